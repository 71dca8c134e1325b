#include "map/submap.h"

namespace mapwright::map {

std::string toText(SubmapId id) { return std::to_string(id.trajectory) + "-" + std::to_string(id.index); }

Subject subjectOf(SubmapId id) { return {SubjectKind::Submap, toText(id)}; }

}  // namespace mapwright::map
