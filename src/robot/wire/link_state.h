// How a WebSocket to a robot stands, in the words of the port. Pure.
#pragma once

#include "net/web_socket_link.h"
#include "robot/robot.h"

namespace mapwright::robot::wire {

/// What a link that does not work is a case of; None of one that does.
map::FailureKind failureOf(net::WebSocketLink::Failure fault);

/// `wanted`: somebody has asked to be connected, so a closed link is one that was refused.
ConnectionState stateOf(const net::WebSocketLink& link, bool wanted);

}  // namespace mapwright::robot::wire
