#include "robot/ros/marker_board.h"

#include <algorithm>
#include <limits>

namespace mapwright::robot::ros {

void MarkerBoard::put(Row& row, const Marker& marker, double now_s) {
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

void MarkerBoard::take(const std::vector<Marker>& markers, double now_s) {
  for (const Marker& marker : markers) {
    const std::pair key(marker.ns, marker.id);
    switch (marker.action) {
      case Marker::Action::Add:
        if (rows_.size() >= kMost && !rows_.contains(key)) break;
        put(rows_[key], marker, now_s);
        break;
      case Marker::Action::Delete:
        rows_.erase(key);
        break;
      case Marker::Action::DeleteAll:
        rows_.clear();
        break;
    }
  }
}

bool MarkerBoard::expire(double now_s) {
  return std::erase_if(rows_, [now_s](const auto& row) { return row.second.until_s <= now_s; }) > 0;
}

double MarkerBoard::nextEnd() const {
  double end_s = std::numeric_limits<double>::infinity();
  for (const auto& [key, row] : rows_) end_s = std::min(end_s, row.until_s);
  return end_s;
}

std::vector<Marker> MarkerBoard::markers() const {
  std::vector<Marker> all;
  all.reserve(rows_.size());
  for (const auto& [key, row] : rows_) all.push_back(row.next.value_or(row.marker));
  return all;
}

}  // namespace mapwright::robot::ros
