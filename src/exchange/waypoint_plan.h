// What it takes to make a list of waypoints another one, as a value and as a file. Pure functions.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <QByteArray>
#include <QJsonArray>
#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

#include "exchange/wanted_waypoint.h"
#include "exchange/waypoint_steps.h"

namespace mapwright::exchange {

/// What becomes of waypoints that a file does not list.
enum class Others {
  Stay,  // and what it lists is found by its id, else by its name, else it is new
  Go,    // and what it lists is found by its id alone, else it is new
};
/// The error is a sentence.
using WaypointEdits = tl::expected<std::vector<WaypointEdit>, QString>;
WaypointEdits editsFor(const WaypointItems& kept, const std::vector<WantedWaypoint>& wanted, Others others);

/// Why a waypoint cannot be kept like that; empty when it can. What is as it was is not looked at.
QString whyNotKept(const std::optional<map::Waypoint>& before, const map::Waypoint& after);
/// The edits as they are going to be kept. `notes`: what of them is not, a sentence each.
struct FittedEdits {
  std::vector<WaypointEdit> edits;  // without those that change nothing
  QStringList notes;
};
FittedEdits fitted(std::vector<WaypointEdit> edits, const robot::KeptFields& keeps);
/// "Dock, Gate: another waypoint has this name, …"; empty when none is refused.
QString refusedText(const std::set<edit::Key>& refused, const std::vector<WaypointEdit>& edits);
/// Names a new waypoint until it is kept.
edit::Key freshKey();

/// The edits brought together with how the list is now.
struct MergedEdits {
  std::vector<WaypointEdit> edits;  // without what is so already
  WaypointConflicts conflicts;
};
MergedEdits merged(const std::vector<WaypointEdit>& edits, const WaypointItems& now);

struct WaypointPlan {
  QString robot;    // its address
  std::string map;  // the id of its map
  WaypointItems base;
  std::vector<WaypointEdit> edits;
};
/// {"mapwright":"waypoint-plan","version":1,"robot","map","base":[…],"changes":[…],"calls":[…],"conflicts":[]}.
/// `calls` is for people: an application plans anew.
QByteArray planBytes(const WaypointPlan& plan, const QJsonArray& calls);
/// Only base and changes are looked at; a change that somebody has taken out is not made. The error is a
/// sentence.
tl::expected<WaypointPlan, QString> planFromBytes(std::string_view bytes);
/// Without creating what is there already: new since the base, and alike.
std::vector<WaypointEdit> withoutCreated(const WaypointPlan& plan, const WaypointItems& now);

}  // namespace mapwright::exchange
