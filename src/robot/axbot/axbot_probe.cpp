#include "robot/axbot/axbot_probe.h"

#include <utility>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "net/http_client.h"
#include "robot/axbot/axbot_address.h"
#include "robot/axbot/device_info.h"
#include "robot/axbot/faults.h"
#include "robot/axbot/robot_urls.h"

namespace mapwright::robot::axbot {
namespace {

constexpr qint64 kLongestAnswer = qint64(4) << 20;

/// {"detail": …}, {"message": …}, {"error": …}: robots explain refusals, other servers send web pages.
bool explainsItself(const QByteArray& body) {
  const QJsonObject said = QJsonDocument::fromJson(body).object();
  return said.contains(QLatin1String("detail")) || said.contains(QLatin1String("message")) ||
         said.contains(QLatin1String("error"));
}

bool listsMaps(const QByteArray& body) {
  const QJsonArray maps = QJsonDocument::fromJson(body).array();
  return !maps.isEmpty() && maps.first().toObject().contains(QLatin1String("map_name"));
}

/// One server that is asked. Destroyed with its owner, or when it has answered.
class Asking : public QObject {
 public:
  Asking(QObject* owner, QUrl server, std::chrono::milliseconds within, Probe::Reply reply)
      : QObject(owner),
        server_(std::move(server)),
        within_(within),
        reply_(std::move(reply)),
        http_(server_, QByteArray(), nullptr) {}

  void start() {
    get(QStringLiteral("/device/info"), [this](const net::HttpAnswer& answer) {
      const DeviceInfo info = answer.ok() ? deviceInfoIn(answer.body) : DeviceInfo();
      if (info.surely) return found(info.identity);
      // Old firmware does not know this request.
      if (answer.kind == net::HttpAnswer::Kind::Answered && (answer.status == 404 || answer.ok()))
        return askForMaps();
      conclude(answer);
    });
  }

 private:
  void get(const QString& path, net::HttpClient::Reply reply) {
    net::HttpRequest request;
    request.url = urlOnRobot(server_, path);
    request.timeout = within_;
    request.max_bytes = kLongestAnswer;
    http_.send(request, std::move(reply));
  }
  void askForMaps() {
    get(QStringLiteral("/maps/"), [this](const net::HttpAnswer& answer) {
      if (answer.ok() && listsMaps(answer.body)) return found({});
      conclude(answer);
    });
  }
  void found(const RobotIdentity& identity) { end({{{.address = address(), .identity = identity}}, {}}); }
  void conclude(const net::HttpAnswer& answer) {
    const bool refused = answer.status == 401 || answer.status == 403;
    if (refused && explainsItself(answer.body))
      return end({{{.address = address(), .wants_secret = true}}, {}});
    if (answer.ok())
      return end({{}, {faultText("axbot", "a web server answers there, but it is no Autoxing robot")}, true});
    if (answer.kind == net::HttpAnswer::Kind::Answered)
      return end({{},
                  {faultText("axbot", "a web server answers there, but not as an Autoxing robot does: %1"),
                   {},
                   {answer.reason}},
                  true});
    end({{}, answer.reason});
  }
  QString address() const { return addressScheme().prefix + server_.toString(); }
  void end(ProbeAnswer answer) {
    deleteLater();
    std::exchange(reply_, nullptr)(std::move(answer));
  }

  QUrl server_;
  std::chrono::milliseconds within_;
  Probe::Reply reply_;
  net::HttpClient http_;
};

Probe probeOf(const QUrl& server) {
  return {addressScheme().title, server,
          [server](QObject* owner, std::chrono::milliseconds within, Probe::Reply reply) {
            (new Asking(owner, server, within, std::move(reply)))->start();
          }};
}

}  // namespace

std::vector<Probe> probesOf(const Host& host) {
  const QString plain = QStringLiteral("http"), encrypted = QStringLiteral("https");
  std::vector<Probe> probes{probeOf(serverAt(plain, host, addressScheme().port))};
  if (!host.port) probes.push_back(probeOf(serverAt(plain, host, 80)));
  probes.push_back(probeOf(serverAt(encrypted, host, 443)));
  return probes;
}

}  // namespace mapwright::robot::axbot
