#include "simulator/chassis_routes.h"

#include <cmath>

#include "simulator/json_text.h"
#include "simulator/map_answers.h"
#include "simulator/map_overlays.h"
#include "simulator/map_upload.h"
#include "simulator/request_fields.h"

namespace mapwright::simulator {
namespace {

constexpr double kFarthestM = 1e5;

HttpAnswer noObject() { return jsonAnswer(400, jsonDetail("The request is no JSON object.")); }

}  // namespace

std::optional<HttpAnswer> ChassisRoutes::answer(const HttpQuestion& question) {
  const std::string_view path = pathOf(question.target);
  HttpAnswer answer;
  if (path == "/chassis/current-map") {
    answer = currentMap(question);
  } else if (path == "/ros/map/overlays") {
    answer = overlays(question);
  } else if (path == "/chassis/pose") {
    return pose(question);
  } else if (path == "/services/wheel_control/set_control_mode") {
    return controlMode(question);
  } else if (path == "/services/wheel_control/set_emergency_stop") {
    return emergencyStop(question);
  } else if (path == "/services/start_global_positioning") {
    return relocate(question);
  } else {
    return std::nullopt;
  }
  answer.delay_ms += faults_.faults().map_latency_ms;
  return answer;
}

HttpAnswer ChassisRoutes::currentMap(const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "GET, POST")) return *refused;
  if (question.method == "POST") return setCurrentMap(question);
  const std::optional<StoredMap> map = library_.current();
  if (!map) {
    return jsonAnswer(
        200, R"({"id":-1,"uid":"","map_name":"","create_time":0,"map_version":0,"overlays_version":0})");
  }
  std::string body;
  appendMap(body, *map);
  return jsonAnswer(200, body + "}");
}

HttpAnswer ChassisRoutes::setCurrentMap(const HttpQuestion& question) {
  const std::optional<RequestFields> fields = RequestFields::read({}, question.body);
  if (!fields) return noObject();
  if (state_.mapping()) return jsonAnswer(400, jsonDetail("A mapping task is running."));
  if (fields->has("map_id")) {
    const std::optional<std::int64_t> id = fields->integer("map_id");
    if (!id || *id < 0 || *id > 1'000'000'000 || !library_.setCurrent(static_cast<int>(*id)))
      return jsonAnswer(400, jsonDetail("map_id: there is no such map."));
  } else if (fields->has("map_uid")) {
    if (!library_.setCurrent(fields->text("map_uid").value_or("")))
      return jsonAnswer(400, jsonDetail("map_uid: there is no such map."));
  } else if (fields->has("map_name") || fields->has("occupancy_grid") || fields->has("data_url")) {
    auto handed_in = readMapUpload(*fields);
    if (!handed_in) return jsonAnswer(400, jsonDetail(handed_in.error()));
    library_.setCurrentFromData(std::move(*handed_in));
  } else {
    return jsonAnswer(400, jsonDetail("Either map_id, map_uid or the data of a map is required."));
  }
  std::string body;
  appendMap(body, library_.current().value_or(StoredMap{}));
  return jsonAnswer(200, body + "}");
}

HttpAnswer ChassisRoutes::pose(const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "POST")) return *refused;
  const std::optional<RequestFields> fields = RequestFields::read({}, question.body);
  if (!fields) return noObject();
  const std::optional<std::vector<double>> position = fields->numbers("position");
  const std::optional<double> ori = fields->number("ori");
  // Two numbers are enough: the third is always 0.
  if (!position || position->size() < 2 || position->size() > 3 ||
      !(std::abs((*position)[0]) <= kFarthestM) || !(std::abs((*position)[1]) <= kFarthestM))
    return jsonAnswer(400, jsonDetail("position: must be [x, y, 0] in metres."));
  if (!ori || std::abs(*ori) > kFarthestM)
    return jsonAnswer(400, jsonDetail("ori: must be a number of radians."));
  const std::optional<bool> adjust =
      fields->has("adjust_position") ? fields->flag("adjust_position") : std::optional(false);
  if (!adjust) return jsonAnswer(400, jsonDetail("adjust_position: must be true or false."));
  if (state_.mapping()) return jsonAnswer(400, jsonDetail("A mapping task is running."));
  state_.setPose({(*position)[0], (*position)[1], geometry::normalizeAngle(*ori)}, *adjust);
  return jsonAnswer(200, "{}");
}

HttpAnswer ChassisRoutes::overlays(const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "GET, PUT")) return *refused;
  const std::optional<StoredMap> map = library_.current();
  if (!map) return jsonAnswer(404, jsonDetail("There is no current map."));
  if (question.method == "GET") {
    HttpAnswer answer =
        jsonAnswer(200, map->overlays && !map->overlays->empty() ? *map->overlays : noOverlays());
    answer.headers = {{"Cache-Control", "no-cache"}};
    return answer;
  }
  if (question.body.empty() || !isOverlays(question.body))
    return jsonAnswer(400, jsonDetail("The request is no GeoJSON FeatureCollection."));
  return library_.setCurrentOverlays(std::string(question.body))
             ? jsonAnswer(200, R"({"success":true,"message":""})")
             : jsonAnswer(404, jsonDetail("There is no current map."));
}

HttpAnswer ChassisRoutes::controlMode(const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "POST")) return *refused;
  const std::optional<RequestFields> fields = RequestFields::read({}, question.body);
  if (!fields) return noObject();
  const std::string mode = fields->text("control_mode").value_or("");
  if (mode != "auto" && mode != "manual" && mode != "remote")
    return jsonAnswer(400, jsonDetail("control_mode: must be auto, manual or remote."));
  state_.setControlMode(mode);
  return jsonAnswer(200, "{}");
}

HttpAnswer ChassisRoutes::emergencyStop(const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "POST")) return *refused;
  const std::optional<RequestFields> fields = RequestFields::read({}, question.body);
  if (!fields) return noObject();
  const std::optional<bool> enable = fields->flag("enable");
  if (!enable) return jsonAnswer(400, jsonDetail("enable: must be true or false."));
  state_.setEmergencyStop(*enable);
  return jsonAnswer(200, "{}");
}

HttpAnswer ChassisRoutes::relocate(const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "POST")) return *refused;
  state_.relocate();
  return jsonAnswer(200, "{}");
}

}  // namespace mapwright::simulator
