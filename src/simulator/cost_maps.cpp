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
  const double c = std::abs(std::cos(solid.yaw_rad)), s = std::abs(std::sin(solid.yaw_rad));
  const Vector2d half = solid.round ? Vector2d(solid.half.x(), solid.half.x())
                                    : Vector2d(c * solid.half.x() + s * solid.half.y(),
                                               s * solid.half.x() + c * solid.half.y());
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
    for (int u = u0; u < u1; ++u) {
      if (row[u] == 254) continue;
      const double distance =
          solid.distanceTo(place.origin_m + place.resolution_m * Vector2d(u + 0.5, y + 0.5));
      if (distance > kInflationM) continue;
      const std::uint8_t cost =
          distance <= 0 ? 254 : costs[static_cast<std::size_t>(distance * kStepsPerMetre)];
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
