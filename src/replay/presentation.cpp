#include "replay/presentation.h"

#include <algorithm>
#include <variant>

#include "map/live_state.h"
#include "replay/recorded_message.h"

namespace mapwright::replay {
namespace {

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
  std::size_t place = chunk.countUntil(at_s);
  while (place < chunk.order.size() && !isRecorded(chunk.at(place))) ++place;
  return place < chunk.order.size() ? std::optional(chunk.stampAt(place)) : std::nullopt;
}

std::optional<double> stampBefore(const Chunk& chunk, double at_s) {
  std::size_t place = chunk.countUntil(at_s);
  while (place > 0 && (chunk.stampAt(place - 1) >= at_s || !isRecorded(chunk.at(place - 1)))) --place;
  return place > 0 ? std::optional(chunk.stampAt(place - 1)) : std::nullopt;
}

}  // namespace mapwright::replay
