// What live layers and a large whole map cost the GUI thread: the scene in a real QGraphicsView, fed with
// messages that were made before the clock starts.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <random>
#include <thread>
#include <vector>

#include <QCoreApplication>
#include <QEvent>
#include <QEventLoop>
#include <QGraphicsView>
#include <QTimer>
#include <benchmark/benchmark.h>
#include <spng.h>

#include "grids/grid_pyramid.h"
#include "map/live_topics.h"
#include "render/tile_renderer.h"
#include "session/session_options.h"
#include "ui/scene/map_scene.h"

namespace {

using namespace mapwright;
using Clock = std::chrono::steady_clock;

/// CPU time of this thread.
double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

/// Speaks what it is given.
class ScriptedRobot : public robot::Robot, public robot::LiveTopics {
 public:
  QString address() const override { return QStringLiteral("bench:"); }
  void connectToRobot() override {}
  void disconnectFromRobot() override {}
  robot::ConnectionState connection() const override {
    robot::ConnectionState state;
    state.phase = robot::ConnectionPhase::Online;
    return state;
  }
  robot::RobotIdentity identity() const override { return {}; }
  robot::LiveTopics* liveTopics() override { return this; }
  QStringList known() const override { return {}; }
  QStringList topicsOf(map::Stream) const override { return {}; }
  void setWanted(const map::Streams&, const QStringList&) override {}
  void setWatching(bool) override {}
  void setTap(robot::FrameTap) override {}
  void say(const map::TopicMessage& message) {
    Q_EMIT topicReceived({message, double(QDateTime::currentMSecsSinceEpoch()) / 1000});
  }
};

std::shared_ptr<const std::string> grayPng(int width, int height, const std::vector<std::uint8_t>& cells) {
  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> encoder(spng_ctx_new(SPNG_CTX_ENCODER),
                                                                    &spng_ctx_free);
  spng_ihdr header{};
  header.width = std::uint32_t(width);
  header.height = std::uint32_t(height);
  header.bit_depth = 8;
  header.color_type = SPNG_COLOR_TYPE_GRAYSCALE;
  spng_set_option(encoder.get(), SPNG_ENCODE_TO_BUFFER, 1);
  spng_set_option(encoder.get(), SPNG_IMG_COMPRESSION_LEVEL, 1);
  spng_set_ihdr(encoder.get(), &header);
  spng_encode_image(encoder.get(), cells.data(), cells.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  std::size_t bytes = 0;
  int failure = 0;
  void* png = spng_get_png_buffer(encoder.get(), &bytes, &failure);
  auto text = std::make_shared<std::string>(static_cast<const char*>(png), bytes);
  std::free(png);
  return text;
}

/// Rooms with walls of two cells, unknown ground between the buildings.
std::vector<std::uint8_t> rooms(int width, int height) {
  std::vector<std::uint8_t> cells(std::size_t(width) * std::size_t(height));
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const int x = u % 240, y = v % 200;
      const bool outside = (u / 960 + v / 800) % 3 == 2;
      const bool wall = x < 2 || y < 2;
      cells[std::size_t(v) * std::size_t(width) + std::size_t(u)] = outside ? 128 : wall ? 0 : 255;
    }
  }
  return cells;
}

class PaintCount : public QObject {
 public:
  int count = 0;
  bool eventFilter(QObject*, QEvent* event) override {
    count += event->type() == QEvent::Paint;
    return false;
  }
};

session::Session::Options sessionOptions(std::shared_ptr<work::Workers> workers) {
  session::Session::Options options;
  options.workers = std::move(workers);
  return options;
}

struct Stage {
  Stage() : view(&scene) {
    auto made = std::make_unique<ScriptedRobot>();
    robot = made.get();
    session = std::make_unique<session::Session>(std::move(made), sessionOptions(workers));
    view.setFrameShape(QFrame::NoFrame);
    view.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view.setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view.resize(1920, 1080);
    view.show();
    camera.width_px = 1920;
    camera.height_px = 1080;
    camera.scale_m_per_px = 0.05;
    scene.setView(camera);
    scene.setSession(session.get());
  }
  ~Stage() { scene.setSession(nullptr); }
  void run(double seconds) {
    // A loop that sleeps between events: processEvents() with a time limit would spin.
    QEventLoop loop;
    QTimer::singleShot(int(seconds * 1000), Qt::PreciseTimer, &loop, &QEventLoop::quit);
    loop.exec();
  }

  std::shared_ptr<work::Workers> workers = std::make_shared<work::Workers>();
  ui::scene::MapScene scene{render::TileRenderer::Options{.workers = workers}};
  QGraphicsView view;
  ScriptedRobot* robot = nullptr;
  std::unique_ptr<session::Session> session;
  geometry::ViewTransform camera;
};

/// 30,000 points at 10 Hz, a costmap of 1 Mcell at 1 Hz, poses at 30 Hz over a whole map.
void LiveLayers(benchmark::State& state) {
  Stage stage;
  for (const ui::scene::Layer layer : {ui::scene::Layer::WholeMap, ui::scene::Layer::CostmapLow}) {
    stage.scene.setLayerVisible(layer, true);
  }
  stage.session->openMap({map::MapKind::Live, {}});
  map::GridMessage whole;
  whole.grid = {2000, 2000, 0.05, {-50, -50, 0}};
  whole.png = grayPng(2000, 2000, rooms(2000, 2000));
  stage.robot->say(whole);

  std::mt19937 random(5);
  std::vector<map::PointCloudMessage> clouds;
  for (int frame = 0; frame < 10; ++frame) {
    auto points = std::make_shared<std::vector<map::CloudPoint>>();
    for (int i = 0; i < int(state.range(0)); ++i) {
      const double angle = i * 6.283 / double(state.range(0));
      const double reach = 8 + 6 * std::sin(angle * 7 + frame) + double(random() % 100) / 200;
      points->push_back({std::cos(angle) * reach, std::sin(angle) * reach, 0.3F, std::uint8_t(i)});
    }
    clouds.push_back({"/scan_matched_points2", points});
  }
  std::vector<map::GridMessage> costmaps;
  for (int frame = 0; frame < 3; ++frame) {
    std::vector<std::uint8_t> cells(1'000'000, 0);
    for (int i = 0; i < 4000; ++i) {
      const std::size_t at = random() % (cells.size() - 3000);
      for (const std::size_t step : {0, 1, 2, 1000, 1001, 1002, 2001})
        cells[at + step] = step == 1001 ? 254 : 120;
    }
    map::GridMessage message;
    message.kind = map::GridKind::CostmapLow;
    message.topic = "/maps/5cm/1hz";
    message.grid = {1000, 1000, 0.05, {-25, -25, 0}};
    message.png = grayPng(1000, 1000, cells);
    costmaps.push_back(message);
  }
  map::RobotModel model;
  model.footprint = {{0.3, -0.2}, {0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}};
  stage.robot->say(model);
  stage.run(1);

  int poses = 0, scans = 0, maps = 0;
  QTimer pose_timer, cloud_timer, map_timer;
  QObject::connect(&pose_timer, &QTimer::timeout, [&] {
    stage.robot->say(
        map::TrackedPose{{std::cos(poses * 0.01) * 5, std::sin(poses * 0.01) * 5, poses * 0.01}});
    ++poses;
  });
  QObject::connect(&cloud_timer, &QTimer::timeout,
                   [&] { stage.robot->say(clouds[std::size_t(scans++ % 10)]); });
  QObject::connect(&map_timer, &QTimer::timeout,
                   [&] { stage.robot->say(costmaps[std::size_t(maps++ % 3)]); });
  pose_timer.setTimerType(Qt::PreciseTimer);
  cloud_timer.setTimerType(Qt::PreciseTimer);
  pose_timer.start(33);
  cloud_timer.start(100);
  map_timer.start(1000);
  constexpr double kSeconds = 6;
  for (auto _ : state) {
    const double before = threadSeconds();
    stage.run(kSeconds);
    state.counters["gui_percent_of_a_core"] = (threadSeconds() - before) / kSeconds * 100;
  }
  state.counters["poses"] = poses;
  state.counters["scans"] = scans;
  state.counters["costmaps"] = maps;
}

/// Pan over a whole map of `edge` cells while it is being read, and after.
void WholeMapPan(benchmark::State& state) {
  const int edge = int(state.range(0));
  Stage stage;
  stage.scene.setLayerVisible(ui::scene::Layer::Submaps, false);
  stage.scene.setLayerVisible(ui::scene::Layer::WholeMap, true);
  map::WholeMap map;
  map.key = {map::MapKind::Stored, "1"};
  map.grid = {edge, edge, 0.05, {0, 0, 0}};
  map.bytes = grayPng(edge, edge, rooms(edge, edge));
  stage.camera.center_m = {edge * 0.025, edge * 0.05 - 40};
  stage.camera.scale_m_per_px = 0.12;
  stage.scene.setView(stage.camera);
  stage.run(0.2);
  PaintCount paints;
  stage.view.viewport()->installEventFilter(&paints);
  // A frame is what lies between a step of the mouse and the picture: exactly one painting.
  const auto frame = [&](double dx) {
    const int before = paints.count;
    const auto from = Clock::now();
    stage.camera = stage.camera.pannedBy({dx, dx / 3});
    stage.scene.setView(stage.camera);
    while (paints.count == before) QCoreApplication::processEvents();
    return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
  };
  const auto p = [](std::vector<double> ms, double part) {
    if (ms.empty()) return 0.0;
    std::sort(ms.begin(), ms.end());
    return ms[std::size_t(double(ms.size() - 1) * part)];
  };
  for (auto _ : state) {
    const auto begun = Clock::now();
    double first_rows_ms = 0;
    stage.session->wholeMap().show(map);
    std::vector<double> loading, after;
    int i = 0;
    while (!stage.session->wholeMap().settled()) {
      loading.push_back(frame(i++ % 200 < 100 ? -6 : 6));
      const auto cells = stage.session->wholeMap().cells();
      if (first_rows_ms == 0 && cells && cells->rowsReady() > 0) {
        first_rows_ms = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(4));
    }
    state.counters["complete_ms"] = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
    state.counters["first_rows_ms"] = first_rows_ms;
    stage.run(0.3);
    const int painted = paints.count;
    for (i = 0; i < 400; ++i) after.push_back(frame(i % 200 < 100 ? -6 : 6));
    state.counters["paintings_per_frame"] = double(paints.count - painted) / 400;
    state.counters["loading_p50_ms"] = p(loading, 0.5);
    state.counters["loading_p99_ms"] = p(loading, 0.99);
    state.counters["after_p50_ms"] = p(after, 0.5);
    state.counters["after_p99_ms"] = p(after, 0.99);
  }
}

BENCHMARK(LiveLayers)->Arg(30'000)->Arg(5'000)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(WholeMapPan)->Arg(4'000)->Arg(12'000)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
