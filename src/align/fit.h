// Fitting one map to another by the distances between their walls. Immutable values and pure functions.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <unordered_map>
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
/// Without walls whose free side the other map does not know. It may have seen them from behind, where they
/// lie beside by their thickness: in rooms that were seen from one side, that looks like a bend.
Points facedAlike(const Sheets& sheets, const std::vector<Eigen::Vector2d>& of_old,
                  const std::vector<Eigen::Vector2d>& of_new, const geometry::Pose2& pose);

/// Pose2::apply() for many points.
class Mover {
 public:
  explicit Mover(const geometry::Pose2& pose);
  Mover(const Eigen::Matrix2d& turn, const Eigen::Vector2d& by) : turn_(turn), by_(by) {}
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

/// Walls by squares, so that those around a point are found without looking at all.
class WallIndex {
 public:
  explicit WallIndex(const std::vector<Eigen::Vector2d>& walls);
  std::vector<Eigen::Vector2d> around(const Eigen::Vector2d& at, double reach_m) const;

 private:
  std::unordered_map<std::int64_t, std::vector<Eigen::Vector2d>> squares_;
};

/// The transform that fits best around a point of the old map, by the walls within 3 m, if it differs from
/// `transform` by at most 0.5 m and 5 degrees and agrees better there.
std::optional<geometry::Pose2> fittedAround(const Sheets& sheets, const WallIndex& old_walls,
                                            const WallIndex& new_walls, const geometry::Pose2& transform,
                                            const Eigen::Vector2d& old_m);
inline constexpr double kAround_m = 3.0;

/// The motion by which the score falls least: 1 m for points as far from the middle as usual. Its turn is
/// about the middle of `points`, in the new map.
struct Motion {
  Eigen::Vector2d by_m{0, 0};
  double turn_rad = 0;
};
Motion weakestMotion(const Sheets& sheets, const Points& points, const geometry::Pose2& pose);
geometry::Pose2 movedBy(const geometry::Pose2& pose, const Points& points, const Motion& motion,
                        double times);

}  // namespace mapwright::align
