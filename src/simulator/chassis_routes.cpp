#include <cmath>

#include "simulator/map_answers.h"
#include "simulator/map_overlays.h"
#include "simulator/map_upload.h"
#include "simulator/request_fields.h"
#include "simulator/routes.h"

namespace mapwright::simulator {
namespace {

constexpr double kFarthestM = 1e5;

HttpAnswer noObject() { return errorAnswer(400, "The request is no JSON object."); }

HttpAnswer setCurrentMap(const Robot& robot, const HttpQuestion& question) {
  const std::optional<RequestFields> fields = RequestFields::read({}, question.body);
  if (!fields) return noObject();
  if (robot.state.mapping()) return errorAnswer(400, "A mapping task is running.");
  if (fields->has("map_id")) {
    const std::optional<std::int64_t> id = fields->integer("map_id");
    if (!id || *id < 0 || *id > 1'000'000'000 || !robot.library.setCurrent(static_cast<int>(*id)))
      return errorAnswer(400, "map_id: there is no such map.");
  } else if (fields->has("map_uid")) {
    if (!robot.library.setCurrent(fields->text("map_uid").value_or("")))
      return errorAnswer(400, "map_uid: there is no such map.");
  } else if (fields->has("map_name") || fields->has("occupancy_grid") || fields->has("data_url")) {
    auto handed_in = readMapUpload(*fields);
    if (!handed_in) return errorAnswer(400, handed_in.error());
    robot.library.setCurrentFromData(std::move(*handed_in));
  } else {
    return errorAnswer(400, "Either map_id, map_uid or the data of a map is required.");
  }
  return valueAnswer(200, mapValue(robot.library.current().value_or(StoredMap{})));
}

HttpAnswer currentMap(const Robot& robot, const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "GET, POST")) return *refused;
  if (question.method == "POST") return setCurrentMap(robot, question);
  const std::optional<StoredMap> map = robot.library.current();
  if (!map) {
    return jsonAnswer(
        200, R"({"id":-1,"uid":"","map_name":"","create_time":0,"map_version":0,"overlays_version":0})");
  }
  return valueAnswer(200, mapValue(*map));
}

HttpAnswer pose(const Robot& robot, const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "POST")) return *refused;
  const std::optional<RequestFields> fields = RequestFields::read({}, question.body);
  if (!fields) return noObject();
  const std::optional<std::vector<double>> position = fields->numbers("position");
  const std::optional<double> ori = fields->number("ori");
  // Two numbers are enough: the third is always 0.
  if (!position || position->size() < 2 || position->size() > 3 ||
      !(std::abs((*position)[0]) <= kFarthestM) || !(std::abs((*position)[1]) <= kFarthestM))
    return errorAnswer(400, "position: must be [x, y, 0] in metres.");
  if (!ori || std::abs(*ori) > kFarthestM) return errorAnswer(400, "ori: must be a number of radians.");
  const std::optional<bool> adjust =
      fields->has("adjust_position") ? fields->flag("adjust_position") : std::optional(false);
  if (!adjust) return errorAnswer(400, "adjust_position: must be true or false.");
  if (robot.state.mapping()) return errorAnswer(400, "A mapping task is running.");
  robot.state.setPose({(*position)[0], (*position)[1], geometry::normalizeAngle(*ori)}, *adjust);
  return jsonAnswer(200, "{}");
}

HttpAnswer overlays(const Robot& robot, const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "GET, PUT")) return *refused;
  const std::optional<StoredMap> map = robot.library.current();
  if (!map) return errorAnswer(404, "There is no current map.");
  if (question.method == "GET") {
    HttpAnswer answer =
        jsonAnswer(200, map->overlays && !map->overlays->empty() ? *map->overlays : noOverlays());
    answer.headers = {{"Cache-Control", "no-cache"}};
    return answer;
  }
  if (question.body.empty() || !isOverlays(question.body))
    return errorAnswer(400, "The request is no GeoJSON FeatureCollection.");
  return robot.library.setCurrentOverlays(std::string(question.body))
             ? jsonAnswer(200, R"({"success":true,"message":""})")
             : errorAnswer(404, "There is no current map.");
}

HttpAnswer controlMode(const Robot& robot, const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "POST")) return *refused;
  const std::optional<RequestFields> fields = RequestFields::read({}, question.body);
  if (!fields) return noObject();
  const std::string mode = fields->text("control_mode").value_or("");
  if (mode != "auto" && mode != "manual" && mode != "remote")
    return errorAnswer(400, "control_mode: must be auto, manual or remote.");
  robot.state.setControlMode(mode);
  return jsonAnswer(200, "{}");
}

HttpAnswer emergencyStop(const Robot& robot, const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "POST")) return *refused;
  const std::optional<RequestFields> fields = RequestFields::read({}, question.body);
  if (!fields) return noObject();
  const std::optional<bool> enable = fields->flag("enable");
  if (!enable) return errorAnswer(400, "enable: must be true or false.");
  robot.state.setEmergencyStop(*enable);
  return jsonAnswer(200, "{}");
}

HttpAnswer relocate(const Robot& robot, const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "POST")) return *refused;
  robot.state.relocate();
  return jsonAnswer(200, "{}");
}

}  // namespace

std::optional<HttpAnswer> chassisAnswer(const Robot& robot, const HttpQuestion& question) {
  const std::string_view path = pathOf(question.target);
  HttpAnswer answer;
  if (path == "/chassis/current-map") {
    answer = currentMap(robot, question);
  } else if (path == "/ros/map/overlays") {
    answer = overlays(robot, question);
  } else if (path == "/chassis/pose") {
    return pose(robot, question);
  } else if (path == "/services/wheel_control/set_control_mode") {
    return controlMode(robot, question);
  } else if (path == "/services/wheel_control/set_emergency_stop") {
    return emergencyStop(robot, question);
  } else if (path == "/services/start_global_positioning") {
    return relocate(robot, question);
  } else {
    return std::nullopt;
  }
  answer.delay_ms += robot.faults.faults().map_latency_ms;
  return answer;
}

}  // namespace mapwright::simulator
