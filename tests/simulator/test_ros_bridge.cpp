// The simulated rosbridge server: its operations, both dialects, compression, fragments, and how strict it
// is.
#include <QImage>
#include <QTest>

#include "ros_socket.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_ros_bridge {

using mapwright::simulator::Options;
using mapwright::simulator::RosWriter;

class TestRosBridge : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void callsAreAnsweredUnderTheirId() {
    RosRobot robot;
    const QJsonObject answer = robot->ask("/rosapi/topic_type", R"({"topic":"/map"})");
    QCOMPARE(at(answer, "service").toString(), QStringLiteral("/rosapi/topic_type"));
    QCOMPARE(at(answer, "values.type").toString(), QStringLiteral("nav_msgs/OccupancyGrid"));
    QCOMPARE(at(answer, "result").toBool(), true);
  }

  void argumentsMayBeAListInTheOrderOfTheFields() {
    RosRobot robot;
    QCOMPARE(robot->values("/rosapi/topic_type", R"(["/odom"])")[QLatin1String("type")].toString(),
             QStringLiteral("nav_msgs/Odometry"));
    QCOMPARE(robot->ask("/rosapi/topic_type", R"(["/odom","more"])")[QLatin1String("result")].toBool(true),
             false);
  }

  void aServiceThatDoesNotExistIsRefusedWithAText() {
    RosRobot robot;
    const QJsonObject answer = robot->ask("/no/such");
    QCOMPARE(at(answer, "result").toBool(true), false);
    QCOMPARE(at(answer, "values").toString(), QStringLiteral("Service /no/such does not exist"));
  }

  void aCallWithoutAServiceGetsNoAnswer() {
    RosRobot robot;
    robot->send(R"({"op":"call_service","id":"x","args":{}})");
    QVERIFY(robot->settle());
    QCOMPARE(robot->texts.size(), 1);
  }

  void typesAreStrict_data() {
    QTest::addColumn<QByteArray>("service");
    QTest::addColumn<QByteArray>("args");
    const auto row = [](const char* name, const char* service, const char* args) {
      QTest::newRow(name) << QByteArray(service) << QByteArray(args);
    };
    row("1 for true", "/map_manager/archive_map", R"({"map_id":"x","set_archive":1})");
    row("text for true", "/map_manager/archive_map", R"({"map_id":"x","set_archive":"true"})");
    row("2.0 for 2", "/map_manager/update_map_image", R"({"map_id":"x","updated_image":{"height":2.0}})");
    row("too large", "/map_manager/update_map_image",
        R"({"map_id":"x","updated_image":{"height":4294967296}})");
    row("negative", "/map_manager/update_map_image", R"({"map_id":"x","updated_image":{"height":-1}})");
    row("null for a float", "/map_manager/create_waypoint",
        R"({"waypoint_info":{"pose":{"position":{"x":null}}}})");
    row("text for a float", "/map_manager/create_waypoint",
        R"({"waypoint_info":{"pose":{"position":{"x":"1"}}}})");
    row("number for a text", "/map_manager/load_map", R"({"map_id":7})");
    row("text for a list", "/map_manager/create_waypoint", R"({"waypoint_info":{"waypoint_tags":"a"}})");
    row("number in a list of texts", "/map_manager/create_waypoint",
        R"({"waypoint_info":{"waypoint_tags":[1]}})");
    row("no base64", "/map_manager/update_map_image", R"({"map_id":"x","updated_image":{"data":"***"}})");
    row("no byte", "/map_manager/update_map_image", R"({"map_id":"x","updated_image":{"data":[256]}})");
    row("unknown field", "/map_manager/load_map", R"({"map_id":"x","waypoint":"y"})");
    row("unknown field deep", "/map_manager/create_waypoint", R"({"waypoint_info":{"pose":{"place":{}}}})");
    row("time of the other ROS", "/map_manager/update_map_image",
        R"({"updated_image":{"header":{"stamp":{"sec":1,"nanosec":0}}}})");
  }
  void typesAreStrict() {
    QFETCH(QByteArray, service);
    QFETCH(QByteArray, args);
    RosRobot robot;
    const QJsonObject answer = robot->ask(service, args);
    QCOMPARE(at(answer, "result").toBool(true), false);
    QVERIFY2(!at(answer, "values").toString().isEmpty(), "a text that says why");
  }

  void whatIsOmittedIsZeroAndWholeNumbersServeForFloats() {
    RosRobot robot;
    robot->subscribe("/map_manager/map_list");
    const QByteArray id = at(robot->first("/map_manager/map_list"), "maps.0.map_id").toString().toUtf8();
    const QJsonObject made =
        robot->values("/map_manager/create_waypoint", R"({"waypoint_info":{"name":"New","map_id":")" + id +
                                                          R"(","pose":{"position":{"x":3}}}})");
    QCOMPARE(at(made, "result").toInt(-1), 0);
    QCOMPARE(at(made, "waypoint_response.pose.position.x").toDouble(), 3.0);
    QCOMPARE(at(made, "waypoint_response.pose.orientation.w").toDouble(-1), 0.0);
  }

  void latchedTopicsComeAtOnceAndAgainWithEachSubscribe() {
    RosRobot robot;
    robot->subscribe("/map_manager/map_list", R"(,"id":"a")");
    QVERIFY(!robot->first("/map_manager/map_list").isEmpty());
    robot->subscribe("/map_manager/map_list", R"(,"id":"b","type":"kabam_msgs/MapList")");
    QTRY_COMPARE(robot->count("/map_manager/map_list"), 2);
    robot->send(R"({"op":"unsubscribe","id":"a","topic":"/map_manager/map_list"})");
    QCOMPARE(robot->result("/map_manager/archive_map", R"({"map_id":"none"})"), 2);
    robot.robot.otherOperator();
    robot.robot.otherOperator();
    robot.robot.otherOperator();
    robot.robot.otherOperator();  // has given the map another label
    QTRY_COMPARE(robot->count("/map_manager/map_list"), 3);
    robot->send(R"({"op":"unsubscribe","topic":"/map_manager/map_list"})");
    QVERIFY(robot->settle());
    const QJsonObject request{
        {QStringLiteral("map_id"), at(robot->last("/map_manager/map_list"), "maps.1.map_id")},
        {QStringLiteral("new_map_label"), QStringLiteral("Other")}};
    QCOMPARE(robot->result("/map_manager/rename_map", QJsonDocument(request).toJson()), 0);
    QVERIFY(robot->settle());
    QCOMPARE(robot->count("/map_manager/map_list"), 3);
  }

  void whatCannotBeDeliveredIsMetWithSilence_data() {
    QTest::addColumn<QByteArray>("more");
    QTest::newRow("another type") << QByteArray(R"(/odom","type":"nav_msgs/Path)");
    QTest::newRow("the other ROS's type") << QByteArray(R"(/odom","type":"nav_msgs/msg/Odometry)");
    QTest::newRow("no such topic") << QByteArray(R"(/no/such)");
    QTest::newRow("a field of another type") << QByteArray(R"(/odom","throttle_rate":"200)");
  }
  void whatCannotBeDeliveredIsMetWithSilence() {
    QFETCH(QByteArray, more);
    RosRobot robot;
    robot->subscribe(more);
    robot->subscribe("/odom", R"(,"throttle_rate":10.5)");
    robot->subscribe("/tf");
    QTRY_VERIFY(robot->count("/tf") > 20);
    QCOMPARE(robot->topics.size(), 1);
    QCOMPARE(robot->statuses.size(), 0);
  }

  void mistakesAreToldToWhoAsks() {
    RosRobot robot;
    robot->send(R"({"op":"set_level","level":"error"})");
    robot->send(R"({"op":"subscribe","id":"s7","topic":"/odom","type":"nav_msgs/Path"})");
    QTRY_COMPARE(robot->statuses.size(), 1);
    QCOMPARE(at(robot->statuses.first(), "level").toString(), QStringLiteral("error"));
    QCOMPARE(at(robot->statuses.first(), "id").toString(), QStringLiteral("s7"));
    robot->send("no JSON");
    robot->send(R"({"op":"dance"})");
    QTRY_COMPARE(robot->statuses.size(), 3);
    Options options = RosRobot::still();
    options.ros.status = true;
    RosRobot telling(options);
    telling->send(R"({"op":"call_service"})");
    QTRY_COMPARE(telling->statuses.size(), 1);
  }

  void aThrottledTopicKeepsItsLastMessageOnlyWithAQueue() {
    RosRobot robot;
    robot->subscribe("/map_manager/current_map_waypoints", R"(,"throttle_rate":2000)");
    RosSocket queued(robot.robot.rosPort());
    queued.subscribe("/map_manager/current_map_waypoints", R"(,"throttle_rate":2000,"queue_length":1)");
    QVERIFY(!robot->first("/map_manager/current_map_waypoints").isEmpty());
    QVERIFY(!queued.first("/map_manager/current_map_waypoints").isEmpty());
    for (int i = 0; i < 5; ++i) robot.robot.otherOperator();
    QTRY_COMPARE(queued.count("/map_manager/current_map_waypoints"), 3);
    QVERIFY(queued.settle());
    QCOMPARE(robot->count("/map_manager/current_map_waypoints"), 2);
    QVERIFY(robot->last("/map_manager/current_map_waypoints") !=
            queued.last("/map_manager/current_map_waypoints"));
  }

  void ros2NamesTypesAndTimesItsOwnWay() {
    RosRobot robot(RosRobot::ros2());
    QCOMPARE(at(robot->values("/rosapi/topic_type", R"({"topic":"/tf"})"), "type").toString(),
             QStringLiteral("tf2_msgs/msg/TFMessage"));
    QCOMPARE(at(robot->values("/rosapi/service_type", R"({"service":"/map_manager/load_map"})"), "type")
                 .toString(),
             QStringLiteral("kabam_msgs/srv/LoadMap"));
    robot->subscribe("/odom", R"(,"type":"nav_msgs/msg/Odometry")");
    const QJsonObject header = at(robot->first("/odom"), "header").toObject();
    QVERIFY(!header.contains(QLatin1String("seq")));
    QCOMPARE(at(header, "stamp.sec").toDouble(), 1717405290.0);
    QVERIFY(at(header, "stamp.nanosec").isDouble());
    RosRobot older;
    older->subscribe("/odom", R"(,"type":"nav_msgs/Odometry")");
    const QJsonObject first = at(older->first("/odom"), "header").toObject();
    QVERIFY(first.contains(QLatin1String("seq")));
    QCOMPARE(at(first, "stamp.secs").toDouble(), 1717405290.0);
  }

  void rosapiKnowsEverythingAndMayBeAbsent() {
    RosRobot robot;
    const QJsonObject topics = robot->values("/rosapi/topics");
    QCOMPARE(at(topics, "topics").toArray().size(), at(topics, "types").toArray().size());
    QVERIFY(at(topics, "topics").toArray().contains(QLatin1String("/map")));
    QCOMPARE(at(robot->values("/rosapi/topics_for_type", R"({"type":"nav_msgs/Path"})"), "topics").toArray(),
             QJsonArray({QStringLiteral("/plan"), QStringLiteral("/local_plan")}));
    QCOMPARE(at(robot->values("/rosapi/topic_type", R"({"topic":"/none"})"), "type").toString(), QString());
    QCOMPARE(at(robot->values("/rosapi/service_type", R"({"service":"/none"})"), "type").toString(),
             QString());
    QVERIFY(at(robot->values("/rosapi/services"), "services")
                .toArray()
                .contains(QLatin1String("/map_manager/save_map")));
    QVERIFY(at(robot->values("/rosapi/nodes"), "nodes").toArray().contains(QLatin1String("/map_manager")));
    Options options = RosRobot::still();
    options.ros.rosapi = options.ros.kabam = false;
    RosRobot bare(options);
    QCOMPARE(bare->ask("/rosapi/topics")[QLatin1String("result")].toBool(true), false);
    QCOMPARE(bare->ask("/map_manager/load_map")[QLatin1String("result")].toBool(true), false);
    bare->subscribe("/map");
    QVERIFY(!bare->first("/map").isEmpty());
  }

  void jsonIsWrittenInThreeWays() {
    const auto written = [](RosWriter writer) {
      Options options = RosRobot::still();
      options.ros.writer = writer;
      RosRobot robot(options);
      robot->subscribe("/map_manager/map_list");
      robot->first("/map_manager/map_list");
      return robot->texts.value(0);
    };
    const QString escaped = written(RosWriter::Escaped), spaced = written(RosWriter::Spaced),
                  plain = written(RosWriter::Plain);
    QVERIFY(escaped.startsWith(QLatin1String(R"({"op":"publish","topic":"\/map_manager\/map_list")")));
    QVERIFY(spaced.startsWith(QLatin1String(R"({"op": "publish", "topic": "/map_manager/map_list")")));
    QVERIFY(plain.startsWith(QLatin1String(R"({"op":"publish","topic":"/map_manager/map_list")")));
    QVERIFY(escaped.contains(QLatin1String("Anbau S\\u00fcd")) &&
            spaced.contains(QLatin1String("Anbau S\\u00fcd")));
    QVERIFY(plain.contains(QStringLiteral("Anbau Süd")));
    QCOMPARE(QJsonDocument::fromJson(escaped.toUtf8()), QJsonDocument::fromJson(plain.toUtf8()));
    QCOMPARE(QJsonDocument::fromJson(spaced.toUtf8()), QJsonDocument::fromJson(plain.toUtf8()));
  }

  void cborHoldsTypedArrays() {
    RosRobot robot;
    robot->subscribe("/map", R"(,"compression":"cbor")");
    QTRY_COMPARE(robot->binaries.size(), 1);
    const QCborMap message = QCborValue::fromCbor(robot->binaries.first()).toMap();
    QCOMPARE(message[QStringLiteral("op")].toString(), QStringLiteral("publish"));
    QCOMPARE(message[QStringLiteral("topic")].toString(), QStringLiteral("/map"));
    const QCborMap grid = message[QStringLiteral("msg")].toMap(), info = grid[QStringLiteral("info")].toMap();
    const QCborValue data = grid[QStringLiteral("data")];
    QVERIFY(data.isTag());
    QCOMPARE(quint64(data.tag()), 72U);
    QCOMPARE(data.taggedValue().toByteArray().size(),
             info[QStringLiteral("width")].toInteger() * info[QStringLiteral("height")].toInteger());
    QCOMPARE(info[QStringLiteral("resolution")].toDouble(), 0.05000000074505806);
    robot->subscribe("/map", R"(,"id":"json")");
    QTRY_COMPARE(robot->binaries.size(), 2);  // of two, compression wins
    RosSocket other(robot.robot.rosPort());
    other.subscribe("/map");
    const QJsonArray cells = at(other.first("/map"), "data").toArray();
    QCOMPARE(cells.size(), data.taggedValue().toByteArray().size());
    for (qsizetype i = 0; i < cells.size(); i += 997)
      QCOMPARE(cells[i].toInt(), int(static_cast<signed char>(data.taggedValue().toByteArray()[i])));
  }

  void cborHoldsFloatsAndBytes() {
    RosRobot robot;
    robot->subscribe("/scan", R"(,"compression":"cbor")");
    QTRY_VERIFY(!robot->binaries.isEmpty());
    const QCborMap scan =
        QCborValue::fromCbor(robot->binaries.first()).toMap()[QStringLiteral("msg")].toMap();
    QCOMPARE(quint64(scan[QStringLiteral("ranges")].tag()), 85U);
    QCOMPARE(scan[QStringLiteral("ranges")].taggedValue().toByteArray().size(), 720 * 4);
    RosSocket other(robot.robot.rosPort());
    other.subscribe("/points", R"(,"compression":"cbor")");
    QTRY_VERIFY(!other.binaries.isEmpty());
    const QCborMap cloud =
        QCborValue::fromCbor(other.binaries.first()).toMap()[QStringLiteral("msg")].toMap();
    QVERIFY(cloud[QStringLiteral("data")].isByteArray());
    QCOMPARE(cloud[QStringLiteral("data")].toByteArray().size(),
             cloud[QStringLiteral("width")].toInteger() * cloud[QStringLiteral("point_step")].toInteger());
  }

  void messagesWithTextsAreLostInCbor() {
    RosRobot robot;
    robot->subscribe("/map_manager/current_map_waypoints", R"(,"compression":"cbor")");
    robot->subscribe("/map_manager/map_list", R"(,"compression":"cbor")");
    QTRY_COMPARE(robot->binaries.size(), 1);
    QVERIFY(robot->settle());
    QCOMPARE(QCborValue::fromCbor(robot->binaries.first()).toMap()[QStringLiteral("topic")].toString(),
             QStringLiteral("/map_manager/map_list"));
    QCOMPARE(robot->binaries.size(), 1);
  }

  void pngHoldsTheWholeMessageInItsPixels() {
    RosRobot robot;
    robot->subscribe("/map", R"(,"compression":"png")");
    QTRY_COMPARE(robot->texts.size(), 1);
    const QJsonObject frame = QJsonDocument::fromJson(robot->texts.first().toUtf8()).object();
    QCOMPARE(at(frame, "op").toString(), QStringLiteral("png"));
    const QImage picture = QImage::fromData(QByteArray::fromBase64(at(frame, "data").toString().toLatin1()))
                               .convertToFormat(QImage::Format_RGB888);
    QVERIFY(!picture.isNull());
    QByteArray bytes;
    for (int y = 0; y < picture.height(); ++y)
      bytes.append(reinterpret_cast<const char*>(picture.constScanLine(y)), 3 * qsizetype(picture.width()));
    const QJsonObject message = QJsonDocument::fromJson(bytes.trimmed()).object();
    QCOMPARE(at(message, "topic").toString(), QStringLiteral("/map"));
    QVERIFY(at(message, "msg.data").toArray().size() > 100'000);
  }

  void whoAsksForFragmentsGetsThemFromThenOn() {
    RosRobot robot;
    robot->subscribe("/map_manager/current_map_waypoints", R"(,"fragment_size":300)");
    const auto joined = [&]() -> QString {
      QString text;
      double total = 0;
      for (const QString& one : robot->texts) {
        const QJsonObject piece = QJsonDocument::fromJson(one.toUtf8()).object();
        if (at(piece, "op").toString() != QLatin1String("fragment") || at(piece, "id").toDouble(-1) != 0)
          continue;
        total = at(piece, "total").toDouble();
        text += at(piece, "data").toString();
        if (at(piece, "num").toInt() + 1 == int(total)) return text;
      }
      return {};
    };
    QTRY_VERIFY(!joined().isEmpty());
    QCOMPARE(QJsonDocument::fromJson(joined().toUtf8()).object()[QLatin1String("op")].toString(),
             QStringLiteral("publish"));
    robot->texts.clear();
    robot->send(R"({"op":"call_service","id":"long","service":"/rosapi/topics"})");
    QTRY_VERIFY(robot->texts.size() > 2);
    QCOMPARE(at(QJsonDocument::fromJson(robot->texts.first().toUtf8()).object(), "id").toString(),
             QStringLiteral("long"));
  }

  void whatIsPublishedReachesAllWhoSubscribed() {
    RosRobot robot;
    RosSocket other(robot.robot.rosPort());
    other.subscribe("/chat", R"(,"type":"std_msgs/String")");
    other.subscribe("/initialpose");
    QVERIFY(other.settle());
    robot->send(R"({"op":"publish","topic":"/chat","msg":{"data":"too early"}})");
    robot->send(R"({"op":"advertise","topic":"/chat","type":"std_msgs/String"})");
    robot->send(R"({"op":"publish","topic":"/chat","msg":{"data":1}})");
    robot->send(R"({"op":"publish","topic":"/chat","msg":{"data":"hello"}})");
    robot->send(R"({"op":"publish","topic":"/initialpose","msg":{"pose":{"pose":{"position":{"x":4}}}}})");
    robot->send(R"({"op":"unadvertise","topic":"/chat"})");
    QCOMPARE(at(other.first("/chat"), "data").toString(), QStringLiteral("hello"));
    QCOMPARE(at(other.first("/initialpose"), "pose.pose.position.x").toDouble(), 4.0);
  }

  void authIsAcceptedAndMayBeNeeded() {
    constexpr const char* kAuth =
        R"({"op":"auth","mac":"m","client":"c","dest":"d","rand":"r","t":1,"level":"user","end":2})";
    RosRobot open;
    open->send(kAuth);
    QVERIFY(open->settle());
    Options options = RosRobot::still();
    options.ros.needs_auth = true;
    RosRobot locked(options);
    locked->send(R"({"op":"call_service","service":"/rosapi/topics"})");
    QTRY_VERIFY(!locked->isOpen());
    RosSocket known(locked.robot.rosPort());
    known.send(kAuth);
    QVERIFY(known.settle());
  }

  void theLogTellsWhatWasAsked() {
    RosRobot robot;
    robot->subscribe("/odom");
    robot->ask("/rosapi/topics");
    robot->ask("/no/such");
    QStringList lines;
    for (const auto& record : robot.robot.requestLog()) {
      lines << QStringLiteral("%1 %2 %3")
                   .arg(QString::fromStdString(record.method), QString::fromStdString(record.target))
                   .arg(record.status);
    }
    QCOMPARE(lines,
             QStringList({QStringLiteral("SUBSCRIBE /odom 200"), QStringLiteral("CALL /rosapi/topics 200"),
                          QStringLiteral("CALL /no/such 400")}));
  }
};

}  // namespace test_ros_bridge

MAPWRIGHT_TEST(test_ros_bridge, TestRosBridge, Core)
#include "test_ros_bridge.moc"
