// What of a cloud lies in the region that was asked for: what came is placed by itself, and may be more, or
// another part of the map. Pure: any thread.
#pragma once

#include <cstdint>
#include <memory>

#include "map/map_part.h"

namespace mapwright::clouds {

struct CroppedCloud {
  std::shared_ptr<const map::SpatialCloud> cloud;  // the same one where nothing lies beyond
  std::uint64_t beyond = 0;                        // points that were left out
};

CroppedCloud cropped(std::shared_ptr<const map::SpatialCloud> cloud, const map::CloudRegion& region);

}  // namespace mapwright::clouds
