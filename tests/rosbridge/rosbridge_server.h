// A server of rosbridge for one test: it notes what every client sends and says what the test tells it to.
#pragma once

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>
#include <QWebSocket>
#include <QWebSocketServer>

#include "net/rosbridge/client.h"

namespace mapwright::net::rosbridge::testing {

struct Seen {
  int peer = 0;  // in the order of their coming
  QJsonObject request;
  QByteArray text;
  QString operator[](const char* name) const { return request[QLatin1String(name)].toVariant().toString(); }
};

class RosbridgeServer {
 public:
  explicit RosbridgeServer(quint16 port = 0)
      : server_(QStringLiteral("rosbridge"), QWebSocketServer::NonSecureMode) {
    server_.listen(QHostAddress::LocalHost, port);
    QObject::connect(&server_, &QWebSocketServer::newConnection, &server_, [this] {
      while (QWebSocket* peer = server_.nextPendingConnection()) {
        peer->setParent(&server_);
        const int number = int(peers.size());
        peers.append(peer);
        if (arrived) arrived(number);
        QObject::connect(peer, &QWebSocket::textMessageReceived, peer, [this, number](const QString& text) {
          seen.append({number, QJsonDocument::fromJson(text.toUtf8()).object(), text.toUtf8()});
          if (answer) answer(seen.last());
        });
      }
    });
  }

  QUrl url() const { return QUrl(QStringLiteral("ws://127.0.0.1:%1").arg(server_.serverPort())); }
  quint16 port() const { return server_.serverPort(); }

  void say(const QByteArray& text, int peer = -1) { at(peer)->sendTextMessage(QString::fromUtf8(text)); }
  void sayBytes(const QByteArray& bytes, int peer = -1) { at(peer)->sendBinaryMessage(bytes); }
  /// {"op":"service_response","id":…,"values":…,"result":…}
  void reply(const Seen& call, const QByteArray& values, const QByteArray& result = "true") {
    say("{\"op\":\"service_response\",\"id\":\"" + call["id"].toUtf8() + "\",\"values\":" + values +
            ",\"result\":" + result + "}",
        call.peer);
  }
  /// All that has been said to the peer has arrived there, and what it sent before that has arrived here: a
  /// WebSocket keeps the order, and answers a ping in its turn.
  bool settled(int peer = -1) {
    QWebSocket* const socket = at(peer);
    bool answered = false;
    const auto connection =
        QObject::connect(socket, &QWebSocket::pong, socket, [&](quint64, const QByteArray& payload) {
          if (payload == "settled") answered = true;
        });
    socket->ping("settled");
    const bool in_time = QTest::qWaitFor([&] { return answered; }, 30'000);
    QObject::disconnect(connection);
    return in_time;
  }
  /// As a server that dies: no farewell, code 1006.
  void dropAll() {
    for (const QPointer<QWebSocket>& peer : peers) {
      if (peer) peer->abort();
    }
  }
  QList<Seen> all(const char* operation) const {
    QList<Seen> found;
    for (const Seen& one : seen) {
      if (one["op"] == QLatin1String(operation)) found << one;
    }
    return found;
  }

  QList<Seen> seen;
  QList<QPointer<QWebSocket>> peers;
  std::function<void(const Seen&)> answer;
  std::function<void(int)> arrived;  // a peer

 private:
  QWebSocket* at(int peer) { return peers.at(peer < 0 ? peers.size() - 1 : peer); }

  QWebSocketServer server_;
};

/// A clock that stands until the test moves it.
struct StandingClock {
  std::shared_ptr<std::chrono::milliseconds> time = std::make_shared<std::chrono::milliseconds>(1'000'000);
  void pass(std::chrono::milliseconds by) { *time += by; }
  /// Who goes by it has looked at it, and done what was due: the second look begins when the first is over.
  bool seen() const {
    const int before = *looks;
    return QTest::qWaitFor([&] { return *looks >= before + 2; }, 30'000);
  }
  std::shared_ptr<int> looks = std::make_shared<int>(0);
};

inline ClientOptions quick(const StandingClock& clock = {}) {
  ClientOptions options;
  options.link.ping_every = std::chrono::milliseconds(20);
  options.link.look_every = std::chrono::milliseconds(5);
  options.link.silent_after = std::chrono::milliseconds(30'000);
  options.link.backoff_first = std::chrono::milliseconds(5);
  options.link.backoff_limit = std::chrono::milliseconds(20);
  options.link.jitter_seed = 1;
  options.look_every = std::chrono::milliseconds(2);
  options.now = [time = clock.time, looks = clock.looks] {
    ++*looks;
    return *time;
  };
  options.wall_s = [] { return 1'700'000'000.5; };
  return options;
}

/// What came back of calls, in order.
struct Replies {
  QList<CallAnswer> all;
  rosbridge::Reply collect() {
    return [this](const CallAnswer& answer) { all.append(answer); };
  }
};

inline CallRequest request(const std::string& service, const QByteArray& args = "{}") {
  CallRequest made;
  made.service = service;
  made.args = args;
  return made;
}

}  // namespace mapwright::net::rosbridge::testing
