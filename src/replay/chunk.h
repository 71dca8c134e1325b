// A range of a bag for replay: the messages of an answer that are in the range, in playing order. Pure.
// Order. Messages are played by their stamps; those with equal stamps in the order of the answer. Only this
// order does not depend on the ranges in which a bag is read: robots are asked by stamps, so if a clock was
// set back during recording, no answer tells the recorded order across two ranges. So the last message of a
// topic at T is the one with the greatest stamp up to T. Messages whose stamp is not a number have no place
// in time: they are left out and counted (robot::BagChunk::without_stamp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "robot/bag_library.h"

namespace mapwright::replay {

/// Immutable. Messages are referred to by their index in source->messages.
struct Chunk {
  double from_s = 0, until_s = 0;  // from_s <= stamp < until_s
  robot::BagChunkPtr source;
  std::vector<std::uint32_t> order;        // the messages in the range, in playing order
  std::vector<std::uint32_t> back_filled;  // the messages from before the range, by stamp

  const robot::BagMessage& at(std::size_t place) const { return source->messages[order[place]]; }
  double stampAt(std::size_t place) const { return at(place).message.received_s; }
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

}  // namespace mapwright::replay
