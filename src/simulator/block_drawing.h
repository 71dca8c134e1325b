// Draws one part of a building: walls with gaps, furniture, and the route through it.
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "simulator/floor_plan.h"
#include "simulator/noise.h"

namespace mapwright::simulator {

/// An interval along a wall that stays open, metres.
using Gap = std::pair<double, double>;

/// A part of a building being drawn, in its own coordinates: metres, x to the east, y to the north.
class BlockDrawing {
 public:
  explicit BlockDrawing(std::uint64_t seed) : dice(seed) {}

  /// A wall along x (or y) with the given gaps.
  void wallAlongX(double x0, double x1, double y, double thickness, std::vector<Gap> gaps = {});
  void wallAlongY(double x, double y0, double y1, double thickness, std::vector<Gap> gaps = {});
  void post(double x, double y, double size);  // a column, which is not moved for the route
  void box(double x, double y, double width, double depth, double yaw_rad = 0);
  void disc(double x, double y, double radius);
  void chair(double x, double y, double yaw_rad);
  void table(double x, double y, double width, double depth, double yaw_rad);  // four legs
  void desk(double x, double y, double yaw_rad);  // legs, drawers and a chair in front

  /// Removes furniture that is too close to `way` for the robot.
  void clear(const std::vector<Eigen::Vector2d>& way);

  Dice dice;
  std::vector<Solid> solids;
};

/// A room with one door, for furnishing and for visits.
struct Room {
  double x0 = 0, x1 = 0;  // along the corridor
  double door_y = 0;      // the wall with the door
  double depth = 0;       // from that wall
  double inward = 1;      // +1: the room is north of the door, -1: south
  double corridor_y = 0;  // centre line of the corridor
  double door_x = 0;
  bool visited = false;  // the robot goes in

  double at(double from_door) const { return door_y + inward * from_door; }
};

/// A row of rooms along a corridor, with their walls, doors and furniture. `x0..x1` is the wing's extent.
std::vector<Room> drawRooms(BlockDrawing& drawing, double x0, double x1, double door_y, double depth,
                            double inward, double corridor_y);

/// The route of a visit: from the corridor through the door, around a small loop and out again.
void appendVisit(std::vector<Eigen::Vector2d>& way, const Room& room);

}  // namespace mapwright::simulator
