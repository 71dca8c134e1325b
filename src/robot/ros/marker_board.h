// The markers of one topic that are to be seen. Source: visualization_msgs/Marker (action, lifetime).
#pragma once

#include <map>
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
  /// By namespace and number.
  std::vector<Marker> markers() const;

 private:
  struct Row {
    Marker marker;
    double until_s = 0;
  };
  std::map<std::pair<std::string, std::int64_t>, Row> rows_;
};

}  // namespace mapwright::robot::ros
