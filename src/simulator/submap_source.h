// One submap of the simulated robot: everything that its answer is made from.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "map/submap.h"
#include "ros_messages/slam.pb.h"
#include "simulator/cache.h"
#include "simulator/floor_plan.h"
#include "simulator/lidar.h"

namespace mapwright::simulator {

/// A recipe: the same recipe gives the same bytes.
struct SubmapSource {
  map::SubmapId id;
  std::int32_t version = 0;
  std::uint64_t seed = 0;     // of the submap's own traits and noise
  std::uint64_t session = 0;  // counts SLAM restarts: another session's submap is another content
  bool nearby = false;
  bool shared = false;     // many submaps look like this one: small, and packed as robots pack
  geometry::Pose3 pose;    // before any loop closure; slice poses are relative to it
  geometry::Pose2 anchor;  // where its first scan was taken; its yaw is the texture's heading
  std::vector<ScanPlace> scans;
  std::vector<Solid> extra;  // what came to stand there since
};

/// The pose in the list for a submap that begins at `anchor`. Of every four submaps one is tilted and lifted
/// as 3D SLAM leaves them, and one is turned against its texture.
geometry::Pose3 nominalPose(const geometry::Pose2& anchor, map::SubmapId id, std::uint64_t seed);

ros_messages::Pose messageOf(const geometry::Pose3& pose);

/// The serialised SubmapQueryV2Response. Pure; about a millisecond.
std::string makeSubmapBody(const FloorPlan& plan, const SubmapSource& source);

/// What tells bodies apart.
struct BodyKey {
  std::uint64_t session;
  map::SubmapId id;
  std::int32_t version;
  bool operator==(const BodyKey&) const = default;
};
using BodyCache = Cache<BodyKey, std::shared_ptr<const std::string>>;

}  // namespace mapwright::simulator
