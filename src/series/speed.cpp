#include "series/speed.h"

#include <cmath>
#include <limits>

namespace mapwright::series {
namespace {

struct Position {
  double at_s = 0, x_m = 0, y_m = 0;
};

/// Where both are known. They differ in their times only where samples gave way.
std::vector<Position> positions(const Series& x, const Series& y, double from_s, double until_s) {
  const std::vector<Sample> xs = x.samples(from_s, until_s), ys = y.samples(from_s, until_s);
  std::vector<Position> both;
  for (std::size_t i = 0, j = 0; i < xs.size() && j < ys.size();) {
    if (xs[i].at_s < ys[j].at_s) {
      ++i;
    } else if (ys[j].at_s < xs[i].at_s) {
      ++j;
    } else {
      both.push_back({xs[i].at_s, xs[i].value, ys[j].value});
      ++i, ++j;
    }
  }
  return both;
}

double distance(const Position& a, const Position& b) { return std::hypot(b.x_m - a.x_m, b.y_m - a.y_m); }

}  // namespace

std::vector<Sample> speeds(const Series& x, const Series& y, double from_s, double until_s) {
  const std::vector<Position> at = positions(x, y, from_s - kSpeedReach_s, until_s);
  std::vector<Sample> found;
  std::size_t before = 0;  // the last one that is long enough ago
  for (std::size_t i = 0; i < at.size(); ++i) {
    while (before + 1 < i && at[i].at_s - at[before + 1].at_s >= kSpeedOver_s) ++before;
    if (at[i].at_s < from_s) continue;
    const double over_s = at[i].at_s - at[before].at_s;
    double speed = std::numeric_limits<double>::quiet_NaN();
    if (over_s >= kSpeedOver_s && over_s <= kSpeedReach_s && x.isCovered(at[before].at_s, at[i].at_s)) {
      speed = distance(at[before], at[i]) / over_s;
      if (speed > kFastest_m_s) speed = std::numeric_limits<double>::quiet_NaN();
    }
    found.push_back({at[i].at_s, speed});
  }
  return found;
}

}  // namespace mapwright::series
