// What became of an HTTP request, in the words of the port. Pure.
#pragma once

#include "map/failure.h"
#include "net/http_client.h"
#include "robot/robot.h"

namespace mapwright::robot::wire {

inline std::string_view view(const QByteArray& bytes) {
  return {bytes.constData(), std::size_t(bytes.size())};
}

/// None for a 2xx; 401 and 403 are refusals like those of the link itself.
map::FailureKind failureOf(const net::HttpAnswer& answer);

/// Whether a request that was to change something did so, as far as its answer tells.
map::Applied appliedOf(const net::HttpAnswer& answer);

/// The request for `subject` that ended in `answer`, which is no 2xx.
map::Failure failed(const net::HttpAnswer& answer, map::Subject subject,
                    map::AskedFor asked_for = map::AskedFor::All);
/// The answer came (2xx) and cannot be read; `cause` is what is wrong with it.
map::Failure misread(const net::HttpAnswer& answer, map::Subject subject, Fault cause,
                     map::FailureReason reason = map::FailureReason::Told,
                     map::AskedFor asked_for = map::AskedFor::All);
/// Of an answer that came (2xx) but cannot be read: a web page is not what a robot sends.
map::FailureKind unreadable(const net::HttpAnswer& answer);

/// The same certificate in the words of the port.
UntrustedCertificate untrusted(const net::CertificateFault& fault);
/// It answers, and knows no such place or not this use of it.
inline bool isUnknownThere(const net::HttpAnswer& answer) {
  return answer.kind == net::HttpAnswer::Kind::Answered && (answer.status == 404 || answer.status == 405);
}

}  // namespace mapwright::robot::wire
