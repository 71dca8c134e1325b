// A range of a bag as it is replayed: what of an answer lies in it, in the order in which it is played. Pure.
//
// Order. Messages are played by their stamps; those with equal stamps in the order of the answer. Nothing
// else would be the same whichever ranges a bag was read in: robots are asked by stamps, so where a clock was
// set back while it recorded, no answer tells what was recorded before what across two ranges. So the last
// message of a topic at T is the one with the greatest stamp that is not beyond T. Messages whose stamp is no
// number have no place in time: they are left out and counted (robot::BagChunk::without_stamp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "robot/bag_library.h"

namespace mapwright::replay {

/// Immutable once made. Messages are named by their place in source->messages.
struct Chunk {
  double from_s = 0, until_s = 0;  // from_s <= stamp < until_s
  robot::BagChunkPtr source;
  std::vector<std::uint32_t> order;        // what lies in the range, as it is played
  std::vector<std::uint32_t> back_filled;  // what was said before, by stamp

  const robot::BagMessage& at(std::size_t place) const { return source->messages[order[place]]; }
  double stampAt(std::size_t place) const { return at(place).message.received_s; }
  /// How many of `order` have a stamp of at most `at_s`.
  std::size_t countUntil(double at_s) const;
  /// About what it takes in memory.
  std::size_t bytes() const;
};
using ChunkPtr = std::shared_ptr<const Chunk>;

/// Each message of the answer that lies in its range once: what is at its very end belongs to the next range,
/// whether or not the robot counts the end in. A latched one at its beginning may be told twice, back-filled
/// and as itself (topic, stamp, bytes): that is one. All others stay, however often they say the same.
Chunk inRange(robot::BagChunkPtr answer);

}  // namespace mapwright::replay
