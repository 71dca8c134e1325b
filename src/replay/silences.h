// Pauses in a bag, as far as it has been read. Pure.
#pragma once

#include <map>
#include <vector>

#include "replay/chunks.h"
#include "replay/digest.h"

namespace mapwright::replay {

/// From one message to the next; at the ends of a bag, and next to unread parts, from or to there.
struct Silence {
  double from_s = 0, until_s = 0;
  bool operator==(const Silence&) const = default;
};

/// By time, those of at least kSilenceS within the bag's stated times that are much longer than usual in it.
/// Unread ranges count as unknown.
std::vector<Silence> silencesIn(const Chunks& chunks, const std::map<Tick, Digest>& digests);

}  // namespace mapwright::replay
