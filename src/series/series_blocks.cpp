#include "series/series_blocks.h"

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
Place Blocks::bound(Before before) const {
  // The first block whose last sample is not earlier.
  const auto block = std::partition_point(blocks_.begin(), blocks_.end(),
                                          [&](const Block& each) { return before(each.at.back()); });
  if (block == blocks_.end()) return end();
  const auto index = std::partition_point(block->at.begin(), block->at.end(), before);
  return {std::size_t(block - blocks_.begin()), std::size_t(index - block->at.begin())};
}

Place Blocks::lowerBound(double at_s) const {
  return bound([at_s](double each) { return each < at_s; });
}
Place Blocks::upperBound(double at_s) const {
  return bound([at_s](double each) { return each <= at_s; });
}

Place Blocks::next(Place place) const {
  if (++place.index < blocks_[place.block].at.size()) return place;
  return {place.block + 1, 0};
}

Place Blocks::previous(Place place) const {
  if (place.index > 0) return {place.block, place.index - 1};
  return {place.block - 1, blocks_[place.block - 1].at.size() - 1};
}

Summary Blocks::sumBlocks(std::size_t from, std::size_t until) const {
  Summary sum;
  while (from < until) {
    // The widest group that begins here and does not reach too far.
    std::size_t width = 1, level = 0;
    while (level < levels_.size()) {
      const std::size_t wider = width * kFan;
      if (from % wider != 0 || from + wider > until || from / wider >= levels_[level].size()) break;
      width = wider;
      ++level;
    }
    sum.add(level == 0 ? blocks_[from].whole : levels_[level - 1][from / width]);
    from += width;
  }
  return sum;
}

Summary Blocks::sum(Place from, Place until) const {
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
  sum.add(sumBlocks(block, until.block));
  if (until.index > 0) addSamples(sum, blocks_[until.block], 0, until.index);
  return sum;
}

void Blocks::sumUp(std::size_t first_block) {
  // The last block still grows: it is in no group.
  std::size_t below = blocks_.empty() ? 0 : blocks_.size() - 1, first = first_block, level = 0;
  for (; below >= kFan; ++level) {
    if (level >= levels_.size()) levels_.emplace_back();
    std::vector<Summary>& groups = levels_[level];
    below /= kFan;
    first = std::min(first / kFan, groups.size());
    groups.resize(below);
    for (std::size_t group = first; group < below; ++group) {
      Summary sum;
      for (std::size_t i = group * kFan; i < (group + 1) * kFan; ++i)
        sum.add(level == 0 ? blocks_[i].whole : levels_[level - 1][i]);
      groups[group] = sum;
    }
  }
  levels_.resize(level);
}

void Blocks::append(double at_s, double value) {
  if (blocks_.empty() || blocks_.back().at.size() >= kBlock) {
    blocks_.emplace_back();
    if (blocks_.size() % kFan == 1 && blocks_.size() > 1) sumUp(blocks_.size() - 2);
  }
  Block& block = blocks_.back();
  if (block.at.size() % kPart == 0) block.parts.emplace_back();
  block.at.push_back(at_s);
  block.value.push_back(value);
  block.parts.back().add(at_s, value);
  block.whole.add(at_s, value);
  ++size_;
}

void Blocks::replace(Place from, Place until, std::span<const Sample> samples) {
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
  const auto take = [&](const Block& block, std::size_t begin, std::size_t end) {
    at.insert(at.end(), block.at.begin() + std::ptrdiff_t(begin), block.at.begin() + std::ptrdiff_t(end));
    value.insert(value.end(), block.value.begin() + std::ptrdiff_t(begin),
                 block.value.begin() + std::ptrdiff_t(end));
  };
  if (before > 0) take(blocks_[first], 0, before);
  if (head > 0) take(blocks_[from.block], 0, head);
  for (const Sample& sample : samples) {
    at.push_back(sample.at_s);
    value.push_back(sample.value);
  }
  if (until.index > 0) take(blocks_[until.block], until.index, blocks_[until.block].at.size());
  if (last < blocks_.size() && at.size() + blocks_[last].at.size() <= kBlock) {
    take(blocks_[last], 0, blocks_[last].at.size());
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
  sumUp(first);
}

void Blocks::clear() {
  blocks_.clear();
  levels_.clear();
  size_ = 0;
}

std::size_t Blocks::bytes() const {
  std::size_t bytes = 0;
  for (const Block& block : blocks_) {
    bytes += sizeof(Block) + (block.at.capacity() + block.value.capacity()) * sizeof(double) +
             block.parts.capacity() * sizeof(Summary);
  }
  for (const auto& level : levels_) bytes += level.capacity() * sizeof(Summary);
  return bytes;
}

}  // namespace mapwright::series
