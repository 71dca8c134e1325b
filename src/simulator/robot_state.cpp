#include "simulator/robot_state.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/noise.h"

namespace mapwright::simulator {
namespace {

constexpr int kFullVersion = kScansPerSubmap;

map::SlamState slamStateOf(const Scene& scene) {
  return scene.trajectories.empty() ? map::SlamState::Slam : map::SlamState::Positioning;
}

/// How a loop closure moves a submap: rigidly in the plane, turning about the submap's own origin.
struct Correction {
  double dx = 0, dy = 0, dyaw = 0;
};

/// The frozen map moves by centimetres, the live trajectory by up to half a metre and a degree and a half;
/// neighbours move alike.
Correction correctionOf(std::uint64_t seed, std::uint64_t closures, map::SubmapId id) {
  if (closures == 0) return {};
  Dice dice(hashOf(seed, 23, closures, id.trajectory));
  const double reach = id.trajectory == 1 ? 0.34 : id.trajectory == 0 ? 0.05 : 0.15;
  const double turn = id.trajectory == 1 ? 0.026 : 0.004;
  const double phase = dice.uniform(0, 2 * std::numbers::pi) + 0.12 * id.index;
  return {reach * dice.uniform(0.6, 1) * std::cos(phase), reach * dice.uniform(0.6, 1) * std::sin(phase),
          turn * dice.uniform(0.5, 1) * (dice.chance(0.5) ? 1 : -1) * std::cos(0.09 * id.index)};
}

}  // namespace

RobotState::RobotState(Scene scene, std::uint32_t seed, ClockOptions clock)
    : scene_(std::move(scene)), seed_(seed), clock_(clock) {
  for (const Trajectory& trajectory : scene_.trajectories) {
    if (trajectory.growth == Growth::Live) continue;
    std::vector<geometry::Pose3>& poses = fixed_poses_[trajectory.id];
    for (int index = 0; index < trajectory.submaps; ++index) {
      const map::SubmapId id{trajectory.id, index};
      poses.push_back(nominalPose(anchorOf(trajectory, index), id, seedOf(id)));
    }
  }
}

geometry::Pose3 RobotState::nominalOf(const Trajectory& trajectory, int index) const {
  const map::SubmapId id{trajectory.id, index};
  const auto fixed = fixed_poses_.find(trajectory.id);
  if (fixed != fixed_poses_.end()) return fixed->second[static_cast<std::size_t>(index)];
  return nominalPose(anchorOf(trajectory, index), id, seedOf(id));
}

double RobotState::now() const {
  double t = clock_.start_at_s + advanced_s_;
  if (!clock_.paused) {
    t += clock_.speed * std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  }
  return t;
}

double RobotState::sessionNow() const { return now() - session_began_s_; }

std::string RobotState::uuid() const {
  const std::lock_guard lock(mutex_);
  return uuidNow();
}

std::string RobotState::uuidNow() const {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  Dice dice(hashOf(seed_, 31, session_));
  for (int i = 0; i < 24; ++i) text += kDigits[dice.next() & 15];
  return text;
}

const Trajectory* RobotState::trajectoryOf(int id) const {
  for (const Trajectory& trajectory : scene_.trajectories) {
    if (trajectory.id == id) return &trajectory;
  }
  return nullptr;
}

std::uint64_t RobotState::seedOf(map::SubmapId id) const {
  const Trajectory* owner = trajectoryOf(id.trajectory);
  const std::uint64_t session = owner != nullptr && owner->growth == Growth::Live ? session_ : 0;
  return hashOf(seed_, 41, session, id.trajectory, id.index);
}

double RobotState::metresAtScan(const Trajectory& trajectory, int scan) const {
  if (trajectory.growth != Growth::Live) return kScanStepM * scan;
  // The session's first scans were taken just before it was published.
  return kSpeedMPerS * std::floor(session_began_s_) + kScanStepM * (scan - 8);
}

int RobotState::versionOf(map::SubmapId id, int scans) const {
  const auto bumped = bumps_.find(id);
  return std::clamp(scans - kScansPerSubmapStart * id.index, 0, kFullVersion) +
         (bumped == bumps_.end() ? 0 : bumped->second);
}

geometry::Pose2 RobotState::anchorOf(const Trajectory& trajectory, int index) const {
  const geometry::Pose2 first = trajectory.drive.at(metresAtScan(trajectory, kScansPerSubmapStart * index));
  const double yaw = unitFrom(hashOf(seedOf({trajectory.id, index}), 7)) * 2 * std::numbers::pi;
  return {first.x_m, first.y_m, geometry::normalizeAngle(yaw)};
}

geometry::Pose3 RobotState::corrected(const geometry::Pose3& pose, map::SubmapId id) const {
  if (closures_ == 0) return pose;
  const Correction correction = correctionOf(seed_, closures_, id);
  const Eigen::Quaterniond q = Eigen::AngleAxisd(correction.dyaw, Eigen::Vector3d::UnitZ()) *
                               Eigen::Quaterniond(pose.qw, pose.qx, pose.qy, pose.qz);
  return {pose.x + correction.dx, pose.y + correction.dy, pose.z, q.x(), q.y(), q.z(), q.w()};
}

map::SubmapList RobotState::list() const {
  map::SubmapList list;
  list.slam_state = slamStateOf(scene_);
  const std::lock_guard lock(mutex_);
  list.uuid = uuidNow();
  for (const Trajectory& trajectory : scene_.trajectories) {
    const int scans = trajectory.scansAt(sessionNow());
    const auto [first, end] = trajectory.submapsAfter(scans);
    const bool whole =
        trajectory.growth != Growth::Live && scans >= kScansPerSubmapStart * (trajectory.submaps + 1);
    for (int index = first; index < end; ++index) {
      const map::SubmapId id{trajectory.id, index};
      if (removed_.contains(id)) continue;
      list.entries.push_back({id, versionOf(id, scans), corrected(nominalOf(trajectory, index), id), whole,
                              trajectory.incremental, trajectory.nearby});
    }
  }
  return list;
}

ListStamp RobotState::stamp() const {
  const std::lock_guard lock(mutex_);
  ListStamp stamp;
  stamp.edits = edits_;
  for (const Trajectory& trajectory : scene_.trajectories)
    stamp.scans.push_back(trajectory.scansAt(sessionNow()));
  return stamp;
}

double RobotState::time() const {
  const std::lock_guard lock(mutex_);
  return now();
}

int RobotState::scansOf(int id) const {
  const std::lock_guard lock(mutex_);
  const Trajectory* found = trajectoryOf(id);
  return found == nullptr ? 0 : found->scansAt(sessionNow());
}

geometry::Pose2 RobotState::poseAhead(double metres) const {
  const std::lock_guard lock(mutex_);
  const Trajectory* live = trajectoryOf(1);
  if (live == nullptr) return {};
  const int newest = live->submapsAfter(live->scansAt(sessionNow())).second - 1;
  geometry::Pose2 pose = live->drive.at(kSpeedMPerS * now() + metres);
  const geometry::Pose2 origin = anchorOf(*live, newest);
  const Correction correction = correctionOf(seed_, closures_, {1, newest});
  // The robot is where its newest submap says it is.
  const geometry::Pose2 turned = geometry::Pose2{0, 0, correction.dyaw} *
                                 geometry::Pose2{pose.x_m - origin.x_m, pose.y_m - origin.y_m, pose.yaw_rad};
  return {origin.x_m + correction.dx + turned.x_m, origin.y_m + correction.dy + turned.y_m, turned.yaw_rad};
}

SubmapSource RobotState::describe(const Trajectory& trajectory, int index, int scans) const {
  SubmapSource source;
  source.id = {trajectory.id, index};
  source.version = versionOf(source.id, scans);
  source.session = session_;
  source.seed = seedOf(source.id);
  source.nearby = trajectory.nearby;
  source.anchor = anchorOf(trajectory, index);
  source.pose = nominalOf(trajectory, index);
  const int first = kScansPerSubmapStart * index;
  for (int scan = first; scan < std::min(scans, first + kScansPerSubmap); ++scan) {
    source.scans.push_back(
        {trajectory.drive.at(metresAtScan(trajectory, scan)), hashOf(seed_, trajectory.id, scan)});
  }
  const auto bumped = bumps_.find(source.id);
  for (int i = 0; bumped != bumps_.end() && i < std::min(bumped->second, 64) && !source.scans.empty(); ++i) {
    // A crate at the side of the way for each new version.
    const geometry::Pose2& by = source.scans[static_cast<std::size_t>(i * 5 + 2) % source.scans.size()].pose;
    const Eigen::Vector2d at = by.apply({0.3, i % 2 == 0 ? 0.85 : -0.85});
    source.extra.push_back({at, {0.25, 0.25}, by.yaw_rad, false, true});
  }
  return source;
}

std::optional<SubmapSource> RobotState::find(map::SubmapId id) const {
  const std::lock_guard lock(mutex_);
  const Trajectory* owner = trajectoryOf(id.trajectory);
  if (owner == nullptr || removed_.contains(id)) return std::nullopt;
  const int scans = owner->scansAt(sessionNow());
  const auto [first, end] = owner->submapsAfter(scans);
  if (id.index < first || id.index >= end) return std::nullopt;
  return describe(*owner, id.index, scans);
}

void RobotState::advance(double simulated_s) {
  const std::lock_guard lock(mutex_);
  if (std::isfinite(simulated_s) && simulated_s > 0) advanced_s_ += simulated_s;
}

void RobotState::closeLoop() {
  const std::lock_guard lock(mutex_);
  ++closures_;
  ++edits_;
}

void RobotState::restartSlam() {
  const std::lock_guard lock(mutex_);
  ++session_;
  ++edits_;
  closures_ = 0;
  session_began_s_ = now();
  removed_.clear();
  bumps_.clear();
}

void RobotState::remove(map::SubmapId id) {
  const std::lock_guard lock(mutex_);
  removed_.insert(id);
  ++edits_;
}

void RobotState::bump(map::SubmapId id) {
  const std::lock_guard lock(mutex_);
  ++bumps_[id];
  ++edits_;
}

}  // namespace mapwright::simulator
