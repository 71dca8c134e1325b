// A web server for one test: it notes every request and answers with the very bytes it is told to.
#pragma once

#include <functional>

#include <QByteArray>
#include <QList>
#include <QMap>
#include <QTcpServer>
#include <QTcpSocket>
#include <QUrl>

namespace mapwright::net::testing {

struct SeenRequest {
  QByteArray method, path;
  QMap<QByteArray, QByteArray> headers;  // names in lower case
  QByteArray body;
};

class ScriptedServer {
 public:
  /// The whole answer, sent as it is, after which the connection is closed; empty: silence, and the
  /// connection stays.
  using Answer = std::function<QByteArray(const SeenRequest&)>;

  /// Answer with this to close the connection without a word.
  inline static const QByteArray kHangUp = "(hang up)";

  explicit ScriptedServer(Answer answer) : answer_(std::move(answer)) {
    server_.listen(QHostAddress::LocalHost);
    QObject::connect(&server_, &QTcpServer::newConnection, &server_, [this] {
      QTcpSocket* socket = server_.nextPendingConnection();
      QObject::connect(socket, &QTcpSocket::readyRead, socket, [this, socket] { read(socket); });
      QObject::connect(socket, &QTcpSocket::disconnected, socket, [this, socket] {
        ++disconnects;
        socket->deleteLater();
      });
    });
  }

  QUrl url(const QString& path = QStringLiteral("/")) const {
    return QUrl(QStringLiteral("http://127.0.0.1:%1%2").arg(server_.serverPort()).arg(path));
  }
  quint16 port() const { return server_.serverPort(); }

  static QByteArray reply(int status, const QByteArray& headers, const QByteArray& body) {
    return "HTTP/1.1 " + QByteArray::number(status) +
           " Word\r\nConnection: close\r\nContent-Length: " + QByteArray::number(body.size()) + "\r\n" +
           headers + "\r\n" + body;
  }

  QList<SeenRequest> seen;
  int disconnects = 0;

 private:
  void read(QTcpSocket* socket) {
    QByteArray text = socket->property("text").toByteArray() + socket->readAll();
    socket->setProperty("text", text);
    const auto end = text.indexOf("\r\n\r\n");
    if (end < 0) {
      return;
    }
    SeenRequest request;
    for (const QByteArray& line : text.left(end).split('\n')) {
      const auto colon = line.indexOf(':');
      if (request.path.isEmpty()) {
        request.method = line.split(' ').value(0);
        request.path = line.split(' ').value(1);
      } else if (colon > 0) {
        request.headers.insert(line.left(colon).trimmed().toLower(), line.mid(colon + 1).trimmed());
      }
    }
    const qsizetype length = request.headers.value("content-length").toLongLong();
    request.body = text.mid(end + 4, length);
    if (request.body.size() < length) {
      return;
    }
    socket->setProperty("text", text.mid(end + 4 + length));
    seen.append(request);
    const QByteArray bytes = answer_(request);
    if (!bytes.isEmpty()) {
      if (bytes != kHangUp) {
        socket->write(bytes);
      }
      socket->disconnectFromHost();
    }
  }

  QTcpServer server_;
  Answer answer_;
};

}  // namespace mapwright::net::testing
