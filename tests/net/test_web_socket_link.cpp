#include <QSignalSpy>
#include <QWebSocket>
#include <QWebSocketServer>
#include <QtTest>

#include "fault_arguments.h"
#include "net/backoff.h"
#include "net/web_socket_link.h"
#include "scripted_server.h"
#include "secure_server.h"
#include "test_program.h"

namespace test_web_socket_link {

using namespace mapwright;
using namespace mapwright::net;
using testing::ScriptedServer;
using testing::SeenRequest;
using State = WebSocketLink::State;
using std::chrono::milliseconds;

namespace {

QString argumentsOf(const WebSocketLink& link) { return ::argumentsOf(link.reason()).join(QLatin1Char('|')); }

/// A WebSocket server that keeps its peers.
class EchoServer {
 public:
  explicit EchoServer(quint16 port = 0) : server_(QStringLiteral("echo"), QWebSocketServer::NonSecureMode) {
    server_.listen(QHostAddress::LocalHost, port);
    QObject::connect(&server_, &QWebSocketServer::newConnection, &server_, [this] {
      while (QWebSocket* peer = server_.nextPendingConnection()) {
        peer->setParent(&server_);
        peers.append(peer);
        QObject::connect(peer, &QWebSocket::textMessageReceived, peer,
                         [peer](const QString& text) { peer->sendTextMessage(text); });
      }
    });
  }
  QUrl url() const { return QUrl(QStringLiteral("ws://127.0.0.1:%1/ws").arg(port())); }
  quint16 port() const { return server_.serverPort(); }

  QList<QWebSocket*> peers;

 private:
  QWebSocketServer server_;
};

WebSocketLinkOptions quick() {
  WebSocketLinkOptions options;
  options.ping_every = milliseconds(20);
  options.look_every = milliseconds(5);
  options.silent_after = milliseconds(5'000);
  options.connect_timeout = milliseconds(5'000);
  options.backoff_first = milliseconds(5);
  options.backoff_limit = milliseconds(20);
  options.jitter_seed = 1;
  return options;
}

/// A server that shakes hands and then sends what the test says, byte by byte; it answers nothing by itself.
class RawWebSocketServer {
 public:
  RawWebSocketServer() {
    server_.listen(QHostAddress::LocalHost);
    QObject::connect(&server_, &QTcpServer::newConnection, &server_, [this] {
      QTcpSocket* socket = server_.nextPendingConnection();
      QObject::connect(socket, &QTcpSocket::readyRead, socket, [this, socket] {
        const QByteArray request = socket->readAll();
        const auto at = request.indexOf("Sec-WebSocket-Key: ");
        if (at < 0) return;
        const QByteArray key = request.mid(at + 19, request.indexOf('\r', at) - at - 19);
        const QByteArray accept =
            QCryptographicHash::hash(key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11", QCryptographicHash::Sha1)
                .toBase64();
        socket->write(
            "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            "Sec-WebSocket-Accept: " +
            accept + "\r\n\r\n");
        ++handshakes;
        peer = socket;
        if (greeting.isEmpty()) return;
        socket->write(greeting);
        socket->disconnectFromHost();
      });
    });
  }
  QUrl url() const { return QUrl(QStringLiteral("ws://127.0.0.1:%1/").arg(server_.serverPort())); }

  QByteArray greeting;  // sent after the handshake, then the connection is closed
  int handshakes = 0;
  QPointer<QTcpSocket> peer;

 private:
  QTcpServer server_;
};

/// A clock that stands until the test moves it, and tells how often it was looked at.
struct StandingClock {
  std::chrono::milliseconds time{1'000'000};
  int looks = 0;
  std::function<std::chrono::milliseconds()> reader() {
    return [this] {
      ++looks;
      return time;
    };
  }
};

QUrl webSocketUrl(const ScriptedServer& server, const QString& path = QStringLiteral("/ws")) {
  QUrl url = server.url(path);
  url.setScheme(QStringLiteral("ws"));
  return url;
}

}  // namespace

class TestWebSocketLink : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void carriesTextAndBytes() {
    EchoServer server;
    WebSocketLink link({server.url()}, "hush", quick());
    QSignalSpy opened(&link, &WebSocketLink::opened);
    QSignalSpy text(&link, &WebSocketLink::textReceived);
    QSignalSpy binary(&link, &WebSocketLink::binaryReceived);
    QCOMPARE(link.state(), State::Closed);
    link.sendText(QStringLiteral("too early"));
    link.open();
    QCOMPARE(link.state(), State::Connecting);
    QTRY_COMPARE(link.state(), State::Open);
    QTRY_COMPARE(opened.size(), 1);
    QCOMPARE(link.attempt(), 0);
    QVERIFY(!link.reason().any());
    QTRY_COMPARE(server.peers.size(), 1);
    QCOMPARE(server.peers[0]->request().rawHeader("Secret"), QByteArray("hush"));
    link.sendText(QStringLiteral("grüß"));
    QTRY_COMPARE(text.size(), 1);
    QCOMPARE(text[0][0].toByteArray(), QByteArray("grüß"));
    server.peers[0]->sendBinaryMessage(QByteArray("\0\1\2", 3));
    QTRY_COMPARE(binary.size(), 1);
    QCOMPARE(binary[0][0].toByteArray(), QByteArray("\0\1\2", 3));
    QTRY_VERIFY(link.roundTripMs().has_value());
    link.open();  // already
    QCOMPARE(opened.size(), 1);
  }

  void closedStaysClosed() {
    EchoServer server;
    WebSocketLink link({server.url()}, {}, quick());
    link.open();
    QTRY_COMPARE(link.state(), State::Open);
    QTRY_COMPARE(server.peers.size(), 1);
    QSignalSpy left(server.peers[0], &QWebSocket::disconnected);
    link.close();
    QCOMPARE(link.state(), State::Closed);
    QVERIFY(!link.reason().any());
    QVERIFY(!link.retryInMs());
    QTRY_COMPARE(left.size(), 1);
    QCOMPARE(server.peers[0]->closeCode(), QWebSocketProtocol::CloseCodeNormal);
    QCOMPARE(link.state(), State::Closed);
    link.open();
    QTRY_COMPARE(link.state(), State::Open);
  }

  void comesBackByItself() {
    auto server = std::make_unique<EchoServer>();
    const quint16 port = server->port();
    WebSocketLink link({server->url()}, {}, quick());
    QSignalSpy opened(&link, &WebSocketLink::opened);
    QList<Fault> reasons;
    int most_attempts = 0;
    connect(&link, &WebSocketLink::changed, this, [&] {
      if (link.state() == State::Waiting) {
        reasons.append(link.reason());
        QVERIFY(link.retryInMs().has_value());
      }
      most_attempts = std::max(most_attempts, link.attempt());
    });
    link.open();
    QTRY_COMPARE(opened.size(), 1);
    QTRY_COMPARE(server->peers.size(), 1);
    server->peers[0]->close(QWebSocketProtocol::CloseCodeGoingAway, QStringLiteral("<b>restart</b>"));
    QTRY_COMPARE(opened.size(), 2);
    QCOMPARE(reasons.value(0), faultOf(net::fault::ConnectionClosedSaying,
                                       {QStringLiteral(u"\u2039b\u203arestart\u2039/b\u203a")}));
    QTRY_COMPARE(server->peers.size(), 2);
    reasons.clear();
    server.reset();
    const Fault refused = faultOf(net::fault::ConnectionRefused, {QStringLiteral("127.0.0.1:%1").arg(port)});
    QTRY_VERIFY(reasons.count(refused) >= 3);
    QVERIFY(most_attempts >= 3);
    EchoServer again(port);
    QTRY_COMPARE(opened.size(), 3);
    QCOMPARE(link.attempt(), 0);
    QVERIFY(!link.reason().any());
  }

  void openWhileWaitingDoesNotWait() {
    auto server = std::make_unique<EchoServer>();
    const quint16 port = server->port();
    const QUrl url = server->url();
    server.reset();
    WebSocketLinkOptions options = quick();
    options.backoff_first = options.backoff_limit = milliseconds(3'600'000);
    WebSocketLink link({url}, {}, options);
    link.open();
    QTRY_COMPARE(link.state(), State::Waiting);
    QVERIFY(*link.retryInMs() > 3'000'000);
    EchoServer again(port);
    link.open();
    QTRY_COMPARE(link.state(), State::Open);
  }

  void silenceIsNoticed() {
    RawWebSocketServer mute;  // not even a pong
    WebSocketLinkOptions options = quick();
    options.silent_after = milliseconds(60);
    WebSocketLink link({mute.url()}, {}, options);
    QSignalSpy opened(&link, &WebSocketLink::opened);
    QList<Fault> reasons;
    connect(&link, &WebSocketLink::changed, this, [&] {
      if (link.state() == State::Waiting) {
        reasons.append(link.reason());
      }
    });
    link.open();
    QTRY_VERIFY(opened.size() >= 2);  // and it tries again
    QCOMPARE(reasons.value(0), faultOf(net::fault::NoAnswerWithin, {QStringLiteral("60 ms")}));
    QVERIFY(mute.handshakes >= 2);
  }

  void whoDoesNotAnswerIsToldSoonWithTheTimeOfItsLastByte() {
    RawWebSocketServer server;
    StandingClock clock;
    const QDateTime began(QDate(2026, 5, 1), QTime(12, 0, 0));
    WebSocketLinkOptions options = quick();
    options.now = clock.reader();
    options.wall = [&] { return began.addMSecs((clock.time - milliseconds(1'000'000)).count()); };
    options.quiet_after = milliseconds(3'000);
    options.ping_every = milliseconds(60'000);  // it asks because nothing comes
    options.silent_after = milliseconds(15'000);
    options.backoff_first = options.backoff_limit = milliseconds(1'000);
    WebSocketLink link({server.url()}, {}, options);
    QSignalSpy changed(&link, &WebSocketLink::changed);
    link.open();
    QTRY_COMPARE(link.state(), State::Open);
    const auto hear = [&] {
      const QByteArray text("\x81\x01x", 3);
      QSignalSpy came(&link, &WebSocketLink::textReceived);
      server.peer->write(text);
      QTRY_COMPARE(came.size(), 1);
    };
    const auto pass = [&](int ms) {
      clock.time += milliseconds(ms);
      const int looks = clock.looks;
      QTRY_VERIFY(clock.looks > looks + 4);
    };
    hear();
    hear();       // what nobody asked for: it talks
    pass(2'000);  // asked by now
    QVERIFY(!link.silentSince());
    pass(1'900);
    QVERIFY(!link.silentSince());
    changed.clear();
    pass(200);
    QCOMPARE(link.state(), State::Open);
    QCOMPARE(link.silentSince(), std::optional(began));
    QCOMPARE(changed.size(), 1);
    pass(5'000);
    QCOMPARE(link.silentSince(), std::optional(began));
    hear();
    QVERIFY(!link.silentSince());
    QCOMPARE(changed.size(), 2);
    // It has taken 7.1 s to answer: as long is nothing remarkable now.
    pass(2'000);
    pass(10'000);
    QVERIFY(!link.silentSince());
    const QDateTime heard = began.addMSecs(9'100);
    clock.time += milliseconds(3'500);
    QTRY_COMPARE(link.state(), State::Waiting);
    QCOMPARE(link.silentSince(), std::optional(heard));
    QTRY_COMPARE(link.state(), State::Open);
    QVERIFY(!link.silentSince());
  }

  void aQuietServerThatAnswersIsNotSilent() {
    EchoServer server;
    WebSocketLinkOptions options = quick();
    options.ask_after = milliseconds(10);
    options.quiet_after = milliseconds(2'000);
    WebSocketLink link({server.url()}, {}, options);
    link.open();
    QTRY_COMPARE(link.state(), State::Open);
    bool told = false;
    connect(&link, &WebSocketLink::changed, this, [&] { told |= link.silentSince().has_value(); });
    int pongs = 0;
    connect(&link, &WebSocketLink::changed, this, [&] { ++pongs; });
    QTRY_VERIFY(pongs > 10);
    QVERIFY(!told);
  }

  void everyByteIsASignOfLife() {
    RawWebSocketServer server;
    StandingClock clock;
    WebSocketLinkOptions options = quick();
    options.silent_after = milliseconds(15'000);
    options.backoff_first = options.backoff_limit = milliseconds(3'600'000);
    options.now = clock.reader();
    WebSocketLink link({server.url()}, {}, options);
    QSignalSpy binary(&link, &WebSocketLink::binaryReceived);
    link.open();
    QTRY_COMPARE(link.state(), State::Open);
    QTRY_VERIFY(server.peer);
    // One frame of 20 parts, each of which comes just in time: half a minute and more for the whole.
    constexpr int kParts = 20, kPartBytes = 1000;
    server.peer->write(QByteArray::fromHex("827e4e20"));  // binary, 20,000 bytes
    for (int part = 0; part < kParts; ++part) {
      clock.time += milliseconds(14'000);
      server.peer->write(QByteArray(kPartBytes, 'x'));
      QTRY_COMPARE(link.silence(), milliseconds(0));
      const int before = clock.looks;
      QTRY_VERIFY(clock.looks > before + 3);
      QCOMPARE(link.state(), State::Open);
    }
    QTRY_COMPARE(binary.size(), 1);
    QCOMPARE(binary[0][0].toByteArray().size(), kParts * kPartBytes);
    // Half a frame and then nothing is a dead link.
    server.peer->write(QByteArray::fromHex("827e4e20") + QByteArray(500, 'x'));
    clock.time += milliseconds(14'000);
    QTRY_COMPARE(link.silence(), milliseconds(0));
    clock.time += milliseconds(15'001);
    QTRY_COMPARE(link.state(), State::Waiting);
    QCOMPARE(link.reason(), faultOf(net::fault::NoAnswerWithin, {QStringLiteral("15 s")}));
    QCOMPARE(link.failure(), WebSocketLink::Failure::TimedOut);
  }

  void whatHasComeOfAMessageIsCounted() {
    RawWebSocketServer server;
    WebSocketLink link({server.url()}, {}, quick());
    QSignalSpy binary(&link, &WebSocketLink::binaryReceived);
    QCOMPARE(link.arrivingBytes(), 0);
    link.open();
    QTRY_COMPARE(link.state(), State::Open);
    QTRY_VERIFY(server.peer);
    // Two frames of one message, the second of which comes in halves.
    server.peer->write(QByteArray::fromHex("027e03e8") + QByteArray(1000, 'x'));
    QTRY_VERIFY(link.arrivingBytes() >= 1000);
    server.peer->write(QByteArray::fromHex("807e07d0") + QByteArray(1000, 'x'));
    QTRY_VERIFY(link.arrivingBytes() >= 2000);
    QVERIFY(link.arrivingBytes() < 2100);
    QCOMPARE(binary.size(), 0);
    server.peer->write(QByteArray(1000, 'x'));
    QTRY_COMPARE(binary.size(), 1);
    QCOMPARE(binary[0][0].toByteArray().size(), 3000);
    QTRY_COMPARE(link.arrivingBytes(), 0);
  }

  void everyEncryptedByteIsASignOfLifeToo() {
    testing::SecureServer server(QStringLiteral("self_signed"));
    StandingClock clock;
    WebSocketLinkOptions options = quick();
    // No pongs: bytes of the frame alone count here.
    options.ping_every = options.ask_after = std::chrono::hours(1);
    options.now = clock.reader();
    WebSocketLink link({server.url(QStringLiteral("wss"))}, {}, options);
    Trust trust;
    trust.pinned_sha256 = testing::sha256(QStringLiteral("self_signed"));
    link.setTrust(trust);
    QSignalSpy binary(&link, &WebSocketLink::binaryReceived);
    link.open();
    QTRY_COMPARE(link.state(), State::Open);
    QTRY_VERIFY(link.roundTripMs().has_value());
    QVERIFY(server.raw);
    server.raw->write(QByteArray::fromHex("827e2710"));  // binary, 10,000 bytes
    for (int part = 0; part < 10; ++part) {
      clock.time += milliseconds(4'000);
      server.raw->write(QByteArray(1000, 'x'));
      QTRY_COMPARE(link.silence(), milliseconds(0));
      QCOMPARE(link.state(), State::Open);
    }
    QTRY_COMPARE(binary.size(), 1);
  }

  void aServerThatSendsAndClosesIsAskedLessAndLess_data() {
    QTest::addColumn<QByteArray>("greeting");
    QTest::addRow("a message") << QByteArray::fromHex("8102") + "{}";
    QTest::addRow("a pong") << QByteArray::fromHex("8a00");
    QTest::addRow("half a frame") << QByteArray::fromHex("827e4e20") + "xx";
    QTest::addRow("a close") << QByteArray::fromHex("880203e8");
  }
  void aServerThatSendsAndClosesIsAskedLessAndLess() {
    QFETCH(QByteArray, greeting);
    RawWebSocketServer server;
    server.greeting = greeting;
    StandingClock clock;
    WebSocketLinkOptions options = quick();
    options.backoff_limit = milliseconds(3'600'000);
    options.now = clock.reader();
    WebSocketLink link({server.url()}, {}, options);
    QList<int> waits;
    connect(&link, &WebSocketLink::changed, this, [&] {
      if (link.state() == State::Waiting) waits << *link.retryInMs();
    });
    link.open();
    QTRY_VERIFY(waits.size() >= 6);
    Backoff expected(options.backoff_first, options.backoff_limit, options.jitter_seed);
    for (int i = 0; i < 6; ++i) {
      const auto wait = int(expected.next().count());
      QVERIFY2(waits[i] <= wait * 11 / 10 + 2 && waits[i] > wait / 2, qPrintable(QString::number(waits[i])));
    }
    QVERIFY(server.handshakes >= 5);
  }

  void aTimeOfHealthForgetsEarlierLosses() {
    RawWebSocketServer server;
    server.greeting = QByteArray::fromHex("8102") + "{}";
    StandingClock clock;
    WebSocketLinkOptions options = quick();
    options.silent_after = milliseconds(3'600'000);
    options.healthy_after = milliseconds(30'000);
    options.backoff_limit = milliseconds(3'600'000);
    options.now = clock.reader();
    WebSocketLink link({server.url()}, {}, options);
    int last_wait = 0;
    connect(&link, &WebSocketLink::changed, this, [&] {
      if (link.state() == State::Waiting) last_wait = *link.retryInMs();
    });
    const auto lose = [&](milliseconds open_for) {
      QTRY_COMPARE(link.state(), State::Open);
      QTRY_VERIFY(server.peer);
      clock.time += open_for;
      const int before = clock.looks;
      QTRY_VERIFY(clock.looks > before + 3);
      server.peer->disconnectFromHost();
      server.peer.clear();
      QTRY_COMPARE(link.state(), State::Waiting);
    };
    link.open();
    QTRY_VERIFY(server.handshakes >= 5);
    server.greeting.clear();  // from now on it stays
    lose(milliseconds(29'000));
    QVERIFY2(last_wait > 40, qPrintable(QString::number(last_wait)));
    lose(milliseconds(30'001));
    QVERIFY2(last_wait <= 7, qPrintable(QString::number(last_wait)));
  }

  void whatKindOfFailureItWasIsTold_data() {
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<int>("failure");
    using Failure = WebSocketLink::Failure;
    const auto row = [](const char* name, const QByteArray& answer, Failure failure) {
      QTest::addRow("%s", name) << answer << int(failure);
    };
    row("401", ScriptedServer::reply(401, {}, {}), Failure::Refused);
    row("403", ScriptedServer::reply(403, {}, {}), Failure::Refused);
    row("a page", ScriptedServer::reply(200, "Content-Type: text/html\r\n", "<p>hello"),
        Failure::NotAWebSocket);
    row("404", ScriptedServer::reply(404, {}, {}), Failure::NotAWebSocket);
    row("400", ScriptedServer::reply(400, {}, {}), Failure::NotAWebSocket);
    row("redirect", ScriptedServer::reply(302, "Location: http://127.0.0.1:1/\r\n", {}),
        Failure::NotAWebSocket);
    row("no HTTP", "SSH-2.0-OpenSSH_9\r\n\r\n", Failure::NotAWebSocket);
    row("501", ScriptedServer::reply(501, {}, {}), Failure::NotAWebSocket);
    row("500", ScriptedServer::reply(500, {}, {}), Failure::Unreachable);
    row("503", ScriptedServer::reply(503, {}, {}), Failure::Unreachable);
    row("hang up", ScriptedServer::kHangUp, Failure::Unreachable);
  }
  void whatKindOfFailureItWasIsTold() {
    QFETCH(QByteArray, answer);
    QFETCH(int, failure);
    ScriptedServer server([answer](const SeenRequest&) { return answer; });
    WebSocketLinkOptions options = quick();
    options.backoff_first = options.backoff_limit = milliseconds(3'600'000);
    WebSocketLink link({webSocketUrl(server)}, {}, options);
    link.open();
    QTRY_VERIFY(link.state() == State::Waiting || link.state() == State::Closed);
    QCOMPARE(int(link.failure()), failure);
    QVERIFY(link.reason().any());
    QVERIFY2(!argumentsOf(link).contains(QStringLiteral("nknown error")), qPrintable(argumentsOf(link)));
  }

  void theSecretGoesToTheFirstAddressesOriginOnly() {
    ScriptedServer own([](const SeenRequest&) { return ScriptedServer::reply(404, {}, {}); });
    ScriptedServer other([](const SeenRequest&) { return ScriptedServer::reply(404, {}, {}); });
    WebSocketLinkOptions options = quick();
    options.backoff_first = options.backoff_limit = milliseconds(3'600'000);
    WebSocketLink link({webSocketUrl(own), webSocketUrl(other)}, "hush", options);
    link.open();
    QTRY_COMPARE(link.state(), State::Waiting);
    QCOMPARE(own.seen.size(), 1);
    QCOMPARE(own.seen[0].headers.value("secret"), QByteArray("hush"));
    QCOMPARE(other.seen.size(), 1);
    QVERIFY(!other.seen[0].headers.contains("secret"));
  }

  void pongsAloneKeepItOpen() {
    EchoServer server;
    WebSocketLinkOptions options = quick();
    options.ping_every = milliseconds(10);
    options.silent_after = milliseconds(2'000);
    WebSocketLink link({server.url()}, {}, options);
    QSignalSpy changed(&link, &WebSocketLink::changed);
    link.open();
    QTRY_VERIFY(changed.size() > 30);  // a pong each
    QCOMPARE(link.state(), State::Open);
  }

  void aServerThatDoesNotShakeHandsTimesOut() {
    ScriptedServer server([](const SeenRequest&) { return QByteArray(); });
    WebSocketLinkOptions options = quick();
    options.connect_timeout = milliseconds(50);
    options.backoff_first = options.backoff_limit = milliseconds(3'600'000);
    WebSocketLink link({webSocketUrl(server)}, {}, options);
    link.open();
    QTRY_COMPARE(link.state(), State::Waiting);
    QCOMPARE(link.reason(), faultOf(net::fault::NoAnswerWithin, {QStringLiteral("50 ms")}));
    QCOMPARE(link.attempt(), 1);
  }

  void garbageIsNotAHandshake_data() {
    QTest::addColumn<QByteArray>("answer");
    QTest::addRow("no HTTP") << QByteArray("SSH-2.0-OpenSSH_9\r\n\r\n");
    QTest::addRow("noise") << QByteArray("\0\1\xff\xfe\r\n\r\n\r\n", 11);
    QTest::addRow("a page") << ScriptedServer::reply(200, "Content-Type: text/html\r\n", "<h1>hello</h1>");
    QTest::addRow("wrong key") << QByteArray(
        "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Accept: AAAAAAAAAAAAAAAAAAAAAAAAAAA=\r\n\r\n");
    QTest::addRow("cut off") << QByteArray("HTTP/1.1 101 Switching");
    QTest::addRow("server error") << ScriptedServer::reply(503, {}, {});
  }
  void garbageIsNotAHandshake() {
    QFETCH(QByteArray, answer);
    ScriptedServer server([answer](const SeenRequest&) { return answer; });
    WebSocketLinkOptions options = quick();
    options.backoff_first = options.backoff_limit = milliseconds(3'600'000);
    WebSocketLink link({webSocketUrl(server)}, "hush", options);
    QSignalSpy opened(&link, &WebSocketLink::opened);
    link.open();
    QTRY_COMPARE(link.state(), State::Waiting);
    QVERIFY(link.reason().any());
    QVERIFY2(!argumentsOf(link).contains(QStringLiteral("QWebSocket")), qPrintable(argumentsOf(link)));
    QVERIFY(!argumentsOf(link).contains(QStringLiteral("hush")));
    QCOMPARE(opened.size(), 0);
  }

  void aRefusedSecretIsFinal_data() {
    QTest::addColumn<int>("status");
    QTest::addRow("401") << 401;
    QTest::addRow("403") << 403;
  }
  void aRefusedSecretIsFinal() {
    QFETCH(int, status);
    ScriptedServer server([status](const SeenRequest&) { return ScriptedServer::reply(status, {}, "no"); });
    WebSocketLink link({webSocketUrl(server), webSocketUrl(server, QStringLiteral("/other"))}, "hush",
                       quick());
    QSignalSpy changed(&link, &WebSocketLink::changed);
    link.open();
    QTRY_COMPARE(link.state(), State::Closed);
    QCOMPARE(link.handshakeStatus(), status);
    QCOMPARE(link.reason(), Fault(net::fault::ConnectionForbidden, {HttpStatus{status}}));
    QVERIFY(!argumentsOf(link).contains(QStringLiteral("hush")));
    QVERIFY(!link.retryInMs());
    QCOMPARE(server.seen.size(), 1);
    QCOMPARE(server.seen[0].headers.value("secret"), QByteArray("hush"));
  }

  void otherAddressesAreTriedInTurn_data() {
    QTest::addColumn<int>("status");
    for (const int status : {400, 404, 405, 426}) {
      QTest::addRow("%d", status) << status;
    }
  }
  void otherAddressesAreTriedInTurn() {
    QFETCH(int, status);
    EchoServer working;
    ScriptedServer refusing(
        [status](const SeenRequest&) { return ScriptedServer::reply(status, {}, "what?"); });
    WebSocketLinkOptions options = quick();
    options.backoff_first = options.backoff_limit = milliseconds(3'600'000);
    WebSocketLink link({webSocketUrl(refusing, QStringLiteral("/ws?pb=1")), working.url()}, {}, options);
    link.open();
    QTRY_COMPARE(link.state(), State::Open);  // without a wait between
    QCOMPARE(refusing.seen.size(), 1);
    QCOMPARE(refusing.seen[0].path, QByteArray("/ws?pb=1"));
    // The address that worked is remembered.
    QTRY_COMPARE(working.peers.size(), 1);
    working.peers[0]->close();
    QTRY_COMPARE(link.state(), State::Waiting);
    link.open();
    QTRY_COMPARE(link.state(), State::Open);
    QCOMPARE(refusing.seen.size(), 1);
  }

  void whenAllAddressesRefuseItWaits() {
    ScriptedServer refusing([](const SeenRequest&) { return ScriptedServer::reply(404, {}, "what?"); });
    WebSocketLinkOptions options = quick();
    options.backoff_first = options.backoff_limit = milliseconds(3'600'000);
    WebSocketLink link(
        {webSocketUrl(refusing, QStringLiteral("/a")), webSocketUrl(refusing, QStringLiteral("/b"))}, {},
        options);
    link.open();
    QTRY_COMPARE(link.state(), State::Waiting);
    QCOMPARE(refusing.seen.size(), 2);
    QCOMPARE(link.handshakeStatus(), 404);
    QCOMPARE(link.reason(), Fault(net::fault::ConnectionRejected, {HttpStatus{404}}));
    QCOMPARE(link.attempt(), 1);
    link.open();
    QTRY_COMPARE(refusing.seen.size(), 4);
    QTRY_COMPARE(link.state(), State::Waiting);
    QCOMPARE(link.attempt(), 2);
    link.close();
    QCOMPARE(link.state(), State::Closed);
    QVERIFY(!link.retryInMs());
  }

  void messagesThatAreTooLongEndTheLink() {
    EchoServer server;
    WebSocketLinkOptions options = quick();
    options.max_message_bytes = 1000;
    options.backoff_first = options.backoff_limit = milliseconds(3'600'000);
    WebSocketLink link({server.url()}, {}, options);
    QSignalSpy binary(&link, &WebSocketLink::binaryReceived);
    link.open();
    QTRY_COMPARE(link.state(), State::Open);
    QTRY_COMPARE(server.peers.size(), 1);
    server.peers[0]->sendBinaryMessage(QByteArray(1000, 'x'));
    QTRY_COMPARE(binary.size(), 1);
    server.peers[0]->sendBinaryMessage(QByteArray(1001, 'x'));
    QTRY_COMPARE(link.state(), State::Waiting);
    QCOMPARE(link.reason(), faultOf(net::fault::MessageTooLong, {QStringLiteral("1000")}));
    QCOMPARE(binary.size(), 1);
  }

  void withoutAnAddressItStaysClosed() {
    WebSocketLink link({}, {}, quick());
    link.open();
    QCOMPARE(link.state(), State::Closed);
    QVERIFY(link.reason().any());
  }

  void backoffDoublesWithJitterUpToItsLimit() {
    Backoff backoff(milliseconds(500), milliseconds(30'000), 7);
    for (int round = 0; round < 2; ++round) {
      double doubled = 500;
      for (int n = 0; n < 40; ++n) {
        const auto wait = double(backoff.next().count());
        QVERIFY(wait >= std::min(std::floor(doubled), 30'000.0));
        QVERIFY(wait <= std::min(doubled * 1.25, 30'000.0));
        doubled = std::min(doubled * 2, 1e9);
      }
      backoff.reset();
    }
    QVERIFY(Backoff(milliseconds(500), milliseconds(30'000), 1).next() !=
                Backoff(milliseconds(500), milliseconds(30'000), 99).next() ||
            Backoff(milliseconds(500), milliseconds(30'000), 1).next() !=
                Backoff(milliseconds(500), milliseconds(30'000), 12345).next());
  }
};

}  // namespace test_web_socket_link

MAPWRIGHT_TEST(test_web_socket_link, TestWebSocketLink, Core)
#include "test_web_socket_link.moc"
