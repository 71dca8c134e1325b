#include "map/waypoint.h"

#include <cmath>

#include "geometry/pose.h"

namespace mapwright::map {
namespace {

constexpr std::string_view kMark = " ~", kDigits = "0123456789";

/// "Dock ~1" of "Dock ~1 ~2"; empty = it has no mark.
std::string_view withoutMark(std::string_view name) {
  const auto before_digits = name.find_last_not_of(kDigits);
  if (before_digits == std::string_view::npos || before_digits + 1 == name.size()) return {};
  const std::string_view marked = name.substr(0, before_digits + 1);
  return marked.ends_with(kMark) ? marked.substr(0, marked.size() - kMark.size()) : std::string_view();
}

}  // namespace

std::string temporaryName(std::string_view name, int number) {
  return std::string(name) + std::string(kMark) + std::to_string(number);
}

// A swap that was interrupted twice may have left "Dock ~1 ~1".
std::string_view permanentName(std::string_view temporary) {
  std::string_view name = withoutMark(temporary);
  for (auto rest = withoutMark(name); !rest.empty(); rest = withoutMark(rest)) name = rest;
  return name;
}

bool isTemporaryFor(std::string_view name, std::string_view permanent) {
  for (name = withoutMark(name); !name.empty(); name = withoutMark(name)) {
    if (name == permanent) return true;
  }
  return false;
}

bool samePlace(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m) {
  return (a_m - b_m).norm() <= kSameM;
}

bool sameHeading(double a_rad, double b_rad) {
  return std::abs(geometry::normalizeAngle(a_rad - b_rad)) <= kSameRad;
}

bool sameHeading(const std::optional<double>& a_rad, const std::optional<double>& b_rad) {
  return a_rad && b_rad ? sameHeading(*a_rad, *b_rad) : a_rad.has_value() == b_rad.has_value();
}

}  // namespace mapwright::map
