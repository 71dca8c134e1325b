// The robot's messages about itself and its surroundings (docs/protocols/autoxing.md, "Topics that the map
// shows"). Pure functions of the robot's present state.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "map/submap.h"
#include "simulator/robot_state.h"
#include "simulator/stored_map.h"

namespace mapwright::simulator {

/// As these robots write it.
std::string_view nameOf(map::SlamState state);

/// /tracked_pose, /slam/state, /path, /planning_state, /alerts, /battery_state, /wheel_state, ...; nullopt
/// for other topics, and for those that need a map if there is none. `map` is the current one.
std::optional<std::string> ownTopic(std::string_view topic, const RobotState& state,
                                    const std::optional<StoredMap>& map);

/// /nearby_robots, /landmarks, /nearby_auto_doors, /detected_pallets, /constraint_list, ...
std::optional<std::string> surroundingsTopic(std::string_view topic, const RobotState& state);

}  // namespace mapwright::simulator
