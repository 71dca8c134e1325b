#include "overlays/overlay_arrange.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace mapwright::overlays {

using Eigen::Vector2d;
using geometry::WorldRect;

std::vector<Vector2d> shiftsToAlign(const std::vector<WorldRect>& boxes, Alignment how) {
  WorldRect all;
  for (const WorldRect& box : boxes) {
    all.extend(Vector2d(box.min_x, box.min_y));
    all.extend(Vector2d(box.max_x, box.max_y));
  }
  std::vector<Vector2d> shifts;
  for (const WorldRect& box : boxes) {
    Vector2d by(0, 0);
    switch (how) {
      case Alignment::Left:
        by.x() = all.min_x - box.min_x;
        break;
      case Alignment::CentreX:
        by.x() = (all.min_x + all.max_x - box.min_x - box.max_x) / 2;
        break;
      case Alignment::Right:
        by.x() = all.max_x - box.max_x;
        break;
      case Alignment::Top:
        by.y() = all.max_y - box.max_y;
        break;
      case Alignment::CentreY:
        by.y() = (all.min_y + all.max_y - box.min_y - box.max_y) / 2;
        break;
      case Alignment::Bottom:
        by.y() = all.min_y - box.min_y;
        break;
    }
    shifts.push_back(by);
  }
  return shifts;
}

std::vector<Vector2d> shiftsToSpread(const std::vector<WorldRect>& boxes, Spread along) {
  std::vector<Vector2d> shifts(boxes.size(), Vector2d(0, 0));
  if (boxes.size() < 3) return shifts;
  const auto low = [&](const WorldRect& box) { return along == Spread::X ? box.min_x : box.min_y; };
  const auto high = [&](const WorldRect& box) { return along == Spread::X ? box.max_x : box.max_y; };
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return low(boxes[a]) + high(boxes[a]) < low(boxes[b]) + high(boxes[b]);
  });
  double widths = 0;
  for (const WorldRect& box : boxes) widths += high(box) - low(box);
  const double from = low(boxes[order.front()]), to = high(boxes[order.back()]);
  const double gap = (to - from - widths) / double(boxes.size() - 1);
  double at = from;
  for (const std::size_t i : order) {
    shifts[i][along == Spread::X ? 0 : 1] = at - low(boxes[i]);
    at += high(boxes[i]) - low(boxes[i]) + gap;
  }
  shifts[order.front()] = shifts[order.back()] = Vector2d(0, 0);
  return shifts;
}

std::vector<Vector2d> circleAround(const Vector2d& centre_m, double radius_m) {
  std::vector<Vector2d> points;
  for (int i = 0; i < kCircleVertices; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCircleVertices;
    points.emplace_back(centre_m + radius_m * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return points;
}

}  // namespace mapwright::overlays
