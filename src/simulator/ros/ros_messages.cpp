#include "simulator/ros/ros_messages.h"

#include <ctime>

#include "simulator/ros/shapes.h"
#include "simulator/ros/topic_table.h"
#include "simulator/stamp.h"

namespace mapwright::simulator::ros {
namespace {

constexpr double kLocalPlanM = 3;
constexpr double kCostmapM = 0.05;
constexpr double kPatchReachM = 4;
constexpr double kPersonM = 0.3;

std::string_view nameOf(ManagerState state) {
  return state == ManagerState::Idle ? "IDLE" : state == ManagerState::Mapping ? "MAPPING" : "ACTIVE";
}

/// "2025-05-21 11:28:18"
std::string dateOf(double simulated_s) {
  const auto stamp = static_cast<std::time_t>(stampOf(simulated_s));
  std::tm parts{};
  gmtime_r(&stamp, &parts);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &parts)};
}

Value mapList(const std::vector<KabamMap>& maps, bool archived, bool both) {
  Value::List list;
  for (const KabamMap& map : maps) {
    if (!both && map.archived != archived) continue;
    list.push_back(Value::Object{{"map_name", map.name}, {"map_label", map.label}, {"map_id", map.id}});
  }
  return Value::Object{{"maps", std::move(list)}};
}

/// The solids around the robot as the frame odom has them.
std::vector<Solid> solidsInOdom(const Moment& moment, double reach_m) {
  const geometry::Pose2 to_odom = mapFromOdom(moment.time_s).inverse();
  const Eigen::Vector2d here(moment.pose.x_m, moment.pose.y_m), reach(reach_m, reach_m);
  std::vector<Solid> solids;
  for (const std::uint32_t index : moment.robot.plan().near(here - reach, here + reach)) {
    Solid solid = moment.robot.plan().solids()[index];
    solid.centre = to_odom.apply(solid.centre);
    solid.yaw_rad += to_odom.yaw_rad;
    solids.push_back(solid);
  }
  return solids;
}

}  // namespace

Value shownWaypoint(const KabamWaypoint& waypoint, std::string_view map_id, std::size_t index,
                    const RosFaults& faults) {
  Value shown = waypointMessage(waypoint, map_id);
  Value pose = shown["pose"];
  if (faults.zero_quaternion && index % 3 == 1) {
    pose.set("orientation", poseOf({}, faults)["orientation"]);
  } else if (faults.zero_quaternion && index % 3 == 2) {
    pose.set("orientation", Value::Object{{"x", 0.0}, {"y", 0.0}, {"z", 2.0}, {"w", 2.0}});
  }
  if (faults.nan_pose && index % 4 == 2) pose.set("position", poseOf({}, faults)["position"]);
  shown.set("pose", std::move(pose));
  return shown;
}

Value waypointList(const KabamMap& map, const RosFaults& faults) {
  Value::List list;
  for (std::size_t i = 0; i < map.waypoints.size(); ++i)
    list.push_back(shownWaypoint(map.waypoints[i], map.id, i, faults));
  return Value::Object{{"waypoints", std::move(list)}};
}

Moment Messages::momentOf(const RosFaults& faults) const {
  return {robot_, options_, faults, robot_.time(), robot_.robotPose()};
}

std::optional<OccupancyCells> Messages::mapCells() {
  const std::optional<RasterSource> source = kabam_.raster();
  const std::shared_ptr<const FloorCells> floor = source ? pictures_.cells(source->spec) : nullptr;
  if (!floor) return std::nullopt;
  return occupancyOf(*floor, source->image.get());
}

std::optional<Value> Messages::mapMessage() {
  const RosFaults faults = faults_.faults().ros;
  std::optional<OccupancyCells> cells = mapCells();
  if (!cells) return std::nullopt;
  return gridMessage(momentOf(faults), "map", std::move(*cells));
}

std::shared_ptr<const OccupancyCells> Messages::costsOfMap() {
  const std::optional<RasterSource> source = kabam_.raster();
  if (!source || source->map_id.empty()) return nullptr;
  {
    const std::lock_guard lock(mutex_);
    if (costs_ && costs_->source == *source) return costs_->grid;
  }
  const std::shared_ptr<const FloorCells> floor = pictures_.cells(source->spec);
  if (!floor) return nullptr;
  const GridPlace place{floor->width, floor->height, floor->resolution_m, floor->origin_m};
  auto made = std::make_shared<const OccupancyCells>(occupancyOf(costsOf(robot_.plan(), {}, place), place));
  const std::lock_guard lock(mutex_);
  costs_ = KeptCosts{*source, made};
  return made;
}

std::optional<Value> Messages::gridTopic(std::string_view topic, const Moment& moment) {
  const Eigen::Vector2d here(moment.pose.x_m, moment.pose.y_m);
  if (topic == "/map") return mapMessage();
  if (topic == "/map_updates") {
    if (kabam_.state() != ManagerState::Mapping) return std::nullopt;
    const std::optional<OccupancyCells> cells = mapCells();
    if (!cells) return std::nullopt;
    return gridPatchMessage(moment, "map", *cells, here, kPatchReachM);
  }
  if (topic == "/local_costmap/costmap") {
    const double reach = options_.costmap_cells * kCostmapM;
    const geometry::Pose2 in_odom = moment.odomFromBase();
    const GridPlace place = squareAround({in_odom.x_m, in_odom.y_m}, options_.costmap_cells, kCostmapM);
    return gridMessage(moment, "odom", occupancyOf(costsOf({}, solidsInOdom(moment, reach), place), place));
  }
  const std::shared_ptr<const OccupancyCells> costs = costsOfMap();
  if (!costs) return std::nullopt;
  if (topic == "/global_costmap/costmap") return gridMessage(moment, "map", *costs);
  // Somebody walks beside the robot.
  const Value whole = gridPatchMessage(moment, "map", *costs, here, kPatchReachM);
  if (whole.isNull()) return std::nullopt;
  GridPlace place{static_cast<int>(whole["width"].number()), static_cast<int>(whole["height"].number()),
                  costs->place.resolution_m, costs->place.origin_m};
  place.origin_m += costs->place.resolution_m * Eigen::Vector2d(whole["x"].number(), whole["y"].number());
  const Solid person{moment.pose.apply({1.5, 1.0}), {kPersonM, kPersonM}, 0, true, true};
  Value patch = whole;
  patch.set("data", occupancyOf(costsOf(robot_.plan(), {person}, place), place).cells);
  return patch;
}

std::optional<Value> Messages::kabamTopic(std::string_view topic) const {
  if (topic == kMapListTopic) return mapList(kabam_.maps(), false, options_.ros.kabam_list_holds_archived);
  if (topic == kArchivedListTopic) return mapList(kabam_.maps(), true, false);
  const std::optional<KabamMap> map = kabam_.current();
  if (topic == kWaypointsTopic) return waypointList(map.value_or(KabamMap{}), faults_.faults().ros);
  if (topic != kMapInfoTopic) return std::nullopt;
  return Value::Object{{"map_id", map ? map->id : ""},
                       {"map_name", map ? map->name : ""},
                       {"map_label", map ? map->label : ""},
                       {"updated_at", map ? dateOf(map->updated_s) : ""},
                       {"created_at", map ? dateOf(map->created_s) : ""},
                       {"map_manager_state", nameOf(kabam_.state())}};
}

std::optional<Value> Messages::messageOf(std::string_view topic) {
  const RosFaults faults = faults_.faults().ros;
  const Moment moment = momentOf(faults);
  if (faults.wrong_type && hasOddType(topic)) return Value::Object{{"data", "this topic is of another type"}};
  if (topic == "/tf") return tfMessage(moment);
  if (topic == "/tf_static") return tfStaticMessage(moment);
  if (topic == "/odom") return odometryMessage(moment);
  if (topic == "/amcl_pose") return amclPoseMessage(moment);
  if (topic == "/goal_pose") return goalMessage(moment);
  if (topic == "/plan") return pathMessage(moment, -1);
  if (topic == "/local_plan") return pathMessage(moment, kLocalPlanM);
  if (topic == "/scan") return laserScanMessage(moment);
  if (topic == "/points") return pointCloudMessage(moment);
  // Where the manager tells of waypoints, nobody else needs to.
  if (topic == "/markers")
    return markersMessage(moment, options_.ros.kabam ? std::nullopt : kabam_.current());
  if (topic.ends_with("footprint")) return footprintMessage(moment);
  if (topic == "/map" || topic == "/map_updates" || topic.find("costmap/costmap") != std::string_view::npos)
    return gridTopic(topic, moment);
  return kabamTopic(topic);
}

}  // namespace mapwright::simulator::ros
