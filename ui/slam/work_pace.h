// Which state of work that begins again and again is worth a word: what takes long, and an end that lasts. So
// nothing comes and goes every second while a robot moves. Value; time is passed in.
#pragma once

#include <chrono>
#include <optional>

namespace mapwright::ui {

class WorkPace {
 public:
  using Ms = std::chrono::milliseconds;
  static constexpr Ms kLong{2000}, kQuiet{2000};

  /// `busy`: it goes on; `current`: all that is known has been done. `now` never goes back.
  void update(Ms now, bool busy, bool current);
  /// Busy for kLong without an end.
  bool isLong() const { return busy_since_ && now_ - *busy_since_ >= kLong; }
  /// Current, and not only for a moment: since kQuiet, or for the first time.
  bool isSettled() const { return current_since_ && (first_ || now_ - *current_since_ >= kQuiet); }
  /// When one of these changes if nothing happens; nullopt = never.
  std::optional<Ms> changesIn() const;

 private:
  Ms now_{0};
  std::optional<Ms> busy_since_, current_since_;
  bool first_ = true;
};

}  // namespace mapwright::ui
