// Kinds of data that a robot sends by itself, independent of the back-end.
#pragma once

#include <set>

namespace mapwright::map {

enum class Stream {
  Pose,         // where the robot is
  Model,        // its outline
  WholeMap,     // the map that the robot uses, as a picture
  Incremental,  // what it is adding to it
  EnvMatch,
  EnvSymmetry,
  CostmapLow,   // coarse and wide
  CostmapHigh,  // fine and near
  MapInfo,      // name, versions, overlays
  Landmarks,
  Doors,
  Pallets,
  Racks,
  SeenObjects,
  Constraints,
  Trajectory,
  Path,
  LocalPath,
  Planning,  // where it goes
  Cloud,     // lidar points
  NearbyRobots,
  NearbyFootprints,
  Battery,
  Wheels,
  Alerts,
  Sensors,
  GlobalPositioning,
};
using Streams = std::set<Stream>;

}  // namespace mapwright::map
