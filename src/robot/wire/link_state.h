// The state of a WebSocket to a robot as a value of the port. Pure.
#pragma once

#include "net/web_socket_link.h"
#include "robot/robot.h"

namespace mapwright::robot::wire {

/// The failure kind of a broken connection; None if it works.
map::FailureKind failureOf(net::WebSocketLink::Failure fault);

/// `wanted`: a connection was requested, so a closed link means that it was refused.
ConnectionState stateOf(const net::WebSocketLink& link, bool wanted);

}  // namespace mapwright::robot::wire
