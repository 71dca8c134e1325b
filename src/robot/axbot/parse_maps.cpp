#include "robot/axbot/parse_maps.h"

#include <limits>
#include <tuple>

#include "robot/axbot/faults.h"
#include "robot/axbot/parse_overlays.h"
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
  if (const auto grid = listedGrid(row); !map::whyUnusable(grid)) entry.grid = grid;
  return entry;
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

tl::expected<MapDetail, Fault> parseMapDetail(std::string_view body, const map::MapKey& key) {
  wire::JsonReader reader;
  auto root = reader.readKeepingDigits(body);
  if (root && root->is_object() && !wire::member(*root, {"id", "grid_resolution"})) {
    if (const auto inner = wire::member(*root, {"data"})) root = inner;
  }
  if (!root || !root->is_object()) return refused(robot::wire::fault::AnswerIsNoMap);
  MapDetail detail;
  detail.entry = entryOf(*root, key.kind);
  detail.entry.key = key;
  detail.grid = listedGrid(*root);
  detail.image_url = wire::text(*root, {"image_url"});
  detail.trajectories_url = wire::text(*root, {"trajectories_url", "trajectory_url"});
  detail.landmarks_url = wire::text(*root, {"landmark_url", "landmarks_url"});
  if (const auto overlays = wire::member(*root, {"overlays"})) {
    auto features = parseOverlays(*overlays);
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
  if (body.empty() || body.size() > std::size_t(std::numeric_limits<int>::max()) ||
      !response.ParseFromArray(body.data(), int(body.size()))) {
    return refused(fault::AnswerIsNoPicture);
  }
  if (response.status_code() != ros_messages::slam::OK) {
    const std::string& name = ros_messages::slam::StatusCode_Name(response.status_code());
    return refused({fault::RobotAnswered,
                    {name.empty() ? "code " + std::to_string(response.status_code()) : name},
                    {fault::said(response.status_message().substr(0, 300))}});
  }
  map::WholeMap whole;
  whole.key = {map::MapKind::Live, {}};
  whole.grid.resolution_m = response.resolution() == 0 ? asked_resolution_m : response.resolution();
  whole.grid.origin = {response.origin_x(), response.origin_y(), 0};
  if (const auto why = map::whyUnusable(whole.grid)) return refused(*why);
  if (response.png_bytes().empty()) return refused(fault::NoPictureSent);
  whole.bytes = std::make_shared<const std::string>(std::move(*response.mutable_png_bytes()));
  if (const auto size = wire::pngSize(*whole.bytes)) {
    std::tie(whole.grid.width, whole.grid.height) = *size;
  }
  whole.fingerprint = wire::fingerprint(*whole.bytes);
  return whole;
}

}  // namespace mapwright::robot::axbot
