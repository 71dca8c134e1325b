#include "session/submap_tally.h"

namespace mapwright::session {

void SubmapTally::add(const SubmapStanding& standing, int by) {
  counts_.listed += by;
  if (!standing.visible) counts_.hidden += by;
  if (standing.status == SubmapStatus::Updating) counts_.updating += by;
  if (standing.drawable) {
    counts_.held += by;
    if (standing.visible) counts_.shown += by;
    return;
  }
  switch (standing.status) {
    case SubmapStatus::Missing:
      counts_.missing += by;
      break;
    case SubmapStatus::Waiting:
      counts_.failed += by;
      break;
    case SubmapStatus::Corrupt:
    case SubmapStatus::Unplaced:
      counts_.corrupt += by;
      break;
    case SubmapStatus::NoSlice:
      counts_.without_slice += by;
      break;
    case SubmapStatus::OnScreen:
    case SubmapStatus::Hidden:
    case SubmapStatus::Updating:
    case SubmapStatus::Queued:
    case SubmapStatus::Fetching:
      counts_.pending += by;
      break;
  }
}

void SubmapTally::set(map::SubmapId id, const SubmapStanding& standing) {
  const auto [found, added] = standings_.try_emplace(id, standing);
  if (added) {
    counts_.trajectories += ++by_trajectory_[id.trajectory] == 1;
  } else {
    add(found->second, -1);
    found->second = standing;
  }
  add(standing, 1);
}

void SubmapTally::remove(map::SubmapId id) {
  const auto found = standings_.find(id);
  if (found == standings_.end()) return;
  add(found->second, -1);
  standings_.erase(found);
  const auto count = by_trajectory_.find(id.trajectory);
  if (--count->second > 0) return;
  by_trajectory_.erase(count);
  --counts_.trajectories;
}

void SubmapTally::clear() { *this = {}; }

geometry::WorldRect SubmapTally::contentBounds() const {
  geometry::WorldRect drawn, listed;
  for (const auto& [id, standing] : standings_) {
    if (!standing.visible) continue;
    listed.extend(standing.bounds);
    if (standing.drawable) drawn.extend(standing.bounds);
  }
  return drawn.empty() ? listed : drawn;
}

}  // namespace mapwright::session
