#include "map/submap.h"

namespace mapwright::map {

std::string toText(SubmapId id) { return std::to_string(id.trajectory) + "-" + std::to_string(id.index); }

}  // namespace mapwright::map
