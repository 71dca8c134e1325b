// What a recording holds of ROS: which topics bring what, and in which frame all of it is placed.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "recording/source.h"
#include "robot/recorded/message_fields.h"
#include "robot/ros/ros_topics.h"

namespace mapwright::robot::recorded {

/// A value. Topics by what their messages are for; a topic may be in several lists.
struct RosShape {
  bool isRos(const recording::Channel& channel) const { return recorded::isRos(channel, untyped_ros); }

  std::vector<ros::Source> sources;  // the better ones of a stream first
  std::map<std::string, std::vector<ros::Source>> by_topic;
  std::vector<std::string> transforms;  // /tf and /tf_static
  std::vector<std::string> statics;     // of these, what never changes
  std::vector<std::string> poses;       // poses that are told without transforms
  std::vector<std::string> markers;
  std::map<std::string, std::string> patches_of;  // by topic of the grid: that of its patches
  /// One for the whole file, so that no message is placed otherwise because another was read before: that of
  /// its first map; without a map `map` where transforms name it, else the root of the robot's own frames at
  /// the beginning of the file; where neither tells, what its first scan lies in.
  std::string fixed_frame;
  bool own_frame = false;      // it is that of the first scan
  bool fixed_by_file = false;  // false: the file has not told yet, `map` is assumed

  /// The robot speaks ROS: what has no type is taken by its usual name.
  bool untyped_ros = false;

  std::vector<ros::FoundTopic> found;  // every topic of ROS
  bool any() const { return !sources.empty(); }
};

/// `choices`: topics that people have chosen.
RosShape shapeOf(recording::Source& file, MessageFields& fields, const ros::Choices& choices);

}  // namespace mapwright::robot::recorded
