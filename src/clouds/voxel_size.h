// How large the cells of an occupancy cloud are, told by how far its points lie apart. Pure.
#pragma once

#include "clouds/cloud_tree.h"

namespace mapwright::clouds {

/// The edge of its cells, metres; 0 = it does not look like cells of one size. Where cells of several sizes
/// are mixed (an octree), it is that of the smallest that come often.
double voxelSize(const CloudTree& tree);

}  // namespace mapwright::clouds
