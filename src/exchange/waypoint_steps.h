// Changes of waypoints, told one by one: what of which is done. Pure functions.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QJsonArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "edit/waypoint_fields.h"
#include "robot/waypoint_store.h"

namespace mapwright::exchange {

using WaypointItems = edit::Items<map::Waypoint>;
/// A created one without an id (`after->id` is empty) is called by `key` until it has one.
using WaypointEdit = edit::Change<map::Waypoint>;
using WaypointConflicts = std::map<edit::Key, edit::Conflict<map::Waypoint>>;

WaypointItems itemsOf(const std::vector<map::Waypoint>& points);

enum class StepKind { Create, Move, Rename, Retag, Retype, Delete };
/// "create", "move", …: stable (docs/command-line.md).
QString wordOf(StepKind kind);

/// One thing that is done to one waypoint. `before` and `after` are the whole edit's.
struct WaypointStep {
  StepKind kind = StepKind::Create;
  edit::Key key;
  std::optional<map::Waypoint> before = {}, after = {};

  /// As it is called before; a new one as it is going to be.
  const std::string& name() const { return before ? before->name : after->name; }
  /// "" = it has none yet.
  std::string id() const { return before ? key : after->id; }
};
std::vector<WaypointStep> stepsOf(const std::vector<WaypointEdit>& edits);

/// Whether it is so; `kept` is null where there is no such waypoint. Places and turns may differ by what is
/// lost in between (map/waypoint_likeness.h), and what is asked for without a turn may be kept with one of
/// zero.
bool isDone(const WaypointStep& step, const map::Waypoint* kept);
/// Alike in everything but the id, likewise.
bool isAlike(const map::Waypoint& wanted, const map::Waypoint& kept);

/// {"id"|null,"name","kind"} and what it becomes: "x","y","yaw_rad" of a move, "to" of a rename, "tags",
/// "type", all of it of a create.
QJsonObject stepJson(const WaypointStep& step, const std::string& map);
QJsonArray stepsJson(const std::vector<WaypointStep>& steps, const std::string& map);
/// What it becomes, for people: "x 1 m, y 2 m, 90°".
QString detailOf(const WaypointStep& step);
/// "x 1 m, y 2 m, 90°".
QString placeText(const map::Waypoint& point);
/// "a, b".
QString tagText(const map::Waypoint& point);

/// {"service","args"} of each request that the store would be sent.
QJsonArray callsJson(const robot::WaypointStore& store, const std::vector<robot::WaypointRequest>& requests,
                     const map::MapKey& map);

/// {"id","name","kind","fields":[…],"base","mine","theirs"}.
QJsonArray conflictsJson(const WaypointConflicts& conflicts, const std::string& map);
/// A line each, for people.
QStringList conflictLines(const WaypointConflicts& conflicts);

}  // namespace mapwright::exchange
