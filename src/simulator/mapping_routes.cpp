#include <algorithm>
#include <utility>

#include "simulator/json_shapes.h"
#include "simulator/map_answers.h"
#include "simulator/request_fields.h"
#include "simulator/routes.h"
#include "simulator/whole_text.h"

namespace mapwright::simulator {
namespace {

constexpr double kTrailStepM = 0.5;
constexpr int kMostTrailPoints = 4000;

/// The part of a drive that made a map.
struct DrivenWay {
  const Drive* drive = nullptr;
  double from_m = 0, to_m = 0;
  double length_m() const { return to_m - from_m; }
};

std::optional<DrivenWay> wayOf(const Scene& scene, const std::optional<PictureSpec>& spec) {
  const Trajectory* trajectory = spec ? scene.find(spec->trajectory) : nullptr;
  if (trajectory == nullptr) return std::nullopt;
  const double to_m =
      spec->scans < 0 ? trajectory->drive.length_m() : spec->from_m + kScanStepM * spec->scans;
  return DrivenWay{&trajectory->drive, spec->from_m, to_m};
}

/// The way that made the map, in two parts as after a pause.
Value trajectoriesOf(const DrivenWay& way) {
  const double length = way.length_m();
  const double step = std::max(kTrailStepM, length / kMostTrailPoints);
  Value::List parts;
  for (int part = 0; part < 2; ++part) {
    const double from = part == 0 ? 0 : length * 0.6, to = part == 0 ? length * 0.6 : length;
    std::vector<Eigen::Vector2d> points;
    for (double s = from; s <= to; s += step) points.push_back(way.drive->at(way.from_m + s).apply({0, 0}));
    parts.push_back(Value::Object{{"id", part}, {"coordinates", pointsOf(points)}});
  }
  return parts;
}

Value landmarksOf(const DrivenWay& way) {
  Value::List list;
  for (int i = 0; i < 6; ++i) {
    const geometry::Pose2 by = way.drive->at(way.from_m + way.length_m() * (i + 0.5) / 6);
    list.push_back(Value::Object{{"id", "landmark_" + std::to_string(i + 1)},
                                 {"pos", pointOf(by.apply({0, i % 2 == 0 ? 1.1 : -1.1}))},
                                 {"in_use", i % 3 != 2}});
  }
  return list;
}

HttpAnswer noSuchTask() { return errorAnswer(404, "There is no such mapping task."); }

HttpAnswer removed(MappingTasks::Removal removal) {
  if (removal == MappingTasks::Removal::Missing) return noSuchTask();
  if (removal == MappingTasks::Removal::Running)
    return errorAnswer(400, "A mapping task is running. Finish or cancel it first.");
  return noContent();
}

Value taskValue(const Robot& robot, const MappingTask& task) {
  const MapPicturePtr picture = task.spec ? robot.library.pictures().picture(*task.spec) : nullptr;
  const std::string path = "/mappings/" + std::to_string(task.id);
  const auto url = [&](const char* of) { return picture ? ownUrl(path + of) : Value(); };
  Value value = Value::Object{{"id", task.id},
                              {"thumbnail_url", url("/thumbnail")},
                              {"image_url", url(".png")},
                              {"trajectories_url", url("/trajectories.json")},
                              {"landmark_url", url("/landmarks.json")}};
  if (picture) value.set("pbstream_url", url(".pbstream"));
  addGrid(value, picture);
  value.set("url", ownUrl(path));
  value.set("continue_mapping", task.continues);
  value.set("start_time", task.started_s);
  value.set("end_time", task.ended_s ? Value(*task.ended_s) : Value());
  value.set("state", task.state);
  for (const char* name : {"bag_id", "bag_url", "download_url"}) value.set(name, {});
  return value;
}

HttpAnswer shownTask(const Robot& robot, int status, const MappingTask& task) {
  return valueAnswer(status, taskValue(robot, task));
}

HttpAnswer startMapping(const Robot& robot, const HttpQuestion& question) {
  const std::optional<RequestFields> fields = RequestFields::read({}, question.body);
  if (!fields) return errorAnswer(400, "The request is no JSON object.");
  const std::optional<bool> continues =
      fields->has("continue_mapping") ? fields->flag("continue_mapping") : std::optional(false);
  if (!continues) return errorAnswer(400, "continue_mapping: must be true or false.");
  const std::string from =
      fields->has("start_pose_type") ? fields->text("start_pose_type").value_or("") : "zero";
  if (from != "zero" && from != "current_pose")
    return errorAnswer(400, "start_pose_type: must be \"zero\" or \"current_pose\".");
  if (!robot.state.canMap()) return errorAnswer(400, "This robot has nothing to map.");
  if (*continues && !robot.library.current())
    return errorAnswer(400, "There is no current map that could be continued.");
  const std::optional<MappingTask> task = robot.mappings.start(*continues ? Mapping::Continue : Mapping::New);
  if (!task) return errorAnswer(400, "A mapping task is running already.");
  return shownTask(robot, 201, *task);
}

HttpAnswer mappingCollection(const Robot& robot, const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "GET, POST, DELETE")) return *refused;
  if (question.method == "POST") return startMapping(robot, question);
  if (question.method == "DELETE") return removed(robot.mappings.removeAll());
  Value::List tasks;
  for (const MappingTask& task : robot.mappings.tasks()) tasks.push_back(taskValue(robot, task));
  return valueAnswer(200, tasks);
}

HttpAnswer currentMapping(const Robot& robot, const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "GET, PATCH")) return *refused;
  if (question.method == "GET") {
    const std::optional<MappingTask> task = robot.mappings.running();
    return task ? shownTask(robot, 200, *task) : errorAnswer(404, "No mapping task is running.");
  }
  const std::optional<RequestFields> fields = RequestFields::read({}, question.body);
  if (!fields) return errorAnswer(400, "The request is no JSON object.");
  const std::string state = fields->text("state").value_or("");
  if (state != "finished" && state != "cancelled")
    return errorAnswer(400, "state: must be \"finished\" or \"cancelled\".");
  const std::optional<bool> new_only =
      fields->has("new_map_only") ? fields->flag("new_map_only") : std::optional(false);
  if (!new_only) return errorAnswer(400, "new_map_only: must be true or false.");
  const std::optional<MappingTask> task =
      robot.mappings.end(state == "cancelled" ? MappingTasks::End::Cancelled
                         : *new_only          ? MappingTasks::End::FinishedNewOnly
                                              : MappingTasks::End::Finished);
  return task ? shownTask(robot, 200, *task) : errorAnswer(404, "No mapping task is running.");
}

HttpAnswer mappingTask(const Robot& robot, std::string_view rest, const HttpQuestion& question) {
  const std::size_t end = rest.find_first_of("./");
  const std::optional<int> id = numberFrom<int>(rest.substr(0, end));
  const std::string_view part = end == std::string_view::npos ? std::string_view() : rest.substr(end);
  const std::optional<MappingTask> task = id ? robot.mappings.find(*id) : std::nullopt;
  if (!task) return noSuchTask();
  if (part.empty() || part == "/") {
    if (auto refused = refusedMethod(question, "GET, DELETE")) return *refused;
    return question.method == "DELETE" ? removed(robot.mappings.remove(*id)) : shownTask(robot, 200, *task);
  }
  if (part != ".png" && part != "/thumbnail" && part != "/trajectories.json" && part != "/landmarks.json" &&
      part != ".pbstream")
    return notFound();
  if (auto refused = refusedMethod(question, "GET")) return *refused;
  const std::optional<DrivenWay> way = wayOf(robot.library.scene(), task->spec);
  if (!way) return errorAnswer(404, "This mapping task made no map.");
  if (part == "/trajectories.json") return valueAnswer(200, trajectoriesOf(*way));
  if (part == "/landmarks.json") return valueAnswer(200, landmarksOf(*way));
  if (part == ".pbstream")
    return bytesAnswer(pbstreamOf(robot.library.pictures().picture(*task->spec)), question);
  return pictureAnswer(part == ".png" ? robot.library.pictures().picture(*task->spec)
                                      : robot.library.pictures().thumbnail(*task->spec),
                       question, false, robot.faults.faults());
}

}  // namespace

std::optional<HttpAnswer> mappingAnswer(const Robot& robot, const HttpQuestion& question) {
  const std::string_view path = pathOf(question.target);
  HttpAnswer answer;
  if (path == "/mappings" || path == "/mappings/") {
    answer = mappingCollection(robot, question);
  } else if (path == "/mappings/current" || path == "/mappings/current/") {
    answer = currentMapping(robot, question);
  } else if (path.starts_with("/mappings/")) {
    answer = mappingTask(robot, path.substr(10), question);
  } else {
    return std::nullopt;
  }
  answer.delay_ms += robot.faults.faults().map_latency_ms;
  return answer;
}

}  // namespace mapwright::simulator
