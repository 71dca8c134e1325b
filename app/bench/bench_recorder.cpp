// A robot that says 10 MB in a second, recorded for five: how long the thread of its link is kept for each
// message, and what share of a processor recording takes. The baseline writes the same bytes, at the same
// pace and on the same thread, to the same disk.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <fcntl.h>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <QTemporaryDir>
#include <benchmark/benchmark.h>

#include "recorder/recorder.h"
#include "recording/append_file.h"
#include "robot/delivery.h"
#include "robots_words.h"

namespace {

using namespace mapwright;
using Clock = std::chrono::steady_clock;

constexpr double kBytesInASecond = 10e6, kSeconds = 5;

/// A link that is told what came over it.
class Link final : public robot::Robot, public robot::Delivers {
 public:
  QString address() const override { return QStringLiteral("bench"); }
  void connectToRobot() override {}
  void disconnectFromRobot() override {}
  robot::ConnectionState connection() const override { return {}; }
  robot::RobotIdentity identity() const override { return {}; }
  void setDeliveryTap(robot::DeliveryTap tap) override {
    const std::lock_guard lock(mutex_);
    tap_ = std::move(tap);
  }
  void hear(std::string_view bytes, double now_s) {
    robot::Delivery delivery;
    delivery.name = bytes.find("/scan") < 16 ? "/scan_matched_points2" : "/tracked_pose";
    delivery.encoding = "json";
    delivery.bytes = bytes;
    delivery.received_s = now_s;
    const std::lock_guard lock(mutex_);
    if (tap_) tap_(delivery);
  }

 private:
  std::mutex mutex_;
  robot::DeliveryTap tap_;
};

double processorSeconds() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return double(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         double(used.ru_utime.tv_usec + used.ru_stime.tv_usec) / 1e6;
}

/// Calls `record` with what comes in kSeconds, each message when it is due, on a thread of its own; tells how
/// long that was kept for each.
template <typename Record>
void pace(benchmark::State& state, Record record) {
  const std::vector<std::string>& words = bench::robotsWords();
  std::vector<double> kept_us;
  kept_us.reserve(100'000);
  const double before_s = processorSeconds();
  const Clock::time_point start = Clock::now();
  std::thread link([&] {
    double bytes = 0;
    for (std::size_t i = 0; bytes < kSeconds * kBytesInASecond; ++i) {
      const std::string& word = words[i % words.size()];
      bytes += double(word.size());
      std::this_thread::sleep_until(start + std::chrono::duration_cast<Clock::duration>(
                                                std::chrono::duration<double>(bytes / kBytesInASecond)));
      const Clock::time_point from = Clock::now();
      record(word);
      kept_us.push_back(std::chrono::duration<double, std::micro>(Clock::now() - from).count());
    }
  });
  link.join();
  const double took_s = std::chrono::duration<double>(Clock::now() - start).count();
  state.counters["processor_share"] = (processorSeconds() - before_s) / took_s;
  double sum_us = 0;
  for (const double us : kept_us) sum_us += us;
  std::sort(kept_us.begin(), kept_us.end());
  state.counters["link_us"] = sum_us / double(kept_us.size());
  state.counters["link_p99_us"] = kept_us[kept_us.size() * 99 / 100];
  state.counters["link_share"] = sum_us / 1e6 / took_s;
}

void RecorderAt10MBs(benchmark::State& state) {
  for (auto _ : state) {
    QTemporaryDir folder(bench::folderOnDisk());
    Link robot;
    auto target = recording::appendFile(folder.filePath(QStringLiteral("a.mcap")).toStdString(),
                                        recording::Existing::Refuse);
    if (!target) return state.SkipWithError("no file");
    auto recorder = recorder::Recorder::start(robot, std::move(*target), {});
    if (!recorder) return state.SkipWithError("not started");
    const double start_s =
        std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
    double said = 0;
    pace(state, [&](const std::string& word) { robot.hear(word, start_s + ++said * 1e-3); });
    (*recorder)->finish();
    const recorder::Recorder::Progress progress = (*recorder)->progress();
    state.counters["lost"] = double(progress.written.lost);
    state.counters["stored_share"] = double(progress.written.bytes) / (kSeconds * kBytesInASecond);
  }
}

void RecorderBareBytesAt10MBs(benchmark::State& state) {
  for (auto _ : state) {
    QTemporaryDir folder(bench::folderOnDisk());
    const std::string path = folder.filePath(QStringLiteral("a")).toStdString();
    const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    bool written = fd >= 0;
    pace(state, [&](const std::string& word) {
      written = written && ::write(fd, word.data(), word.size()) == ssize_t(word.size());
    });
    ::close(fd);
    if (!written) state.SkipWithError("the disk is full");
  }
}

BENCHMARK(RecorderAt10MBs)->Unit(benchmark::kMillisecond)->Iterations(1)->UseRealTime();
BENCHMARK(RecorderBareBytesAt10MBs)->Unit(benchmark::kMillisecond)->Iterations(1)->UseRealTime();

}  // namespace
