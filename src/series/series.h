// Numbers over time, for drawing and look-up: millions of them, added in any order of ranges, where drawing
// any part costs as much as the picture is wide. Pure; one thread at a time.
// Times are finite seconds since the epoch. A value that is not finite (NaN, infinite) breaks the line.
// Ranges that are not covered are unknown: no line crosses them, and they have no values.
// Memory is bounded (Options::most_samples): beyond that, runs of samples are replaced by their least and
// greatest ones, so that spikes stay visible.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "series/series_blocks.h"

namespace mapwright::series {

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
  /// that the picture is the same as if all were drawn. O(columns * log(size)).
  std::vector<Stroke> strokes(double from_s, double until_s, int columns) const;

 private:
  void thin();

  Options options_;
  Blocks blocks_;
  std::map<double, double> covered_;
  bool thinned_ = false;
};

}  // namespace mapwright::series
