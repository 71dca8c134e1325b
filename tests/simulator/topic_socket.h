// A client of /ws/v2/topics that keeps what it is sent.
#pragma once

#include <QByteArrayList>
#include <QStringList>
#include <QUrl>
#include <QWebSocket>

class TopicSocket {
 public:
  explicit TopicSocket(int port, const QString& query = {}) {
    QObject::connect(&socket, &QWebSocket::textMessageReceived, &socket,
                     [this](const QString& text) { texts.append(text); });
    QObject::connect(&socket, &QWebSocket::binaryMessageReceived, &socket,
                     [this](const QByteArray& bytes) { binaries.append(bytes); });
    QObject::connect(&socket, &QWebSocket::pong, &socket, [this] { ++pongs; });
    socket.open(QUrl(QStringLiteral("ws://127.0.0.1:%1/ws/v2/topics%2").arg(port).arg(query)));
  }

  bool isOpen() const { return socket.state() == QAbstractSocket::ConnectedState; }
  void send(const char* text) { socket.sendTextMessage(QString::fromUtf8(text)); }
  /// The texts of a topic, oldest first.
  QStringList of(const char* topic) const {
    return texts.filter(QStringLiteral("{\"topic\":\"%1\"").arg(QLatin1String(topic)));
  }

  QWebSocket socket;
  QStringList texts;
  QByteArrayList binaries;
  int pongs = 0;
};
