// Binary point clouds. Pure function, any thread. Source: docs/protocols/autoxing.md, "Point clouds".
#pragma once

#include <string>

#include "map/live_topics.h"

namespace ros_messages {
class PointCloud;
}

namespace mapwright::robot::axbot {

/// The points of a PointCloud message, in the world frame; at most 2 million.
map::TopicMessage readCloud(const std::string& topic, const ros_messages::PointCloud& message);

}  // namespace mapwright::robot::axbot
