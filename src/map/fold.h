// The reducer (map/world.h) in place: folds many messages without copying the world for each. The result is
// exactly that of map::reduce().
#pragma once

#include "map/world.h"

namespace mapwright::map {

/// Updates `world` with `message`, which arrived at `at_s` (seconds since the epoch).
void reduceInto(World& world, const TopicMessage& message, double at_s);

/// The same for messages other than submap lists.
void reduceInto(LiveState& state, const TopicMessage& message, double at_s);

}  // namespace mapwright::map
