// The markers of all topics as they lie in the fixed frame. Source: visualization_msgs/Marker (header,
// lifetime, frame_locked).
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

/// A value; time is handed in. One marker that has no place keeps none of the others from theirs.
class SeenMarkers {
 public:
  static constexpr double kPatienceS = 1;  // for a transform, before its absence is told

  void take(const std::string& topic, const std::vector<Marker>& markers, double now_s);
  void forget(const std::string& topic) { boards_.erase(topic); }
  std::vector<std::string> topics() const;

  struct Look {
    bool changed = false;                   // seen() is another
    std::map<std::string, Fault> unplaced;  // by topic: why a marker that has waited has no place
  };
  /// Places what has no place yet, moves what goes with its frame, takes away what has lived its time.
  Look look(const Transforms& transforms, const std::string& fixed_frame, double now_s);
  /// The last look() has found some without a place.
  bool waits() const { return waits_; }
  /// Some of them go with their frames.
  bool moves() const { return moves_; }
  /// So many that looking at them at every transform, and at the end of each, would be too much.
  bool many() const { return many_; }
  /// When the next one has lived its time, as of the last look(); infinity: none will, or they are many().
  double nextEnd() const { return next_end_s_; }
  /// As they were seen by the last look().
  const map::SeenObjectsMessage& seen() const { return seen_; }

 private:
  std::map<std::string, MarkerBoard> boards_;  // by topic
  map::SeenObjectsMessage seen_;
  bool waits_ = false, moves_ = false, many_ = false;
  double next_end_s_ = std::numeric_limits<double>::infinity();
};

}  // namespace mapwright::robot::ros
