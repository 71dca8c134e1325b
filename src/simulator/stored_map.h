// A map that the simulated robot keeps.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "simulator/map_pictures.h"

namespace mapwright::simulator {

/// A value; what is large in it is shared and never changes.
struct StoredMap {
  int id = 0;  // -1: set as the current map from data, not kept
  std::string uid, name;
  std::int64_t created_s = 0, modified_s = 0;  // epoch
  int map_version = 1, overlays_version = 1;
  std::shared_ptr<const std::string> overlays;   // GeoJSON as it was written, byte for byte; may be empty
  std::optional<PictureSpec> spec;               // drawn from the building,
  MapPicturePtr picture, thumbnail;              // or handed in
  std::shared_ptr<const std::string> carto_map;  // what the robot positions itself by
};

}  // namespace mapwright::simulator
