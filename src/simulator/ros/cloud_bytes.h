// Clouds of points as senders of all kinds lay them down (sensor_msgs/PointCloud2).
#pragma once

#include <string>
#include <vector>

#include "simulator/ros/building.h"
#include "simulator/ros/ros_options.h"
#include "simulator/value.h"

namespace mapwright::simulator::ros {

/// `header` goes into it as it is.
Value cloudMessage(Value header, const std::vector<Building::Point>& points, bool colored,
                   const CloudOddities& odd);

}  // namespace mapwright::simulator::ros
