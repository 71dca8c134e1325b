// The capabilities that every ROS robot may have: one object each, on the thread of the robot. They call the
// link on its own thread and return its results.
#pragma once

#include "robot/ros/ros_link.h"
#include "robot/wire/forwarded.h"

namespace mapwright::robot::ros {

class Topics : public wire::TopicsOf<RosLink> {
 public:
  /// `known` is kept up to date by the robot.
  Topics(RosLink* link, const KnownTopics& known) : TopicsOf(link), known_(known) {}
  QStringList known() const override;
  QStringList topicsOf(map::Stream stream) const override;

 private:
  const KnownTopics& known_;
};

}  // namespace mapwright::robot::ros
