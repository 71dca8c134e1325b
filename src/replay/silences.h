// Where nothing was recorded in a bag, as far as it has been read. Pure.
#pragma once

#include <map>
#include <vector>

#include "replay/chunks.h"
#include "replay/digest.h"

namespace mapwright::replay {

/// From one message to the next one; at the ends of a bag, and beside what has not been read, from or to
/// there.
struct Silence {
  double from_s = 0, until_s = 0;
  bool operator==(const Silence&) const = default;
};

/// By time, those of at least kSilenceS within the times that the bag told, and of much more than is usual in
/// it. Of ranges that have not been read nothing is said.
std::vector<Silence> silencesIn(const Chunks& chunks, const std::map<Tick, Digest>& digests);

}  // namespace mapwright::replay
