// An encrypted robot for one test: HTTP and WebSocket on one port, with a certificate of tests/tls. It
// notes every decrypted request, so a test can tell that nothing was sent to it.
#pragma once

#include <functional>

#include <QByteArray>
#include <QFile>
#include <QList>
#include <QMap>
#include <QPointer>
#include <QSslCertificate>
#include <QSslConfiguration>
#include <QSslKey>
#include <QSslServer>
#include <QSslSocket>
#include <QUrl>
#include <QWebSocket>
#include <QWebSocketServer>

namespace mapwright::net::testing {

inline QByteArray tlsFile(const QString& name) {
  QFile file(QStringLiteral(MAPWRIGHT_TEST_DATA "/tls/") + name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline QSslCertificate certificate(const QString& name) {
  return QSslCertificate(tlsFile(name + QStringLiteral(".pem")), QSsl::Pem);
}

inline QByteArray sha256(const QString& name) { return certificate(name).digest(QCryptographicHash::Sha256); }

class SecureServer {
 public:
  explicit SecureServer(const QString& certificate_name)
      : sockets_(QStringLiteral("robot"), QWebSocketServer::NonSecureMode) {
    show(certificate_name);
    server_.listen(QHostAddress::LocalHost);
    QObject::connect(&server_, &QTcpServer::pendingConnectionAvailable, &server_, [this] {
      auto* socket = server_.nextPendingConnection();
      QObject::connect(socket, &QTcpSocket::readyRead, socket, [this, socket] { read(socket); });
      QObject::connect(socket, &QTcpSocket::disconnected, socket, &QObject::deleteLater);
      if (socket->bytesAvailable() > 0) read(socket);
    });
    QObject::connect(&sockets_, &QWebSocketServer::newConnection, &sockets_, [this] {
      while (QWebSocket* peer = sockets_.nextPendingConnection()) {
        peer->setParent(&sockets_);
        peers.append(peer);
      }
    });
  }

  /// The certificate from the next connection on.
  void show(const QString& certificate_name) {
    QSslConfiguration configuration = QSslConfiguration::defaultConfiguration();
    configuration.setLocalCertificate(certificate(certificate_name));
    configuration.setPrivateKey(QSslKey(tlsFile(QStringLiteral("robot.key")), QSsl::Ec));
    server_.setSslConfiguration(configuration);
  }
  QUrl url(const QString& scheme, const QString& path = QStringLiteral("/")) const {
    return QUrl(QStringLiteral("%1://127.0.0.1:%2%3").arg(scheme).arg(server_.serverPort()).arg(path));
  }
  quint16 port() const { return server_.serverPort(); }

  QByteArray answer = "{}";  // to every HTTP request, with 200
  QList<QByteArray> seen;    // requests as they came, decrypted
  QList<QWebSocket*> peers;
  QPointer<QTcpSocket> raw;  // below the last of the peers: what is written there goes out as it is

 private:
  void read(QTcpSocket* socket) {
    const QByteArray text = socket->peek(1 << 20);
    const auto end = text.indexOf("\r\n\r\n");
    if (end < 0) return;
    seen.append(text);
    if (text.toLower().contains("upgrade: websocket")) {
      socket->disconnect(socket);
      raw = socket;
      sockets_.handleConnection(socket);
      return;
    }
    socket->readAll();
    socket->write(
        "HTTP/1.1 200 OK\r\nConnection: close\r\nContent-Type: application/json\r\nContent-Length: " +
        QByteArray::number(answer.size()) + "\r\n\r\n" + answer);
    socket->disconnectFromHost();
  }

  QSslServer server_;
  QWebSocketServer sockets_;
};

}  // namespace mapwright::net::testing
