// A simulated robot with one client of its topics.
#pragma once

#include <memory>

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "simulator/simulator.h"
#include "topic_socket.h"

/// `of` waits for a topic's first message and gives its last.
class Listening {
 public:
  explicit Listening(const mapwright::simulator::Options& options, const QString& query = {})
      : robot(options) {
    if (!robot.start()) client = std::make_unique<TopicSocket>(robot.port(), query);
  }
  QJsonObject of(const char* topic) { return QJsonDocument::fromJson(text(topic).toUtf8()).object(); }
  QString text(const char* topic) {
    if (!client || !QTest::qWaitFor([this] { return client->isOpen(); }, 20'000)) return {};
    client->send(QByteArray("{\"enable_topic\":\"") + topic + "\"}");
    if (!QTest::qWaitFor([&] { return !client->of(topic).isEmpty(); }, 20'000)) return {};
    return client->of(topic).last();
  }
  /// How many messages of a topic came so far.
  qsizetype count(const char* topic) const { return client ? client->of(topic).size() : 0; }
  QJsonObject last(const char* topic) const {
    return QJsonDocument::fromJson(client->of(topic).last().toUtf8()).object();
  }
  int port() const { return robot.port(); }

  mapwright::simulator::Simulator robot;
  std::unique_ptr<TopicSocket> client;
};
