#include "replay/world_at.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "map/live_state.h"
#include "map/world.h"

namespace mapwright::replay {
namespace {

constexpr Tick kBackFilled = std::numeric_limits<Tick>::min();

/// The last message of a slot, or one that begins a frame.
struct Found {
  double stamp_s = 0;
  Tick chunk = 0;
  std::uint32_t index = 0;
  const map::TopicMessage* message = nullptr;
  const std::string* picture_url = nullptr;
};

auto orderOf(const Found& found) { return std::tuple(found.stamp_s, found.chunk, found.index); }

bool beginsFrames(const map::TopicMessage& message) {
  return std::holds_alternative<map::SubmapList>(message) || std::holds_alternative<map::MapInfo>(message);
}

struct Search {
  const PrefixIndex& index;
  Tick from;
  const Chunk& chunk;
  double at_s;
  bool complete;
  const ContentOf& content;
  WorldAt& result;
  std::map<Slot, Found> last = {};
  std::vector<Found> frames = {};
  std::deque<map::TopicMessage> light = {};  // of `frames`

  /// From newest to oldest: the first one found stays.
  void lookIntoChunk() {
    for (std::size_t i = chunk.countUntil(at_s); i-- > 0;) {
      const robot::BagMessage& each = chunk.at(i);
      if (!each.known) continue;
      const map::TopicMessage& message = each.message.message;
      const Found found{each.message.received_s, from, std::uint32_t(i), &message, &each.picture_url};
      last.try_emplace(slotOf(message), found);
      if (beginsFrames(message)) addFrame(found);
    }
  }

  /// Lists are long and frequent.
  void addFrame(Found found) {
    found.message = &light.emplace_back(lightened(*found.message));
    frames.push_back(found);
  }

  void lookBack() {
    index.forLastBefore(from, [&](const Slot& slot, Tick at, const Digest::Last& one) {
      if (last.contains(slot)) return;
      Found found{one.stamp_s, at, one.index, one.message ? one.message.get() : content(at, one.index),
                  &one.picture_url};
      if (found.message == nullptr) result.missing.push_back(at);
      last.emplace(slot, found);
    });
    const auto end = index.digests().lower_bound(from);
    for (auto before = index.digests().begin(); before != end; ++before) {
      for (const Digest::Kept& kept : before->second.history) {
        if (beginsFrames(kept.message))
          frames.push_back({kept.stamp_s, before->first, kept.index, &kept.message, nullptr});
      }
    }
  }

  /// Data added by the robot is older than the chunk, and may be newer than what is known.
  void addBackFilled() {
    for (const std::uint32_t which : chunk.back_filled) {
      const robot::BagMessage& each = chunk.source->messages[which];
      if (!each.known) continue;
      const map::TopicMessage& message = each.message.message;
      const Found found{each.message.received_s, kBackFilled, which, &message, &each.picture_url};
      const auto [known, is_new] = last.try_emplace(slotOf(message), found);
      if (!is_new && known->second.stamp_s < found.stamp_s) known->second = found;
      if (beginsFrames(message)) addFrame(found);
    }
  }

  std::optional<double> stampOf(std::size_t kind) const {
    const auto found = last.lower_bound({kind, {}});
    return found != last.end() && found->first.first == kind ? std::optional(found->second.stamp_s)
                                                             : std::nullopt;
  }

  /// The known earlier ranges, with the robot's back-fill; some have not been read.
  map::World knownHistory() const {
    const auto end = index.digests().lower_bound(from);
    // Called often while data arrives: only uses poses that can be part of a trail.
    auto trail_from = end;
    for (std::size_t poses = 0;
         trail_from != index.digests().begin() && poses <= map::LiveState::kTrailPoints;)
      poses += (--trail_from)->second.poses.size();
    map::World world;
    auto added = chunk.back_filled.begin();
    const auto addedBefore = [&](double stamp_s, bool is_news) {
      for (; added != chunk.back_filled.end(); ++added) {
        const robot::BagMessage& each = chunk.source->messages[*added];
        if (each.message.received_s >= stamp_s) return;
        if (is_news && each.known) map::reduceInto(world, each.message.message, each.message.received_s);
      }
    };
    for (auto it = index.digests().begin(); it != end; ++it) {
      const Digest& digest = it->second;
      addedBefore(digest.from_s, true);
      addedBefore(digest.until_s, false);
      if (it->first >= trail_from->first) {
        foldHistory(world, digest, digest.until_s);
      } else {
        for (const Digest::Kept& kept : digest.history) map::reduceInto(world, kept.message, kept.stamp_s);
      }
    }
    addedBefore(std::numeric_limits<double>::infinity(), true);
    return world;
  }

  map::World history() const {
    map::World world = complete ? index.historyBefore(from) : knownHistory();
    const std::size_t count = chunk.countUntil(at_s);
    for (std::size_t i = 0; i < count; ++i) {
      const robot::BagMessage& each = chunk.at(i);
      const map::TopicMessage& message = each.message.message;
      if (!each.known) continue;
      if (beginsFrames(message)) {
        map::reduceInto(world, lightened(message), each.message.received_s);
      } else if (std::holds_alternative<map::TrackedPose>(message) || countsLater(message, nullptr)) {
        map::reduceInto(world, message, each.message.received_s);
      }
    }
    // Each message about it removes expired ones, even if it brings no news.
    std::optional<double> told_s;
    for (const std::size_t kind :
         {std::size_t(map::topicIndex<map::AlertsMessage>()), std::size_t(map::topicIndex<map::WheelState>()),
          std::size_t(map::topicIndex<map::SlamStatus>())}) {
      if (const auto stamp_s = stampOf(kind)) told_s = std::max(told_s.value_or(*stamp_s), *stamp_s);
    }
    if (told_s) world.live.safety = map::continuedSafety(std::move(world.live.safety), world.live, *told_s);
    return world;
  }

  map::World ofLastMessages() {
    std::vector<Found> all = frames;
    for (const auto& [slot, found] : last) {
      if (found.message == nullptr) continue;
      all.push_back(found);
      if (found.chunk != kBackFilled) result.sources[slot] = {found.chunk, found.index};
    }
    // Frames come first among equals: the full message follows its reduced version.
    std::stable_sort(all.begin(), all.end(),
                     [](const Found& a, const Found& b) { return orderOf(a) < orderOf(b); });
    map::World world;
    for (const Found& found : all) {
      if (std::holds_alternative<map::TrackedPose>(*found.message)) continue;
      map::reduceInto(world, *found.message, found.stamp_s);
    }
    for (const auto& [slot, found] : last) {
      const auto* grid = found.message ? std::get_if<map::GridMessage>(found.message) : nullptr;
      // One of a previous map is no longer in the world.
      if (grid && found.picture_url && !found.picture_url->empty() && world.live.grids.contains(grid->kind))
        result.pictures[grid->kind] = *found.picture_url;
    }
    return world;
  }

  double newest() const {
    double newest_s = 0;
    const std::size_t count = chunk.countUntil(at_s);
    for (std::size_t i = count; i-- > 0;) {
      if (chunk.at(i).known) return chunk.stampAt(i);
    }
    for (auto it = std::make_reverse_iterator(index.digests().lower_bound(from));
         it != index.digests().rend(); ++it) {
      if (it->second.known > 0) {
        newest_s = it->second.last_known_s;
        break;
      }
    }
    if (!complete) {
      for (const std::uint32_t which : chunk.back_filled)
        newest_s = std::max(newest_s, chunk.source->messages[which].message.received_s);
    }
    return newest_s;
  }
};

constexpr double kLongestS = 1;

/// Whether a frame may begin within (from_s, until_s].
bool framesBetween(const PrefixIndex& index, double from_s, double until_s) {
  for (const auto& [from, digest] : index.digests()) {
    if (digest.until_s < from_s || digest.from_s > until_s) continue;
    for (const Digest::Kept& kept : digest.history) {
      const bool frame = std::holds_alternative<map::SubmapList>(kept.message) ||
                         std::holds_alternative<map::MapInfo>(kept.message);
      if (frame && kept.stamp_s > from_s && kept.stamp_s <= until_s) return true;
    }
  }
  return false;
}

}  // namespace

WorldAt worldAt(const PrefixIndex& index, Tick from, const Chunk& chunk, double at_s, bool complete,
                const ContentOf& content) {
  WorldAt result;
  Search search{index, from, chunk, at_s, complete, content, result};
  search.lookIntoChunk();
  search.lookBack();
  if (!complete) search.addBackFilled();
  map::World history = search.history();
  map::World world = search.ofLastMessages();
  world.live.robot_pose = history.live.robot_pose;
  world.live.trail = std::move(history.live.trail);
  world.live.alerts = std::move(history.live.alerts);
  world.live.safety = std::move(history.live.safety);
  world.live.nearby_footprints = std::move(history.live.nearby_footprints);
  world.at_s = search.newest();
  result.world = std::move(world);
  auto& missing = result.missing;
  std::sort(missing.begin(), missing.end());
  missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
  return result;
}

std::map<std::string, double> topicsAt(const PrefixIndex& index, Tick from, const Chunk& chunk, double at_s,
                                       bool complete) {
  std::map<std::string, double> last_s;
  if (!complete) {
    for (const std::uint32_t which : chunk.back_filled) {
      const robot::BagMessage& each = chunk.source->messages[which];
      if (isRecorded(each)) last_s[each.message.topic] = each.message.received_s;
    }
  }
  index.addTopicsBefore(from, last_s);
  const std::size_t count = chunk.countUntil(at_s);
  for (std::size_t i = 0; i < count; ++i) {
    if (isRecorded(chunk.at(i))) last_s[chunk.at(i).message.topic] = chunk.stampAt(i);
  }
  return last_s;
}

std::optional<geometry::Pose2> poseBetween(const PrefixIndex& index, double at_s) {
  const Digest::Pose *before = nullptr, *after = nullptr;
  // Only the ranges around `at_s` matter: the last with a pose before it, and the first with one after it.
  auto next = index.digests().upper_bound(tickOf(at_s));
  const auto first_after = [&](const Digest& digest) {
    return std::partition_point(digest.poses.begin(), digest.poses.end(),
                                [&](const Digest::Pose& pose) { return pose.stamp_s <= at_s; });
  };
  for (auto it = next; it != index.digests().begin() && before == nullptr;) {
    --it;
    const auto later = first_after(it->second);
    if (later != it->second.poses.end() && after == nullptr) after = &*later;
    if (later != it->second.poses.begin()) before = &*std::prev(later);
  }
  for (; next != index.digests().end() && after == nullptr; ++next) {
    if (!next->second.poses.empty()) after = &next->second.poses.front();
  }
  if (before == nullptr) return std::nullopt;
  const bool near =
      after != nullptr && after->stamp_s - before->stamp_s <= kLongestS && after->stamp_s > before->stamp_s;
  if (!near || map::isJump(placeOf(*before), placeOf(*after)) ||
      framesBetween(index, before->stamp_s, after->stamp_s))
    return before->pose;
  const double share = (at_s - before->stamp_s) / (after->stamp_s - before->stamp_s);
  const double turn_rad = geometry::normalizeAngle(after->pose.yaw_rad - before->pose.yaw_rad);
  return geometry::Pose2{before->pose.x_m + share * (after->pose.x_m - before->pose.x_m),
                         before->pose.y_m + share * (after->pose.y_m - before->pose.y_m),
                         geometry::normalizeAngle(before->pose.yaw_rad + share * turn_rad)};
}

std::optional<double> stampAfter(const Chunk& chunk, double at_s) {
  std::size_t i = chunk.countUntil(at_s);
  while (i < chunk.order.size() && !isRecorded(chunk.at(i))) ++i;
  return i < chunk.order.size() ? std::optional(chunk.stampAt(i)) : std::nullopt;
}

std::optional<double> stampBefore(const Chunk& chunk, double at_s) {
  std::size_t i = chunk.countUntil(at_s);
  while (i > 0 && (chunk.stampAt(i - 1) >= at_s || !isRecorded(chunk.at(i - 1)))) --i;
  return i > 0 ? std::optional(chunk.stampAt(i - 1)) : std::nullopt;
}

std::optional<double> stampOfFirstMap(const Chunk& chunk) {
  const auto is_map = [](const robot::BagMessage& message) {
    if (std::holds_alternative<map::SubmapList>(message.message.message)) return true;
    const auto* const grid = std::get_if<map::GridMessage>(&message.message.message);
    return grid && grid->kind == map::GridKind::WholeMap;
  };
  for (const std::uint32_t index : chunk.back_filled) {
    if (is_map(chunk.source->messages[index])) return std::nullopt;
  }
  for (std::size_t i = 0; i < chunk.order.size(); ++i) {
    if (is_map(chunk.at(i))) return chunk.stampAt(i);
  }
  return std::nullopt;
}

}  // namespace mapwright::replay
