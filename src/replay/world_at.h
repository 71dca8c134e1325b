// The world of a bag at a time, independent of how that time was reached. Pure.
// World(T) is the result of playing from the bag's start to T: map::reduce over every message with a stamp of
// at most T, in the order of replay/chunks.h. It is computed from the prefix index, the chunk that contains T
// and the last message of each slot, and equals that fold (tests/replay).
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/pose.h"
#include "map/world.h"
#include "replay/chunks.h"
#include "replay/digest.h"

namespace mapwright::replay {

/// The message at `index` of the chunk at `from`; nullptr if that chunk is not in memory.
using ContentOf = std::function<const map::TopicMessage*(Tick from, std::uint32_t index)>;

struct WorldAt {
  map::World world;
  /// The ranges of missing large messages (pictures, clouds, lists): their chunks are not in memory.
  std::vector<Tick> missing;
  /// Addresses on the robot of pictures that are not in the bag. The world only has their places.
  std::map<map::GridKind, std::string> pictures;
  /// The chunk and index of the last message of each slot.
  std::map<Slot, std::pair<Tick, std::uint32_t>> sources;
};

/// `chunk` is the one at `from`, which contains `at_s`. `complete`: the index has every range before it; then
/// the result is exact if nothing is missing. Otherwise it is what is known so far, including the robot's
/// back-fill.
WorldAt worldAt(const PrefixIndex& index, Tick from, const Chunk& chunk, double at_s, bool complete,
                const ContentOf& content);

/// Every topic with a message at or before `at_s`, and the stamp of its last one.
std::map<std::string, double> topicsAt(const PrefixIndex& index, Tick from, const Chunk& chunk, double at_s,
                                       bool complete);

// For display only: no part of the world.

/// The robot's pose interpolated between the last sample at or before `at_s` and the next one, turning the
/// shorter way. Never across a jump, into another map or session, or over more than a second without samples:
/// then it is the sample before. nullopt: there is none before.
std::optional<geometry::Pose2> poseBetween(const PrefixIndex& index, double at_s);

/// The stamp of the first message after `at_s`, or the last before it, in a chunk; nullopt = there is none in
/// this one.
std::optional<double> stampAfter(const Chunk& chunk, double at_s);
std::optional<double> stampBefore(const Chunk& chunk, double at_s);

/// The stamp of the first map in a chunk (a list of submaps, or a whole map); nullopt = there is none, or the
/// map is there from before the chunk.
std::optional<double> stampOfFirstMap(const Chunk& chunk);

}  // namespace mapwright::replay
