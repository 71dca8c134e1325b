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
  const auto [found, added] = entries_.try_emplace(id);
  Entry& entry = found->second;
  if (added) {
    entry.place = free_places_.empty() ? entries_.size() - 1 : free_places_.back();
    if (!free_places_.empty()) free_places_.pop_back();
    counts_.trajectories += ++by_trajectory_[id.trajectory] == 1;
  } else {
    add(entry.standing, -1);
  }
  add(standing, 1);
  entry.standing = standing;
  drawn_.set(entry.place, standing.visible && standing.drawable ? standing.bounds : geometry::WorldRect{});
  listed_.set(entry.place, standing.visible ? standing.bounds : geometry::WorldRect{});
}

void SubmapTally::remove(map::SubmapId id) {
  const auto found = entries_.find(id);
  if (found == entries_.end()) return;
  add(found->second.standing, -1);
  drawn_.set(found->second.place, {});
  listed_.set(found->second.place, {});
  free_places_.push_back(found->second.place);
  entries_.erase(found);
  const auto count = by_trajectory_.find(id.trajectory);
  if (--count->second > 0) return;
  by_trajectory_.erase(count);
  --counts_.trajectories;
}

void SubmapTally::clear() { *this = {}; }

geometry::WorldRect SubmapTally::contentBounds() const {
  return drawn_.bounds().empty() ? listed_.bounds() : drawn_.bounds();
}

}  // namespace mapwright::session
