#include "robot/wire/net_results.h"

namespace mapwright::robot::wire {
namespace {

/// Whether a changing request took effect, as far as its answer tells.
map::Applied appliedOf(const net::HttpAnswer& answer) {
  using map::Applied;
  if (!answer.sent) return Applied::No;
  if (answer.status == 0) return Applied::Maybe;
  if (answer.status >= 200 && answer.status < 300) return Applied::Yes;  // even if the body broke off
  // A redirecting server has not done it itself.
  if (answer.status == 307 || answer.status == 308) return Applied::No;
  return answer.status >= 400 && answer.status < 500 ? Applied::No : Applied::Maybe;
}

map::FailureKind failureOf(net::WebSocketLink::Failure failure) {
  using Failure = net::WebSocketLink::Failure;
  switch (failure) {
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

}  // namespace

void send(const TaskPtr& task, net::HttpClient& http, net::HttpRequest request, net::HttpClient::Reply reply,
          bool tells) {
  if (tells) {
    request.progress = [task](const net::HttpProgress& progress) {
      task->reportProgress({progress.bytes, progress.of_bytes});
    };
  }
  const auto number = std::make_shared<int>(0);
  const auto id = http.send(request, [task, number, reply = std::move(reply)](net::HttpAnswer answer) {
    task->ended(*number);
    reply(std::move(answer));
  });
  *number = task->begun([&http, id] { http.cancel(id); });
}

map::FailureKind failureOf(const net::HttpAnswer& answer) {
  using Kind = net::HttpAnswer::Kind;
  using map::FailureKind;
  switch (answer.kind) {
    case Kind::Answered:
      if (answer.ok()) return FailureKind::None;
      return answer.status == 401 || answer.status == 403 ? FailureKind::Refused
                                                          : FailureKind::RejectedByRobot;
    case Kind::Unreachable:
      return FailureKind::Unreachable;
    case Kind::TimedOut:
      return FailureKind::TimedOut;
    case Kind::TooLarge:
    case Kind::Refused:  // by the client: the answer leads where it must not
      return FailureKind::MalformedAnswer;
    case Kind::Certificate:
      return FailureKind::Certificate;
    case Kind::Cancelled:
      break;
  }
  return FailureKind::Cancelled;
}

map::Failure failed(const net::HttpAnswer& answer, map::Subject subject, map::AskedFor asked_for) {
  map::Failure failure;
  failure.kind = failureOf(answer);
  failure.subject = std::move(subject);
  failure.asked_for = asked_for;
  if (map::changes(asked_for)) failure.applied = appliedOf(answer);
  if (answer.kind == net::HttpAnswer::Kind::Answered) {
    failure.robot_code = std::to_string(answer.status);
    if (answer.status == 409) failure.kind = map::FailureKind::Conflict;
    failure.detail = answer.said.toStdString();
  } else if (failure.kind != map::FailureKind::Cancelled) {
    failure.cause = answer.reason;
  }
  return failure;
}

map::Failure misread(const net::HttpAnswer& answer, map::Subject subject, Fault cause,
                     map::FailureReason reason) {
  const bool page = answer.content_type.startsWith("text/html") || answer.body.trimmed().startsWith('<');
  return {.kind = page ? map::FailureKind::NotARobot : map::FailureKind::MalformedAnswer,
          .subject = std::move(subject),
          .reason = reason,
          .cause = std::move(cause)};
}

UntrustedCertificate untrusted(const net::CertificateFault& fault) {
  return {.host = fault.host,
          .why = fault.whys,
          .sha256 = net::fingerprintText(fault.sha256),
          .pinned_sha256 = net::fingerprintText(fault.pinned_sha256),
          .subject = fault.subject,
          .issuer = fault.issuer,
          .from = fault.from,
          .until = fault.until,
          .trustable = fault.trustable()};
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
      break;
  }
  return state;
}

}  // namespace mapwright::robot::wire
