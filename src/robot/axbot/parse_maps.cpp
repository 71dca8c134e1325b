#include "robot/axbot/parse_maps.h"

#include <limits>
#include <tuple>

#include "map/submap_version.h"
#include "robot/axbot/faults.h"
#include "robot/axbot/overlay_requests.h"
#include "robot/submap_list_topic.h"
#include "robot/wire/faults.h"
#include "robot/wire/picture_bytes.h"
#include "ros_messages/slam.pb.h"

namespace mapwright::robot::axbot {
namespace {

using wire::Json;

map::GridReference listedGrid(const Json& row) {
  map::GridReference grid;
  grid.resolution_m = wire::number(row, {"grid_resolution", "resolution"}).value_or(wire::kNaN);
  grid.origin.x_m = wire::number(row, {"grid_origin_x", "origin_x"}).value_or(wire::kNaN);
  grid.origin.y_m = wire::number(row, {"grid_origin_y", "origin_y"}).value_or(wire::kNaN);
  grid.origin.yaw_rad = wire::number(row, {"grid_origin_yaw", "grid_origin_ori"}).value_or(0);
  return grid;
}

map::CatalogueEntry entryOf(const Json& row, map::MapKind kind) {
  map::CatalogueEntry entry;
  entry.key = {kind, wire::text(row, {"id", "map_id", "mapping_id"})};
  entry.name = wire::text(row, {"map_name", "name"});
  entry.uid = wire::text(row, {"uid", "map_uid"});
  entry.created_s = wire::epochSeconds(row, {"create_time", "start_time"});
  entry.modified_s = wire::epochSeconds(row, {"last_modified_time", "end_time"});
  entry.map_version = wire::smallInteger(row, {"map_version"});
  entry.overlays_version = wire::smallInteger(row, {"overlays_version"});
  entry.state = wire::text(row, {"state"});
  entry.has_thumbnail = !wire::text(row, {"thumbnail_url"}).empty();
  if (const auto grid = listedGrid(row); !map::unusableReason(grid)) entry.grid = grid;
  return entry;
}

using map::OverlayFeature;
using map::OverlayShape;

constexpr std::string_view kMulti = "Multi";
constexpr int kDeepest = 4;  // nested geometry collections

std::string_view typeOf(const Json& object) {
  std::string_view type;
  return object["type"].get(type) ? std::string_view() : type;
}

/// Everything of a feature except its geometry.
OverlayFeature described(const Json& feature, const Json& properties) {
  OverlayFeature described;
  described.id = wire::text(feature, {"id"});
  if (described.id.empty()) described.id = wire::text(properties, {"id"});
  described.name = wire::text(properties, {"name"});
  return described;
}

/// The first point in coordinates of any depth.
std::optional<Eigen::Vector2d> somePoint(const Json& coordinates, int depth) {
  constexpr int kMostTries = 1'000;
  if (const auto point = wire::asPoint(coordinates)) return point;
  wire::JsonList parts;
  if (depth == 0 || coordinates.get(parts)) return std::nullopt;
  int tries = 0;
  for (const Json part : parts) {
    if (const auto point = somePoint(part, depth - 1)) return point;
    if (++tries == kMostTries) break;
  }
  return std::nullopt;
}

class Reader {
 public:
  Reader(std::vector<OverlayFeature>& out, std::vector<map::BrokenOverlay>* broken)
      : out_(out), broken_(broken) {}

  void readFeature(const Json& feature) {
    const auto geometry = wire::member(feature, {"geometry"});
    if (!geometry || geometry->is_null()) return;  // it has no place, which is allowed
    Json properties = feature;
    if (const auto given = wire::member(feature, {"properties"})) properties = *given;
    readGeometry(*geometry, described(feature, properties), properties, kDeepest);
  }

 private:
  void readGeometry(const Json& geometry, const OverlayFeature& model, const Json& properties, int depth) {
    std::string_view type = typeOf(geometry);
    if (type == "GeometryCollection" && depth > 0) {
      if (const auto parts = wire::list(geometry, {"geometries"})) {
        for (const Json part : *parts) readGeometry(part, model, properties, depth - 1);
      }
      return;
    }
    const auto coordinates = wire::member(geometry, {"coordinates"});
    if (!coordinates) return addBroken(model, fault::GeometryUnreadable, std::nullopt);
    if (!type.starts_with(kMulti)) return add(type, *coordinates, model, properties);
    type.remove_prefix(kMulti.size());
    wire::JsonList parts;
    if (coordinates->get(parts)) return addBroken(model, fault::GeometryUnreadable, std::nullopt);
    for (const Json part : parts) add(type, part, model, properties);
  }

  void addBroken(const OverlayFeature& feature, Fault reason, std::optional<Eigen::Vector2d> at_m) {
    if (broken_) broken_->push_back({feature.id, feature.name, std::move(reason), at_m});
  }

  void add(std::string_view type, const Json& coordinates, OverlayFeature feature, const Json& properties) {
    if (type == "Point") {
      const auto at = wire::asPoint(coordinates);
      if (!at) return addBroken(feature, fault::GeometryUnreadable, std::nullopt);
      feature.shape = OverlayShape::Point;
      feature.type = wire::smallInteger(properties, {"type"}).value_or(0);
      if (const auto yaw = wire::number(properties, {"yaw"}))
        feature.yaw_rad = geometry::radiansFromDegrees(*yaw);
      feature.parts.push_back({*at});
    } else if (type == "LineString") {
      feature.shape = OverlayShape::Line;
      feature.type = wire::smallInteger(properties, {"lineType"}).value_or(0);
      feature.parts.push_back(wire::asPolyline(coordinates));
      if (feature.parts[0].size() < 2)
        return addBroken(feature, fault::GeometryUnreadable, somePoint(coordinates, kDeepest));
    } else if (type == "Polygon") {
      feature.shape = OverlayShape::Polygon;
      feature.type = wire::smallInteger(properties, {"regionType"}).value_or(0);
      wire::JsonList rings;
      if (!coordinates.get(rings)) {
        for (const Json ring : rings) addRing(wire::asPolyline(ring), feature);
      }
      if (feature.parts.empty())
        return addBroken(feature, fault::GeometryUnreadable, somePoint(coordinates, kDeepest));
    } else {
      return addBroken(feature,
                       {faultText("axbot", "Its geometry \"%1\" is not known."), {std::string(type)}},
                       somePoint(coordinates, kDeepest));
    }
    out_.push_back(std::move(feature));
  }

  static void addRing(std::vector<Eigen::Vector2d> ring, OverlayFeature& feature) {
    if (ring.size() < 3) return;
    if (ring.front() != ring.back()) ring.push_back(Eigen::Vector2d(ring.front()));
    feature.parts.push_back(std::move(ring));
  }

  std::vector<OverlayFeature>& out_;
  std::vector<map::BrokenOverlay>* broken_;
};

std::optional<std::vector<OverlayFeature>> featuresOf(const Json& overlays,
                                                      std::vector<map::BrokenOverlay>* broken) {
  std::vector<OverlayFeature> features;
  Reader reader(features, broken);
  wire::JsonList rows;
  if (!overlays.get(rows)) {  // the features without their collection
    for (const Json row : rows) reader.readFeature(row);
  } else if (const auto list = wire::list(overlays, {"features"})) {
    for (const Json feature : *list) reader.readFeature(feature);
  } else if (overlays.is_object()) {
    reader.readFeature(overlays);
  } else if (!overlays.is_null()) {
    return std::nullopt;
  }
  return features;
}

geometry::Pose3 toPose(const ros_messages::Pose& pose) {
  return {pose.x(), pose.y(), pose.z(), pose.qx(), pose.qy(), pose.qz(), pose.qw()};
}

bool readMessage(std::string_view body, google::protobuf::MessageLite& message) {
  return body.size() <= std::size_t(std::numeric_limits<int>::max()) &&
         message.ParseFromArray(body.data(), int(body.size()));
}

std::string codeName(int code) {
  const std::string& name = ros_messages::slam::StatusCode_Name(ros_messages::slam::StatusCode(code));
  return name.empty() ? "code " + std::to_string(code) : name;
}

}  // namespace

tl::expected<MapRows, Fault> parseMapRows(std::string_view body, map::MapKind kind) {
  wire::JsonReader reader;
  const auto root = reader.readKeepingDigits(body);
  const auto rows = root ? wire::asList(*root, {"maps", "mappings"}) : std::nullopt;
  if (!rows) return refused(fault::AnswerIsNoList);
  MapRows read;
  for (const Json row : *rows) {
    auto entry = entryOf(row, kind);
    if (entry.key.id.empty()) {
      ++read.without_id;
    } else {
      read.entries.push_back(std::move(entry));
    }
  }
  return read;
}

tl::expected<std::optional<RunningMapping>, Fault> parseRunningMapping(std::string_view body) {
  wire::JsonReader reader;
  const auto root = reader.readKeepingDigits(body);
  const auto rows = root ? wire::asList(*root, {"mappings"}) : std::nullopt;
  if (!rows) return refused(fault::AnswerIsNoList);
  for (const Json row : *rows) {
    const map::CatalogueEntry entry = entryOf(row, map::MapKind::Mapping);
    if (entry.state != "running" || entry.key.id.empty()) continue;
    return RunningMapping{entry.key, entry.created_s, wire::flag(row, {"continue_mapping"})};
  }
  return std::nullopt;
}

tl::expected<MapFacts, Fault> parseMapFacts(std::string_view body, const map::MapKey& key) {
  auto detail = parseMapDetail(body, key);
  if (!detail) return refused(std::move(detail.error()));
  MapFacts facts;
  facts.key = key;
  facts.name = detail->entry.name;
  facts.uid = detail->entry.uid;
  facts.map_version = detail->entry.map_version;
  facts.overlays_version = detail->entry.overlays_version;
  facts.grid = detail->grid;
  if (auto overlays = parseOverlayText(body)) facts.overlays = std::move(overlays->text);
  wire::JsonReader reader;
  const auto root = reader.readKeepingDigits(body);
  const auto size = [&](const char* name) -> std::optional<std::int64_t> {
    const auto bytes = root ? wire::integer(*root, {name}) : std::nullopt;
    return bytes && *bytes > 0 ? bytes : std::nullopt;
  };
  facts.picture_bytes = size("image_size");
  facts.data_bytes = size("pbstream_size");
  return facts;
}

std::string parseNewId(std::string_view body) {
  wire::JsonReader reader;
  const auto root = reader.readKeepingDigits(body);
  return root && root->is_object() ? wire::text(*root, {"id", "map_id"}) : std::string();
}

tl::expected<MapDetail, Fault> parseMapDetail(std::string_view body, const map::MapKey& key) {
  wire::JsonReader reader;
  auto root = reader.readKeepingDigits(body);
  if (root && root->is_object() && !wire::member(*root, {"id", "grid_resolution"})) {
    if (const auto inner = wire::member(*root, {"data"})) root = inner;
  }
  if (!root || !root->is_object()) return refused(robot::wire::fault::AnswerIsNoMap);
  MapDetail detail;
  detail.entry = entryOf(*root, key.kind);
  if (key.kind != map::MapKind::Stored || detail.entry.key.id.empty()) detail.entry.key = key;
  detail.grid = listedGrid(*root);
  detail.image_url = wire::text(*root, {"image_url"});
  detail.trajectories_url = wire::text(*root, {"trajectories_url", "trajectory_url"});
  detail.landmarks_url = wire::text(*root, {"landmark_url", "landmarks_url"});
  if (const auto overlays = wire::member(*root, {"overlays"})) {
    auto features = parseOverlays(*overlays, &detail.broken_overlays);
    detail.overlays_readable = features.has_value();
    if (features) detail.overlays = std::move(*features);
  }
  return detail;
}

bool CurrentMap::is(const map::CatalogueEntry& entry) const {
  if (entry.key.kind != map::MapKind::Stored) return false;
  if (!uid.empty() && !entry.uid.empty()) return uid == entry.uid;
  return !id.empty() && id == entry.key.id;
}

CurrentMap parseCurrentMap(std::string_view body) {
  wire::JsonReader reader;
  const auto root = reader.readKeepingDigits(body);
  if (!root) return {};
  CurrentMap current{wire::text(*root, {"id", "map_id"}), wire::text(*root, {"uid", "map_uid"})};
  if (current.id == "-1") current.id.clear();
  return current;
}

std::vector<std::vector<Eigen::Vector2d>> parseTrajectories(std::string_view body) {
  std::vector<std::vector<Eigen::Vector2d>> lines;
  wire::JsonReader reader;
  const auto root = reader.read(body);
  const auto rows = root ? wire::asList(*root, {"trajectories"}) : std::nullopt;
  if (!rows) return lines;
  for (const Json row : *rows) {
    auto line = row.is_object() ? wire::polyline(row, {"coordinates", "points"}) : wire::asPolyline(row);
    if (!line.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<map::WholeMap::Landmark> parseLandmarks(std::string_view body) {
  std::vector<map::WholeMap::Landmark> landmarks;
  wire::JsonReader reader;
  const auto root = reader.readKeepingDigits(body);
  const auto rows = root ? wire::asList(*root, {"landmarks"}) : std::nullopt;
  if (!rows) return landmarks;
  for (const Json row : *rows) {
    const auto at = row.is_object() ? wire::asPoint(row) : std::nullopt;
    if (at) landmarks.push_back({wire::text(row, {"id"}), *at});
  }
  return landmarks;
}

tl::expected<map::WholeMap, Fault> parseOverview(std::string_view body, double asked_resolution_m) {
  ros_messages::slam::GetMapImageResponse response;
  if (body.empty() || !readMessage(body, response))
    return refused(faultText("axbot", "The robot's answer is not a map picture, or is cut off."));
  if (response.status_code() != ros_messages::slam::OK) {
    return refused({fault::RobotAnswered,
                    {codeName(response.status_code())},
                    {fault::said(response.status_message().substr(0, 300))}});
  }
  map::WholeMap whole;
  whole.key = {map::MapKind::Live, {}};
  whole.grid.resolution_m = response.resolution() == 0 ? asked_resolution_m : response.resolution();
  whole.grid.origin = {response.origin_x(), response.origin_y(), 0};
  if (const auto why = map::unusableReason(whole.grid)) return refused(*why);
  if (response.png_bytes().empty()) return refused(faultText("axbot", "The robot sent no picture."));
  whole.bytes = std::make_shared<const std::string>(std::move(*response.mutable_png_bytes()));
  if (const auto size = wire::pngSize(*whole.bytes)) {
    std::tie(whole.grid.width, whole.grid.height) = *size;
  }
  whole.fingerprint = wire::fingerprint(*whole.bytes);
  return whole;
}

std::optional<std::vector<OverlayFeature>> parseOverlays(const Json& overlays,
                                                         std::vector<map::BrokenOverlay>* broken) {
  std::string_view text;
  return overlays.get(text) ? featuresOf(overlays, broken) : parseOverlays(text, broken);
}

std::optional<std::vector<OverlayFeature>> parseOverlays(std::string_view geo_json,
                                                         std::vector<map::BrokenOverlay>* broken) {
  if (geo_json.find_first_not_of(" \t\r\n") == std::string_view::npos) return std::vector<OverlayFeature>();
  wire::JsonReader reader;
  const auto root = reader.read(geo_json);
  return root ? featuresOf(*root, broken) : std::nullopt;  // a text inside a text is not parsed
}

map::SubmapAnswer parseSubmapResponse(const map::SubmapKey& key, std::string_view body) {
  using Outcome = map::SubmapAnswer::Outcome;
  map::SubmapAnswer answer;
  answer.key = key;
  answer.bytes = body.size();
  ros_messages::slam::SubmapQueryV2Response response;
  if (body.empty()) {
    answer.reason = faultText("axbot", "The robot sent an empty answer.");
    return answer;
  }
  if (!readMessage(body, response)) {
    answer.reason = {fault::AnswerIsNoSubmap, {std::int64_t(body.size())}};
    return answer;
  }
  answer.version = response.submap_version();
  const int code = response.status().code();
  if (code != ros_messages::slam::OK) {
    answer.outcome = code == ros_messages::slam::NOT_FOUND       ? Outcome::NotFound
                     : code == ros_messages::slam::UUID_MISMATCH ? Outcome::WrongUuid
                                                                 : Outcome::Failed;
    answer.reason = {
        fault::RobotAnswered, {codeName(code)}, {fault::said(response.status().message().substr(0, 300))}};
    return answer;
  }
  answer.outcome = Outcome::Ok;
  for (auto& texture : *response.mutable_textures()) {
    map::RawSlice slice;
    slice.cell_format = texture.cell_format();
    slice.cells = std::move(*texture.mutable_cells());
    slice.width = texture.width();
    slice.height = texture.height();
    slice.resolution_m = texture.resolution();
    slice.z_level = texture.z_level();
    if (texture.has_slice_pose()) slice.slice_pose = toPose(texture.slice_pose());
    answer.slices.push_back(std::move(slice));
  }
  return answer;
}

map::TopicMessage usable(map::SubmapList list) {
  const auto unusable = [](Fault why) { return map::UnreadableMessage{kSubmapListTopic, std::move(why)}; };
  if (list.entries.empty() && !list.rejected.empty())
    return unusable({fault::NoRowReadable, {std::int64_t(list.rejected.size())}});
  if (!list.entries.empty() && list.uuid.empty())
    return unusable(faultText("axbot",
                              "It lists submaps, but not the uuid of their SLAM session, so none can be "
                              "loaded. The previous list stays."));
  return list;
}

map::TopicMessage toSubmapList(const ros_messages::slam::SubmapList& message) {
  map::SubmapList list;
  list.uuid = message.uuid();
  list.slam_state = message.slam_state() == ros_messages::slam::SLAM_STATE_SLAM ? map::SlamState::Slam
                    : message.slam_state() == ros_messages::slam::SLAM_STATE_POSITIONING
                        ? map::SlamState::Positioning
                        : map::SlamState::Invalid;
  list.entries.reserve(std::size_t(message.submaps_size()));
  for (const auto& entry : message.submaps()) {
    // Protobuf does not tell a version of 0 from one that is left out.
    list.entries.push_back({{entry.trajectory_id(), entry.submap_index()},
                            entry.submap_version() > 0 ? entry.submap_version() : map::kNoVersion,
                            toPose(entry.pose()),
                            entry.is_frozen(),
                            entry.is_incremental_submap(),
                            entry.is_nearby_map()});
  }
  return usable(std::move(list));
}

}  // namespace mapwright::robot::axbot
