#include "robot/ros/seen_markers.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "robot/ros/map_values.h"

namespace mapwright::robot::ros {
namespace {

constexpr std::size_t kMany = 300;

/// Why its newest version cannot be placed; nullopt: it can.
std::optional<Fault> place(MarkerBoard::Row& row, const Transforms& transforms, const std::string& fixed) {
  const Marker& newest = row.next ? *row.next : row.marker;
  const bool stays = !newest.frame_locked;
  if (!row.next && stays && row.placed && row.fixed_frame == fixed) return std::nullopt;
  const std::string& frame = newest.header.frame.empty() ? fixed : newest.header.frame;
  const auto found = transforms.find(fixed, frame, stays ? newest.header.stamp_s : std::nullopt);
  if (!found) return reasonOf(found.error());
  row.placed = *found;
  row.fixed_frame = fixed;
  if (row.next) row.marker = *std::exchange(row.next, std::nullopt);
  return std::nullopt;
}

}  // namespace

void SeenMarkers::take(const std::string& topic, const std::vector<Marker>& markers, double now_s) {
  boards_[topic].take(markers, now_s);
}

std::vector<std::string> SeenMarkers::topics() const {
  std::vector<std::string> topics;
  for (const auto& [topic, board] : boards_) topics.push_back(topic);
  return topics;
}

SeenMarkers::Look SeenMarkers::look(const Transforms& transforms, const std::string& fixed_frame,
                                    double now_s) {
  Look look;
  map::SeenObjectsMessage seen;
  waits_ = moves_ = false;
  next_end_s_ = std::numeric_limits<double>::infinity();
  std::size_t rows = 0;
  for (auto& [topic, board] : boards_) {
    board.expire(now_s);
    next_end_s_ = std::min(next_end_s_, board.nextEnd());
    board.each([&, of = topic](MarkerBoard::Row& row) {
      ++rows;
      moves_ |= row.marker.frame_locked;
      if (auto why = place(row, transforms, fixed_frame)) {
        waits_ = true;
        if (now_s - row.since_s > kPatienceS) look.unplaced.try_emplace(of, std::move(*why));
      }
      if (!row.placed || row.fixed_frame != fixed_frame) return;
      if (auto box = boxOf(row.marker, *row.placed)) {
        seen.objects.push_back(std::move(*box));
      } else if (auto drawing = drawingOf(row.marker, *row.placed)) {
        seen.drawings.push_back(std::move(*drawing));
      }
    });
  }
  many_ = rows > kMany;
  if (many_) next_end_s_ = std::numeric_limits<double>::infinity();
  look.changed = !(seen == seen_);
  seen_ = std::move(seen);
  return look;
}

}  // namespace mapwright::robot::ros
