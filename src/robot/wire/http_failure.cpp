#include "robot/wire/http_failure.h"

namespace mapwright::robot::wire {

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

map::Applied appliedOf(const net::HttpAnswer& answer) {
  using map::Applied;
  if (!answer.sent) return Applied::No;
  if (answer.status == 0) return Applied::Maybe;
  if (answer.status >= 200 && answer.status < 300) return Applied::Yes;  // even if the body broke off
  // A redirecting server has not done it itself.
  if (answer.status == 307 || answer.status == 308) return Applied::No;
  return answer.status >= 400 && answer.status < 500 ? Applied::No : Applied::Maybe;
}

map::Failure failed(const net::HttpAnswer& answer, map::Subject subject, map::AskedFor asked_for) {
  map::Failure failure;
  failure.kind = failureOf(answer);
  failure.subject = std::move(subject);
  failure.asked_for = asked_for;
  if (asked_for == map::AskedFor::Change) failure.applied = appliedOf(answer);
  const bool answered = answer.kind == net::HttpAnswer::Kind::Answered;
  if (answered) failure.robot_code = std::to_string(answer.status);
  if (answered && answer.status == 409) failure.kind = map::FailureKind::Conflict;
  if (answered) {
    failure.detail = answer.said.toStdString();
  } else if (failure.kind != map::FailureKind::Cancelled) {
    failure.cause = answer.reason;
  }
  return failure;
}

map::Failure misread(const net::HttpAnswer& answer, map::Subject subject, Fault cause,
                     map::FailureReason reason, map::AskedFor asked_for) {
  map::Failure failure;
  failure.kind = unreadable(answer);
  failure.subject = std::move(subject);
  failure.asked_for = asked_for;
  if (asked_for == map::AskedFor::Change) failure.applied = map::Applied::Yes;
  failure.cause = std::move(cause);
  failure.reason = reason;
  return failure;
}

map::FailureKind unreadable(const net::HttpAnswer& answer) {
  const bool page = answer.content_type.startsWith("text/html") || answer.body.trimmed().startsWith('<');
  return page ? map::FailureKind::NotARobot : map::FailureKind::MalformedAnswer;
}

UntrustedCertificate untrusted(const net::CertificateFault& fault) {
  UntrustedCertificate certificate;
  certificate.host = fault.host;
  for (const Fault& why : fault.whys) certificate.why.push_back(why);
  certificate.sha256 = net::fingerprintText(fault.sha256);
  certificate.pinned_sha256 = net::fingerprintText(fault.pinned_sha256);
  certificate.subject = fault.subject;
  certificate.issuer = fault.issuer;
  certificate.from = fault.from;
  certificate.until = fault.until;
  certificate.trustable = fault.trustable();
  return certificate;
}

}  // namespace mapwright::robot::wire
