// Further failures of changes to a map manager's data. Private to this room.
#pragma once

#include <chrono>

#include "map/failure.h"

namespace mapwright::robot::ros {

/// The robot reported success but does not show the change.
map::Failure unconfirmed(map::Subject subject, std::chrono::milliseconds within);
/// The change was sent; whether it was made is unknown.
map::Failure cancelled(map::Subject subject);

}  // namespace mapwright::robot::ros
