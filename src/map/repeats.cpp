#include "map/repeats.h"

#include <algorithm>

namespace mapwright::map {
namespace {

struct Comparer {
  const LiveState& state;

  template <typename K, typename V>
  static const V* at(const std::map<K, V>& values, const K& key) {
    const auto found = values.find(key);
    return found == values.end() ? nullptr : &found->second;
  }

  bool operator()(const TrackedPose& tracked) const { return state.robot_pose == tracked.pose; }
  bool operator()(const RobotModel& model) const { return state.model == model; }
  bool operator()(const SlamStatus& slam) const { return state.slam == slam; }
  bool operator()(const GridMessage& grid) const {
    const GridMessage* const held = at(state.grids, grid.kind);
    return held && *held == grid;
  }
  bool operator()(const PointCloudMessage& cloud) const {
    const auto* const held = at(state.clouds, cloud.topic);
    return held && PointCloudMessage{cloud.topic, *held} == cloud;
  }
  bool operator()(const PathMessage& path) const { return state.path == path.points; }
  bool operator()(const LocalPathMessage& path) const { return state.local_path == path; }
  bool operator()(const TrajectoryMessage& trajectory) const { return state.trajectory == trajectory.points; }
  bool operator()(const PlanningState& planning) const { return state.planning == planning; }
  bool operator()(const MapInfo& info) const { return state.map_info == info; }
  bool operator()(const AlertsMessage& alerts) const {
    // Those of the state are sorted by time.
    return state.alerts.size() == alerts.alerts.size() &&
           std::is_permutation(state.alerts.begin(), state.alerts.end(), alerts.alerts.begin(),
                               [](const Alert& a, const Alert& b) {
                                 return a.code == b.code && a.level == b.level && a.text == b.text;
                               });
  }
  bool operator()(const BatteryState& battery) const { return state.battery == battery; }
  bool operator()(const WheelState& wheels) const { return state.wheels == wheels; }
  bool operator()(const SensorState& sensors) const { return state.sensors == sensors; }
  bool operator()(const NearbyRobotsMessage& nearby) const { return state.nearby_robots == nearby.robots; }
  bool operator()(const NearbyFootprintsMessage& nearby) const {
    return std::all_of(nearby.by_digest.begin(), nearby.by_digest.end(), [&](const auto& entry) {
      const Polyline* const held = at(state.nearby_footprints, entry.first);
      return held && *held == entry.second;
    });
  }
  bool operator()(const LandmarksMessage& landmarks) const { return state.landmarks == landmarks.landmarks; }
  bool operator()(const AutoDoorsMessage& doors) const { return state.doors == doors.doors; }
  bool operator()(const PalletsMessage& pallets) const { return state.pallets == pallets.pallets; }
  bool operator()(const RackMessage& racks) const { return state.racks == racks.racks; }
  bool operator()(const SeenObjectsMessage& seen) const {
    return state.seen_objects == seen.objects && state.drawings == seen.drawings;
  }
  bool operator()(const ConstraintsMessage& constraints) const { return state.constraints == constraints; }
  bool operator()(const GlobalPositioning& positioning) const {
    return state.global_positioning == positioning;
  }
  bool operator()(const BarcodeMessage& barcode) const { return state.barcode == barcode; }
  // The state does not contain them.
  bool operator()(const SubmapList&) const { return false; }
  bool operator()(const UnreadableMessage&) const { return false; }
};

}  // namespace

bool repeats(const LiveState& state, const TopicMessage& message) {
  return std::visit(Comparer{state}, message);
}

}  // namespace mapwright::map
