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

map::FailureKind unreadable(const net::HttpAnswer& answer) {
  const bool page = answer.content_type.startsWith("text/html") || answer.body.trimmed().startsWith('<');
  return page ? map::FailureKind::NotARobot : map::FailureKind::MalformedAnswer;
}

UntrustedCertificate untrusted(const net::CertificateFault& fault) {
  UntrustedCertificate certificate;
  certificate.host = fault.host;
  certificate.why = fault.why;
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
