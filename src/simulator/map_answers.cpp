#include "simulator/map_answers.h"

#include "simulator/json_shapes.h"
#include "simulator/png_writing.h"

namespace mapwright::simulator {
namespace {

constexpr std::string_view kForEver = "public, max-age=2592000";

std::string quoted(const std::string& text) {
  std::string out(1, '"');
  out += text;
  out += '"';
  return out;
}

}  // namespace

std::string faultyPng(const std::string& png, const Faults& faults) {
  std::string made = faults.lying_map_size ? withDeclaredSize(png, 60'000, 60'000) : png;
  if (faults.truncated_maps) made.resize(made.size() / 2);
  return made;
}

HttpAnswer pictureAnswer(const MapPicturePtr& picture, const HttpQuestion& question, bool for_ever,
                         const Faults& faults) {
  if (!picture) return errorAnswer(404, "There is no such picture.");
  // Static files carry their tag without quotes, as these robots send it.
  const std::string tag = for_ever ? picture->hash : quoted(picture->hash);
  HttpAnswer answer;
  answer.headers = {{"ETag", tag}, {"Cache-Control", for_ever ? std::string(kForEver) : "no-cache"}};
  if (matchesTag(question.if_none_match, tag) || matchesTag(question.if_none_match, quoted(tag))) {
    answer.status = 304;
    answer.content_type.clear();
    return answer;
  }
  answer.content_type = "image/png";
  answer.body = faults.truncated_maps || faults.lying_map_size
                    ? std::make_shared<const std::string>(faultyPng(*picture->png, faults))
                    : picture->png;
  return answer;
}

HttpAnswer bytesAnswer(std::shared_ptr<const std::string> bytes, const HttpQuestion& question) {
  const std::string tag = quoted(contentHash(*bytes));
  HttpAnswer answer;
  answer.headers = {{"ETag", tag}, {"Cache-Control", "no-cache"}};
  if (matchesTag(question.if_none_match, tag)) {
    answer.status = 304;
    answer.content_type.clear();
    return answer;
  }
  answer.content_type = "application/octet-stream";
  answer.body = std::move(bytes);
  return answer;
}

std::shared_ptr<const std::string> pbstreamOf(const MapPicturePtr& picture) {
  return std::make_shared<const std::string>("simulated pbstream of " +
                                             (picture ? picture->hash : "nothing"));
}

Value mapValue(const StoredMap& map) {
  return Value::Object{{"id", map.id},
                       {"uid", map.uid},
                       {"map_name", map.name},
                       {"create_time", map.created_s},
                       {"map_version", map.map_version},
                       {"overlays_version", map.overlays_version}};
}

void addGrid(Value& value, const MapPicturePtr& picture) {
  value.set("grid_origin_x", picture ? picture->origin_m.x() : 0);
  value.set("grid_origin_y", picture ? picture->origin_m.y() : 0);
  value.set("grid_resolution", picture ? picture->resolution_m : 0);
}

Value mapRow(const StoredMap& map) {
  const std::string path = "/maps/" + std::to_string(map.id);
  Value row = mapValue(map);
  row.set("thumbnail_url", ownUrl(path + "/thumbnail"));
  row.set("image_url", ownUrl(path + ".png"));
  row.set("url", ownUrl(path));
  return row;
}

}  // namespace mapwright::simulator
