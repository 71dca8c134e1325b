// From connecting to a complete map of 500, 10,000 and 100,000 submaps over loopback: with an empty cache,
// after a restart, and next to a plain download of the same answers, four at a time, without decoding.
#include <chrono>
#include <memory>
#include <vector>

#include <QCoreApplication>
#include <QEventLoop>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QTemporaryDir>
#include <benchmark/benchmark.h>

#include "robot/axbot/axbot_robot.h"
#include "session/session_options.h"
#include "simulator/simulator.h"
#include "submap/submap_store.h"

namespace {

using namespace mapwright;
using Clock = std::chrono::steady_clock;

constexpr int kSubmaps = 500;

struct LoadTimes {
  double first_ms = -1, complete_ms = -1;
  session::SubmapCounts counts;
};

double since(Clock::time_point from) {
  return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
}

LoadTimes load(const simulator::Simulator& robot, const QString& cache_folder) {
  robot::axbot::LinkOptions options;
  options.base = QUrl(QStringLiteral("http://127.0.0.1:%1").arg(robot.port()));
  options.cache_folder = cache_folder;
  session::Session session(std::make_unique<robot::axbot::AxbotRobot>(QStringLiteral("bench"), options),
                           session::Session::Options{});
  LoadTimes times;
  const auto from = Clock::now();
  QEventLoop loop;
  QObject::connect(&session, &session::Session::submapsPlaced, &loop, [&] {
    if (times.first_ms < 0) times.first_ms = since(from);
    const auto& rows = session.submaps().rows();
    if (session.settled(1) && !rows.empty()) loop.quit();
  });
  session.open();
  loop.exec();
  times.complete_ms = since(from);
  times.counts = session.counts();
  return times;
}

std::unique_ptr<simulator::Simulator> robotOf(int submaps) {
  simulator::Options options;
  options.submaps = submaps;
  options.paused = true;
  options.pose_hz = 20;  // so that runs of every version are alike
  auto robot = std::make_unique<simulator::Simulator>(options);
  if (robot->start()) return nullptr;
  return robot;
}

void report(benchmark::State& state, const LoadTimes& times) {
  state.counters["first_paint_ms"] = times.first_ms;
  state.counters["complete_ms"] = times.complete_ms;
  state.counters["submaps"] = times.counts.shown;
  state.counters["network_fetches"] = double(times.counts.fetches);
}

void LoadEmptyCache(benchmark::State& state) {
  const auto robot = robotOf(kSubmaps);
  if (!robot) return state.SkipWithError("the simulator did not start");
  LoadTimes times = load(*robot, {});  // the simulator draws its textures now
  // Kept to the end: files made just after as many were removed cost the file system twice.
  std::vector<std::unique_ptr<QTemporaryDir>> caches;
  for (auto _ : state) {
    caches.push_back(std::make_unique<QTemporaryDir>());
    times = load(*robot, caches.back()->path());
  }
  report(state, times);
}

void LoadAfterRestart(benchmark::State& state) {
  const auto robot = robotOf(kSubmaps);
  if (!robot) return state.SkipWithError("the simulator did not start");
  const QTemporaryDir cache;
  LoadTimes times = load(*robot, cache.path());
  for (auto _ : state) times = load(*robot, cache.path());
  report(state, times);
}

/// The same addresses by a bare QNetworkAccessManager.
void LoadPlainDownload(benchmark::State& state) {
  const auto robot = robotOf(kSubmaps);
  if (!robot) return state.SkipWithError("the simulator did not start");
  load(*robot, {});
  std::vector<QUrl> addresses;
  for (const simulator::RequestRecord& record : robot->requestLog()) {
    if (record.target.starts_with("/ros/slam/submaps/")) {
      addresses.emplace_back(QStringLiteral("http://127.0.0.1:%1%2")
                                 .arg(robot->port())
                                 .arg(QString::fromStdString(record.target)));
    }
  }
  double bytes = 0;
  for (auto _ : state) {
    QNetworkAccessManager network;
    QEventLoop loop;
    std::size_t next = 0, done = 0;
    bytes = 0;
    std::function<void()> ask = [&] {
      if (next >= addresses.size()) return;
      QNetworkReply* reply = network.get(QNetworkRequest(addresses[next++]));
      QObject::connect(reply, &QNetworkReply::finished, [&, reply] {
        bytes += double(reply->readAll().size());
        reply->deleteLater();
        ask();
        if (++done == addresses.size()) loop.quit();
      });
    };
    for (int i = 0; i < 4; ++i) ask();
    loop.exec();
  }
  state.counters["requests"] = double(addresses.size());
  state.counters["MB"] = bytes / 1e6;
}

/// Once each: the cache is empty at first, and full for the second one.
void Load100k(benchmark::State& state) {
  const auto robot = robotOf(int(state.range(0)));
  if (!robot) return state.SkipWithError("the simulator did not start");
  for (auto _ : state) {
    const QTemporaryDir cache;
    const LoadTimes empty = load(*robot, cache.path()), restarted = load(*robot, cache.path());
    report(state, empty);
    state.counters["restart_ms"] = restarted.complete_ms;
    state.counters["restart_hits"] = double(restarted.counts.cache_hits);
    state.counters["texture_MB"] = double(restarted.counts.texture_bytes) / 1e6;
  }
}

BENCHMARK(LoadEmptyCache)->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(LoadAfterRestart)->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(LoadPlainDownload)->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(Load100k)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
