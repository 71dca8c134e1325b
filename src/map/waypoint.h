// Named places that a robot can be sent to. Source: aimdk.md (GetTopoMsgs).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace mapwright::map {

/// A place in world metres. Names are untrusted plain text; ids keep every digit.
struct Waypoint {
  std::string id, name, type;
  Eigen::Vector2d position_m{0, 0};
  std::optional<double> yaw_rad;
  bool operator==(const Waypoint&) const = default;
};

/// The places of one map. `notes`: what is odd about them, one sentence each.
struct WaypointList {
  std::vector<Waypoint> points;
  std::vector<std::string> notes;
};

}  // namespace mapwright::map
