#include "simulator/cost_maps.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mapwright::simulator {
namespace {

using Eigen::Vector2d;

constexpr double kInscribedM = 0.25;
constexpr double kInflationM = 0.55;
constexpr double kSteepness = 9;  // per metre
constexpr int kStepsPerMetre = 400;

/// Cost by distance in steps, so that no exponential is taken per cell.
std::vector<std::uint8_t> costTable() {
  std::vector<std::uint8_t> costs;
  for (int i = 0; i <= static_cast<int>(kInflationM * kStepsPerMetre); ++i) {
    const double distance = static_cast<double>(i) / kStepsPerMetre;
    const double cost =
        distance <= kInscribedM ? 253 : 252 * std::exp(-kSteepness * (distance - kInscribedM));
    costs.push_back(static_cast<std::uint8_t>(cost));
  }
  return costs;
}

void addSolid(GrayPicture& picture, const GridPlace& place, const Solid& solid,
              const std::vector<std::uint8_t>& costs) {
  const double c = std::cos(solid.yaw_rad), s = std::sin(solid.yaw_rad);
  const Vector2d shape = solid.round ? Vector2d(solid.half.x(), solid.half.x()) : solid.half;
  const Vector2d half = solid.round ? shape
                                    : Vector2d(std::abs(c) * shape.x() + std::abs(s) * shape.y(),
                                               std::abs(s) * shape.x() + std::abs(c) * shape.y());
  const Vector2d grown = half + Vector2d(kInflationM, kInflationM);
  const Vector2d low = (solid.centre - grown - place.origin_m) / place.resolution_m;
  const Vector2d high = (solid.centre + grown - place.origin_m) / place.resolution_m;
  const auto cell = [](double at, int count) {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, static_cast<double>(count)));
  };
  const int u0 = cell(low.x(), place.width), u1 = cell(high.x() + 1, place.width);
  const int y0 = cell(low.y(), place.height), y1 = cell(high.y() + 1, place.height);
  for (int y = y0; y < y1; ++y) {
    std::uint8_t* row = picture.levels.data() + static_cast<std::size_t>(place.height - 1 - y) *
                                                    static_cast<std::size_t>(place.width);
    const double dy = place.origin_m.y() + place.resolution_m * (y + 0.5) - solid.centre.y();
    for (int u = u0; u < u1; ++u) {
      if (row[u] == 254) continue;
      const double dx = place.origin_m.x() + place.resolution_m * (u + 0.5) - solid.centre.x();
      double beyond = 0;  // the square of how far outside the shape
      if (solid.round) {
        const double distance = std::max(0.0, std::sqrt(dx * dx + dy * dy) - shape.x());
        beyond = distance * distance;
      } else {
        const double along = std::max(0.0, std::abs(c * dx + s * dy) - shape.x());
        const double across = std::max(0.0, std::abs(-s * dx + c * dy) - shape.y());
        beyond = along * along + across * across;
      }
      if (beyond > kInflationM * kInflationM) continue;
      const std::uint8_t cost =
          beyond <= 0 ? 254 : costs[static_cast<std::size_t>(std::sqrt(beyond) * kStepsPerMetre)];
      row[u] = std::max(row[u], cost);
    }
  }
}

}  // namespace

GridPlace squareAround(const Vector2d& centre_m, int cells, double resolution_m) {
  const Vector2d corner = centre_m / resolution_m - Vector2d(cells / 2, cells / 2);
  return {cells, cells, resolution_m,
          Vector2d(std::round(corner.x()) * resolution_m, std::round(corner.y()) * resolution_m)};
}

GrayPicture costsOf(const FloorPlan& plan, const std::vector<Solid>& extra, const GridPlace& place) {
  static const std::vector<std::uint8_t> costs = costTable();
  GrayPicture picture{place.width, place.height, {}};
  picture.levels.assign(static_cast<std::size_t>(place.width) * static_cast<std::size_t>(place.height), 0);
  const Vector2d margin(kInflationM, kInflationM);
  const Vector2d size = place.resolution_m * Vector2d(place.width, place.height);
  for (const std::uint32_t index : plan.near(place.origin_m - margin, place.origin_m + size + margin))
    addSolid(picture, place, plan.solids()[index], costs);
  for (const Solid& solid : extra) addSolid(picture, place, solid, costs);
  return picture;
}

}  // namespace mapwright::simulator
