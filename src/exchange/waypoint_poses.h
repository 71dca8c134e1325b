// Waypoints as lists of poses, in YAML and JSON: what ROS programs and people write by hand. Pure functions.
#pragma once

#include "exchange/file_value.h"
#include "exchange/wanted_waypoint.h"

namespace mapwright::exchange {

/// Lists of maps ({name, x, y, yaw}, {name, pose: {position, orientation}}, poses with a header, …) or of
/// numbers ([x, y, yaw], …), and maps of such by their names; also inside of maps (waypoints: …). Of a
/// navigation graph of Open-RMF the vertices. `documents`: of one file. The error is a sentence.
WantedFile wantedFromPoses(const std::vector<FileValue>& documents, AngleUnit angles);

}  // namespace mapwright::exchange
