// The ROS content of a recording: which topics provide what, and the frame for everything.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "recording/source.h"
#include "robot/recorded/message_fields.h"
#include "robot/ros/ros_topics.h"

namespace mapwright::robot::recorded {

/// A value. Topics by the purpose of their messages; a topic may be in several lists.
struct RosShape {
  bool isRos(const recording::Channel& channel) const { return recorded::isRos(channel, untyped_ros); }

  std::vector<ros::Source> sources;  // better ones of a stream first
  std::map<std::string, std::vector<ros::Source>> by_topic;
  std::vector<std::string> transforms;  // /tf and /tf_static
  std::vector<std::string> statics;     // of these, what never changes
  std::vector<std::string> poses;       // poses given without transforms
  std::vector<std::string> markers;
  std::map<std::string, std::string> patches_of;  // by grid topic: the topic of its patches
  /// One for the whole file, so that the result for a message does not depend on what was read before: that
  /// of its first map; without a map `map` if transforms mention it, otherwise the root of the robot's own
  /// frames at the start of the file; otherwise the frame of its first scan.
  std::string fixed_frame;
  bool own_frame = false;      // it is that of the first scan
  bool fixed_by_file = false;  // false: the file does not tell (yet), `map` is assumed

  /// The robot speaks ROS: topics without a type are recognised by their usual names.
  bool untyped_ros = false;

  std::vector<ros::Endpoint> found;  // every topic of ROS
  /// RobotTransforms::setNamespaces(): the first one is the robot that is shown.
  std::vector<std::string> robots;
  bool root_serves = false;  // RobotTransforms::rootServesAll() at the start of the file
  std::string ns;            // of the robot that was asked for
  bool any() const { return !sources.empty(); }
};

/// `choices`: topics chosen by the user; `ns`: the robot's namespace, empty = none was given.
RosShape shapeOf(recording::Source& file, MessageFields& fields, const ros::Choices& choices,
                 const std::string& ns = {});

/// The robots in the file by their namespaces ("/" without one), if there are several: those with transforms
/// of their own, or with frames like "robot1/base_link".
std::vector<std::string> robotNames(recording::Source& file, MessageFields& fields, const RosShape& shape);

}  // namespace mapwright::robot::recorded
