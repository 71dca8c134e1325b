// Numbers over time, to be drawn and looked up: millions of them, in any order of ranges, with a picture of
// any stretch that costs as much as it is wide. Pure; one thread at a time.
//
// Times are seconds since the epoch and finite. A value that is no number (NaN, infinite) breaks the line.
// What is not covered has not been looked at: no line goes across it, and no value is known in it.
//
// Memory is bounded (Options::most_samples): of more, runs of samples give way to their least and greatest
// ones, so that every spike stays.
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

  /// What lies in from_s <= t < until_s is `samples` from now on, and covered; what lies outside of that is
  /// left out of them. Those of equal times stay in their order.
  void insert(double from_s, double until_s, std::span<const Sample> samples);
  /// One more, as it comes. Covers nothing. One with an earlier time than the last is put in its place.
  void append(double at_s, double value);
  /// from_s <= t < until_s has been looked at: what is there is all that there is.
  void cover(double from_s, double until_s);
  /// All before goes, what was covered included.
  void forgetBefore(double at_s);
  void clear();

  std::size_t size() const { return blocks_.size(); }
  bool empty() const { return blocks_.size() == 0; }
  /// Of the first and the last sample. Not when empty.
  double firstAt() const { return blocks_.all().front().at.front(); }
  double lastAt() const { return blocks_.all().back().at.back(); }
  /// Samples had to give way: what at() and samples() tell are some of them.
  bool thinned() const { return thinned_; }
  /// About what it takes in memory.
  std::size_t bytes() const;

  /// No part of from_s <= t <= until_s is outside of what was covered, its end aside.
  bool isCovered(double from_s, double until_s) const;
  const std::map<double, double>& covered() const { return covered_; }  // from -> until, disjoint

  /// The last sample at or before `at_s`; nullopt where that is not known: before the first one, after a
  /// range that is not covered, or where it is no number.
  std::optional<Sample> at(double at_s) const;
  /// from_s <= t < until_s, NaN included.
  std::vector<Sample> samples(double from_s, double until_s) const;
  /// Least and greatest value in from_s <= t <= until_s; nullopt = no number there.
  std::optional<std::pair<double, double>> extent(double from_s, double until_s) const;

  /// The line of from_s..until_s for a picture of so many columns of pixels, and on to the next sample on
  /// either side. In each column where more than a few samples lie: the first, the least, the greatest and
  /// the last of them, so that the line between columns and what it covers within each are as if all were
  /// drawn. O(columns * log(size)).
  std::vector<Stroke> strokes(double from_s, double until_s, int columns) const;

 private:
  void thin();

  Options options_;
  Blocks blocks_;
  std::map<double, double> covered_;
  bool thinned_ = false;
};

}  // namespace mapwright::series
