// Crops a cloud to the requested region: the answer has a position of its own and may cover more, or another
// part of the map. Pure: any thread.
#pragma once

#include <cstdint>
#include <memory>

#include "map/map_part.h"

namespace mapwright::clouds {

struct CroppedCloud {
  std::shared_ptr<const map::SpatialCloud> cloud;  // the same object if nothing lies outside
  std::uint64_t beyond = 0;                        // points that were left out
};

CroppedCloud cropped(std::shared_ptr<const map::SpatialCloud> cloud, const map::CloudRegion& region);

}  // namespace mapwright::clouds
