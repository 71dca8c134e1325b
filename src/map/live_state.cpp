#include "map/live_state.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "map/fold.h"

namespace mapwright::map {
namespace {

void extendTrail(std::deque<TrailPoint>& trail, const Eigen::Vector2d& point, double at_s) {
  if (!trail.empty() && (trail.back().position_m - point).norm() < LiveState::kTrailStepM) return;
  trail.push_back({point, at_s});
  if (trail.size() > LiveState::kTrailPoints) trail.pop_front();
}

/// An alert that is still active keeps its first time, even if a number in its text changes.
std::vector<Alert> withTimes(const std::vector<Alert>& before, std::vector<Alert> now, double at_s) {
  const auto identity = [](const Alert& alert) {
    return safetyIdentity({SafetyKind::Alert, Severity::Error, alert.code, alert.text, 0, 1, {}});
  };
  std::multimap<std::string, double> known;
  for (const Alert& alert : before) known.emplace(identity(alert), alert.since_s);
  for (Alert& alert : now) {
    const auto same = known.find(identity(alert));
    alert.since_s = same == known.end() ? at_s : same->second;
    if (same != known.end()) known.erase(same);
  }
  std::stable_sort(now.begin(), now.end(),
                   [](const Alert& a, const Alert& b) { return a.since_s < b.since_s; });
  return now;
}

/// Whether `after` is another map: by uid, or by name if there is no uid.
bool otherMap(const MapInfo& before, const MapInfo& after) {
  if (!before.uid.empty() && !after.uid.empty()) return before.uid != after.uid;
  return !before.name.empty() && !after.name.empty() && before.name != after.name;
}

template <typename T>
bool sameContent(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
  return a == b || (a && b && *a == *b);
}

struct Reducer {
  LiveState& state;
  double at_s;

  void operator()(const TrackedPose& tracked) {
    state.robot_pose = tracked.pose;
    extendTrail(state.trail, {tracked.pose.x_m, tracked.pose.y_m}, at_s);
  }
  void operator()(const RobotModel& model) { state.model = model; }
  void operator()(const SlamStatus& slam) { state.slam = slam; }
  void operator()(const GridMessage& grid) { state.grids[grid.kind] = grid; }
  void operator()(const PointCloudMessage& cloud) { state.clouds[cloud.topic] = cloud.points; }
  void operator()(const PathMessage& path) { state.path = path.points; }
  void operator()(const LocalPathMessage& path) { state.local_path = path; }
  void operator()(const TrajectoryMessage& trajectory) { state.trajectory = trajectory.points; }
  void operator()(const PlanningState& planning) { state.planning = planning; }
  void operator()(const MapInfo& info) {
    if (state.map_info && otherMap(*state.map_info, info)) state = inNewFrame(std::move(state), false);
    state.map_info = info;
  }
  void operator()(const AlertsMessage& alerts) {
    state.alerts = withTimes(state.alerts, alerts.alerts, at_s);
  }
  void operator()(const BatteryState& battery) { state.battery = battery; }
  void operator()(const WheelState& wheels) { state.wheels = wheels; }
  void operator()(const SensorState& sensors) { state.sensors = sensors; }
  void operator()(const NearbyRobotsMessage& nearby) { state.nearby_robots = nearby.robots; }
  void operator()(const NearbyFootprintsMessage& nearby) {
    for (const auto& [digest, outline] : nearby.by_digest) state.nearby_footprints[digest] = outline;
  }
  void operator()(const LandmarksMessage& landmarks) { state.landmarks = landmarks.landmarks; }
  void operator()(const AutoDoorsMessage& doors) { state.doors = doors.doors; }
  void operator()(const PalletsMessage& pallets) { state.pallets = pallets.pallets; }
  void operator()(const RackMessage& racks) { state.racks = racks.racks; }
  void operator()(const SeenObjectsMessage& seen) {
    state.seen_objects = seen.objects;
    state.drawings = seen.drawings;
  }
  void operator()(const ConstraintsMessage& constraints) { state.constraints = constraints; }
  void operator()(const GlobalPositioning& positioning) { state.global_positioning = positioning; }
  void operator()(const BarcodeMessage& barcode) { state.barcode = barcode; }
  void operator()(const SubmapList& list) {
    if (list.uuid.empty() || list.uuid == state.session_uuid) return;
    if (!state.session_uuid.empty()) {
      state = inNewFrame(std::move(state), list.slam_state == SlamState::Positioning);
    }
    state.session_uuid = list.uuid;
  }
  void operator()(const UnreadableMessage&) {}
};

}  // namespace

bool GridMessage::operator==(const GridMessage& other) const {
  return topic == other.topic && kind == other.kind && grid == other.grid && reading == other.reading &&
         fingerprint == other.fingerprint && sameContent(png, other.png);
}

bool PointCloudMessage::operator==(const PointCloudMessage& other) const {
  return topic == other.topic && sameContent(points, other.points);
}

bool LiveState::operator==(const LiveState& other) const {
  const auto rest = [](const LiveState& s) {
    return std::tie(s.session_uuid, s.robot_pose, s.trail, s.model, s.slam, s.grids, s.path, s.trajectory,
                    s.local_path, s.planning, s.map_info, s.alerts, s.battery, s.wheels, s.sensors,
                    s.nearby_robots, s.nearby_footprints, s.landmarks, s.doors, s.pallets, s.racks,
                    s.seen_objects, s.drawings, s.constraints, s.global_positioning, s.barcode, s.safety);
  };
  return rest(*this) == rest(other) && std::equal(clouds.begin(), clouds.end(), other.clouds.begin(),
                                                  other.clouds.end(), [](const auto& a, const auto& b) {
                                                    return a.first == b.first &&
                                                           sameContent(a.second, b.second);
                                                  });
}

LiveState inNewFrame(LiveState state, bool map_stays) {
  ++state.frame;
  state.robot_pose.reset();
  state.trail.clear();
  std::erase_if(state.grids,
                [&](const auto& grid) { return !map_stays || grid.first != GridKind::WholeMap; });
  if (!map_stays) state.map_info.reset();
  state.clouds.clear();
  state.path.clear();
  state.trajectory.clear();
  state.local_path = {};
  if (state.planning) {
    state.planning->targets.clear();
    state.planning->remaining_distance_m.reset();
  }
  state.nearby_robots.clear();
  state.landmarks.clear();
  state.doors.clear();
  state.pallets.clear();
  state.racks.clear();
  state.seen_objects.clear();
  state.drawings.clear();
  state.constraints = {};
  if (state.global_positioning) state.global_positioning->pose.reset();
  if (state.barcode) state.barcode->pose.reset();
  return state;
}

void reduceInto(LiveState& state, const TopicMessage& message, double at_s) {
  std::visit(Reducer{state, at_s}, message);
  const bool tells = std::holds_alternative<AlertsMessage>(message) ||
                     std::holds_alternative<WheelState>(message) ||
                     std::holds_alternative<SlamStatus>(message);
  if (tells) state.safety = continuedSafety(std::move(state.safety), state, at_s);
}

LiveState reduce(LiveState state, const TopicMessage& message, double at_s) {
  reduceInto(state, message, at_s);
  return state;
}

}  // namespace mapwright::map
