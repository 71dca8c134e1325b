// Walls that are far from those of the other map, one by one: they show where a map is bent or was changed.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.h"
#include "render/sample_grid.h"

namespace mapwright::align {

/// A cell of a wall.
struct OffWall {
  Eigen::Vector2d at_m{0, 0};  // on the new map
  double off_m = 0;            // to the nearest wall of the other map
};

class WallsOff {
 public:
  /// For many transforms. Null: cancelled. Takes about 20 bytes for each cell of both maps.
  static std::shared_ptr<const WallsOff> between(const render::PlacedGrid& old_map,
                                                 const render::PlacedGrid& new_map,
                                                 const std::atomic<bool>& cancelled);
  ~WallsOff();

  /// Those of both maps that are off by more than `least_m`, where the other map knows something.
  std::vector<OffWall> at(const geometry::Pose2& transform, double least_m) const;
  /// The edge of a cell.
  double cell_m() const;

 private:
  struct Parts;
  explicit WallsOff(std::unique_ptr<const Parts> parts);
  std::unique_ptr<const Parts> parts_;
};

}  // namespace mapwright::align
