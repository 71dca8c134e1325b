// The time axis of a bag, divided into ranges: which are read, kept, or requested next. Pure; time is passed
// in. The caller (replay::Reading) holds the data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "map/failure.h"
#include "robot/bag_library.h"

namespace mapwright::replay {

/// Units of 1/64 s since the epoch: the limits of ranges, which a double, and six decimals, represent
/// exactly.
using Tick = std::int64_t;
constexpr double kTicksPerS = 64;
constexpr double secondsOf(Tick tick) { return double(tick) / kTicksPerS; }
/// The last one not after `s`; clamped.
Tick tickOf(double s);

/// Whether a message was recorded. The others were derived at a time without a message: they affect the world
/// but are not listed.
inline bool isRecorded(const robot::BagMessage& message) { return message.size > 0; }

/// A range of a bag for replay: the messages of an answer that are in the range, in playing order.
/// Order. Messages are played by their stamps; those with equal stamps in the order of the answer. Only this
/// order does not depend on the ranges in which a bag is read: robots are asked by stamps, so if a clock was
/// set back during recording, no answer tells the recorded order across two ranges. So the last message of a
/// topic at T is the one with the greatest stamp up to T. Messages whose stamp is not a number have no
/// position in time: they are left out and counted (robot::BagChunk::without_stamp). Immutable. Messages are
/// referred to by their index in source->messages.
struct Chunk {
  double from_s = 0, until_s = 0;  // from_s <= stamp < until_s
  robot::BagChunkPtr source;
  std::vector<std::uint32_t> order;        // the messages in the range, in playing order
  std::vector<std::uint32_t> back_filled;  // the messages from before the range, by stamp

  const robot::BagMessage& at(std::size_t index) const { return source->messages[order[index]]; }
  double stampAt(std::size_t index) const { return at(index).message.received_s; }
  /// How many of `order` have a stamp of at most `at_s`.
  std::size_t countUntil(double at_s) const;
  /// Approximate memory use.
  std::size_t bytes() const;
};
using ChunkPtr = std::shared_ptr<const Chunk>;

/// Each message of the answer that is in its range, once: those at its very end belong to the next range,
/// whether or not the robot includes them. A latched message at the start may appear twice, back-filled and
/// as itself (same topic, stamp, bytes), and counts once. All other repetitions stay.
Chunk inRange(robot::BagChunkPtr answer);

using Millis = std::int64_t;

enum class CellState {
  Unread,
  InProgress,
  Read,    // its effect on later times is known (PrefixIndex); its messages may be in memory or not
  Failed,  // a gap; will be requested again
};

/// One range.
struct Cell {
  Tick from = 0, until = 0;
  CellState state = CellState::Unread;
  bool held = false;         // its messages are in memory
  bool in_progress = false;  // asked for (again)
  bool beyond = false;       // before the start or after the end stated by the robot
  bool doubtful = false;     // part of a longer range that the robot refused
  bool lost = false;  // refused, and not to be divided further: a hole. Still requested again now and then
  std::size_t bytes = 0, messages = 0;
  int tries = 0;        // failed attempts in a row
  Millis retry_at = 0;  // not before
  map::Failure failure = {};
};

/// Another request would not help.
bool isFinal(const Cell& cell);

/// A part of a bag that the robot refused: nothing of it is known.
struct Hole {
  double from_s = 0, until_s = 0;  // from_s <= stamp < until_s
  map::Failure failure = {};       // of its first range
  bool operator==(const Hole&) const = default;
};
/// "Not all of it can be read: 2024-06-03 09:12:34.000 to 09:12:35.000 UTC is missing: …". At least one.
Fault faultOf(const std::vector<Hole>& holes);

struct ChunksOptions {
  double messages_per_cell = 800;
  double ahead_s = 120, behind_s = 60;                    // how much to read ahead, and to keep behind
  std::size_t ahead_bytes = std::size_t(24) << 20;        // its maximum; the next range is always read
  std::size_t held_bytes = std::size_t(96) << 20;         // the maximum in memory
  std::size_t comfortable_bytes = std::size_t(12) << 20;  // a longer answer makes the unread ranges shorter
  int at_once = 2;
  Millis first_retry_ms = 500, last_retry_ms = 30'000;
  bool look_back = true;  // read everything before the wanted time, which its state depends on
  bool whole = false;     // also read everything after the wanted time
};

class Chunks {
 public:
  /// The axis according to `info`, and what lies before and after: only whole seconds are stated, clocks are
  /// set back, and a bag may continue after its end. A bag without messages and times has no ranges at all.
  explicit Chunks(const robot::BagInfo& info, ChunksOptions options = {});

  const std::map<Tick, Cell>& cells() const { return cells_; }  // by `from`; adjacent, without overlaps
  const Cell* find(Tick from) const;
  /// The range of `at_s`; outside of all the nearest. nullptr: there are none.
  const Cell* cellAt(double at_s) const;
  /// First and last second as stated by the robot.
  double start_s() const { return start_s_; }
  double end_s() const { return end_s_; }

  /// The time whose state is wanted. The last call counts.
  void want(double at_s) { wanted_s_ = at_s; }
  std::optional<double> wanted() const { return wanted_s_; }
  /// Ranges whose messages are also needed (for example for an old picture).
  void need(std::vector<Tick> cells) { needed_ = std::move(cells); }
  void setWhole(bool whole) { options_.whole = whole; }
  /// Reads these ranges again if they are not in memory: once each, with the lowest priority.
  void readAgain(const std::vector<Tick>& cells) { again_.insert(cells.begin(), cells.end()); }

  /// The bag has grown: adds ranges, and reads those at its old end again in case they contain more now,
  /// keeping their present data. Returns them, including the new ones.
  std::vector<Tick> lengthen(const robot::BagInfo& info);
  /// It may have grown since it was read.
  bool isStale(Tick from) const { return stale_.contains(from); }

  /// Which ranges to request now, most urgent first; never more than allowed at once.
  std::vector<Tick> next(Millis now) const;
  /// Which requests to cancel: they are no longer needed, or delay the wanted time.
  std::vector<Tick> toCancel() const;
  /// Which ranges to drop from memory to stay within the limits.
  std::vector<Tick> toDrop() const;
  /// When next() will return something new without any other event; nullopt = never.
  std::optional<Millis> wakesAt(Millis now) const;

  void begun(Tick from);
  void cancelled(Tick from);
  void read(Tick from, std::size_t bytes, std::size_t messages);
  void dropped(Tick from);
  /// An answer that is too long splits the range into two. So does one that the robot refuses or that cannot
  /// be read, down to about a second, as long as the number of requests stays bounded: a bag that is damaged
  /// in one part is refused wherever that part is asked for. A range beyond the stated times that the robot
  /// refuses counts as empty.
  void failed(Tick from, const map::Failure& failure, Millis now);
  /// Requests failed ranges again at once.
  void retryNow();

  /// Everything up to `at_s` has been read.
  bool readUntil(double at_s) const;
  /// Everything up to `at_s` has been read or is lost: then more will not be known.
  bool settledUntil(double at_s) const;
  /// The first failed range up to `at_s`.
  const Cell* gapUntil(double at_s) const;
  /// The first failed range up to `at_s` that is not lost; if everything up to there is lost that has any
  /// messages, the first of these. It ends a reading once it is final.
  const Cell* obstacleUntil(double at_s) const;
  bool wholeRead() const;
  bool wholeSettled() const;
  /// What is lost of from_s <= t <= until_s, by time; adjacent ranges as one.
  std::vector<Hole> holes(double from_s, double until_s) const;
  bool anyFailed() const;
  std::size_t messagesRead() const;
  std::size_t heldBytes() const;

 private:
  void addCells(Tick from, Tick until, Tick length, bool beyond);
  void split(Tick from, bool doubtful);
  bool mayDivide(const Cell& cell) const;
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
  int divided_ = 0;  // refused ranges
};

}  // namespace mapwright::replay
