#include "robot/wire/link_state.h"

#include "robot/wire/http_failure.h"

namespace mapwright::robot::wire {

map::FailureKind failureOf(net::WebSocketLink::Failure fault) {
  using Failure = net::WebSocketLink::Failure;
  switch (fault) {
    case Failure::None:
      break;
    case Failure::Unreachable:
      return map::FailureKind::Unreachable;
    case Failure::TimedOut:
      return map::FailureKind::TimedOut;
    case Failure::Refused:
      return map::FailureKind::Refused;
    case Failure::NotAWebSocket:
      return map::FailureKind::NotARobot;
    case Failure::Certificate:
      return map::FailureKind::Certificate;
  }
  return map::FailureKind::None;
}

ConnectionState stateOf(const net::WebSocketLink& link, bool wanted) {
  using State = net::WebSocketLink::State;
  ConnectionState state;
  state.reason = link.reason();
  state.failure = failureOf(link.failure());
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
