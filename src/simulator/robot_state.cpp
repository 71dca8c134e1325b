#include "simulator/robot_state.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

#include "simulator/noise.h"

namespace mapwright::simulator {
namespace {

constexpr int kFullVersion = kScansPerSubmap;
constexpr int kScansAtStart = 8;  // a session's first scans were taken just before it was published
constexpr double kLostM = 0.5, kLostRad = 0.3;  // beyond it, the lidar does not fit the map
constexpr double kSearchS = 2;
constexpr double kAdjustableM = 1.5, kAdjustableRad = 0.8;  // up to here, a given pose can be put right

/// How a loop closure moves a submap, which turns about its own origin. The frozen map moves by centimetres,
/// the live trajectory by up to half a metre and a degree and a half; neighbours move alike.
geometry::Pose2 correctionOf(std::uint64_t seed, std::uint64_t closures, map::SubmapId id) {
  if (closures == 0) return {};
  Dice dice(hashOf(seed, 23, closures, id.trajectory));
  const double reach = id.trajectory == 1 ? 0.34 : id.trajectory == 0 ? 0.05 : 0.15;
  const double turn = id.trajectory == 1 ? 0.026 : 0.004;
  const double phase = dice.uniform(0, 2 * std::numbers::pi) + 0.12 * id.index;
  return {reach * dice.uniform(0.6, 1) * std::cos(phase), reach * dice.uniform(0.6, 1) * std::sin(phase),
          turn * dice.uniform(0.5, 1) * (dice.chance(0.5) ? 1 : -1) * std::cos(0.09 * id.index)};
}

}  // namespace

std::string dateOf(double time_s, const char* format) {
  const auto stamp = static_cast<std::time_t>(std::floor(stampOf(time_s)));
  std::tm utc{};
  gmtime_r(&stamp, &utc);
  char text[64];
  return {text, std::strftime(text, sizeof text, format, &utc)};
}

RobotState::RobotState(Scene scene, std::uint32_t seed, ClockOptions clock)
    : RobotState(std::make_shared<const Scene>(std::move(scene)), seed, clock, nullptr) {
  auto poses_of = std::make_shared<FixedPoses>();
  for (const Trajectory& trajectory : scene_->trajectories) {
    if (trajectory.growth == Growth::Live) continue;
    std::vector<geometry::Pose3>& poses = (*poses_of)[trajectory.id];
    for (int index = 0; index < trajectory.submaps; ++index) {
      poses.push_back(nominalOf(trajectory, index));
    }
  }
  fixed_poses_ = std::move(poses_of);
}

RobotState::RobotState(std::shared_ptr<const Scene> scene, std::uint32_t seed, ClockOptions clock,
                       std::shared_ptr<const FixedPoses> fixed_poses)
    : scene_(std::move(scene)), seed_(seed), clock_(clock), fixed_poses_(std::move(fixed_poses)) {}

RobotState RobotState::recordedAt(double time_s) const {
  return RobotState(scene_, seed_, {time_s, 1, true}, fixed_poses_);
}

geometry::Pose3 RobotState::nominalOf(const Trajectory& trajectory, int index) const {
  if (fixed_poses_ && trajectory.growth != Growth::Live)
    return fixed_poses_->at(trajectory.id)[static_cast<std::size_t>(index)];
  const map::SubmapId look{trajectory.id, trajectory.lookOf(index)};
  return nominalPose(anchorOf(trajectory, index), look, seedOf(look));
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

std::string RobotState::uuidNow() const { return hexDigits(hashOf(seed_, 31, session_), 24); }

std::uint64_t RobotState::seedOf(map::SubmapId id) const {
  const Trajectory* owner = scene_->find(id.trajectory);
  const std::uint64_t session = owner != nullptr && owner->growth == Growth::Live ? session_ : 0;
  return hashOf(seed_, 41, session, id.trajectory, id.index);
}

double RobotState::metresAtScan(const Trajectory& trajectory, int scan) const {
  if (trajectory.growth != Growth::Live) return kScanStepM * scan;
  return kSpeedMPerS * std::floor(session_began_s_) + kScanStepM * (scan - kScansAtStart);
}

int RobotState::versionOf(map::SubmapId id, int scans) const {
  const auto bumped = bumps_.find(id);
  return std::clamp(scans - kScansPerSubmapStart * id.index, 0, kFullVersion) +
         (bumped == bumps_.end() ? 0 : bumped->second);
}

geometry::Pose2 RobotState::anchorOf(const Trajectory& trajectory, int index) const {
  const geometry::Pose2 first = trajectory.drive.at(metresAtScan(trajectory, kScansPerSubmapStart * index));
  const double yaw =
      unitFrom(hashOf(seedOf({trajectory.id, trajectory.lookOf(index)}), 7)) * 2 * std::numbers::pi;
  return {first.x_m, first.y_m, geometry::normalizeAngle(yaw)};
}

geometry::Pose3 RobotState::corrected(const geometry::Pose3& pose, map::SubmapId id) const {
  if (closures_ == 0) return pose;
  const geometry::Pose2 correction = correctionOf(seed_, closures_, id);
  const Eigen::Quaterniond q = Eigen::AngleAxisd(correction.yaw_rad, Eigen::Vector3d::UnitZ()) *
                               Eigen::Quaterniond(pose.qw, pose.qx, pose.qy, pose.qz);
  return {pose.x + correction.x_m, pose.y + correction.y_m, pose.z, q.x(), q.y(), q.z(), q.w()};
}

map::SubmapList RobotState::list() const {
  map::SubmapList list;
  list.slam_state = slamState();
  const std::lock_guard lock(mutex_);
  list.uuid = uuidNow();
  for (const Trajectory& trajectory : scene_->trajectories) {
    if (!isThere(trajectory)) continue;
    const int scans = trajectory.scansAt(sessionNow());
    const auto [first, end] = submapsOf(trajectory, scans);
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
  for (const Trajectory& trajectory : scene_->trajectories)
    stamp.scans.push_back(trajectory.scansAt(sessionNow()));
  return stamp;
}

double RobotState::time() const {
  const std::lock_guard lock(mutex_);
  return now();
}

int RobotState::scansOf(int id) const {
  const std::lock_guard lock(mutex_);
  const Trajectory* found = scene_->find(id);
  return found == nullptr ? 0 : found->scansAt(sessionNow());
}

geometry::Pose2 RobotState::poseAhead(double metres) const {
  const std::lock_guard lock(mutex_);
  return misplacement_ * truePoseAhead(metres);
}

geometry::Pose2 RobotState::truePoseAhead(double metres) const {
  const Trajectory* live = scene_->find(1);
  if (live == nullptr) return {};
  const int newest = submapsOf(*live, live->scansAt(sessionNow())).second - 1;
  geometry::Pose2 pose = live->drive.at(kSpeedMPerS * now() + metres);
  const geometry::Pose2 origin = anchorOf(*live, newest);
  const geometry::Pose2 correction = correctionOf(seed_, closures_, {1, newest});
  // The robot is where its newest submap says it is.
  const geometry::Pose2 turned = geometry::Pose2{0, 0, correction.yaw_rad} *
                                 geometry::Pose2{pose.x_m - origin.x_m, pose.y_m - origin.y_m, pose.yaw_rad};
  return {origin.x_m + correction.x_m + turned.x_m, origin.y_m + correction.y_m + turned.y_m, turned.yaw_rad};
}

SubmapSource RobotState::describe(const Trajectory& trajectory, int index, int scans) const {
  const map::SubmapId id{trajectory.id, index};
  const auto bumped = bumps_.find(id);
  const int bumps = bumped == bumps_.end() ? 0 : bumped->second;
  const int look = bumps > 0 ? index : trajectory.lookOf(index);
  SubmapSource source;
  source.id = {trajectory.id, look};
  source.version = versionOf(id, scans);
  source.session = session_;
  source.seed = seedOf(source.id);
  source.nearby = trajectory.nearby;
  source.shared = trajectory.looks > 0;
  source.anchor = anchorOf(trajectory, look);
  source.pose = nominalOf(trajectory, look);
  const int first = kScansPerSubmapStart * look;
  for (int scan = first; scan < std::min(scans, first + kScansPerSubmap); ++scan) {
    source.scans.push_back(
        {trajectory.drive.at(metresAtScan(trajectory, scan)), hashOf(seed_, trajectory.id, scan)});
  }
  for (int i = 0; i < std::min(bumps, 64) && !source.scans.empty(); ++i) {
    // A crate at the side of the way for each new version.
    const geometry::Pose2& by = source.scans[static_cast<std::size_t>(i * 5 + 2) % source.scans.size()].pose;
    const Eigen::Vector2d at = by.apply({0.3, i % 2 == 0 ? 0.85 : -0.85});
    source.extra.push_back({at, {0.25, 0.25}, by.yaw_rad, false, true});
  }
  return source;
}

std::optional<SubmapSource> RobotState::find(map::SubmapId id) const {
  const std::lock_guard lock(mutex_);
  const Trajectory* owner = scene_->find(id.trajectory);
  if (owner == nullptr || !isThere(*owner) || removed_.contains(id)) return std::nullopt;
  const int scans = owner->scansAt(sessionNow());
  const auto [first, end] = submapsOf(*owner, scans);
  if (id.index < first || id.index >= end) return std::nullopt;
  return describe(*owner, id.index, scans);
}

bool RobotState::isThere(const Trajectory& trajectory) const {
  return mapping_ != Mapping::New || trajectory.growth == Growth::Live;
}

std::pair<int, int> RobotState::submapsOf(const Trajectory& trajectory, int scans) const {
  std::pair<int, int> range = trajectory.submapsAfter(scans);
  // What is being mapped is kept.
  if (trajectory.growth == Growth::Live && mapping_ != Mapping::Off) range.first = 0;
  return range;
}

geometry::Pose2 RobotState::misplacement() const {
  const std::lock_guard lock(mutex_);
  return misplacement_;
}

bool RobotState::isPositioned() const {
  const std::lock_guard lock(mutex_);
  const geometry::Pose2 here = truePoseAhead(0), believed = misplacement_ * here;
  return std::hypot(believed.x_m - here.x_m, believed.y_m - here.y_m) < kLostM &&
         std::abs(geometry::normalizeAngle(believed.yaw_rad - here.yaw_rad)) < kLostRad;
}

map::SlamState RobotState::slamState() const {
  const std::lock_guard lock(mutex_);
  return scene_->trajectories.empty() || mapping_ != Mapping::Off ? map::SlamState::Slam
                                                                  : map::SlamState::Positioning;
}

Controls RobotState::controls() const {
  const std::lock_guard lock(mutex_);
  return controls_;
}

std::optional<MappingSpan> RobotState::mapping() const {
  const std::lock_guard lock(mutex_);
  const Trajectory* live = scene_->find(1);
  if (mapping_ == Mapping::Off || live == nullptr) return std::nullopt;
  return MappingSpan{mapping_, metresAtScan(*live, 0), live->scansAt(sessionNow())};
}

void RobotState::setPose(const geometry::Pose2& pose, bool adjust) {
  const std::lock_guard lock(mutex_);
  const geometry::Pose2 here = truePoseAhead(0);
  const bool near = std::hypot(pose.x_m - here.x_m, pose.y_m - here.y_m) < kAdjustableM &&
                    std::abs(geometry::normalizeAngle(pose.yaw_rad - here.yaw_rad)) < kAdjustableRad;
  search_asks_ = false;
  misplacement_ = adjust && near ? geometry::Pose2{} : pose * here.inverse();
}

void RobotState::relocate(bool asks) {
  const std::lock_guard lock(mutex_);
  searched_at_s_ = now();
  search_asks_ = asks;
  if (!asks) misplacement_ = {};
}

std::optional<RobotState::Search> RobotState::search() const {
  const std::lock_guard lock(mutex_);
  if (!searched_at_s_) return std::nullopt;
  return Search{now() - *searched_at_s_ < kSearchS, search_asks_, truePoseAhead(0)};
}

void RobotState::setMapping(Mapping mapping) {
  const std::lock_guard lock(mutex_);
  beginSession();
  mapping_ = mapping;
}

void RobotState::setControlMode(std::string mode) {
  const std::lock_guard lock(mutex_);
  controls_.control_mode = std::move(mode);
}

void RobotState::setEmergencyStop(bool pressed) {
  const std::lock_guard lock(mutex_);
  controls_.emergency_stop = pressed;
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
  beginSession();
}

void RobotState::beginSession() {
  ++session_;
  ++edits_;
  closures_ = 0;
  misplacement_ = {};
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
