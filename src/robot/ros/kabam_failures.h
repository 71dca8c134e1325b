// Further failures of changes to a map manager's data. Private to this room.
#pragma once

#include <chrono>

#include "map/failure.h"

namespace mapwright::robot::ros {

/// No answer can be had; `cause` says why, if there is more to be said of it.
map::Failure unsupported(map::Subject subject, Fault cause = {});
/// The robot said that it was done, and does not show it.
map::Failure unconfirmed(map::Subject subject, std::chrono::milliseconds within);
/// The change was sent; whether it was made is unknown.
map::Failure cancelled(map::Subject subject);

}  // namespace mapwright::robot::ros
