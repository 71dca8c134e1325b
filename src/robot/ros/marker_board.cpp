#include "robot/ros/marker_board.h"

#include <limits>

namespace mapwright::robot::ros {

void MarkerBoard::take(const std::vector<Marker>& markers, double now_s) {
  for (const Marker& marker : markers) {
    const std::pair key(marker.ns, marker.id);
    switch (marker.action) {
      case Marker::Action::Add:
        if (rows_.size() >= kMost && !rows_.contains(key)) break;
        rows_[key] = {marker, marker.lifetime_s > 0 ? now_s + marker.lifetime_s
                                                    : std::numeric_limits<double>::infinity()};
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

std::vector<Marker> MarkerBoard::markers() const {
  std::vector<Marker> all;
  all.reserve(rows_.size());
  for (const auto& [key, row] : rows_) all.push_back(row.marker);
  return all;
}

}  // namespace mapwright::robot::ros
