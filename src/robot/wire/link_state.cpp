#include "robot/wire/link_state.h"

#include "robot/wire/http_failure.h"
#include "robot/wire/net_reason.h"

namespace mapwright::robot::wire {

map::FailureKind failureOf(net::WebSocketLink::Fault fault) {
  using Fault = net::WebSocketLink::Fault;
  switch (fault) {
    case Fault::None:
      break;
    case Fault::Unreachable:
      return map::FailureKind::Unreachable;
    case Fault::TimedOut:
      return map::FailureKind::TimedOut;
    case Fault::Refused:
      return map::FailureKind::Refused;
    case Fault::NotAWebSocket:
      return map::FailureKind::NotARobot;
    case Fault::Certificate:
      return map::FailureKind::Certificate;
  }
  return map::FailureKind::None;
}

ConnectionState stateOf(const net::WebSocketLink& link, bool wanted) {
  using State = net::WebSocketLink::State;
  ConnectionState state;
  state.reason = reasonOf(link.reason());
  state.failure = failureOf(link.fault());
  if (const auto fault = link.certificate()) state.certificate = untrusted(*fault);
  state.attempt = link.attempt();
  state.retry_in_ms = link.retryInMs();
  state.round_trip_ms = link.roundTripMs();
  switch (link.state()) {
    case State::Open:
      state.phase = ConnectionPhase::Online;
      state.reason = {};
      state.failure = map::FailureKind::None;
      break;
    case State::Connecting:
      state.phase = state.attempt <= 1 ? ConnectionPhase::Connecting : ConnectionPhase::Interrupted;
      break;
    case State::Waiting:
      state.phase = ConnectionPhase::Interrupted;
      break;
    case State::Closed:
      state.phase = wanted ? ConnectionPhase::Refused : ConnectionPhase::Offline;
      if (!wanted) state.reason = {};
      if (wanted && (link.handshakeStatus() == 401 || link.handshakeStatus() == 403))
        state.failure = map::FailureKind::Refused;
      break;
  }
  return state;
}

}  // namespace mapwright::robot::wire
