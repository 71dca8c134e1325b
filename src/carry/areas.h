// Free ground that a robot can drive on, by connected areas.
#pragma once

#include <memory>

#include "align/plan.h"

namespace mapwright::carry {

class Areas {
 public:
  /// Walls are kept farther away than `radius_m`.
  Areas(const align::Plan& plan, double radius_m);
  Areas(Areas&&) noexcept;
  ~Areas();

  /// The nearest area within the robot's radius and half a metre; 0 = none.
  int at(const Eigen::Vector2d& world_m) const;

 private:
  struct Labels;
  std::unique_ptr<const Labels> labels_;
};

}  // namespace mapwright::carry
