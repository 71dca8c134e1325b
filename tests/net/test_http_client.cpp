#include <optional>

#include <QTemporaryDir>
#include <QTimeZone>
#include <QtTest>

#include "fault_arguments.h"
#include "net/http_cache.h"
#include "net/http_client.h"
#include "scripted_server.h"
#include "test_program.h"

namespace test_http_client {

using namespace mapwright;
using namespace mapwright::net;
using testing::ScriptedServer;
using testing::SeenRequest;
using Kind = HttpAnswer::Kind;

namespace {

/// One request and what came of it.
struct Asked {
  int replies = 0;
  HttpAnswer answer;
  HttpClient::Reply reply() {
    return [this](HttpAnswer given) {
      ++replies;
      answer = std::move(given);
    };
  }
};

HttpAnswer ask(HttpClient& client, HttpRequest request) {
  Asked asked;
  client.send(request, asked.reply());
  const bool immediate = asked.replies != 0;
  const bool arrived = QTest::qWaitFor([&] { return asked.replies > 0; }, 20'000);
  if (immediate || !arrived || asked.replies != 1) {
    HttpAnswer wrong;
    wrong.reason = faultOf(mapwright::fault::Said,
                           {QStringLiteral("not answered exactly once and later: %1").arg(asked.replies)});
    return wrong;
  }
  return asked.answer;
}

HttpRequest to(const QUrl& url, bool cacheable = false) {
  HttpRequest request;
  request.url = url;
  request.cacheable = cacheable;
  return request;
}

}  // namespace

class TestHttpClient : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void asksAndTellsTheAnswer() {
    ScriptedServer server([](const SeenRequest&) {
      return ScriptedServer::reply(200, "Content-Type: application/x-protobuf\r\n", "body");
    });
    HttpClient client(server.url(), "hush", nullptr);
    HttpRequest request = to(server.url(QStringLiteral("/a?b=c")));
    request.accept = "application/x-protobuf";
    const HttpAnswer answer = ask(client, request);
    QVERIFY(answer.ok());
    QCOMPARE(answer.body, QByteArray("body"));
    QCOMPARE(answer.content_type, QByteArray("application/x-protobuf"));
    QVERIFY(!answer.from_cache);
    QVERIFY(!answer.reason.any());
    QCOMPARE(server.seen.size(), 1);
    QCOMPARE(server.seen[0].path, QByteArray("/a?b=c"));
    QCOMPARE(server.seen[0].headers.value("accept"), QByteArray("application/x-protobuf"));
    QCOMPARE(server.seen[0].headers.value("secret"), QByteArray("hush"));
  }

  void errorsCarryTheRobotsWords() {
    ScriptedServer server([](const SeenRequest&) {
      return ScriptedServer::reply(404, "Content-Type: application/json\r\n",
                                   R"({"detail":"No <b>such</b> map"})");
    });
    HttpClient client(server.url(), "hush", nullptr);
    const HttpAnswer answer = ask(client, to(server.url()));
    QCOMPARE(answer.kind, Kind::Answered);
    QCOMPARE(answer.status, 404);
    QVERIFY(!answer.ok());
    QCOMPARE(answer.reason, Fault(net::fault::AnsweredWithStatusSaying, {HttpStatus{404}, "No such map"}));
  }

  void everyStatusIsAnAnswer() {
    for (const int status : {400, 402, 408, 418, 422, 425, 429, 451, 499, 500, 505, 511, 599}) {
      ScriptedServer server(
          [status](const SeenRequest&) { return ScriptedServer::reply(status, {}, "why"); });
      HttpClient client(server.url(), "", nullptr);
      const HttpAnswer answer = ask(client, to(server.url()));
      QCOMPARE(answer.kind, Kind::Answered);
      QCOMPARE(answer.status, status);
      QCOMPARE(answer.said, QStringLiteral("why"));
    }
  }

  void theSecretStaysAtItsOrigin() {
    ScriptedServer elsewhere([](const SeenRequest&) { return ScriptedServer::reply(200, {}, "stolen"); });
    const QByteArray location = elsewhere.url(QStringLiteral("/x")).toEncoded();
    ScriptedServer server([location](const SeenRequest& request) {
      if (request.path == "/away") {
        return ScriptedServer::reply(302, "Location: " + location + "\r\n", {});
      }
      if (request.path == "/here") {
        return ScriptedServer::reply(307, "Location: there?x=1\r\n", {});
      }
      if (request.path.startsWith("/loop")) {
        return ScriptedServer::reply(302, "Location: " + request.path + "x\r\n", {});
      }
      return ScriptedServer::reply(200, {}, "moved");
    });
    HttpClient client(server.url(), "hush", nullptr);

    const HttpAnswer away = ask(client, to(server.url(QStringLiteral("/away"))));
    QCOMPARE(away.kind, Kind::Refused);
    QCOMPARE(away.reason, faultOf(net::fault::LeadsToAnotherServer,
                                  {QStringLiteral("127.0.0.1:%1").arg(elsewhere.port())}));
    QVERIFY(elsewhere.seen.isEmpty());

    const HttpAnswer here = ask(client, to(server.url(QStringLiteral("/here"))));
    QVERIFY2(here.ok(), qPrintable(argumentsOf(here.reason).join(QLatin1Char('|'))));
    QCOMPARE(here.body, QByteArray("moved"));
    QCOMPARE(server.seen.last().path, QByteArray("/there?x=1"));
    QCOMPARE(server.seen.last().headers.value("secret"), QByteArray("hush"));

    const auto before = server.seen.size();
    const HttpAnswer loop = ask(client, to(server.url(QStringLiteral("/loop"))));
    QCOMPARE(loop.kind, Kind::Refused);
    QCOMPARE(server.seen.size(), before + 6);

    // Asked for directly, another origin gets the request but not the secret.
    QVERIFY(ask(client, to(elsewhere.url())).ok());
    QVERIFY(!elsewhere.seen[0].headers.contains("secret"));
  }

  void aSecretCannotAddHeaders() {
    ScriptedServer server([](const SeenRequest&) { return ScriptedServer::reply(200, {}, "x"); });
    HttpClient client(server.url(), "hush\r\nX-Evil: 1", nullptr);
    QVERIFY(ask(client, to(server.url())).ok());
    QVERIFY(!server.seen[0].headers.contains("x-evil"));
  }

  void brokenOffBodiesFail_data() {
    QTest::addColumn<QByteArray>("answer");
    QTest::addRow("content length") << QByteArray("HTTP/1.1 200 OK\r\nContent-Length: 2000\r\n\r\n") +
                                           QByteArray(1000, 'x');
    QTest::addRow("length, closing")
        << QByteArray("HTTP/1.1 200 OK\r\nConnection: close\r\nContent-Length: 2000\r\n\r\n") +
               QByteArray(1000, 'x');
    QTest::addRow("chunks") << QByteArray("HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n3e8\r\n") +
                                   QByteArray(500, 'x');
    QTest::addRow("last chunk missing")
        << QByteArray("HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n3\r\nabc\r\n");
    QTest::addRow("no body at all") << QByteArray("HTTP/1.1 200 OK\r\nContent-Length: 2000\r\n\r\n");
    QTest::addRow("headers") << QByteArray("HTTP/1.1 200 OK\r\nContent-Le");
    QTest::addRow("no HTTP") << QByteArray("SSH-2.0-OpenSSH_9\r\n\r\n");
  }
  void brokenOffBodiesFail() {
    QFETCH(QByteArray, answer);
    ScriptedServer server([answer](const SeenRequest&) { return answer; });
    QTemporaryDir folder;
    HttpCache cache(folder.path(), 1 << 20);
    HttpClient client(server.url(), {}, &cache);
    HttpRequest request = to(server.url(), true);
    request.content_addressed = true;
    const HttpAnswer given = ask(client, request);
    QVERIFY(!given.ok());
    QCOMPARE(given.kind, Kind::Unreachable);
    QVERIFY(given.reason.any());
    QVERIFY(!cache.find(server.url()));
  }

  void aHungUpConnectionIsToldAndNotTriedAgainByItself() {
    int asked = 0;
    ScriptedServer server([&asked](const SeenRequest&) {
      ++asked;
      return ScriptedServer::kHangUp;
    });
    HttpClient client(server.url(), {}, nullptr);
    const HttpAnswer given = ask(client, to(server.url(), false));
    QCOMPARE(given.kind, Kind::Unreachable);
    QVERIFY(given.reason.any());
    QCOMPARE(asked, 1);
  }

  void tooLongBodiesAreCutOff_data() {
    QTest::addColumn<bool>("announced");
    QTest::addRow("announced") << true;
    QTest::addRow("not announced") << false;
  }
  void tooLongBodiesAreCutOff() {
    QFETCH(bool, announced);
    ScriptedServer server([announced](const SeenRequest&) {
      const QByteArray body(3'000'000, 'x');
      return announced ? ScriptedServer::reply(200, {}, body)
                       : "HTTP/1.1 200 OK\r\nConnection: close\r\n\r\n" + body;
    });
    HttpClient client(server.url(), {}, nullptr);
    HttpRequest request = to(server.url());
    request.max_bytes = 2'999'999;
    const HttpAnswer answer = ask(client, request);
    QCOMPARE(answer.kind, Kind::TooLarge);
    QVERIFY(answer.body.isEmpty());
    QCOMPARE(answer.reason, faultOf(mapwright::fault::AnswerTooLong, {QStringLiteral("2,999,999")}));
    request.max_bytes = 3'000'000;
    QCOMPARE(ask(client, request).body.size(), 3'000'000);
  }

  void silenceIsATimeout() {
    ScriptedServer server([](const SeenRequest&) { return QByteArray(); });
    HttpClient client(server.url(), {}, nullptr);
    HttpRequest request = to(server.url());
    request.timeout = std::chrono::milliseconds(50);
    const HttpAnswer answer = ask(client, request);
    QCOMPARE(answer.kind, Kind::TimedOut);
    QCOMPARE(answer.reason, faultOf(net::fault::NoAnswerWithin, {QStringLiteral("50 ms")}));
    QTRY_COMPARE(server.disconnects, 1);  // and the connection is given up
  }

  void nobodyListens() {
    quint16 port = 0;
    {
      ScriptedServer gone([](const SeenRequest&) { return QByteArray(); });
      port = gone.port();
    }
    const QUrl url(QStringLiteral("http://127.0.0.1:%1/").arg(port));
    HttpClient client(url, {}, nullptr);
    const HttpAnswer answer = ask(client, to(url));
    QCOMPARE(answer.kind, Kind::Unreachable);
    QCOMPARE(answer.reason,
             faultOf(net::fault::ConnectionRefused, {QStringLiteral("127.0.0.1:%1").arg(port)}));
    QCOMPARE(answer.status, 0);
  }

  void onlyWebAddressesAreAsked() {
    HttpClient client(QUrl(QStringLiteral("http://robot/")), "hush", nullptr);
    for (const char* url : {"file:///etc/passwd", "ftp://robot/x", "", "data:text/plain,x", "/relative"}) {
      QCOMPARE(ask(client, to(QUrl(QLatin1String(url)))).kind, Kind::Refused);
    }
  }

  void cancellingTellsOnce() {
    ScriptedServer server([](const SeenRequest&) { return QByteArray(); });
    HttpClient client(server.url(), {}, nullptr);
    std::vector<Asked> asked(HttpClient::kInFlight + 4);
    std::vector<HttpClient::RequestId> ids;
    for (Asked& one : asked) {
      ids.push_back(client.send(to(server.url()), one.reply()));
    }
    QTRY_COMPARE(server.seen.size(), qsizetype(HttpClient::kInFlight));  // the others wait
    client.cancel(ids.back());                                           // one that waits
    client.cancel(ids.front());
    client.cancel(ids.front());
    client.cancel(123456);
    QCOMPARE(asked.front().replies, 0);  // never from within
    QTRY_COMPARE(asked.front().replies, 1);
    QTRY_COMPARE(asked.back().replies, 1);
    QCOMPARE(asked.front().answer.kind, Kind::Cancelled);
    QTRY_COMPARE(server.seen.size(), qsizetype(HttpClient::kInFlight + 1));  // the next one's turn
    client.cancelAll();
    client.cancelAll();
    for (Asked& one : asked) {
      QTRY_COMPARE(one.replies, 1);
      QCOMPARE(one.answer.kind, Kind::Cancelled);
    }
    QCoreApplication::processEvents();
    for (const Asked& one : asked) {
      QCOMPARE(one.replies, 1);
    }
  }

  void thoseThatNameANumberKeepToItAndOthersPassThem() {
    ScriptedServer server([](const SeenRequest&) { return QByteArray(); });  // never answers
    HttpClient client(server.url(), {}, nullptr);
    HttpRequest bounded = to(server.url());
    bounded.most_at_once = 2;
    std::vector<Asked> asked(5);
    std::vector<HttpClient::RequestId> ids;
    for (int i = 0; i < 4; ++i) ids.push_back(client.send(bounded, asked[std::size_t(i)].reply()));
    ids.push_back(client.send(to(server.url()), asked[4].reply()));
    QTRY_COMPARE(server.seen.size(), qsizetype(3));  // two of them, and the other one
    client.cancel(ids[4]);
    QTRY_COMPARE(asked[4].replies, 1);
    QCOMPARE(server.seen.size(), qsizetype(3));
    client.cancel(ids[0]);
    QTRY_COMPARE(server.seen.size(), qsizetype(4));  // the next one's turn
    client.cancel(ids[1]);
    QTRY_COMPARE(server.seen.size(), qsizetype(5));
  }

  void cancelledBeforeItBegan() {
    ScriptedServer server([](const SeenRequest&) { return ScriptedServer::reply(200, {}, "x"); });
    HttpClient client(server.url(), {}, nullptr);
    Asked asked;
    client.cancel(client.send(to(server.url()), asked.reply()));
    QTRY_COMPARE(asked.replies, 1);
    QCOMPARE(asked.answer.kind, Kind::Cancelled);
    QVERIFY(ask(client, to(server.url())).ok());
    QCOMPARE(server.seen.size(), 1);
  }

  void aReplyMayDestroyTheClient() {
    ScriptedServer server([](const SeenRequest&) { return ScriptedServer::reply(200, {}, "x"); });
    auto client = std::make_unique<HttpClient>(server.url(), QByteArray(), nullptr);
    int replies = 0;
    for (int i = 0; i < 3; ++i) {
      client->send(to(server.url()), [&](HttpAnswer) {
        ++replies;
        client.reset();
      });
    }
    QTRY_VERIFY(client == nullptr);
    QCoreApplication::processEvents();
    QCOMPARE(replies, 1);
  }

  void freshAnswersDoNotTravel() {
    QDateTime now = QDateTime(QDate(2030, 1, 1), QTime(0, 0), QTimeZone::utc()).toUTC();
    ScriptedServer server([](const SeenRequest& request) {
      if (request.headers.value("if-none-match") == "W/\"v1\"") {
        return QByteArray(
            "HTTP/1.1 304 Not Modified\r\nConnection: close\r\nCache-Control: max-age=60\r\n\r\n");
      }
      return ScriptedServer::reply(
          200, "Cache-Control: max-age=60\r\nETag: W/\"v1\"\r\nContent-Type: a/b\r\n", "one");
    });
    QTemporaryDir folder;
    HttpCache cache(folder.path(), 1 << 20, [&now] { return now; });
    HttpClient client(server.url(), {}, &cache);
    QVERIFY(!ask(client, to(server.url(), true)).from_cache);
    const HttpAnswer fresh = ask(client, to(server.url(), true));
    QVERIFY(fresh.ok() && fresh.from_cache);
    QCOMPARE(fresh.body, QByteArray("one"));
    QCOMPARE(fresh.content_type, QByteArray("a/b"));
    QCOMPARE(server.seen.size(), 1);

    now = now.addSecs(61);
    const HttpAnswer confirmed = ask(client, to(server.url(), true));  // 304
    QVERIFY(confirmed.ok() && confirmed.from_cache);
    QCOMPARE(confirmed.status, 200);
    QCOMPARE(confirmed.body, QByteArray("one"));
    QCOMPARE(server.seen.size(), 2);
    QVERIFY(ask(client, to(server.url(), true)).from_cache);  // fresh again
    QCOMPARE(server.seen.size(), 2);

    QVERIFY(!ask(client, to(server.url(), false)).from_cache);  // told not to look
    QCOMPARE(server.seen.size(), 3);
    QVERIFY(!server.seen[2].headers.contains("if-none-match"));
  }

  void failuresAreNotKept() {
    int status = 500;
    ScriptedServer server([&status](const SeenRequest&) {
      return ScriptedServer::reply(status, "Cache-Control: max-age=60, immutable\r\n", "words");
    });
    QTemporaryDir folder;
    HttpCache cache(folder.path(), 1 << 20);
    HttpClient client(server.url(), {}, &cache);
    for (const int failing : {500, 404, 204, 304}) {
      status = failing;
      QCOMPARE(ask(client, to(server.url(), true)).status, failing);
      QVERIFY(!cache.find(server.url()));
    }
    status = 200;
    QVERIFY(ask(client, to(server.url(), true)).ok());
    QVERIFY(cache.find(server.url())->fresh);
  }
};

}  // namespace test_http_client

MAPWRIGHT_TEST(test_http_client, TestHttpClient, Core)
#include "test_http_client.moc"
