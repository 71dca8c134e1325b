#include "simulator/json_text.h"
#include "simulator/map_answers.h"
#include "simulator/map_overlays.h"
#include "simulator/map_upload.h"
#include "simulator/png_writing.h"
#include "simulator/routes.h"
#include "simulator/whole_text.h"

namespace mapwright::simulator {
namespace {

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
    if (!task->wish) return errorAnswer(400, "mapping_id: this mapping task made no map.");
    const std::optional<std::string> name = fields->text("map_name");
    if (!name || name->empty() || name->size() > kLongestMapName)
      return errorAnswer(400, "map_name: must be a text of 1 to 255 bytes.");
    map.name = *name;
    map.wish = task->wish;
    map.overlays = std::make_shared<const std::string>(noOverlays());
  } else {
    auto handed_in = readMapUpload(*fields);
    if (!handed_in) return errorAnswer(400, handed_in.error());
    map = std::move(*handed_in);
  }
  const std::optional<StoredMap> kept = robot.library.add(std::move(map));
  if (!kept) return errorAnswer(400, "uid: there is a map with this uid already.");
  std::string body;
  appendMapRow(body, *kept);
  return jsonAnswer(201, std::move(body));
}

HttpAnswer mapCollection(const Robot& robot, const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "GET, POST, DELETE")) return *refused;
  if (question.method == "POST") return createMap(robot, question);
  if (question.method == "DELETE") {
    robot.library.removeAll();
    return noContent();
  }
  if (robot.faults.faults().map_list_error) return errorAnswer(500, "The database is locked.");
  std::string body = "[";
  for (const StoredMap& map : robot.library.maps()) {
    if (body.size() > 1) body += ',';
    appendMapRow(body, map);
  }
  return jsonAnswer(200, body + "]");
}

HttpAnswer mapDetail(const Robot& robot, const StoredMap& map) {
  const MapPicturePtr picture = robot.library.pictureOf(map);
  const std::string path = "/maps/" + std::to_string(map.id);
  std::string body;
  appendMap(body, map);
  body += ",\"last_modified_time\":" + std::to_string(map.modified_s);
  appendFaultyGrid(body, picture, robot.faults.faults().grid_fault);
  body += ",\"overlays\":";
  appendJsonText(body, map.overlays ? *map.overlays : "");
  body += ",\"image_size\":" + std::to_string(picture ? picture->png->size() : 0) +
          ",\"pbstream_size\":" + std::to_string(pbstreamOf(robot.library, map)->size());
  appendOwnUrl(body, "thumbnail_url", path + "/thumbnail");
  appendOwnUrl(body, "image_url", path + ".png");
  appendOwnUrl(body, "download_url", path + "/download");
  appendOwnUrl(body, "pbstream_url", path + ".pbstream");
  return jsonAnswer(200, body + "}");
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
  std::string body;
  appendMap(body, map);
  appendGrid(body, picture);
  body += ",\"overlays\":";
  appendJsonText(body, map.overlays ? *map.overlays : "");
  body += ",\"carto_map\":\"" + base64(*pbstreamOf(robot.library, map)) + "\",\"occupancy_grid\":\"" +
          base64(faultyPng(*picture->png, robot.faults.faults()));
  return jsonAnswer(200, body + "\"}");
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
