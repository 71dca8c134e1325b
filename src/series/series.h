// Numbers over time, for drawing and look-up: millions of them, added in any order of ranges, where drawing
// any part costs hardly more than the picture is wide. Pure; one thread at a time.
// Times are finite seconds since the epoch. A value that is not finite (NaN, infinite) breaks the line.
// Ranges that are not covered are unknown: no line crosses them, and they have no values.
// Memory is bounded (Options::most_samples): beyond that, runs of samples are replaced by their least and
// greatest ones, so that spikes stay visible.
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace mapwright::series {

struct Sample {
  double at_s = 0, value = 0;
  bool operator==(const Sample&) const = default;
};

/// Summary of a range of samples. `least` and `greatest` ignore values that are not numbers.
struct Summary {
  Sample first = {}, last = {};  // of the numbers; invalid without `numbers`
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
  std::size_t count = 0, numbers = 0;
  bool broken_before = false;  // there is a break before the first number
  bool broken_after = false;   // and after the last one
  /// Followed by `later`.
  void add(const Summary& later);
  void add(double at_s, double value);
};

/// Never empty. Times never decrease.
struct Block {
  std::vector<double> at, value;
  std::vector<Summary> parts;  // of kPart samples each
  Summary whole;
};

/// A position between samples: before sample `index` of a block. The end is {blocks, 0}.
struct SamplePosition {
  std::size_t block = 0, index = 0;
  auto operator<=>(const SamplePosition&) const = default;
};

/// The samples of a Series in blocks with summaries, so that a range is summed up without looking at each.
class Blocks {
 public:
  static constexpr std::size_t kBlock = 2048, kPart = 64;

  const std::vector<Block>& all() const { return blocks_; }
  std::size_t size() const { return size_; }
  SamplePosition begin() const { return {0, 0}; }
  SamplePosition end() const { return {blocks_.size(), 0}; }
  /// Before the first sample with t >= at_s, or t > at_s.
  SamplePosition lowerBound(double at_s) const;
  SamplePosition upperBound(double at_s) const;
  SamplePosition next(SamplePosition position) const;
  SamplePosition previous(SamplePosition position) const;  // not of begin()
  Sample at(SamplePosition position) const {
    return {blocks_[position.block].at[position.index], blocks_[position.block].value[position.index]};
  }
  Summary sum(SamplePosition from, SamplePosition until) const;

  void append(double at_s, double value);
  /// Replaces everything between the two by `samples`, which are sorted.
  void replace(SamplePosition from, SamplePosition until, std::span<const Sample> samples);
  void clear();
  std::size_t bytes() const;

 private:
  template <typename Before>
  SamplePosition bound(Before before) const;

  std::vector<Block> blocks_;
  std::size_t size_ = 0;
};

/// A piece of a line without breaks. A single point is a dot.
using Stroke = std::vector<Sample>;

class Series {
 public:
  struct Options {
    std::size_t most_samples = 4'000'000;
  };
  Series() : Series(Options{}) {}
  explicit Series(Options options) : options_(options) {}

  /// Replaces the content of from_s <= t < until_s by `samples` and marks it as covered; samples outside are
  /// dropped. Those of equal times keep their order.
  void insert(double from_s, double until_s, std::span<const Sample> samples);
  /// Adds one sample as it arrives. Covers nothing. One that is earlier than the last is inserted in order.
  void append(double at_s, double value);
  /// from_s <= t < until_s has been read: its content is complete.
  void cover(double from_s, double until_s);
  /// Drops everything before, including coverage.
  void forgetBefore(double at_s);
  void clear();

  std::size_t size() const { return blocks_.size(); }
  bool empty() const { return blocks_.size() == 0; }
  /// Of the first and the last sample. Not if empty.
  double firstAt() const { return blocks_.all().front().at.front(); }
  double lastAt() const { return blocks_.all().back().at.back(); }
  /// Samples were dropped: at() and samples() return only some of them.
  bool thinned() const { return thinned_; }
  /// Approximate memory use.
  std::size_t bytes() const;

  /// from_s <= t <= until_s is completely covered, except for its end.
  bool isCovered(double from_s, double until_s) const;
  const std::map<double, double>& covered() const { return covered_; }  // from -> until, disjoint

  /// The last sample at or before `at_s`; nullopt if unknown: before the first one, after a range that is not
  /// covered, or if it is not a number.
  std::optional<Sample> at(double at_s) const;
  /// from_s <= t < until_s, NaN included.
  std::vector<Sample> samples(double from_s, double until_s) const;
  /// Least and greatest value in from_s <= t <= until_s; nullopt = there is no number.
  std::optional<std::pair<double, double>> extent(double from_s, double until_s) const;

  /// The line of from_s..until_s for a picture with this many pixel columns, extended to the next sample on
  /// either side. For columns with more than a few samples: the first, least, greatest and last of them, so
  /// that the picture is the same as if all were drawn.
  std::vector<Stroke> strokes(double from_s, double until_s, int columns) const;

 private:
  void thin();

  Options options_;
  Blocks blocks_;
  std::map<double, double> covered_;
  bool thinned_ = false;
};

/// Poses have centimetres of noise, so the speed is averaged over kSpeedOver_s. Older data than kSpeedReach_s
/// has no effect: after new poses, recompute the speeds of that period.
inline constexpr double kSpeedOver_s = 0.2, kSpeedReach_s = 2;
/// Faster than any of these robots: its pose was reset, it did not drive.
inline constexpr double kFastest_m_s = 8;

/// Metres per second at the samples of `x` and `y` (metres, at the same times) in from_s <= t < until_s; NaN
/// if unknown: after a gap, and where the pose was reset. The result does not depend on the ranges in which
/// the poses were added.
std::vector<Sample> speeds(const Series& x, const Series& y, double from_s, double until_s);

}  // namespace mapwright::series
