#include <QTest>

#include "net/json_numbers.h"
#include "robot/axbot/parse_topics.h"
#include "robot/axbot/robot_urls.h"
#include "robot/axbot/topic_subscriptions.h"
#include "robot/wire/picture_bytes.h"
#include "robot/wire/robot_link.h"
#include "test_program.h"

namespace test_axbot_parts {

using namespace mapwright;
using namespace mapwright::robot::axbot;
using net::quoteLongNumbers;
using robot::wire::fromBase64;
using robot::wire::RawLimit;
using robot::wire::TopicMailbox;

class AxbotPartsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void robotUrlsLeadToTheAddressThatWasConnectedTo_data() {
    QTest::addColumn<QString>("base");
    QTest::addColumn<QByteArray>("given");
    QTest::addColumn<QString>("url");
    const auto row = [](const char* base, const char* given, const char* url) {
      QTest::newRow(given) << QString::fromLatin1(base) << QByteArray(given) << QString::fromLatin1(url);
    };
    row("http://h:1", "static-files/a.png", "http://h:1/static-files/a.png");
    row("http://h:1", "/static-files/a.png?v=2", "http://h:1/static-files/a.png?v=2");
    row("http://h:1", "http://localhost:8090/maps/1.png", "http://h:1/maps/1.png");
    row("http://h:1", "//evil.example/x.png", "http://h:1/x.png");
    row("http://h:1", "maps/a:b.png", "http://h:1/maps/a:b.png");
    row("http://h:1", "a%20b.png", "http://h:1/a%20b.png");
    row("http://h:1", "https://u:p@evil/x.png", "http://h:1/x.png");
    row("http://h:1/robots/7", "maps/1.png", "http://h:1/robots/7/maps/1.png");
    row("http://h:1/robots/7", "/robots/7/maps/2.png", "http://h:1/robots/7/maps/2.png");
    row("http://h:1", "", "");
    row("http://h:1", "http://evil", "");
  }
  void robotUrlsLeadToTheAddressThatWasConnectedTo() {
    QFETCH(QString, base);
    QFETCH(QByteArray, given);
    QFETCH(QString, url);
    QCOMPARE(robotUrl(QUrl(base), given.toStdString()).toString(QUrl::FullyEncoded), url);
  }

  void theMailboxHoldsTheLatestOfEachTopic() {
    TopicMailbox box;
    const auto grid = [](const char* topic, const char* mark) -> map::StampedMessage {
      map::GridMessage message;
      message.topic = topic;
      message.fingerprint = mark;
      return {message, 7};
    };
    QVERIFY(box.put(grid("/a", "1")));
    QVERIFY(!box.put(grid("/b", "2")));
    QVERIFY(!box.put(grid("/a", "3")));
    const auto taken = box.take();
    QCOMPARE(taken.size(), std::size_t(2));
    QCOMPARE(std::get<map::GridMessage>(taken[0].message).fingerprint, std::string("3"));
    QVERIFY(box.take().empty());
    QVERIFY(box.put(grid("/a", "4")));
    QVERIFY(!TopicMailbox::takes(map::TrackedPose{}));
    QVERIFY(TopicMailbox::takes(map::PointCloudMessage{"/c", nullptr}));
  }

  void theMailboxIsBounded() {
    TopicMailbox box;
    for (int i = 0; i < 1000; ++i)
      box.put({map::PointCloudMessage{std::string("/cloud").append(std::to_string(i)), nullptr}});
    QCOMPARE(box.take().size(), TopicMailbox::kTopics);
  }

  void onlyDifferencesAreAskedFor() {
    TopicSubscriptions topics;
    topics.setTakesLists(true);
    QCOMPARE(topics.setWanted(
                 {QStringLiteral("/a"), QStringLiteral("/a"), QString(), QStringLiteral("/slam/state")}),
             QStringList{QStringLiteral(R"({"enable_topic":["/a"]})")});
    QVERIFY(topics.setWanted({QStringLiteral("/a")}).isEmpty());
    QCOMPARE(topics.setWanted({QStringLiteral("/b")}),
             (QStringList{QStringLiteral(R"({"disable_topic":["/a"]})"),
                          QStringLiteral(R"({"enable_topic":["/b"]})")}));
    topics.setTakesLists(false);
    QCOMPARE(topics.all().size(), topics.always().size() + 1);
    QCOMPARE(topics.all().last(), QStringLiteral(R"({"enable_topic":"/b"})"));
  }

  void aFloodOfRawMessagesIsHeldBack() {
    RawLimit limit;
    int passed = 0;
    for (int i = 0; i < 5000; ++i) passed += limit.allow(10, 100) ? 1 : 0;
    QCOMPARE(passed, RawLimit::kMessages);
    QVERIFY(limit.allow(1010, 100));
    int large = 0;
    for (int i = 0; i < 100; ++i) large += limit.allow(2000, qint64(1) << 30) ? 1 : 0;
    QVERIFY2(large >= 1 && large <= 33, qPrintable(QString::number(large)));
  }

  void rawTextsAreCutBetweenCharacters() {
    std::string text(std::size_t(robot::kMaxRawText) - 1, 'x');
    text.append("🔥");
    const auto raw = rawText("/t", text);
    QCOMPARE(raw.text.size(), robot::kMaxRawText - 1);
    QCOMPARE(raw.bytes, qint64(text.size()));
  }

  void unknownBinariesAreDumped() {
    const auto raw =
        rawBinary(std::string("\x02/x\0\xff\xfe"
                              "AB",
                              8));
    QCOMPARE(raw.topic, QStringLiteral("/x"));
    QVERIFY(raw.text.startsWith("00000000  ff fe 41 42"));
    QVERIFY(!rawBinary("").text.contains("more"));
  }

  void base64IsReadAsRobotsWriteIt() {
    QCOMPARE(fromBase64("aGVsbG8=", 100), std::optional<std::string>("hello"));
    QCOMPARE(fromBase64("aGVs\r\n bG8", 100), std::optional<std::string>("hello"));
    QCOMPARE(fromBase64("data:image/png;base64,aGVsbG8=", 100), std::optional<std::string>("hello"));
    QCOMPARE(fromBase64("_-8=", 100), fromBase64("/+8=", 100));
    QCOMPARE(fromBase64("", 100), std::optional<std::string>(""));
    for (const char* text : {"a", "aGVs!", "aGVs=aGVs", "data:image/png,raw"})
      QVERIFY2(!fromBase64(text, 100), text);
    QVERIFY(!fromBase64("aGVsbG8=", 4));
  }

  void longNumbersKeepTheirDigits() {
    QCOMPARE(quoteLongNumbers(
                 R"({"a":1764059676131123456,"b":-12345678901234567,"c":1.5,"d":"12345678901234567"})"),
             std::string(
                 R"({"a":"1764059676131123456","b":"-12345678901234567","c":1.5,"d":"12345678901234567"})"));
  }
};

}  // namespace test_axbot_parts

MAPWRIGHT_TEST(test_axbot_parts, AxbotPartsTest, Core)
#include "test_axbot_parts.moc"
