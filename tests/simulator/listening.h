// A simulated robot with one client of its topics.
#pragma once

#include <memory>

#include "running.h"
#include "topic_socket.h"

/// `of` waits for a topic's first message and gives its last.
class Listening : public Running {
 public:
  explicit Listening(const mapwright::simulator::Options& options, const QString& query = {})
      : Running(options), client(std::make_unique<TopicSocket>(port(), query)) {}
  QJsonObject of(const char* topic) { return object(text(topic)); }
  QString text(const char* topic) {
    if (!QTest::qWaitFor([this] { return client->isOpen(); }, 20'000)) return {};
    client->send(QByteArray("{\"enable_topic\":\"") + topic + "\"}");
    if (!QTest::qWaitFor([&] { return !client->of(topic).isEmpty(); }, 20'000)) return {};
    return client->of(topic).last();
  }
  /// How many messages of a topic came so far.
  qsizetype count(const char* topic) const { return client->of(topic).size(); }
  QJsonObject last(const char* topic) const { return object(client->of(topic).last()); }

  std::unique_ptr<TopicSocket> client;
};
