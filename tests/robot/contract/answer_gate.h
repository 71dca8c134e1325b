// A way to a robot that can be disturbed: passes what it is asked on to the real one, or does not.
#pragma once

#include <algorithm>
#include <optional>

#include <QByteArray>
#include <QHostAddress>
#include <QList>
#include <QTcpServer>
#include <QTcpSocket>
#include <QUrl>

namespace mapwright::robot::testing {

class AnswerGate {
 public:
  explicit AnswerGate(quint16 robot_port) : robot_port_(robot_port) {
    server_.listen(QHostAddress::LocalHost);
    port_ = server_.serverPort();
    QObject::connect(&server_, &QTcpServer::newConnection, &server_, [this] {
      while (QTcpSocket* asker = server_.nextPendingConnection()) onConnection(asker);
    });
  }

  quint16 port() const { return port_; }
  /// What every question gets from now on instead of the robot's answer; empty: silence.
  void answerAll(const QByteArray& answer) { instead_ = answer; }
  /// Questions that begin so ("PATCH ") are passed on whatever is said here; the others get answerAll().
  void passOnly(const QByteArray& beginning) { passed_ = beginning; }
  /// The robot's answers break off after so many bytes.
  void cutAfter(qint64 bytes) { cut_after_ = bytes; }
  /// Nobody is there any more, for those who are connected neither.
  void close() {
    server_.close();
    const auto askers = server_.findChildren<QTcpSocket*>(QString(), Qt::FindDirectChildrenOnly);
    for (QTcpSocket* asker : askers) asker->abort();
  }
  /// How many questions came that begin so.
  int count(const QByteArray& beginning) const {
    return int(std::count_if(questions_.begin(), questions_.end(),
                             [&](const QByteArray& one) { return one.startsWith(beginning); }));
  }

  static QByteArray reply(int status, const QByteArray& body, const QByteArray& type = "application/json") {
    return "HTTP/1.1 " + QByteArray::number(status) + " Word\r\nConnection: close\r\nContent-Type: " + type +
           "\r\nContent-Length: " + QByteArray::number(body.size()) + "\r\n\r\n" + body;
  }

 private:
  void onConnection(QTcpSocket* asker) {
    auto* robot = new QTcpSocket(asker);
    QObject::connect(asker, &QTcpSocket::disconnected, asker, &QObject::deleteLater);
    QObject::connect(asker, &QTcpSocket::readyRead, robot, [this, asker, robot] {
      const QByteArray question = asker->readAll();
      questions_ << question;
      if (instead_ && (passed_.isEmpty() || !question.startsWith(passed_))) {
        if (instead_->isEmpty()) return;
        asker->write(*instead_);
        asker->disconnectFromHost();
        return;
      }
      if (robot->state() == QAbstractSocket::UnconnectedState)
        robot->connectToHost(QHostAddress::LocalHost, robot_port_);
      robot->write(question);
    });
    QObject::connect(robot, &QTcpSocket::readyRead, asker, [this, asker, robot] {
      const QByteArray answer = robot->readAll();
      if (!cut_after_) {
        asker->write(answer);
        return;
      }
      asker->write(answer.left(*cut_after_));
      asker->flush();
      asker->disconnectFromHost();
    });
    QObject::connect(robot, &QTcpSocket::disconnected, asker, [asker, robot] {
      asker->write(robot->readAll());
      asker->disconnectFromHost();
    });
  }

  QTcpServer server_;
  quint16 robot_port_, port_ = 0;
  std::optional<QByteArray> instead_;
  QByteArray passed_;
  std::optional<qint64> cut_after_;
  QList<QByteArray> questions_;
};

}  // namespace mapwright::robot::testing
