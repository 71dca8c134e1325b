// The displayed time during playback: a function of the controls and of a clock that is passed in. Pure. It
// knows nothing about messages: replay::Reading has the data.
#pragma once

#include <cstdint>
#include <optional>

#include "replay/chunks.h"

namespace mapwright::replay {

class Player {
 public:
  static constexpr double kSlowest = 0.1, kFastest = 20;
  struct Loop {
    double from_s = 0, until_s = 0;
    bool operator==(const Loop&) const = default;
  };

  /// Paused at the start. Seconds since the epoch.
  Player(double start_s, double end_s);

  double start_s() const { return start_s_; }
  double end_s() const { return end_s_; }
  /// The bag is longer than stated.
  void extend(double end_s);

  /// The current time; always inside the bag. It stops at either end, unless it loops.
  double at(Millis now) const;
  /// It would continue if nothing were missing.
  bool playing(Millis now) const;
  void play(Millis now);
  void pause(Millis now);
  /// 1 is real time. The magnitude is clamped to kSlowest..kFastest; negative plays backwards.
  void setSpeed(double speed, Millis now);
  double speed() const { return speed_; }
  void seek(double at_s, Millis now);
  /// Moves by this much and pauses.
  void step(double by_s, Millis now);
  /// While data is missing its clock stands still.
  void setWaiting(bool waiting, Millis now);
  bool waiting() const { return waiting_; }
  /// Plays this range repeatedly; nullopt ends it. An empty range does nothing.
  void setLoop(std::optional<Loop> loop, Millis now);
  const std::optional<Loop>& loop() const { return loop_; }
  /// Plays until then and pauses; nullopt = to the end.
  void playUntil(std::optional<double> until_s, Millis now);

 private:
  void settle(Millis now);  // continues from the present position
  double unbounded(Millis now) const;
  double last() const;

  double start_s_, end_s_;
  double from_s_;  // where it was at since_
  Millis since_ = 0;
  double speed_ = 1;
  bool playing_ = false, waiting_ = false;
  std::optional<Loop> loop_;
  std::optional<double> until_s_;
};

}  // namespace mapwright::replay
