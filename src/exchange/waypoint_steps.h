// Changes of waypoints as single steps, and what became of them: from the answer to a request and from
// reading the stored state afterwards. Pure functions.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QJsonArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "edit/document.h"
#include "edit/submission.h"
#include "robot/waypoint_store.h"

namespace mapwright::exchange {

using WaypointItems = edit::Items;
/// A created waypoint without an id (`after->id` is empty) is identified by `key` until it has one.
using WaypointEdit = edit::Change;
using WaypointConflicts = std::map<edit::Key, edit::Conflict>;

using edit::itemsOf;

enum class StepKind { Create, Move, Rename, Retag, Retype, Delete };
/// "create", "move", …: stable (docs/json.md).
QString wordOf(StepKind kind);

/// One change to one waypoint. `before` and `after` are those of the whole edit.
struct WaypointStep {
  StepKind kind = StepKind::Create;
  edit::Key key;
  std::optional<map::Waypoint> before = {}, after = {};

  /// Its name before the change; for a new one its name afterwards.
  const std::string& name() const { return before ? before->name : after->name; }
  /// "" = none yet.
  std::string id() const { return before ? key : after->id; }
};
std::vector<WaypointStep> stepsOf(const std::vector<WaypointEdit>& edits);

/// Whether it has been done; `kept` is null if there is no such waypoint. Positions and headings may differ
/// by rounding (map/waypoint.h; `pixel_m`: robot::KeptFields), and one without a heading may be stored with
/// 0.
bool isDone(const WaypointStep& step, const map::Waypoint* kept, double pixel_m = 0);
/// The same for everything but the id.
bool isAlike(const map::Waypoint& wanted, const map::Waypoint& kept, double pixel_m = 0);

/// {"id"|null,"name","kind"} and the new values: "x","y","yaw_rad" of a move, "to" of a rename, "tags",
/// "type", all of it for a create.
QJsonObject stepJson(const WaypointStep& step, const std::string& map);
QJsonArray stepsJson(const std::vector<WaypointStep>& steps, const std::string& map);
/// The new value as text: "x 1 m, y 2 m, 90°".
QString detailOf(const WaypointStep& step);
/// "x 1 m, y 2 m, 90°".
QString placeText(const map::Waypoint& point);
/// "a, b".
QString tagText(const map::Waypoint& point);

/// {"service","args"} of each request that would be sent to the store.
QJsonArray callsJson(const robot::WaypointStore& store, const std::vector<robot::WaypointRequest>& requests,
                     const map::MapKey& map);

/// {"id","name","kind","fields":[…],"base","mine","theirs"}.
QJsonArray conflictsJson(const WaypointConflicts& conflicts, const std::string& map);
/// One line of text each.
QStringList conflictLines(const WaypointConflicts& conflicts);

enum class SentState {
  Applied,
  Failed,   // it has not been made: it was refused, or has no effect
  Unknown,  // it was sent, but neither an answer nor the stored state tells
  NotSent,  // with a failure: that kept it from being sent
};

struct SentOutcome {
  SentState state = SentState::NotSent;
  std::optional<map::Failure> failure = {};  // of one that is Applied: only its answer was lost
};

using SentRequest = edit::SubmittedRequest;

/// From the answer alone; a request in progress is Unknown.
SentOutcome answered(const SentRequest& sent);
/// From reading afterwards; `is_so`: the stored state is as requested.
SentOutcome judged(SentOutcome by_answer, bool is_so);
/// Both. `looked`: what has been read since; null = nothing yet.
SentOutcome outcomeOf(const SentRequest& sent, const edit::WaypointDocument* looked);

/// How many requests stand so.
struct SentCounts {
  std::size_t applied = 0, failed = 0, unknown = 0, not_sent = 0;
};
SentCounts countsOf(const std::vector<SentRequest>& sent, const edit::WaypointDocument* looked);

/// Why it Failed, is Unknown or could not be sent; else empty.
QString sentenceOf(const SentOutcome& outcome);

struct TemporaryName {
  edit::Key key;
  std::string name;       // "Dock ~1"
  std::string permanent;  // "Dock"
  bool is_free = true;    // nobody else is called so now
};
std::vector<TemporaryName> temporaryNamesIn(const WaypointItems& items);

}  // namespace mapwright::exchange
