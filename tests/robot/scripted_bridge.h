// A rosbridge server for one test: it answers with what it is told to, latches what it is given, and notes
// what it was asked.
#pragma once

#include <functional>

#include <QCborMap>
#include <QCborValue>
#include <QHostAddress>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QList>
#include <QMap>
#include <QSet>
#include <QUrl>
#include <QWebSocket>
#include <QWebSocketServer>

namespace mapwright::robot::testing {

class ScriptedBridge {
 public:
  /// nullopt: no answer. With {"refused": text}: result false.
  using Service = std::function<std::optional<QJsonObject>(const QJsonObject& args)>;

  ScriptedBridge() : server_(QStringLiteral("bridge"), QWebSocketServer::NonSecureMode) {
    listen();
    QObject::connect(&server_, &QWebSocketServer::newConnection, &server_, [this] {
      while (QWebSocket* peer = server_.nextPendingConnection()) {
        peer->setParent(&server_);
        peers.append(peer);
        QObject::connect(peer, &QWebSocket::textMessageReceived, peer, [this, peer](const QString& text) {
          onRequest(*peer, QJsonDocument::fromJson(text.toUtf8()).object());
        });
        QObject::connect(peer, &QWebSocket::disconnected, peer, [this, peer] {
          peers.removeAll(peer);
          for (auto& subscribers : subscribers_) subscribers.remove(peer);
          peer->deleteLater();
        });
      }
    });
    serve(QStringLiteral("/rosapi/topics"), [this](const QJsonObject&) {
      QJsonArray names, types;
      for (auto topic = types_.constBegin(); topic != types_.constEnd(); ++topic) {
        names << topic.key();
        types << topic.value();
      }
      return QJsonObject{{QStringLiteral("topics"), names}, {QStringLiteral("types"), types}};
    });
    serve(QStringLiteral("/rosapi/services"), [this](const QJsonObject&) {
      return QJsonObject{{QStringLiteral("services"), QJsonArray::fromStringList(services_.keys())}};
    });
  }
  ~ScriptedBridge() {
    for (QWebSocket* peer : std::as_const(peers)) peer->disconnect();
  }

  QUrl url() const { return QUrl(QStringLiteral("ws://127.0.0.1:%1").arg(port_)); }
  void listen() {
    server_.listen(QHostAddress::LocalHost, port_);
    port_ = server_.serverPort();
  }
  void goAway() {
    server_.close();
    cut();
  }
  void cut() {
    const auto all = peers;
    for (QWebSocket* peer : all) peer->abort();
  }

  void serve(const QString& service, Service answer) { services_[service] = std::move(answer); }
  void withdraw(const QString& service) { services_.remove(service); }
  /// The server knows the topic.
  void advertise(const QString& topic, const QString& type) { types_[topic] = type; }
  void forget(const QString& topic) { types_.remove(topic); }
  /// Is sent to who has subscribed, and to everyone who does from now on.
  void latch(const QString& topic, const QJsonObject& msg) {
    latched_[topic] = msg;
    send(topic, msg);
  }
  void forgetLatched(const QString& topic) { latched_.remove(topic); }
  /// The same of a message with bytes in it, which JSON has none of.
  void latch(const QString& topic, const QCborMap& msg) {
    frames_[topic] = QCborValue(QCborMap{{QStringLiteral("op"), QStringLiteral("publish")},
                                         {QStringLiteral("topic"), topic},
                                         {QStringLiteral("msg"), msg}})
                         .toCbor();
    for (QWebSocket* peer : subscribers_.value(topic)) peer->sendBinaryMessage(frames_[topic]);
  }
  /// Only to who asks from now on.
  void keep(const QString& topic, const QJsonObject& msg) { latched_[topic] = msg; }
  void send(const QString& topic, const QJsonObject& msg) {
    for (QWebSocket* peer : subscribers_.value(topic)) sendTo(*peer, topic, msg);
  }

  int timesCalled(const QString& service) const { return int(argumentsOf(service).size()); }
  QList<QJsonObject> argumentsOf(const QString& service) const {
    QList<QJsonObject> all;
    for (const QJsonObject& one : asked) {
      if (one[QLatin1String("op")] == QLatin1String("call_service") &&
          one[QLatin1String("service")] == service)
        all << one[QLatin1String("args")].toObject();
    }
    return all;
  }
  /// The last subscription of the topic; empty: none, or it was ended.
  /// The server's own status about what it was asked for.
  void refuse(const QString& topic, const QString& words) {
    const QJsonObject status{{QStringLiteral("op"), QStringLiteral("status")},
                             {QStringLiteral("level"), QStringLiteral("error")},
                             {QStringLiteral("msg"), words},
                             {QStringLiteral("id"), subscriptionOf(topic)[QLatin1String("id")]}};
    for (QWebSocket* peer : peers) write(*peer, status);
  }
  QJsonObject subscriptionOf(const QString& topic) const {
    for (auto one = asked.rbegin(); one != asked.rend(); ++one) {
      if ((*one)[QLatin1String("topic")] != topic) continue;
      const bool on = (*one)[QLatin1String("op")] == QLatin1String("subscribe");
      return on ? *one : QJsonObject();
    }
    return {};
  }
  bool isAskedFor(const char* topic) const { return !subscriptionOf(QLatin1String(topic)).isEmpty(); }

  QList<QJsonObject> asked;          // every operation, those in pieces once they are whole
  int pieces = 0;                    // that came
  std::function<void(int)> atPiece;  // its number within its message
  QList<QWebSocket*> peers;
  bool silent = false;         // no service is answered
  QSet<QString> lost_in_cbor;  // topics that never arrive when they are compressed

 private:
  static void write(QWebSocket& peer, const QJsonObject& object) {
    peer.sendTextMessage(QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact)));
  }
  void sendTo(QWebSocket& peer, const QString& topic, const QJsonObject& msg) {
    const QJsonObject publish{{QStringLiteral("op"), QStringLiteral("publish")},
                              {QStringLiteral("topic"), topic},
                              {QStringLiteral("msg"), msg}};
    if (subscriptionOf(topic)[QLatin1String("compression")] != QLatin1String("cbor"))
      return write(peer, publish);
    if (lost_in_cbor.contains(topic)) return;
    peer.sendBinaryMessage(QCborValue(QCborMap::fromJsonObject(publish)).toCbor());
  }
  void onRequest(QWebSocket& peer, const QJsonObject& asked_now) {
    if (asked_now[QLatin1String("op")] == QLatin1String("fragment")) return join(peer, asked_now);
    asked << asked_now;
    const QString op = asked_now[QLatin1String("op")].toString(),
                  topic = asked_now[QLatin1String("topic")].toString();
    if (op == QLatin1String("subscribe")) {
      subscribers_[topic].insert(&peer);
      if (latched_.contains(topic)) sendTo(peer, topic, latched_[topic]);
      if (frames_.contains(topic)) peer.sendBinaryMessage(frames_[topic]);
    } else if (op == QLatin1String("unsubscribe")) {
      subscribers_[topic].remove(&peer);
    } else if (op == QLatin1String("call_service") && !silent) {
      const QString service = asked_now[QLatin1String("service")].toString();
      QJsonObject answer{{QStringLiteral("op"), QStringLiteral("service_response")},
                         {QStringLiteral("id"), asked_now[QLatin1String("id")]},
                         {QStringLiteral("service"), service}};
      const auto known = services_.constFind(service);
      std::optional<QJsonObject> values;
      if (known == services_.constEnd()) {
        answer[QStringLiteral("values")] = QStringLiteral("Service %1 does not exist").arg(service);
      } else {
        const Service call = *known;
        values = call(asked_now[QLatin1String("args")].toObject());
        if (!values) return;
        const bool refused = values->contains(QLatin1String("refused"));
        answer[QStringLiteral("values")] =
            refused ? (*values)[QLatin1String("refused")] : QJsonValue(*values);
        if (refused) values.reset();
      }
      answer[QStringLiteral("result")] = values.has_value();
      write(peer, answer);
    }
  }

  void join(QWebSocket& peer, const QJsonObject& piece) {
    ++pieces;
    const int number = piece[QLatin1String("num")].toInt();
    QMap<int, QString>& held = held_[piece[QLatin1String("id")].toString()];
    held[number] = piece[QLatin1String("data")].toString();
    const bool whole = held.size() == piece[QLatin1String("total")].toInt();
    const QString text = whole ? QStringList(held.values()).join(QString()) : QString();
    if (whole) held_.remove(piece[QLatin1String("id")].toString());
    if (atPiece) atPiece(number);
    if (whole) onRequest(peer, QJsonDocument::fromJson(text.toUtf8()).object());
  }

  QMap<QString, QMap<int, QString>> held_;
  QMap<QString, QByteArray> frames_;  // latched
  QWebSocketServer server_;
  quint16 port_ = 0;
  QMap<QString, Service> services_;
  QMap<QString, QString> types_;
  QMap<QString, QJsonObject> latched_;
  QMap<QString, QSet<QWebSocket*>> subscribers_;
};

}  // namespace mapwright::robot::testing
