// The state of the simulated robot: its clock, SLAM session, submap list and pose.
#pragma once

#include <chrono>
#include <cmath>
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

/// Seconds since the epoch of a simulated second, as the robot's clock shows it: its world begins on 3 June
/// 2024, 09:00 UTC.
constexpr double stampOf(double time_s) { return 1717405200 + time_s; }
/// Its date and time in UTC, as strftime() writes them.
std::string dateOf(double time_s, const char* format);

constexpr double kGoalM = 40;  // from one goal of the robot to the next

struct ClockOptions {
  double start_at_s = 0;  // simulated seconds
  double speed = 1;       // simulated seconds per real second
  bool paused = false;
};

/// Changes with the list of submaps.
struct ListStamp {
  std::uint64_t edits = 0;
  std::vector<int> scans;  // per trajectory
  bool operator==(const ListStamp&) const = default;
};

/// The purpose of a SLAM session.
enum class Mapping {
  Off,      // localization in a finished map
  New,      // a map from nothing
  Continue  // more of the finished map
};

/// The part of the live trajectory driven during the running mapping.
struct MappingSpan {
  Mapping mapping = Mapping::New;
  double from_m = 0;  // along the drive
  int scans = 0;
};

/// Settings by clients that override the robot's own behaviour.
struct Controls {
  std::optional<std::string> control_mode;  // auto, manual, remote
  std::optional<bool> emergency_stop;
};

/// Safe from any thread. Everything except the clock is a pure function of scene, seed and edits.
class RobotState {
 public:
  RobotState(Scene scene, std::uint32_t seed, ClockOptions clock);

  /// This robot as recorded in a bag: frozen at a simulated time, without any edits.
  RobotState recordedAt(double time_s) const;

  const FloorPlan& plan() const { return scene_->plan; }
  const Scene& scene() const { return *scene_; }
  /// Simulated seconds.
  double time() const;
  std::string uuid() const;
  map::SubmapList list() const;
  ListStamp stamp() const;
  geometry::Pose2 robotPose() const { return poseAhead(0); }
  /// Where the robot will be (or was, if negative) `metres` further along its route.
  geometry::Pose2 poseAhead(double metres) const;
  /// The error of the robot's pose: set by setPose(), corrected by relocate().
  geometry::Pose2 misplacement() const;
  /// Whether the robot's scans match its pose.
  bool isPositioned() const;
  map::SlamState slamState() const;
  Controls controls() const;
  /// The running mapping; nullopt if there is none.
  std::optional<MappingSpan> mapping() const;
  /// Whether there is anything to map.
  bool canMap() const { return scene_->find(1) != nullptr; }
  /// How many scans a trajectory has so far; 0 if it does not exist.
  int scansOf(int trajectory) const;
  /// How far the robot has driven, metres.
  double drivenMetres() const { return kSpeedMPerS * time(); }
  /// To the present goal: one comes after the other.
  double metresToGoal() const {
    const double driven = drivenMetres();
    return kGoalM - (driven - kGoalM * std::floor(driven / kGoalM));
  }

  /// The present version of the submap; nullopt if there is none with that id.
  std::optional<SubmapSource> find(map::SubmapId id) const;

  void advance(double simulated_s);
  void closeLoop();
  void restartSlam();
  void remove(map::SubmapId id);
  void bump(map::SubmapId id);
  /// Sets the robot's pose; with `adjust`, an almost correct one is corrected.
  void setPose(const geometry::Pose2& pose, bool adjust);
  /// Looks for where the robot is. `asks`: what it finds is only proposed.
  void relocate(bool asks);
  /// The last search; nullopt: there was none.
  struct Search {
    bool running = false, asks = false;
    geometry::Pose2 found;
  };
  std::optional<Search> search() const;
  /// Starts and ends mappings: each is a SLAM session of its own.
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
  std::shared_ptr<const FixedPoses> fixed_poses_;  // of the trajectories that restarts do not change
  double advanced_s_ = 0;
  double session_began_s_ = 0;
  std::uint64_t session_ = 0;
  std::uint64_t closures_ = 0;
  std::uint64_t edits_ = 0;
  std::set<map::SubmapId> removed_;
  std::map<map::SubmapId, int> bumps_;
  geometry::Pose2 misplacement_;
  std::optional<double> searched_at_s_;
  bool search_asks_ = false;
  Mapping mapping_ = Mapping::Off;
  Controls controls_;
};

}  // namespace mapwright::simulator
