// Texts about waypoints. Pure functions.
#pragma once

#include <optional>
#include <set>
#include <string>

#include <QString>

#include "edit/document.h"
#include "edit/open_waypoints.h"
#include "exchange/waypoint_deed.h"
#include "exchange/waypoint_steps.h"

namespace mapwright::ui {

using exchange::deedText;
using exchange::shortWaypointName;
using exchange::yawText;

/// "dock, charger".
QString tagsText(const std::vector<std::string>& tags);
/// The reverse of what people type: separated by commas, without blanks around them and empty ones.
std::vector<std::string> tagsFrom(const QString& text);
/// "1 waypoint", "12 waypoints".
QString waypointsText(qsizetype count);
/// "3 changes".
QString changesText(qsizetype count);

/// The state of an item in words; empty if it is saved.
QString stateText(const edit::ItemState& state);

/// What is pending of one waypoint, as flags; several may be so at once.
enum Pending : int {
  kUnsaved = 1,
  kNew = 2,
  kMoved = 4,  // or turned
  kRenamed = 8,
  kRetagged = 16,  // or of another type
  kDeleted = 32,
  kConflicting = 64,
};
/// `kept`, `now`: null = it is not there.
int pendingOf(const edit::ItemState& state, const map::Waypoint* kept, const map::Waypoint* now);
/// "Not saved yet: renamed, moved."; empty when nothing is pending.
QString pendingText(const edit::ItemState& state, int pending);
/// "name “A” to “B”, position 1.000, 2.000 m to 2.000, 2.000 m"; "new: …", "deleted".
QString changeText(const std::optional<map::Waypoint>& before, const std::optional<map::Waypoint>& after);
/// "Changed here: position 1.000, 2.000. Changed elsewhere: position 4.000, 2.000."
QString conflictText(const edit::Conflict& conflict);
/// What went wrong.
QString failureText(const map::Failure& failure);
/// The result of a request of the list's submission, and of all of them, as far as known.
exchange::SentOutcome outcomeOf(const edit::OpenWaypoints& list, const exchange::SentRequest& sent);
exchange::SentCounts countsOf(const edit::OpenWaypoints& list);
/// "Not all is saved: of 3 requests 1 was carried out. The connection is gone."
QString notSavedText(const edit::OpenWaypoints& list, const map::Failure& stopped_by);
/// Why it went wrong, without its result.
QString reasonText(const map::Failure& failure);

/// A temporary name left by an interrupted swap of names, and how to fix it.
struct LeftName {
  enum class Remedy {
    SendRest,  // what is not saved ends it
    CallItSo,  // `permanent`, which nobody else is called
    Ask,       // for a name
  };
  edit::Key key;
  Remedy remedy = Remedy::Ask;
  std::string permanent;
  QString sentence, offer;  // the text, and the button
};
/// The first one; ignores those in `accepted`.
std::optional<LeftName> leftName(const edit::WaypointDocument& document, const std::set<edit::Key>& accepted);

}  // namespace mapwright::ui
