// Named positions that a robot can be sent to. Source: docs/protocols/agibot-aimdk.md, "Methods",
// docs/protocols/kabam-map-manager.md, "Topics".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fault/fault.h"

namespace mapwright::map {

/// A position in world metres. Names, types and tags are untrusted plain text; ids keep every digit.
struct Waypoint {
  std::string id, name, type;
  Eigen::Vector2d position_m{0, 0};
  std::optional<double> yaw_rad = {};
  std::vector<std::string> tags = {};
  /// The stored form, including what is not understood here. Only the store's reader and writer use it; empty
  /// = not stored yet.
  std::string source = {};
  bool operator==(const Waypoint&) const = default;
};

/// The waypoints of one map. `notes`: warnings about them.
struct WaypointList {
  std::vector<Waypoint> points;
  std::vector<Fault> notes;
};

}  // namespace mapwright::map
