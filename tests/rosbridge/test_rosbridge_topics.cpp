#include <QCryptographicHash>
#include <QSignalSpy>
#include <QtTest>

#include "../net/fault_arguments.h"
#include "frames_for_tests.h"
#include "net/faults.h"
#include "rosbridge_server.h"
#include "test_program.h"

namespace test_rosbridge_topics {

using namespace mapwright;
using namespace mapwright::net::rosbridge;
using testing::pieceFrame;
using testing::quick;
using testing::Replies;
using testing::request;
using testing::RosbridgeServer;
using testing::Seen;
using testing::StandingClock;
using State = mapwright::net::WebSocketLink::State;
using std::chrono::milliseconds;

namespace {

Subscription topic(const std::string& name, const std::string& type = {}) {
  Subscription wanted;
  wanted.topic = name;
  wanted.type = type;
  return wanted;
}

/// A client, what it received, and its server.
struct Heard {
  explicit Heard(ClientOptions options = quick()) : client(server.url(), std::move(options)) {
    QObject::connect(&client, &Client::received, &client,
                     [this](const TopicMessage& message) { messages << message; });
    QObject::connect(&client, &Client::odd, &client, [this](Oddity what, const QString&) { odd << what; });
  }
  RosbridgeServer server;
  Client client;
  QList<TopicMessage> messages;
  QList<Oddity> odd;
};

}  // namespace

class TestRosbridgeTopics : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aSubscriptionIsSentAndItsMessagesCome() {
    Heard heard;
    Subscription wanted = topic("/map_manager/map_list", "kabam_msgs/MapList");
    wanted.throttle_ms = 200;
    heard.client.subscribe(wanted);
    heard.client.subscribe(topic("/plain"));
    heard.client.open();
    QTRY_COMPARE(heard.server.seen.size(), 2);
    const Seen& sent = heard.server.seen[0];
    QCOMPARE(sent["op"], QStringLiteral("subscribe"));
    QCOMPARE(sent["topic"], QStringLiteral("/map_manager/map_list"));
    QCOMPARE(sent["type"], QStringLiteral("kabam_msgs/MapList"));
    QCOMPARE(sent.request[QLatin1String("throttle_rate")].toInt(), 200);
    QCOMPARE(sent.request[QLatin1String("queue_length")].toInt(), 1);  // else the last would be dropped
    heard.server.say("{\"op\":\"status\",\"level\":\"error\",\"msg\":\"no such type\",\"id\":\"" +
                     sent["id"].toUtf8() + "\"}");
    QTRY_COMPARE(heard.client.refusalOf("/map_manager/map_list"), QStringLiteral("no such type"));
    QCOMPARE(heard.client.refusalOf("/plain"), QString());
    for (const char* absent : {"type", "throttle_rate", "queue_length", "fragment_size", "compression"}) {
      QVERIFY2(!heard.server.seen[1].request.contains(QLatin1String(absent)), absent);
    }
    const QByteArray text = R"({"op":"publish","topic":"\/map_manager\/map_list","msg":{"maps":[1]}})";
    heard.server.say(text);
    QTRY_COMPARE(heard.messages.size(), 1);
    QCOMPARE(heard.client.refusalOf("/map_manager/map_list"), QString());
    QCOMPARE(heard.messages[0].topic, std::string("/map_manager/map_list"));
    QCOMPARE(heard.messages[0].msg["maps"].size(), std::size_t(1));
    QCOMPARE(heard.messages[0].bytes, qint64(text.size()));
    QCOMPARE(heard.messages[0].received_s, 1'700'000'000.5);
    QVERIFY(!heard.messages[0].binary);
  }

  void aNameWithoutItsSlashIsTheSame() {
    Heard heard;
    heard.client.subscribe(topic("tf"));
    heard.client.open();
    QTRY_COMPARE(heard.server.seen.size(), 1);
    heard.server.say(R"({"op":"publish","topic":"/tf","msg":{}})");
    QTRY_COMPARE(heard.messages.size(), 1);
    QCOMPARE(heard.messages[0].topic, std::string("tf"));
  }

  void subscriptionsAreSentAgainAfterTheServerHasRestarted() {
    Heard heard;
    QSignalSpy opened(&heard.client, &Client::opened);
    heard.client.subscribe(topic("/a"));
    heard.client.open();
    QTRY_COMPARE(heard.server.seen.size(), 1);
    const QString first = heard.server.seen[0]["id"];
    heard.server.dropAll();
    QTRY_COMPARE(heard.server.seen.size(), 2);
    QCOMPARE(heard.server.seen[1]["topic"], QStringLiteral("/a"));
    QVERIFY(heard.server.seen[1]["id"] != first);
    QTRY_COMPARE(opened.size(), 2);
    heard.server.say(R"({"op":"publish","topic":"/a","msg":{}})");
    QTRY_COMPARE(heard.messages.size(), 1);
  }

  void subscribingAgainReplaces() {
    Heard heard;
    heard.client.open();
    heard.client.subscribe(topic("/a"));
    QTRY_COMPARE(heard.server.seen.size(), 1);
    heard.client.subscribe(topic("/a"));  // the same: nothing
    heard.client.subscribe(topic("/a", "pkg/Type"));
    QTRY_COMPARE(heard.server.seen.size(), 3);
    QCOMPARE(heard.server.seen[1]["op"], QStringLiteral("unsubscribe"));
    QCOMPARE(heard.server.seen[1]["id"], heard.server.seen[0]["id"]);
    QCOMPARE(heard.server.seen[2]["type"], QStringLiteral("pkg/Type"));
  }

  void whatIsUnsubscribedIsNotHeard() {
    Heard heard;
    heard.client.open();
    heard.client.subscribe(topic("/a"));
    heard.client.subscribe(topic("/b"));
    QTRY_COMPARE(heard.server.seen.size(), 2);
    heard.client.unsubscribe("/a");
    heard.client.unsubscribe("/never");
    QTRY_COMPARE(heard.server.seen.size(), 3);
    QCOMPARE(heard.server.seen[2]["op"], QStringLiteral("unsubscribe"));
    QCOMPARE(heard.server.seen[2]["topic"], QStringLiteral("/a"));
    heard.server.say(R"({"op":"publish","topic":"/a","msg":{}})");
    heard.server.say(R"({"op":"publish","topic":"/b","msg":{}})");
    QTRY_COMPARE(heard.messages.size(), 1);
    QCOMPARE(heard.messages[0].topic, std::string("/b"));
    QCOMPARE(heard.odd.size(), 0);
  }

  void largeTopicsComeByAConnectionOfTheirOwn() {
    Heard heard;
    heard.client.open();
    QTRY_COMPARE(heard.client.link().state(), State::Open);
    Subscription grid = topic("/map");
    grid.large = true;
    grid.compression = Subscription::Compression::Cbor;
    heard.client.subscribe(grid);
    QTRY_COMPARE(heard.server.seen.size(), 1);
    QCOMPARE(heard.server.seen[0].peer, 1);
    QCOMPARE(heard.server.seen[0]["compression"], QStringLiteral("cbor"));
    heard.server.sayBytes(testing::written([](QCborStreamWriter& writer) {
                            writer.startMap(3);
                            writer.append(QStringLiteral("op"));
                            writer.append(QStringLiteral("publish"));
                            writer.append(QStringLiteral("topic"));
                            writer.append(QStringLiteral("/map"));
                            writer.append(QStringLiteral("msg"));
                            writer.startMap(1);
                            writer.append(QStringLiteral("data"));
                            writer.append(QCborTag(72));
                            writer.append(QByteArray("\xff\x64"));
                            writer.endMap();
                            writer.endMap();
                          }),
                          1);
    QTRY_COMPARE(heard.messages.size(), 1);
    QVERIFY(heard.messages[0].binary);
    QCOMPARE(heard.messages[0].msg["data"].int8s(2), std::vector<std::int8_t>({-1, 100}));
    grid.large = false;
    grid.compression = Subscription::Compression::Png;
    heard.client.subscribe(grid);
    QTRY_COMPARE(heard.server.seen.size(), 3);
    QCOMPARE(heard.server.all("unsubscribe").value(0).peer, 1);
    QCOMPARE(heard.server.all("subscribe").value(1).peer, 0);
    heard.server.say(testing::pictureFrame(R"({"op":"publish","topic":"/map","msg":{"n":1}})"), 0);
    QTRY_COMPARE(heard.messages.size(), 2);
    QCOMPARE(heard.messages[1].msg["n"].integer(), 1);
    heard.server.say(R"({"op":"publish","topic":"/map","msg":{"n":2}})", 1);  // of the old subscription
    heard.server.say(R"({"op":"publish","topic":"/map","msg":{"n":3}})", 0);
    QTRY_COMPARE(heard.messages.size(), 3);
    QCOMPARE(heard.messages[2].msg["n"].integer(), 3);
  }

  void whenTheLargeConnectionBreaksTheQuickOneGoesOn() {
    Heard heard;
    Subscription grid = topic("/map");
    grid.large = true;
    heard.client.subscribe(grid);
    heard.client.open();
    QTRY_COMPARE(heard.server.seen.size(), 1);
    QTRY_COMPARE(heard.client.link().state(), State::Open);
    QSignalSpy opened(&heard.client, &Client::opened);
    heard.server.peers[heard.server.seen[0].peer]->abort();
    QTRY_COMPARE(heard.server.seen.size(), 2);
    QCOMPARE(heard.server.seen[1]["topic"], QStringLiteral("/map"));
    QCOMPARE(heard.client.link().state(), State::Open);
    QCOMPARE(opened.size(), 0);
  }

  void piecesAreJoinedWhateverTheirOrder() {
    Heard heard;
    heard.client.subscribe(topic("/a"));
    heard.client.open();
    QTRY_COMPARE(heard.server.seen.size(), 1);
    heard.server.say(pieceFrame(0, 2, 3.57, "sg\":{\"n\":7}}"));
    heard.server.say(pieceFrame(0, 0, 3.57, "{\"op\":\"publi"));
    heard.server.say(pieceFrame(0, 1, 3.57, "sh\",\"topic\":\"/a\",\"m"));
    QTRY_COMPARE(heard.messages.size(), 1);
    QCOMPARE(heard.messages[0].msg["n"].integer(), 7);
    heard.server.say(pieceFrame(0, 3, 2, ""));
    QTRY_COMPARE(heard.odd, QList<Oddity>{Oddity::BadFragment});
  }

  void aPieceThatDoesNotComeIsTold() {
    StandingClock clock;
    Heard heard(quick(clock));
    heard.client.open();
    QTRY_COMPARE(heard.server.peers.size(), 1);
    heard.server.say(pieceFrame(QStringLiteral("x"), 0, 2, "{"));
    QVERIFY(heard.server.settled() && clock.seen());
    QCOMPARE(heard.odd.size(), 0);
    clock.pass(milliseconds(31'000));
    QTRY_COMPARE(heard.odd, QList<Oddity>{Oddity::LostFragments});
  }

  void silenceIsKnown() {
    StandingClock clock;
    Heard heard(quick(clock));
    heard.client.subscribe(topic("/a"));
    QVERIFY(!heard.client.silentFor("/a"));
    QVERIFY(!heard.client.silentFor("/other"));
    heard.client.open();
    QTRY_COMPARE(heard.server.seen.size(), 1);
    clock.pass(milliseconds(5'000));
    QCOMPARE(heard.client.silentFor("/a"), milliseconds(5'000));
    heard.server.say(R"({"op":"publish","topic":"/a","msg":{}})");
    QTRY_COMPARE(heard.messages.size(), 1);
    QCOMPARE(heard.client.silentFor("/a"), milliseconds(0));
    heard.client.close();
    QVERIFY(!heard.client.silentFor("/a"));
  }

  void theServersOpinionIsHeard() {
    Heard heard;
    QStringList said;
    connect(
        &heard.client, &Client::statusReceived, this,
        [&](const QString& level, const QString& words, const QString& id) { said << level << words << id; });
    heard.client.open();
    QTRY_COMPARE(heard.server.peers.size(), 1);
    heard.server.say(R"({"op":"status","level":"warning","msg":"<b>slow\u0007</b>","id":5})");
    QTRY_COMPARE(said.size(), 3);
    QCOMPARE(said[0], QStringLiteral("warning"));
    QVERIFY(said[1].contains(QLatin1String("slow")) && !said[1].contains(QLatin1Char('<')));
    QCOMPARE(said[2], QStringLiteral("5"));
    Replies replies;
    heard.client.call(request("/a"), replies.collect());
    QTRY_COMPARE(heard.server.seen.size(), 1);
    heard.server.say("{\"op\":\"status\",\"level\":\"error\",\"msg\":\"no such field\",\"id\":\"" +
                     heard.server.seen[0]["id"].toUtf8() + "\"}");
    QTRY_COMPARE(replies.all.size(), 1);
    QCOMPARE(replies.all[0].kind, CallAnswer::Kind::Refused);
    QCOMPARE(replies.all[0].words, std::string("no such field"));
  }

  void credentialsAreSaidFirst() {
    ClientOptions options = quick();
    Credentials credentials;
    credentials.secret = "hush";
    credentials.client = QStringLiteral("10.0.0.2");
    credentials.destination = QStringLiteral("10.0.0.7");
    credentials.level = QStringLiteral("user");
    credentials.valid_s = 60;
    options.credentials = credentials;
    Heard heard(options);
    heard.client.subscribe(topic("/a"));
    heard.client.open();
    QTRY_COMPARE(heard.server.seen.size(), 2);
    const Seen& auth = heard.server.seen[0];
    QCOMPARE(auth["op"], QStringLiteral("auth"));
    QCOMPARE(auth["t"], QStringLiteral("1700000000"));
    QCOMPARE(auth["end"], QStringLiteral("1700000060"));
    QVERIFY(auth["rand"].size() >= 16);
    const QString signed_text = QStringLiteral("hush") + auth["client"] + auth["dest"] + auth["rand"] +
                                auth["t"] + auth["level"] + auth["end"];
    QCOMPARE(auth["mac"],
             QString::fromLatin1(
                 QCryptographicHash::hash(signed_text.toUtf8(), QCryptographicHash::Sha512).toHex()));
    QVERIFY(!auth.text.contains("hush"));
    QCOMPARE(heard.server.seen[1]["op"], QStringLiteral("subscribe"));
    heard.server.dropAll();
    QTRY_COMPARE(heard.server.all("auth").size(), 2);
    QVERIFY(heard.server.all("auth")[1]["rand"] != auth["rand"]);
  }

  void nothingIsSaidWithoutCredentials() {
    Heard heard;
    heard.client.subscribe(topic("/a"));
    heard.client.open();
    QTRY_COMPARE(heard.server.seen.size(), 1);
    QCOMPARE(heard.server.all("auth").size(), 0);
  }

  void everyFrameCanBeTapped() {
    Heard heard;
    QByteArrayList frames;
    connect(&heard.client, &Client::frameReceived, this,
            [&](std::string_view bytes, bool binary, double received_s) {
              frames << (binary ? "b:" : "t:") + QByteArray(bytes.data(), qsizetype(bytes.size()));
              QCOMPARE(received_s, 1'700'000'000.5);
            });
    heard.client.open();
    QTRY_COMPARE(heard.server.peers.size(), 1);
    heard.server.say("nonsense");
    heard.server.sayBytes("\x01");
    QTRY_COMPARE(frames, (QByteArrayList{"t:nonsense", "b:\x01"}));
    QCOMPARE(heard.odd, (QList<Oddity>{Oddity::UnreadableFrame, Oddity::UnknownOperation}));
  }

  void aMessageBeyondTheBoundIsNotTaken() {
    ClientOptions options = quick();
    options.max_message_bytes = 1000;
    Heard heard(options);
    bool told = false;
    connect(&heard.client, &Client::changed, this, [&] {
      const Fault reason = heard.client.link().reason();
      told |= reason.code == mapwright::net::fault::MessageTooLong &&
              argumentsOf(reason).value(0) == QLatin1String("1000");
    });
    heard.client.subscribe(topic("/a"));
    heard.client.open();
    QTRY_COMPARE(heard.server.seen.size(), 1);
    heard.server.say("{\"op\":\"publish\",\"topic\":\"/a\",\"msg\":{\"x\":\"" + QByteArray(2000, 'x') +
                     "\"}}");
    QTRY_VERIFY(told);
    QTRY_COMPARE(heard.server.seen.size(), 2);  // and it goes on
    // In pieces it is no better.
    for (int i = 0; i < 3; ++i) {
      heard.server.say(pieceFrame(QStringLiteral("f"), i, 3, QByteArray(500, 'x')));
    }
    QTRY_VERIFY(heard.odd.contains(Oddity::LostFragments));
    QCOMPARE(heard.messages.size(), 0);
  }
};

}  // namespace test_rosbridge_topics

MAPWRIGHT_TEST(test_rosbridge_topics, TestRosbridgeTopics, Core)
#include "test_rosbridge_topics.moc"
