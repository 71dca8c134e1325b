// The markers of one topic that are to be seen. Source: visualization_msgs/Marker (action, lifetime).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot/ros/read_messages.h"

namespace mapwright::robot::ros {

/// A value; time is handed in (seconds, any clock that goes on). At most kMost markers: what comes beyond
/// that is not taken.
class MarkerBoard {
 public:
  static constexpr std::size_t kMost = 20'000;

  /// ADD puts a marker or replaces the one of its namespace and number, DELETE takes it away, DELETEALL all.
  void take(const std::vector<Marker>& markers, double now_s);
  /// Takes away what has lived its time; true when anything has.
  bool expire(double now_s);
  /// When the next one has lived its time; infinity: none will.
  double nextEnd() const;
  /// By namespace and number.
  std::vector<Marker> markers() const;

  struct Row {
    Marker marker;               // the one to be seen
    std::optional<Marker> next;  // as it has been sent since, not placed yet
    double until_s = 0;
    double since_s = 0;  // when the one that waits for its place was put
    /// Where its frame lay in the fixed one when it was placed, and which one that was.
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
