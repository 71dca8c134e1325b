// What the simulated robot knows at a moment: its clock, its SLAM session, its list of submaps, where it is.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "map/submap.h"
#include "simulator/scene.h"
#include "simulator/submap_source.h"

namespace mapwright::simulator {

struct ClockOptions {
  double start_at_s = 0;  // simulated seconds
  double speed = 1;       // simulated seconds per real second
  bool paused = false;
};

/// Changes whenever the list of submaps does.
struct ListStamp {
  std::uint64_t edits = 0;
  std::vector<int> scans;  // per trajectory
  bool operator==(const ListStamp&) const = default;
};

/// Safe from any thread. Everything but the clock is a pure function of the scene, the seed and the edits.
class RobotState {
 public:
  RobotState(Scene scene, std::uint32_t seed, ClockOptions clock);

  const FloorPlan& plan() const { return scene_.plan; }
  const Scene& scene() const { return scene_; }
  /// Simulated seconds.
  double time() const;
  std::string uuid() const;
  map::SubmapList list() const;
  ListStamp stamp() const;
  geometry::Pose2 robotPose() const { return poseAhead(0); }
  /// Where the robot will be (or was, when negative) `metres` further on its way.
  geometry::Pose2 poseAhead(double metres) const;
  /// How many scans went into a trajectory so far; 0 when it is not there.
  int scansOf(int trajectory) const;
  /// How far the robot has driven, metres.
  double drivenMetres() const { return kSpeedMPerS * time(); }

  /// The submap as it is now; nullopt when the robot has none of that name.
  std::optional<SubmapSource> find(map::SubmapId id) const;

  void advance(double simulated_s);
  void closeLoop();
  void restartSlam();
  void remove(map::SubmapId id);
  void bump(map::SubmapId id);

 private:
  double now() const;         // simulated seconds
  double sessionNow() const;  // since the SLAM session began
  const Trajectory* trajectoryOf(int id) const;
  SubmapSource describe(const Trajectory& trajectory, int index, int scans) const;
  double metresAtScan(const Trajectory& trajectory, int scan) const;
  int versionOf(map::SubmapId id, int scans) const;
  geometry::Pose3 corrected(const geometry::Pose3& pose, map::SubmapId id) const;
  std::uint64_t seedOf(map::SubmapId id) const;
  geometry::Pose2 anchorOf(const Trajectory& trajectory, int index) const;
  geometry::Pose3 nominalOf(const Trajectory& trajectory, int index) const;
  std::string uuidNow() const;

  mutable std::mutex mutex_;
  const Scene scene_;
  const std::uint32_t seed_;
  const ClockOptions clock_;
  const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  std::map<int, std::vector<geometry::Pose3>> fixed_poses_;  // of the trajectories that no restart changes
  double advanced_s_ = 0;
  double session_began_s_ = 0;
  std::uint64_t session_ = 0;
  std::uint64_t closures_ = 0;
  std::uint64_t edits_ = 0;
  std::set<map::SubmapId> removed_;
  std::map<map::SubmapId, int> bumps_;
};

}  // namespace mapwright::simulator
