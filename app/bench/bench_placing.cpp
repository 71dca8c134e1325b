// What is doubtful about thousands of waypoints on a large map: by one thread, and in the groups that the
// crew of the window shares.
#include <cstdint>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "grids/grid_pyramid.h"
#include "placing/warnings.h"
#include "work/workers.h"

namespace {

using namespace mapwright;

constexpr double kRadiusM = 0.3;
constexpr std::size_t kMostOfGroup = 2'500;  // as in the window

std::uint32_t noise(std::uint32_t seed) {
  seed ^= seed >> 16;
  seed *= 0x7feb352d;
  seed ^= seed >> 15;
  seed *= 0x846ca68b;
  return seed ^ seed >> 16;
}

/// Rooms with doors, a speck in every 200 cells, 5 cm a cell.
placing::PlacedMap mapOf(int edge) {
  static placing::PlacedMap made;
  if (made.cells && made.cells->width() == edge) return made;
  const auto builder =
      grids::buildGrid(edge, edge, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
  std::vector<std::uint8_t> row(static_cast<std::size_t>(edge));
  for (int y = 0; y < edge; ++y) {
    for (int x = 0; x < edge; ++x) {
      const bool wall = x % 400 < 3 || y % 400 < 3;
      const std::uint32_t dice = noise(std::uint32_t(y) * 65'599u + std::uint32_t(x));
      row[std::size_t(x)] = wall || dice % 200 == 0 ? 100 : dice % 331 == 0 ? grids::kUnknownOccupancy : 0;
    }
    builder->pushRow(row);
  }
  builder->finish();
  made.cells = builder->pyramid();
  made.reference.width = made.reference.height = edge;
  made.reference.resolution_m = 0.05;
  return made;
}

std::vector<Eigen::Vector2d> placesOn(const placing::PlacedMap& map, int count) {
  const auto within_mm = std::uint32_t(map.reference.width * map.reference.resolution_m * 1000);
  std::vector<Eigen::Vector2d> places;
  for (std::uint32_t i = 0; i < std::uint32_t(count); ++i)
    places.emplace_back(noise(2 * i) % within_mm * 1e-3, noise(2 * i + 1) % within_mm * 1e-3);
  return places;
}

void placingWarnings(benchmark::State& state) {
  const placing::PlacedMap map = mapOf(int(state.range(0)));
  const auto places = placesOn(map, int(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(placing::groundWarnings(places, map, kRadiusM, nullptr));
}
BENCHMARK(placingWarnings)
    ->Name("PlacingWarnings")
    ->ArgNames({"map", "points"})
    ->Args({2'000, 20'000})
    ->Args({12'000, 2'000})
    ->Args({12'000, 20'000})
    ->Unit(benchmark::kMillisecond);

void placingWarningsByCrew(benchmark::State& state) {
  const placing::PlacedMap map = mapOf(int(state.range(0)));
  const auto places = placesOn(map, int(state.range(1)));
  work::Tasks share(std::make_shared<work::Workers>());
  for (auto _ : state) {
    for (const auto& group : placing::groupsOf(places, map.reference, kMostOfGroup)) {
      std::vector<Eigen::Vector2d> part;
      for (const std::size_t i : group) part.push_back(places[i]);
      share.start(work::Urgency::Wanted, [part = std::move(part), map] {
        benchmark::DoNotOptimize(placing::groundWarnings(part, map, kRadiusM, nullptr));
      });
    }
    share.waitForDone();
  }
}
BENCHMARK(placingWarningsByCrew)
    ->Name("PlacingWarningsByCrew")
    ->ArgNames({"map", "points"})
    ->Args({12'000, 20'000})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
