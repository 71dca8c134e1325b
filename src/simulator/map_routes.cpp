#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <tl/expected.hpp>

#include "simulator/axbot_routes.h"
#include "simulator/noise.h"

namespace mapwright::simulator {
namespace {

constexpr std::size_t kLongestMapName = 255;
constexpr std::string_view kForEver = "public, max-age=2592000";
constexpr double kTrailStepM = 0.5;
constexpr int kMostTrailPoints = 4000;

bool isName(const std::optional<std::string>& text) {
  return text && !text->empty() && text->size() <= kLongestMapName;
}

std::string quoted(const std::string& text) { return '"' + text + '"'; }

/// 404 if there is none, 304 if the client has it.
HttpAnswer pictureAnswer(const Robot& robot, const Request& request, const MapPicturePtr& picture,
                         bool for_ever = false) {
  if (!picture) return errorAnswer(404, "There is no such picture.");
  // Static files carry their tag without quotes, as these robots send it.
  const std::string tag = for_ever ? picture->hash : quoted(picture->hash);
  const std::string_view known = request.question.if_none_match;
  HttpAnswer answer;
  if (matchesTag(known, tag) || matchesTag(known, quoted(tag))) {
    answer = emptyAnswer(304);
  } else {
    answer.content_type = "image/png";
    answer.body = std::make_shared<const std::string>(faultyPng(*picture->png, robot.faults.faults()));
  }
  answer.headers = {{"ETag", tag}, {"Cache-Control", for_ever ? std::string(kForEver) : "no-cache"}};
  return answer;
}

/// Bytes that a client may cache by their tag, and get from any offset on.
HttpAnswer bytesAnswer(std::string bytes, const Request& request) {
  const std::string tag = quoted(contentHash(bytes));
  const bool known = matchesTag(request.question.if_none_match, tag);
  HttpAnswer answer = known ? emptyAnswer(304) : bytesFrom(request.question, std::move(bytes), tag);
  answer.headers.insert(answer.headers.end(), {{"ETag", tag}, {"Cache-Control", "no-cache"}});
  return answer;
}

/// What the robot positions itself by: what came with an uploaded map, or else made of its picture.
std::shared_ptr<const std::string> pbstreamOf(MapLibrary& library, const StoredMap& map) {
  return map.carto_map ? map.carto_map : library.stateFile(library.pictureOf(map));
}

/// The common members of all answers about a map.
Value mapValue(const StoredMap& map) {
  return Value::Object{{"id", map.id},
                       {"uid", map.uid},
                       {"map_name", map.name},
                       {"create_time", map.created_s},
                       {"map_version", map.map_version},
                       {"overlays_version", map.overlays_version}};
}

/// Adds where the picture lies and its resolution; zeros without a picture.
void addGrid(Value& value, const MapPicturePtr& picture, std::string_view fault = {}) {
  if (fault != "no-origin") {
    value.set("grid_origin_x", picture ? picture->origin_m.x() : 0);
    value.set("grid_origin_y", picture ? picture->origin_m.y() : 0);
  }
  if (const auto resolution = faultyResolution(picture ? picture->resolution_m : 0, fault))
    value.set("grid_resolution", *resolution);
}

/// One row of the list of maps.
Value mapRow(const StoredMap& map) {
  const std::string path = "/maps/" + std::to_string(map.id);
  Value row = mapValue(map);
  row.set("thumbnail_url", ownUrl(path + "/thumbnail"));
  row.set("image_url", ownUrl(path + ".png"));
  row.set("url", ownUrl(path));
  return row;
}

/// nullopt for what is no base64. White space is skipped, a data-URL prefix too.
std::optional<std::string> fromUploadedBase64(std::string text) {
  if (text.starts_with("data:")) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) return std::nullopt;
    text.erase(0, comma + 1);
  }
  std::erase_if(text, [](char c) { return c == '\n' || c == '\r' || c == ' ' || c == '\t'; });
  // Padding may be left out, but not be wrong.
  const std::size_t digits = text.find_last_not_of('=') + 1, padding = text.size() - digits;
  if (padding > 2 || (padding > 0 && text.size() % 4 != 0)) return std::nullopt;
  return fromBase64(text);
}

/// Bytes of a form's part, or base64 of either kind of request.
std::optional<std::string> bytesOf(const RequestFields& fields, std::string_view key,
                                   std::string_view magic) {
  std::optional<std::string> text = fields.text(key);
  if (!text || (!magic.empty() && text->starts_with(magic))) return text;
  return fromUploadedBase64(std::move(*text));
}

/// A number that a version can be.
std::optional<int> versionOf(const RequestFields& fields, std::string_view key) {
  if (!fields.has(key)) return 1;
  const std::optional<std::int64_t> number = fields.integer(key);
  if (!number || *number < 0 || *number > std::numeric_limits<int>::max() / 2) return std::nullopt;
  return static_cast<int>(*number);
}

/// A map uploaded by a client: its fields, picture and name. The error is a sentence for the client.
tl::expected<StoredMap, std::string> readMapUpload(const RequestFields& fields) {
  const auto fail = [](std::string sentence) { return tl::make_unexpected(std::move(sentence)); };
  for (const char* key : {"data_url", "occupancy_grid_filename", "carto_map_filename"}) {
    if (fields.has(key)) return fail(std::string(key) + ": there is no such file on this robot.");
  }
  for (const char* key :
       {"map_name", "carto_map", "occupancy_grid", "grid_origin_x", "grid_origin_y", "grid_resolution"}) {
    if (!fields.has(key)) return fail(std::string(key) + ": this field is required.");
  }
  StoredMap map;
  const std::optional<std::string> name = fields.text("map_name");
  if (!isName(name)) return fail("map_name: must be a text of 1 to 255 bytes.");
  map.name = *name;
  const std::optional<double> x = fields.number("grid_origin_x"), y = fields.number("grid_origin_y"),
                              resolution = fields.number("grid_resolution");
  if (!x || !y || !resolution) return fail("grid_origin_x, grid_origin_y, grid_resolution: must be numbers.");
  if (*resolution <= 0 || *resolution > 10) return fail("grid_resolution: must lie between 0 and 10 metres.");
  std::optional<std::string> carto_map = bytesOf(fields, "carto_map", {});
  if (!carto_map) return fail("carto_map: is no base64.");
  map.carto_map = std::make_shared<const std::string>(std::move(*carto_map));
  std::optional<std::string> png = bytesOf(fields, "occupancy_grid", "\x89PNG");
  if (!png) return fail("occupancy_grid: is no base64.");
  const std::optional<GrayPicture> gray = readPng(*png);
  if (!gray) return fail("occupancy_grid: is no PNG of at most 32 million pixels.");
  map.picture = placedPicture({gray->width, gray->height, *resolution, {*x, *y}}, std::move(*png));
  map.thumbnail = thumbnailOf(*map.picture, *gray);
  const std::optional<int> version = versionOf(fields, "map_version"),
                           overlays_version = versionOf(fields, "overlays_version");
  if (!version || !overlays_version) return fail("map_version, overlays_version: must be whole numbers.");
  map.map_version = *version;
  map.overlays_version = *overlays_version;
  if (fields.has("uid")) {
    const std::optional<std::string> uid = fields.text("uid");
    if (!isName(uid)) return fail("uid: must be a text of 1 to 255 bytes.");
    map.uid = *uid;
  }
  const std::string overlays = fields.has("overlays") ? fields.text("overlays").value_or("*") : noOverlays();
  if (!isOverlays(overlays)) return fail("overlays: must be the text of a GeoJSON FeatureCollection.");
  map.overlays = std::make_shared<const std::string>(overlays);
  return map;
}

HttpAnswer createMap(const Robot& robot, const Request& request) {
  const RequestFields& fields = request.fields;
  StoredMap map;
  if (fields.has("mapping_id")) {
    const std::optional<std::int64_t> id = fields.integer("mapping_id");
    const std::optional<MappingTask> task =
        id && *id > 0 && *id < 1'000'000'000 ? robot.mappings.find(static_cast<int>(*id)) : std::nullopt;
    if (!task) return errorAnswer(400, "mapping_id: there is no such mapping task.");
    if (!task->spec) return errorAnswer(400, "mapping_id: this mapping task made no map.");
    const std::optional<std::string> name = fields.text("map_name");
    if (!isName(name)) return errorAnswer(400, "map_name: must be a text of 1 to 255 bytes.");
    map.name = *name;
    map.spec = task->spec;
    map.overlays = std::make_shared<const std::string>(noOverlays());
  } else {
    auto handed_in = readMapUpload(fields);
    if (!handed_in) return errorAnswer(400, handed_in.error());
    map = std::move(*handed_in);
  }
  const std::optional<StoredMap> kept = robot.library.add(std::move(map));
  if (!kept) return errorAnswer(400, "uid: there is a map with this uid already.");
  return valueAnswer(201, mapRow(*kept));
}

HttpAnswer listMaps(const Robot& robot, const Request&) {
  Value::List rows;
  for (const StoredMap& map : robot.library.maps()) rows.push_back(mapRow(map));
  return valueAnswer(200, rows);
}

HttpAnswer deleteMaps(const Robot& robot, const Request&) {
  robot.library.removeAll();
  return emptyAnswer(204);
}

HttpAnswer mapDetail(const Robot& robot, const StoredMap& map, const Request&) {
  const MapPicturePtr picture = robot.library.pictureOf(map);
  const std::string path = "/maps/" + std::to_string(map.id);
  Value body = mapValue(map);
  body.set("last_modified_time", map.modified_s);
  addGrid(body, picture, robot.faults.faults().grid_fault);
  body.set("overlays", map.overlays ? *map.overlays : "");
  body.set("image_size", picture ? picture->png->size() : 0);
  body.set("pbstream_size", pbstreamOf(robot.library, map)->size());
  body.set("thumbnail_url", ownUrl(path + "/thumbnail"));
  body.set("image_url", ownUrl(path + ".png"));
  body.set("download_url", ownUrl(path + "/download"));
  body.set("pbstream_url", ownUrl(path + ".pbstream"));
  return valueAnswer(200, body);
}

HttpAnswer noSuchMap() { return errorAnswer(404, "There is no such map."); }

/// A route of a stored map, whose id the path has.
template <HttpAnswer (*kAnswer)(const Robot&, const StoredMap&, const Request&)>
HttpAnswer ofMap(const Robot& robot, const Request& request) {
  const std::optional<StoredMap> map = robot.library.find(numberFrom<int>(request.name).value_or(-1));
  return map ? kAnswer(robot, *map, request) : noSuchMap();
}

HttpAnswer changeMap(const Robot& robot, const StoredMap& map, const Request& request) {
  const RequestFields& fields = request.fields;
  MapPatch patch{fields.text("map_name"), fields.text("overlays")};
  if (fields.has("map_name") && !isName(patch.name))
    return errorAnswer(400, "map_name: must be a text of 1 to 255 bytes.");
  if (fields.has("overlays") && (!patch.overlays || !isOverlays(*patch.overlays)))
    return errorAnswer(400, "overlays: must be the text of a GeoJSON FeatureCollection.");
  if (!patch.name && !patch.overlays) return mapDetail(robot, map, request);
  if (patch.overlays && robot.faults.faults().overlay_edit_before_writes) robot.library.editOverlays(map.id);
  const std::optional<StoredMap> changed = robot.library.patch(map.id, patch);
  return changed ? mapDetail(robot, *changed, request) : noSuchMap();
}

HttpAnswer deleteMap(const Robot& robot, const StoredMap& map, const Request&) {
  return robot.library.remove(map.id) ? emptyAnswer(204) : noSuchMap();
}

HttpAnswer downloadMap(const Robot& robot, const StoredMap& map, const Request&) {
  const MapPicturePtr picture = robot.library.pictureOf(map);
  if (!picture) return errorAnswer(404, "Not found.");
  Value body = mapValue(map);
  addGrid(body, picture);
  body.set("overlays", map.overlays ? *map.overlays : "");
  body.set("carto_map", Value::Bytes{*pbstreamOf(robot.library, map)});
  body.set("occupancy_grid", Value::Bytes{faultyPng(*picture->png, robot.faults.faults())});
  return valueAnswer(200, body);
}

HttpAnswer mapPicture(const Robot& robot, const StoredMap& map, const Request& request) {
  return pictureAnswer(robot, request, robot.library.pictureOf(map));
}

HttpAnswer mapThumbnail(const Robot& robot, const StoredMap& map, const Request& request) {
  return pictureAnswer(robot, request, robot.library.thumbnailOf(map));
}

HttpAnswer mapPbstream(const Robot& robot, const StoredMap& map, const Request& request) {
  return bytesAnswer(*pbstreamOf(robot.library, map), request);
}

HttpAnswer staticFile(const Robot& robot, const Request& request) {
  return pictureAnswer(robot, request, robot.library.staticFile(request.name), true);
}

HttpAnswer setCurrentMap(const Robot& robot, const Request& request) {
  const RequestFields& fields = request.fields;
  if (robot.state.mapping()) return errorAnswer(400, "A mapping task is running.");
  if (fields.has("map_id")) {
    const std::optional<std::int64_t> id = fields.integer("map_id");
    if (!id || *id < 0 || *id > 1'000'000'000 || !robot.library.setCurrent(static_cast<int>(*id)))
      return errorAnswer(400, "map_id: there is no such map.");
  } else if (fields.has("map_uid")) {
    if (!robot.library.setCurrent(-1, fields.text("map_uid").value_or("")))
      return errorAnswer(400, "map_uid: there is no such map.");
  } else if (fields.has("map_name") || fields.has("occupancy_grid") || fields.has("data_url")) {
    auto handed_in = readMapUpload(fields);
    if (!handed_in) return errorAnswer(400, handed_in.error());
    robot.library.setCurrentFromData(std::move(*handed_in));
  } else {
    return errorAnswer(400, "Either map_id, map_uid or the data of a map is required.");
  }
  return valueAnswer(200, mapValue(robot.library.current().value_or(StoredMap{})));
}

HttpAnswer currentMap(const Robot& robot, const Request&) {
  StoredMap none;
  none.id = -1;
  none.map_version = none.overlays_version = 0;
  return valueAnswer(200, mapValue(robot.library.current().value_or(none)));
}

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
  Value::List list = landmarksAlong(*way.drive, way.from_m, way.length_m());
  for (std::size_t i = 0; i < list.size(); ++i) list[i].set("in_use", i % 3 != 2);
  return list;
}

HttpAnswer noSuchTask() { return errorAnswer(404, "There is no such mapping task."); }

HttpAnswer taskRuns() { return errorAnswer(400, "A mapping task is running. Finish or cancel it first."); }

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

HttpAnswer startMapping(const Robot& robot, const Request& request) {
  const RequestFields& fields = request.fields;
  const std::optional<bool> continues = fields.flag("continue_mapping", false);
  if (!continues) return errorAnswer(400, "continue_mapping: must be true or false.");
  const std::string from =
      fields.has("start_pose_type") ? fields.text("start_pose_type").value_or("") : "zero";
  if (from != "zero" && from != "current_pose")
    return errorAnswer(400, "start_pose_type: must be \"zero\" or \"current_pose\".");
  if (!robot.state.canMap()) return errorAnswer(400, "This robot has nothing to map.");
  if (*continues && !robot.library.current())
    return errorAnswer(400, "There is no current map that could be continued.");
  const std::optional<MappingTask> task = robot.mappings.start(*continues ? Mapping::Continue : Mapping::New);
  if (!task) return errorAnswer(400, "A mapping task is running already.");
  return shownTask(robot, 201, *task);
}

HttpAnswer listTasks(const Robot& robot, const Request&) {
  Value::List tasks;
  for (const MappingTask& task : robot.mappings.tasks()) tasks.push_back(taskValue(robot, task));
  return valueAnswer(200, tasks);
}

HttpAnswer deleteTasks(const Robot& robot, const Request&) {
  return robot.mappings.removeAll() ? emptyAnswer(204) : taskRuns();
}

HttpAnswer runningTask(const Robot& robot, const std::optional<MappingTask>& task) {
  return task ? shownTask(robot, 200, *task) : errorAnswer(404, "No mapping task is running.");
}

HttpAnswer currentMapping(const Robot& robot, const Request&) {
  return runningTask(robot, robot.mappings.running());
}

HttpAnswer endMapping(const Robot& robot, const Request& request) {
  const std::string state = request.fields.text("state").value_or("");
  if (state != "finished" && state != "cancelled")
    return errorAnswer(400, "state: must be \"finished\" or \"cancelled\".");
  const std::optional<bool> new_only = request.fields.flag("new_map_only", false);
  if (!new_only) return errorAnswer(400, "new_map_only: must be true or false.");
  return runningTask(robot, robot.mappings.end(state == "cancelled" ? MappingTasks::End::Cancelled
                                               : *new_only          ? MappingTasks::End::FinishedNewOnly
                                                                    : MappingTasks::End::Finished));
}

/// A route of a mapping task, whose id the path has.
template <HttpAnswer (*kAnswer)(const Robot&, const MappingTask&, const Request&)>
HttpAnswer ofTask(const Robot& robot, const Request& request) {
  const std::optional<MappingTask> task = robot.mappings.find(numberFrom<int>(request.name).value_or(-1));
  return task ? kAnswer(robot, *task, request) : noSuchTask();
}

/// What a mapping task made, which some did not.
template <HttpAnswer (*kAnswer)(const Robot&, const DrivenWay&, const PictureSpec&, const Request&)>
HttpAnswer ofMappedWay(const Robot& robot, const MappingTask& task, const Request& request) {
  const std::optional<DrivenWay> way = wayOf(robot.library.scene(), task.spec);
  return way ? kAnswer(robot, *way, *task.spec, request) : errorAnswer(404, "This mapping task made no map.");
}

HttpAnswer taskDetail(const Robot& robot, const MappingTask& task, const Request&) {
  return shownTask(robot, 200, task);
}

HttpAnswer deleteTask(const Robot& robot, const MappingTask& task, const Request&) {
  if (task.state == "running") return taskRuns();
  robot.mappings.remove(task.id);
  return emptyAnswer(204);
}

HttpAnswer taskTrajectories(const Robot&, const DrivenWay& way, const PictureSpec&, const Request&) {
  return valueAnswer(200, trajectoriesOf(way));
}

HttpAnswer taskLandmarks(const Robot&, const DrivenWay& way, const PictureSpec&, const Request&) {
  return valueAnswer(200, landmarksOf(way));
}

HttpAnswer taskPicture(const Robot& robot, const DrivenWay&, const PictureSpec& spec,
                       const Request& request) {
  return pictureAnswer(robot, request, robot.library.pictures().picture(spec));
}

HttpAnswer taskThumbnail(const Robot& robot, const DrivenWay&, const PictureSpec& spec,
                         const Request& request) {
  return pictureAnswer(robot, request, robot.library.pictures().thumbnail(spec));
}

HttpAnswer taskPbstream(const Robot& robot, const DrivenWay&, const PictureSpec& spec,
                        const Request& request) {
  return bytesAnswer(*robot.library.stateFile(robot.library.pictures().picture(spec)), request);
}

constexpr Route kMapRoutes[] = {
    {"GET", "/maps/", listMaps},
    {"POST", "/maps/", createMap, Route::Body::JsonOrForm},
    {"DELETE", "/maps/", deleteMaps},
    {"GET", "/maps/#/", ofMap<mapDetail>},
    {"PATCH", "/maps/#/", ofMap<changeMap>, Route::Body::Json},
    {"DELETE", "/maps/#/", ofMap<deleteMap>},
    {"GET", "/maps/#.png", ofMap<mapPicture>},
    {"GET", "/maps/#/thumbnail", ofMap<mapThumbnail>},
    {"GET", "/maps/#.pbstream", ofMap<mapPbstream>},
    {"GET", "/maps/#/download", ofMap<downloadMap>},
    {"GET", "/static-files/*", staticFile},
    {"GET", "/chassis/current-map", currentMap},
    {"POST", "/chassis/current-map", setCurrentMap, Route::Body::Json},
    {"GET", "/mappings/", listTasks},
    {"POST", "/mappings/", startMapping, Route::Body::Json},
    {"DELETE", "/mappings/", deleteTasks},
    {"GET", "/mappings/current/", currentMapping},
    {"PATCH", "/mappings/current/", endMapping, Route::Body::Json},
    {"GET", "/mappings/#/", ofTask<taskDetail>},
    {"DELETE", "/mappings/#/", ofTask<deleteTask>},
    {"GET", "/mappings/#.png", ofTask<ofMappedWay<taskPicture>>},
    {"GET", "/mappings/#/thumbnail", ofTask<ofMappedWay<taskThumbnail>>},
    {"GET", "/mappings/#/trajectories.json", ofTask<ofMappedWay<taskTrajectories>>},
    {"GET", "/mappings/#/landmarks.json", ofTask<ofMappedWay<taskLandmarks>>},
    {"GET", "/mappings/#.pbstream", ofTask<ofMappedWay<taskPbstream>>}};

}  // namespace

std::string faultyPng(const std::string& png, const Faults& faults) {
  std::string made = faults.lying_map_size ? withDeclaredSize(png, 60'000, 60'000) : png;
  if (faults.truncated_maps) made.resize(made.size() / 2);
  return made;
}

Value::List landmarksAlong(const Drive& drive, double from_m, double length_m) {
  Value::List list;
  for (int i = 0; i < 6; ++i) {
    const geometry::Pose2 by = drive.at(from_m + length_m * (i + 0.5) / 6);
    list.push_back(Value::Object{{"id", "landmark_" + std::to_string(i + 1)},
                                 {"pos", pointOf(by.apply({0, i % 2 == 0 ? 1.1 : -1.1}))}});
  }
  return list;
}

std::span<const Route> mapRoutes() { return kMapRoutes; }

}  // namespace mapwright::simulator
