// Servers that take one connection of a client and no second.
#include <QSignalSpy>
#include <QTcpServer>
#include <QTcpSocket>
#include <QtTest>

#include "rosbridge_server.h"
#include "test_program.h"

namespace test_rosbridge_one_connection {

using namespace mapwright::net::rosbridge;
using testing::quick;
using testing::Replies;
using testing::request;
using testing::RosbridgeServer;
using testing::Seen;
using State = mapwright::net::WebSocketLink::State;

namespace {

/// Lets so many connections through to a server at a time, and answers 503 to the others.
class Doorman {
 public:
  explicit Doorman(quint16 to) {
    door_.listen(QHostAddress::LocalHost);
    QObject::connect(&door_, &QTcpServer::newConnection, &door_, [this, to] {
      while (QTcpSocket* guest = door_.nextPendingConnection()) {
        if (inside_ >= seats) {
          ++refused;
          guest->write("HTTP/1.1 503 Service Unavailable\r\nContent-Length: 0\r\nConnection: close\r\n\r\n");
          guest->disconnectFromHost();
          QObject::connect(guest, &QTcpSocket::disconnected, guest, &QObject::deleteLater);
          continue;
        }
        ++inside_;
        auto* host = new QTcpSocket(guest);
        host->connectToHost(QHostAddress::LocalHost, to);
        QObject::connect(host, &QTcpSocket::readyRead, guest, [=] { guest->write(host->readAll()); });
        QObject::connect(guest, &QTcpSocket::readyRead, host, [=] { host->write(guest->readAll()); });
        QObject::connect(host, &QTcpSocket::disconnected, guest, [=] { guest->disconnectFromHost(); });
        QObject::connect(guest, &QTcpSocket::disconnected, &door_, [this, guest] {
          --inside_;
          guest->deleteLater();
        });
      }
    });
  }
  QUrl url() const { return QUrl(QStringLiteral("ws://127.0.0.1:%1").arg(door_.serverPort())); }
  int seats = 1, refused = 0;

 private:
  QTcpServer door_;
  int inside_ = 0;
};

/// A client that wants something small and something large.
struct Guest {
  explicit Guest(const QUrl& url) : client(url, quick()) {
    QObject::connect(&client, &Client::received, &client,
                     [this](const TopicMessage& message) { messages << message.topic; });
    Subscription small, large;
    small.topic = "/tf";
    large.topic = "/map";
    large.large = true;
    client.subscribe(small);
    client.subscribe(large);
    client.open();
  }
  Client client;
  QList<std::string> messages;
  QSignalSpy sharing{&client, &Client::sharesOneConnection};
};

CallRequest largeRequest() {
  CallRequest made = request("/static_map");
  made.large = true;
  return made;
}

}  // namespace

class RosbridgeOneConnectionTest : public QObject {
  Q_OBJECT

  /// Both topics and a large answer come by the one connection, and it has been told once.
  static void allComesByOne(Guest& guest, RosbridgeServer& server) {
    QTRY_COMPARE(guest.sharing.size(), 1);
    QTRY_COMPARE(guest.client.link().state(), State::Open);
    server.answer = [&](const Seen& seen) {
      if (seen["op"] == QLatin1String("call_service")) server.reply(seen, R"({"map":{}})");
    };
    Replies replies;
    guest.client.call(largeRequest(), replies.collect());
    QTRY_COMPARE(replies.all.size(), 1);
    QCOMPARE(replies.all[0].kind, CallAnswer::Kind::Answered);
    const int peer = server.seen.last().peer;
    for (const char* topic : {"/tf", "/map"}) {
      const bool asked = std::any_of(server.seen.begin(), server.seen.end(), [&](const Seen& seen) {
        return seen.peer == peer && seen["op"] == QLatin1String("subscribe") &&
               seen["topic"] == QLatin1String(topic);
      });
      QVERIFY2(asked, topic);
      server.say(R"({"op":"publish","topic":")" + QByteArray(topic) + R"(","msg":{}})", peer);
    }
    QTRY_VERIFY(guest.messages.contains("/tf") && guest.messages.contains("/map"));
    QCOMPARE(guest.client.largeLink().state(), State::Closed);
    QCOMPARE(guest.sharing.size(), 1);
  }

 private Q_SLOTS:
  void aSecondOneThatIsRefusedIsDoneWithout() {
    RosbridgeServer server;
    Doorman doorman(server.port());
    Guest guest(doorman.url());
    allComesByOne(guest, server);
    QCOMPARE(doorman.refused, 1);
  }

  void aCallThatWaitsForTheSecondGoesByTheFirst() {
    RosbridgeServer server;
    server.answer = [&](const Seen& seen) {
      if (seen["op"] == QLatin1String("call_service")) server.reply(seen, "{}");
    };
    Doorman doorman(server.port());
    Client client(doorman.url(), quick());
    client.open();
    QTRY_COMPARE(client.link().state(), State::Open);
    Replies replies;
    client.call(largeRequest(), replies.collect());
    QTRY_COMPARE(replies.all.size(), 1);
    QCOMPARE(replies.all[0].kind, CallAnswer::Kind::Answered);
  }

  void anotherServerThatTakesTwoGetsTwo() {
    RosbridgeServer server;
    Doorman doorman(server.port());
    Guest guest(doorman.url());
    QTRY_COMPARE(guest.sharing.size(), 1);
    doorman.seats = 5;
    server.dropAll();
    QTRY_COMPARE(guest.client.largeLink().state(), State::Open);
    QTRY_VERIFY(server.seen.last()["topic"] == QLatin1String("/map") && server.seen.last().peer > 1);
  }

  void aSecondOneThatIsClosedEachTimeIsDoneWithout() {
    RosbridgeServer server;
    server.arrived = [&](int peer) {
      if (peer > 0) server.peers[peer]->close();
    };
    Guest guest(server.url());
    allComesByOne(guest, server);
  }

  void aServerThatKeepsTheNewestOnlyGetsOne() {
    RosbridgeServer server;
    server.arrived = [&](int peer) {
      for (int before = 0; before < peer; ++before) {
        if (server.peers[before]) server.peers[before]->close();
      }
    };
    Guest guest(server.url());
    allComesByOne(guest, server);
  }

  void oneLossOfTheSecondIsNoReason() {
    RosbridgeServer server;
    Guest guest(server.url());
    QTRY_COMPARE(guest.client.largeLink().state(), State::Open);
    QTRY_COMPARE(server.seen.size(), 2);
    server.peers.last()->abort();
    QTRY_COMPARE(server.seen.size(), 3);
    QTRY_COMPARE(guest.client.largeLink().state(), State::Open);
    QCOMPARE(guest.sharing.size(), 0);
  }
};

}  // namespace test_rosbridge_one_connection

MAPWRIGHT_TEST(test_rosbridge_one_connection, RosbridgeOneConnectionTest, Core)
#include "test_rosbridge_one_connection.moc"
