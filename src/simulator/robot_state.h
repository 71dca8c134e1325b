// What the simulated robot knows at a moment: its clock, its SLAM session, its list of submaps, where it is.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
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

/// What a SLAM session is for.
enum class Mapping {
  Off,      // the robot finds its place in a finished map
  New,      // a map from nothing
  Continue  // more of the finished map
};

/// The part of the live trajectory that the running mapping has driven.
struct MappingSpan {
  Mapping mapping = Mapping::New;
  double from_m = 0;  // along the drive
  int scans = 0;
};

/// What people and programs have set, over what the robot would do by itself.
struct Controls {
  std::optional<std::string> control_mode;  // auto, manual, remote
  std::optional<bool> emergency_stop;
};

/// Safe from any thread. Everything but the clock is a pure function of the scene, the seed and the edits.
class RobotState {
 public:
  RobotState(Scene scene, std::uint32_t seed, ClockOptions clock);

  /// This robot as a bag has it: at a simulated moment that stands still, without any edits.
  RobotState recordedAt(double time_s) const;

  const FloorPlan& plan() const { return scene_->plan; }
  const Scene& scene() const { return *scene_; }
  /// Simulated seconds.
  double time() const;
  std::string uuid() const;
  map::SubmapList list() const;
  ListStamp stamp() const;
  geometry::Pose2 robotPose() const { return poseAhead(0); }
  /// Where the robot will be (or was, when negative) `metres` further on its way.
  geometry::Pose2 poseAhead(double metres) const;
  /// How the robot believes to stand in the world, seen from where it does: moved by setPose(), put right by
  /// relocate().
  geometry::Pose2 misplacement() const;
  /// Whether what the robot sees fits what it believes.
  bool isPositioned() const;
  map::SlamState slamState() const;
  Controls controls() const;
  /// The running mapping; nullopt when there is none.
  std::optional<MappingSpan> mapping() const;
  /// Whether there is anything to drive through with a lidar.
  bool canMap() const { return trajectoryOf(1) != nullptr; }
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
  /// The robot believes to be there from now on; with `adjust`, what is nearly right is put right.
  void setPose(const geometry::Pose2& pose, bool adjust);
  void relocate();
  /// Begins and ends mappings: each is a SLAM session of its own.
  void setMapping(Mapping mapping);
  void setControlMode(std::string mode);
  void setEmergencyStop(bool pressed);

 private:
  using FixedPoses = std::map<int, std::vector<geometry::Pose3>>;

  RobotState(std::shared_ptr<const Scene> scene, std::uint32_t seed, ClockOptions clock,
             std::shared_ptr<const FixedPoses> fixed_poses);
  void beginSession();
  bool isThere(const Trajectory& trajectory) const;
  std::pair<int, int> submapsOf(const Trajectory& trajectory, int scans) const;
  geometry::Pose2 truePoseAhead(double metres) const;
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
  const std::shared_ptr<const Scene> scene_;
  const std::uint32_t seed_;
  const ClockOptions clock_;
  const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  std::shared_ptr<const FixedPoses> fixed_poses_;  // of the trajectories that no restart changes
  double advanced_s_ = 0;
  double session_began_s_ = 0;
  std::uint64_t session_ = 0;
  std::uint64_t closures_ = 0;
  std::uint64_t edits_ = 0;
  std::set<map::SubmapId> removed_;
  std::map<map::SubmapId, int> bumps_;
  geometry::Pose2 misplacement_;
  Mapping mapping_ = Mapping::Off;
  Controls controls_;
};

}  // namespace mapwright::simulator
