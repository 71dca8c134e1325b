#include "align/plan_of.h"

#include <algorithm>
#include <cmath>

#include "grids/grid_pyramid.h"
#include "placing/ground.h"

namespace mapwright::align {

double cellsFor(const render::PlacedGrid& one, const render::PlacedGrid& other) {
  constexpr double kMostCells = 6'000;
  double cell = kFinestCell_m;
  for (const render::PlacedGrid* const map : {&one, &other}) {
    const geometry::WorldRect bounds = map->reference.bounds();
    cell = std::max(
        {cell, map->reference.resolution_m, bounds.width() / kMostCells, bounds.height() / kMostCells});
  }
  return cell;
}

std::optional<Plan> planOf(const render::PlacedGrid& map, double resolution_m,
                           const std::atomic<bool>* cancelled) {
  constexpr int kStrip = 256;
  Plan plan;
  plan.resolution_m = resolution_m;
  if (map::unusableReason(map.reference)) return plan;
  const geometry::WorldRect bounds = map.reference.bounds();
  if (bounds.empty()) return plan;
  plan.width = std::max(1, int(std::ceil(bounds.width() / resolution_m - 1e-6)));
  plan.height = std::max(1, int(std::ceil(bounds.height() / resolution_m - 1e-6)));
  plan.corner_m = {bounds.min_x, bounds.min_y};
  plan.cells.assign(std::size_t(plan.width) * std::size_t(plan.height), Ground::Unknown);
  render::PixelGrid pixels;
  pixels.origin_m = {bounds.min_x, bounds.min_y + plan.height * resolution_m};
  pixels.scale_m_per_px = resolution_m;
  pixels.width_px = plan.width;
  const grids::CellMeaning& meaning = grids::meaningOf(map.cells->code());
  for (int row = 0; row < plan.height; row += kStrip) {
    pixels.first_row = row;
    pixels.height_px = std::min(kStrip, plan.height - row);
    const render::Composition sampled = render::sampleGrid(pixels, map, cancelled);
    if (cancelled && *cancelled) return std::nullopt;  // then it is not complete
    std::size_t at = 0;
    for (int y = row; y < row + pixels.height_px; ++y) {
      Ground* const cells = plan.cells.data() + std::size_t(plan.height - 1 - y) * std::size_t(plan.width);
      for (int x = 0; x < plan.width; ++x, ++at) {
        if (!render::knownIn(sampled, at, meaning)) continue;
        const bool wall = render::occupancyIn(sampled, at, meaning) >= placing::kOccupiedPercent;
        cells[x] = wall ? Ground::Wall : Ground::Free;
      }
    }
  }
  return plan;
}

render::PlacedGrid moved(const render::PlacedGrid& map, const geometry::Pose2& by) {
  render::PlacedGrid out = map;
  out.reference.origin = by * map.reference.origin;
  return out;
}

}  // namespace mapwright::align
