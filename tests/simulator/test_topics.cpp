// The WebSocket side: enabling, both kinds of list, the moments of the script, garbage, silence.
#include <zlib.h>

#include "ros_messages/wrapper.pb.h"
#include "running.h"
#include "test_program.h"
#include "topic_socket.h"

namespace test_topics {

using mapwright::simulator::Options;

namespace {

QStringList enabled(const QString& text) {
  QStringList topics;
  for (const QJsonValue& value : object(text)[QLatin1String("enabled_topics")].toArray())
    topics << value.toString();
  return topics;
}

raw::List lastList(const TopicSocket& client) {
  return raw::readList(client.of("/submap_list").last().toStdString());
}

/// A binary frame's wrapper, unpacked by hand.
std::optional<ros_messages::RosMessageWrapper> wrapperOf(const QByteArray& frame, bool& zipped) {
  const int length = frame.isEmpty() ? 0 : static_cast<unsigned char>(frame[0]);
  if (frame.mid(1, length) != "/submap_list") return std::nullopt;
  zipped = frame[1 + length] != 0;
  std::string payload = frame.mid(2 + length).toStdString();
  if (zipped) {
    std::string plain(16u << 20, '\0');
    z_stream stream{};
    if (inflateInit2(&stream, 15 + 16) != Z_OK) return std::nullopt;
    stream.next_in = reinterpret_cast<Bytef*>(payload.data());
    stream.avail_in = static_cast<uInt>(payload.size());
    stream.next_out = reinterpret_cast<Bytef*>(plain.data());
    stream.avail_out = static_cast<uInt>(plain.size());
    const int result = inflate(&stream, Z_FINISH);
    plain.resize(stream.total_out);
    inflateEnd(&stream);
    if (result != Z_STREAM_END) return std::nullopt;
    payload = plain;
  }
  ros_messages::RosMessageWrapper wrapper;
  if (!wrapper.ParseFromString(payload)) return std::nullopt;
  return wrapper;
}

}  // namespace

class TestTopics : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theListComesAtOnceAsJson() {
    Running robot;
    TopicSocket client(robot.port());
    QTRY_VERIFY(client.isOpen());
    QTRY_COMPARE(robot.openWebSockets(), 1);
    client.send(R"({"enable_topic":"/submap_list"})");
    QTRY_COMPARE(client.of("/submap_list").size(), 1);
    QCOMPARE(enabled(client.texts.first()), QStringList{QStringLiteral("/submap_list")});
    const raw::List list = lastList(client);
    QCOMPARE(list.uuid, robot.uuid());
    QCOMPARE(list.slam_state, std::string("positioning"));
    QVERIFY(list.entries.size() > 40);
    QVERIFY(list.find(0, 0) != nullptr && list.find(0, 0)->frozen);
    QVERIFY(list.find(1, 0) != nullptr && !list.find(1, 0)->frozen);
  }

  void theListComesAsBinaryFrameWhenBothSidesCan_data() {
    QTest::addColumn<int>("submaps");
    QTest::addColumn<bool>("zipped");
    QTest::newRow("small") << 3 << false;
    QTest::newRow("large") << 80 << true;
  }
  void theListComesAsBinaryFrameWhenBothSidesCan() {
    QFETCH(int, submaps);
    QFETCH(bool, zipped);
    Options options = paused();
    options.submaps = submaps;
    Running robot(options);
    TopicSocket binary(robot.port(), QStringLiteral("?pb=1")), text(robot.port());
    QTRY_VERIFY(binary.isOpen() && text.isOpen());
    binary.send(R"({"enable_topic":"/submap_list"})");
    text.send(R"({"enable_topic":"/submap_list"})");
    QTRY_VERIFY(binary.binaries.size() == 1 && text.of("/submap_list").size() == 1);
    bool was_zipped = !zipped;
    const auto wrapper = wrapperOf(binary.binaries.first(), was_zipped);
    QVERIFY(wrapper.has_value());
    QCOMPARE(was_zipped, zipped);
    QCOMPARE(wrapper->type(), ros_messages::SUBMAP_LIST);
    const raw::List list = lastList(text);
    QCOMPARE(wrapper->submap_list().uuid(), list.uuid);
    QCOMPARE(wrapper->submap_list().slam_state(), ros_messages::slam::SLAM_STATE_POSITIONING);
    QCOMPARE(std::size_t(wrapper->submap_list().submaps_size()), list.entries.size());
    for (std::size_t i = 0; i < list.entries.size(); ++i) {
      const ros_messages::slam::SubmapEntry& entry = wrapper->submap_list().submaps(int(i));
      QCOMPARE(entry.submap_index(), list.entries[i].index);
      QCOMPARE(entry.submap_version(), list.entries[i].version);
      QVERIFY(entry.pose().x() == list.entries[i].pose[0] && entry.pose().qw() == list.entries[i].pose[6]);
    }
  }

  void withoutBinarySupportTheListStaysJson() {
    Options options = paused();
    options.binary_topics = false;
    Running robot(options);
    TopicSocket client(robot.port(), QStringLiteral("?pb=1"));
    QTRY_VERIFY(client.isOpen());
    client.send(R"({"enable_topic":"/submap_list"})");
    QTRY_COMPARE(client.of("/submap_list").size(), 1);
    QVERIFY(client.binaries.isEmpty());
  }

  void listsOfTopicsAreUnderstoodOnlyWhenOffered() {
    for (const bool offered : {true, false}) {
      Options options = paused();
      options.enable_topic_list = offered;
      Running robot(options);
      TopicSocket client(robot.port());
      QTRY_VERIFY(client.isOpen());
      client.send(R"({"enable_topic":["/robot_model","/slam/state","/no/such"]})");
      QTRY_VERIFY(!client.texts.isEmpty());
      if (offered) {
        QCOMPARE(enabled(client.texts.first()).size(), 3);
        QTRY_COMPARE(client.of("/robot_model").size(), 1);
        QTRY_VERIFY(!client.of("/slam/state").isEmpty());
        QVERIFY(client.of("/no/such").isEmpty());
      } else {
        QVERIFY(object(client.texts.first()).contains(QLatin1String("error")));
        client.send(R"({"enable_topic":"/robot_model"})");
        QTRY_COMPARE(client.of("/robot_model").size(), 1);
        QVERIFY(client.of("/slam/state").isEmpty());
      }
    }
  }

  void aDisabledTopicIsSilent() {
    Running robot;
    TopicSocket client(robot.port());
    QTRY_VERIFY(client.isOpen());
    client.send(R"({"enable_topic":["/submap_list","/tracked_pose"]})");
    QTRY_VERIFY(client.of("/tracked_pose").size() >= 3 && client.of("/submap_list").size() == 1);
    client.send(R"({"disable_topic":["/submap_list"]})");
    const auto answered = [&] {
      return !client.texts.filter(QStringLiteral("{\"enabled_topics\":[\"/tracked_pose\"]}")).isEmpty();
    };
    QTRY_VERIFY(answered());
    robot.closeLoop();
    const qsizetype poses = client.of("/tracked_pose").size();
    QTRY_VERIFY(client.of("/tracked_pose").size() >= poses + 3);  // the list would have come before these
    QCOMPARE(client.of("/submap_list").size(), 1);
  }

  void thePoseIsInsideTheBuildingAndMovesWithTime() {
    Running robot;
    TopicSocket client(robot.port());
    QTRY_VERIFY(client.isOpen());
    client.send(R"({"enable_topic":"/tracked_pose"})");
    QTRY_VERIFY(client.of("/tracked_pose").size() >= 2);
    QCOMPARE(client.of("/tracked_pose").first(), client.of("/tracked_pose").last());
    const QJsonArray before = object(client.of("/tracked_pose").last())[QLatin1String("pos")].toArray();
    robot.advance(5);
    const auto moved = [&] {
      const QJsonArray now = object(client.of("/tracked_pose").last())[QLatin1String("pos")].toArray();
      return std::hypot(now[0].toDouble() - before[0].toDouble(), now[1].toDouble() - before[1].toDouble());
    };
    QTRY_VERIFY(moved() > 2);
    QVERIFY(moved() < 4.5);  // 5 s at 0.8 m/s
  }

  void garbageIsAnsweredAndTheLinkLivesOn_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("no json") << QStringLiteral("hello");
    QTest::newRow("empty") << QString();
    QTest::newRow("array") << QStringLiteral("[1,2]");
    QTest::newRow("cut") << QStringLiteral("{\"enable_topic\":");
    QTest::newRow("other key") << QStringLiteral("{\"subscribe\":\"/x\"}");
    QTest::newRow("number") << QStringLiteral("{\"enable_topic\":5}");
    QTest::newRow("numbers") << QStringLiteral("{\"enable_topic\":[5]}");
    QTest::newRow("empty name") << QStringLiteral("{\"enable_topic\":\"\"}");
    QTest::newRow("long name")
        << QStringLiteral("{\"enable_topic\":\"/%1\"}").arg(QString(400, QLatin1Char('x')));
    QTest::newRow("deep") << QString(5000, QLatin1Char('['));
  }
  void garbageIsAnsweredAndTheLinkLivesOn() {
    QFETCH(QString, text);
    Running robot;
    TopicSocket client(robot.port());
    QTRY_VERIFY(client.isOpen());
    client.socket.sendTextMessage(text);
    QTRY_COMPARE(client.texts.size(), 1);
    QVERIFY(!object(client.texts.first())[QLatin1String("error")].toString().isEmpty());
    client.socket.sendBinaryMessage("\x01\x02");
    QTRY_COMPARE(client.texts.size(), 2);
    client.send("{\"enable_topic\":\"/with \\\"quotes\\\"\"}");
    QTRY_COMPARE(client.texts.size(), 3);
    QCOMPARE(enabled(client.texts.last()), QStringList{QStringLiteral("/with \"quotes\"")});
  }

  void pingsArePonged() {
    Running robot;
    TopicSocket client(robot.port());
    QTRY_VERIFY(client.isOpen());
    client.socket.ping();
    QTRY_COMPARE(client.pongs, 1);
  }

  void aSilentRobotAcceptsAndSaysNothing() {
    Options options = paused();
    options.faults.silent_websocket = true;
    Running robot(options);
    TopicSocket client(robot.port());
    QTRY_VERIFY(client.isOpen());
    QTRY_COMPARE(robot.openWebSockets(), 1);
    client.send(R"({"enable_topic":"/submap_list"})");
    client.socket.ping();
    mapwright::simulator::Faults none;
    robot.setFaults(none);
    TopicSocket other(
        robot.port());  // by the time another link has its answers, the silent one would have, too
    QTRY_VERIFY(other.isOpen());
    other.send(R"({"enable_topic":["/submap_list","/tracked_pose"]})");
    QTRY_VERIFY(other.of("/tracked_pose").size() >= 5);
    QVERIFY(client.texts.isEmpty());
    QCOMPARE(client.pongs, 0);
    QVERIFY(client.isOpen());
  }

  void droppedLinksAreClosed() {
    Running robot;
    TopicSocket client(robot.port());
    QTRY_COMPARE(robot.openWebSockets(), 1);
    QTRY_VERIFY(client.isOpen());
    robot.dropWebSockets();
    QCOMPARE(robot.openWebSockets(), 0);
    QTRY_VERIFY(!client.isOpen());
  }

  void theSecretGuardsTheTopics() {
    Options options = paused();
    options.secret = "s";
    Running robot(options);
    TopicSocket client(robot.port());
    QTRY_VERIFY(!robot.requestLog().empty() && robot.requestLog().front().until_s >= 0);
    QCOMPARE(robot.requestLog().front().status, 401);
    QTRY_COMPARE(client.socket.state(), QAbstractSocket::UnconnectedState);
    QCOMPARE(robot.openWebSockets(), 0);
  }

  void aClosedLoopMovesPosesWithoutNewVersions() {
    Running robot;
    TopicSocket client(robot.port());
    QTRY_VERIFY(client.isOpen());
    client.send(R"({"enable_topic":"/submap_list"})");
    QTRY_COMPARE(client.of("/submap_list").size(), 1);
    const raw::List before = lastList(client);
    robot.closeLoop();
    QTRY_COMPARE(client.of("/submap_list").size(), 2);
    const raw::List after = lastList(client);
    QCOMPARE(after.uuid, before.uuid);
    QCOMPARE(after.entries.size(), before.entries.size());
    for (std::size_t i = 0; i < after.entries.size(); ++i) {
      QCOMPARE(after.entries[i].version, before.entries[i].version);
      const double shift = std::hypot(after.entries[i].pose[0] - before.entries[i].pose[0],
                                      after.entries[i].pose[1] - before.entries[i].pose[1]);
      QVERIFY2(shift > 0 && shift < 0.55, qPrintable(QString::number(shift)));
    }
  }

  void aRestartGivesANewUuid() {
    Running robot;
    TopicSocket client(robot.port());
    QTRY_VERIFY(client.isOpen());
    client.send(R"({"enable_topic":"/submap_list"})");
    QTRY_COMPARE(client.of("/submap_list").size(), 1);
    const std::string before = robot.uuid();
    robot.restartSlam();
    QVERIFY(robot.uuid() != before);
    QTRY_COMPARE(client.of("/submap_list").size(), 2);
    QCOMPARE(lastList(client).uuid, robot.uuid());
  }

  void removedAndChangedSubmapsShowInTheList() {
    Running robot;
    TopicSocket client(robot.port());
    QTRY_VERIFY(client.isOpen());
    client.send(R"({"enable_topic":"/submap_list"})");
    QTRY_COMPARE(client.of("/submap_list").size(), 1);
    const int version = lastList(client).find(0, 4)->version;
    robot.bumpVersion(0, 4);
    QTRY_COMPARE(client.of("/submap_list").size(), 2);
    QCOMPARE(lastList(client).find(0, 4)->version, version + 1);
    robot.removeSubmap(0, 4);
    QTRY_COMPARE(client.of("/submap_list").size(), 3);
    QVERIFY(lastList(client).find(0, 4) == nullptr);
    QCOMPARE(robot.get("/ros/slam/submaps/" + robot.uuid() + "/0/4?ver=25").status, 404);
  }

  void timeGrowsTheLiveTrajectoryAndBringsTheOthers() {
    Running robot;
    TopicSocket client(robot.port());
    QTRY_VERIFY(client.isOpen());
    client.send(R"({"enable_topic":"/submap_list"})");
    QTRY_COMPARE(client.of("/submap_list").size(), 1);
    const raw::List start = lastList(client);
    QVERIFY(start.find(2, 0) == nullptr && start.find(3, 0) == nullptr);
    robot.advance(3);
    QTRY_COMPARE(client.of("/submap_list").size(), 2);
    QVERIFY(lastList(client).find(1, 0)->version > start.find(1, 0)->version);
    robot.advance(22);
    QTRY_COMPARE(client.of("/submap_list").size(), 3);
    QVERIFY(lastList(client).find(2, 0) != nullptr && lastList(client).find(2, 0)->incremental);
    QVERIFY(!lastList(client).find(2, 0)->frozen);
    robot.advance(10);
    QTRY_COMPARE(client.of("/submap_list").size(), 4);
    QVERIFY(lastList(client).find(3, 0) != nullptr && lastList(client).find(3, 0)->nearby);
    robot.advance(600);
    QTRY_COMPARE(client.of("/submap_list").size(), 5);
    QVERIFY(lastList(client).find(2, 0)->frozen);
    QVERIFY(lastList(client).find(1, 0) == nullptr);  // only the newest are kept
    QCOMPARE(lastList(client).find(0, 0)->version, start.find(0, 0)->version);
  }

  void aRunningClockPublishesByItself() {
    Options options;
    options.speed = 20;
    Running robot(options);
    TopicSocket client(robot.port());
    QTRY_VERIFY(client.isOpen());
    client.send(R"({"enable_topic":"/submap_list"})");
    QTRY_VERIFY(client.of("/submap_list").size() >= 2);
  }

  void anEmptySceneHasAnEmptyList() {
    Options options = paused();
    options.scene = "empty";
    Running robot(options);
    TopicSocket client(robot.port());
    QTRY_VERIFY(client.isOpen());
    client.send(R"({"enable_topic":["/submap_list","/tracked_pose"]})");
    QTRY_VERIFY(client.of("/submap_list").size() == 1 && !client.of("/tracked_pose").isEmpty());
    QVERIFY(lastList(client).entries.empty());
    QVERIFY(!lastList(client).uuid.empty());
  }
};

}  // namespace test_topics

MAPWRIGHT_TEST(test_topics, TestTopics, Core)
#include "test_topics.moc"
