// What the network found to be wrong, as a reason of the port. Pure.
#pragma once

#include "map/reason.h"
#include "net/reason.h"

namespace mapwright::robot::wire {

map::Reason reasonOf(const net::Reason& reason);

}  // namespace mapwright::robot::wire
