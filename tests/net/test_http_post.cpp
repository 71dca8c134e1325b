#include <QtTest>

#include "net/http_client.h"
#include "scripted_server.h"

using namespace mapwright::net;
using testing::ScriptedServer;
using testing::SeenRequest;

namespace {

HttpAnswer post(HttpClient& client, const QUrl& url, const QByteArray& body) {
  HttpRequest request;
  request.url = url;
  request.body = body;
  std::optional<HttpAnswer> answer;
  client.post(request, [&](HttpAnswer given) { answer = std::move(given); });
  return QTest::qWaitFor([&] { return answer.has_value(); }, 20'000) ? *answer : HttpAnswer();
}

}  // namespace

class TestHttpPost : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theBodyArrivesAsItIs_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::newRow("small") << QByteArray(R"({"map_id":1764059676131})");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("large") << QByteArray(300'000, 'x');
  }
  void theBodyArrivesAsItIs() {
    QFETCH(QByteArray, body);
    ScriptedServer server([](const SeenRequest&) { return ScriptedServer::reply(200, "", "fine"); });
    HttpClient client(server.url(), "hush", nullptr);
    const HttpAnswer answer = post(client, server.url(QStringLiteral("/rpc")), body);
    QVERIFY2(answer.ok(), qPrintable(answer.sentence));
    QCOMPARE(answer.body, QByteArray("fine"));
    QCOMPARE(server.seen.size(), 1);
    QCOMPARE(server.seen[0].method, QByteArray("POST"));
    QCOMPARE(server.seen[0].body, body);
    QCOMPARE(server.seen[0].headers.value("content-type"), QByteArray("application/json"));
    QCOMPARE(server.seen[0].headers.value("secret"), QByteArray("hush"));
  }

  void aConnectionThatClosesIsNotAskedAgain() {
    ScriptedServer server([](const SeenRequest&) { return ScriptedServer::kHangUp; });
    HttpClient client(server.url(), "", nullptr);
    const HttpAnswer answer = post(client, server.url(), "{}");
    QCOMPARE(answer.kind, HttpAnswer::Kind::Unreachable);
    QVERIFY(!answer.sentence.isEmpty());
    QCOMPARE(server.seen.size(), 1);
  }

  void redirectsAreNotFollowed() {
    for (const int status : {301, 303, 307, 308}) {
      ScriptedServer server([status](const SeenRequest&) {
        return ScriptedServer::reply(status, "Location: /elsewhere\r\n", "");
      });
      HttpClient client(server.url(), "", nullptr);
      const HttpAnswer answer = post(client, server.url(), "{\"a\":1}");
      QVERIFY2(answer.kind == HttpAnswer::Kind::Refused, qPrintable(QString::number(status)));
      QCOMPARE(server.seen.size(), 1);
    }
  }
};

QTEST_GUILESS_MAIN(TestHttpPost)
#include "test_http_post.moc"
