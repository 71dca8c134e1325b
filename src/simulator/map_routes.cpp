#include "simulator/map_routes.h"

#include "simulator/json_text.h"
#include "simulator/map_answers.h"
#include "simulator/map_overlays.h"
#include "simulator/map_upload.h"
#include "simulator/png_writing.h"
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

}  // namespace

std::optional<HttpAnswer> MapRoutes::answer(const HttpQuestion& question) {
  const std::string_view path = pathOf(question.target);
  HttpAnswer answer;
  if (path == "/maps" || path == "/maps/") {
    answer = collection(question);
  } else if (path.starts_with("/maps/")) {
    answer = map(path.substr(6), question);
  } else if (path.starts_with("/static-files/")) {
    if (auto refused = refusedMethod(question, "GET")) return refused;
    answer = pictureAnswer(library_.staticFile(path.substr(14)), question, true, faults_.faults());
  } else {
    return std::nullopt;
  }
  answer.delay_ms += faults_.faults().map_latency_ms;
  return answer;
}

HttpAnswer MapRoutes::collection(const HttpQuestion& question) {
  if (auto refused = refusedMethod(question, "GET, POST, DELETE")) return *refused;
  if (question.method == "POST") return create(question);
  if (question.method == "DELETE") {
    library_.removeAll();
    return noContent();
  }
  if (faults_.faults().map_list_error) return jsonAnswer(500, jsonDetail("The database is locked."));
  std::string body = "[";
  for (const StoredMap& map : library_.maps()) {
    if (body.size() > 1) body += ',';
    appendMapRow(body, map);
  }
  return jsonAnswer(200, body + "]");
}

HttpAnswer MapRoutes::create(const HttpQuestion& question) {
  const std::optional<RequestFields> fields = RequestFields::read(question.content_type, question.body);
  if (!fields) return jsonAnswer(400, jsonDetail("The request is no JSON object and no form."));
  StoredMap map;
  if (fields->has("mapping_id")) {
    const std::optional<std::int64_t> id = fields->integer("mapping_id");
    const std::optional<MappingTask> task =
        id && *id > 0 && *id < 1'000'000'000 ? mappings_.find(static_cast<int>(*id)) : std::nullopt;
    if (!task) return jsonAnswer(400, jsonDetail("mapping_id: there is no such mapping task."));
    if (!task->wish) return jsonAnswer(400, jsonDetail("mapping_id: this mapping task made no map."));
    const std::optional<std::string> name = fields->text("map_name");
    if (!name || name->empty() || name->size() > kLongestMapName)
      return jsonAnswer(400, jsonDetail("map_name: must be a text of 1 to 255 bytes."));
    map.name = *name;
    map.wish = task->wish;
    map.overlays = std::make_shared<const std::string>(noOverlays());
  } else {
    auto handed_in = readMapUpload(*fields);
    if (!handed_in) return jsonAnswer(400, jsonDetail(handed_in.error()));
    map = std::move(*handed_in);
  }
  const std::optional<StoredMap> kept = library_.add(std::move(map));
  if (!kept) return jsonAnswer(400, jsonDetail("uid: there is a map with this uid already."));
  std::string body;
  appendMapRow(body, *kept);
  return jsonAnswer(201, std::move(body));
}

HttpAnswer MapRoutes::map(std::string_view rest, const HttpQuestion& question) {
  const std::size_t end = rest.find_first_of("./");
  const std::optional<int> id = numberFrom<int>(rest.substr(0, end));
  const std::optional<StoredMap> map = id ? library_.find(*id) : std::nullopt;
  if (!map) return jsonAnswer(404, jsonDetail("There is no such map."));
  const std::string_view part = end == std::string_view::npos ? std::string_view() : rest.substr(end);
  if (part.empty() || part == "/") {
    if (auto refused = refusedMethod(question, "GET, PATCH, DELETE")) return *refused;
    if (question.method == "PATCH") return change(*map, question);
    if (question.method == "GET") return detail(*map);
    return library_.remove(map->id) ? noContent() : jsonAnswer(404, jsonDetail("There is no such map."));
  }
  if (part != ".png" && part != "/thumbnail" && part != ".pbstream" && part != "/download") return notFound();
  if (auto refused = refusedMethod(question, "GET")) return *refused;
  if (part == ".pbstream") return bytesAnswer(pbstreamOf(library_, *map), question);
  if (part == "/download") return download(*map);
  return pictureAnswer(part == ".png" ? library_.pictureOf(*map) : library_.thumbnailOf(*map), question,
                       false, faults_.faults());
}

HttpAnswer MapRoutes::detail(const StoredMap& map) {
  const MapPicturePtr picture = library_.pictureOf(map);
  const std::string path = "/maps/" + std::to_string(map.id);
  std::string body;
  appendMap(body, map);
  body += ",\"last_modified_time\":" + std::to_string(map.modified_s);
  appendFaultyGrid(body, picture, faults_.faults().grid_fault);
  body += ",\"overlays\":";
  appendJsonText(body, map.overlays ? *map.overlays : "");
  body += ",\"image_size\":" + std::to_string(picture ? picture->png->size() : 0) +
          ",\"pbstream_size\":" + std::to_string(pbstreamOf(library_, map)->size());
  appendOwnUrl(body, "thumbnail_url", path + "/thumbnail");
  appendOwnUrl(body, "image_url", path + ".png");
  appendOwnUrl(body, "download_url", path + "/download");
  appendOwnUrl(body, "pbstream_url", path + ".pbstream");
  return jsonAnswer(200, body + "}");
}

HttpAnswer MapRoutes::change(const StoredMap& map, const HttpQuestion& question) {
  const std::optional<RequestFields> fields = RequestFields::read({}, question.body);
  if (!fields) return jsonAnswer(400, jsonDetail("The request is no JSON object."));
  MapPatch patch{fields->text("map_name"), fields->text("overlays")};
  if (fields->has("map_name") && (!patch.name || patch.name->empty() || patch.name->size() > kLongestMapName))
    return jsonAnswer(400, jsonDetail("map_name: must be a text of 1 to 255 bytes."));
  if (fields->has("overlays") && (!patch.overlays || !isOverlays(*patch.overlays)))
    return jsonAnswer(400, jsonDetail("overlays: must be the text of a GeoJSON FeatureCollection."));
  if (!patch.name && !patch.overlays) return detail(map);
  const std::optional<StoredMap> changed = library_.patch(map.id, patch);
  return changed ? detail(*changed) : jsonAnswer(404, jsonDetail("There is no such map."));
}

HttpAnswer MapRoutes::download(const StoredMap& map) {
  const MapPicturePtr picture = library_.pictureOf(map);
  if (!picture) return notFound();
  std::string body;
  appendMap(body, map);
  appendGrid(body, picture);
  body += ",\"overlays\":";
  appendJsonText(body, map.overlays ? *map.overlays : "");
  body += ",\"carto_map\":\"" + base64(*pbstreamOf(library_, map)) + "\",\"occupancy_grid\":\"" +
          base64(faultyPng(*picture->png, faults_.faults()));
  return jsonAnswer(200, body + "\"}");
}

}  // namespace mapwright::simulator
