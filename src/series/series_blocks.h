// Storage of a Series: blocks in order of time, with summaries on several levels, so that any range is
// summarised in logarithmic time.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
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
struct Place {
  std::size_t block = 0, index = 0;
  auto operator<=>(const Place&) const = default;
};

class Blocks {
 public:
  static constexpr std::size_t kBlock = 2048, kPart = 64, kFan = 16;

  const std::vector<Block>& all() const { return blocks_; }
  std::size_t size() const { return size_; }
  Place begin() const { return {0, 0}; }
  Place end() const { return {blocks_.size(), 0}; }
  /// Before the first sample with t >= at_s, or t > at_s.
  Place lowerBound(double at_s) const;
  Place upperBound(double at_s) const;
  Place next(Place place) const;
  Place previous(Place place) const;  // not of begin()
  Sample at(Place place) const {
    return {blocks_[place.block].at[place.index], blocks_[place.block].value[place.index]};
  }
  Summary sum(Place from, Place until) const;

  void append(double at_s, double value);
  /// Replaces everything between the two by `samples`, which are sorted.
  void replace(Place from, Place until, std::span<const Sample> samples);
  void clear();
  std::size_t bytes() const;

 private:
  template <typename Before>
  Place bound(Before before) const;
  void sumUp(std::size_t first_block);
  Summary sumBlocks(std::size_t from, std::size_t until) const;

  std::vector<Block> blocks_;
  std::size_t size_ = 0;
  std::vector<std::vector<Summary>> levels_;  // kFan blocks each, kFan of these each …; only full groups
};

}  // namespace mapwright::series
