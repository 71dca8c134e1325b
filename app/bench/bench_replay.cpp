// A bag of eight hours with more than half a million messages, over loopback with 20 ms to every answer: how
// long a jump takes to its first picture of the world, what reading ranges costs next to QJsonDocument, how
// much of the window's thread playing takes, and what memory grows to.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <sys/resource.h>
#include <vector>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QJsonDocument>
#include <QTimer>
#include <benchmark/benchmark.h>

#include "replay/player.h"
#include "replay/reading.h"
#include "replay/replay_robot.h"
#include "robot/axbot/axbot_robot.h"
#include "robot/axbot/parse_bags.h"
#include "robot/bag_library.h"
#include "session/session_options.h"
#include "simulator/simulator.h"

namespace {

using namespace mapwright;
using Clock = std::chrono::steady_clock;

constexpr int kLatencyMs = 20;
constexpr const char* kLongBag = "eight_hours.bag";

double millisecondsSince(Clock::time_point from) {
  return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
}

bool waitFor(const std::function<bool()>& done, int at_most_ms = 120'000) {
  QElapsedTimer clock;
  clock.start();
  while (!done()) {
    if (clock.elapsed() > at_most_ms) return false;
    QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 1);
  }
  return true;
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, std::size_t(share * double(values.size())))];
}

/// Megabytes in memory now.
double residentMb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024;
  }
  return 0;
}

/// Seconds that this thread has worked.
double threadSeconds() {
  rusage used{};
  getrusage(RUSAGE_THREAD, &used);
  return double(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         double(used.ru_utime.tv_usec + used.ru_stime.tv_usec) / 1e6;
}

std::unique_ptr<simulator::Simulator> simulated() {
  simulator::Options options;
  options.paused = true;
  options.bags.odd = true;
  options.faults.requests.push_back({simulator::FaultKind::Delay, simulator::kMaps, 1, kLatencyMs});
  auto robot = std::make_unique<simulator::Simulator>(options);
  if (robot->start()) return nullptr;
  return robot;
}

std::unique_ptr<robot::Robot> clientOf(const simulator::Simulator& robot) {
  robot::axbot::LinkOptions options;
  options.base = QUrl(QStringLiteral("http://127.0.0.1:%1").arg(robot.port()));
  return std::make_unique<robot::axbot::AxbotRobot>(QStringLiteral("bench"), options);
}

robot::BagKey longBag() { return {robot::BagKind::Bag, kLongBag}; }

std::unique_ptr<replay::Reading> opened(robot::BagLibrary& library) {
  auto reading = std::make_unique<replay::Reading>(library, longBag(), replay::Reading::Options{});
  bool is_open = false;
  QObject context;
  QObject::connect(reading.get(), &replay::Reading::opened, &context, [&] { is_open = true; });
  reading->open();
  return waitFor([&] { return is_open; }) ? std::move(reading) : nullptr;
}

/// From the wish until the world of there can be shown: in ranges that are not held, and in those that are.
void ReplaySeek(benchmark::State& state) {
  const auto simulator = simulated();
  if (!simulator) return state.SkipWithError("the simulator did not start");
  const auto robot = clientOf(*simulator);
  const auto reading = opened(*robot->bagLibrary());
  if (!reading) return state.SkipWithError("the bag was not opened");
  std::mt19937 random(1);
  const double start_s = reading->chunks().start_s(), length_s = reading->chunks().end_s() - start_s;
  std::vector<double> fetched_ms, held_ms;
  const auto shown = [&] { return reading->moment().knowledge != replay::Knowledge::Buffering; };
  for (auto _ : state) {
    const double at_s = start_s + length_s * double(random() % 100'000) / 100'000;
    const replay::Cell* const cell = reading->chunks().cellAt(at_s);
    const bool held = cell && cell->held;
    auto from = Clock::now();
    reading->want(at_s);
    if (!waitFor(shown)) return state.SkipWithError("a range did not come");
    (held ? held_ms : fetched_ms).push_back(millisecondsSince(from));
    from = Clock::now();
    reading->want(at_s - 0.5);
    if (!waitFor(shown)) return state.SkipWithError("a range did not come");
    held_ms.push_back(millisecondsSince(from));
  }
  state.counters["fetched_p50_ms"] = percentile(fetched_ms, 0.5);
  state.counters["fetched_p95_ms"] = percentile(fetched_ms, 0.95);
  state.counters["held_p95_ms"] = percentile(held_ms, 0.95);
}

/// The text of a range of ten minutes.
std::string someText() {
  const auto simulator = simulated();
  if (!simulator) return {};
  const auto robot = clientOf(*simulator);
  const auto reading = opened(*robot->bagLibrary());
  if (!reading) return {};
  std::string text;
  bool ended = false;
  const double from_s = reading->chunks().start_s() + 3600;
  const robot::Call call = robot->bagLibrary()->messages(
      longBag(), {from_s, from_s + 600}, [&](const robot::Outcome<robot::BagChunkPtr>& outcome) {
        if (outcome && (*outcome)->text) text = *(*outcome)->text;
        ended = true;
      });
  waitFor([&] { return ended; });
  return text;
}

void ReplayParse(benchmark::State& state) {
  const std::string text = someText();
  if (text.empty()) return state.SkipWithError("no range came");
  for (auto _ : state) benchmark::DoNotOptimize(robot::axbot::parseBagChunk(text, {0, 4e9}));
  state.SetBytesProcessed(std::int64_t(text.size()) * state.iterations());
}

/// What it is measured against: a tree of the same text, of which nothing is made yet.
void ReplayParseQJson(benchmark::State& state) {
  const QByteArray text = QByteArray::fromStdString(someText());
  if (text.isEmpty()) return state.SkipWithError("no range came");
  for (auto _ : state) benchmark::DoNotOptimize(QJsonDocument::fromJson(text));
  state.SetBytesProcessed(text.size() * state.iterations());
}

/// Ten seconds in the window's way, without a window: argument = speed.
void ReplayPlay(benchmark::State& state) {
  const auto simulator = simulated();
  if (!simulator) return state.SkipWithError("the simulator did not start");
  constexpr double kSeconds = 10;
  constexpr int kFrameMs = 33;
  double share = 0;
  for (auto _ : state) {
    auto replayed = std::make_unique<replay::ReplayRobot>(clientOf(*simulator), kLongBag);
    replay::ReplayRobot& robot = *replayed;
    session::Session session(std::move(replayed), session::Session::Options{});
    QObject::connect(&robot, &replay::ReplayRobot::jumped, &session,
                     [&](const map::World& world, replay::Knowledge) { session.reset(world); });
    session.open();
    if (!waitFor([&] { return robot.reading() && robot.reading()->info(); }))
      return state.SkipWithError("the bag was not opened");
    replay::Player player(robot.reading()->chunks().start_s(), robot.reading()->chunks().end_s());
    QElapsedTimer clock;
    clock.start();
    player.seek(player.start_s() + 600, 0);
    robot.goTo(player.at(0));
    if (!waitFor([&] { return robot.knowledge() == replay::Knowledge::Exact; }))
      return state.SkipWithError("the world did not become exact");
    player.setSpeed(double(state.range(0)), clock.elapsed());
    player.play(clock.elapsed());
    QTimer frames;
    frames.setTimerType(Qt::PreciseTimer);
    QEventLoop loop;
    QObject::connect(&frames, &QTimer::timeout, [&] { robot.goTo(player.at(clock.elapsed())); });
    QTimer::singleShot(int(kSeconds * 1000), &loop, &QEventLoop::quit);
    const double before_s = threadSeconds();
    frames.start(kFrameMs);
    loop.exec();
    share = (threadSeconds() - before_s) / kSeconds;
  }
  state.counters["thread_share"] = share;
}

/// All eight hours, read from the start to the end.
void ReplayMemory(benchmark::State& state) {
  const auto simulator = simulated();
  if (!simulator) return state.SkipWithError("the simulator did not start");
  const auto robot = clientOf(*simulator);
  double before_mb = 0, hour_mb = 0, end_mb = 0, messages = 0;
  for (auto _ : state) {
    const auto reading = opened(*robot->bagLibrary());
    if (!reading) return state.SkipWithError("the bag was not opened");
    before_mb = residentMb();
    const double start_s = reading->chunks().start_s();
    reading->want(start_s + 3600);
    if (!waitFor([&] { return reading->chunks().readUntil(start_s + 3600); }))
      return state.SkipWithError("an hour was not read");
    hour_mb = residentMb();
    reading->want(reading->chunks().end_s());
    if (!waitFor([&] { return reading->chunks().readUntil(reading->chunks().end_s()); }, 600'000))
      return state.SkipWithError("the bag was not read");
    benchmark::DoNotOptimize(reading->moment());
    end_mb = residentMb();
    messages = double(reading->chunks().messagesRead());
  }
  state.counters["messages"] = messages;
  state.counters["before_MB"] = before_mb;
  state.counters["hour_MB"] = hour_mb;
  state.counters["end_MB"] = end_mb;
}

BENCHMARK(ReplaySeek)->Unit(benchmark::kMillisecond)->Iterations(100);
BENCHMARK(ReplayParse)->Unit(benchmark::kMillisecond);
BENCHMARK(ReplayParseQJson)->Unit(benchmark::kMillisecond);
BENCHMARK(ReplayPlay)->Arg(1)->Arg(20)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(ReplayMemory)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
