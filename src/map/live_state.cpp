#include "map/live_state.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "map/world.h"

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

/// Where the state holds what a message says, and what it says: of messages that replace it as a whole.
auto kept(auto& state, const RobotModel& said) { return std::tie(state.model, said); }
auto kept(auto& state, const SlamStatus& said) { return std::tie(state.slam, said); }
auto kept(auto& state, const PathMessage& said) { return std::tie(state.path, said.points); }
auto kept(auto& state, const LocalPathMessage& said) { return std::tie(state.local_path, said); }
auto kept(auto& state, const TrajectoryMessage& said) { return std::tie(state.trajectory, said.points); }
auto kept(auto& state, const PlanningState& said) { return std::tie(state.planning, said); }
auto kept(auto& state, const BatteryState& said) { return std::tie(state.battery, said); }
auto kept(auto& state, const WheelState& said) { return std::tie(state.wheels, said); }
auto kept(auto& state, const SensorState& said) { return std::tie(state.sensors, said); }
auto kept(auto& state, const JackState& said) { return std::tie(state.jack, said); }
auto kept(auto& state, const TowingState& said) { return std::tie(state.towing, said); }
auto kept(auto& state, const NearbyRobotsMessage& said) { return std::tie(state.nearby_robots, said.robots); }
auto kept(auto& state, const LandmarksMessage& said) { return std::tie(state.landmarks, said.landmarks); }
auto kept(auto& state, const AutoDoorsMessage& said) { return std::tie(state.doors, said.doors); }
auto kept(auto& state, const PalletsMessage& said) { return std::tie(state.pallets, said.pallets); }
auto kept(auto& state, const RackMessage& said) { return std::tie(state.racks, said.racks); }
auto kept(auto& state, const ConstraintsMessage& said) { return std::tie(state.constraints, said); }
auto kept(auto& state, const GlobalPositioning& said) { return std::tie(state.global_positioning, said); }
auto kept(auto& state, const BarcodeMessage& said) { return std::tie(state.barcode, said); }

struct Reducer {
  LiveState& state;
  double at_s;

  void operator()(const auto& message) {
    const auto [target, said] = kept(state, message);
    target = said;
  }
  void operator()(const TrackedPose& tracked) {
    state.robot_pose = tracked.pose;
    extendTrail(state.trail, {tracked.pose.x_m, tracked.pose.y_m}, at_s);
  }
  void operator()(const GridMessage& grid) { state.grids[grid.kind] = grid; }
  void operator()(const PointCloudMessage& cloud) { state.clouds[cloud.topic] = cloud.points; }
  void operator()(const MapInfo& info) {
    if (state.map_info && otherMap(*state.map_info, info)) state = inNewFrame(std::move(state), false);
    state.map_info = info;
  }
  void operator()(const AlertsMessage& alerts) {
    state.alerts = withTimes(state.alerts, alerts.alerts, at_s);
  }
  void operator()(const NearbyFootprintsMessage& nearby) {
    for (const auto& [digest, outline] : nearby.by_digest) state.nearby_footprints[digest] = outline;
  }
  void operator()(const DetectedFeaturesMessage& seen) { state.features[seen.kind] = seen.boxes; }
  void operator()(const SeenObjectsMessage& seen) {
    state.seen_objects = seen.objects;
    state.drawings = seen.drawings;
  }
  void operator()(const SubmapList& list) {
    if (list.uuid.empty() || list.uuid == state.session_uuid) return;
    if (!state.session_uuid.empty()) {
      state = inNewFrame(std::move(state), list.slam_state == SlamState::Positioning);
    }
    state.session_uuid = list.uuid;
  }
  void operator()(const UnreadableMessage&) {}
};

struct Comparer {
  const LiveState& state;

  template <typename K, typename V>
  static const V* at(const std::map<K, V>& values, const K& key) {
    const auto found = values.find(key);
    return found == values.end() ? nullptr : &found->second;
  }

  bool operator()(const auto& message) const {
    const auto [target, said] = kept(state, message);
    return target == said;
  }
  bool operator()(const TrackedPose& tracked) const { return state.robot_pose == tracked.pose; }
  bool operator()(const GridMessage& grid) const {
    const GridMessage* const held = at(state.grids, grid.kind);
    return held && *held == grid;
  }
  bool operator()(const PointCloudMessage& cloud) const {
    const auto* const held = at(state.clouds, cloud.topic);
    return held && PointCloudMessage{cloud.topic, *held} == cloud;
  }
  bool operator()(const MapInfo& info) const { return state.map_info == info; }
  bool operator()(const AlertsMessage& alerts) const {
    // Those of the state are sorted by time.
    return state.alerts.size() == alerts.alerts.size() &&
           std::is_permutation(state.alerts.begin(), state.alerts.end(), alerts.alerts.begin(),
                               [](const Alert& a, const Alert& b) {
                                 return a.code == b.code && a.level == b.level && a.text == b.text;
                               });
  }
  bool operator()(const NearbyFootprintsMessage& nearby) const {
    return std::all_of(nearby.by_digest.begin(), nearby.by_digest.end(), [&](const auto& entry) {
      const Polyline* const held = at(state.nearby_footprints, entry.first);
      return held && *held == entry.second;
    });
  }
  bool operator()(const DetectedFeaturesMessage& seen) const {
    const auto* const held = at(state.features, seen.kind);
    return held && *held == seen.boxes;
  }
  bool operator()(const SeenObjectsMessage& seen) const {
    return state.seen_objects == seen.objects && state.drawings == seen.drawings;
  }
  // The state does not contain them.
  bool operator()(const SubmapList&) const { return false; }
  bool operator()(const UnreadableMessage&) const { return false; }
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
                    s.local_path, s.planning, s.map_info, s.alerts, s.battery, s.wheels, s.sensors, s.jack,
                    s.towing, s.nearby_robots, s.nearby_footprints, s.landmarks, s.doors, s.pallets, s.racks,
                    s.features, s.seen_objects, s.drawings, s.constraints, s.global_positioning, s.barcode,
                    s.safety);
  };
  return rest(*this) == rest(other) && std::equal(clouds.begin(), clouds.end(), other.clouds.begin(),
                                                  other.clouds.end(), [](const auto& a, const auto& b) {
                                                    return a.first == b.first &&
                                                           sameContent(a.second, b.second);
                                                  });
}

std::vector<BoxGroup> boxGroups(const LiveState& state) {
  std::vector<BoxGroup> groups{{BoxKind::Pallet, topicIndex<PalletsMessage>(), &state.pallets},
                               {BoxKind::Rack, topicIndex<RackMessage>(), &state.racks}};
  for (const auto& [kind, boxes] : state.features)
    groups.push_back({kind, topicIndex<DetectedFeaturesMessage>(), &boxes});
  groups.push_back({BoxKind::Object, topicIndex<SeenObjectsMessage>(), &state.seen_objects});
  return groups;
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
  state.features.clear();
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

bool repeats(const LiveState& state, const TopicMessage& message) {
  return std::visit(Comparer{state}, message);
}

bool isJump(const TrailPoint& before, const TrailPoint& after) {
  const double way_m = (after.position_m - before.position_m).norm();
  return way_m > kJumpM && way_m > kJumpMPerS * std::max(after.at_s - before.at_s, 0.0);
}

bool isWayKnown(const TrailPoint& before, const TrailPoint& after) {
  const bool unheard =
      after.at_s - before.at_s > kUnheardS && (after.position_m - before.position_m).norm() > kUnheardM;
  return !unheard && !isJump(before, after);
}

}  // namespace mapwright::map
