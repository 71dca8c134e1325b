// Fitting one map to another by the distances between their walls. Immutable values and pure functions.
#pragma once

#include <initializer_list>
#include <vector>

#include <Eigen/Core>

#include "align/sheet.h"
#include "geometry/pose.h"

namespace mapwright::align {

struct Sheets {
  Sheet of_old, of_new;
};

/// Walls of both maps, which are looked up in the other one.
struct Points {
  std::vector<Eigen::Vector2d> of_old, of_new;
  Eigen::Vector2d middle{0, 0};  // of those of the old map
  double radius = 1;             // how far they reach from there, at least 1 m
};
Points pointsFrom(std::vector<Eigen::Vector2d> of_old, std::vector<Eigen::Vector2d> of_new);
/// At most `most` of each map.
Points pointsOf(const Sheets& sheets, std::size_t most);

/// Pose2::apply() for many points.
class Mover {
 public:
  explicit Mover(const geometry::Pose2& pose);
  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const { return turn_ * p + by_; }

 private:
  Eigen::Matrix2d turn_;
  Eigen::Vector2d by_;
};

/// Agreement 0..1 above chance, both ways; and how much could be compared.
struct Quality {
  double agreement = 0, seen = 0;
  double score() const;
};
Quality qualityOf(const Sheets& sheets, const Points& points, const geometry::Pose2& transform);

/// Least squares over the distances to the nearest wall, both ways, from a transform nearby; what is farther
/// than the cutoff does not count (Tukey). The cutoffs are used one after the other.
geometry::Pose2 fitted(const Sheets& sheets, const Points& points, geometry::Pose2 pose,
                       std::initializer_list<double> cutoffs_m);

}  // namespace mapwright::align
