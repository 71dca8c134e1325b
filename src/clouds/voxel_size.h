// Detects the cell size of an occupancy cloud from the distances between its points. Pure.
#pragma once

#include "clouds/cloud_tree.h"

namespace mapwright::clouds {

/// The cell edge in metres; 0 = it does not look like cells of one size. With mixed sizes (an octree), the
/// smallest frequent one.
double voxelSize(const CloudTree& tree);

}  // namespace mapwright::clouds
