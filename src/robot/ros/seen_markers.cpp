#include "robot/ros/seen_markers.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "robot/ros/faults.h"
#include "robot/ros/map_values.h"

namespace mapwright::robot::ros {
namespace {

constexpr std::size_t kMany = 300;

}  // namespace

/// Why its newest version cannot be placed; nullopt: it can.
std::optional<Fault> SeenMarkers::place(Row& row, const std::string& topic, const RobotTransforms& transforms,
                                        const std::string& fixed) {
  const Marker& newest = row.next ? *row.next : row.marker;
  const bool stays = !newest.frame_locked;
  if (!row.next && stays && row.placed && row.fixed_frame == fixed) return std::nullopt;
  const std::string& frame = newest.header.frame.empty() ? fixed : newest.header.frame;
  const auto found = transforms.find(topic, fixed, frame, stays ? newest.header.stamp_s : std::nullopt);
  if (!found) return reasonOf(found.error());
  row.placed = *found;
  row.fixed_frame = fixed;
  if (row.next) row.marker = *std::exchange(row.next, std::nullopt);
  return std::nullopt;
}

void SeenMarkers::put(Row& row, const Marker& marker, double now_s) {
  row.until_s = marker.lifetime_s > 0 ? now_s + marker.lifetime_s : std::numeric_limits<double>::infinity();
  // One that waits for its transform and is sent again keeps waiting.
  const bool waits = row.since_s > 0 && (!row.placed || row.next);
  if (!waits) row.since_s = now_s;
  if (row.placed) {
    row.next = marker;
  } else {
    row.marker = marker;
  }
}

void SeenMarkers::apply(const std::string& topic, const std::vector<Marker>& markers, double now_s) {
  auto& rows = topics_[topic];
  for (const Marker& marker : markers) {
    const std::pair key(marker.ns, marker.id);
    // One whose time is over is not there any more, also where nobody has looked since.
    if (const auto row = rows.find(key); row != rows.end() && row->second.until_s <= now_s) rows.erase(row);
    switch (marker.action) {
      case Marker::Action::Add:
        if (rows.size() < kMost || rows.contains(key)) put(rows[key], marker, now_s);
        break;
      case Marker::Action::Delete:
        rows.erase(key);
        break;
      case Marker::Action::DeleteAll:
        rows.clear();
        break;
    }
  }
}

void SeenMarkers::settle(const std::string& topic, const std::vector<Marker>& markers,
                         const RobotTransforms& transforms, const std::string& fixed_frame, double now_s) {
  apply(topic, markers, now_s);
  auto& rows = topics_[topic];
  for (const Marker& marker : markers) {
    const auto row = rows.find({marker.ns, marker.id});
    if (row != rows.end() && place(row->second, topic, transforms, fixed_frame)) ++waiting_[topic];
  }
}

std::vector<std::string> SeenMarkers::topics() const {
  std::vector<std::string> topics;
  for (const auto& [topic, rows] : topics_) topics.push_back(topic);
  return topics;
}

SeenMarkers::Look SeenMarkers::look(const RobotTransforms& transforms, const std::string& fixed_frame,
                                    double now_s) {
  Look look;
  map::SeenObjectsMessage seen;
  waiting_.clear();
  moves_ = false;
  next_end_s_ = std::numeric_limits<double>::infinity();
  std::size_t count = 0;
  for (auto& [topic, rows] : topics_) {
    std::erase_if(rows, [now_s](const auto& row) { return row.second.until_s <= now_s; });
    count += rows.size();
    std::int64_t late = 0;
    std::optional<Fault> reason;
    for (auto& [key, row] : rows) {
      next_end_s_ = std::min(next_end_s_, row.until_s);
      moves_ |= row.marker.frame_locked;
      if (auto why = place(row, topic, transforms, fixed_frame)) {
        ++waiting_[topic];
        const bool is_late = now_s - row.since_s > kLongestWaitS;
        late += is_late;
        if (is_late && !reason) reason = std::move(why);
      }
      if (!row.placed || row.fixed_frame != fixed_frame) continue;
      if (auto box = boxOf(row.marker, *row.placed)) {
        seen.objects.push_back(std::move(*box));
      } else if (auto drawing = drawingOf(row.marker, *row.placed)) {
        seen.drawings.push_back(std::move(*drawing));
      }
    }
    if (reason) look.unplaced.try_emplace(topic, Fault(fault::RosMarkersUnplaced, {late}, {*reason}));
  }
  many_ = count > kMany;
  if (many_) next_end_s_ = std::numeric_limits<double>::infinity();
  look.changed = !(seen == seen_);
  seen_ = std::move(seen);
  return look;
}

}  // namespace mapwright::robot::ros
