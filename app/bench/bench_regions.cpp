// A map by regions: placing the pieces that come, next to a plain copy of their rows into one large buffer;
// cutting a rectangle out; and panning over what is held, next to the same cells as one whole map.
#include <algorithm>
#include <chrono>
#include <cstring>
#include <memory>
#include <thread>
#include <vector>

#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <benchmark/benchmark.h>

#include "grids/grid_pyramid.h"
#include "regions/region_cells.h"
#include "regions/region_fetch.h"
#include "regions/region_sheet.h"
#include "render/grid_renderer.h"
#include "work/workers.h"

namespace {

using namespace mapwright;
using Clock = std::chrono::steady_clock;

constexpr int kPiece = regions::RegionSheet::kStep, kAcross = 4, kEdge = kPiece * kAcross;
constexpr double kCellM = 0.05;

/// Rooms of 400 cells with walls, and ground that is not known.
std::int8_t cellAt(int x, int y) {
  if (x % 400 < 3 || y % 400 < 3) return 100;
  return (x / 400 + y / 400) % 5 == 0 ? std::int8_t(-1) : std::int8_t(0);
}

/// The pieces of a map of kEdge x kEdge cells, each with `margin` cells more on every side, as they are asked
/// for.
const std::vector<map::GridPart>& pieces(int margin) {
  static std::vector<map::GridPart> made[2];
  std::vector<map::GridPart>& parts = made[margin];
  if (!parts.empty()) return parts;
  for (int row = 0; row < kAcross; ++row) {
    for (int column = 0; column < kAcross; ++column) {
      map::GridPart part;
      const int left = column * kPiece - margin, bottom = row * kPiece - margin, edge = kPiece + 2 * margin;
      part.grid = {edge, edge, kCellM, {left * kCellM, bottom * kCellM, 0}};
      auto cells = std::make_shared<std::vector<std::int8_t>>();
      for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) cells->push_back(cellAt(std::abs(left + x), std::abs(bottom + y)));
      }
      part.cells = std::move(cells);
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

void reportPlaced(benchmark::State& state, double longest_ms) {
  state.SetBytesProcessed(std::int64_t(state.iterations()) * kEdge * kEdge);
  state.counters["pieces"] =
      benchmark::Counter(double(state.iterations()) * kAcross * kAcross, benchmark::Counter::kIsRate);
  state.counters["longest_ms"] = longest_ms;
}

double msSinceThen(Clock::time_point from) {
  return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
}

void RegionsPlacing(benchmark::State& state) {
  const auto& parts = pieces(1);
  double longest_ms = 0;
  for (auto _ : state) {
    regions::RegionCells cells;
    for (const map::GridPart& part : parts) {
      const auto from = Clock::now();
      cells.put(part);
      longest_ms = std::max(longest_ms, msSinceThen(from));
    }
    benchmark::DoNotOptimize(cells.bytes());
  }
  reportPlaced(state, longest_ms);
}
BENCHMARK(RegionsPlacing)->Unit(benchmark::kMillisecond);

void RegionsPlacingBaseline(benchmark::State& state) {
  const auto& parts = pieces(0);
  double longest_ms = 0;
  for (auto _ : state) {
    const std::unique_ptr<std::uint8_t[]> all(new std::uint8_t[std::size_t(kEdge) * kEdge]);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto from = Clock::now();
      const std::size_t column = i % kAcross, row = i / kAcross;
      for (std::size_t y = 0; y < kPiece; ++y) {
        std::memcpy(all.get() + (row * kPiece + y) * kEdge + column * kPiece,
                    parts[i].cells->data() + y * kPiece, kPiece);
      }
      longest_ms = std::max(longest_ms, msSinceThen(from));
    }
    benchmark::DoNotOptimize(all.get());
    benchmark::ClobberMemory();
  }
  reportPlaced(state, longest_ms);
}
BENCHMARK(RegionsPlacingBaseline)->Unit(benchmark::kMillisecond);

void RegionsCutOut(benchmark::State& state) {
  regions::RegionCells cells;
  for (const map::GridPart& part : pieces(1)) cells.put(part);
  const double edge = kEdge * kCellM;
  for (auto _ : state) {
    const auto fetched = regions::cutOut(cells.sheets(), {0, 0, edge, edge});
    benchmark::DoNotOptimize(fetched.cells.get());
  }
  state.SetBytesProcessed(std::int64_t(state.iterations()) * kEdge * kEdge);
}
BENCHMARK(RegionsCutOut)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A view of 1920 x 1080 is panned by 8 pixels a frame over `placed`, and painted when its tiles are there.
void pan(benchmark::State& state, const render::PlacedGrid& placed) {
  render::RasterTiles::Options options;
  options.workers = std::make_shared<work::Workers>();
  render::GridRenderer renderer(options);
  render::GridPalette palette;
  for (std::size_t byte = 0; byte < palette.size(); ++byte)
    palette[byte] = 0xff000000u | std::uint32_t(byte) * 0x010101u;
  renderer.setPalette(palette);
  renderer.setGrid(placed);
  geometry::ViewTransform view;
  view.width_px = 1920;
  view.height_px = 1080;
  view.scale_m_per_px = double(state.range(0)) / 100 * kCellM;
  view.center_m = {kEdge * kCellM / 2, kEdge * kCellM / 2};
  renderer.setActive(true);
  renderer.setView(view);
  const auto settle = [&] {
    do {
      QCoreApplication::processEvents();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    } while (!renderer.settled());
  };
  settle();
  QImage screen(1920, 1080, QImage::Format_ARGB32_Premultiplied);
  constexpr int kFrames = 400;
  std::vector<double> ms;
  for (auto _ : state) {
    for (int i = 0; i < kFrames; ++i) {
      const auto from = Clock::now();
      view = view.pannedBy({i % 200 < 100 ? -8.0 : 8.0, i % 200 < 100 ? -3.0 : 3.0});
      renderer.setView(view);
      QCoreApplication::processEvents();
      QPainter painter(&screen);
      const auto drawing = renderer.drawing();
      for (const auto* tiles : {&drawing.stand_ins, &drawing.tiles}) {
        for (const render::DrawnTile& tile : *tiles) {
          painter.setTransform(tile.to_viewport);
          painter.drawImage(0, 0, tile.image);
        }
      }
      painter.end();
      ms.push_back(msSinceThen(from));
    }
  }
  std::sort(ms.begin(), ms.end());
  state.counters["p50_ms"] = ms[ms.size() / 2];
  state.counters["p99_ms"] = ms[ms.size() * 99 / 100];
}

void RegionsPan(benchmark::State& state) {
  regions::RegionCells cells;
  for (const map::GridPart& part : pieces(1)) cells.put(part);
  pan(state, {cells.sheets().front(), cells.sheets().front()->reference()});
}
BENCHMARK(RegionsPan)
    ->ArgName("percent_of_a_cell")
    ->Arg(100)
    ->Arg(300)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

void RegionsPanBaseline(benchmark::State& state) {
  const auto builder =
      grids::buildGrid(kEdge, kEdge, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
  std::vector<std::uint8_t> row(kEdge);
  for (int y = kEdge; y-- > 0;) {
    for (int x = 0; x < kEdge; ++x) row[std::size_t(x)] = std::uint8_t(cellAt(x, y));
    builder->pushRow(row);
  }
  builder->finish();
  pan(state, {builder->pyramid(), {kEdge, kEdge, kCellM, {0, 0, 0}}});
}
BENCHMARK(RegionsPanBaseline)
    ->ArgName("percent_of_a_cell")
    ->Arg(100)
    ->Arg(300)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
