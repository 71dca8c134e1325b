// Where 10,000 submaps of a route contradict each other, and how long it takes to look at one of them again,
// next to the plain way (OpenCV: each submap turned onto one picture of the world, and dilated) on a part of
// the route in the same run.
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <opencv2/imgproc.hpp>

#include "agreement/survey.h"
#include "cells/cell_texture.h"
#include "render/dense_cache.h"

namespace {

using namespace mapwright;

constexpr int kCells = 200;  // a submap is 10 m x 10 m
constexpr double kCellM = 0.05;

/// Rows of a shop floor: submaps every 2 m along aisles of 200 m that are 4 m apart, 41 % of their cells
/// known. They lie at any angle and so contradict each other nearly everywhere, which takes longest. Their
/// textures are 64 different ones, each held anew, since a robot sends each of its own.
std::vector<render::PlacedTexture> route(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-0.03, 0.03);
  std::vector<std::vector<cells::CellPair>> kinds(64);
  for (auto& cells : kinds) {
    cells.resize(std::size_t(kCells) * kCells);
    for (int v = 0; v < kCells; ++v) {
      for (int u = 0; u < kCells; ++u) {
        if (std::hypot(u - 100, v - 100) > 72) continue;
        const bool wall = (u % 40) < 2 || (v % 40) < 2 || random() % 400 == 0;
        const auto strength = std::uint8_t(random() % 70);
        cells[std::size_t(v * kCells + u)] = wall ? cells::CellPair{0, std::uint8_t(40 + strength)}
                                                  : cells::CellPair{std::uint8_t(10 + strength), 0};
      }
    }
  }
  std::vector<render::PlacedTexture> submaps;
  for (int index = 0; index < count; ++index) {
    const int aisle = index / 100;
    submaps.push_back(
        {{0, index},
         cells::CellTexture::fromPairs(kCells, kCells, kCellM, kinds[std::size_t(index) % 64]),
         {index % 100 * 2.0 + jitter(random), aisle * 4.0 + jitter(random), jitter(random) * 100},
         0});
  }
  return submaps;
}

double memoryMb(const char* what) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(what)) return std::stod(line.substr(line.find(':') + 1)) / 1024;
  }
  return 0;
}

void AgreementOfAll(benchmark::State& state) {
  const auto submaps = route(int(state.range(0)));
  const auto workers = std::make_shared<work::Workers>(2);
  std::ofstream("/proc/self/clear_refs") << 5;
  const double before = memoryMb("VmRSS");
  double share = 0, tiles = 0;
  for (auto _ : state) {
    agreement::Survey survey;
    survey.setSubmaps(submaps);
    render::DenseCache cache;
    survey.makeAll(workers, cache);
    share = survey.disagreement().share();
    tiles = double(survey.tiles());
  }
  state.counters["share_percent"] = share * 100;
  state.counters["tiles"] = tiles;
  state.counters["submaps_per_s"] =
      benchmark::Counter(double(submaps.size()) * double(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["peak_mb"] = memoryMb("VmHWM") - before;
}
BENCHMARK(AgreementOfAll)->Arg(100)->Arg(10'000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One submap of all has moved.
void AgreementAfterOneMoved(benchmark::State& state) {
  auto submaps = route(int(state.range(0)));
  const auto workers = std::make_shared<work::Workers>(2);
  agreement::Survey survey;
  survey.setSubmaps(submaps);
  render::DenseCache cache;
  survey.makeAll(workers, cache);
  for (auto _ : state) {
    submaps[submaps.size() / 2].world_from_texture.x_m += 0.01;
    survey.setSubmaps(submaps);
    survey.makeAll(workers, cache);
    benchmark::DoNotOptimize(survey.disagreement().contradicted_cells);
  }
}
BENCHMARK(AgreementAfterOneMoved)->Arg(10'000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The baseline: one core, all in one picture.
void AgreementPlain(benchmark::State& state) {
  const auto submaps = route(int(state.range(0)));
  constexpr int kWide = 4400, kHigh = 600, kX0 = -200, kY0 = -300;  // cells
  double share = 0;
  for (auto _ : state) {
    cv::Mat occupied_any = cv::Mat::zeros(kHigh, kWide, CV_8U), clear_any = occupied_any.clone();
    const cv::Mat disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, {9, 9});
    for (const render::PlacedTexture& placed : submaps) {
      cv::Mat read(kCells, kCells, CV_8U);  // 0 unseen, 1 undecided, 2 free, 3 occupied
      for (int v = 0; v < kCells; ++v) {
        for (int u = 0; u < kCells; ++u) {
          const cells::CellPair cell = placed.texture->at(u, v);
          read.at<std::uint8_t>(v, u) = cell == cells::CellPair{} ? 0
                                        : cell.alpha >= 24        ? 3
                                        : cell.value >= 24        ? 2
                                                                  : 1;
        }
      }
      // From the cells of the world to those of the texture.
      const geometry::Pose2& pose = placed.world_from_texture;
      const double c = std::cos(pose.yaw_rad), s = std::sin(pose.yaw_rad);
      const double x0 = (kX0 + 0.5) * kCellM - pose.x_m, y0 = (kY0 + 0.5) * kCellM - pose.y_m;
      const cv::Mat back = (cv::Mat_<double>(2, 3) << s, -c, (s * x0 - c * y0) / kCellM - 0.5, -c, -s,
                            (-c * x0 - s * y0) / kCellM - 0.5);
      cv::Mat laid, near;
      cv::warpAffine(read, laid, back, occupied_any.size(), cv::INTER_NEAREST | cv::WARP_INVERSE_MAP);
      cv::dilate(laid == 3, near, disc);
      occupied_any |= laid == 3;
      clear_any |= (laid == 2) & ~near;
    }
    share = cv::countNonZero(occupied_any & clear_any) / double(cv::countNonZero(occupied_any));
  }
  state.counters["share_percent"] = share * 100;
  state.counters["submaps_per_s"] =
      benchmark::Counter(double(submaps.size()) * double(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(AgreementPlain)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
