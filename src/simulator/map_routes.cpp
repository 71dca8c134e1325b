#include "simulator/map_routes.h"

#include <array>
#include <charconv>
#include <cmath>

#include "ros_messages/slam.pb.h"
#include "simulator/json_text.h"
#include "simulator/map_overlays.h"
#include "simulator/noise.h"

namespace mapwright::simulator {
namespace {

// These robots put the address that they know themselves by into their answers, whatever was connected to.
constexpr std::string_view kOwnAddress = "http://192.168.25.25:8090";
constexpr std::string_view kForEver = "public, max-age=2592000";
constexpr double kFinestM = 0.005, kCoarsestM = 10;
constexpr double kTrailStepM = 0.5;
constexpr int kMostTrailPoints = 4000;

template <typename Number>
std::optional<Number> numberFrom(std::string_view text) {
  Number number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || result.ec != std::errc() || result.ptr != text.data() + text.size())
    return std::nullopt;
  return number;
}

HttpAnswer notFound() { return jsonAnswer(404, jsonDetail("Not found.")); }

/// Appends ,"key":"<own address>/path".
void appendUrl(std::string& out, std::string_view key, const std::string& path) {
  out += ",\"";
  out += key;
  out += "\":";
  appendJsonText(out, std::string(kOwnAddress) + path);
}

void appendMap(std::string& out, const StoredMap& map) {
  out += "{\"id\":" + std::to_string(map.id) + ",\"uid\":";
  appendJsonText(out, map.uid);
  out += ",\"map_name\":";
  appendJsonText(out, map.name);
  out += ",\"create_time\":" + std::to_string(map.created_s) +
         ",\"map_version\":" + std::to_string(map.map_version) +
         ",\"overlays_version\":" + std::to_string(map.overlays_version);
}

void appendMapUrls(std::string& out, const StoredMap& map) {
  const std::string path = "/maps/" + std::to_string(map.id);
  appendUrl(out, "thumbnail_url", path + "/thumbnail");
  appendUrl(out, "image_url", path + ".png");
}

void appendGrid(std::string& out, const MapPicturePtr& picture) {
  out += ",\"grid_origin_x\":";
  appendJsonNumber(out, picture ? picture->origin_m.x() : 0);
  out += ",\"grid_origin_y\":";
  appendJsonNumber(out, picture ? picture->origin_m.y() : 0);
  out += ",\"grid_resolution\":";
  appendJsonNumber(out, picture ? picture->resolution_m : 0);
}

void appendFaultyGrid(std::string& out, const MapPicturePtr& picture, const std::string& fault) {
  const std::size_t from = out.size();
  appendGrid(out, picture);
  const std::size_t resolution = out.find(",\"grid_resolution\":", from);
  if (fault == "zero-resolution") out.replace(resolution, std::string::npos, ",\"grid_resolution\":0");
  if (fault == "negative-resolution")
    out.replace(resolution, std::string::npos, ",\"grid_resolution\":-0.05");
  if (fault == "no-resolution") out.erase(resolution);
  if (fault == "no-origin") out.erase(from, resolution - from);
}

void appendMapping(std::string& out, const MappingTask& task, const MapPicturePtr& picture) {
  const std::string path = "/mappings/" + std::to_string(task.id);
  out += "{\"id\":" + std::to_string(task.id);
  if (picture) {
    appendUrl(out, "thumbnail_url", path + "/thumbnail");
    appendUrl(out, "image_url", path + ".png");
    appendUrl(out, "trajectories_url", path + "/trajectories.json");
    appendUrl(out, "landmark_url", path + "/landmarks.json");
    appendUrl(out, "pbstream_url", path + ".pbstream");
  } else {
    out += R"(,"thumbnail_url":null,"image_url":null,"trajectories_url":null,"landmark_url":null)";
  }
  appendGrid(out, picture);
  appendUrl(out, "url", path);
  out += ",\"start_time\":" + std::to_string(task.started_s) +
         ",\"end_time\":" + (task.ended_s ? std::to_string(*task.ended_s) : std::string("null")) +
         ",\"state\":";
  appendJsonText(out, task.state);
  out += R"(,"bag_id":null,"bag_url":null,"download_url":null})";
}

void appendPoint(std::string& out, const Eigen::Vector2d& point) {
  out += '[';
  appendJsonFixed(out, point.x(), 3);
  out += ',';
  appendJsonFixed(out, point.y(), 3);
  out += ']';
}

const Trajectory* wayOf(const Scene& scene, const PictureWish& wish) {
  for (const Trajectory& trajectory : scene.trajectories) {
    if (trajectory.id == wish.trajectory) return &trajectory;
  }
  return nullptr;
}

/// The way that made the map, in two parts as after a pause.
std::string trajectoriesJson(const Trajectory& way) {
  const double length = way.drive.length_m();
  const double step = std::max(kTrailStepM, length / kMostTrailPoints);
  std::string out = "[";
  for (int part = 0; part < 2; ++part) {
    if (part > 0) out += ',';
    out += "{\"id\":" + std::to_string(part) + ",\"coordinates\":[";
    const double from = part == 0 ? 0 : length * 0.6, to = part == 0 ? length * 0.6 : length;
    for (double s = from; s <= to; s += step) {
      if (s > from) out += ',';
      const geometry::Pose2 pose = way.drive.at(s);
      appendPoint(out, {pose.x_m, pose.y_m});
    }
    out += "]}";
  }
  return out + "]";
}

std::string landmarksJson(const Trajectory& way) {
  std::string out = R"({"landmarks":[)";
  for (int i = 0; i < 6; ++i) {
    if (i > 0) out += ',';
    out += "{\"id\":\"landmark_" + std::to_string(i + 1) + "\",\"pos\":";
    appendPoint(out, way.drive.at(way.drive.length_m() * (i + 0.5) / 6).apply({0, i % 2 == 0 ? 1.1 : -1.1}));
    out += i % 3 == 2 ? ",\"in_use\":false}" : ",\"in_use\":true}";
  }
  return out + "]}";
}

}  // namespace

std::string faultyPng(const std::string& png, const Faults& faults) {
  std::string made = faults.lying_map_size ? withDeclaredSize(png, 60'000, 60'000) : png;
  if (faults.truncated_maps) made.resize(made.size() / 2);
  return made;
}

std::optional<HttpAnswer> MapRoutes::answer(const HttpQuestion& question) {
  const std::string_view path = pathOf(question.target);
  const auto below = [&](std::string_view prefix) { return path.starts_with(prefix); };
  HttpAnswer answer;
  if (path == "/maps" || path == "/maps/") {
    answer = list();
  } else if (below("/maps/")) {
    answer = map(path.substr(6), question);
  } else if (path == "/chassis/current-map") {
    answer = current();
  } else if (path == "/mappings" || path == "/mappings/") {
    answer = mappings();
  } else if (below("/mappings/")) {
    answer = mapping(path.substr(10), question);
  } else if (below("/static-files/")) {
    answer = picture(library_.staticFile(path.substr(14)), question, true);
  } else if (path == "/ros/slam/map_image") {
    answer = image(question);
  } else {
    return std::nullopt;
  }
  answer.delay_ms += faults_.faults().map_latency_ms;
  return answer;
}

HttpAnswer MapRoutes::list() const {
  if (faults_.faults().map_list_error) return jsonAnswer(500, jsonDetail("The database is locked."));
  std::string body = "[";
  for (const StoredMap& map : library_.maps()) {
    if (body.size() > 1) body += ',';
    appendMap(body, map);
    appendMapUrls(body, map);
    appendUrl(body, "url", "/maps/" + std::to_string(map.id));
    body += '}';
  }
  return jsonAnswer(200, body + "]");
}

HttpAnswer MapRoutes::map(std::string_view rest, const HttpQuestion& question) {
  const std::size_t end = rest.find_first_of("./");
  const std::optional<int> id = numberFrom<int>(rest.substr(0, end));
  const std::optional<StoredMap> map = id ? library_.find(*id) : std::nullopt;
  if (!map) return jsonAnswer(404, jsonDetail("There is no such map."));
  const std::string_view part = end == std::string_view::npos ? std::string_view() : rest.substr(end);
  if (part == ".png") return picture(library_.pictures().picture(map->wish), question, false);
  if (part == "/thumbnail") return picture(library_.pictures().thumbnail(map->wish), question, false);
  if (!part.empty() && part != "/") return notFound();

  std::string body;
  appendMap(body, *map);
  body += ",\"last_modified_time\":" + std::to_string(map->modified_s);
  appendFaultyGrid(body, library_.pictures().picture(map->wish), faults_.faults().grid_fault);
  body += ",\"overlays\":";
  appendJsonText(body, overlaysOf(library_.scene(), *map));
  appendMapUrls(body, *map);
  const std::string path = "/maps/" + std::to_string(map->id);
  appendUrl(body, "download_url", path + "/download");
  appendUrl(body, "pbstream_url", path + ".pbstream");
  return jsonAnswer(200, body + "}");
}

HttpAnswer MapRoutes::current() const {
  const std::optional<StoredMap> map = library_.current();
  if (!map) {
    return jsonAnswer(
        200, R"({"id":-1,"uid":"","map_name":"","create_time":0,"map_version":0,"overlays_version":0})");
  }
  std::string body;
  appendMap(body, *map);
  return jsonAnswer(200, body + "}");
}

HttpAnswer MapRoutes::mappings() const {
  std::string body = "[";
  for (const MappingTask& task : library_.mappings()) {
    if (body.size() > 1) body += ',';
    appendMapping(body, task, task.wish ? library_.pictures().picture(*task.wish) : nullptr);
  }
  return jsonAnswer(200, body + "]");
}

HttpAnswer MapRoutes::mapping(std::string_view rest, const HttpQuestion& question) {
  const std::size_t end = rest.find_first_of("./");
  const std::optional<int> id = numberFrom<int>(rest.substr(0, end));
  const std::string_view part = end == std::string_view::npos ? std::string_view() : rest.substr(end);
  for (const MappingTask& task : library_.mappings()) {
    if (task.id != id) continue;
    const Trajectory* way = task.wish ? wayOf(library_.scene(), *task.wish) : nullptr;
    if (part.empty() || part == "/") {
      std::string body;
      appendMapping(body, task, way ? library_.pictures().picture(*task.wish) : nullptr);
      return jsonAnswer(200, body);
    }
    if (way == nullptr) return jsonAnswer(404, jsonDetail("This mapping task made no map."));
    if (part == ".png") return picture(library_.pictures().picture(*task.wish), question, false);
    if (part == "/thumbnail") return picture(library_.pictures().thumbnail(*task.wish), question, false);
    if (part == "/trajectories.json") return jsonAnswer(200, trajectoriesJson(*way));
    if (part == "/landmarks.json") return jsonAnswer(200, landmarksJson(*way));
    return notFound();
  }
  return jsonAnswer(404, jsonDetail("There is no such mapping task."));
}

HttpAnswer MapRoutes::picture(const MapPicturePtr& picture, const HttpQuestion& question, bool for_ever) {
  if (!picture) return jsonAnswer(404, jsonDetail("There is no such picture."));
  // Static files carry their tag without quotes, as these robots send it.
  const std::string tag = for_ever ? picture->hash : "\"" + picture->hash + "\"";
  HttpAnswer answer;
  answer.headers = {{"ETag", tag}, {"Cache-Control", for_ever ? std::string(kForEver) : "no-cache"}};
  if (matchesTag(question.if_none_match, tag) || matchesTag(question.if_none_match, "\"" + tag + "\"")) {
    answer.status = 304;
    answer.content_type.clear();
    return answer;
  }
  answer.content_type = "image/png";
  const Faults faults = faults_.faults();
  answer.body = faults.truncated_maps || faults.lying_map_size
                    ? std::make_shared<const std::string>(faultyPng(*picture->png, faults))
                    : picture->png;
  return answer;
}

HttpAnswer MapRoutes::image(const HttpQuestion& question) {
  const std::string_view asked = queryValue(question.target, "resolution");
  PictureWish wish;
  const std::optional<double> resolution = asked.empty() ? wish.resolution_m : numberFrom<double>(asked);
  if (!resolution || !std::isfinite(*resolution) || *resolution < kFinestM || *resolution > kCoarsestM) {
    return jsonAnswer(400, jsonDetail("The resolution must lie between 0.005 and 10 metres."));
  }
  wish.resolution_m = *resolution;
  if (const std::string_view id = queryValue(question.target, "trajectory_id"); !id.empty()) {
    const std::optional<int> number = numberFrom<int>(id);
    if (!number) return jsonAnswer(400, jsonDetail("Invalid query parameters."));
    if (*number >= 0) wish.trajectory = *number;
  }
  const MapPicturePtr made = library_.pictures().picture(wish);
  if (!made) return jsonAnswer(502, jsonDetail("The ROS service call failed."));
  ros_messages::slam::GetMapImageResponse response;
  response.set_origin_x(made->origin_m.x());
  response.set_origin_y(made->origin_m.y());
  response.set_resolution(made->resolution_m);
  response.set_png_bytes(faultyPng(*made->png, faults_.faults()));
  HttpAnswer answer;
  answer.content_type = "application/x-protobuf";
  answer.headers = {{"Cache-Control", "no-cache"}};
  answer.body = std::make_shared<const std::string>(response.SerializeAsString());
  return answer;
}

}  // namespace mapwright::simulator
