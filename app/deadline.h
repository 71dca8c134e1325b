// The end of a command's time, kept also while its main thread is busy.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>

namespace mapwright::app {

using SteadyTime = std::chrono::steady_clock::time_point;

/// After the time-out (--timeout), in seconds: so long what has come may still be drawn, and then the process
/// ends, whatever it is doing.
struct Grace {
  double draw_s = 0.15, end_s = 0.4;
};
/// When a command's time began, and what it has after it.
struct CommandStart {
  SteadyTime begun;
  Grace grace;
};
/// The time counts from the start of the process, which is `age_s` ago: on a busy machine a program takes
/// long to be loaded. A process that another one became may be of any age: such an age does not count, but
/// the grace is short then.
CommandStart commandStart(double timeout_s, double age_s, SteadyTime now = std::chrono::steady_clock::now());
/// Seconds since the process was made; 0 where that is not known.
double processAge();

/// `seconds` after `start`.
SteadyTime later(SteadyTime start, double seconds);

class Deadline {
 public:
  /// Called on the deadline's own thread when the time is over, while the main thread may be anywhere: says
  /// what there is to say and returns the exit code. It may use only what nobody changes meanwhile.
  using LastWords = std::function<int()>;
  /// `end` gets the exit code; without it the process ends at once, without any cleaning up.
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

/// One line on standard error, past every buffer that the main thread may hold.
void sayAtTheEnd(const std::string& line);

}  // namespace mapwright::app
