// Enforces a command's time limit even if its main thread is busy.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>

namespace mapwright::app {

using SteadyTime = std::chrono::steady_clock::time_point;

/// Seconds after --timeout during which the data received so far may still be drawn; then the process ends in
/// any case.
struct Grace {
  double draw_s = 0.15, end_s = 0.4;
};
/// When a command's time began, and how much it gets after the timeout.
struct CommandStart {
  SteadyTime begun;
  Grace grace;
};
/// The time counts from the start of the process, `age_s` ago: loading a program takes long on a busy
/// machine. A process that was replaced by exec can have any age: a large age does not count, but the grace
/// time is short then.
CommandStart commandStart(double timeout_s, double age_s, SteadyTime now = std::chrono::steady_clock::now());
/// Seconds since the process started; 0 if unknown.
double processAge();

/// `seconds` after `start`.
SteadyTime later(SteadyTime start, double seconds);

class Deadline {
 public:
  /// Called on the deadline's own thread when the time is over, while the main thread may be anywhere: prints
  /// the final messages and returns the exit code. It may only use data that nobody else changes.
  using LastWords = std::function<int()>;
  /// `end` gets the exit code; by default the process ends at once, without cleanup.
  Deadline(SteadyTime when, LastWords words, std::function<void(int)> end = {});
  /// In time: nothing happens any more.
  ~Deadline();
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  void setLastWords(LastWords words);

 private:
  void wait(SteadyTime when);

  std::mutex mutex_;
  std::condition_variable called_off_changed_;
  bool called_off_ = false;
  LastWords words_;
  std::function<void(int)> end_;
  std::thread thread_;
};

/// Writes a line to standard error, bypassing all buffers that the main thread may hold.
void sayAtTheEnd(const std::string& line);

}  // namespace mapwright::app
