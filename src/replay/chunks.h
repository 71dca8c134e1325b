// The time axis of a bag in ranges: which are read, which are held, which to ask for next. Pure; time is
// handed in. The answers themselves are held by whoever asks (replay::Reading).
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "map/failure.h"
#include "robot/bag_library.h"

namespace mapwright::replay {

/// Parts of 1/64 s since the epoch: ranges begin and end at whole ones, which a double, and six digits after
/// the point, hold exactly.
using Tick = std::int64_t;
constexpr double kTicksPerS = 64;
constexpr double secondsOf(Tick tick) { return double(tick) / kTicksPerS; }
/// The last one that is not beyond `s`; out of all bounds the outermost.
Tick tickOf(double s);

using Millis = std::int64_t;

enum class CellState {
  Unread,
  UnderWay,
  Read,    // what of it matters for later is known (PrefixIndex); its messages may be held or not
  Failed,  // a gap; will be asked for again
};

/// One range.
struct Cell {
  Tick from = 0, until = 0;
  CellState state = CellState::Unread;
  bool held = false;       // its messages are in memory
  bool under_way = false;  // asked for (again)
  bool beyond = false;     // lies before the start or after the end that the robot told
  std::size_t bytes = 0, messages = 0;
  int tries = 0;        // that failed, one after the other
  Millis retry_at = 0;  // not before
  map::Failure failure = {};
};

struct ChunksOptions {
  double messages_per_cell = 800;
  double ahead_s = 120, behind_s = 60;              // what is read ahead, and kept behind
  std::size_t ahead_bytes = std::size_t(24) << 20;  // of that at most; the next cell always
  std::size_t held_bytes = std::size_t(96) << 20;   // all that is held
  std::size_t comfortable_bytes = std::size_t(12)
                                  << 20;  // a longer answer makes the ranges still unread shorter
  int at_once = 2;
  Millis first_retry_ms = 500, last_retry_ms = 30'000;
  bool look_back = true;  // read what lies before the wanted time: its world is made of that
  bool whole = false;     // read what lies after the wanted time as well
};

class Chunks {
 public:
  /// The axis that `info` tells, and what lies before and after: whole seconds are told, clocks are set back,
  /// and a bag may go on after its end. A bag without messages and times has no ranges at all.
  explicit Chunks(const robot::BagInfo& info, ChunksOptions options = {});

  const std::map<Tick, Cell>& cells() const { return cells_; }  // by `from`; side by side, without overlaps
  const Cell* find(Tick from) const;
  /// Where `at_s` lies; outside of all the nearest. nullptr: there are none.
  const Cell* cellAt(double at_s) const;
  /// First and last second that the robot told.
  double start_s() const { return start_s_; }
  double end_s() const { return end_s_; }

  /// Where the world is wanted. The last wish wins.
  void want(double at_s) { wanted_s_ = at_s; }
  std::optional<double> wanted() const { return wanted_s_; }
  /// Ranges whose messages are needed besides (a picture that came long ago).
  void need(std::vector<Tick> cells) { needed_ = std::move(cells); }
  void setWhole(bool whole) { options_.whole = whole; }
  /// Ranges that have been read and are not held: once more each, when nothing else is to do.
  void readAgain(const std::vector<Tick>& cells) { again_.insert(cells.begin(), cells.end()); }

  /// The bag has grown: ranges are made where there were none, and those at its end that may hold more by now
  /// are read again, while what was read of them stays. Which these are, those that are made anew among them.
  std::vector<Tick> lengthen(const robot::BagInfo& info);
  /// What was read of it may not be all.
  bool isStale(Tick from) const { return stale_.contains(from); }

  /// Which to ask for now, the most wanted first; never more than may be under way.
  std::vector<Tick> next(Millis now) const;
  /// Which that are under way nobody wants any more, or stand in the way of the wanted time.
  std::vector<Tick> toCancel() const;
  /// Which of those held may go, so that what is held stays within its bounds.
  std::vector<Tick> toDrop() const;
  /// When next() will say more without anything happening; nullopt = never.
  std::optional<Millis> wakesAt(Millis now) const;

  void begun(Tick from);
  void cancelled(Tick from);
  void read(Tick from, std::size_t bytes, std::size_t messages);
  void dropped(Tick from);
  /// An answer that is too long makes two ranges of one. One beyond the told times that the robot refuses is
  /// taken for empty.
  void failed(Tick from, const map::Failure& failure, Millis now);
  /// Failed ranges are asked for again at once.
  void retryNow();

  /// All that lies at or before `at_s` is read.
  bool readUntil(double at_s) const;
  /// The first range at or before `at_s` that failed.
  const Cell* gapUntil(double at_s) const;
  bool wholeRead() const;
  std::size_t messagesRead() const;
  std::size_t heldBytes() const;

 private:
  void addCells(Tick from, Tick until, Tick length, bool beyond);
  void split(Tick from);
  void shorten(Tick longest);
  std::vector<Tick> wantedCells() const;
  Cell& at(Tick from) { return cells_.at(from); }

  ChunksOptions options_;
  std::map<Tick, Cell> cells_;
  double start_s_ = 0, end_s_ = 0;
  std::optional<double> wanted_s_;
  std::vector<Tick> needed_;
  std::set<Tick> again_;
  std::set<Tick> stale_;
};

}  // namespace mapwright::replay
