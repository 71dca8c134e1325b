// A client of the simulated rosbridge server that keeps what it is sent. Knows nothing of the program's own
// client.
#pragma once

#include <memory>
#include <tuple>

#include <QByteArrayList>
#include <QCborMap>
#include <QCborValue>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>
#include <QTest>
#include <QUrl>
#include <QWebSocket>

#include "simulator/simulator.h"

class RosSocket {
 public:
  explicit RosSocket(int port) {
    QObject::connect(&socket, &QWebSocket::textMessageReceived, &socket, [this](const QString& text) {
      texts.append(text);
      const QJsonObject message = QJsonDocument::fromJson(text.toUtf8()).object();
      const QString op = message[QLatin1String("op")].toString();
      if (op == QLatin1String("service_response")) answers.append(message);
      if (op == QLatin1String("status")) statuses.append(message);
      if (op == QLatin1String("publish"))
        topics[name(message)].append(message[QLatin1String("msg")].toObject());
      order.append(op == QLatin1String("publish") ? name(message) : op);
    });
    QObject::connect(&socket, &QWebSocket::binaryMessageReceived, &socket,
                     [this](const QByteArray& bytes) { binaries.append(bytes); });
    socket.open(QUrl(QStringLiteral("ws://127.0.0.1:%1/").arg(port)));
    std::ignore = QTest::qWaitFor([this] { return isOpen(); }, 30'000);
  }

  bool isOpen() const { return socket.state() == QAbstractSocket::ConnectedState; }
  void send(const QByteArray& json) { socket.sendTextMessage(QString::fromUtf8(json)); }
  void subscribe(const QByteArray& topic, const QByteArray& more = {}) {
    send(R"({"op":"subscribe","topic":")" + topic + '"' + more + '}');
  }
  /// The first message that comes, or has come; empty when none does.
  QJsonObject first(const char* topic) {
    std::ignore = QTest::qWaitFor([&] { return count(topic) > 0; }, 30'000);
    return topics.value(QLatin1String(topic)).value(0);
  }
  QJsonObject last(const char* topic) const {
    return topics.value(QLatin1String(topic)).value(count(topic) - 1);
  }
  qsizetype count(const char* topic) const { return topics.value(QLatin1String(topic)).size(); }

  /// The whole answer; empty when none comes.
  QJsonObject ask(const QByteArray& service, const QByteArray& args = "{}") {
    const QString id = QStringLiteral("call%1").arg(++asked);
    send(R"({"op":"call_service","id":")" + id.toUtf8() + R"(","service":")" + service + R"(","args":)" +
         args + '}');
    return answerTo(id);
  }
  QJsonObject answerTo(const QString& id) {
    QJsonObject found;
    const auto has_come = [&] {
      for (const QJsonObject& answer : answers) {
        if (answer[QLatin1String("id")].toString() == id) found = answer;
      }
      return !found.isEmpty();
    };
    std::ignore = QTest::qWaitFor(has_come, 30'000);
    return found;
  }
  QJsonObject values(const QByteArray& service, const QByteArray& args = "{}") {
    return ask(service, args)[QLatin1String("values")].toObject();
  }
  /// The service's own code; -1 when the call did not work.
  int result(const QByteArray& service, const QByteArray& args = "{}") {
    return values(service, args)[QLatin1String("result")].toInt(-1);
  }
  /// Returns when all that was sent before has been read by the server.
  bool settle() { return !ask("/no/such/service").isEmpty(); }

  QWebSocket socket;
  QStringList texts, order;
  QByteArrayList binaries;
  QList<QJsonObject> answers, statuses;
  QMap<QString, QList<QJsonObject>> topics;
  int asked = 0;

 private:
  static QString name(const QJsonObject& message) { return message[QLatin1String("topic")].toString(); }
};

/// A simulated robot that stands still, with one client.
class RosRobot {
 public:
  explicit RosRobot(const mapwright::simulator::Options& options = still()) : robot(options) {
    if (!robot.start()) client = std::make_unique<RosSocket>(robot.rosPort());
  }
  static mapwright::simulator::Options still() {
    mapwright::simulator::Options options;
    options.paused = true;
    options.start_at_s = 90;
    return options;
  }
  static mapwright::simulator::Options ros2() {
    mapwright::simulator::Options options = still();
    options.ros.dialect = mapwright::simulator::RosDialect::Ros2;
    return options;
  }
  RosSocket* operator->() const { return client.get(); }

  mapwright::simulator::Simulator robot;
  std::unique_ptr<RosSocket> client;
};

/// A member of a member: at(message, "header.stamp.secs").
inline QJsonValue at(const QJsonObject& object, const char* path) {
  QJsonValue value = object;
  for (const QString& part : QString::fromLatin1(path).split(QLatin1Char('.'))) {
    bool is_index = false;
    const int index = part.toInt(&is_index);
    value = is_index ? value.toArray().at(index) : value.toObject()[part];
  }
  return value;
}
