// The world of a bag at a time, whichever way one came there. Pure.
//
// World(T) is what playing from the bag's start to T makes: map::reduce over every message with a stamp of at
// most T, in the order of replay/chunk.h. It is computed of the prefix index, the chunk that T lies in and
// the last message of each slot, and equals that fold (tests/replay).
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "map/world.h"
#include "replay/chunk.h"
#include "replay/prefix_index.h"

namespace mapwright::replay {

/// The message at `place` of the chunk at `from`; nullptr where that chunk is not held.
using ContentOf = std::function<const map::TopicMessage*(Tick from, std::uint32_t place)>;

struct WorldAt {
  map::World world;
  /// Where large messages lie (pictures, clouds, lists) that are missing in it: their chunks are not held.
  std::vector<Tick> missing;
  /// Pictures in it that the bag only names: where they lie on the robot. The world has their places alone.
  std::map<map::GridKind, std::string> pictures;
  /// The chunk and the place of the last message of each slot.
  std::map<Slot, std::pair<Tick, std::uint32_t>> sources;
};

/// `chunk` is that of `from`, in which `at_s` lies. `complete`: the index has every range before it; then the
/// result is exact when nothing is missing. Else it is what is known so far, with what the robot back-filled.
WorldAt worldAt(const PrefixIndex& index, Tick from, const Chunk& chunk, double at_s, bool complete,
                const ContentOf& content);

/// Every topic with a message at or before `at_s`, and the stamp of its last one.
std::map<std::string, double> topicsAt(const PrefixIndex& index, Tick from, const Chunk& chunk, double at_s,
                                       bool complete);

}  // namespace mapwright::replay
