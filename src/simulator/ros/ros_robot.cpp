#include "simulator/ros/ros_robot.h"

#include <algorithm>
#include <cmath>

namespace mapwright::simulator::ros {
namespace {

constexpr double kLocalPlanM = 3;
constexpr double kCostmapM = 0.05;
constexpr double kPatchReachM = 4;
constexpr double kPersonM = 0.3;
constexpr std::int8_t kUnknown = -1, kFree = 0, kOccupied = 100;

std::int8_t cellOf(FloorCell cell) {
  return cell == FloorCell::Unknown ? kUnknown : cell == FloorCell::Free ? kFree : kOccupied;
}

/// As map_server reads shades: dark is occupied, light is free.
std::int8_t cellOf(std::uint8_t shade) {
  const double occupied = (255 - shade) / 255.0;
  return occupied > 0.65 ? kOccupied : occupied < 0.196 ? kFree : kUnknown;
}

/// As costmap_2d publishes its costs.
std::int8_t cellOfCost(std::uint8_t cost) {
  if (cost == 0) return kFree;
  if (cost >= 254) return kOccupied;
  if (cost == 253) return 99;
  return static_cast<std::int8_t>(1 + (97 * (cost - 1)) / 251);
}

/// A grid of cellAt(i) for every cell i of a picture, whose top row comes first.
template <typename CellAt>
OccupancyCells upsideDown(const GridPlace& place, const CellAt& cell_at) {
  OccupancyCells grid{place, {}};
  const auto columns = static_cast<std::size_t>(place.width), rows = static_cast<std::size_t>(place.height);
  grid.cells.reserve(columns * rows);
  for (std::size_t row = rows; row-- > 0;) {
    for (std::size_t u = 0; u < columns; ++u) grid.cells.push_back(cell_at(row * columns + u));
  }
  return grid;
}

OccupancyCells occupancyOf(const GrayPicture& costs, const GridPlace& place) {
  return upsideDown(place, [&](std::size_t i) { return cellOfCost(costs.levels[i]); });
}

Value gridMessage(const Moment& moment, std::string_view frame, OccupancyCells grid) {
  const geometry::Pose2 corner{grid.place.origin_m.x(), grid.place.origin_m.y(), 0};
  return moment.stamped(frame, {{"info", mapInfo(grid.place.resolution_m, grid.place.width, grid.place.height,
                                                 corner, moment.dialect())},
                                {"data", std::move(grid.cells)}});
}

/// The part of `of` around the robot; null if there is none.
Value gridPatchMessage(const Moment& moment, const OccupancyCells& of) {
  const Eigen::Vector2d here(moment.pose.x_m, moment.pose.y_m);
  const Eigen::Vector2d middle = (here - of.place.origin_m) / of.place.resolution_m;
  const double reach = kPatchReachM / of.place.resolution_m;
  const auto clamped = [](double at, int most) {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, 1.0 * most));
  };
  const int u0 = clamped(middle.x() - reach, of.place.width),
            u1 = clamped(middle.x() + reach, of.place.width);
  const int v0 = clamped(middle.y() - reach, of.place.height),
            v1 = clamped(middle.y() + reach, of.place.height);
  if (u1 <= u0 || v1 <= v0) return {};
  Value::Int8s cells;
  for (int v = v0; v < v1; ++v) {
    const auto row = of.cells.begin() + static_cast<std::ptrdiff_t>(v) * of.place.width;
    cells.insert(cells.end(), row + u0, row + u1);
  }
  return moment.stamped(
      "map", {{"x", u0}, {"y", v0}, {"width", u1 - u0}, {"height", v1 - v0}, {"data", std::move(cells)}});
}

std::optional<OccupancyCells> mapCells(const Moment& moment) {
  const std::optional<RasterSource> source = moment.kabam.raster();
  const std::shared_ptr<const FloorCells> floor = source ? moment.pictures.cells(source->spec) : nullptr;
  if (!floor) return std::nullopt;
  const GrayPicture* const image = source->image.get();
  return upsideDown(*floor, [&](std::size_t i) {
    return image != nullptr ? cellOf(image->levels[i]) : cellOf(floor->cells[i]);
  });
}

Value mapMessage(const Moment& moment) {
  std::optional<OccupancyCells> cells = mapCells(moment);
  return cells ? gridMessage(moment, "map", std::move(*cells)) : Value();
}

Value mapUpdate(const Moment& moment) {
  if (moment.kabam.state() != ManagerState::Mapping) return {};
  const std::optional<OccupancyCells> cells = mapCells(moment);
  return cells ? gridPatchMessage(moment, *cells) : Value();
}

Value localCosts(const Moment& moment) {
  const double reach_m = moment.options.costmap_cells * kCostmapM;
  const geometry::Pose2 in_odom = moment.odomFromBase(), to_odom = mapFromOdom(moment.time_s).inverse();
  const GridPlace place = squareAround({in_odom.x_m, in_odom.y_m}, moment.options.costmap_cells, kCostmapM);
  // The solids around the robot as the frame odom has them.
  const Eigen::Vector2d here(moment.pose.x_m, moment.pose.y_m), reach(reach_m, reach_m);
  std::vector<Solid> solids;
  for (const std::uint32_t index : moment.robot.plan().near(here - reach, here + reach)) {
    Solid solid = moment.robot.plan().solids()[index];
    solid.centre = to_odom.apply(solid.centre);
    solid.yaw_rad += to_odom.yaw_rad;
    solids.push_back(solid);
  }
  return gridMessage(moment, "odom", occupancyOf(costsOf({}, solids, place), place));
}

std::shared_ptr<const OccupancyCells> costsOfMap(const Moment& moment) {
  const std::optional<RasterSource> source = moment.kabam.raster();
  if (!source || source->map_id.empty()) return nullptr;
  return moment.costs.get(*source, [&]() -> std::shared_ptr<const OccupancyCells> {
    const std::shared_ptr<const FloorCells> floor = moment.pictures.cells(source->spec);
    if (!floor) return nullptr;
    return std::make_shared<const OccupancyCells>(
        occupancyOf(costsOf(moment.robot.plan(), {}, *floor), *floor));
  });
}

Value globalCosts(const Moment& moment) {
  const std::shared_ptr<const OccupancyCells> costs = costsOfMap(moment);
  return costs ? gridMessage(moment, "map", *costs) : Value();
}

Value globalCostsUpdate(const Moment& moment) {
  const std::shared_ptr<const OccupancyCells> costs = costsOfMap(moment);
  Value patch = costs ? gridPatchMessage(moment, *costs) : Value();
  if (patch.isNull()) return patch;
  // Somebody walks beside the robot.
  GridPlace place{static_cast<int>(patch["width"].number()), static_cast<int>(patch["height"].number()),
                  costs->place.resolution_m, costs->place.origin_m};
  place.origin_m += costs->place.resolution_m * Eigen::Vector2d(patch["x"].number(), patch["y"].number());
  const Solid person{moment.pose.apply({1.5, 1.0}), {kPersonM, kPersonM}, 0, true, true};
  patch.set("data", occupancyOf(costsOf(moment.robot.plan(), {person}, place), place).cells);
  return patch;
}

constexpr const char* kDate = "%Y-%m-%d %H:%M:%S";

Value mapList(const std::vector<KabamMap>& maps, bool archived, bool both = false) {
  Value::List list;
  for (const KabamMap& map : maps) {
    if (!both && map.archived != archived) continue;
    list.push_back(Value::Object{{"map_name", map.name}, {"map_label", map.label}, {"map_id", map.id}});
  }
  return Value::Object{{"maps", std::move(list)}};
}

Value mapInfoMessage(const KabamStore& kabam) {
  const std::optional<KabamMap> map = kabam.current();
  const ManagerState state = kabam.state();
  return Value::Object{{"map_id", map ? map->id : ""},
                       {"map_name", map ? map->name : ""},
                       {"map_label", map ? map->label : ""},
                       {"updated_at", map ? dateOf(map->updated_s, kDate) : ""},
                       {"created_at", map ? dateOf(map->created_s, kDate) : ""},
                       {"map_manager_state", state == ManagerState::Idle      ? "IDLE"
                                             : state == ManagerState::Mapping ? "MAPPING"
                                                                              : "ACTIVE"}};
}

/// The topics that RosFaults::wrong_type is about.
bool hasOddType(std::string_view topic) { return topic == "/map" || topic == "/scan" || topic == "/odom"; }

std::vector<TopicRow> topicTable(const Options& options) {
  const bool is_ros1 = options.ros.dialect == RosDialect::Ros1;
  constexpr bool kLatched = true, kSlow = true;
  std::vector<TopicRow> rows;
  if (!options.ros.dispatcher.there) {
    rows = {{"/map", "nav_msgs/OccupancyGrid", 5, kLatched, kSlow, mapMessage},
            {"/map_updates", "map_msgs/OccupancyGridUpdate", 1, false, kSlow, mapUpdate}};
  }
  const std::vector<TopicRow> usual{
      {"/global_costmap/costmap", "nav_msgs/OccupancyGrid", 0, kLatched, kSlow, globalCosts},
      {"/global_costmap/costmap_updates", "map_msgs/OccupancyGridUpdate", 1, false, kSlow, globalCostsUpdate},
      {"/local_costmap/costmap", "nav_msgs/OccupancyGrid", 0.5, kLatched, kSlow, localCosts},
      {"/plan", "nav_msgs/Path", 1, kLatched, false,
       [](const Moment& moment) { return pathMessage(moment, -1); }},
      {"/local_plan", "nav_msgs/Path", 0.2, false, false,
       [](const Moment& moment) { return pathMessage(moment, kLocalPlanM); }},
      {"/scan", "sensor_msgs/LaserScan", 0.1, false, false, laserScanMessage},
      {"/points", "sensor_msgs/PointCloud2", 1 / options.scan_hz, false, kSlow, pointCloudMessage},
      {"/odom", "nav_msgs/Odometry", 0.05, false, false, odometryMessage},
      {"/amcl_pose", "geometry_msgs/PoseWithCovarianceStamped", 0.5, kLatched, false, amclPoseMessage},
      {"/tf", "tf2_msgs/TFMessage", 0.02, false, false, tfMessage},
      {"/tf_static", "tf2_msgs/TFMessage", 0, kLatched, false, tfStaticMessage},
      {is_ros1 ? "/move_base/local_costmap/footprint" : "/local_costmap/published_footprint",
       "geometry_msgs/PolygonStamped", 0.2, false, false, footprintMessage},
      {"/markers", "visualization_msgs/MarkerArray", 1, kLatched, false, markersMessage},
      {"/goal_pose", "geometry_msgs/PoseStamped", 1, kLatched, false, goalMessage},
      {"/initialpose", "geometry_msgs/PoseWithCovarianceStamped"},
      {"/cmd_vel", "geometry_msgs/Twist"}};
  rows.insert(rows.end(), usual.begin(), usual.end());
  if (options.ros.kabam) {
    rows.push_back({kMapInfoTopic, "kabam_msgs/MapInfo", 0, kLatched, false,
                    [](const Moment& moment) { return mapInfoMessage(moment.kabam); }});
    rows.push_back({kMapListTopic, "kabam_msgs/MapList", 0, kLatched, false, [](const Moment& moment) {
                      return mapList(moment.kabam.maps(), false,
                                     moment.options.ros.kabam_list_holds_archived);
                    }});
    rows.push_back({kArchivedListTopic, "kabam_msgs/MapList", 0, kLatched, false,
                    [](const Moment& moment) { return mapList(moment.kabam.maps(), true); }});
    rows.push_back(
        {kWaypointsTopic, "kabam_msgs/MapWaypointList", 0, kLatched, false, [](const Moment& moment) {
           return waypointList(moment.kabam.current().value_or(KabamMap{}), moment.faults);
         }});
  }
  const DispatcherOptions& dispatcher = options.ros.dispatcher;
  if (dispatcher.there && dispatcher.planar)
    rows.push_back({"/map_metadata", "nav_msgs/MapMetaData", 0, kLatched});
  for (const std::string_view name : Dispatcher::projectedTopics()) {
    if (dispatcher.there && dispatcher.spatial)
      rows.push_back({name, "map_msgs/ProjectedMap", 0, kLatched, kSlow});
  }
  return rows;
}

}  // namespace

RosRobot::RosRobot(const Options& options, const RobotState& robot, const FaultPlan& faults,
                   KabamStore& kabam, MapPictures& pictures)
    : options_(options),
      robot_(robot),
      faults_(faults),
      kabam_(kabam),
      pictures_(pictures),
      dispatcher_(options, faults),
      types_(options.ros.dialect),
      topics_(topicTable(options)),
      services_(allServices()) {}

const TopicRow* RosRobot::topic(std::string_view name) const { return byName(topics_, name); }

std::string_view RosRobot::typeOf(const TopicRow& topic) const {
  return hasOddType(topic.name) && faults_.faults().ros.wrong_type ? "std_msgs/String" : topic.type;
}

Moment RosRobot::momentOf(const RosFaults& faults) {
  return {robot_, kabam_, pictures_, costs_, options_, faults, robot_.time(), robot_.robotPose()};
}

Value RosRobot::messageOf(std::string_view name) {
  const TopicRow* const row = topic(name);
  if (row == nullptr) return {};
  if (row->make == nullptr) return dispatcher_.messageOf(name);
  const RosFaults faults = faults_.faults().ros;
  if (faults.wrong_type && hasOddType(name)) return Value::Object{{"data", "this topic is of another type"}};
  return row->make(momentOf(faults));
}

std::vector<Service> RosRobot::allServices() {
  std::vector<Service> rows;
  const bool is_ros1 = options_.ros.dialect == RosDialect::Ros1;
  if (!options_.ros.dispatcher.there) {
    const std::string name = is_ros1 ? "/static_map" : "/map_server/map";
    rows.push_back({name, "nav_msgs/GetMap", [this, name](const Value&, bool) -> Answer {
                      const RosFaults faults = faults_.faults().ros;
                      const Value map = mapMessage(momentOf(faults));
                      if (!map.isNull()) return Value::Object{{"map", map}};
                      return tl::make_unexpected("service [" + name +
                                                 "] responded with an error: b'there is no map'");
                    }});
  }
  const std::vector<Service> dispatcher = dispatcher_.services(), kabam = kabam_.services();
  rows.insert(rows.end(), dispatcher.begin(), dispatcher.end());
  if (options_.ros.kabam) rows.insert(rows.end(), kabam.begin(), kabam.end());
  const auto rosapi = [&](const char* name, std::string_view type, auto answer) {
    const auto told = [answer](const Value& request, bool) -> Answer { return answer(request); };
    if (options_.ros.rosapi) rows.push_back({std::string("/rosapi/") + name, type, told});
  };
  const auto typeOfOne = [this](const auto& all, const std::string& name) {
    const auto* const row = byName(all, name);
    return Value::Object{{"type", row == nullptr ? std::string() : wireType(*row)}};
  };
  rosapi("topics", "rosapi/Topics", [this](const Value&) {
    Value::List names, types;
    for (const TopicRow& topic : presentTopics()) {
      names.emplace_back(topic.name);
      types.emplace_back(wireType(topic));
    }
    return Value::Object{{"topics", std::move(names)}, {"types", std::move(types)}};
  });
  rosapi("topic_type", "rosapi/TopicType", [this, typeOfOne](const Value& request) {
    return typeOfOne(presentTopics(), request["topic"].text());
  });
  rosapi("topics_for_type", "rosapi/TopicsForType", [this](const Value& request) {
    Value::List names;
    for (const TopicRow& topic : presentTopics()) {
      if (wireType(topic) == request["type"].text()) names.emplace_back(topic.name);
    }
    return Value::Object{{"topics", std::move(names)}};
  });
  rosapi("services", "rosapi/Services", [this](const Value&) {
    Value::List names;
    for (const Service& row : services_) names.emplace_back(row.name);
    return Value::Object{{"services", std::move(names)}};
  });
  rosapi("service_type", "rosapi/ServiceType",
         [this, typeOfOne](const Value& request) { return typeOfOne(services_, request["service"].text()); });
  rosapi("nodes", "rosapi/Nodes", [this](const Value&) {
    Value::List names{"/amcl", "/map_server", "/move_base", "/robot_state_publisher", "/rosbridge_websocket"};
    if (options_.ros.kabam) names.emplace_back("/map_manager");
    if (options_.ros.dispatcher.there) names.emplace_back("/map_dispatcher");
    names.emplace_back("/rosapi");
    return Value::Object{{"nodes", std::move(names)}};
  });
  rosapi("message_details", "rosapi/MessageDetails",
         [this](const Value& request) { return types_.details(request["type"].text()); });
  return rows;
}

const Service* RosRobot::service(std::string_view name) const { return byName(services_, name); }

unsigned RosRobot::kindsOf(std::string_view name) const {
  const Service* const known = service(name);
  return kServices | (known != nullptr && known->changes ? kWrites : kReads);
}

Answer RosRobot::call(std::string_view name, const Value& args, const Verdict& verdict) {
  // ROS resolves names that are not whole; roslib asks for "rosapi/topics".
  const std::string whole = name.starts_with('/') ? std::string(name) : '/' + std::string(name);
  const Service* const known = service(whole);
  if (known == nullptr) return tl::make_unexpected("Service " + whole + " does not exist");
  const std::string type = std::string(known->type) + "Request";
  const Answer request = args.as<Value::List>() != nullptr ? types_.fromList(type, *args.as<Value::List>())
                                                           : types_.complete(type, args);
  return request ? known->answer(*request, !verdict.is(FaultKind::Ignore)) : request;
}

/// Those that there are now.
std::vector<TopicRow> RosRobot::presentTopics() const {
  std::vector<TopicRow> rows = topics_;
  std::erase_if(rows, [&](const TopicRow& row) { return !dispatcher_.has(row.name); });
  return rows;
}

std::string RosRobot::wireType(const TopicRow& topic) const {
  return typeName(typeOf(topic), "msg", options_.ros.dialect);
}

std::string RosRobot::wireType(const Service& service) const {
  if (options_.ros.dialect == RosDialect::Ros2 && service.type.starts_with("rosapi/"))
    return "rosapi_msgs/srv/" + std::string(service.type.substr(service.type.find('/') + 1));
  std::string name = typeName(service.type, "srv", options_.ros.dialect);
  if (options_.ros.dispatcher.map_msg && name.starts_with("map_msgs/")) name.erase(7, 1);
  return name;
}

}  // namespace mapwright::simulator::ros
