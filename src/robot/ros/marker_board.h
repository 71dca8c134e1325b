// The visible markers of one topic. Source: visualization_msgs/Marker (action, lifetime).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot/ros/read_messages.h"

namespace mapwright::robot::ros {

/// A value; time is passed in (seconds, any monotonic clock). At most kMost markers: further ones are
/// ignored.
class MarkerBoard {
 public:
  static constexpr std::size_t kMost = 20'000;

  /// ADD adds a marker or replaces the one with the same namespace and number, DELETE removes it, DELETEALL
  /// all.
  void take(const std::vector<Marker>& markers, double now_s);
  /// Removes expired markers; true if there were any.
  bool expire(double now_s);
  /// When the next one expires; infinity: none will.
  double nextEnd() const;
  /// By namespace and number.
  std::vector<Marker> markers() const;

  struct Row {
    Marker marker;               // the one to be seen
    std::optional<Marker> next;  // the newer version, not placed yet
    double until_s = 0;
    double since_s = 0;  // when the waiting one was added
    /// The pose of its frame in the fixed frame when it was placed, and which fixed frame that was.
    std::optional<Transform3> placed;
    std::string fixed_frame;
  };
  /// `take` each, by namespace and number.
  template <typename Take>
  void each(const Take& take) {
    for (auto& [key, row] : rows_) take(row);
  }

 private:
  static void put(Row& row, const Marker& marker, double now_s);
  std::map<std::pair<std::string, std::int64_t>, Row> rows_;
};

}  // namespace mapwright::robot::ros
