// The time that is looked at while a bag is played: a function of what was asked for and of a clock that is
// handed in. Pure. It knows no messages: what is there at its time, replay::Reading tells.
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

  /// Stands at the start. Seconds since the epoch.
  Player(double start_s, double end_s);

  double start_s() const { return start_s_; }
  double end_s() const { return end_s_; }
  /// The bag turned out to be longer than it told.
  void extend(double end_s);

  /// Where it is; never outside of the bag. It stops by itself at either end, unless it loops.
  double at(Millis now) const;
  /// It would go on if nothing were missing.
  bool playing(Millis now) const;
  void play(Millis now);
  void pause(Millis now);
  /// Of time: 1 is as recorded. Its size is brought within kSlowest..kFastest; below 0 it plays backwards.
  void setSpeed(double speed, Millis now);
  double speed() const { return speed_; }
  void seek(double at_s, Millis now);
  /// By so much; it stands still then.
  void step(double by_s, Millis now);
  /// While something is missing its clock stands still.
  void setWaiting(bool waiting, Millis now);
  bool waiting() const { return waiting_; }
  /// Plays this again and again; nullopt ends it. A range without length is none.
  void setLoop(std::optional<Loop> loop, Millis now);
  const std::optional<Loop>& loop() const { return loop_; }
  /// Plays until then and stands still there; nullopt = to the end.
  void playUntil(std::optional<double> until_s, Millis now);

 private:
  void settle(Millis now);  // from here on the present position is where it began
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
