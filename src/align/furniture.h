// Two floors of one building can have the same walls. What stands in their rooms tells them apart. Pure
// functions.
#pragma once

#include "align/align.h"
#include "align/plan.h"
#include "geometry/pose.h"

namespace mapwright::align {

Furniture furnitureOf(const Plan& old_map, const Plan& new_map, const geometry::Pose2& pose);

}  // namespace mapwright::align
