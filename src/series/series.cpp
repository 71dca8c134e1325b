#include "series/series.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mapwright::series {
namespace {

void sumUpBlock(Block& block) {
  block.parts.clear();
  block.whole = {};
  for (std::size_t from = 0; from < block.at.size(); from += Blocks::kPart) {
    Summary part;
    const std::size_t until = std::min(from + Blocks::kPart, block.at.size());
    for (std::size_t i = from; i < until; ++i) part.add(block.at[i], block.value[i]);
    block.parts.push_back(part);
    block.whole.add(part);
  }
}

void addSamples(Summary& sum, const Block& block, std::size_t from, std::size_t until) {
  while (from < until) {
    if (from % Blocks::kPart == 0 && from + Blocks::kPart <= until) {
      sum.add(block.parts[from / Blocks::kPart]);
      from += Blocks::kPart;
    } else {
      sum.add(block.at[from], block.value[from]);
      ++from;
    }
  }
}

bool isEarlier(const Sample& a, const Sample& b) { return a.at_s < b.at_s; }

/// The least and the greatest of a run, and that something in it is no number, in the order of time: at most
/// three.
void addThinned(std::vector<Sample>& kept, std::span<const Sample> run) {
  const Sample *least = nullptr, *greatest = nullptr, *broken = nullptr;
  for (const Sample& each : run) {
    if (!std::isfinite(each.value)) {
      broken = &each;
      continue;
    }
    if (!least || each.value < least->value) least = &each;
    if (!greatest || each.value > greatest->value) greatest = &each;
  }
  std::vector<const Sample*> chosen;
  for (const Sample* each : {least, greatest, broken}) {
    if (each && std::find(chosen.begin(), chosen.end(), each) == chosen.end()) chosen.push_back(each);
  }
  std::sort(chosen.begin(), chosen.end());  // by their index in the run
  for (const Sample* each : chosen) kept.push_back(*each);
}

constexpr std::size_t kFew = 4;  // samples in a column that are drawn as they are

/// Joins points to lines that break where they must.
class Pen {
 public:
  explicit Pen(const std::map<double, double>& covered) : covered_(covered) {}

  void add(double at_s, double value) {
    if (broken_ || at_s > covered_until_s_) {
      strokes_.emplace_back();
      broken_ = false;
    }
    if (at_s > covered_until_s_) {
      const auto after = covered_.upper_bound(at_s);
      covered_until_s_ = after == covered_.begin() ? at_s : std::max(std::prev(after)->second, at_s);
    }
    strokes_.back().push_back({at_s, value});
  }
  void lift() { broken_ = true; }
  std::vector<Stroke> taken() { return std::move(strokes_); }

 private:
  const std::map<double, double>& covered_;
  std::vector<Stroke> strokes_;
  double covered_until_s_ = -std::numeric_limits<double>::infinity();
  bool broken_ = true;
};

void addSample(Pen& pen, const Sample& sample) {
  if (std::isfinite(sample.value)) {
    pen.add(sample.at_s, sample.value);
  } else {
    pen.lift();
  }
}

void addColumn(Pen& pen, const Summary& sum) {
  if (sum.numbers == 0 || sum.broken_before) pen.lift();
  if (sum.numbers == 0) return;
  pen.add(sum.first.at_s, sum.first.value);
  if (sum.numbers > 1) {
    const double middle_s = sum.first.at_s + (sum.last.at_s - sum.first.at_s) / 2;
    if (sum.least < std::min(sum.first.value, sum.last.value)) pen.add(middle_s, sum.least);
    if (sum.greatest > std::max(sum.first.value, sum.last.value)) pen.add(middle_s, sum.greatest);
    pen.add(sum.last.at_s, sum.last.value);
  }
  if (sum.broken_after) pen.lift();
}

struct Position {
  double at_s = 0, x_m = 0, y_m = 0;
};

/// Where both are known. They differ in their times only where samples gave way.
std::vector<Position> positions(const Series& x, const Series& y, double from_s, double until_s) {
  const std::vector<Sample> xs = x.samples(from_s, until_s), ys = y.samples(from_s, until_s);
  std::vector<Position> both;
  for (std::size_t i = 0, j = 0; i < xs.size() && j < ys.size();) {
    if (xs[i].at_s < ys[j].at_s) {
      ++i;
    } else if (ys[j].at_s < xs[i].at_s) {
      ++j;
    } else {
      both.push_back({xs[i].at_s, xs[i].value, ys[j].value});
      ++i, ++j;
    }
  }
  return both;
}

double distance(const Position& a, const Position& b) { return std::hypot(b.x_m - a.x_m, b.y_m - a.y_m); }

}  // namespace

void Summary::add(const Summary& later) {
  if (later.count == 0) return;
  if (later.numbers > 0) {
    if (numbers == 0) {
      first = later.first;
      broken_before = count > 0 || later.broken_before;
    }
    last = later.last;
    broken_after = later.broken_after;
    least = std::min(least, later.least);
    greatest = std::max(greatest, later.greatest);
  } else {
    // Only breaks: they break the line on both sides.
    broken_after = true;
    if (numbers == 0) broken_before = true;
  }
  count += later.count;
  numbers += later.numbers;
}

void Summary::add(double at_s, double value) {
  if (std::isfinite(value)) {
    if (numbers++ == 0) {
      first = {at_s, value};
      broken_before = count > 0;
    }
    last = {at_s, value};
    broken_after = false;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  } else {
    broken_after = true;
    if (numbers == 0) broken_before = true;
  }
  ++count;
}

template <typename Before>
SamplePosition Blocks::bound(Before before) const {
  // The first block whose last sample is not earlier.
  const auto block = std::partition_point(blocks_.begin(), blocks_.end(),
                                          [&](const Block& each) { return before(each.at.back()); });
  if (block == blocks_.end()) return end();
  const auto index = std::partition_point(block->at.begin(), block->at.end(), before);
  return {std::size_t(block - blocks_.begin()), std::size_t(index - block->at.begin())};
}

SamplePosition Blocks::lowerBound(double at_s) const {
  return bound([at_s](double each) { return each < at_s; });
}
SamplePosition Blocks::upperBound(double at_s) const {
  return bound([at_s](double each) { return each <= at_s; });
}

SamplePosition Blocks::next(SamplePosition position) const {
  if (++position.index < blocks_[position.block].at.size()) return position;
  return {position.block + 1, 0};
}

SamplePosition Blocks::previous(SamplePosition position) const {
  if (position.index > 0) return {position.block, position.index - 1};
  return {position.block - 1, blocks_[position.block - 1].at.size() - 1};
}

Summary Blocks::sum(SamplePosition from, SamplePosition until) const {
  Summary sum;
  if (!(from < until)) return sum;
  if (from.block == until.block) {
    addSamples(sum, blocks_[from.block], from.index, until.index);
    return sum;
  }
  std::size_t block = from.block;
  if (from.index > 0) {
    addSamples(sum, blocks_[block], from.index, blocks_[block].at.size());
    ++block;
  }
  for (; block < until.block; ++block) sum.add(blocks_[block].whole);
  if (until.index > 0) addSamples(sum, blocks_[until.block], 0, until.index);
  return sum;
}

void Blocks::append(double at_s, double value) {
  if (blocks_.empty() || blocks_.back().at.size() >= kBlock) blocks_.emplace_back();
  Block& block = blocks_.back();
  if (block.at.size() % kPart == 0) block.parts.emplace_back();
  block.at.push_back(at_s);
  block.value.push_back(value);
  block.parts.back().add(at_s, value);
  block.whole.add(at_s, value);
  ++size_;
}

void Blocks::replace(SamplePosition from, SamplePosition until, std::span<const Sample> samples) {
  if (from == until && samples.empty()) return;
  // What remains of the blocks at either end, and small neighbours, make new blocks together with `samples`.
  std::size_t first = from.block, last = until.index > 0 ? until.block + 1 : until.block;
  const std::size_t head = from.index;
  std::vector<double> at, value;
  std::size_t before = 0;  // samples of a small block before
  if (first > 0 && head == 0 && blocks_[first - 1].at.size() + samples.size() <= kBlock) {
    --first;
    before = blocks_[first].at.size();
  }
  const auto appendRange = [&](const Block& block, std::size_t begin, std::size_t end) {
    at.insert(at.end(), block.at.begin() + std::ptrdiff_t(begin), block.at.begin() + std::ptrdiff_t(end));
    value.insert(value.end(), block.value.begin() + std::ptrdiff_t(begin),
                 block.value.begin() + std::ptrdiff_t(end));
  };
  if (before > 0) appendRange(blocks_[first], 0, before);
  if (head > 0) appendRange(blocks_[from.block], 0, head);
  for (const Sample& sample : samples) {
    at.push_back(sample.at_s);
    value.push_back(sample.value);
  }
  if (until.index > 0) appendRange(blocks_[until.block], until.index, blocks_[until.block].at.size());
  if (last < blocks_.size() && at.size() + blocks_[last].at.size() <= kBlock) {
    appendRange(blocks_[last], 0, blocks_[last].at.size());
    ++last;
  }
  std::size_t gone = 0;
  for (std::size_t i = first; i < last; ++i) gone += blocks_[i].at.size();
  size_ = size_ - gone + at.size();
  const std::size_t pieces = (at.size() + kBlock - 1) / kBlock;
  std::vector<Block> made(pieces);
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    const auto begin = std::ptrdiff_t(at.size() * piece / pieces),
               end = std::ptrdiff_t(at.size() * (piece + 1) / pieces);
    made[piece].at.assign(at.begin() + begin, at.begin() + end);
    made[piece].value.assign(value.begin() + begin, value.begin() + end);
    sumUpBlock(made[piece]);
  }
  const auto common = std::ptrdiff_t(std::min(pieces, last - first));
  const auto there = blocks_.begin() + std::ptrdiff_t(first);
  std::move(made.begin(), made.begin() + common, there);
  if (std::ptrdiff_t(pieces) > common) {
    blocks_.insert(there + common, std::make_move_iterator(made.begin() + common),
                   std::make_move_iterator(made.end()));
  } else {
    blocks_.erase(there + common, blocks_.begin() + std::ptrdiff_t(last));
  }
}

void Blocks::clear() {
  blocks_.clear();
  size_ = 0;
}

std::size_t Blocks::bytes() const {
  std::size_t bytes = 0;
  for (const Block& block : blocks_) {
    bytes += sizeof(Block) + (block.at.capacity() + block.value.capacity()) * sizeof(double) +
             block.parts.capacity() * sizeof(Summary);
  }
  return bytes;
}

void Series::insert(double from_s, double until_s, std::span<const Sample> samples) {
  if (!(from_s < until_s) || !std::isfinite(from_s) || !std::isfinite(until_s)) return;
  std::vector<Sample> own;
  own.reserve(samples.size());
  for (const Sample& each : samples) {
    if (each.at_s >= from_s && each.at_s < until_s) own.push_back(each);
  }
  if (!std::is_sorted(own.begin(), own.end(), isEarlier)) std::stable_sort(own.begin(), own.end(), isEarlier);
  blocks_.replace(blocks_.lowerBound(from_s), blocks_.lowerBound(until_s), own);
  cover(from_s, until_s);
  thin();
}

void Series::append(double at_s, double value) {
  if (!std::isfinite(at_s)) return;
  if (empty() || at_s >= lastAt()) {
    blocks_.append(at_s, value);
  } else {
    const Sample sample{at_s, value};
    const SamplePosition position = blocks_.upperBound(at_s);
    blocks_.replace(position, position, {&sample, 1});
  }
  thin();
}

void Series::cover(double from_s, double until_s) {
  if (!(from_s < until_s)) return;
  auto it = covered_.upper_bound(from_s);
  if (it != covered_.begin() && std::prev(it)->second >= from_s) {
    --it;
    from_s = it->first;
  }
  while (it != covered_.end() && it->first <= until_s) {
    until_s = std::max(until_s, it->second);
    it = covered_.erase(it);
  }
  covered_.emplace_hint(it, from_s, until_s);
}

void Series::forgetBefore(double at_s) {
  blocks_.replace(blocks_.begin(), blocks_.lowerBound(at_s), {});
  while (!covered_.empty() && covered_.begin()->first < at_s) {
    const double until_s = covered_.begin()->second;
    covered_.erase(covered_.begin());
    if (until_s > at_s) covered_.emplace(at_s, until_s);
  }
}

void Series::clear() {
  blocks_.clear();
  covered_.clear();
  thinned_ = false;
}

std::size_t Series::bytes() const { return blocks_.bytes() + covered_.size() * 48; }

bool Series::isCovered(double from_s, double until_s) const {
  const auto after = covered_.upper_bound(from_s);
  return after != covered_.begin() && std::prev(after)->second >= until_s;
}

std::optional<Sample> Series::at(double at_s) const {
  const SamplePosition after = blocks_.upperBound(at_s);
  if (after == blocks_.begin()) return std::nullopt;
  const Sample sample = blocks_.at(blocks_.previous(after));
  if (!std::isfinite(sample.value) || !isCovered(sample.at_s, at_s)) return std::nullopt;
  return sample;
}

std::vector<Sample> Series::samples(double from_s, double until_s) const {
  std::vector<Sample> found;
  const SamplePosition end = blocks_.lowerBound(until_s);
  for (SamplePosition position = blocks_.lowerBound(from_s); position < end;
       position = blocks_.next(position))
    found.push_back(blocks_.at(position));
  return found;
}

std::optional<std::pair<double, double>> Series::extent(double from_s, double until_s) const {
  const Summary sum = blocks_.sum(blocks_.lowerBound(from_s), blocks_.upperBound(until_s));
  if (sum.numbers == 0) return std::nullopt;
  return std::pair{sum.least, sum.greatest};
}

void Series::thin() {
  constexpr std::size_t kRun = 8;
  if (size() <= options_.most_samples) return;
  thinned_ = true;
  std::vector<Sample> kept, run;
  kept.reserve(size() / 2);
  for (SamplePosition position = blocks_.begin(); position < blocks_.end();
       position = blocks_.next(position)) {
    run.push_back(blocks_.at(position));
    if (run.size() < kRun) continue;
    addThinned(kept, run);
    run.clear();
  }
  kept.insert(kept.end(), run.begin(), run.end());
  blocks_.replace(blocks_.begin(), blocks_.end(), kept);
}

std::vector<Stroke> Series::strokes(double from_s, double until_s, int columns) const {
  if (!(from_s < until_s) || columns < 1) return {};
  Pen pen(covered_);
  SamplePosition position = blocks_.lowerBound(from_s);
  const SamplePosition end = blocks_.upperBound(until_s);
  if (blocks_.begin() < position) addSample(pen, blocks_.at(blocks_.previous(position)));
  const double width_s = (until_s - from_s) / columns;
  while (position < end) {
    // Columns without samples cost nothing.
    const double column = std::floor((blocks_.at(position).at_s - from_s) / width_s);
    SamplePosition next =
        column + 1 >= columns ? end : std::min(blocks_.lowerBound(from_s + (column + 1) * width_s), end);
    if (!(position < next)) next = blocks_.next(position);  // what rounding left behind
    const Summary sum = blocks_.sum(position, next);
    if (sum.count > kFew) {
      addColumn(pen, sum);
      position = next;
    } else {
      for (; position < next; position = blocks_.next(position)) addSample(pen, blocks_.at(position));
    }
  }
  if (end < blocks_.end()) addSample(pen, blocks_.at(end));
  return pen.taken();
}

std::vector<Sample> speeds(const Series& x, const Series& y, double from_s, double until_s) {
  const std::vector<Position> at = positions(x, y, from_s - kSpeedReach_s, until_s);
  std::vector<Sample> found;
  std::size_t before = 0;  // the last one that is long enough ago
  for (std::size_t i = 0; i < at.size(); ++i) {
    while (before + 1 < i && at[i].at_s - at[before + 1].at_s >= kSpeedOver_s) ++before;
    if (at[i].at_s < from_s) continue;
    const double over_s = at[i].at_s - at[before].at_s;
    double speed = std::numeric_limits<double>::quiet_NaN();
    if (over_s >= kSpeedOver_s && over_s <= kSpeedReach_s && x.isCovered(at[before].at_s, at[i].at_s)) {
      speed = distance(at[before], at[i]) / over_s;
      if (speed > kFastest_m_s) speed = std::numeric_limits<double>::quiet_NaN();
    }
    found.push_back({at[i].at_s, speed});
  }
  return found;
}

}  // namespace mapwright::series
