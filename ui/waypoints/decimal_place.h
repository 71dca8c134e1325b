// Places that are set by hand, as they are kept. Pure.
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>

namespace mapwright::ui {

/// In decimals, to the micrometre: sums of decimals are none (0.15000000000000002), and end in files. Axes on
/// which it stays at `from_m` are not changed.
inline Eigen::Vector2d decimalPlace(const Eigen::Vector2d& to_m,
                                    const std::optional<Eigen::Vector2d>& from_m = std::nullopt) {
  constexpr double kUnitsInAMetre = 1e6;
  Eigen::Vector2d place = to_m;
  for (int axis = 0; axis < 2; ++axis) {
    if (!from_m || to_m[axis] != (*from_m)[axis])
      place[axis] = std::round(to_m[axis] * kUnitsInAMetre) / kUnitsInAMetre;
  }
  return place;
}

}  // namespace mapwright::ui
