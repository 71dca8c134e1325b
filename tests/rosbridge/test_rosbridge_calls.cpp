#include <QtTest>

#include "rosbridge_server.h"
#include "test_program.h"

namespace test_rosbridge_calls {

using namespace mapwright::net::rosbridge;
using testing::quick;
using testing::Replies;
using testing::request;
using testing::RosbridgeServer;
using testing::Seen;
using testing::StandingClock;
using Kind = CallAnswer::Kind;
using State = mapwright::net::WebSocketLink::State;
using std::chrono::milliseconds;

namespace {

/// A text, a few bytes at a time: not where characters end.
struct Letters : ArgsSource {
  explicit Letters(const QString& text) : all(text.toUtf8()) {}
  qint64 bytes() const override { return all.size(); }
  std::optional<QByteArray> next() override {
    if (at >= most) return std::nullopt;
    const QByteArray part = all.mid(at, all.size() > 100'000 ? 30'000 : 11);
    at += part.size();
    return part;
  }
  QByteArray all;
  qsizetype at = 0, most = std::numeric_limits<qsizetype>::max();
};

}  // namespace

class TestRosbridgeCalls : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aCallIsAnswered() {
    RosbridgeServer server;
    server.answer = [&](const Seen& call) { server.reply(call, "{\"result\":2}"); };
    Client client(server.url(), quick());
    Replies replies;
    client.open();
    client.call(request("/map_manager/load_map", "{\"map_id\":\"d8\",\"number\":2.0}"), replies.collect());
    QCOMPARE(replies.all.size(), 0);
    QTRY_COMPARE(replies.all.size(), 1);
    QCOMPARE(replies.all[0].kind, Kind::Answered);
    QVERIFY(replies.all[0].sent);
    QCOMPARE(replies.all[0].values["result"].integer(), 2);
    QCOMPARE(server.seen.size(), 1);
    QCOMPARE(server.seen[0]["op"], QStringLiteral("call_service"));
    QCOMPARE(server.seen[0]["service"], QStringLiteral("/map_manager/load_map"));
    // As the caller wrote it: servers tell 2.0 from 2.
    QVERIFY(server.seen[0].text.contains("\"args\":{\"map_id\":\"d8\",\"number\":2.0}"));
  }

  void howMuchOfAnAnswerHasComeIsTold() {
    RosbridgeServer server;
    Client client(server.url(), quick());
    Replies replies;
    QList<qint64> told;
    CallRequest wanted = request("/get_map", "{}");
    wanted.arriving = [&](qint64 bytes) { told.append(bytes); };
    client.open();
    client.call(wanted, replies.collect());
    QTRY_COMPARE(server.seen.size(), 1);
    const QByteArray answer = "{\"op\":\"service_response\",\"id\":\"" + server.seen[0]["id"].toUtf8() +
                              "\",\"values\":{},\"result\":true}";
    const auto piece = [&](int number, const QByteArray& text) {
      const QJsonObject fragment{{QStringLiteral("op"), QStringLiteral("fragment")},
                                 {QStringLiteral("id"), QStringLiteral("7")},
                                 {QStringLiteral("num"), number},
                                 {QStringLiteral("total"), 2},
                                 {QStringLiteral("data"), QString::fromUtf8(text)}};
      server.say(QJsonDocument(fragment).toJson(QJsonDocument::Compact));
    };
    piece(0, answer.left(20));
    QTRY_VERIFY(!told.isEmpty());
    QVERIFY(told.last() >= 20);
    QCOMPARE(replies.all.size(), 0);
    piece(1, answer.mid(20));
    QTRY_COMPARE(replies.all.size(), 1);
    QCOMPARE(replies.all[0].kind, Kind::Answered);
  }

  void whatIsMadeWhileItTravelsArrivesWhole_data() {
    QTest::addColumn<qint64>("most_whole");
    QTest::addColumn<int>("frames");
    QTest::newRow("in one frame") << qint64(1'000'000) << 1;
    QTest::newRow("in pieces") << qint64(100) << 0;
  }
  void whatIsMadeWhileItTravelsArrivesWhole() {
    QFETCH(qint64, most_whole);
    QFETCH(int, frames);
    RosbridgeServer server;
    QByteArray whole;
    server.answer = [&](const Seen& one) {
      if (one["op"] == QLatin1String("call_service")) whole = one.text;
      if (one["op"] != QLatin1String("fragment")) return;
      whole += one["data"].toUtf8();
      QCOMPARE(one["num"].toInt() + 1, server.all("fragment").size());
      if (one["num"].toInt() + 1 < one["total"].toInt()) return;
      server.reply({one.peer, QJsonDocument::fromJson(whole).object(), whole}, "{}");
    };
    ClientOptions options = quick();
    options.most_whole_bytes = most_whole;
    options.fragment_bytes = 37;
    Client client(server.url(), options);
    Replies replies;
    client.open();
    CallRequest call = request("/map_manager/update_map_image");
    const auto args =
        std::make_shared<Letters>(QStringLiteral("{\"a\":\"") +
                                  QStringLiteral("ä会\U0001F3ED\\\"").repeated(200) + QStringLiteral("\"}"));
    call.made_while_sent = args;
    QList<qint64> travelled;
    call.travelled = [&](qint64 bytes, qint64 of) {
      travelled << bytes;
      QVERIFY(bytes <= of);
    };
    client.call(call, replies.collect());
    QTRY_VERIFY(!whole.isEmpty() && whole.endsWith("\"}}"));
    const QJsonObject read = QJsonDocument::fromJson(whole).object();
    QCOMPARE(read[QLatin1String("service")].toString(), QStringLiteral("/map_manager/update_map_image"));
    QCOMPARE(QJsonDocument(read[QLatin1String("args")].toObject()).toJson(QJsonDocument::Compact), args->all);
    if (frames == 1) {
      QCOMPARE(server.seen.size(), 1);
      server.reply(server.seen[0], "{}");
    } else {
      QVERIFY(server.all("fragment").size() > 10);
    }
    QTRY_COMPARE(replies.all.size(), 1);
    QCOMPARE(replies.all[0].kind, Kind::Answered);
    QVERIFY(!travelled.isEmpty() && std::is_sorted(travelled.begin(), travelled.end()));
  }

  void whatIsNotSentToItsEndHasNotBeenSent_data() {
    QTest::addColumn<QString>("how");
    for (const char* how : {"its maker gives up", "it is cancelled", "the link is lost"})
      QTest::newRow(how) << QString::fromLatin1(how);
  }
  void whatIsNotSentToItsEndHasNotBeenSent() {
    QFETCH(QString, how);
    RosbridgeServer server;
    ClientOptions options = quick();
    options.most_whole_bytes = 100;
    options.fragment_bytes = 64 * 1024;
    Client client(server.url(), options);
    Replies replies;
    client.open();
    CallRequest call = request("/x");
    // More than the system takes at once.
    const auto args = std::make_shared<Letters>(
        QStringLiteral("{\"a\":\"") + QString(40'000'000, QLatin1Char('a')) + QStringLiteral("\"}"));
    if (how == QLatin1String("its maker gives up")) args->most = 1'000'000;
    call.made_while_sent = args;
    const quint64 number = client.call(call, replies.collect());
    server.answer = [&](const Seen& one) {
      if (one["num"].toInt() != 2) return;
      if (how == QLatin1String("it is cancelled")) client.cancel(number);
      if (how == QLatin1String("the link is lost")) server.dropAll();
    };
    QTRY_COMPARE(replies.all.size(), 1);
    QVERIFY(!replies.all[0].sent);
    QCOMPARE(replies.all[0].kind,
             how == QLatin1String("the link is lost") ? Kind::LinkLost : Kind::Cancelled);
    // Other calls are not touched by that.
    server.answer = [&](const Seen& one) {
      if (one["service"] == QLatin1String("/y")) server.reply(one, "{}");
    };
    QTRY_COMPARE(client.link().state(), State::Open);
    client.call(request("/y"), replies.collect());
    QTRY_COMPARE(replies.all.size(), 2);
    QCOMPARE(replies.all[1].kind, Kind::Answered);
  }

  void answersMayComeInAnyOrder() {
    RosbridgeServer server;
    Client client(server.url(), quick());
    client.open();
    QStringList got;
    for (const char* name : {"/a", "/b", "/c"}) {
      client.call(request(name), [&got, name](const CallAnswer& answer) {
        got << QLatin1String(name) + QString::fromStdString(answer.values["of"].text());
      });
    }
    QTRY_COMPARE(server.seen.size(), 3);
    for (const int i : {2, 0, 1}) {
      server.reply(server.seen[i], "{\"of\":\"" + server.seen[i]["service"].toUtf8() + "\"}");
    }
    QTRY_COMPARE(got.size(), 3);
    QCOMPARE(got, QStringList({QStringLiteral("/c/c"), QStringLiteral("/a/a"), QStringLiteral("/b/b")}));
  }

  void idsAreNeverUsedAgain() {
    RosbridgeServer server;
    server.answer = [&](const Seen& call) { server.reply(call, "{}"); };
    Client client(server.url(), quick());
    Replies replies;
    client.open();
    client.call(request("/a"), replies.collect());
    QTRY_COMPARE(replies.all.size(), 1);
    server.dropAll();
    QTRY_VERIFY(client.link().state() != State::Open);
    QTRY_COMPARE(client.link().state(), State::Open);
    client.call(request("/b"), replies.collect());
    QTRY_COMPARE(replies.all.size(), 2);
    QVERIFY(server.seen[0]["id"] != server.seen[1]["id"]);
    QVERIFY(!server.seen[0]["id"].isEmpty());
  }

  void aRefusalTellsTheInnerWords() {
    RosbridgeServer server;
    Client client(server.url(), quick());
    Replies replies;
    client.open();
    for (int i = 0; i < 5; ++i) client.call(request("/x"), replies.collect());
    QTRY_COMPARE(server.seen.size(), 5);
    server.reply(server.seen[0], "\"Service \\/no\\/such does not exist\"", "false");
    server.reply(server.seen[1],
                 "\"service [/x] responded with an error: b'map \\\\'Hof\\\\' \\\\xc3\\\\xa4'\"", "false");
    server.reply(server.seen[2], "{\"why\":1}", "false");
    server.reply(server.seen[3], "null", "false");
    server.reply(server.seen[4], "\"transport error completing service call: x\"", "false");
    QTRY_COMPARE(replies.all.size(), 5);
    QStringList words;
    for (const CallAnswer& answer : replies.all) {
      QCOMPARE(answer.kind, Kind::Refused);
      QVERIFY(answer.sent);  // it does not prove that nothing was done
      words << QString::fromStdString(answer.words);
    }
    QCOMPARE(words[0], QStringLiteral("Service /no/such does not exist"));
    QCOMPARE(words[1], QStringLiteral("map 'Hof' ä"));
    QCOMPARE(words[2], QStringLiteral("{\"why\":1}"));
    QCOMPARE(words[3], QString());
    QCOMPARE(words[4], QStringLiteral("transport error completing service call: x"));
  }

  void theCodeOfTheServiceIsNotTheResultOfTheCall() {
    RosbridgeServer server;
    server.answer = [&](const Seen& call) { server.reply(call, "{\"result\":false}"); };
    Client client(server.url(), quick());
    Replies replies;
    client.open();
    client.call(request("/x"), replies.collect());
    QTRY_COMPARE(replies.all.size(), 1);
    QCOMPARE(replies.all[0].kind, Kind::Answered);
    QCOMPARE(replies.all[0].values["result"].flag(), false);
  }

  void valuesMayBeTextAndTheResultMayBeAbsent() {
    RosbridgeServer server;
    Client client(server.url(), quick());
    Replies replies;
    client.open();
    for (int i = 0; i < 4; ++i) client.call(request("/x"), replies.collect());
    QTRY_COMPARE(server.seen.size(), 4);
    server.reply(server.seen[0], "\"fine\"");
    const auto answer = [&](int i, const QByteArray& rest) {
      server.say("{\"op\":\"service_response\",\"id\":\"" + server.seen[i]["id"].toUtf8() + "\"" + rest +
                 "}");
    };
    answer(1, ",\"values\":{\"a\":1}");
    answer(2, ",\"values\":\"what?\"");
    answer(3, ",\"values\":{},\"result\":\"maybe\"");
    QTRY_COMPARE(replies.all.size(), 4);
    QCOMPARE(replies.all[0].values.text(), std::string("fine"));
    QCOMPARE(replies.all[1].kind, Kind::Answered);
    QCOMPARE(replies.all[1].values["a"].integer(), 1);
    QCOMPARE(replies.all[2].kind, Kind::Malformed);
    QVERIFY(replies.all[2].sent && !replies.all[2].words.empty());
    QCOMPARE(replies.all[3].kind, Kind::Malformed);
  }

  void anAnswerWithoutAnIdBelongsToTheOnlyCallOfItsService() {
    RosbridgeServer server;
    Client client(server.url(), quick());
    Replies replies;
    client.open();
    client.call(request("/a"), replies.collect());
    client.call(request("/b"), replies.collect());
    client.call(request("/b"), replies.collect());
    QTRY_COMPARE(server.seen.size(), 3);
    server.say(R"({"op":"service_response","service":"\/b","values":{},"result":true})");
    server.say(R"({"op":"service_response","service":"\/a","values":{"a":1},"result":true})");
    QTRY_COMPARE(replies.all.size(), 1);
    QCOMPARE(replies.all[0].values["a"].integer(), 1);
    QCOMPARE(client.oddities(), quint64(1));  // one of two
  }

  void anAnswerToNothingIsOdd() {
    RosbridgeServer server;
    Client client(server.url(), quick());
    QList<Oddity> odd;
    connect(&client, &Client::odd, this, [&](Oddity what, const QString&) { odd << what; });
    client.open();
    QTRY_COMPARE(client.link().state(), State::Open);
    QTRY_COMPARE(server.peers.size(), 1);
    server.say(R"({"op":"service_response","id":"c77","values":{},"result":true})");
    QTRY_COMPARE(odd, QList<Oddity>{Oddity::UnknownCall});
  }

  void onlySoManyAreInProgress() {
    RosbridgeServer server;
    ClientOptions options = quick();
    options.calls_at_once = 3;
    Client client(server.url(), options);
    Replies replies;
    client.open();
    for (int i = 0; i < 7; ++i) client.call(request("/" + std::to_string(i)), replies.collect());
    QTRY_COMPARE(server.seen.size(), 3);
    server.reply(server.seen[1], "{}");
    QTRY_COMPARE(server.seen.size(), 4);
    QCOMPARE(server.seen[3]["service"], QStringLiteral("/3"));
    server.answer = [&](const Seen& call) { server.reply(call, "{}"); };
    for (const int i : {0, 2, 3}) server.reply(server.seen[i], "{}");
    QTRY_COMPARE(replies.all.size(), 7);
    QCOMPARE(server.seen.size(), 7);
  }

  void anAnswerThatDoesNotComeIsNotWaitedFor() {
    StandingClock clock;
    RosbridgeServer server;
    Client client(server.url(), quick(clock));
    Replies replies;
    client.open();
    CallRequest patient = request("/patient");
    patient.timeout = milliseconds(60'000);
    client.call(request("/a"), replies.collect());
    client.call(patient, replies.collect());
    QTRY_COMPARE(server.seen.size(), 2);
    clock.pass(milliseconds(9'999));
    QVERIFY(clock.seen());
    QCOMPARE(replies.all.size(), 0);
    clock.pass(milliseconds(1));
    QTRY_COMPARE(replies.all.size(), 1);
    QCOMPARE(replies.all[0].kind, Kind::TimedOut);
    QVERIFY(replies.all[0].sent);
    server.reply(server.seen[0], "{}");  // too late
    server.reply(server.seen[1], "{}");
    QTRY_COMPARE(replies.all.size(), 2);
    QCOMPARE(replies.all[1].kind, Kind::Answered);
    QCOMPARE(client.oddities(), quint64(0));
  }

  void whatWasGivenUpKeepsTheServerBusyUntilItAnswers() {
    StandingClock clock;
    RosbridgeServer server;
    ClientOptions options = quick(clock);
    options.calls_at_once = 1;
    Client client(server.url(), options);
    Replies replies;
    client.open();
    client.call(request("/a"), replies.collect());
    client.call(request("/b"), replies.collect());
    client.call(request("/c"), replies.collect());
    QTRY_COMPARE(server.seen.size(), 1);
    clock.pass(milliseconds(10'000));
    QTRY_COMPARE(replies.all.size(), 1);
    QVERIFY(clock.seen() && server.settled());
    QCOMPARE(server.seen.size(), 1);
    server.reply(server.seen[0], "{}");
    QTRY_COMPARE(server.seen.size(), 2);
    clock.pass(milliseconds(10'000));
    QTRY_COMPARE(replies.all.size(), 2);
    clock.pass(options.busy_after_giving_up);
    QTRY_COMPARE(server.seen.size(), 3);
  }

  void aCallCanBeCancelled() {
    RosbridgeServer server;
    ClientOptions options = quick();
    options.calls_at_once = 1;
    Client client(server.url(), options);
    Replies replies;
    client.open();
    const quint64 sent = client.call(request("/a"), replies.collect());
    const quint64 waiting = client.call(request("/b"), replies.collect());
    QTRY_COMPARE(server.seen.size(), 1);
    client.cancel(waiting);
    client.cancel(sent);
    client.cancel(sent);
    client.cancel(12345);
    QCOMPARE(replies.all.size(), 0);
    QTRY_COMPARE(replies.all.size(), 2);
    QCOMPARE(replies.all[0].kind, Kind::Cancelled);
    QVERIFY(!replies.all[0].sent && replies.all[1].sent);
    server.reply(server.seen[0], "{}");
    client.call(request("/c"), replies.collect());
    QTRY_COMPARE(server.seen.size(), 2);
    QCOMPARE(server.seen[1]["service"], QStringLiteral("/c"));
    QCOMPARE(replies.all.size(), 2);
  }

  void withoutAConnectionACallFailsLater() {
    Client client(QUrl(QStringLiteral("ws://127.0.0.1:1")), quick());
    Replies replies;
    client.call(request("/a"), replies.collect());
    QCOMPARE(replies.all.size(), 0);
    QTRY_COMPARE(replies.all.size(), 1);
    QCOMPARE(replies.all[0].kind, Kind::LinkLost);
    QVERIFY(!replies.all[0].sent);
    client.open();
    client.call(request("/a"), replies.collect());  // waits for what is being tried
    QTRY_COMPARE(replies.all.size(), 2);
    QCOMPARE(replies.all[1].kind, Kind::LinkLost);
    QVERIFY(!replies.all[1].sent);
  }

  void aLostConnectionEndsWhatIsInProgress() {
    RosbridgeServer server;
    ClientOptions options = quick();
    options.calls_at_once = 1;
    Client client(server.url(), options);
    Replies replies;
    client.open();
    client.call(request("/a"), replies.collect());
    client.call(request("/b"), replies.collect());
    QTRY_COMPARE(server.seen.size(), 1);
    server.dropAll();
    QTRY_COMPARE(replies.all.size(), 2);
    QCOMPARE(replies.all[0].kind, Kind::LinkLost);
    QVERIFY(replies.all[0].sent);
    QCOMPARE(replies.all[1].kind, Kind::LinkLost);
    QVERIFY(!replies.all[1].sent);
    QTRY_COMPARE(client.link().state(), State::Open);
    client.call(request("/c"), replies.collect());
    QTRY_COMPARE(server.seen.size(), 2);
  }

  void closingEndsAllCalls() {
    RosbridgeServer server;
    Client client(server.url(), quick());
    Replies replies;
    client.open();
    client.call(request("/a"), replies.collect());
    QTRY_COMPARE(server.seen.size(), 1);
    client.close();
    QCOMPARE(replies.all.size(), 0);
    QTRY_COMPARE(replies.all.size(), 1);
    QCOMPARE(replies.all[0].kind, Kind::LinkLost);
    QCOMPARE(client.link().state(), State::Closed);
  }

  void noReplyComesAfterTheClientIsGone() {
    RosbridgeServer server;
    server.answer = [&](const Seen& call) { server.reply(call, "{}"); };
    Replies replies;
    auto client = std::make_unique<Client>(server.url(), quick());
    client->open();
    client->call(request("/a"), [&](const CallAnswer& answer) {
      replies.all << answer;
      client.reset();
    });
    client->call(request("/b"), replies.collect());
    QTRY_COMPARE(replies.all.size(), 1);
    QCOMPARE(client, nullptr);
    QTRY_COMPARE(server.peers[0]->state(), QAbstractSocket::UnconnectedState);
    QCOMPARE(replies.all.size(), 1);
  }

  void whatCannotBeAnsweredIsNotSent() {
    RosbridgeServer server;
    Client client(server.url(), quick());
    Replies replies;
    client.open();
    QTRY_COMPARE(client.link().state(), State::Open);
    for (const char* args : {"", "[]", "{\"a\":NaN}", "{}{}", "{},\"op\":\"publish\""}) {
      client.call(request("/a", args), replies.collect());
    }
    client.call(request(""), replies.collect());
    QTRY_COMPARE(replies.all.size(), 6);
    for (const CallAnswer& answer : replies.all) {
      QCOMPARE(answer.kind, Kind::Malformed);
      QVERIFY(!answer.sent);
    }
    QCOMPARE(server.seen.size(), 0);
  }

  void largeAnswersComeByAConnectionOfTheirOwn() {
    RosbridgeServer server;
    server.answer = [&](const Seen& call) { server.reply(call, "{}"); };
    Client client(server.url(), quick());
    Replies replies;
    client.open();
    client.call(request("/small"), replies.collect());
    QTRY_COMPARE(replies.all.size(), 1);
    QCOMPARE(server.peers.size(), 1);
    QCOMPARE(client.largeLink().state(), State::Closed);
    CallRequest large = request("/large");
    large.large = true;
    client.call(large, replies.collect());
    QTRY_COMPARE(replies.all.size(), 2);
    QCOMPARE(replies.all[1].kind, Kind::Answered);
    QCOMPARE(server.peers.size(), 2);
    QCOMPARE(server.seen[1].peer, 1);
    QCOMPARE(server.seen[0].peer, 0);
    client.close();
    QCOMPARE(client.largeLink().state(), State::Closed);
    client.call(large, replies.collect());
    QTRY_COMPARE(replies.all.size(), 3);
    QCOMPARE(replies.all[2].kind, Kind::LinkLost);
  }
};

}  // namespace test_rosbridge_calls

MAPWRIGHT_TEST(test_rosbridge_calls, TestRosbridgeCalls, Core)
#include "test_rosbridge_calls.moc"
