// Requests that change something: sent as they are, once at most, and with it known whether they left.
#include <QtTest>

#include "fault_arguments.h"
#include "net/http_client.h"
#include "scripted_server.h"
#include "test_program.h"

namespace test_http_changes {

using namespace mapwright::net;
using testing::ScriptedServer;
using testing::SeenRequest;
using Kind = HttpAnswer::Kind;

namespace {

constexpr int kPatienceMs = 20'000;

/// One request in progress.
struct Asked {
  std::optional<HttpAnswer> answer;
  int replies = 0;
  QList<HttpProgress> progress;

  HttpRequest request(HttpMethod method, const QUrl& url, const QByteArray& body) {
    HttpRequest made;
    made.method = method;
    made.url = url;
    made.body = body;
    made.progress = [this](HttpProgress more) { progress << more; };
    return made;
  }
  HttpClient::Reply reply() {
    return [this](HttpAnswer given) {
      ++replies;
      answer = std::move(given);
    };
  }
  bool wait() const {
    return QTest::qWaitFor([this] { return answer.has_value(); }, kPatienceMs);
  }
};

HttpAnswer send(HttpClient& client, HttpMethod method, const QUrl& url, const QByteArray& body) {
  Asked asked;
  client.send(asked.request(method, url, body), asked.reply());
  return asked.wait() ? *asked.answer : HttpAnswer();
}

/// The threads in which Qt's network access works: one for each access that is still there.
int networkThreads() {
  int count = 0;
  for (const QString& task : QDir(QStringLiteral("/proc/self/task")).entryList(QDir::Dirs)) {
    QFile name(QStringLiteral("/proc/self/task/%1/comm").arg(task));
    count += name.open(QIODevice::ReadOnly) && name.readAll().startsWith("QNetworkAccess");
  }
  return count;
}

/// Keeps its connections open; does what it is told with the n-th request on them.
class KeepingServer {
 public:
  enum class Then { Answer, HangUp };
  explicit KeepingServer(QList<Then> script) : script_(std::move(script)) {
    server_.listen(QHostAddress::LocalHost);
    QObject::connect(&server_, &QTcpServer::newConnection, &server_, [this] {
      QTcpSocket* socket = server_.nextPendingConnection();
      open_ << socket;
      QObject::connect(socket, &QTcpSocket::readyRead, socket, [this, socket] { read(socket); });
      QObject::connect(socket, &QTcpSocket::disconnected, socket, [this, socket] {
        open_.removeOne(socket);
        socket->deleteLater();
      });
    });
  }
  ~KeepingServer() {
    for (QTcpSocket* socket : std::as_const(open_)) socket->disconnect();
  }
  QUrl url() const { return QUrl(QStringLiteral("http://127.0.0.1:%1/").arg(server_.serverPort())); }
  /// Closes the connections that wait for a next request, as servers do after a while.
  void closeIdle() {
    const auto open = open_;
    for (QTcpSocket* socket : open) socket->abort();
  }

  QList<QByteArray> methods;
  int used = 0;  // connections that a request came over

 private:
  void read(QTcpSocket* socket) {
    QByteArray text = socket->property("text").toByteArray() + socket->readAll();
    for (auto end = text.indexOf("\r\n\r\n"); end >= 0; end = text.indexOf("\r\n\r\n")) {
      static const QRegularExpression length(QStringLiteral("content-length: (\\d+)"),
                                             QRegularExpression::CaseInsensitiveOption);
      const auto body = length.match(QString::fromLatin1(text.left(end))).captured(1).toInt();
      if (text.size() < end + 4 + body) break;
      methods << text.left(text.indexOf(' '));
      if (!socket->property("used").toBool()) ++used;
      socket->setProperty("used", true);
      text.remove(0, end + 4 + body);
      const Then then = script_.value(methods.size() - 1, Then::Answer);
      if (then == Then::HangUp) {
        socket->abort();
        return;
      }
      socket->write("HTTP/1.1 200 OK\r\nConnection: keep-alive\r\nContent-Length: 2\r\n\r\nok");
    }
    socket->setProperty("text", text);
  }

  QTcpServer server_;
  QList<Then> script_;
  QList<QTcpSocket*> open_;
};

}  // namespace

class TestHttpChanges : public QObject {
  Q_OBJECT

  static void methods() {
    QTest::addColumn<HttpMethod>("method");
    QTest::addColumn<QByteArray>("name");
    QTest::newRow("POST") << HttpMethod::Post << QByteArray("POST");
    QTest::newRow("PUT") << HttpMethod::Put << QByteArray("PUT");
    QTest::newRow("PATCH") << HttpMethod::Patch << QByteArray("PATCH");
    QTest::newRow("DELETE") << HttpMethod::Delete << QByteArray("DELETE");
  }

 private Q_SLOTS:
  void everyMethodArrivesWithItsBody_data() { methods(); }
  void everyMethodArrivesWithItsBody() {
    QFETCH(HttpMethod, method);
    QFETCH(QByteArray, name);
    for (const QByteArray& body :
         {QByteArray(R"({"map_id":1764059676131})"), QByteArray(), QByteArray(300'000, 'x')}) {
      ScriptedServer server([](const SeenRequest&) { return ScriptedServer::reply(200, "", "fine"); });
      HttpClient client(server.url(), "hush", nullptr);
      const HttpAnswer answer = send(client, method, server.url(QStringLiteral("/rpc")), body);
      QVERIFY2(answer.ok(), qPrintable(argumentsOf(answer.reason).join(QLatin1Char('|'))));
      QVERIFY(answer.sent);
      QCOMPARE(answer.body, QByteArray("fine"));
      QCOMPARE(server.seen.size(), 1);
      QCOMPARE(server.seen[0].method, name);
      QCOMPARE(server.seen[0].body, body);
      QCOMPARE(server.seen[0].headers.contains("content-type"), !body.isEmpty());
      QCOMPARE(server.seen[0].headers.value("secret"), QByteArray("hush"));
    }
  }

  void aConnectionThatClosesIsNotAskedAgain_data() { methods(); }
  void aConnectionThatClosesIsNotAskedAgain() {
    QFETCH(HttpMethod, method);
    QFETCH(QByteArray, name);
    for (const QByteArray& body : {QByteArray("{}"), QByteArray(), QByteArray(300'000, 'x')}) {
      KeepingServer server({KeepingServer::Then::HangUp});
      HttpClient client(server.url(), "", nullptr);
      const HttpAnswer answer = send(client, method, server.url(), body);
      QCOMPARE(answer.kind, Kind::Unreachable);
      QVERIFY(answer.reason.any());
      QVERIFY(answer.sent);
      QCOMPARE(answer.status, 0);
      QCOMPARE(server.methods, QList<QByteArray>{name});
    }
  }

  void aKeptConnectionThatClosesIsNotAskedAgainEither_data() { methods(); }
  void aKeptConnectionThatClosesIsNotAskedAgainEither() {
    QFETCH(HttpMethod, method);
    QFETCH(QByteArray, name);
    KeepingServer server(
        {KeepingServer::Then::Answer, KeepingServer::Then::Answer, KeepingServer::Then::HangUp});
    HttpClient client(server.url(), "", nullptr);
    QVERIFY(send(client, HttpMethod::Get, server.url(), {}).ok());
    QVERIFY(send(client, method, server.url(), "{}").ok());
    const HttpAnswer answer = send(client, method, server.url(), "{}");
    QCOMPARE(answer.kind, Kind::Unreachable);
    QVERIFY(answer.sent);
    QCOMPARE(server.methods, (QList<QByteArray>{"GET", name, name}));
    QCOMPARE(server.used, 3);  // each change over one that nothing was sent over before
    // Since Qt 6.8 one more is opened; nothing comes over it.
    QVERIFY(send(client, HttpMethod::Get, server.url(), {}).ok());
    QCOMPARE(server.methods, (QList<QByteArray>{"GET", name, name, "GET"}));
  }

  void aChangeIsNotLostOnAnIdleConnectionThatIsClosed() {
    KeepingServer server({});
    HttpClient client(server.url(), "", nullptr);
    for (int times = 0; times < 5; ++times) {
      QVERIFY(send(client, HttpMethod::Get, server.url(), {}).ok());
      server.closeIdle();
      QVERIFY(send(client, HttpMethod::Patch, server.url(), "{}").ok());
    }
    QCOMPARE(server.methods.count("PATCH"), 5);
  }

  void redirectsAreNotFollowed() {
    for (const int status : {301, 303, 307, 308}) {
      ScriptedServer server([status](const SeenRequest&) {
        return ScriptedServer::reply(status, "Location: /elsewhere\r\n", "");
      });
      HttpClient client(server.url(), "", nullptr);
      const HttpAnswer answer = send(client, HttpMethod::Post, server.url(), "{\"a\":1}");
      QVERIFY2(answer.kind == Kind::Refused, qPrintable(QString::number(status)));
      QVERIFY(answer.sent);
      QCOMPARE(answer.status, status);
      QCOMPARE(server.seen.size(), 1);
    }
  }

  void whatFindsNobodyWasNotSent_data() { methods(); }
  void whatFindsNobodyWasNotSent() {
    QFETCH(HttpMethod, method);
    QTcpServer gone;
    QVERIFY(gone.listen(QHostAddress::LocalHost));
    const QUrl url(QStringLiteral("http://127.0.0.1:%1/").arg(gone.serverPort()));
    gone.close();
    HttpClient client(url, "", nullptr);
    for (const QByteArray& body : {QByteArray("{}"), QByteArray()}) {
      const HttpAnswer answer = send(client, method, url, body);
      QCOMPARE(answer.kind, Kind::Unreachable);
      QVERIFY(!answer.sent);
    }
  }

  void whatIsCancelledBeforeItsTurnWasNotSent() {
    ScriptedServer server([](const SeenRequest&) { return QByteArray(); });
    HttpClient client(server.url(), "", nullptr);
    std::vector<Asked> before(HttpClient::kInFlight);
    for (Asked& one : before) client.send(one.request(HttpMethod::Get, server.url(), {}), one.reply());
    Asked waiting;
    const auto id = client.send(waiting.request(HttpMethod::Post, server.url(), "{}"), waiting.reply());
    QTRY_COMPARE_WITH_TIMEOUT(server.seen.size(), HttpClient::kInFlight, kPatienceMs);
    client.cancel(id);
    QVERIFY(!waiting.answer);  // never from within
    QVERIFY(waiting.wait());
    QCOMPARE(waiting.answer->kind, Kind::Cancelled);
    QVERIFY(!waiting.answer->sent);
    QCOMPARE(server.seen.size(), HttpClient::kInFlight);
  }

  void whatIsCancelledOrTimesOutAfterItWasReadWasSent() {
    for (const bool cancels : {true, false}) {
      ScriptedServer server([](const SeenRequest&) { return QByteArray(); });
      HttpClient client(server.url(), "", nullptr);
      Asked asked;
      HttpRequest request = asked.request(HttpMethod::Patch, server.url(), "{}");
      if (!cancels) request.timeout = std::chrono::milliseconds(200);
      const auto id = client.send(request, asked.reply());
      QTRY_COMPARE_WITH_TIMEOUT(server.seen.size(), 1, kPatienceMs);
      if (cancels) client.cancel(id);
      QVERIFY(asked.wait());
      QCOMPARE(asked.answer->kind, cancels ? Kind::Cancelled : Kind::TimedOut);
      QVERIFY(asked.answer->sent);
      client.cancel(id);
      QCOMPARE(asked.replies, 1);
    }
  }

  void whatIsNeverAcceptedTimesOutUnsent() {
    // Listens and never reads: with a full queue nobody gets a connection.
    QTcpServer server;
    server.setListenBacklogSize(1);
    QVERIFY(server.listen(QHostAddress::LocalHost));
    server.pauseAccepting();
    std::vector<std::unique_ptr<QTcpSocket>> queue;
    for (int i = 0; i < 4; ++i) {
      queue.push_back(std::make_unique<QTcpSocket>());
      queue.back()->connectToHost(QHostAddress::LocalHost, server.serverPort());
    }
    QTRY_VERIFY_WITH_TIMEOUT(queue.front()->state() == QAbstractSocket::ConnectedState, kPatienceMs);
    const QUrl url(QStringLiteral("http://127.0.0.1:%1/").arg(server.serverPort()));
    HttpClient client(url, "", nullptr);
    Asked asked;
    HttpRequest request = asked.request(HttpMethod::Patch, url, "{}");
    request.timeout = std::chrono::milliseconds(300);
    client.send(request, asked.reply());
    QVERIFY(asked.wait());
    QCOMPARE(asked.answer->kind, Kind::TimedOut);
    QVERIFY(!asked.answer->sent);
  }

  void progressIsToldUpAndDown() {
    const QByteArray body(1'000'000, 'x');
    ScriptedServer server(
        [](const SeenRequest&) { return ScriptedServer::reply(200, "", QByteArray(2'000'000, 'y')); });
    HttpClient client(server.url(), "", nullptr);
    Asked asked;
    client.send(asked.request(HttpMethod::Post, server.url(), body), asked.reply());
    QVERIFY(asked.wait());
    QVERIFY2(asked.answer->ok(), qPrintable(argumentsOf(asked.answer->reason).join(QLatin1Char('|'))));
    qint64 up = 0, down = 0;
    for (const HttpProgress& one : std::as_const(asked.progress)) {
      qint64& before = one.up ? up : down;
      QVERIFY(one.bytes >= before);
      QVERIFY(!one.up || down == 0);
      before = one.bytes;
      QCOMPARE(one.of_bytes.value_or(-1), one.up ? 1'000'000 : 2'000'000);
    }
    QCOMPARE(up, 1'000'000);
    QCOMPARE(down, 2'000'000);
  }

  void aStatusThatCameStaysKnownWhenTheAnswerBreaksOff() {
    ScriptedServer server([](const SeenRequest&) {
      return QByteArray("HTTP/1.1 200 OK\r\nConnection: close\r\nContent-Length: 100\r\n\r\nhalf");
    });
    HttpClient client(server.url(), "", nullptr);
    const HttpAnswer answer = send(client, HttpMethod::Patch, server.url(), "{}");
    QCOMPARE(answer.kind, Kind::Unreachable);
    QCOMPARE(answer.status, 200);
    QVERIFY(answer.sent);
  }

  void aClientThatGoesWithItsThreadLeavesNothingOfWhatIsInProgress() {
    // Those of earlier tests end on their own.
    QTRY_COMPARE_WITH_TIMEOUT(networkThreads(), 0, kPatienceMs);
    ScriptedServer silent([](const SeenRequest&) { return QByteArray(); });
    QThread thread;
    auto* const keeper = new QObject;
    keeper->moveToThread(&thread);
    connect(&thread, &QThread::finished, keeper, &QObject::deleteLater);
    thread.start();
    QMetaObject::invokeMethod(keeper, [keeper, url = silent.url()] {
      auto* const client = new HttpClient(url, "", nullptr, keeper);
      HttpRequest request;
      request.method = HttpMethod::Post;
      request.url = url;
      client->send(request, [](const HttpAnswer&) {});
    });
    QTRY_COMPARE_WITH_TIMEOUT(silent.seen.size(), 1, kPatienceMs);
    QCOMPARE(networkThreads(), 1);
    thread.quit();
    QVERIFY(thread.wait(kPatienceMs));
    QTRY_COMPARE_WITH_TIMEOUT(networkThreads(), 0, kPatienceMs);
  }
};

}  // namespace test_http_changes

MAPWRIGHT_TEST(test_http_changes, TestHttpChanges, Core)
#include "test_http_changes.moc"
