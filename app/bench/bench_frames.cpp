// Frame times of a scripted pan and zoom at 1920x1080 in a real QGraphicsView: the tile scene of mapwright
// against the obvious scene of one QGraphicsPixmapItem per submap, for growing numbers of submaps.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <random>
#include <thread>
#include <vector>

#include <QCoreApplication>
#include <QGraphicsPixmapItem>
#include <QGraphicsView>
#include <QScrollBar>
#include <benchmark/benchmark.h>

#include "cells/cell_texture.h"
#include "render/tile_renderer.h"
#include "ui/scene/map_scene.h"

namespace {

using namespace mapwright;
using Clock = std::chrono::steady_clock;

constexpr int kCells = 400;
constexpr double kResolution = 0.05;
constexpr double kSpacing = 7.5;  // about three layers over each known cell
constexpr int kDistinct = 16;
constexpr int kFrames = 300;

std::vector<cells::CellPair> roomCells(std::mt19937& random) {
  std::vector<cells::CellPair> cells(std::size_t(kCells) * kCells);
  const double cx = kCells / 2.0, cy = kCells / 2.0;
  for (int v = 0; v < kCells; ++v) {
    for (int u = 0; u < kCells; ++u) {
      const double r = std::hypot(u - cx, v - cy) + 12 * std::sin(0.05 * u) + 9 * std::cos(0.07 * v);
      cells::CellPair& cell = cells[std::size_t(v) * kCells + std::size_t(u)];
      if (r < 142)
        cell = {std::uint8_t(60 + random() % 40), 0};
      else if (r < 145)
        cell = {0, std::uint8_t(80 + random() % 40)};
    }
  }
  return cells;
}

/// A square town of n submaps.
struct Town {
  std::vector<render::PlacedTexture> placed;
  std::vector<QImage> pictures;  // of the distinct textures, for the naive scene
  std::size_t distinct_bytes = 0;
  double side_m = 0;
};

const Town& town(int n) {
  static std::map<int, Town> towns;
  Town& made = towns[n];
  if (!made.placed.empty()) return made;
  std::mt19937 random(7);
  std::vector<std::shared_ptr<const cells::CellTexture>> textures;
  for (int i = 0; i < kDistinct; ++i) {
    const auto cells = roomCells(random);
    textures.push_back(cells::CellTexture::fromPairs(kCells, kCells, kResolution, cells));
    made.distinct_bytes += textures.back()->bytes();
    QImage picture(kCells, kCells, QImage::Format_ARGB32_Premultiplied);
    for (int v = 0; v < kCells; ++v) {
      for (int u = 0; u < kCells; ++u) {
        const cells::CellPair cell = cells[std::size_t(v) * kCells + std::size_t(u)];
        const int a = cell.alpha, g = std::min<int>(cell.value, 255);
        picture.setPixel(u, v, qRgba(g, g, g, std::max(a, g)));
      }
    }
    made.pictures.push_back(picture);
  }
  const int columns = int(std::ceil(std::sqrt(double(n))));
  made.side_m = columns * kSpacing;
  for (int i = 0; i < n; ++i) {
    const double yaw = double(random() % 6283) / 1000;
    const geometry::Pose2 center{(i % columns) * kSpacing, (i / columns) * kSpacing, yaw};
    // The texture reaches from its origin towards -x and -y.
    const geometry::Pose2 origin = center * geometry::Pose2{10, 10, 0};
    made.placed.push_back({{0, i}, textures[std::size_t(i % kDistinct)], origin, render::kActive});
  }
  return made;
}

void reportFrames(benchmark::State& state, std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  state.counters["p50_ms"] = ms[ms.size() / 2];
  state.counters["p99_ms"] = ms[ms.size() * 99 / 100];
}

template <typename Step>
std::vector<double> timeFrames(Step step) {
  std::vector<double> ms;
  for (int i = 0; i < kFrames; ++i) {
    const auto from = Clock::now();
    step(i);
    QCoreApplication::processEvents();
    ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - from).count());
  }
  return ms;
}

double zoomFactor(int frame) { return (frame / 50) % 2 == 0 ? 1 / 1.05 : 1.05; }

class TileView {
 public:
  explicit TileView(int n) : scene_(render::TileRenderer::Options{}), view_(&scene_) {
    view_.setFrameShape(QFrame::NoFrame);
    view_.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view_.setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view_.resize(1920, 1080);
    view_.show();
    camera_.width_px = 1920;
    camera_.height_px = 1080;
    camera_.center_m = {town(n).side_m / 2, town(n).side_m / 2};
    camera_.scale_m_per_px = kResolution;
    scene_.setView(camera_);
    scene_.renderer().upsert(town(n).placed);
    settle();
  }
  void settle() {
    while (!scene_.renderer().settled()) {
      QCoreApplication::processEvents();
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
  }
  void look(const geometry::ViewTransform& camera) { scene_.setView(camera_ = camera); }
  ui::scene::MapScene scene_;
  QGraphicsView view_;
  geometry::ViewTransform camera_;
};

class NaiveView {
 public:
  explicit NaiveView(int n) : view_(&scene_) {
    const Town& t = town(n);
    for (const auto& placed : t.placed) {
      auto* item = scene_.addPixmap(QPixmap::fromImage(t.pictures[std::size_t(placed.id.index % kDistinct)]));
      item->setTransformationMode(Qt::SmoothTransformation);
      item->setPos(placed.world_from_texture.x_m / kResolution, -placed.world_from_texture.y_m / kResolution);
      item->setRotation(-geometry::degreesFromRadians(placed.world_from_texture.yaw_rad));
    }
    view_.setFrameShape(QFrame::NoFrame);
    view_.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view_.setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view_.resize(1920, 1080);
    view_.show();
    view_.centerOn(t.side_m / 2 / kResolution, -t.side_m / 2 / kResolution);
    QCoreApplication::processEvents();
  }
  QGraphicsScene scene_;
  QGraphicsView view_;
};

void FramesPanTiles(benchmark::State& state) {
  TileView tiles(int(state.range(0)));
  std::vector<double> ms;
  for (auto _ : state) ms = timeFrames([&](int) { tiles.look(tiles.camera_.pannedBy({-8, -3})); });
  reportFrames(state, ms);
}

void FramesPanNaive(benchmark::State& state) {
  NaiveView naive(int(state.range(0)));
  std::vector<double> ms;
  for (auto _ : state) {
    ms = timeFrames([&](int) {
      naive.view_.horizontalScrollBar()->setValue(naive.view_.horizontalScrollBar()->value() + 8);
      naive.view_.verticalScrollBar()->setValue(naive.view_.verticalScrollBar()->value() + 3);
    });
  }
  reportFrames(state, ms);
}

void FramesZoomTiles(benchmark::State& state) {
  TileView tiles(int(state.range(0)));
  std::vector<double> ms;
  for (auto _ : state) {
    ms = timeFrames([&](int i) { tiles.look(tiles.camera_.zoomedAt({900, 500}, zoomFactor(i))); });
  }
  reportFrames(state, ms);
}

void FramesZoomNaive(benchmark::State& state) {
  NaiveView naive(int(state.range(0)));
  std::vector<double> ms;
  for (auto _ : state) {
    ms = timeFrames([&](int i) { naive.view_.scale(zoomFactor(i), zoomFactor(i)); });
  }
  reportFrames(state, ms);
}

void WholeMapFrameTiles(benchmark::State& state) {
  const int n = int(state.range(0));
  TileView tiles(n);
  geometry::WorldRect world;
  world.extend(Eigen::Vector2d(-10, -10));
  world.extend(Eigen::Vector2d(town(n).side_m + 10, town(n).side_m + 10));
  const auto from = Clock::now();
  tiles.look(tiles.camera_.fitted(world, 10));
  tiles.view_.viewport()->repaint();
  while (tiles.scene_.renderer().counts().exact + tiles.scene_.renderer().counts().preview <
         tiles.scene_.renderer().counts().visible) {
    QCoreApplication::processEvents();
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  tiles.view_.viewport()->repaint();
  state.counters["preview_ms"] = std::chrono::duration<double, std::milli>(Clock::now() - from).count();
  tiles.settle();
  state.counters["exact_ms"] = std::chrono::duration<double, std::milli>(Clock::now() - from).count();
  for (auto _ : state) tiles.view_.viewport()->repaint();
  state.counters["texture_MB_if_distinct"] = double(town(n).distinct_bytes) / kDistinct * n / 1e6;
  state.counters["tile_MB"] = double(tiles.scene_.renderer().counts().cache_bytes) / 1e6;
}

void WholeMapFrameNaive(benchmark::State& state) {
  const int n = int(state.range(0));
  NaiveView naive(n);
  naive.view_.fitInView(naive.scene_.itemsBoundingRect(), Qt::KeepAspectRatio);
  for (auto _ : state) naive.view_.viewport()->repaint();
  state.counters["pixmap_MB_if_distinct"] = double(kCells) * kCells * 4 * n / 1e6;
}

BENCHMARK(FramesPanTiles)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(10000)
    ->Arg(100000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(FramesPanNaive)->Arg(100)->Arg(1000)->Arg(10000)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(FramesZoomTiles)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(10000)
    ->Arg(100000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(FramesZoomNaive)->Arg(100)->Arg(1000)->Arg(10000)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(WholeMapFrameTiles)->Arg(100)->Arg(1000)->Arg(10000)->Iterations(20)->Unit(benchmark::kMillisecond);
BENCHMARK(WholeMapFrameNaive)->Arg(100)->Arg(1000)->Arg(10000)->Iterations(5)->Unit(benchmark::kMillisecond);

}  // namespace
