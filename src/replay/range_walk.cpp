#include "replay/range_walk.h"

#include <algorithm>

#include "map/failure.h"

namespace mapwright::replay {
namespace {

constexpr int kTries = 3;
constexpr double kBeforeAllS = -1e300;

}  // namespace

bool isFinal(const Cell& cell) {
  const bool rejected = cell.failure.kind == map::FailureKind::RejectedByRobot && !map::mayPass(cell.failure);
  return cell.tries >= kTries || rejected || cell.failure.kind == map::FailureKind::Refused ||
         cell.failure.kind == map::FailureKind::Certificate;
}

RangeWalk::RangeWalk(Reading& reading, std::optional<double> from_s, std::optional<double> to_s)
    : reading_(reading), from_s_(from_s), to_s_(to_s) {
  const Cell* const first = reading_.chunks().cellAt(from_s.value_or(kBeforeAllS));
  next_s_ = from_s.value_or(kBeforeAllS);
  wantNext(first);
}

void RangeWalk::wantNext(const Cell* cell) {
  if (!cell || (to_s_ && secondsOf(cell->from) > *to_s_)) {
    next_s_.reset();
    return;
  }
  next_s_ = std::max(*next_s_, secondsOf(cell->from));
  reading_.want(*next_s_);
}

const Cell* RangeWalk::waitsFor() const { return next_s_ ? reading_.chunks().cellAt(*next_s_) : nullptr; }

ChunkPtr RangeWalk::next() {
  // Ranges may have been merged or split meanwhile.
  const Cell* const cell = waitsFor();
  ChunkPtr chunk = cell ? reading_.chunkAt(cell->from) : nullptr;
  if (!chunk) return nullptr;
  const auto& cells = reading_.chunks().cells();
  const auto after = cells.upper_bound(cell->from);
  wantNext(after == cells.end() ? nullptr : &after->second);
  return chunk;
}

double RangeWalk::share() const {
  if (!next_s_) return 1;
  const Chunks& chunks = reading_.chunks();
  const double first_s = std::max(from_s_.value_or(kBeforeAllS), chunks.start_s());
  const double last_s = std::min(to_s_.value_or(-kBeforeAllS), chunks.end_s());
  return last_s > first_s ? std::clamp((*next_s_ - first_s) / (last_s - first_s), 0.0, 1.0) : 0;
}

}  // namespace mapwright::replay
