// How long the window could not answer: the time that each event took, as a histogram.
#pragma once

#include <array>
#include <chrono>
#include <vector>

#include <QString>

namespace mapwright::ui {

/// What kept the thread of the window busy: who got which event. Names of the program's own classes.
struct Busy {
  const char* receiver = "";  // a class name, which lives as long as the program
  int event = 0;              // QEvent::Type
  /// "Timer, MapView".
  QString text() const;
};

class Stalls {
 public:
  using Duration = std::chrono::nanoseconds;
  /// Upper limits in ms, not included; what is longer is counted behind the last.
  static constexpr std::array kBelowMs{16, 33, 50, 100, 200, 500};

  void add(Duration duration, const Busy& busy);
  const std::array<quint64, kBelowMs.size() + 1>& counts() const { return counts_; }
  Duration longest() const { return longest_; }
  const Busy& duringLongest() const { return during_; }

 private:
  std::array<quint64, kBelowMs.size() + 1> counts_{};
  Duration longest_{};
  Busy during_;
};

/// Measures events. An event that is sent while another is handled is part of it. A dialog that waits inside
/// of an event (a nested event loop) is not: the outer event pauses while the inner loop runs.
class StallMeter {
 public:
  using Time = std::chrono::nanoseconds;  // of a monotonic clock
  /// `level`: how many event loops are nested. False: part of an event that is measured, or before the first
  /// loop, when there is no window yet that anybody could use; ends() is not called.
  bool begins(int level, Time now, const Busy& busy);
  void ends(Time now);
  /// The event loop waits, and goes on.
  void waits(Time now);
  void wakes(Time now);
  const Stalls& stalls() const { return stalls_; }

 private:
  struct Event {
    int level;
    Time since;
    Busy busy;
    bool paused = false;
  };
  void pause(Time now);
  std::vector<Event> events_;  // one for each event loop
  Stalls stalls_;
};

}  // namespace mapwright::ui
