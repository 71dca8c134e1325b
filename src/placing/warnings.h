// What is doubtful about waypoints on the map that they lie on. Pure.
#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

#include "placing/ground.h"

namespace mapwright::map {
struct RobotModel;
}

namespace mapwright::placing {

/// In the order of gravity.
enum class WarningKind {
  InWall,
  OutsideMap,
  NearWall,   // closer to a wall than the robot's radius
  OnUnknown,  // on ground that the map knows nothing of
  NameTwice,
  ZeroTurn,       // it is kept with a quaternion of zero, which is no heading
  TemporaryName,  // a swap of names that broke off has left it a temporary name
};

struct Warning {
  WarningKind kind = WarningKind::InWall;
  double distance_m = 0, radius_m = 0;  // NearWall: to the wall, and the robot's
  bool operator==(const Warning&) const = default;
};
/// Of one waypoint, the gravest first.
using Warnings = std::vector<Warning>;

/// How far the ground can tell anything.
enum class GroundState {
  None,     // there is no map
  Unknown,  // the map knows nothing anywhere: only its edge is looked at
  Known,
};

struct GroundWarnings {
  GroundState state = GroundState::None;
  std::vector<Warnings> of;  // each place's, in their order; as long as they are
};
/// The places in groups of about `most` that lie together on the map: their numbers, each once. For several
/// threads, each with a group, few tiles are unpacked twice.
std::vector<std::vector<std::size_t>> groupsOf(const std::vector<Eigen::Vector2d>& places_m,
                                               const map::GridReference& reference, std::size_t most);

/// What the ground says of each place. `radius_m` <= 0: walls are looked for nowhere but under the place.
/// Costs as much as there are places; `cancelled` (may be null) ends it early, then what was not looked at
/// has none.
GroundWarnings groundWarnings(const std::vector<Eigen::Vector2d>& places_m, const PlacedMap& map,
                              double radius_m, const std::atomic<bool>* cancelled);

/// The radius of the circle in which a robot of that shape can turn; 0 = it is not known.
double radiusOf(const map::RobotModel& model);
/// What a robot is taken to be that does not tell its shape, until somebody says otherwise.
inline constexpr double kUsualRadiusM = 0.3;
inline constexpr double kMostRadiusM = 10;

/// All that holds of one waypoint, the gravest first.
Warnings together(const Warnings& of_ground, const std::string& name, bool name_twice, bool zero_turn);

}  // namespace mapwright::placing
