// Editing a whole map: a step of a stroke, filling all of it, undoing that, tidying up. The fill's baseline
// is OpenCV's on one picture in memory, which has no levels of detail and cannot be undone.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include <benchmark/benchmark.h>
#include <opencv2/imgproc.hpp>

#include "picture/draw.h"
#include "picture/fill.h"
#include "picture/merge.h"
#include "picture/tidy.h"

namespace {

using namespace mapwright;
using namespace mapwright::picture;

constexpr std::uint8_t kFree = 0, kOccupied = 100, kUnknown = 255;

std::uint32_t noise(std::uint32_t seed) {
  seed ^= seed >> 16;
  seed *= 0x7feb352d;
  seed ^= seed >> 15;
  seed *= 0x846ca68b;
  return seed ^ seed >> 16;
}

/// Rooms with doors, a speck in every 200 cells.
std::uint8_t cellAt(int x, int y) {
  const int room_x = x % 400, room_y = y % 400;
  const bool door = (room_x > 150 && room_x < 190) || (room_y > 150 && room_y < 190);
  if ((room_x < 3 || room_y < 3) && !door) return kOccupied;
  const std::uint32_t dice = noise(std::uint32_t(y) * 65'599u + std::uint32_t(x));
  return dice % 200 == 0 ? kOccupied : dice % 331 == 0 ? kUnknown : kFree;
}

std::shared_ptr<const grids::GridPyramid> mapOf(int edge) {
  static std::shared_ptr<const grids::GridPyramid> made;
  if (made && made->width() == edge) return made;
  const auto builder =
      grids::buildGrid(edge, edge, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
  std::vector<std::uint8_t> row(static_cast<std::size_t>(edge));
  for (int y = 0; y < edge; ++y) {
    for (int x = 0; x < edge; ++x) row[std::size_t(x)] = cellAt(x, y);
    builder->pushRow(row);
  }
  builder->finish();
  made = builder->pyramid();
  return made;
}

/// One movement of the hand, 12 cells far, with all that the window reckons for it but drawing. Round and
/// round, each lap in another colour: what is painted already costs nothing.
void pictureStroke(benchmark::State& state) {
  constexpr int kLap = 126;
  EditedGrid grid(mapOf(int(state.range(0))));
  std::optional<Stroke> stroke;
  Eigen::Vector2d at(double(state.range(0)) / 2, double(state.range(0)) / 2);
  std::size_t tiles = 0;
  int step = 0;
  for (auto _ : state) {
    if (step % kLap == 0) {
      const std::uint8_t byte = step / kLap % 2 == 0 ? kOccupied : kFree;
      stroke.emplace(grid, Brush{int(state.range(1)), {byte, {}}});
    }
    const double angle = 2 * M_PI * step / kLap;
    at += Eigen::Vector2d(std::cos(angle), std::sin(angle)) * 12;
    ++step;
    benchmark::DoNotOptimize(stroke->to(at));
    tiles = std::max(tiles, stroke->soFar().tiles.size());
  }
  state.counters["tiles held"] = double(tiles);
}
BENCHMARK(pictureStroke)
    ->Name("PictureStroke")
    ->ArgNames({"map", "brush"})
    ->Args({1'000, 9})
    ->Args({12'000, 9})
    ->Args({12'000, 101})
    ->Args({12'000, 1'000})
    ->Unit(benchmark::kMicrosecond);

void pictureFill(benchmark::State& state) {
  const EditedGrid grid(mapOf(int(state.range(0))));
  std::size_t tiles = 0;
  for (auto _ : state) {
    const auto copy = grid.snapshot();
    Canvas canvas(*copy);
    floodFill(canvas, 5, 5, {kUnknown, {}});
    const Patch patch = canvas.take();
    copy->apply(patch);
    tiles = patch.tiles.size();
  }
  state.counters["tiles"] = double(tiles);
}
BENCHMARK(pictureFill)
    ->Name("PictureFill")
    ->ArgName("map")
    ->Arg(4'000)
    ->Arg(12'000)
    ->Unit(benchmark::kMillisecond);

void pictureFillOpenCv(benchmark::State& state) {
  const int edge = int(state.range(0));
  cv::Mat cells(edge, edge, CV_8U);
  for (int y = 0; y < edge; ++y) {
    for (int x = 0; x < edge; ++x) cells.at<std::uint8_t>(y, x) = cellAt(x, y);
  }
  cv::setNumThreads(1);
  for (auto _ : state) {
    state.PauseTiming();
    cv::Mat copy = cells.clone();
    state.ResumeTiming();
    cv::floodFill(copy, cv::Point(5, 5), cv::Scalar(kUnknown));
  }
}
BENCHMARK(pictureFillOpenCv)
    ->Name("PictureFillOpenCV")
    ->ArgName("map")
    ->Arg(4'000)
    ->Arg(12'000)
    ->Unit(benchmark::kMillisecond);

/// Undoing and redoing the fill of all, with the count of what is changed.
void pictureUndo(benchmark::State& state) {
  EditedGrid grid(mapOf(int(state.range(0))));
  const auto saved = grid.snapshot();
  Canvas canvas(grid);
  floodFill(canvas, 5, 5, {kUnknown, {}});
  const Patch patch = canvas.take();
  grid.apply(patch);
  DifferenceCount count;
  for (auto _ : state) {
    grid.revert(patch);
    count.recount(grid, *saved, patch);
    state.PauseTiming();
    grid.apply(patch);
    state.ResumeTiming();
  }
}
BENCHMARK(pictureUndo)->Name("PictureUndo")->ArgName("map")->Arg(12'000)->Unit(benchmark::kMillisecond);

void pictureCount(benchmark::State& state) {
  EditedGrid grid(mapOf(int(state.range(0))));
  const auto saved = grid.snapshot();
  Canvas canvas(grid);
  floodFill(canvas, 5, 5, {kUnknown, {}});
  const Patch patch = canvas.take();
  grid.apply(patch);
  DifferenceCount count;
  for (auto _ : state) count.recount(grid, *saved, patch);
  state.counters["cells"] = double(count.cells);
}
BENCHMARK(pictureCount)->Name("PictureCount")->ArgName("map")->Arg(12'000)->Unit(benchmark::kMillisecond);

void pictureSpecks(benchmark::State& state) {
  const EditedGrid grid(mapOf(int(state.range(0))));
  Tidied tidied;
  for (auto _ : state) {
    Canvas canvas(grid);
    tidied = removeSpecks(canvas, canvas.all(), 4);
    benchmark::DoNotOptimize(canvas.take());
  }
  state.counters["specks"] = double(tidied.pieces);
}
BENCHMARK(pictureSpecks)
    ->Name("PictureSpecks")
    ->ArgName("map")
    ->Arg(4'000)
    ->Arg(12'000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
