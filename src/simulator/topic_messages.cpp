#include "simulator/topic_messages.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ros_messages/wrapper.pb.h"
#include "simulator/axbot_routes.h"
#include "simulator/lidar.h"
#include "simulator/noise.h"

namespace mapwright::simulator {
namespace {

constexpr std::size_t kGzipFrom = 4096;
constexpr int kLargeCostmap = 500;  // cells of an edge: from here on, pictures are made once in a while
constexpr double kLargeCostmapForS = 10;
constexpr double kEnvironmentM = 0.1;
constexpr double kPatchM = 3;  // the environment has changed in patches of this size
constexpr int kLargeScan = 5000;
constexpr std::int64_t kPrepared = 8;
constexpr int kMostPoints = 1'000'000;
constexpr float kBinaryResolutionM = 0.001F;
constexpr std::string_view kMatchedPoints = "/scan_matched_points2", kPacked = "/left_laser_2d/matched",
                           kSemantic = "/semantic_points";

/// Topic length, topic, gzip flag, RosMessageWrapper (gzipped if large).
std::string binaryMessage(std::string_view topic, const ros_messages::RosMessageWrapper& wrapper) {
  std::string payload = wrapper.SerializeAsString();
  const bool zipped = payload.size() >= kGzipFrom;
  if (zipped) payload = gzip(payload);
  std::string frame;
  frame += static_cast<char>(topic.size());
  frame += topic;
  frame += static_cast<char>(zipped ? 1 : 0);
  return frame + payload;
}

ros_messages::slam::SlamState wireOf(map::SlamState state) {
  return state == map::SlamState::Slam          ? ros_messages::slam::SLAM_STATE_SLAM
         : state == map::SlamState::Positioning ? ros_messages::slam::SLAM_STATE_POSITIONING
                                                : ros_messages::slam::SLAM_STATE_INVALID;
}

std::string submapListBinary(const map::SubmapList& list) {
  ros_messages::RosMessageWrapper wrapper;
  wrapper.set_type(ros_messages::SUBMAP_LIST);
  ros_messages::slam::SubmapList& message = *wrapper.mutable_submap_list();
  message.set_slam_state(wireOf(list.slam_state));
  message.set_uuid(list.uuid);
  for (const map::SubmapEntry& entry : list.entries) {
    ros_messages::slam::SubmapEntry& row = *message.add_submaps();
    row.set_trajectory_id(entry.id.trajectory);
    row.set_submap_index(entry.id.index);
    row.set_submap_version(entry.version);
    *row.mutable_pose() = messageOf(entry.pose);
    row.set_is_frozen(entry.is_frozen);
    row.set_is_incremental_submap(entry.is_incremental);
    row.set_is_nearby_map(entry.is_nearby);
  }
  return binaryMessage(kSubmapListTopic, wrapper);
}

/// Rows as a robot with a broken SLAM sends them: NaN, zero quaternions, duplicates, a version going back.
void addBadEntries(map::SubmapList& list) {
  const std::vector<map::SubmapEntry> good(
      list.entries.begin(), list.entries.begin() + std::min<std::ptrdiff_t>(2, std::ssize(list.entries)));
  map::SubmapEntry bad;
  bad.version = 1;
  bad.id = {90, 0};
  bad.pose.x = std::numeric_limits<double>::quiet_NaN();
  list.entries.push_back(bad);
  bad.id = {90, 1};
  bad.pose = {};
  bad.pose.qw = 0;
  list.entries.push_back(bad);
  if (!good.empty()) list.entries.push_back(good.front());
  if (good.size() > 1) {
    map::SubmapEntry back = good[1];
    back.version -= 1;
    list.entries.push_back(back);
  }
}

std::string pointsJson(const std::vector<LidarPoint>& points, double time_s) {
  // Milliseconds here, as these robots have it; seconds in most other topics.
  std::string out =
      R"({"topic":"/scan_matched_points2","stamp":)" + std::to_string(std::llround(1000 * stampOf(time_s)));
  out.reserve(out.size() + points.size() * 24);
  out += ",\"points\":[";
  bool first = true;
  for (const LidarPoint& point : points) {
    out += first ? "[" : ",[";
    first = false;
    appendJsonNumber(out, point.at_m.x(), 3);
    out += ',';
    appendJsonNumber(out, point.at_m.y(), 3);
    out += ',';
    appendJsonNumber(out, static_cast<double>(point.z_m), 2);
    out += ']';
  }
  return out + "]}";
}

/// A cloud whose points are `bytes`, laid out as `fields`.
std::string cloudJson(std::string_view topic, const char* fields, std::string bytes, double time_s) {
  return messageJson(topic, {{"stamp", std::llround(1000 * stampOf(time_s))},
                             {"fields", Value::Json{fields}},
                             {"data", Value::Bytes{std::move(bytes)}}});
}

void appendPlace(std::string& bytes, const LidarPoint& point) {
  appendNumber(bytes, static_cast<float>(point.at_m.x()));
  appendNumber(bytes, static_cast<float>(point.at_m.y()));
  appendNumber(bytes, point.z_m);
}

std::string packedJson(const std::vector<LidarPoint>& points, double time_s) {
  std::string bytes;
  bytes.reserve(points.size() * 16);
  for (const LidarPoint& point : points) {
    appendPlace(bytes, point);
    appendNumber(bytes, static_cast<float>(point.intensity / 255.0));
  }
  return cloudJson(
      kPacked,
      R"([{"name":"x","data_type":"f32"},{"name":"y","data_type":"f32"},{"name":"z","data_type":"f32"},)"
      R"({"name":"intensity","data_type":"f32"}])",
      std::move(bytes), time_s);
}

/// Every fourth point belongs to somebody who walks by: less likely, with a heading and a speed.
std::string semanticJson(const std::vector<LidarPoint>& points, double time_s) {
  std::string bytes;
  bytes.reserve(points.size() * 15);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool moves = i % 4 == 0;
    appendPlace(bytes, points[i]);
    bytes += static_cast<char>(moves ? 90 : 240);
    bytes += static_cast<char>(moves ? 64 : 0);
    bytes += static_cast<char>(moves ? 80 : 0);
  }
  return cloudJson(
      kSemantic,
      R"([{"name":"x","data_type":"f32"},{"name":"y","data_type":"f32"},{"name":"z","data_type":"f32"},)"
      R"({"name":"probability","data_type":"u8"},{"name":"ori","data_type":"u8"},{"name":"speed","data_type":"u8"}])",
      std::move(bytes), time_s);
}

std::string pointsBinary(const std::vector<LidarPoint>& points, const geometry::Pose2& robot,
                         std::int64_t number, double time_s) {
  ros_messages::RosMessageWrapper wrapper;
  wrapper.set_type(ros_messages::POINT_CLOUD);
  ros_messages::PointCloud& cloud = *wrapper.mutable_point_cloud();
  const double stamp = stampOf(time_s);
  cloud.mutable_header()->set_seq(static_cast<std::uint32_t>(number & 0xFFFFFFFF));
  cloud.mutable_header()->set_stamp_sec(static_cast<std::uint64_t>(stamp));
  cloud.mutable_header()->set_stamp_nsec(
      static_cast<std::uint64_t>(1e6 * std::floor(1e3 * (stamp - std::floor(stamp)))));
  cloud.mutable_header()->set_frame_id("map");
  cloud.set_point_number(static_cast<std::uint32_t>(points.size()));
  const Eigen::Vector2d centre(std::round(robot.x_m), std::round(robot.y_m));
  cloud.set_center_x(centre.x());
  cloud.set_center_y(centre.y());
  cloud.set_resolution(kBinaryResolutionM);
  cloud.set_is_delta_encoded(true);
  const auto cells = [](double metres) {
    return static_cast<std::int32_t>(std::lround(metres / static_cast<double>(kBinaryResolutionM)));
  };
  std::int32_t x = 0, y = 0, z = 0;
  std::string intensities;
  for (const LidarPoint& point : points) {
    const std::int32_t px = cells(point.at_m.x() - centre.x()), py = cells(point.at_m.y() - centre.y()),
                       pz = cells(static_cast<double>(point.z_m));
    cloud.add_xs(px - x);
    cloud.add_ys(py - y);
    cloud.add_zs(pz - z);
    x = px;
    y = py;
    z = pz;
    intensities += static_cast<char>(point.intensity);
  }
  cloud.set_intensities(intensities);
  return binaryMessage(kMatchedPoints, wrapper);
}

/// What the lidar sees from where the robot is, put where it believes to be.
std::vector<LidarPoint> pointsNow(const RobotState& state, int count, std::uint64_t seed) {
  const geometry::Pose2 misplacement = state.misplacement();
  std::vector<LidarPoint> points =
      scanFrom(state.plan(), misplacement.inverse() * state.robotPose(), count, seed);
  for (LidarPoint& point : points) point.at_m = misplacement.apply(point.at_m);
  return points;
}

/// As the faults leave it.
Value::Object messageAt(double time_s, const MapPicture& picture, const std::string& fault) {
  Value::Object message{{"stamp", fixed(stampOf(time_s), 3)}};
  if (const auto resolution = faultyResolution(picture.resolution_m, fault))
    message.emplace_back("resolution", float32(*resolution));
  message.emplace_back("size", Value::List{picture.width, picture.height});
  if (fault != "no-origin")
    message.emplace_back("origin", Value::Float64s{picture.origin_m.x(), picture.origin_m.y()});
  return message;
}

}  // namespace

std::string submapListJson(const map::SubmapList& list) {
  std::string out;
  out.reserve(200 + list.entries.size() * 300);
  out += R"({"topic":"/submap_list","slam_state":)";
  appendJsonText(out, nameOf(list.slam_state));
  out += R"(,"uuid":)";
  appendJsonText(out, list.uuid);
  out += R"(,"submap":[)";
  const auto flag = [&](std::string_view key, bool value) {
    out += key;
    out += value ? "true" : "false";
  };
  bool first = true;
  for (const map::SubmapEntry& entry : list.entries) {
    out += first ? R"({"trajectory_id":)" : R"(,{"trajectory_id":)";
    first = false;
    out += std::to_string(entry.id.trajectory);
    out += R"(,"submap_index":)";
    out += std::to_string(entry.id.index);
    out += R"(,"submap_version":)";
    out += std::to_string(entry.version);
    out += R"(,"pose":)";
    char separator = '{';
    const geometry::Pose3& p = entry.pose;
    for (const auto& [key, value] : {std::pair{"\"x\":", p.x},
                                     {"\"y\":", p.y},
                                     {"\"z\":", p.z},
                                     {"\"qx\":", p.qx},
                                     {"\"qy\":", p.qy},
                                     {"\"qz\":", p.qz},
                                     {"\"qw\":", p.qw}}) {
      out += separator;
      separator = ',';
      out += key;
      appendJsonNumber(out, value);
    }
    flag(R"(},"is_frozen":)", entry.is_frozen);
    flag(R"(,"is_incremental_submap":)", entry.is_incremental);
    flag(R"(,"is_nearby_map":)", entry.is_nearby);
    out += '}';
  }
  out += "]}";
  return out;
}

std::string scanMessage(const RobotState& state, int points, std::uint32_t seed) {
  const double time_s = state.time();
  return pointsJson(
      pointsNow(state, std::min(points, kMostPoints), hashOf(seed, 97, std::llround(1000 * time_s))), time_s);
}

Frame TopicMessages::listMessage(bool binary, bool bad_entries) {
  const std::lock_guard lock(list_mutex_);
  return lists_.get({state_.stamp(), state_.uuid(), binary, bad_entries}, [&] {
    map::SubmapList list = state_.list();
    if (bad_entries) addBadEntries(list);
    return Frame{std::make_shared<const std::string>(binary ? submapListBinary(list) : submapListJson(list)),
                 binary};
  });
}

Frame TopicMessages::pointsMessage(std::string_view topic, bool binary) {
  const bool as_binary = binary && topic == kMatchedPoints;
  const double hz = options_.scan_hz;
  const bool large = options_.points_per_scan > kLargeScan;
  auto number = static_cast<std::int64_t>(std::floor(state_.time() * hz));
  if (large) number %= kPrepared;

  const std::lock_guard lock(scan_mutex_);
  return scans_.get({std::string(topic), as_binary, number}, [&] {
    const geometry::Pose2 pose = state_.robotPose();
    const double time_s = state_.time();
    const std::vector<LidarPoint> points =
        pointsNow(state_, std::min(options_.points_per_scan, kMostPoints), hashOf(options_.seed, 97, number));
    if (as_binary)
      return Frame{std::make_shared<const std::string>(pointsBinary(points, pose, number, time_s)), true};
    return textFrame(topic == kMatchedPoints ? pointsJson(points, time_s)
                     : topic == kPacked      ? packedJson(points, time_s)
                                             : semanticJson(points, time_s));
  });
}

std::optional<Frame> TopicMessages::pictureMessage(std::string_view topic) {
  const MapPicturePtr picture = pictureOf(topic);
  if (!picture) return std::nullopt;
  const Faults faults = faults_.faults();
  Value::Object message = messageAt(state_.time(), *picture, faults.grid_fault);
  if (topic.ends_with("_v2")) {
    const std::string path = library_.publishStatic(topic == "/map_v2"           ? "map"
                                                    : topic == "/map/costmap_v2" ? "costmap"
                                                                                 : "incremental",
                                                    picture);
    message.emplace_back("data_url", faults.foreign_data_url ? "http://127.0.0.2:1/" + path : path);
  } else if (faults.garbage_base64) {
    message.emplace_back("data", "iVBORw0KGgo*** this is no base64 ***");
  } else {
    message.emplace_back("data", Value::Bytes{faultyPng(*picture->png, faults)});
  }
  return textFrame(messageJson(topic, std::move(message)));
}

MapPicturePtr TopicMessages::pictureOf(std::string_view topic) {
  if (topic == "/map" || topic == "/map_v2") {
    if (const std::optional<MappingSpan> span = state_.mapping()) {
      PictureSpec spec = specOf(*span, false);
      spec.bits = 4;
      return library_.pictures().picture(spec);
    }
    return library_.livePicture();
  }
  if (topic == "/map/costmap" || topic == "/map/costmap_v2") return costsOfWholeMap();
  if (topic == "/maps/5cm/1hz") return costsAroundRobot(0.05, options_.costmap_cells);
  if (topic == "/maps/1cm/1hz") return costsAroundRobot(0.01, std::max(400, options_.costmap_cells));
  if (topic == "/incremental_map" || topic == "/incremental_map_v2") return incremental();
  if (topic == "/env_match_map") return environment(false);
  if (topic == "/env_symmetry_map") return environment(true);
  return nullptr;
}

MapPicturePtr TopicMessages::costsAroundRobot(double resolution_m, int cells) {
  if (state_.scene().trajectories.empty()) return nullptr;
  const geometry::Pose2 pose = state_.robotPose();
  const GridPlace place = squareAround({pose.x_m, pose.y_m}, cells, resolution_m);
  const std::string name = "costs" + std::to_string(resolution_m);
  // Large ones stay where they are for a while: making them must not cost more than showing them.
  const std::string of = cells >= kLargeCostmap
                             ? std::to_string(std::floor(state_.time() / kLargeCostmapForS))
                             : std::to_string(place.origin_m.x()) + "," + std::to_string(place.origin_m.y());
  return made_.get(name + of,
                   [&] { return placedPicture(place, writePng(costsOf(state_.plan(), {}, place), 8)); });
}

MapPicturePtr TopicMessages::costsOfWholeMap() {
  const MapPicturePtr map = library_.livePicture();
  if (!map) return nullptr;
  return made_.get("costs of " + map->hash,
                   [&] { return placedPicture(*map, writePng(costsOf(state_.plan(), {}, *map), 8)); });
}

MapPicturePtr TopicMessages::incremental() {
  PictureSpec spec;
  spec.trajectory = 2;
  spec.scans = state_.scansOf(spec.trajectory);
  if (spec.scans == 0) return nullptr;
  return library_.pictures().picture(spec);
}

MapPicturePtr TopicMessages::environment(bool symmetry) {
  const std::optional<StoredMap> current = library_.current();
  if (!current || !current->spec) return nullptr;
  PictureSpec spec = *current->spec;
  spec.resolution_m = std::max(spec.resolution_m, kEnvironmentM);
  const std::shared_ptr<const FloorCells> floor = library_.pictures().cells(spec);
  if (!floor) return nullptr;
  const std::string of = current->uid + "/" + std::to_string(current->map_version);
  return made_.get((symmetry ? "symmetry of " : "match of ") + of, [&] {
    GrayPicture picture{floor->width, floor->height, std::vector<std::uint8_t>(floor->cells.size(), 0)};
    std::size_t at = 0;
    for (int v = 0; v < floor->height; ++v) {
      const double y = floor->origin_m.y() + (floor->height - v) * floor->resolution_m;
      for (int u = 0; u < floor->width; ++u, ++at) {
        if (floor->cells[at] != (symmetry ? FloorCell::Free : FloorCell::Occupied)) continue;
        const double x = floor->origin_m.x() + u * floor->resolution_m;
        const auto patch = hashOf(symmetry ? 3 : 4, std::llround(std::floor(x / kPatchM)),
                                  std::llround(std::floor(y / kPatchM)));
        // Most of the environment is as it was mapped.
        const double good = unitFrom(patch);
        picture.levels[at] = static_cast<std::uint8_t>(good < 0.2 ? 1 + 250 * good : 200 + 50 * good);
      }
    }
    return placedPicture(*floor, writePng(picture, 8));
  });
}

std::optional<Frame> TopicMessages::messageOf(std::string_view topic, bool binary, bool bad_entries) {
  if (topic == kSubmapListTopic) return listMessage(binary, bad_entries);
  if (topic == kMatchedPoints || topic == kPacked || topic == kSemantic) return pointsMessage(topic, binary);
  if (std::optional<std::string> live = liveMessage(topic, state_, library_.current()))
    return textFrame(std::move(*live));
  return pictureMessage(topic);
}

}  // namespace mapwright::simulator
