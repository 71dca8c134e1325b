// The projected maps of a map dispatcher, as maps of the robot that can be opened, compared and exported.
// Pure. Source: docs/protocols/rep130-map-dispatcher.md, "Projections".
#pragma once

#include <optional>

#include "map/catalogue.h"
#include "robot/map_dispatch.h"
#include "robot/ros/transforms.h"

namespace mapwright::robot::ros {

/// "projected_map_0", whatever its topic is called.
map::MapKey projectedKey(int index);
/// The reverse; nullopt: the key of another map.
std::optional<int> projectedIndex(const map::MapKey& key);

/// Its name includes the heights: "projected_map_0: z 0.10 … 1.80 m".
map::CatalogueEntry entryOf(const ProjectedPart& projected);
/// `in_map`: the pose of its frame in that of the map. It must have at least one cell.
map::WholeMap wholeMapOf(const ProjectedPart& projected, const Transform3& in_map);

}  // namespace mapwright::robot::ros
