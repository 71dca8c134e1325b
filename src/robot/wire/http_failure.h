// Results of HTTP requests as failures of the port. Pure.
#pragma once

#include "map/failure.h"
#include "net/http_client.h"
#include "robot/robot.h"

namespace mapwright::robot::wire {

inline std::string_view view(const QByteArray& bytes) {
  return {bytes.constData(), std::size_t(bytes.size())};
}

/// None for a 2xx; 401 and 403 count as refused, like on the connection itself.
map::FailureKind failureOf(const net::HttpAnswer& answer);

/// Whether a changing request took effect, as far as its answer tells.
map::Applied appliedOf(const net::HttpAnswer& answer);

/// The failure for `subject` after `answer`, which is not a 2xx.
map::Failure failed(const net::HttpAnswer& answer, map::Subject subject,
                    map::AskedFor asked_for = map::AskedFor::All);
/// The answer (2xx) cannot be parsed; `cause` is the reason.
map::Failure misread(const net::HttpAnswer& answer, map::Subject subject, Fault cause,
                     map::FailureReason reason = map::FailureReason::Told,
                     map::AskedFor asked_for = map::AskedFor::All);
/// For an answer (2xx) that cannot be parsed: a web page does not come from a robot.
map::FailureKind unreadable(const net::HttpAnswer& answer);

/// The same certificate as a value of the port.
UntrustedCertificate untrusted(const net::CertificateFault& fault);
/// The server answers, but does not know this path or method.
inline bool isUnknownThere(const net::HttpAnswer& answer) {
  return answer.kind == net::HttpAnswer::Kind::Answered && (answer.status == 404 || answer.status == 405);
}

}  // namespace mapwright::robot::wire
