#include "replay/digest.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <variant>

#include "map/world.h"

namespace mapwright::replay {
namespace {

using map::TopicMessage;

constexpr std::size_t kSmallBytes = 2048;

/// The memory of a message outside of the struct itself.
struct Weight {
  template <typename Item>
  static std::size_t of(const std::vector<Item>& items) {
    return items.size() * sizeof(Item);
  }
  std::size_t operator()(const map::SubmapList& list) const { return of(list.entries) + of(list.rejected); }
  std::size_t operator()(const map::GridMessage& grid) const { return grid.png ? grid.png->size() : 0; }
  std::size_t operator()(const map::PointCloudMessage& cloud) const {
    return cloud.points ? of(*cloud.points) : 0;
  }
  std::size_t operator()(const map::RobotModel& model) const {
    return of(model.footprint) + of(model.expanded_footprint);
  }
  std::size_t operator()(const map::PathMessage& path) const { return of(path.points); }
  std::size_t operator()(const map::LocalPathMessage& path) const { return of(path.points); }
  std::size_t operator()(const map::TrajectoryMessage& path) const { return of(path.points); }
  std::size_t operator()(const map::PlanningState& planning) const { return of(planning.targets); }
  std::size_t operator()(const map::MapInfo& info) const { return 1000 * info.overlays.size(); }
  std::size_t operator()(const map::AlertsMessage& alerts) const { return 2 * of(alerts.alerts); }
  std::size_t operator()(const map::NearbyRobotsMessage& nearby) const { return 2 * of(nearby.robots); }
  std::size_t operator()(const map::LandmarksMessage& marks) const { return 2 * of(marks.landmarks); }
  std::size_t operator()(const map::AutoDoorsMessage& doors) const { return 400 * doors.doors.size(); }
  std::size_t operator()(const map::DetectedFeaturesMessage& seen) const { return of(seen.boxes); }
  std::size_t operator()(const map::PalletsMessage& pallets) const { return of(pallets.pallets); }
  std::size_t operator()(const map::RackMessage& racks) const { return of(racks.racks); }
  std::size_t operator()(const map::SeenObjectsMessage& seen) const { return of(seen.objects); }
  std::size_t operator()(const map::ConstraintsMessage& constraints) const {
    std::size_t bytes = 0;
    for (const auto& [name, lines] : constraints.by_name) bytes += 64 + of(lines);
    return bytes;
  }
  std::size_t operator()(const map::NearbyFootprintsMessage& nearby) const {
    std::size_t bytes = 0;
    for (const auto& [digest, outline] : nearby.by_digest) bytes += 64 + of(outline);
    return bytes;
  }
  template <typename Other>
  std::size_t operator()(const Other&) const {
    return 0;
  }
};

/// The parts of SLAM's state that people must know of; its scores change all the time.
auto alarming(const map::SlamStatus& slam) {
  return std::tie(slam.state, slam.reliable, slam.position_quality, slam.wheel_slipping);
}

template <typename Message>
const Message* as(const TopicMessage* message) {
  return message ? std::get_if<Message>(message) : nullptr;
}

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

Slot slotOf(const TopicMessage& message) {
  std::string which;
  if (const auto* grid = std::get_if<map::GridMessage>(&message)) which = std::to_string(int(grid->kind));
  if (const auto* cloud = std::get_if<map::PointCloudMessage>(&message)) which = cloud->topic;
  if (const auto* seen = std::get_if<map::DetectedFeaturesMessage>(&message))
    which = std::to_string(int(seen->kind));
  return {message.index(), std::move(which)};
}

bool isSmall(const TopicMessage& message) { return std::visit(Weight(), message) <= kSmallBytes; }

TopicMessage lightened(const TopicMessage& message) {
  if (const auto* list = std::get_if<map::SubmapList>(&message))
    return map::SubmapList{list->slam_state, list->uuid, {}, {}};
  if (const auto* info = std::get_if<map::MapInfo>(&message)) {
    map::MapInfo light;
    light.name = info->name;
    light.uid = info->uid;
    light.map_version = info->map_version;
    light.overlays_version = info->overlays_version;
    return light;
  }
  return message;
}

bool countsLater(const TopicMessage& message, const TopicMessage* before) {
  if (const auto* list = std::get_if<map::SubmapList>(&message)) {
    const auto* then = as<map::SubmapList>(before);
    return !then || then->uuid != list->uuid;
  }
  if (const auto* info = std::get_if<map::MapInfo>(&message)) {
    const auto* then = as<map::MapInfo>(before);
    return !then || std::tie(then->uid, then->name, then->map_version) !=
                        std::tie(info->uid, info->name, info->map_version);
  }
  if (const auto* slam = std::get_if<map::SlamStatus>(&message)) {
    const auto* then = as<map::SlamStatus>(before);
    return !then || alarming(*then) != alarming(*slam);
  }
  if (std::holds_alternative<map::AlertsMessage>(message) ||
      std::holds_alternative<map::WheelState>(message) ||
      std::holds_alternative<map::NearbyFootprintsMessage>(message)) {
    return !before || !(*before == message);
  }
  return false;
}

Digest digestOf(const Chunk& chunk) {
  Digest digest;
  digest.from_s = chunk.from_s;
  digest.until_s = chunk.until_s;
  std::map<std::size_t, std::size_t> kept_last;  // by kind: its index in the history
  std::map<Slot, std::uint32_t> last;
  for (std::uint32_t index = 0; index < chunk.order.size(); ++index) {
    const robot::BagMessage& each = chunk.at(index);
    const double stamp_s = each.message.received_s;
    if (isRecorded(each)) {
      if (digest.messages == 0) digest.first_s = stamp_s;
      if (digest.messages > 0 && stamp_s - digest.last_s >= kSilenceS)
        digest.silences.emplace_back(digest.last_s, stamp_s);
      ++digest.messages;
      digest.last_s = stamp_s;
      TopicSpan& span = digest.topics[each.message.topic];
      if (span.count++ == 0) span.first_s = stamp_s;
      span.last_s = stamp_s;
    }
    if (!each.known) continue;
    ++digest.known;
    digest.last_known_s = stamp_s;
    const TopicMessage& message = each.message.message;
    if (const auto* tracked = std::get_if<map::TrackedPose>(&message)) {
      digest.poses.push_back({stamp_s, index, tracked->pose});
      continue;
    }
    last[slotOf(message)] = index;
    if (const auto* planning = std::get_if<map::PlanningState>(&message)) {
      if (digest.moves.empty() || digest.moves.back().state != planning->move_state)
        digest.moves.push_back({stamp_s, planning->move_state});
    }
    const auto kept = kept_last.find(message.index());
    if (!countsLater(message, kept == kept_last.end() ? nullptr : &digest.history[kept->second].message))
      continue;
    // A new session may have made the map unknown: then the same message is news again.
    if (std::holds_alternative<map::SubmapList>(message)) kept_last.erase(map::topicIndex<map::MapInfo>());
    kept_last[message.index()] = digest.history.size();
    digest.history.push_back({stamp_s, index, lightened(message)});
  }
  for (const auto& [slot, index] : last) {
    const map::StampedMessage& message = chunk.at(index).message;
    Digest::Last& one = digest.last[slot];
    one.stamp_s = message.received_s;
    one.index = index;
    if (isSmall(message.message)) one.message = std::make_shared<const TopicMessage>(message.message);
    one.picture_url = chunk.at(index).picture_url;
  }
  // They are kept for good.
  digest.history.shrink_to_fit();
  digest.poses.shrink_to_fit();
  digest.moves.shrink_to_fit();
  return digest;
}

void foldHistory(map::World& world, const Digest& digest, double at_s) {
  auto pose = digest.poses.begin();
  auto kept = digest.history.begin();
  for (;;) {
    const bool more_poses = pose != digest.poses.end() && pose->stamp_s <= at_s;
    const bool more_kept = kept != digest.history.end() && kept->stamp_s <= at_s;
    if (!more_poses && !more_kept) return;
    if (more_poses && (!more_kept || pose->index < kept->index)) {
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
  const auto shareWith = [&](Tick range) {
    const auto& theirs = digests_.at(range).last.at(slot).message;
    if (theirs && *theirs == *last.message) last.message = theirs;
  };
  if (after != ranges.end() && *after != from) shareWith(*after);
  if (after != ranges.begin()) shareWith(*std::prev(after));
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
