#include "robot/aimdk/aimdk_probe.h"

#include <utility>

#include "net/http_client.h"
#include "robot/aimdk/aimdk_address.h"
#include "robot/aimdk/faults.h"
#include "robot/aimdk/parse_rpc.h"
#include "robot/wire/net_results.h"

namespace mapwright::robot::aimdk {
namespace {

constexpr qint64 kLongestAnswer = qint64(4) << 20;

ProbeAnswer answerOf(const QUrl& server, const net::HttpAnswer& answer) {
  if (answer.ok()) {
    // An error in JSON may be anybody's.
    if (parseMapNames(wire::view(answer.body)))
      return {{{.address = addressScheme().prefix + server.toString()}}, {}};
    return {{}, {faultText("aimdk", "a web server answers there, but it is no Agibot robot")}, true};
  }
  if (answer.kind == net::HttpAnswer::Kind::Answered)
    return {{}, {fault::NoAgibotRobotThere, {}, {answer.reason}}, true};
  return {{}, answer.reason};
}

Probe probeOf(const QUrl& server) {
  const auto ask = [server](QObject* owner, std::chrono::milliseconds within, Probe::Reply reply) {
    auto* const http = new net::HttpClient(server, QByteArray(), nullptr, owner);
    net::HttpRequest request;
    request.method = net::HttpMethod::Post;  // reads all the same
    request.url = server;
    request.url.setPath(QStringLiteral("/rpc/aimdk.protocol.MappingService/GetStoredMapNames"));
    request.body = mapNamesRequest();
    request.timeout = within;
    request.max_bytes = kLongestAnswer;
    http->send(request, [http, server, reply = std::move(reply)](const net::HttpAnswer& answer) {
      http->deleteLater();
      reply(answerOf(server, answer));
    });
  };
  return {addressScheme().title, server, ask};
}

}  // namespace

std::vector<Probe> probesOf(const Host& host) {
  return {probeOf(serverAt(QStringLiteral("http"), host, addressScheme().port)),
          probeOf(serverAt(QStringLiteral("https"), host, addressScheme().port))};
}

}  // namespace mapwright::robot::aimdk
