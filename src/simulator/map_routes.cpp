#include "simulator/json_shapes.h"
#include "simulator/map_answers.h"
#include "simulator/map_overlays.h"
#include "simulator/map_upload.h"
#include "simulator/routes.h"
#include "simulator/whole_text.h"

namespace mapwright::simulator {
namespace {

void addFaultyGrid(Value& value, const MapPicturePtr& picture, const std::string& fault) {
  Value grid;
  addGrid(grid, picture);
  if (fault == "zero-resolution") grid.set("grid_resolution", 0);
  if (fault == "negative-resolution") grid.set("grid_resolution", -0.05);
  for (const auto& [name, number] : *grid.as<Value::Object>()) {
    const bool left_out = name == "grid_resolution" ? fault == "no-resolution" : fault == "no-origin";
    if (!left_out) value.set(name, number);
  }
}

std::shared_ptr<const std::string> pbstreamOf(MapLibrary& library, const StoredMap& map) {
  return map.carto_map ? map.carto_map : pbstreamOf(library.pictureOf(map));
}

HttpAnswer createMap(const Robot& robot, const HttpQuestion& question) {
  const std::optional<RequestFields> fields = RequestFields::read(question.content_type, question.body);
  if (!fields) return errorAnswer(400, "The request is no JSON object and no form.");
  StoredMap map;
  if (fields->has("mapping_id")) {
    const std::optional<std::int64_t> id = fields->integer("mapping_id");
    const std::optional<MappingTask> task =
        id && *id > 0 && *id < 1'000'000'000 ? robot.mappings.find(static_cast<int>(*id)) : std::nullopt;
    if (!task) return errorAnswer(400, "mapping_id: there is no such mapping task.");
    if (!task->spec) return errorAnswer(400, "mapping_id: this mapping task made no map.");
    const std::optional<std::string> name = fields->text("map_name");
    if (!name || name->empty() || name->size() > kLongestMapName)
      return errorAnswer(400, "map_name: must be a text of 1 to 255 bytes.");
    map.name = *name;
    map.spec = task->spec;
    map.overlays = std::make_shared<const std::string>(noOverlays());
  } else {
    auto handed_in = readMapUpload(*fields);
    if (!handed_in) return errorAnswer(400, handed_in.error());
    map = std::move(*handed_in);
  }
  const std::optional<StoredMap> kept = robot.library.add(std::move(map));
  if (!kept) return errorAnswer(400, "uid: there is a map with this uid already.");
  return valueAnswer(201, mapRow(*kept));
}

HttpAnswer mapCollection(const Robot& robot, const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "GET, POST, DELETE")) return *refused;
  if (question.method == "POST") return createMap(robot, question);
  if (question.method == "DELETE") {
    robot.library.removeAll();
    return noContent();
  }
  if (robot.faults.faults().map_list_error) return errorAnswer(500, "The database is locked.");
  Value::List rows;
  for (const StoredMap& map : robot.library.maps()) rows.push_back(mapRow(map));
  return valueAnswer(200, rows);
}

HttpAnswer mapDetail(const Robot& robot, const StoredMap& map) {
  const MapPicturePtr picture = robot.library.pictureOf(map);
  const std::string path = "/maps/" + std::to_string(map.id);
  Value body = mapValue(map);
  body.set("last_modified_time", map.modified_s);
  addFaultyGrid(body, picture, robot.faults.faults().grid_fault);
  body.set("overlays", map.overlays ? *map.overlays : "");
  body.set("image_size", picture ? picture->png->size() : 0);
  body.set("pbstream_size", pbstreamOf(robot.library, map)->size());
  body.set("thumbnail_url", ownUrl(path + "/thumbnail"));
  body.set("image_url", ownUrl(path + ".png"));
  body.set("download_url", ownUrl(path + "/download"));
  body.set("pbstream_url", ownUrl(path + ".pbstream"));
  return valueAnswer(200, body);
}

HttpAnswer changeMap(const Robot& robot, const StoredMap& map, const HttpQuestion& question) {
  const std::optional<RequestFields> fields = RequestFields::read({}, question.body);
  if (!fields) return errorAnswer(400, "The request is no JSON object.");
  MapPatch patch{fields->text("map_name"), fields->text("overlays")};
  if (fields->has("map_name") && (!patch.name || patch.name->empty() || patch.name->size() > kLongestMapName))
    return errorAnswer(400, "map_name: must be a text of 1 to 255 bytes.");
  if (fields->has("overlays") && (!patch.overlays || !isOverlays(*patch.overlays)))
    return errorAnswer(400, "overlays: must be the text of a GeoJSON FeatureCollection.");
  if (!patch.name && !patch.overlays) return mapDetail(robot, map);
  const std::optional<StoredMap> changed = robot.library.patch(map.id, patch);
  return changed ? mapDetail(robot, *changed) : errorAnswer(404, "There is no such map.");
}

HttpAnswer downloadMap(const Robot& robot, const StoredMap& map) {
  const MapPicturePtr picture = robot.library.pictureOf(map);
  if (!picture) return notFound();
  Value body = mapValue(map);
  addGrid(body, picture);
  body.set("overlays", map.overlays ? *map.overlays : "");
  body.set("carto_map", Value::Bytes{*pbstreamOf(robot.library, map)});
  body.set("occupancy_grid", Value::Bytes{faultyPng(*picture->png, robot.faults.faults())});
  return valueAnswer(200, body);
}

HttpAnswer storedMap(const Robot& robot, std::string_view rest, const HttpQuestion& question) {
  const std::size_t end = rest.find_first_of("./");
  const std::optional<int> id = numberFrom<int>(rest.substr(0, end));
  const std::optional<StoredMap> map = id ? robot.library.find(*id) : std::nullopt;
  if (!map) return errorAnswer(404, "There is no such map.");
  const std::string_view part = end == std::string_view::npos ? std::string_view() : rest.substr(end);
  if (part.empty() || part == "/") {
    if (auto refused = refusedMethod(question, "GET, PATCH, DELETE")) return *refused;
    if (question.method == "PATCH") return changeMap(robot, *map, question);
    if (question.method == "GET") return mapDetail(robot, *map);
    return robot.library.remove(map->id) ? noContent() : errorAnswer(404, "There is no such map.");
  }
  if (part != ".png" && part != "/thumbnail" && part != ".pbstream" && part != "/download") return notFound();
  if (auto refused = refusedMethod(question, "GET")) return *refused;
  if (part == ".pbstream") return bytesAnswer(pbstreamOf(robot.library, *map), question);
  if (part == "/download") return downloadMap(robot, *map);
  return pictureAnswer(part == ".png" ? robot.library.pictureOf(*map) : robot.library.thumbnailOf(*map),
                       question, false, robot.faults.faults());
}

}  // namespace

std::optional<HttpAnswer> mapAnswer(const Robot& robot, const HttpQuestion& question) {
  const std::string_view path = pathOf(question.target);
  HttpAnswer answer;
  if (path == "/maps" || path == "/maps/") {
    answer = mapCollection(robot, question);
  } else if (path.starts_with("/maps/")) {
    answer = storedMap(robot, path.substr(6), question);
  } else if (path.starts_with("/static-files/")) {
    if (auto refused = refusedMethod(question, "GET")) return refused;
    answer = pictureAnswer(robot.library.staticFile(path.substr(14)), question, true, robot.faults.faults());
  } else {
    return std::nullopt;
  }
  answer.delay_ms += robot.faults.faults().map_latency_ms;
  return answer;
}

}  // namespace mapwright::simulator
