// One map at one level of detail: where its walls are and how far each point is from them. Immutable.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "align/plan.h"

namespace mapwright::align {

class Sheet {
 public:
  explicit Sheet(const Plan& plan);

  double resolution() const { return resolution_m_; }
  /// Centres of the wall cells beside free ones: what a scanner saw.
  const std::vector<Eigen::Vector2d>& walls() const { return walls_; }
  /// At most `most` of them, evenly chosen.
  std::vector<Eigen::Vector2d> someWalls(std::size_t most) const;

  struct Distance {
    double metres;
    Eigen::Vector2d slope;  // its gradient
  };
  /// To the nearest wall; nullopt where the map knows nothing within kReach_m, and on unknown ground that is
  /// farther than that from all walls.
  std::optional<Distance> distanceAt(const Eigen::Vector2d& world_m) const;
  bool knownAt(const Eigen::Vector2d& world_m) const;
  bool freeAt(const Eigen::Vector2d& world_m) const;

  /// Beyond known ground: a wall seen from one side has nothing known behind it.
  static constexpr double kReach_m = 0.3;

 private:
  Eigen::Vector2d cellAt(const Eigen::Vector2d& world_m) const {
    return (world_m - corner_m_) / resolution_m_;
  }

  double resolution_m_;
  Eigen::Vector2d corner_m_;  // of distance_, which is larger than the plan
  cv::Mat_<float> distance_;  // metres
  cv::Mat_<std::uint8_t> near_, known_;
  std::vector<Eigen::Vector2d> walls_;
};

}  // namespace mapwright::align
