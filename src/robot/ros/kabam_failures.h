// How a change of what a map manager keeps may end besides. Private to this room.
#pragma once

#include <chrono>

#include "map/failure.h"

namespace mapwright::robot::ros {

/// The robot said that it was done, and does not show it.
map::Failure unconfirmed(map::Subject subject, std::chrono::milliseconds within);
/// The change went out; whether it was made is not known.
map::Failure cancelled(map::Subject subject);

}  // namespace mapwright::robot::ros
