// From a frame of rosbridge to the cells of a grid and on to its tiles, each of the three ways that it can
// travel; what it costs that texts come as UTF-16; and transforms at the rate of a real robot. The baseline
// copies the cells: what nobody can do without.
#include <atomic>
#include <cmath>
#include <cstring>
#include <ctime>
#include <vector>

#include <QBuffer>
#include <QByteArray>
#include <QCborStreamWriter>
#include <QDateTime>
#include <QEventLoop>
#include <QImage>
#include <QThread>
#include <QTimer>
#include <QWebSocket>
#include <QWebSocketServer>
#include <benchmark/benchmark.h>

#include "grids/grid_pyramid.h"
#include "net/rosbridge/frame.h"
#include "robot/ros/ros_robot.h"
#include "robot/ros/ros_world.h"

namespace {

using mapwright::net::rosbridge::Frame;

constexpr int kWidth = 2000, kHeight = 1500;
constexpr std::size_t kCells = std::size_t(kWidth) * kHeight;

/// Rooms with walls of two cells, unknown ground between the buildings.
const std::vector<std::int8_t>& gridCells() {
  static const std::vector<std::int8_t> cells = [] {
    std::vector<std::int8_t> made(kCells);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const bool outside = (x / 960 + y / 800) % 3 == 2;
        const bool wall = x % 240 < 2 || y % 200 < 2;
        made[std::size_t(y) * kWidth + std::size_t(x)] = std::int8_t(outside ? -1 : wall ? 100 : 0);
      }
    }
    return made;
  }();
  return cells;
}

QByteArray jsonFrame() {
  QByteArray text =
      R"({"op": "publish", "topic": "\/map", "msg": {"info": {"resolution": 0.05, "width": 2000, "height": 1500, )"
      R"("origin": {"position": {"x": 0, "y": 0, "z": 0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}}, )"
      R"("data": [)";
  for (const std::int8_t cell : gridCells()) text += QByteArray::number(cell) + ", ";
  text.chop(2);
  return text + "]}}";
}

QByteArray pictureFrame() {
  QByteArray text = jsonFrame();
  const int width = int(std::floor(std::sqrt(double(text.size()) / 3.0)));
  const int height = int(std::ceil(double(text.size()) / 3.0 / width));
  text.append(QByteArray(qsizetype(width) * height * 3 - text.size(), '\n'));
  const QImage image(reinterpret_cast<const uchar*>(text.constData()), width, height, width * 3,
                     QImage::Format_RGB888);
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return "{\"op\": \"png\", \"data\": \"" + png.toBase64() + "\"}";
}

QByteArray cborFrame() {
  QByteArray bytes;
  QCborStreamWriter writer(&bytes);
  const auto text = [&](const char* word) { writer.append(QLatin1String(word)); };
  writer.startMap(3);
  text("op");
  text("publish");
  text("topic");
  text("/map");
  text("msg");
  writer.startMap(2);
  text("info");
  writer.startMap(4);
  text("origin");
  writer.startMap(1);
  text("position");
  writer.startMap(2);
  for (const char* axis : {"x", "y"}) {
    text(axis);
    writer.append(0.0);
  }
  writer.endMap();
  writer.endMap();
  text("width");
  writer.append(kWidth);
  text("height");
  writer.append(kHeight);
  text("resolution");
  writer.append(0.05);
  writer.endMap();
  text("data");
  writer.append(QCborTag(72));
  writer.appendByteString(reinterpret_cast<const char*>(gridCells().data()), qsizetype(kCells));
  writer.endMap();
  writer.endMap();
  return bytes;
}

void readCells(benchmark::State& state, const QByteArray& bytes, Frame::Wire wire) {
  for (auto _ : state) {
    const auto frame = Frame::read(bytes, wire);
    const auto cells = frame->root()["msg"]["data"].int8s(kCells);
    if (!cells || *cells != gridCells()) {
      state.SkipWithError("the cells are not those that were sent");
      return;
    }
  }
  state.counters["frame_bytes"] = double(bytes.size());
  state.SetItemsProcessed(state.iterations() * std::int64_t(kCells));
}

void RosbridgeGridJson(benchmark::State& state) { readCells(state, jsonFrame(), Frame::Wire::Text); }
void RosbridgeGridPng(benchmark::State& state) { readCells(state, pictureFrame(), Frame::Wire::Text); }
void RosbridgeGridCbor(benchmark::State& state) { readCells(state, cborFrame(), Frame::Wire::Binary); }

void RosbridgeGridCopied(benchmark::State& state) {
  for (auto _ : state) {
    std::vector<std::int8_t> cells(kCells);
    std::memcpy(cells.data(), gridCells().data(), kCells);
    benchmark::DoNotOptimize(cells.data());
    benchmark::ClobberMemory();
    if (cells != gridCells()) state.SkipWithError("the copy differs");
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(kCells));
}

/// As QWebSocket hands texts over, whatever they hold.
void RosbridgeTextWidened(benchmark::State& state) {
  const QByteArray bytes = jsonFrame();
  for (auto _ : state) {
    const QString wide = QString::fromUtf8(bytes);
    const QByteArray back = wide.toUtf8();
    benchmark::DoNotOptimize(back.constData());
  }
  state.counters["frame_bytes"] = double(bytes.size());
}

/// All that happens to a map until its tiles can be drawn.
void toTiles(benchmark::State& state, const QByteArray& bytes, Frame::Wire wire) {
  using namespace mapwright;
  const robot::ros::Source source{map::Stream::WholeMap, robot::ros::Form::Grid, "/map", {}, {}, true};
  for (auto _ : state) {
    robot::ros::RosWorld world;
    const auto frame = Frame::read(bytes, wire);
    const auto results = world.add(source, frame->root()["msg"], 1);
    const auto* const grid =
        results.front().message ? std::get_if<map::GridMessage>(&*results.front().message) : nullptr;
    if (!grid) {
      state.SkipWithError("no grid came of it");
      return;
    }
    grids::GridOptions options;
    options.reading = grid->reading;
    auto reading = grids::openGrid(grid->png, options);
    const std::atomic<bool> cancelled{false};
    if (!reading || (*reading)->read(cancelled, [] {})) {
      state.SkipWithError("it cannot be read");
      return;
    }
    benchmark::DoNotOptimize((*reading)->pyramid()->tile(0, 0, 0));
  }
}

void RosbridgeMapJsonToTiles(benchmark::State& state) { toTiles(state, jsonFrame(), Frame::Wire::Text); }
void RosbridgeMapPngToTiles(benchmark::State& state) { toTiles(state, pictureFrame(), Frame::Wire::Text); }
void RosbridgeMapCborToTiles(benchmark::State& state) { toTiles(state, cborFrame(), Frame::Wire::Binary); }

QByteArray transforms(int frames, double at_s) {
  QByteArray text = R"({"op": "publish", "topic": "\/tf", "msg": {"transforms": [)";
  for (int i = 0; i < frames; ++i) {
    const QByteArray parent = i == 0 ? "map" : i == 1 ? "base_link" : "link" + QByteArray::number(i - 1);
    const QByteArray child = i == 0 ? "base_link" : "link" + QByteArray::number(i);
    const auto whole = std::int64_t(at_s);
    text += R"({"header": {"seq": 1, "frame_id": ")" + parent + R"(", "stamp": {"secs": )" +
            QByteArray::number(qlonglong(whole)) + R"(, "nsecs": )" +
            QByteArray::number(int((at_s - double(whole)) * 1e9)) + R"(}}, "child_frame_id": ")" + child +
            R"(", "transform": {"translation": {"x": )" + QByteArray::number(std::sin(at_s), 'g', 17) +
            R"(, "y": 0.25, "z": 0}, "rotation": {"x": 0, "y": 0, "z": 0, "w": 1}}}, )";
  }
  text.chop(2);
  return text + "]}}";
}

/// One message of 30 transforms: read, filed, the pose of the robot looked up.
void RosTransformsTaken(benchmark::State& state) {
  using namespace mapwright;
  const robot::ros::Source source{map::Stream::Pose, robot::ros::Form::Tf, "/tf", {}, {}, true};
  robot::ros::RosWorld world;
  double at_s = 1'700'000'000;
  for (auto _ : state) {
    state.PauseTiming();
    const QByteArray bytes = transforms(30, at_s += 0.01);
    state.ResumeTiming();
    const auto frame = Frame::read(bytes, Frame::Wire::Text);
    world.add(source, frame->root()["msg"], at_s);
    const auto pose = world.pose();
    if (!pose || !*pose) state.SkipWithError("there is no pose");
  }
}

double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

/// 100 times a second 30 transforms for a robot that is connected: the share of the thread that draws, and of
/// the whole program (the server included).
void RosTransformsWhileDrawing(benchmark::State& state) {
  using namespace mapwright;
  QThread beside;
  QObject on_thread;
  QTimer* ticks = nullptr;
  QWebSocketServer* server = nullptr;
  quint16 port = 0;
  on_thread.moveToThread(&beside);
  beside.start();
  QMetaObject::invokeMethod(
      &on_thread,
      [&] {
        server = new QWebSocketServer(QStringLiteral("bench"), QWebSocketServer::NonSecureMode);
        server->listen(QHostAddress::LocalHost);
        port = server->serverPort();
        auto* const peers = new QList<QWebSocket*>;
        QObject::connect(server, &QWebSocketServer::newConnection, server,
                         [=] { peers->append(server->nextPendingConnection()); });
        ticks = new QTimer(server);
        ticks->setTimerType(Qt::PreciseTimer);
        QObject::connect(ticks, &QTimer::timeout, server, [=] {
          const double now_s = double(QDateTime::currentMSecsSinceEpoch()) / 1000;
          const QString text = QString::fromUtf8(transforms(30, now_s));
          for (QWebSocket* peer : *peers) peer->sendTextMessage(text);
        });
        QObject::connect(server, &QObject::destroyed, [=] { delete peers; });
        ticks->start(10);
      },
      Qt::BlockingQueuedConnection);
  {
    robot::ros::LinkOptions options;
    options.url = QUrl(QStringLiteral("ws://127.0.0.1:%1").arg(port));
    options.look_timeout = std::chrono::milliseconds(50);
    robot::ros::RosRobot robot(QStringLiteral("ros+bench"), options);
    int poses = 0;
    QObject::connect(&robot, &robot::Robot::topicReceived, &robot, [&](const map::StampedMessage& message) {
      poses += std::holds_alternative<map::TrackedPose>(message.message);
    });
    robot.connectToRobot();
    const auto run = [](int ms) {
      QEventLoop loop;
      QTimer::singleShot(ms, Qt::PreciseTimer, &loop, &QEventLoop::quit);
      loop.exec();
    };
    run(3'000);
    for (auto _ : state) {
      poses = 0;
      const double before_s = threadSeconds();
      const std::clock_t all = std::clock();
      run(2'000);
      state.SetIterationTime(2);
      state.counters["gui_thread_percent"] = (threadSeconds() - before_s) / 2 * 100;
      state.counters["all_threads_percent"] = double(std::clock() - all) / CLOCKS_PER_SEC / 2 * 100;
      state.counters["poses_per_second"] = poses / 2.0;
    }
  }
  QMetaObject::invokeMethod(
      &on_thread, [&] { delete server; }, Qt::BlockingQueuedConnection);
  beside.quit();
  beside.wait();
}

BENCHMARK(RosbridgeTextWidened)->Unit(benchmark::kMillisecond);
BENCHMARK(RosbridgeMapJsonToTiles)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(RosbridgeMapPngToTiles)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(RosbridgeMapCborToTiles)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(RosTransformsTaken)->Unit(benchmark::kMicrosecond);
BENCHMARK(RosTransformsWhileDrawing)->UseManualTime()->Iterations(2);
BENCHMARK(RosbridgeGridJson)->Unit(benchmark::kMillisecond);
BENCHMARK(RosbridgeGridPng)->Unit(benchmark::kMillisecond);
BENCHMARK(RosbridgeGridCbor)->Unit(benchmark::kMillisecond);
BENCHMARK(RosbridgeGridCopied)->Unit(benchmark::kMillisecond);

}  // namespace
