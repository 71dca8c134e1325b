#include "simulator/block_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace mapwright::simulator {
namespace {

constexpr double kClearanceM = 0.36;  // half a robot and a hand's breadth
constexpr double kBucketM = 2.0;

/// The stretches of [from, to] that the gaps leave.
std::vector<Gap> between(double from, double to, std::vector<Gap> gaps) {
  std::sort(gaps.begin(), gaps.end());
  std::vector<Gap> walls;
  for (const Gap& gap : gaps) {
    if (gap.first > from) walls.emplace_back(from, std::min(gap.first, to));
    from = std::max(from, gap.second);
  }
  if (from < to) walls.emplace_back(from, to);
  return walls;
}

}  // namespace

void BlockDrawing::wallAlongX(double x0, double x1, double y, double thickness, std::vector<Gap> gaps) {
  for (const Gap& wall : between(x0, x1, std::move(gaps))) {
    solids.push_back({{(wall.first + wall.second) / 2, y},
                      {(wall.second - wall.first) / 2, thickness / 2},
                      0,
                      false,
                      false});
  }
}

void BlockDrawing::wallAlongY(double x, double y0, double y1, double thickness, std::vector<Gap> gaps) {
  for (const Gap& wall : between(y0, y1, std::move(gaps))) {
    solids.push_back({{x, (wall.first + wall.second) / 2},
                      {thickness / 2, (wall.second - wall.first) / 2},
                      0,
                      false,
                      false});
  }
}

void BlockDrawing::post(double x, double y, double size) {
  solids.push_back({{x, y}, {size / 2, size / 2}, 0, false, false});
}

void BlockDrawing::box(double x, double y, double width, double depth, double yaw_rad) {
  solids.push_back({{x, y}, {width / 2, depth / 2}, yaw_rad, false, true});
}

void BlockDrawing::disc(double x, double y, double radius) {
  solids.push_back({{x, y}, {radius, radius}, 0, true, true});
}

void BlockDrawing::chair(double x, double y, double yaw_rad) {
  const double r = 0.24;
  for (int leg = 0; leg < 4; ++leg) {
    const double a = yaw_rad + 0.785 + leg * 1.5708;
    disc(x + r * std::cos(a), y + r * std::sin(a), 0.025);
  }
}

void BlockDrawing::table(double x, double y, double width, double depth, double yaw_rad) {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  for (const double i : {-1.0, 1.0}) {
    for (const double k : {-1.0, 1.0}) {
      const double u = i * (width / 2 - 0.06), v = k * (depth / 2 - 0.06);
      disc(x + c * u - s * v, y + s * u + c * v, 0.035);
    }
  }
}

void BlockDrawing::desk(double x, double y, double yaw_rad) {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  table(x, y, 1.5, 0.75, yaw_rad);
  box(x + c * 0.5 - s * 0.05, y + s * 0.5 + c * 0.05, 0.42, 0.58, yaw_rad);
  const double along = dice.uniform(-0.35, 0.1), out = dice.uniform(-0.75, -0.45);
  chair(x + c * along - s * out, y + s * along + c * out, dice.uniform(0, 1.5));
}

void BlockDrawing::clear(const std::vector<Eigen::Vector2d>& way) {
  std::map<std::pair<int, int>, std::vector<Eigen::Vector2d>> buckets;
  const auto bucket = [](double v) { return static_cast<int>(std::floor(v / kBucketM)); };
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Eigen::Vector2d step = way[i] - way[i - 1];
    const int pieces = std::max(1, static_cast<int>(step.norm() / 0.15));
    for (int k = 0; k <= pieces; ++k) {
      const Eigen::Vector2d p = way[i - 1] + step * (static_cast<double>(k) / pieces);
      buckets[{bucket(p.x()), bucket(p.y())}].push_back(p);
    }
  }
  std::erase_if(solids, [&](const Solid& solid) {
    if (!solid.movable) return false;
    const double reach = solid.reach() + kClearanceM;
    for (int by = bucket(solid.centre.y() - reach); by <= bucket(solid.centre.y() + reach); ++by) {
      for (int bx = bucket(solid.centre.x() - reach); bx <= bucket(solid.centre.x() + reach); ++bx) {
        const auto found = buckets.find({bx, by});
        if (found == buckets.end()) continue;
        for (const Eigen::Vector2d& p : found->second) {
          if (solid.distanceTo(p) < kClearanceM) return true;
        }
      }
    }
    return false;
  });
}

}  // namespace mapwright::simulator
