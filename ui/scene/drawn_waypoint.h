// Waypoints as the map shows them during editing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QPainter>
#include <QString>

#include "map/catalogue.h"
#include "map/waypoint.h"

namespace mapwright::ui::scene {

/// The state of a waypoint, shown by shape and colour. Disc, square, framed square, triangle, diamond, cross,
/// and the frame of a triangle for the other version of one in conflict.
enum class WaypointMark { Saved, Unsaved, Sent, Conflict, New, Deleted, Theirs };

struct DrawnWaypoint {
  std::string name;
  Eigen::Vector2d position_m{0, 0};
  std::optional<double> yaw_rad;
  WaypointMark mark = WaypointMark::Saved;
  bool selected = false;
  QString warnings = {};  // a sentence a line; with any, an exclamation mark stands next to it
  std::optional<Eigen::Vector2d> from_m = {};  // a line leads here from there: the stored position, or mine
  QString type = {}, tags = {};  // plain text; shared when copied, unlike those of map::Waypoint
  bool operator==(const DrawnWaypoint&) const = default;
};

/// As it is stored.
DrawnWaypoint drawnFrom(const map::Waypoint& point);

/// The waypoints of one map.
struct DrawnWaypoints {
  map::MapKey map;
  std::vector<DrawnWaypoint> points;
  bool operator==(const DrawnWaypoints&) const = default;
};

/// The shape of a mark, `radius` pixels around `at`.
void paintWaypointMark(QPainter& painter, const QPointF& at, double radius, WaypointMark mark,
                       const QColor& fill, const QColor& edge);

}  // namespace mapwright::ui::scene
