// The markers of all topics in the fixed frame. Source: visualization_msgs/Marker (action, header, lifetime,
// frame_locked).
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fault/fault.h"
#include "map/live_topics.h"
#include "robot/ros/read_messages.h"
#include "robot/ros/robot_transforms.h"

namespace mapwright::robot::ros {

/// A value; time is passed in (seconds, any monotonic clock). A marker that cannot be placed does not block
/// the others. At most kMost of a topic: further ones are ignored.
class SeenMarkers {
 public:
  static constexpr std::size_t kMost = 20'000;
  static constexpr double kLongestWaitS =
      1;  // how long to wait for a transform before it is reported as missing

  /// ADD adds a marker or replaces the one with the same namespace and number, DELETE removes it, DELETEALL
  /// all.
  void apply(const std::string& topic, const std::vector<Marker>& markers, double now_s);
  /// The same, and places what can be placed at once; the rest waits for look().
  void settle(const std::string& topic, const std::vector<Marker>& markers, const RobotTransforms& transforms,
              const std::string& fixed_frame, double now_s);
  void forget(const std::string& topic) { topics_.erase(topic); }
  std::vector<std::string> topics() const;

  struct Look {
    bool changed = false;                   // seen() is another
    std::map<std::string, Fault> unplaced;  // by topic: how many that have waited cannot be placed, and why
  };
  /// Places new markers, moves frame-locked ones, removes expired ones.
  Look look(const RobotTransforms& transforms, const std::string& fixed_frame, double now_s);
  /// The last look() left some unplaced.
  bool waits() const { return !waiting_.empty(); }
  /// How many, by topic.
  const std::map<std::string, int>& waiting() const { return waiting_; }
  /// Some of them move with their frames.
  bool moves() const { return moves_; }
  /// There are too many to update at every transform and every expiry.
  bool many() const { return many_; }
  /// When the next one expires, as of the last look(); infinity: none will, or there are many().
  double nextEnd() const { return next_end_s_; }
  /// The markers as of the last look().
  const map::SeenObjectsMessage& seen() const { return seen_; }

 private:
  struct Row {
    Marker marker;               // the one to be seen
    std::optional<Marker> next;  // the newer version, not placed yet
    double until_s = 0;
    double since_s = 0;  // when the waiting one was added
    /// The pose of its frame in the fixed frame when it was placed, and which fixed frame that was.
    std::optional<Transform3> placed;
    std::string fixed_frame;
  };
  static void put(Row& row, const Marker& marker, double now_s);
  static std::optional<Fault> place(Row& row, const std::string& topic, const RobotTransforms& transforms,
                                    const std::string& fixed);

  std::map<std::string, std::map<std::pair<std::string, std::int64_t>, Row>>
      topics_;  // by namespace and number
  map::SeenObjectsMessage seen_;
  std::map<std::string, int> waiting_;  // by topic
  bool moves_ = false, many_ = false;
  double next_end_s_ = std::numeric_limits<double>::infinity();
};

}  // namespace mapwright::robot::ros
