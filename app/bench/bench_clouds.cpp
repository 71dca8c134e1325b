// Five million points of a building at 1920x1080 in a real QGraphicsView: frames of a pan and of a zoom, and
// how long until all of it is exact. The baseline is what one does first: every point that is in view by
// QPainter, each frame.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>
#include <vector>

#include <QCoreApplication>
#include <QGraphicsView>
#include <QImage>
#include <QPainter>
#include <benchmark/benchmark.h>

#include "clouds/cloud_store.h"
#include "clouds/draw_cloud.h"
#include "render/tile_renderer.h"
#include "ui/scene/map_scene.h"

namespace {

using namespace mapwright;
using Clock = std::chrono::steady_clock;

constexpr int kFrames = 300;
constexpr double kSideM = 120;

/// Floors and walls of five storeys, scattered as a laser sees them.
std::shared_ptr<const map::SpatialCloud> building(std::size_t points) {
  auto cloud = std::make_shared<map::SpatialCloud>();
  std::uint32_t seed = 7;
  const auto random = [&seed] {
    seed = seed * 1'664'525U + 1'013'904'223U;
    return float(seed >> 8) / float(1 << 24);
  };
  cloud->points.reserve(points);
  for (std::size_t i = 0; i < points; ++i) {
    const float floor = std::floor(random() * 5) * 3.5F, noise = (random() - 0.5F) * 0.03F;
    if (i % 2 == 0) {
      cloud->points.emplace_back(random() * float(kSideM), random() * float(kSideM), floor + noise);
      continue;
    }
    const float along = random() * float(kSideM), wall = std::floor(random() * 16) * 8 + noise;
    const float z = floor + random() * 3;
    if (random() < 0.5F) {
      cloud->points.emplace_back(along, wall, z);
    } else {
      cloud->points.emplace_back(wall, along, z);
    }
  }
  return cloud;
}

const std::shared_ptr<const map::SpatialCloud>& fiveMillion() {
  static const auto made = building(5'000'000);
  return made;
}

geometry::ViewTransform camera() {
  geometry::ViewTransform view;
  view.width_px = 1920;
  view.height_px = 1080;
  view.center_m = {kSideM / 2, kSideM / 2};
  view.scale_m_per_px = kSideM / 1000;
  return view;
}

double zoomFactor(int frame) { return frame % 60 < 30 ? 1.05 : 1 / 1.05; }

template <class Look>
std::vector<double> timeFrames(Look look) {
  std::vector<double> ms;
  for (int i = 0; i < kFrames; ++i) {
    const auto from = Clock::now();
    look(i);
    QCoreApplication::processEvents();
    ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - from).count());
  }
  return ms;
}

void report(benchmark::State& state, std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  state.counters["p50_ms"] = ms[ms.size() / 2];
  state.counters["p99_ms"] = ms[ms.size() * 99 / 100];
  state.counters["worst_ms"] = ms.back();
}

struct CloudView {
  CloudView() : scene_(render::TileRenderer::Options{}, clouds_), view_(&scene_) {
    for (const ui::scene::Layer layer : ui::scene::allLayers())
      scene_.setLayerVisible(layer, layer == ui::scene::Layer::DispatchedCloud);
    view_.setFrameShape(QFrame::NoFrame);
    view_.resize(1920, 1080);
    view_.show();
    scene_.setView(camera_ = camera());
    const auto from = Clock::now();
    clouds_->add({fiveMillion()});
    settle();
    first_ms_ = std::chrono::duration<double, std::milli>(Clock::now() - from).count();
  }
  void settle() {
    do {
      QCoreApplication::processEvents();
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    } while (!scene_.picturesSettled());
  }
  void look(const geometry::ViewTransform& to) { scene_.setView(camera_ = to); }
  std::shared_ptr<clouds::CloudStore> clouds_ = std::make_shared<clouds::CloudStore>();
  ui::scene::MapScene scene_;
  QGraphicsView view_;
  geometry::ViewTransform camera_;
  double first_ms_ = 0;
};

/// All of it by QPainter, each point that is in view.
class PointsWidget : public QWidget {
 public:
  geometry::ViewTransform view = camera();

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::white);
    for (const Eigen::Vector3f& point : fiveMillion()->points) {
      const Eigen::Vector2d at = view.pixelFromWorld({double(point.x()), double(point.y())});
      if (!(at.x() >= 0 && at.y() >= 0 && at.x() < width() && at.y() < height())) continue;
      painter.setPen(QColor::fromHsv(int(std::clamp(240 - double(point.z()) * 14, 0.0, 240.0)), 220, 230));
      painter.drawPoint(QPointF(at.x(), at.y()));
    }
  }
};

void CloudsPan(benchmark::State& state) {
  CloudView cloud;
  std::vector<double> ms;
  for (auto _ : state) ms = timeFrames([&](int) { cloud.look(cloud.camera_.pannedBy({-8, -3})); });
  report(state, ms);
  state.counters["first_picture_ms"] = cloud.first_ms_;
}

void CloudsZoom(benchmark::State& state) {
  CloudView cloud;
  std::vector<double> ms;
  for (auto _ : state) {
    ms = timeFrames([&](int i) { cloud.look(cloud.camera_.zoomedAt({900, 500}, zoomFactor(i))); });
  }
  report(state, ms);
  const auto from = Clock::now();
  cloud.settle();
  state.counters["exact_after_ms"] = std::chrono::duration<double, std::milli>(Clock::now() - from).count();
}

void CloudsPanByPainter(benchmark::State& state) {
  PointsWidget widget;
  widget.resize(1920, 1080);
  // A window that nobody has shown yet would not be painted at all.
  QImage canvas(widget.size(), QImage::Format_RGB32);
  std::vector<double> ms;
  for (auto _ : state) {
    for (int i = 0; i < 5; ++i) {
      widget.view = widget.view.pannedBy({-8, -3});
      const auto from = Clock::now();
      widget.render(&canvas);
      ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - from).count());
    }
  }
  report(state, ms);
}

/// One tile of the whole building, one of a hundredth of it.
void CloudsTile(benchmark::State& state) {
  static const auto tree = clouds::CloudTree::make(*fiveMillion());
  clouds::NewestClouds newest;
  newest.add({.tree = tree, .points = tree->size()});
  const clouds::CloudSet set = newest.set();
  clouds::Raster raster;
  raster.scale_m_per_px = double(state.range(0)) / 1000;
  raster.width_px = raster.height_px = 256;
  raster.first_row = -256;
  for (auto _ : state) benchmark::DoNotOptimize(clouds::drawClouds(raster, set, {}));
}

BENCHMARK(CloudsPan)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(CloudsZoom)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(CloudsPanByPainter)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(CloudsTile)->Arg(500)->Arg(120)->Arg(20)->Unit(benchmark::kMillisecond);

}  // namespace
