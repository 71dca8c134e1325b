// HTTP connections: handle requests until the connection closes or becomes a WebSocket.
#pragma once

#include "simulator/loop.h"
#include "simulator/services.h"

namespace mapwright::simulator {

/// On the loop's thread.
void serveHttp(Connection& connection, const Services& services);

}  // namespace mapwright::simulator
