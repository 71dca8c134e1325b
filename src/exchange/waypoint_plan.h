// The changes that turn one list of waypoints into another, as a value and as a file. Pure functions.
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

/// What to do with waypoints that a file does not list.
enum class Others {
  Stay,  // Stay: entries are matched by id, otherwise by name, otherwise they are new
  Go,    // Go: entries are matched by id only, otherwise they are new
};
/// The error is a sentence.
using WaypointEdits = tl::expected<std::vector<WaypointEdit>, QString>;
WaypointEdits editsFor(const WaypointItems& kept, const std::vector<WantedWaypoint>& wanted, Others others);

/// Why a waypoint cannot be stored like this; empty if it can. Unchanged fields are not checked.
QString notKeptReason(const std::optional<map::Waypoint>& before, const map::Waypoint& after);
/// The edits as they will be stored. `notes`: what cannot be stored, a sentence each.
struct FittedEdits {
  std::vector<WaypointEdit> edits;  // without those that change nothing
  QStringList notes;
};
/// Why what is stored is not deleted; empty: it can be.
QString notRemovedReason(const robot::KeptFields& keeps);
FittedEdits fitted(std::vector<WaypointEdit> edits, const robot::KeptFields& keeps);
/// "Dock, Gate: another waypoint has this name, …"; empty if none is refused.
QString refusedText(const std::set<edit::Key>& refused, const std::vector<WaypointEdit>& edits);
/// A key for a new waypoint until it is stored.
edit::Key freshKey();

/// The edits merged with the current list.
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
/// `calls` is for people: the requests are planned again when it is applied.
QByteArray planBytes(const WaypointPlan& plan, const QJsonArray& calls);
/// Only base and changes are read; changes that were deleted from the file are not made. The error is a
/// sentence.
tl::expected<WaypointPlan, QString> planFromBytes(std::string_view bytes);
/// Without creating waypoints that exist already: new since the base, of that name and at that place. One
/// that has other tags or another type gets those of the plan.
std::vector<WaypointEdit> withoutCreated(const WaypointPlan& plan, const WaypointItems& now);

}  // namespace mapwright::exchange
