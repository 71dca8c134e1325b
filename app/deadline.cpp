#include "app/deadline.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>
#include <unistd.h>
#include <utility>

namespace mapwright::app {

CommandStart commandStart(double timeout_s, double age_s, SteadyTime now) {
  constexpr double kLongestLoading = 2, kMostOfTheTime = 0.25;
  if (age_s <= std::min(kLongestLoading, kMostOfTheTime * timeout_s)) return {later(now, -age_s), {}};
  return {now, {0.08, 0.2}};
}

double processAge() {
  std::ifstream stat("/proc/self/stat");
  std::string line;
  std::getline(stat, line);
  // The name, in parentheses, may contain anything; the start time is the 20th word after it, in ticks since
  // boot.
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return 0;
  std::istringstream words(line.substr(name_end + 1));
  std::string word;
  for (int i = 0; i < 20; ++i) words >> word;
  const double started_s = std::strtod(word.c_str(), nullptr) / double(sysconf(_SC_CLK_TCK));
  timespec now{};
  if (!words || clock_gettime(CLOCK_BOOTTIME, &now) != 0) return 0;
  return std::max(0.0, double(now.tv_sec) + double(now.tv_nsec) / 1e9 - started_s);
}

SteadyTime later(SteadyTime start, double seconds) {
  return start + std::chrono::duration_cast<SteadyTime::duration>(std::chrono::duration<double>(seconds));
}

Deadline::Deadline(SteadyTime when, LastWords words, std::function<void(int)> end)
    : words_(std::move(words)), end_(std::move(end)), thread_([this, when] { wait(when); }) {}

Deadline::~Deadline() {
  {
    const std::lock_guard lock(mutex_);
    called_off_ = true;
  }
  called_off_changed_.notify_all();
  thread_.join();
}

void Deadline::setLastWords(LastWords words) {
  const std::lock_guard lock(mutex_);
  words_ = std::move(words);
}

void Deadline::wait(SteadyTime when) {
  std::unique_lock lock(mutex_);
  if (called_off_changed_.wait_until(lock, when, [this] { return called_off_; })) return;
  const int exit_code = words_ ? words_() : EXIT_FAILURE;
  if (!end_) std::_Exit(exit_code);
  end_(exit_code);
}

void sayAtTheEnd(const std::string& line) {
  const std::string text = line + '\n';
  if (write(STDERR_FILENO, text.data(), text.size()) < 0) return;  // nowhere to write to
}

}  // namespace mapwright::app
