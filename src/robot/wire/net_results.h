// Requests over HTTP and the state of a WebSocket, as values of the port.
#pragma once

#include <string_view>
#include <type_traits>

#include "map/failure.h"
#include "net/http_client.h"
#include "net/web_socket_link.h"
#include "robot/robot.h"
#include "robot/wire/task.h"

namespace mapwright::robot::wire {

inline std::string_view view(const QByteArray& bytes) {
  return {bytes.constData(), std::size_t(bytes.size())};
}

/// Sends `request` for `task`; if that is cancelled, the reply is net::HttpAnswer::Kind::Cancelled. `http`
/// outlives the request. `tells`: its progress is that of the task.
void send(const TaskPtr& task, net::HttpClient& http, net::HttpRequest request, net::HttpClient::Reply reply,
          bool tells = false);

/// None for a 2xx; 401 and 403 count as refused, like on the connection itself.
map::FailureKind failureOf(const net::HttpAnswer& answer);
/// The failure for `subject` after `answer`, which is not a 2xx. For a change it says whether it took effect,
/// as far as the answer tells.
map::Failure failed(const net::HttpAnswer& answer, map::Subject subject,
                    map::AskedFor asked_for = map::AskedFor::All);
/// The answer (2xx) cannot be parsed; `cause` is the reason. A web page does not come from a robot.
map::Failure misread(const net::HttpAnswer& answer, map::Subject subject, Fault cause,
                     map::FailureReason reason = map::FailureReason::Told);

/// The result of `parse` for a 2xx, or the failure of `subject`.
template <typename Parse>
auto outcomeOf(const net::HttpAnswer& answer, const map::Subject& subject, Parse parse,
               map::FailureReason reason = map::FailureReason::Told)
    -> Outcome<typename std::invoke_result_t<Parse, std::string_view>::value_type> {
  if (!answer.ok()) return fail(failed(answer, subject));
  auto parsed = parse(view(answer.body));
  if (!parsed) return fail(misread(answer, subject, std::move(parsed.error()), reason));
  return std::move(*parsed);
}

/// The same certificate as a value of the port.
UntrustedCertificate untrusted(const net::CertificateFault& fault);
/// The server answers, but does not know this path or method.
inline bool isUnknownThere(const net::HttpAnswer& answer) {
  return answer.kind == net::HttpAnswer::Kind::Answered && (answer.status == 404 || answer.status == 405);
}

/// The state of a WebSocket to a robot. `wanted`: a connection was requested, so a closed link means that it
/// was refused.
ConnectionState stateOf(const net::WebSocketLink& link, bool wanted);

}  // namespace mapwright::robot::wire
