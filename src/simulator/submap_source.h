// One submap of the simulated robot: everything that its answer is made from.
#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "map/submap.h"
#include "simulator/floor_plan.h"
#include "simulator/scan_grid.h"

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

/// The serialised SubmapQueryV2Response. Pure; about a millisecond.
std::string makeSubmapBody(const FloorPlan& plan, const SubmapSource& source);

/// Recently made bodies within a budget of bytes. Safe from any thread.
class BodyCache {
 public:
  explicit BodyCache(std::size_t budget_bytes) : budget_(budget_bytes) {}
  std::shared_ptr<const std::string> bodyOf(const FloorPlan& plan, const SubmapSource& source);

 private:
  struct Key {
    std::uint64_t session;
    map::SubmapId id;
    std::int32_t version;
    auto operator<=>(const Key&) const = default;
  };
  struct Entry {
    Key key;
    std::shared_ptr<const std::string> body;
  };

  std::mutex mutex_;
  std::size_t budget_;
  std::size_t bytes_ = 0;
  std::list<Entry> entries_;  // newest first
  std::map<Key, std::list<Entry>::iterator> by_key_;
};

}  // namespace mapwright::simulator
