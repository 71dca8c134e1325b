#include "map/live_state.h"

#include <algorithm>
#include <utility>

namespace mapwright::map {
namespace {

void extendTrail(std::deque<Eigen::Vector2d>& trail, const Eigen::Vector2d& point) {
  if (!trail.empty() && (trail.back() - point).norm() < LiveState::kTrailStepM) return;
  trail.push_back(point);
  if (trail.size() > LiveState::kTrailPoints) trail.pop_front();
}

/// An alert that is still active keeps the time when it was first seen.
std::vector<Alert> withTimes(const std::vector<Alert>& before, std::vector<Alert> now, double at_s) {
  for (Alert& alert : now) {
    const auto same = std::find_if(before.begin(), before.end(), [&](const Alert& known) {
      return known.code == alert.code && known.text == alert.text;
    });
    alert.since_s = same == before.end() ? at_s : same->since_s;
  }
  std::stable_sort(now.begin(), now.end(),
                   [](const Alert& a, const Alert& b) { return a.since_s < b.since_s; });
  return now;
}

struct Reducer {
  LiveState& state;
  double at_s;

  void operator()(const TrackedPose& tracked) {
    state.robot_pose = tracked.pose;
    extendTrail(state.trail, {tracked.pose.x_m, tracked.pose.y_m});
  }
  void operator()(const RobotModel& model) { state.model = model; }
  void operator()(const SlamStatus& slam) { state.slam = slam; }
  void operator()(const GridMessage& grid) { state.grids[grid.kind] = grid; }
  void operator()(const PointCloudMessage& cloud) { state.clouds[cloud.topic] = cloud.points; }
  void operator()(const PathMessage& path) { state.path = path.points; }
  void operator()(const LocalPathMessage& path) { state.local_path = path; }
  void operator()(const TrajectoryMessage& trajectory) { state.trajectory = trajectory.points; }
  void operator()(const PlanningState& planning) { state.planning = planning; }
  void operator()(const MapInfo& info) { state.map_info = info; }
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
  void operator()(const SeenObjectsMessage& seen) { state.seen_objects = seen.objects; }
  void operator()(const ConstraintsMessage& constraints) { state.constraints = constraints; }
  void operator()(const GlobalPositioning& positioning) { state.global_positioning = positioning; }
  void operator()(const BarcodeMessage& barcode) { state.barcode = barcode; }
  void operator()(const SubmapList&) {}
  void operator()(const UnreadableMessage&) {}
};

}  // namespace

LiveState reduce(LiveState state, const TopicMessage& message, double at_s) {
  std::visit(Reducer{state, at_s}, message);
  return state;
}

}  // namespace mapwright::map
