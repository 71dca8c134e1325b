// The markers of all topics in the fixed frame. Source: visualization_msgs/Marker (header, lifetime,
// frame_locked).
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "fault/fault.h"
#include "map/live_topics.h"
#include "robot/ros/marker_board.h"
#include "robot/ros/transforms.h"

namespace mapwright::robot::ros {

/// A value; time is passed in. A marker that cannot be placed does not block the others.
class SeenMarkers {
 public:
  static constexpr double kPatienceS =
      1;  // how long to wait for a transform before it is reported as missing

  void take(const std::string& topic, const std::vector<Marker>& markers, double now_s);
  void forget(const std::string& topic) { boards_.erase(topic); }
  std::vector<std::string> topics() const;

  struct Look {
    bool changed = false;                   // seen() is another
    std::map<std::string, Fault> unplaced;  // by topic: why a marker that has waited cannot be placed
  };
  /// Places new markers, moves frame-locked ones, removes expired ones.
  Look look(const Transforms& transforms, const std::string& fixed_frame, double now_s);
  /// The last look() left some unplaced.
  bool waits() const { return waits_; }
  /// Some of them move with their frames.
  bool moves() const { return moves_; }
  /// There are too many to update at every transform and every expiry.
  bool many() const { return many_; }
  /// When the next one expires, as of the last look(); infinity: none will, or there are many().
  double nextEnd() const { return next_end_s_; }
  /// The markers as of the last look().
  const map::SeenObjectsMessage& seen() const { return seen_; }

 private:
  std::map<std::string, MarkerBoard> boards_;  // by topic
  map::SeenObjectsMessage seen_;
  bool waits_ = false, moves_ = false, many_ = false;
  double next_end_s_ = std::numeric_limits<double>::infinity();
};

}  // namespace mapwright::robot::ros
