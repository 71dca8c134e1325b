// What the Autoxing robot sees around it and has collected (docs/protocols/autoxing.md, "Where the robot sees
// things").
#include <numbers>

#include "simulator/axbot_routes.h"
#include "simulator/value.h"

namespace mapwright::simulator {
namespace {

constexpr std::string_view kCollectedFile = "landmarks_2024-06-03_09-00-00.json";

HttpAnswer seen(const Robot& robot, const Request& request) {
  const std::string_view name = request.name, edge = queryValue(request.question.target, "ref");
  const bool charger = name == "charger_pose", rack = name == "rack_pose";
  if (!charger && !rack && name != "pallet_pose" && name != "trailer_pose")
    return errorAnswer(404, "There is no such pose.");
  if (!edge.empty() && edge != "center_of_front_edge" && edge != "center_of_rear_edge")
    return errorAnswer(400, "ref: must be center_of_front_edge or center_of_rear_edge.");
  // Nobody knows how a robot says it, so both ways occur.
  if (robot.faults.faults().sees_nothing)
    return charger || rack ? valueAnswer(200, Value::Object{{"pose", Value()}})
                           : errorAnswer(500, "Nothing was detected.");
  // It stands with its back to a charger, and within a rack, a pallet or a trailer.
  const geometry::Pose2 from = charger                         ? geometry::Pose2{-0.45, 0, std::numbers::pi}
                               : edge == "center_of_rear_edge" ? geometry::Pose2{-0.5, 0, std::numbers::pi}
                                                               : geometry::Pose2{0.5, 0, 0};
  Value answer = Value::Object{{"pose", placeOf(robot.state.robotPose() * from)}};
  if (!charger) answer.set("ref", edge.empty() ? "center_of_front_edge" : std::string(edge));
  return valueAnswer(200, answer);
}

HttpAnswer collectedList(const Robot& robot, const Request&) {
  if (robot.faults.faults().sees_nothing) return valueAnswer(200, Value::List{});
  return valueAnswer(200, Value::List{Value::Object{{"filename", kCollectedFile},
                                                    {"size", "0.4KB"},
                                                    {"size_bytes", 400},
                                                    {"modified_time", "2024-06-03 09:00:00"}}});
}

HttpAnswer collectedFile(const Robot& robot, const Request& request) {
  if (request.name != kCollectedFile || robot.faults.faults().sees_nothing)
    return errorAnswer(404, "There is no such file.");
  const Trajectory* const way = robot.state.scene().find(0);
  Value::List list;
  if (way != nullptr) list = landmarksAlong(way->drive, 0, way->drive.length_m());
  return valueAnswer(200, Value::Object{{"landmarks", std::move(list)}});
}

HttpAnswer collect(const Robot&, const Request&) { return jsonAnswer(200, "{}"); }

constexpr Route kSightingRoutes[] = {{"GET", "/services/query_pose/#", seen},
                                     {"POST", "/services/query_pose/#", seen},
                                     {"POST", "/services/start_collecting_landmarks", collect},
                                     {"POST", "/services/stop_collecting_landmarks", collect},
                                     {"GET", "/collected_data/", collectedList},
                                     {"GET", "/collected_data/*", collectedFile}};

}  // namespace

std::span<const Route> sightingRoutes() { return kSightingRoutes; }

}  // namespace mapwright::simulator
