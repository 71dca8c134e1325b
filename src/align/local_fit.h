// How well an alignment holds around single points, and by how much it is off there: a mean over the whole
// map hides a bent corridor. Why: docs/tasks/new-map.md.
#pragma once

#include <memory>
#include <optional>

#include "align/plan.h"
#include "geometry/pose.h"

namespace mapwright::align {

class LocalFit {
 public:
  /// `transform` takes a point of the old map to the new one.
  LocalFit(const Plan& old_map, const Plan& new_map, const geometry::Pose2& transform);
  ~LocalFit();
  LocalFit(LocalFit&&) noexcept;

  static constexpr double kReach_m = 3.0;

  /// Of walls within kReach_m, where the other map knows something.
  struct Around {
    double within_10cm = 0;  // share of the old map's with a wall of the new map within 10 cm
    /// How far the old map's walls are off, and those of both maps, whichever is worse; nullopt: there are
    /// none.
    std::optional<double> old_m = {}, residual_m = {};
  };
  Around around(const Eigen::Vector2d& old_m) const;

  /// The transform that fits best around that point, if it differs by at most 0.5 m and 5 degrees and agrees
  /// better there.
  std::optional<geometry::Pose2> fittedAt(const Eigen::Vector2d& old_m) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace mapwright::align
