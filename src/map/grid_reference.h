// The position of a grid of cells in the world. Source: docs/protocols/autoxing.md, "Requests", "Topics that
// the map shows", ROS map_server (origin).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "fault/fault.h"
#include "geometry/pose.h"
#include "geometry/rect.h"

namespace mapwright::map {

/// A grid of `width` x `height` cells. `origin` is the world pose of the outer corner of the lower-left cell
/// (last row, first column): x runs along the rows, y against them. Metres, radians counter-clockwise.
struct GridReference {
  int width = 0, height = 0;  // cells; 0 = unknown until the picture is read
  double resolution_m = 0;    // metres per cell
  geometry::Pose2 origin;
  bool operator==(const GridReference&) const = default;

  /// World point of a continuous cell position: (0, 0) is the outer corner of the first cell of the top row,
  /// rows run down.
  Eigen::Vector2d worldFromCell(const Eigen::Vector2d& cell) const;
  Eigen::Vector2d cellFromWorld(const Eigen::Vector2d& world_m) const;
  /// Axis-aligned bounds of the whole grid; empty without cells.
  geometry::WorldRect bounds() const;
};

/// Cells as ROS sends them: row 0 = bottom; -1 unknown, 0 free .. 100 occupied. As many as the grid's width
/// and height say.
using OccupancyCells = std::shared_ptr<const std::vector<std::int8_t>>;

/// nullopt if the reference is valid; otherwise why not: "Its resolution is 0, which is not a valid cell
/// size." A width and height of 0 are fine. Invalid: a resolution that is not finite, not positive, below 0.1
/// mm or above 1 km; an origin that is not finite or farther than 10,000 km. A yaw that is not finite is
/// allowed here: readers use 0 and report it (maps with "nan" as yaw exist).
std::optional<Fault> unusableReason(const GridReference& grid);

}  // namespace mapwright::map
