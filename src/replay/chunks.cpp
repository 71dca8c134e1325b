#include "replay/chunks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <QDateTime>

#include "map/failure.h"
#include "replay/faults.h"
#include "words/qt_versions.h"

namespace mapwright::replay {
namespace {

constexpr double kFirstS = 0, kLastS = 9'223'372'036;  // what a recording can hold: until the year 2262
constexpr Tick kLongest = Tick(256 * kTicksPerS);
constexpr Tick kMostCells = 4096;
/// Data placed by later messages, or late data, may change the last seconds.
constexpr double kUnsettledS = 2;
constexpr int kBelievedTries = 3, kBelievedTriesOfDoubtful = 2;
/// A spot in a range of 256 s is found with eight divisions. Of a bag of which nothing can be read few are
/// tried.
constexpr Tick kShortestDoubt = Tick(kTicksPerS);
constexpr int kMostDivided = 1024, kMostDividedOfNothing = 64;

/// The longest power of two that is no longer; at least one.
Tick powerOfTwo(double ticks) {
  Tick length = 1;
  while (double(length) * 2 <= ticks) length *= 2;
  return length;
}

bool isTooLong(const map::Failure& failure) {
  return failure.kind == map::FailureKind::MalformedAnswer && failure.cause.code == fault::AnswerTooLong;
}

/// About this range, and not about the whole bag, the robot or the way to it.
bool isOfRange(const map::Failure& failure) {
  if (failure.kind == map::FailureKind::MalformedAnswer) return true;
  const bool other =
      failure.robot_code == "404" || failure.robot_code == "429" || failure.robot_code == "503";
  return failure.kind == map::FailureKind::RejectedByRobot && !other;
}

}  // namespace

namespace {

std::vector<Fault> failureReason(const map::Failure& failure) {
  std::vector<Fault> why;
  if (failure.cause.any()) {
    why.push_back(failure.cause);
  } else if (!failure.detail.empty()) {
    why.push_back(fault::said(failure.detail));
  }
  int status = 0;
  const std::string& code = failure.robot_code;
  std::from_chars(code.data(), code.data() + code.size(), status);
  if (code.size() != 3 || status < 100) return why;
  return {Fault(fault::RobotAnswered, {HttpStatus{status}}, std::move(why))};
}

}  // namespace

Fault faultOf(const std::vector<Hole>& holes) {
  constexpr std::size_t kMostNamed = 10;
  const auto clock = [](double at_s, const char* format) {
    return words::utcOfMs(qint64(std::floor(at_s * 1000))).toString(QLatin1String(format)).toStdString();
  };
  Fault all = FaultCode{"replay", QT_TRANSLATE_NOOP("replay", "Not all of it can be read"),
                        FaultCode::Causes::Continued};
  for (std::size_t i = 0; i < std::min(holes.size(), kMostNamed); ++i) {
    const Hole& hole = holes[i];
    Fault part{
        FaultCode{"replay", QT_TRANSLATE_NOOP("replay", "%1 to %2 is missing"), FaultCode::Causes::Continued},
        {clock(hole.from_s, "yyyy-MM-dd HH:mm:ss.zzz"), clock(hole.until_s, "HH:mm:ss.zzz 'UTC'")}};
    // The robot's words are the same for all, mostly.
    if (i == 0 || !(hole.failure == holes[i - 1].failure)) part.because = failureReason(hole.failure);
    all.because.push_back(std::move(part));
  }
  if (holes.size() > kMostNamed)
    all.because.push_back(
        {faultText("replay", "and more parts: %1"), {std::int64_t(holes.size() - kMostNamed)}});
  return all;
}

bool isFinal(const Cell& cell) {
  const bool rejected = cell.failure.kind == map::FailureKind::RejectedByRobot && !map::mayPass(cell.failure);
  return cell.lost || cell.tries >= kBelievedTries || rejected ||
         cell.failure.kind == map::FailureKind::Refused || cell.failure.kind == map::FailureKind::Certificate;
}

std::size_t Chunk::countUntil(double at_s) const {
  const auto end = std::partition_point(order.begin(), order.end(), [&](std::uint32_t index) {
    return source->messages[index].message.received_s <= at_s;
  });
  return std::size_t(end - order.begin());
}

std::size_t Chunk::bytes() const {
  if (!source) return 0;
  // Texts, what was made of them (pictures and clouds shrink), and the values themselves.
  const std::size_t text = source->text ? source->text->size() : 0;
  return text + std::max(text / 2, source->value_bytes) + source->messages.size() * sizeof(robot::BagMessage);
}

Chunk inRange(robot::BagChunkPtr answer) {
  Chunk chunk;
  chunk.from_s = answer->from_s;
  chunk.until_s = answer->until_s;
  std::map<std::pair<std::string_view, std::string_view>, int> at_beginning;  // topic and bytes
  for (std::uint32_t i = 0; i < answer->messages.size(); ++i) {
    const robot::BagMessage& message = answer->messages[i];
    const double stamp_s = message.message.received_s;
    if (stamp_s < chunk.from_s) {
      chunk.back_filled.push_back(i);
    } else if (stamp_s < chunk.until_s) {
      const bool may_be_told_twice = message.latched && stamp_s == chunk.from_s;
      if (may_be_told_twice && ++at_beginning[{message.message.topic, answer->textOf(message)}] == 2)
        continue;
      chunk.order.push_back(i);
    }
  }
  chunk.source = std::move(answer);
  const auto earlier = [&](std::uint32_t a, std::uint32_t b) {
    return chunk.source->messages[a].message.received_s < chunk.source->messages[b].message.received_s;
  };
  std::stable_sort(chunk.order.begin(), chunk.order.end(), earlier);
  std::stable_sort(chunk.back_filled.begin(), chunk.back_filled.end(), earlier);
  return chunk;
}

Tick tickOf(double s) {
  return Tick(std::floor(std::clamp(std::isnan(s) ? kFirstS : s, -kLastS, 2 * kLastS) * kTicksPerS));
}

Chunks::Chunks(const robot::BagInfo& info, ChunksOptions options) : options_(options) {
  // If the clock was set back, the last message may have an earlier stamp than the first.
  start_s_ = std::clamp(std::floor(std::min(info.start_s, info.end_s)), kFirstS, kLastS);
  end_s_ = std::clamp(std::max(info.start_s, info.end_s), kFirstS, kLastS);
  if (info.messages.value_or(0) == 0 && start_s_ == end_s_) return;
  const Tick from = tickOf(start_s_), until = std::min(tickOf(std::floor(end_s_) + 1), tickOf(kLastS) + 1);
  const double rate = double(std::max<std::int64_t>(info.messages.value_or(1), 1)) / secondsOf(until - from);
  Tick length =
      std::clamp(powerOfTwo(options_.messages_per_cell / rate * kTicksPerS), Tick(kTicksPerS), kLongest);
  while ((until - from) / length > kMostCells) length *= 2;
  if (from > tickOf(kFirstS)) addCells(tickOf(kFirstS), from, from - tickOf(kFirstS), true);
  addCells(from, until, length, false);
  if (until < tickOf(kLastS)) addCells(until, tickOf(kLastS), tickOf(kLastS) - until, true);
}

std::vector<Tick> Chunks::lengthen(const robot::BagInfo& info) {
  if (cells_.empty()) {
    const auto wanted_s = wanted_s_;
    *this = Chunks(info, options_);
    wanted_s_ = wanted_s;
    return {};
  }
  const double settled_s = end_s_ - kUnsettledS;
  end_s_ = std::max(end_s_, std::clamp(std::max(info.start_s, info.end_s), kFirstS, kLastS));
  const auto beyond = std::prev(cells_.end());
  const Tick until = std::min(tickOf(std::floor(end_s_) + 1), tickOf(kLastS) + 1);
  if (beyond->second.beyond && beyond->first < until && beyond != cells_.begin()) {
    const Tick from = beyond->first, last = beyond->second.until;
    const Cell& before = std::prev(beyond)->second;
    Tick length = std::max<Tick>(before.until - before.from, Tick(kTicksPerS));
    while ((until - from) / length > kMostCells) length *= 2;
    cells_.erase(beyond);
    addCells(from, until, length, false);
    if (until < last) addCells(until, last, last - until, true);
  }
  for (const auto& [from, cell] : cells_) {
    const bool begun = cell.state == CellState::Read || cell.in_progress;
    if (begun && secondsOf(cell.until) > settled_s) stale_.insert(from);
  }
  std::vector<Tick> changed(stale_.begin(), stale_.end());
  for (auto made = cells_.lower_bound(tickOf(settled_s)); made != cells_.end(); ++made) {
    if (!stale_.contains(made->first)) changed.push_back(made->first);
  }
  return changed;
}

void Chunks::addCells(Tick from, Tick until, Tick length, bool beyond) {
  for (; from < until; from += length) {
    Cell cell;
    cell.from = from;
    cell.until = std::min(from + length, until);
    cell.beyond = beyond;
    cells_.emplace(from, cell);
  }
}

const Cell* Chunks::find(Tick from) const {
  const auto found = cells_.find(from);
  return found == cells_.end() ? nullptr : &found->second;
}

const Cell* Chunks::cellAt(double at_s) const {
  if (cells_.empty()) return nullptr;
  auto after = cells_.upper_bound(tickOf(at_s));
  return after == cells_.begin() ? &after->second : &std::prev(after)->second;
}

std::vector<Tick> Chunks::wantedCells() const {
  std::vector<Tick> wanted;
  const Cell* here = wanted_s_ ? cellAt(*wanted_s_) : nullptr;
  if (!here) return wanted;
  std::set<Tick> named;
  const auto add = [&](const Cell& cell, bool messages) {
    if (messages ? cell.held : cell.state == CellState::Read) return;
    if (named.insert(cell.from).second) wanted.push_back(cell.from);
  };
  add(*here, true);
  for (const Tick needed : needed_) {
    if (const Cell* cell = find(needed)) add(*cell, true);
  }
  const auto at = cells_.find(here->from);
  const auto next = std::next(at);
  const auto ahead = [&](const Cell& cell) { return !cell.beyond || cell.state != CellState::Read; };
  for (const Tick stale : stale_) {
    if (cells_.contains(stale) && named.insert(stale).second) wanted.push_back(stale);
  }
  // The next one comes before everything behind: playback must not stop.
  if (next != cells_.end() && ahead(next->second)) add(next->second, true);
  if (options_.look_back) {
    for (auto before = std::make_reverse_iterator(at); before != cells_.rend(); ++before)
      add(before->second, false);
  }
  std::size_t bytes = 0;
  for (auto later = next; later != cells_.end(); ++later) {
    if (secondsOf(later->first) > *wanted_s_ + options_.ahead_s || bytes > options_.ahead_bytes) break;
    bytes += later->second.held ? later->second.bytes : here->bytes;
    if (ahead(later->second)) add(later->second, true);
  }
  if (options_.whole) {
    for (auto later = next; later != cells_.end(); ++later) add(later->second, false);
  }
  for (const Tick again : again_) {
    if (const Cell* cell = find(again)) add(*cell, true);
  }
  return wanted;
}

std::vector<Tick> Chunks::next(Millis now) const {
  int free = options_.at_once;
  for (const auto& [from, cell] : cells_) free -= cell.in_progress;
  std::vector<Tick> ask;
  for (const Tick from : wantedCells()) {
    if (int(ask.size()) >= free) break;
    const Cell& cell = cells_.at(from);
    if (!cell.in_progress && cell.retry_at <= now) ask.push_back(from);
  }
  return ask;
}

std::vector<Tick> Chunks::toCancel() const {
  const std::vector<Tick> wanted = wantedCells();
  std::vector<Tick> cancel, in_progress;
  for (const auto& [from, cell] : cells_) {
    if (!cell.in_progress) continue;
    in_progress.push_back(from);
    if (std::find(wanted.begin(), wanted.end(), from) == wanted.end()) cancel.push_back(from);
  }
  // The most wanted range is requested in any case.
  const bool waits = !wanted.empty() && !cells_.at(wanted.front()).in_progress &&
                     cells_.at(wanted.front()).tries == 0 && cancel.empty() &&
                     int(in_progress.size()) >= options_.at_once;
  if (waits) {
    const auto rank = [&](Tick from) { return std::find(wanted.begin(), wanted.end(), from); };
    cancel.push_back(*std::max_element(in_progress.begin(), in_progress.end(),
                                       [&](Tick a, Tick b) { return rank(a) < rank(b); }));
  }
  return cancel;
}

std::vector<Tick> Chunks::toDrop() const {
  const Cell* here = wanted_s_ ? cellAt(*wanted_s_) : nullptr;
  std::vector<std::pair<double, const Cell*>> held;  // how far away
  for (const auto& [from, cell] : cells_) {
    if (!cell.held || (here && cell.from == here->from)) continue;
    if (std::find(needed_.begin(), needed_.end(), from) != needed_.end()) continue;
    double away_s = 1e300;
    if (wanted_s_) {
      const bool later = secondsOf(from) > *wanted_s_;
      away_s = later ? secondsOf(from) - *wanted_s_ : *wanted_s_ - secondsOf(cell.until);
      const bool next = here && cell.from == here->until;
      // Only ranges in the window, or the next one, are worth their memory; the next one is dropped last.
      if (next) {
        away_s = 0;
      } else if (away_s > (later ? options_.ahead_s : options_.behind_s)) {
        away_s = 1e300;
      }
    }
    held.emplace_back(away_s, &cell);
  }
  std::sort(held.begin(), held.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::size_t bytes = heldBytes();
  std::vector<Tick> drop;
  for (const auto& [away_s, cell] : held) {
    if (away_s < 1e300 && bytes <= options_.held_bytes) break;
    bytes -= cell->bytes;
    drop.push_back(cell->from);
  }
  return drop;
}

std::optional<Millis> Chunks::wakesAt(Millis now) const {
  std::optional<Millis> at;
  for (const Tick from : wantedCells()) {
    const Cell& cell = cells_.at(from);
    if (!cell.in_progress && cell.retry_at > now) at = std::min(at.value_or(cell.retry_at), cell.retry_at);
  }
  return at;
}

void Chunks::begun(Tick from) {
  Cell& cell = at(from);
  cell.in_progress = true;
  if (cell.state == CellState::Unread || cell.state == CellState::Failed) cell.state = CellState::InProgress;
}

void Chunks::cancelled(Tick from) {
  Cell& cell = at(from);
  cell.in_progress = false;
  if (cell.state == CellState::InProgress)
    cell.state = cell.tries > 0 ? CellState::Failed : CellState::Unread;
}

void Chunks::read(Tick from, std::size_t bytes, std::size_t messages) {
  Cell& cell = at(from);
  cell.in_progress = false;
  cell.state = CellState::Read;
  cell.held = true;
  cell.bytes = bytes;
  cell.messages = messages;
  cell.tries = 0;
  cell.retry_at = 0;
  cell.lost = cell.doubtful = false;
  cell.failure = {};
  again_.erase(from);
  stale_.erase(from);
  const Tick length = cell.until - cell.from;
  if (bytes > options_.comfortable_bytes && length > 1) shorten(std::max<Tick>(length / 2, 1));
}

void Chunks::dropped(Tick from) { at(from).held = false; }

void Chunks::failed(Tick from, const map::Failure& failure, Millis now) {
  Cell& cell = at(from);
  cell.in_progress = false;
  if (isTooLong(failure) && cell.until - cell.from > 1) {
    split(from, cell.doubtful);
    return;
  }
  // Some robots refuse times outside of the bag: then there is nothing. One that may only be busy has to
  // refuse repeatedly.
  const bool rejected = failure.kind == map::FailureKind::RejectedByRobot;
  const bool for_good = rejected && !map::mayPass(failure);
  const bool believed = for_good || cell.tries + 1 >= kBelievedTries;
  if (cell.beyond && rejected && believed) {
    read(from, 0, 0);
    return;
  }
  if (isOfRange(failure) && !cell.beyond && cell.state != CellState::Read) {
    if ((believed || cell.doubtful) && mayDivide(cell)) {
      ++divided_;
      split(from, true);
      return;
    }
    cell.lost = believed || (cell.doubtful && cell.tries + 1 >= kBelievedTriesOfDoubtful);
  }
  if (cell.state != CellState::Read) cell.state = CellState::Failed;
  const int doublings = std::min(cell.tries++, 10);
  cell.retry_at = now + std::min(options_.first_retry_ms << doublings, options_.last_retry_ms);
  cell.failure = failure;
}

void Chunks::retryNow() {
  for (auto& [from, cell] : cells_) cell.retry_at = 0;
}

void Chunks::split(Tick from, bool doubtful) {
  const Cell whole = at(from);
  cells_.erase(from);
  const Tick half = powerOfTwo(double(whole.until - whole.from - 1));
  addCells(whole.from, whole.until, half, whole.beyond);
  for (auto part = cells_.find(from); part != cells_.end() && part->first < whole.until; ++part)
    part->second.doubtful = doubtful;
}

bool Chunks::mayDivide(const Cell& cell) const {
  return cell.until - cell.from > kShortestDoubt &&
         divided_ < (messagesRead() > 0 ? kMostDivided : kMostDividedOfNothing);
}

void Chunks::shorten(Tick longest) {
  std::vector<Tick> longer;
  for (const auto& [from, cell] : cells_) {
    const bool untouched = cell.state == CellState::Unread && !cell.in_progress && !cell.beyond;
    if (untouched && cell.until - cell.from > longest) longer.push_back(from);
  }
  for (const Tick from : longer) {
    const Cell whole = at(from);
    cells_.erase(from);
    addCells(whole.from, whole.until, longest, false);
  }
}

bool Chunks::readUntil(double at_s) const {
  const Tick last = tickOf(at_s);
  return std::all_of(cells_.begin(), cells_.upper_bound(last),
                     [](const auto& entry) { return entry.second.state == CellState::Read; });
}

bool Chunks::settledUntil(double at_s) const {
  return std::all_of(cells_.begin(), cells_.upper_bound(tickOf(at_s)), [](const auto& entry) {
    return entry.second.state == CellState::Read || entry.second.lost;
  });
}

const Cell* Chunks::obstacleUntil(double at_s) const {
  const Cell* lost = nullptr;
  bool nothing = true;
  for (auto it = cells_.begin(); it != cells_.upper_bound(tickOf(at_s)); ++it) {
    const Cell& cell = it->second;
    if (cell.lost && !lost) lost = &cell;
    if (cell.state == CellState::Read || cell.lost) {
      nothing &= cell.messages == 0;
    } else if (cell.tries > 0) {
      return &cell;
    } else {
      nothing = false;  // it may have some
    }
  }
  return nothing ? lost : nullptr;
}

bool Chunks::wholeSettled() const { return settledUntil(kLastS); }

std::vector<Hole> Chunks::holes(double from_s, double until_s) const {
  std::vector<Hole> holes;
  for (const auto& [from, cell] : cells_) {
    if (!cell.lost || secondsOf(cell.from) > until_s || secondsOf(cell.until) <= from_s) continue;
    if (!holes.empty() && holes.back().until_s == secondsOf(cell.from))
      holes.back().until_s = secondsOf(cell.until);
    else
      holes.push_back({secondsOf(cell.from), secondsOf(cell.until), cell.failure});
  }
  return holes;
}

const Cell* Chunks::gapUntil(double at_s) const {
  for (auto it = cells_.begin(); it != cells_.upper_bound(tickOf(at_s)); ++it) {
    if (it->second.state != CellState::Read && it->second.tries > 0) return &it->second;
  }
  return nullptr;
}

bool Chunks::wholeRead() const {
  return std::all_of(cells_.begin(), cells_.end(),
                     [](const auto& entry) { return entry.second.state == CellState::Read; });
}

bool Chunks::anyFailed() const {
  return std::any_of(cells_.begin(), cells_.end(),
                     [](const auto& entry) { return entry.second.state == CellState::Failed; });
}

std::size_t Chunks::messagesRead() const {
  std::size_t count = 0;
  for (const auto& [from, cell] : cells_) count += cell.messages;
  return count;
}

std::size_t Chunks::heldBytes() const {
  std::size_t bytes = 0;
  for (const auto& [from, cell] : cells_) bytes += cell.held ? cell.bytes : 0;
  return bytes;
}

}  // namespace mapwright::replay
