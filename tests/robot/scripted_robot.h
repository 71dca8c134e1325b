// A robot for one test: HTTP and WebSocket on one port. It answers with what it is told to and notes what it
// was asked.
#pragma once

#include <functional>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QList>
#include <QMap>
#include <QSet>
#include <QTcpServer>
#include <QTcpSocket>
#include <QUrl>
#include <QWebSocket>
#include <QWebSocketServer>

namespace mapwright::robot::testing {

struct Asked {
  QByteArray method, path;
  QMap<QByteArray, QByteArray> headers;  // names in lower case
  QByteArray body;
};

class ScriptedRobot {
 public:
  ScriptedRobot() : sockets_(QStringLiteral("robot"), QWebSocketServer::NonSecureMode) {
    listen();
    QObject::connect(&server_, &QTcpServer::newConnection, &server_, [this] {
      QTcpSocket* socket = server_.nextPendingConnection();
      QObject::connect(socket, &QTcpSocket::readyRead, socket, [this, socket] { read(socket); });
      QObject::connect(socket, &QTcpSocket::disconnected, socket, &QObject::deleteLater);
    });
    QObject::connect(&sockets_, &QWebSocketServer::newConnection, &sockets_, [this] {
      while (QWebSocket* peer = sockets_.nextPendingConnection()) {
        peer->setParent(&sockets_);
        peers.append(peer);
        if (!greeting.isEmpty()) peer->sendTextMessage(QString::fromUtf8(greeting));
        QObject::connect(peer, &QWebSocket::textMessageReceived, peer,
                         [this](const QString& text) { texts.append(text.toUtf8()); });
      }
    });
  }

  QUrl url() const { return QUrl(QStringLiteral("http://127.0.0.1:%1").arg(port_)); }
  void listen() {
    server_.listen(QHostAddress::LocalHost, port_);
    port_ = server_.serverPort();
  }
  void goAway() { server_.close(); }

  static QByteArray reply(int status, const QByteArray& body, const QByteArray& headers = {}) {
    return "HTTP/1.1 " + QByteArray::number(status) +
           " Word\r\nConnection: close\r\nContent-Length: " + QByteArray::number(body.size()) + "\r\n" +
           headers + "\r\n" + body;
  }
  /// 200 with this body for a path (without its query).
  void serve(const QByteArray& path, const QByteArray& body, const QByteArray& headers = {}) {
    answers[path] = reply(200, body, headers);
  }
  int timesAsked(const QByteArray& path) const {
    int times = 0;
    for (const Asked& one : asked) times += one.path.split('?').first() == path ? 1 : 0;
    return times;
  }
  void send(const QByteArray& text) {
    for (QWebSocket* peer : std::as_const(peers)) peer->sendTextMessage(QString::fromUtf8(text));
  }
  void sendBinary(const QByteArray& bytes) {
    for (QWebSocket* peer : std::as_const(peers)) peer->sendBinaryMessage(bytes);
  }
  /// Every topic named with `verb` so far.
  QStringList topicsSent(const char* verb) const {
    QStringList topics;
    for (const QByteArray& text : texts) {
      const QJsonValue value = QJsonDocument::fromJson(text).object().value(QLatin1String(verb));
      if (value.isString()) topics << value.toString();
      for (const QJsonValue& topic : value.toArray()) topics << topic.toString();
    }
    return topics;
  }

  QMap<QByteArray, QByteArray> answers;  // whole HTTP answers by path; others are 404
  QSet<QByteArray> held;                 // paths that are never answered
  QList<Asked> asked;
  QList<QWebSocket*> peers;
  QList<QByteArray> texts;  // what came over WebSockets
  QByteArray greeting;      // said to every new one

 private:
  void read(QTcpSocket* socket) {
    const QByteArray seen = socket->peek(qint64(1) << 20);
    const auto end = seen.indexOf("\r\n\r\n");
    if (end < 0) return;
    Asked one;
    for (const QByteArray& line : seen.left(end).split('\n')) {
      const auto colon = line.indexOf(':');
      if (one.path.isEmpty()) {
        one.method = line.split(' ').value(0);
        one.path = line.split(' ').value(1);
      } else if (colon > 0) {
        one.headers.insert(line.left(colon).trimmed().toLower(), line.mid(colon + 1).trimmed());
      }
    }
    if (one.headers.contains("upgrade")) {
      asked.append(one);
      socket->disconnect(socket);
      sockets_.handleConnection(socket);
      return;
    }
    const qsizetype length = one.headers.value("content-length").toLongLong();
    one.body = seen.mid(end + 4, length);
    if (one.body.size() < length) return;
    socket->skip(end + 4 + length);
    asked.append(one);
    const QByteArray path = one.path.split('?').first();
    if (held.contains(path)) return;
    socket->write(
        answers.value(path, reply(404, R"({"detail":"Not found"})", "Content-Type: application/json\r\n")));
    socket->disconnectFromHost();
  }

  QTcpServer server_;
  QWebSocketServer sockets_;
  quint16 port_ = 0;
};

}  // namespace mapwright::robot::testing
