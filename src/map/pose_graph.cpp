#include "map/pose_graph.h"

namespace mapwright::map {

std::string toText(NodeId id) { return std::to_string(id.trajectory) + "-" + std::to_string(id.index); }

}  // namespace mapwright::map
