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

  /// Of the old map's walls within kReach_m, where the new map knows something.
  struct Around {
    double within_10cm = 0;                 // share of them with a wall of the new map within 10 cm
    std::optional<double> residual_m = {};  // how far they are off; nullopt: there are no such walls
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
