// What the robot tells about itself: where it goes, how it is. And about what is around it
// (axbot.md, "Topics that the map shows"). Pure functions of the robot's state at the moment.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "simulator/map_library.h"
#include "simulator/robot_state.h"

namespace mapwright::simulator {

/// /path, /local_path, /trajectory, /planning_state, /alerts, /battery_state, /wheel_state, ...; nullopt for
/// other topics and for a robot without a map.
std::optional<std::string> ownTopic(std::string_view topic, const RobotState& state,
                                    const MapLibrary& library);

/// /nearby_robots, /landmarks, /nearby_auto_doors, /detected_pallets, /constraint_list, ...
std::optional<std::string> surroundingsTopic(std::string_view topic, const RobotState& state);

}  // namespace mapwright::simulator
