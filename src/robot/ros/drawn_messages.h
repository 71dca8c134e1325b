// Messages that no layer of their own shows, drawn like markers: further paths, outlines, ranges, cells,
// lists of poses, uncertain positions. Source: nav_msgs (Path, GridCells), geometry_msgs (PolygonStamped,
// PoseArray, PointStamped, PoseWithCovarianceStamped), nav2_msgs/ParticleCloud, sensor_msgs/Range. Pure; any
// thread. Messages are untrusted (read_messages.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot/ros/read_messages.h"

namespace mapwright::robot::ros {

/// The types that readDrawn() reads (plainType()).
const std::vector<std::string>& drawnTypes();
bool isDrawn(std::string_view type);

/// One marker that replaces the one before: ADD, or DELETE if there is nothing to be seen (a range without a
/// hit, an empty path). `name`: what it is called. Ellipses of positions hold 95 %.
Read<std::vector<Marker>> readDrawn(std::string_view type, const Field& msg, const std::string& name);

}  // namespace mapwright::robot::ros
