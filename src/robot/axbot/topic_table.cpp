#include "robot/axbot/topic_table.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

#include <QCoreApplication>

#include "map/submap_version.h"
#include "robot/axbot/faults.h"
#include "robot/axbot/parse_maps.h"

namespace mapwright::robot::axbot {
namespace {

using wire::Json;

/// A number; `missing` if the member is absent, NaN if it is not a number.
double number(const Json& object, std::string_view name, double missing) {
  Json value;
  return object[name].get(value) ? missing : wire::asNumber(value).value_or(wire::kNaN);
}

/// The pose of a list entry. Missing members are harmless (z, or an omitted quaternion); invalid ones make
/// the pose invalid.
geometry::Pose3 entryPose(const Json& entry) {
  Json pose;
  if (entry["pose"].get(pose)) return {wire::kNaN, wire::kNaN, 0, 0, 0, 0, 0};
  Json any;
  if (pose["qw"].get(any) && pose["qx"].get(any) && pose["qy"].get(any) && pose["qz"].get(any)) {
    Json pos;
    if (!pose["pos"].get(pos)) {
      const auto xy = wire::asPoint(pos);
      return xy ? geometry::poseFromYaw(xy->x(), xy->y(), number(pose, "ori", 0))
                : geometry::Pose3{wire::kNaN, wire::kNaN};
    }
    return {number(pose, "x", wire::kNaN), number(pose, "y", wire::kNaN), number(pose, "z", 0), 0, 0, 0, 1};
  }
  return {number(pose, "x", 0),  number(pose, "y", 0),  number(pose, "z", 0), number(pose, "qx", 0),
          number(pose, "qy", 0), number(pose, "qz", 0), number(pose, "qw", 0)};
}

map::SlamState slamState(const Json& message) {
  const std::string state = wire::text(message, {"slam_state"});
  if (state == "slam" || state == "SLAM_STATE_SLAM" || state == "1") return map::SlamState::Slam;
  if (state == "positioning" || state == "SLAM_STATE_POSITIONING" || state == "2")
    return map::SlamState::Positioning;
  return map::SlamState::Invalid;
}

map::TopicMessage submapList(const Json& message) {
  map::SubmapList list;
  list.slam_state = slamState(message);
  list.uuid = wire::text(message, {"uuid"});
  const auto member = wire::member(message, {"submap", "submaps"});
  if (!member)
    return map::UnreadableMessage{
        "/submap_list", faultText("axbot", "It contains no list of submaps. The previous list stays.")};
  wire::JsonList rows;
  if (member->get(rows)) return map::UnreadableMessage{"/submap_list", {fault::MemberIsNoList, {"submap"}}};
  list.entries.reserve(rows.size());
  std::size_t position = 0;
  for (const Json row : rows) {
    ++position;
    const auto trajectory = wire::smallInteger(row, {"trajectory_id"});
    const auto index = wire::smallInteger(row, {"submap_index"});
    const auto version = wire::smallInteger(row, {"submap_version"});
    if (!trajectory || !index) {
      list.rejected.push_back({fault::RowWithoutNumbers, {std::int64_t(position)}});
      continue;
    }
    list.entries.push_back({{*trajectory, *index},
                            std::max(version.value_or(map::kNoVersion), map::kNoVersion),
                            entryPose(row),
                            wire::flag(row, {"is_frozen"}).value_or(false),
                            wire::flag(row, {"is_incremental_submap"}).value_or(false),
                            wire::flag(row, {"is_nearby_map"}).value_or(false)});
  }
  return usable(std::move(list));
}

map::TopicMessage trackedPose(const Json& message) {
  const auto pose = wire::asPose(message);
  Json heading;
  // A missing heading is 0; one that is not a number makes the pose invalid.
  const bool spoilt = !message["ori"].get(heading) && !wire::asNumber(heading);
  if (!pose || spoilt) {
    return map::UnreadableMessage{"/tracked_pose",
                                  Fault(faultText("axbot", "The robot's pose contains no valid numbers."))
                                      .followedBy(Consequence::StaysWhereItWas)};
  }
  return map::TrackedPose{*pose};
}

map::Polyline outline(const Json& message, std::string_view name) {
  map::Polyline corners = wire::polyline(message, {name});
  if (corners.size() < 3) corners.clear();
  return corners;
}

map::TopicMessage robotModel(const Json& message) {
  map::RobotModel model;
  model.width_m = std::max(0.0, wire::number(message, {"width"}).value_or(0));
  model.footprint = outline(message, "footprint");
  model.expanded_footprint = outline(message, "expanded_footprint");
  return model;
}

/// "#RRGGBBAA", "##RRGGBBAA" (as documented), "#RRGGBB".
std::optional<std::uint32_t> colour(std::string_view text) {
  while (text.starts_with('#')) text.remove_prefix(1);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (text.size() == 8) return value;
  return text.size() == 6 ? std::optional((value << 8) | 0xff) : std::nullopt;
}

map::TopicMessage localPath(const Json& message) {
  return map::LocalPathMessage{.width_m = std::max(0.0, wire::number(message, {"width"}).value_or(0)),
                               .rgba = colour(wire::text(message, {"color", "colour"})),
                               .points = wire::polyline(message, {"poses", "positions", "points"})};
}

/// Some write "none", others "None - None".
std::string meaningful(std::string text) {
  std::string lower = text;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return lower == "none" || lower == "none - none" || lower == "0" ? std::string() : text;
}

map::TopicMessage planningState(const Json& message) {
  map::PlanningState state;
  state.action_id = wire::integer(message, {"action_id"});
  state.action_type = wire::text(message, {"action_type", "move_intent"});
  state.move_state = wire::text(message, {"move_state"});
  state.fail_reason = meaningful(wire::text(message, {"fail_reason_str", "fail_message", "fail_reason"}));
  state.stuck_state = meaningful(wire::text(message, {"stuck_state"}));
  state.remaining_distance_m = wire::number(message, {"remaining_distance"});
  if (const auto targets = wire::list(message, {"target_poses"})) {
    for (const Json target : *targets) {
      if (const auto pose = wire::asPose(target)) state.targets.push_back(*pose);
    }
  }
  return state;
}

map::TopicMessage globalPositioning(const Json& message) {
  map::GlobalPositioning state;
  state.state = wire::text(message, {"state"});
  state.message = wire::text(message, {"message", "msg"});
  state.score = wire::number(message, {"score"});
  state.needs_confirmation = wire::flag(message, {"needs_confirmation"});
  if (const auto pose = wire::member(message, {"pose"})) state.pose = wire::asPose(*pose);
  return state;
}

map::TopicMessage slamStatus(const Json& message) {
  return map::SlamStatus{.state = wire::text(message, {"state"}),
                         .reliable = wire::flag(message, {"reliable"}),
                         .position_quality = wire::smallInteger(message, {"position_quality"}),
                         .lidar_matching_score = wire::number(message, {"lidar_matching_score"}),
                         .lidar_matched = wire::flag(message, {"lidar_matched"}),
                         .wheel_slipping = wire::flag(message, {"wheel_slipping"})};
}

map::TopicMessage batteryState(const Json& message) {
  map::BatteryState state;
  if (auto level = wire::number(message, {"percentage", "level"})) {
    // Some firmware sends 0..1, some 0..100.
    if (*level > 1) *level /= 100;
    state.level = std::clamp(*level, 0.0, 1.0);
  }
  state.voltage_v = wire::number(message, {"voltage"});
  state.current_a = wire::number(message, {"current"});
  state.supply = wire::text(message, {"power_supply_status"});
  return state;
}

map::TopicMessage wheelState(const Json& message) {
  return map::WheelState{wire::text(message, {"control_mode"}),
                         wire::flag(message, {"emergency_stop_pressed", "emergency_stop"}),
                         wire::flag(message, {"wheels_released"})};
}

map::TopicMessage jackState(const Json& message) {
  return map::JackState{wire::text(message, {"state"}), wire::number(message, {"progress"}),
                        wire::flag(message, {"self_checking"}), wire::number(message, {"weight"})};
}

map::TopicMessage towingState(const Json& message) {
  return map::TowingState{
      wire::text(message, {"state"}), wire::number(message, {"action_progress", "progress"}),
      wire::flag(message, {"cargo_detected"}), wire::integer(message, {"error_code"}).value_or(0),
      wire::text(message, {"error_message"})};
}

map::AlertLevel alertLevel(const Json& alert) {
  const std::string level = wire::text(alert, {"level"});
  if (level == "error" || level == "fatal" || level == "critical" || level == "2") {
    return map::AlertLevel::Error;
  }
  if (level == "warning" || level == "warn" || level == "1") return map::AlertLevel::Warning;
  return map::AlertLevel::None;
}

map::TopicMessage alerts(const Json& message) {
  map::AlertsMessage alerts;
  const auto rows = wire::member(message, {"alerts"});
  if (!rows) return alerts;
  wire::JsonList list;
  if (rows->get(list)) {
    return map::UnreadableMessage{"/alerts",
                                  {fault::MemberIsNoList, {"alerts"}, {}, Consequence::AlertsBeforeStay}};
  }
  for (const Json row : list) {
    if (!row.is_object()) continue;
    alerts.alerts.push_back({wire::integer(row, {"code"}).value_or(0), alertLevel(row),
                             wire::text(row, {"msg", "message", "text"}), 0});
  }
  return alerts;
}

map::TopicMessage mapInfo(const Json& message) {
  map::MapInfo info;
  info.name = wire::text(message, {"name", "map_name"});
  info.uid = wire::text(message, {"uid", "map_uid"});
  info.map_version = wire::smallInteger(message, {"map_version"});
  info.overlays_version = wire::smallInteger(message, {"overlays_version"});
  if (const auto overlays = wire::member(message, {"overlays"}))
    info.overlays =
        parseOverlays(*overlays, &info.broken_overlays).value_or(std::vector<map::OverlayFeature>());
  return info;
}

map::TopicMessage path(const Json& message) {
  return map::PathMessage{wire::polyline(message, {"positions", "points", "poses"})};
}

map::TopicMessage trajectory(const Json& message) {
  return map::TrajectoryMessage{wire::polyline(message, {"points", "positions"})};
}

map::TopicMessage sensorState(const Json& message) {
  return map::SensorState{wire::text(message, {"power_state"})};
}

class SeenObjectsText {
  Q_DECLARE_TR_FUNCTIONS(SeenObjects)
};

/// VisualObjectLabel of the robot's reference; a null text for others.
QString nameOf(std::int64_t label) {
  switch (label) {
    case 1:
      return SeenObjectsText::tr("person");
    case 2:
      return SeenObjectsText::tr("platform hand truck");
    case 3:
      return SeenObjectsText::tr("scaffold");
    case 4:
      return SeenObjectsText::tr("queue stand");
    case 5:
      return SeenObjectsText::tr("portable grandstand");
    default:
      return {};
  }
}

QString rackName(bool aligned) {
  return aligned ? SeenObjectsText::tr("rack (aligned)") : SeenObjectsText::tr("rack");
}

bool isRobotFrame(const Json& object) {
  const std::string frame = wire::text(object, {"frame", "frame_id"});
  return frame == "base_link" || frame == "base_footprint" || frame == "robot";
}

std::optional<geometry::Pose2> poseOf(const Json& object) {
  return wire::asPose(wire::member(object, {"pose"}).value_or(object));
}

/// Calls `visit` for every object in a list member; anything else counts as empty.
template <typename Visit>
void forEachObject(const Json& message, wire::Names names, Visit visit) {
  const auto rows = wire::list(message, names);
  if (!rows) return;
  for (const Json row : *rows) {
    if (row.is_object()) visit(row);
  }
}

map::TopicMessage nearbyRobots(const Json& message) {
  map::NearbyRobotsMessage robots;
  forEachObject(message, {"robots"}, [&](const Json& row) {
    if (const auto pose = poseOf(row)) {
      robots.robots.push_back({wire::text(row, {"uid", "id", "sn"}), *pose, wire::polyline(row, {"trend"}),
                               wire::text(row, {"footprint_digest"})});
    }
  });
  return robots;
}

map::TopicMessage nearbyFootprints(const Json& message) {
  map::NearbyFootprintsMessage footprints;
  forEachObject(message, {"footprints"}, [&](const Json& row) {
    auto outline = wire::polyline(row, {"coordinates", "footprint"});
    if (outline.size() >= 3) footprints.by_digest[wire::text(row, {"digest"})] = std::move(outline);
  });
  return footprints;
}

map::TopicMessage landmarks(const Json& message) {
  map::LandmarksMessage landmarks;
  forEachObject(message, {"landmarks"}, [&](const Json& row) {
    if (const auto at = wire::asPoint(row)) {
      landmarks.landmarks.push_back({wire::text(row, {"id"}), *at, wire::flag(row, {"in_use"})});
    }
  });
  return landmarks;
}

map::TopicMessage autoDoors(const Json& message) {
  map::AutoDoorsMessage doors;
  forEachObject(message, {"doors"}, [&](const Json& row) {
    map::AutoDoor door{wire::text(row, {"name"}), wire::text(row, {"mac"}), wire::text(row, {"state"}), {}};
    door.polygon = wire::polyline(row, {"polygon"});
    if (const auto rings = wire::list(row, {"polygon"}); door.polygon.empty() && rings && rings->size() > 0) {
      door.polygon = wire::asPolyline(rings->at(0).value_unsafe());  // rings, as in GeoJSON
    }
    if (door.polygon.size() >= 2) doors.doors.push_back(std::move(door));
  });
  return doors;
}

std::optional<map::GroundBox> box(const Json& holder, std::string label, std::optional<double> length,
                                  std::optional<double> width, bool in_robot_frame) {
  const auto pose = poseOf(holder);
  if (!pose) return std::nullopt;
  return map::GroundBox{std::move(label), *pose, std::max(0.0, length.value_or(0)),
                        std::max(0.0, width.value_or(0)), in_robot_frame};
}

map::TopicMessage pallets(const Json& message) {
  map::PalletsMessage pallets;
  forEachObject(message, {"pallets"}, [&](const Json& row) {
    const Json size = wire::member(row, {"size"}).value_or(row);
    // A fork comes along x: the depth is along it.
    const auto pallet =
        box(row, wire::text(row, {"pallet_id", "id"}), wire::number(size, {"depth", "length"}),
            wire::number(size, {"width"}), isRobotFrame(row));
    if (pallet) pallets.pallets.push_back(*pallet);
  });
  return pallets;
}

map::TopicMessage rack(const Json& message) {
  map::RackMessage rack;
  const bool seen = wire::flag(message, {"rack_detected"}).value_or(true);
  for (const char* name : {"rack_box", "rack_box_aligned"}) {
    const auto given = wire::member(message, {name});
    if (!seen || !given) continue;
    // Seen from above: width along x, height along y.
    const auto found = box(*given, rackName(name != std::string_view("rack_box")).toStdString(),
                           wire::number(*given, {"width"}), wire::number(*given, {"height", "depth"}),
                           isRobotFrame(message));
    if (found) rack.racks.push_back(*found);
  }
  return rack;
}

/// The form of these is not documented but for poses: what is a pose is read, and a size if there is one.
map::DetectedFeaturesMessage features(const Json& message, map::BoxKind kind) {
  map::DetectedFeaturesMessage seen{kind, {}};
  const bool in_robot_frame = isRobotFrame(message);
  for (const char* list : {"racks", "pallets", "chargers", "poses", "features"}) {
    forEachObject(message, {list}, [&](const Json& row) {
      const Json size = wire::member(row, {"size"}).value_or(row);
      const auto found = box(row, wire::text(row, {"rack_id", "pallet_id", "id", "name"}),
                             wire::number(size, {"depth", "length"}), wire::number(size, {"width"}),
                             in_robot_frame || isRobotFrame(row));
      if (found) seen.boxes.push_back(*found);
    });
  }
  return seen;
}
map::TopicMessage seenRacks(const Json& message) { return features(message, map::BoxKind::Rack); }
map::TopicMessage seenPallets(const Json& message) { return features(message, map::BoxKind::Pallet); }
map::TopicMessage seenChargers(const Json& message) { return features(message, map::BoxKind::Charger); }

std::string objectLabel(const Json& row) {
  const auto label = wire::integer(row, {"label"});
  if (label == 0) return {};
  const QString name = nameOf(label.value_or(-1));
  return name.isEmpty() ? wire::text(row, {"label"}) : name.toStdString();
}

map::TopicMessage seenObjects(const Json& message) {
  map::SeenObjectsMessage objects;
  const bool in_robot_frame = isRobotFrame(message);
  forEachObject(message, {"boxes", "objects"}, [&](const Json& row) {
    std::optional<double> width, length;  // dimensions: width, length, height
    if (const auto sizes = wire::list(row, {"dimensions"}); sizes && sizes->size() >= 2) {
      width = wire::asNumber(sizes->at(0).value_unsafe());
      length = wire::asNumber(sizes->at(1).value_unsafe());
    }
    const auto object = box(row, objectLabel(row), length, width, in_robot_frame || isRobotFrame(row));
    if (object) objects.objects.push_back(*object);
  });
  return objects;
}

using Segments = std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>;

/// Segments as [x1, y1, x2, y2], as [[x1, y1], [x2, y2]], or as pairs of points.
Segments segments(const wire::JsonList& rows) {
  Segments segments;
  Eigen::Vector2d start(0, 0);
  bool started = false;
  for (const Json row : rows) {
    wire::JsonList parts;
    if (row.get(parts)) continue;
    const auto flat = wire::asPoint(row);
    if (flat && parts.size() == 4) {
      const auto x = wire::asNumber(parts.at(2).value_unsafe()),
                 y = wire::asNumber(parts.at(3).value_unsafe());
      if (x && y) segments.emplace_back(*flat, Eigen::Vector2d(*x, *y));
    } else if (flat && started) {
      segments.emplace_back(start, *flat);
      started = false;
    } else if (flat) {
      start = *flat;
      started = true;
    } else if (const auto ends = wire::asPolyline(row); ends.size() == 2) {
      segments.emplace_back(ends[0], ends[1]);
    }
  }
  return segments;
}

map::TopicMessage constraints(const Json& message) {
  map::ConstraintsMessage constraints;
  const Json holder = wire::member(message, {"constraints"}).value_or(message);
  simdjson::dom::object members;
  if (holder.get(members)) return constraints;
  for (const auto& [name, value] : members) {
    wire::JsonList rows;
    if (!value.get(rows)) constraints.by_name[std::string(name)] = segments(rows);
  }
  return constraints;
}

map::TopicMessage barcode(const Json& message) {
  const Json code = wire::member(message, {"barcode"}).value_or(message);
  map::BarcodeMessage barcode{wire::text(message, {"state"}), wire::text(code, {"id", "barcode_id"}), {}};
  if (const auto pose = wire::member(code, {"pose"})) barcode.pose = wire::asPose(*pose);
  return barcode;
}

using map::GridKind;
using map::Stream;

constexpr Topic kTopics[] = {
    {.name = "/map", .picture = GridKind::WholeMap, .stream = Stream::WholeMap, .older = true},
    {.name = "/map_v2", .picture = GridKind::WholeMap, .stream = Stream::WholeMap},
    {.name = "/map_image", .picture = GridKind::WholeMap, .offered = false},  // in bags
    {.name = "/map/costmap_v2", .picture = GridKind::CostmapLow},
    {.name = "/maps/5cm/1hz", .picture = GridKind::CostmapLow, .stream = Stream::CostmapLow},
    {.name = "/maps/1cm/1hz", .picture = GridKind::CostmapHigh, .stream = Stream::CostmapHigh},
    {.name = "/incremental_map",
     .picture = GridKind::Incremental,
     .stream = Stream::Incremental,
     .older = true},
    {.name = "/incremental_map_v2", .picture = GridKind::Incremental, .stream = Stream::Incremental},
    {.name = "/env_match_map", .picture = GridKind::EnvMatch, .stream = Stream::EnvMatch},
    {.name = "/env_symmetry_map", .picture = GridKind::EnvSymmetry, .stream = Stream::EnvSymmetry},
    {.name = "/submap_list", .read = submapList},
    {.name = "/tracked_pose", .read = trackedPose, .stream = Stream::Pose},
    {.name = "/robot_model", .read = robotModel, .stream = Stream::Model},
    {.name = "/path", .read = path, .stream = Stream::Path},
    {.name = "/local_path", .read = localPath, .stream = Stream::LocalPath},
    {.name = "/trajectory", .read = trajectory, .stream = Stream::Trajectory},
    {.name = "/trajectory_node_list", .read = trajectory, .stream = Stream::Trajectory},
    {.name = "/scan_matched_points2", .stream = Stream::Cloud},
    {.name = "/semantic_points"},
    {.name = "/left_laser_2d/matched"},
    {.name = "/right_laser_2d/matched"},
    {.name = "/matched_depth_points/forward"},
    {.name = "/matched_depth_points/downward"},
    {.name = "/matched_depth_points/upward"},
    {.name = "/slam/state", .read = slamStatus},
    {.name = "/planning_state", .read = planningState, .stream = Stream::Planning},
    {.name = "/map/info", .read = mapInfo, .stream = Stream::MapInfo},
    {.name = "/alerts", .read = alerts, .stream = Stream::Alerts},
    {.name = "/battery_state", .read = batteryState, .stream = Stream::Battery},
    {.name = "/detailed_battery_state", .read = batteryState},
    {.name = "/wheel_state", .read = wheelState, .stream = Stream::Wheels},
    {.name = "/sensor_manager_state", .read = sensorState, .stream = Stream::Sensors},
    {.name = "/jack_state", .read = jackState, .stream = Stream::Sensors},
    {.name = "/towing_state", .read = towingState, .stream = Stream::Sensors},
    {.name = "/nearby_robots", .read = nearbyRobots, .stream = Stream::NearbyRobots},
    {.name = "/nearby_robot_footprints", .read = nearbyFootprints, .stream = Stream::NearbyFootprints},
    {.name = "/landmarks", .read = landmarks, .stream = Stream::Landmarks},
    {.name = "/nearby_auto_doors", .read = autoDoors, .stream = Stream::Doors},
    {.name = "/detected_pallets", .read = pallets, .stream = Stream::Pallets},
    {.name = "/detected_rack", .read = rack, .stream = Stream::Racks},
    {.name = "/detected_features/racks_v2", .read = seenRacks},
    {.name = "/detected_features/pallets", .read = seenPallets},
    {.name = "/detected_features/chargers", .read = seenChargers},
    {.name = "/global_positioning_state", .read = globalPositioning, .stream = Stream::GlobalPositioning},
    {.name = "/constraint_list", .read = constraints, .stream = Stream::Constraints},
    {.name = "/vision_detected_objects", .read = seenObjects, .stream = Stream::SeenObjects},
    {.name = "/collected_barcode", .read = barcode},
    {.name = "/chassis/occupancy_grid", .picture = GridKind::WholeMap, .offered = false},
    {.name = "/map/costmap", .picture = GridKind::CostmapLow, .offered = false},
};

}  // namespace

const Topic* findTopic(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kTopics), std::end(kTopics),
                                         [&](const Topic& topic) { return topic.name == name; });
  return found == std::end(kTopics) ? nullptr : found;
}

StreamTopics topicsOf(Stream stream) {
  StreamTopics topics;
  for (const Topic& topic : kTopics) {
    if (topic.stream == stream)
      (topic.older ? topics.older : topics.usual) << QLatin1String(topic.name.data());
  }
  return topics;
}

QStringList knownTopics() {
  QStringList names;
  for (const Topic& topic : kTopics) {
    if (topic.offered) names << QLatin1String(topic.name.data());
  }
  return names;
}

}  // namespace mapwright::robot::axbot
