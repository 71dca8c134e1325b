// The reducer (map/world.h) where the world lies: whoever folds many messages, and needs no world in between,
// moves none. Makes exactly what map::reduce() makes.
#pragma once

#include "map/world.h"

namespace mapwright::map {

/// `world` becomes what it is after `message`, which came at `at_s` (seconds since the epoch).
void reduceInto(World& world, const TopicMessage& message, double at_s);

/// The same for what is no list of submaps.
void reduceInto(LiveState& state, const TopicMessage& message, double at_s);

}  // namespace mapwright::map
