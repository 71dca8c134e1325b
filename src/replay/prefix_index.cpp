#include "replay/prefix_index.h"

#include <algorithm>
#include <utility>

#include "map/world.h"

namespace mapwright::replay {
namespace {

void insertSorted(std::vector<Tick>& ranges, Tick from) {
  const auto at = std::lower_bound(ranges.begin(), ranges.end(), from);
  if (at == ranges.end() || *at != from) ranges.insert(at, from);
}

template <typename Key>
void removeFrom(std::map<Key, std::vector<Tick>>& where, const Key& key, Tick from) {
  const auto found = where.find(key);
  if (found == where.end()) return;
  std::erase(found->second, from);
  if (found->second.empty()) where.erase(found);
}

}  // namespace

void foldHistory(map::World& world, const Digest& digest, double at_s) {
  auto pose = digest.poses.begin();
  auto kept = digest.history.begin();
  for (;;) {
    const bool more_poses = pose != digest.poses.end() && pose->stamp_s <= at_s;
    const bool more_kept = kept != digest.history.end() && kept->stamp_s <= at_s;
    if (!more_poses && !more_kept) return;
    if (more_poses && (!more_kept || pose->place < kept->place)) {
      map::reduceInto(world, map::TrackedPose{pose->pose}, pose->stamp_s);
      ++pose;
    } else {
      map::reduceInto(world, kept->message, kept->stamp_s);
      ++kept;
    }
  }
}

void PrefixIndex::add(Tick from, Digest digest) {
  if (const auto before = digests_.find(from); before != digests_.end()) unfile(from, before->second);
  Digest& now = digests_.insert_or_assign(from, std::move(digest)).first->second;
  for (const auto& [topic, span] : now.topics) insertSorted(topics_[topic], from);
  for (auto& [slot, last] : now.last) {
    Ranges& ranges = slots_[slot];
    share(slot, last, ranges, from);
    insertSorted(ranges, from);
  }
  folds_.erase(folds_.lower_bound(from), folds_.end());
}

/// Much is repeated unchanged: adjacent ranges share one copy.
void PrefixIndex::share(const Slot& slot, Digest::Last& last, const Ranges& ranges, Tick from) const {
  if (!last.message) return;
  const auto after = std::lower_bound(ranges.begin(), ranges.end(), from);
  const auto take = [&](Tick range) {
    const auto& theirs = digests_.at(range).last.at(slot).message;
    if (theirs && *theirs == *last.message) last.message = theirs;
  };
  if (after != ranges.end() && *after != from) take(*after);
  if (after != ranges.begin()) take(*std::prev(after));
}

void PrefixIndex::unfile(Tick from, const Digest& digest) {
  for (const auto& [topic, span] : digest.topics) removeFrom(topics_, topic, from);
  for (const auto& [slot, last] : digest.last) removeFrom(slots_, slot, from);
}

void PrefixIndex::forget(Tick from) {
  const auto found = digests_.find(from);
  if (found == digests_.end()) return;
  unfile(from, found->second);
  digests_.erase(found);
  folds_.erase(folds_.lower_bound(from), folds_.end());
}

void PrefixIndex::clear() {
  digests_.clear();
  topics_.clear();
  slots_.clear();
  folds_.clear();
}

std::optional<Tick> PrefixIndex::lastOf(const Ranges& ranges, Tick before) {
  const auto after = std::lower_bound(ranges.begin(), ranges.end(), before);
  return after == ranges.begin() ? std::nullopt : std::optional(*std::prev(after));
}

void PrefixIndex::foldUntil(Tick from) const {
  auto digest = folds_.empty() ? digests_.begin() : digests_.upper_bound(folds_.rbegin()->first);
  if (digest == digests_.end() || digest->first >= from) return;
  map::World world;
  std::shared_ptr<const map::World> besides;
  if (!folds_.empty()) {
    const Fold& last = folds_.rbegin()->second;
    besides = last.besides;
    world = *besides;
    world.live.robot_pose = last.pose;
    world.at_s = last.at_s;
    // The next pose is only compared with the last point.
    for (auto fold = folds_.rbegin(); fold != folds_.rend() && world.live.trail.empty(); ++fold) {
      if (!fold->second.trail.empty()) world.live.trail.push_back(fold->second.trail.back());
      if (fold->second.trail_begins) break;
    }
  }
  for (; digest != digests_.end() && digest->first < from; ++digest) {
    const int frame = world.live.frame;
    const std::size_t before = world.live.trail.size();
    foldHistory(world, digest->second, digest->second.until_s);
    auto& trail = world.live.trail;
    const std::size_t known = std::min(before, trail.size());
    Fold& fold = folds_[digest->first];
    // A trail of maximum length has dropped its first points, including the earlier ones.
    fold.trail_begins = world.live.frame != frame || trail.size() >= map::LiveState::kTrailPoints;
    fold.trail.assign(trail.begin() + std::ptrdiff_t(fold.trail_begins ? 0 : known), trail.end());
    if (trail.size() > 1) trail.erase(trail.begin(), std::prev(trail.end()));
    fold.pose = std::exchange(world.live.robot_pose, std::nullopt);
    fold.at_s = std::exchange(world.at_s, 0);
    const auto last_points = std::exchange(trail, {});
    if (!besides || !(*besides == world)) besides = std::make_shared<const map::World>(world);
    fold.besides = besides;
    trail = last_points;
    world.live.robot_pose = fold.pose;
    world.at_s = fold.at_s;
  }
}

map::World PrefixIndex::historyBefore(Tick from) const {
  foldUntil(from);
  const auto end = folds_.lower_bound(from);
  if (end == folds_.begin()) return {};
  const Fold& last = std::prev(end)->second;
  map::World world = *last.besides;
  world.live.robot_pose = last.pose;
  world.at_s = last.at_s;
  auto first = end;
  std::size_t points = 0;
  do {
    --first;
    points += first->second.trail.size();
  } while (first != folds_.begin() && !first->second.trail_begins && points < map::LiveState::kTrailPoints);
  std::size_t too_many = points - std::min(points, map::LiveState::kTrailPoints);
  for (auto fold = first; fold != end; ++fold) {
    const std::vector<map::TrailPoint>& added = fold->second.trail;
    const std::size_t skipped = std::min(std::exchange(too_many, 0), added.size());
    world.live.trail.insert(world.live.trail.end(), added.begin() + std::ptrdiff_t(skipped), added.end());
  }
  return world;
}

void PrefixIndex::addTopicsBefore(Tick from, std::map<std::string, double>& last_s) const {
  for (const auto& [topic, ranges] : topics_) {
    if (const auto range = lastOf(ranges, from)) last_s[topic] = digests_.at(*range).topics.at(topic).last_s;
  }
}

}  // namespace mapwright::replay
