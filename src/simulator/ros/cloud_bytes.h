// Clouds in all layouts used by senders (sensor_msgs/PointCloud2).
#pragma once

#include <string>
#include <vector>

#include "simulator/ros/building.h"
#include "simulator/ros/ros_options.h"
#include "simulator/value.h"

namespace mapwright::simulator::ros {

/// `header` is included unchanged.
Value cloudMessage(Value header, const std::vector<Building::Point>& points, bool colored,
                   const CloudOddities& odd);

}  // namespace mapwright::simulator::ros
