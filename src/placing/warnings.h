// Warnings about waypoints on their map. Pure.
#pragma once

#include <atomic>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "placing/ground.h"

namespace mapwright::map {
struct RobotModel;
}

namespace mapwright::placing {

/// Most severe first.
enum class WarningKind {
  InWall,
  OutsideMap,
  NearWall,   // closer to a wall than the robot's radius
  OnUnknown,  // in an unknown part of the map
  NameTwice,
  ZeroTurn,       // stored with a zero quaternion, so it has no heading
  TemporaryName,  // an interrupted swap of names left it with a temporary name
};

struct Warning {
  WarningKind kind = WarningKind::InWall;
  double distance_m = 0, radius_m = 0;  // NearWall: to the wall, and the robot's radius
  bool operator==(const Warning&) const = default;
};
/// Of one waypoint, most severe first.
using Warnings = std::vector<Warning>;

/// What the map can tell.
enum class GroundState {
  None,     // there is no map
  Unknown,  // the map is unknown everywhere: only its edge is checked
  Known,
};

struct GroundWarnings {
  GroundState state = GroundState::None;
  std::vector<Warnings> of;  // one entry per position, in the same order
};
/// Splits the positions into groups of about `most` neighbours: their indices, each once. If each thread
/// takes a group, few tiles are unpacked twice.
std::vector<std::vector<std::size_t>> groupsOf(const std::vector<Eigen::Vector2d>& places_m,
                                               const map::GridReference& reference, std::size_t most);

/// Checks each position on the map. `radius_m` <= 0: checks for walls only at the position itself. The cost
/// grows with the number of positions; `cancelled` (may be null) ends it early, then unchecked ones have no
/// warnings.
GroundWarnings groundWarnings(const std::vector<Eigen::Vector2d>& places_m, const PlacedMap& map,
                              double radius_m, const std::atomic<bool>* cancelled);

/// The radius of the circle in which a robot with that footprint can turn; 0 = unknown.
double radiusOf(const map::RobotModel& model);
/// The default radius for a robot that does not report its footprint.
inline constexpr double kUsualRadiusM = 0.3;
inline constexpr double kMostRadiusM = 10;

/// The names that several of them have. Empty ones do not count.
std::set<std::string> namesTwice(const std::vector<std::string>& names);

/// All warnings of one waypoint, most severe first.
Warnings together(const Warnings& of_ground, const std::string& name, bool name_twice, bool zero_turn);

}  // namespace mapwright::placing
