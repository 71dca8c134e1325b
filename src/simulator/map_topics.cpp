#include "simulator/map_topics.h"

#include <algorithm>
#include <cmath>

#include "simulator/cost_maps.h"
#include "simulator/json_shapes.h"
#include "simulator/map_answers.h"
#include "simulator/mapping_tasks.h"
#include "simulator/noise.h"
#include "simulator/stamp.h"

namespace mapwright::simulator {
namespace {

constexpr int kLargeCostmap = 500;  // cells of an edge: from here on, pictures are made once in a while
constexpr double kLargeCostmapForS = 10;
constexpr double kEnvironmentM = 0.1;
constexpr double kPatchM = 3;  // the environment has changed in patches of this size

bool hasDataUrl(std::string_view topic) { return topic.ends_with("_v2"); }

MapPicturePtr encodeAt(const GridPlace& place, const GrayPicture& picture) {
  MapPicture made;
  made.png = std::make_shared<const std::string>(writePng(picture, 8));
  made.width = place.width;
  made.height = place.height;
  made.resolution_m = place.resolution_m;
  made.origin_m = place.origin_m;
  made.hash = contentHash(*made.png);
  return std::make_shared<const MapPicture>(std::move(made));
}

/// As the faults leave it.
Value::Object messageAt(double time_s, const MapPicture& picture, const std::string& fault) {
  Value::Object message{{"stamp", fixed(stampOf(time_s), 3)}};
  const double resolution = fault == "zero-resolution"       ? 0
                            : fault == "negative-resolution" ? -picture.resolution_m
                                                             : picture.resolution_m;
  if (fault != "no-resolution") message.emplace_back("resolution", float32(resolution));
  message.emplace_back("size", Value::List{picture.width, picture.height});
  if (fault != "no-origin")
    message.emplace_back("origin", Value::Float64s{picture.origin_m.x(), picture.origin_m.y()});
  return message;
}

}  // namespace

std::optional<Frame> MapTopics::messageOf(std::string_view topic) {
  const MapPicturePtr picture = pictureOf(topic);
  if (!picture) return std::nullopt;
  const Faults faults = faults_.faults();
  Value::Object message = messageAt(state_.time(), *picture, faults.grid_fault);
  if (hasDataUrl(topic)) {
    const std::string path = library_.publishStatic(topic == "/map_v2"           ? "map"
                                                    : topic == "/map/costmap_v2" ? "costmap"
                                                                                 : "incremental",
                                                    picture);
    message.emplace_back("data_url", faults.foreign_data_url ? "http://127.0.0.2:1/" + path : path);
  } else if (faults.garbage_base64) {
    message.emplace_back("data", "iVBORw0KGgo*** this is no base64 ***");
  } else {
    message.emplace_back("data", Value::Bytes{faultyPng(*picture->png, faults)});
  }
  return textFrame(messageJson(topic, std::move(message)));
}

MapPicturePtr MapTopics::pictureOf(std::string_view topic) {
  if (topic == "/map" || topic == "/map_v2") {
    if (const std::optional<MappingSpan> span = state_.mapping()) {
      PictureSpec spec = specOf(*span, false);
      spec.bits = 4;
      return library_.pictures().picture(spec);
    }
    return library_.livePicture();
  }
  if (topic == "/map/costmap" || topic == "/map/costmap_v2") return costsOfWholeMap();
  if (topic == "/maps/5cm/1hz") return costsAroundRobot(0.05, options_.costmap_cells);
  if (topic == "/maps/1cm/1hz") return costsAroundRobot(0.01, std::max(400, options_.costmap_cells));
  if (topic == "/incremental_map" || topic == "/incremental_map_v2") return incremental();
  if (topic == "/env_match_map") return environment(false);
  if (topic == "/env_symmetry_map") return environment(true);
  return nullptr;
}

MapPicturePtr MapTopics::costsAroundRobot(double resolution_m, int cells) {
  if (state_.scene().trajectories.empty()) return nullptr;
  const geometry::Pose2 pose = state_.robotPose();
  const GridPlace place = squareAround({pose.x_m, pose.y_m}, cells, resolution_m);
  const std::string name = "costs" + std::to_string(resolution_m);
  // Large ones stay where they are for a while: making them must not cost more than showing them.
  const std::string of = cells >= kLargeCostmap
                             ? std::to_string(std::floor(state_.time() / kLargeCostmapForS))
                             : std::to_string(place.origin_m.x()) + "," + std::to_string(place.origin_m.y());
  const std::lock_guard lock(mutex_);
  Made& made = made_[name];
  if (!made.picture || made.of != of) made = {of, encodeAt(place, costsOf(state_.plan(), {}, place))};
  return made.picture;
}

MapPicturePtr MapTopics::costsOfWholeMap() {
  const MapPicturePtr map = library_.livePicture();
  if (!map) return nullptr;
  const std::lock_guard lock(mutex_);
  Made& made = made_["/map/costmap"];
  if (!made.picture || made.of != map->hash) {
    const GridPlace place{map->width, map->height, map->resolution_m, map->origin_m};
    made = {map->hash, encodeAt(place, costsOf(state_.plan(), {}, place))};
  }
  return made.picture;
}

MapPicturePtr MapTopics::incremental() {
  PictureSpec spec;
  spec.trajectory = 2;
  spec.scans = state_.scansOf(spec.trajectory);
  if (spec.scans == 0) return nullptr;
  return library_.pictures().picture(spec);
}

MapPicturePtr MapTopics::environment(bool symmetry) {
  const std::optional<StoredMap> current = library_.current();
  if (!current || !current->spec) return nullptr;
  PictureSpec spec = *current->spec;
  spec.resolution_m = std::max(spec.resolution_m, kEnvironmentM);
  const std::shared_ptr<const FloorCells> floor = library_.pictures().cells(spec);
  if (!floor) return nullptr;
  const std::string of = current->uid + "/" + std::to_string(current->map_version);
  const std::lock_guard lock(mutex_);
  Made& made = made_[symmetry ? "symmetry" : "match"];
  if (made.picture && made.of == of) return made.picture;
  GrayPicture picture{floor->width, floor->height, std::vector<std::uint8_t>(floor->cells.size(), 0)};
  std::size_t at = 0;
  for (int v = 0; v < floor->height; ++v) {
    const double y = floor->origin_m.y() + (floor->height - v) * floor->resolution_m;
    for (int u = 0; u < floor->width; ++u, ++at) {
      if (floor->cells[at] == FloorCell::Unknown) continue;
      if (symmetry ? floor->cells[at] != FloorCell::Free : floor->cells[at] != FloorCell::Occupied) continue;
      const double x = floor->origin_m.x() + u * floor->resolution_m;
      const auto patch = hashOf(symmetry ? 3 : 4, std::llround(std::floor(x / kPatchM)),
                                std::llround(std::floor(y / kPatchM)));
      // Most of the environment is as it was mapped.
      const double good = unitFrom(patch);
      picture.levels[at] = static_cast<std::uint8_t>(good < 0.2 ? 1 + 250 * good : 200 + 50 * good);
    }
  }
  made = {of, encodeAt({floor->width, floor->height, floor->resolution_m, floor->origin_m}, picture)};
  return made.picture;
}

}  // namespace mapwright::simulator
