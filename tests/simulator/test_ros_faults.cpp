// What may go wrong with the simulated ROS robot, on request.
#include <cstring>

#include <QTest>
#include <QtEndian>

#include "ros_socket.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_ros_faults {

using namespace mapwright::simulator;

namespace {

constexpr const char* kLabel = R"({"map_id":"%1","new_map_label":"Changed"})";

Options with(const RosFaults& faults) {
  Options options = RosRobot::still();
  options.faults.ros = faults;
  return options;
}

Options with(RequestFault fault) {
  Options options = RosRobot::still();
  options.faults.requests = {std::move(fault)};
  return options;
}

/// Asks for the first map to be relabelled; the label that the list then tells.
QByteArray relabelling(RosRobot& robot) {
  robot->subscribe("/map_manager/map_list");
  const QByteArray id = at(robot->first("/map_manager/map_list"), "maps.0.map_id").toString().toUtf8();
  return R"({"op":"call_service","id":"r","service":"/map_manager/rename_map","args":)" +
         QByteArray(kLabel).replace("%1", id) + '}';
}

QString label(const RosSocket& client) {
  return at(client.last("/map_manager/map_list"), "maps.0.map_label").toString();
}

}  // namespace

class TestRosFaults : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void answersMayBeSlow() {
    RosRobot robot(with({FaultKind::Delay, kServices, 1, 400}));
    QElapsedTimer timer;
    timer.start();
    QVERIFY(!robot->ask("/rosapi/topics").isEmpty());
    QVERIFY(timer.elapsed() >= 400);
  }

  void answersMayOvertakeOneAnother() {
    RosFaults faults;
    faults.shuffled_answers = true;
    RosRobot robot(with(faults));
    robot->send(R"({"op":"call_service","id":"first","service":"/rosapi/topics"})");
    robot->send(R"({"op":"call_service","id":"second","service":"/rosapi/nodes"})");
    QTRY_COMPARE(robot->answers.size(), 2);
    QCOMPARE(at(robot->answers.first(), "id").toString(), QStringLiteral("second"));
  }

  void aTopicMayBeKnownAndSilent() {
    Options options = RosRobot::still();
    options.faults.silent = {"/map", "/odom"};
    RosRobot robot(options);
    QVERIFY(at(robot->values("/rosapi/topics"), "topics").toArray().contains(QLatin1String("/map")));
    for (const char* topic : {"/map", "/odom", "/tf"}) robot->subscribe(topic);
    QTRY_VERIFY(robot->count("/tf") > 10);
    QCOMPARE(robot->topics.size(), 1);
  }

  void aTopicOfTheUsualNameMayBeSomethingElse() {
    RosFaults faults;
    faults.wrong_type = true;
    RosRobot robot(with(faults));
    QCOMPARE(at(robot->values("/rosapi/topic_type", R"({"topic":"/map"})"), "type").toString(),
             QStringLiteral("std_msgs/String"));
    robot->subscribe("/odom", R"(,"type":"nav_msgs/Odometry")");
    robot->subscribe("/map");
    QVERIFY(at(robot->first("/map"), "data").isString());
    QCOMPARE(robot->count("/odom"), 0);
  }

  void everythingMayComeInFragments() {
    RosFaults faults;
    faults.fragment_bytes = 100;
    RosRobot robot(with(faults));
    robot->send(R"({"op":"call_service","id":"c","service":"/rosapi/topics"})");
    QString text;
    QTRY_VERIFY(!robot->texts.isEmpty());
    const auto piece = [&](qsizetype i) {
      return QJsonDocument::fromJson(robot->texts[i].toUtf8()).object();
    };
    const double total = at(piece(0), "total").toDouble();
    QVERIFY(total != std::floor(total));  // as servers have it
    QTRY_COMPARE(robot->texts.size(), qsizetype(total));
    for (qsizetype i = 0; i < robot->texts.size(); ++i) {
      QCOMPARE(at(piece(i), "id").toString(), QStringLiteral("c"));
      QCOMPARE(at(piece(i), "num").toInt(), int(i));
      text += at(piece(i), "data").toString();
    }
    QCOMPARE(QJsonDocument::fromJson(text.toUtf8()).object()[QLatin1String("id")].toString(),
             QStringLiteral("c"));
  }

  void theServerMayBeGoneNowAndThen() {
    RosFaults faults;
    faults.restart_every_s = 1;
    RosRobot robot(with(faults));
    QTRY_VERIFY(!robot->isOpen());
    RosSocket again(robot.robot.rosPort());
    again.subscribe("/map_manager/map_list");
    QVERIFY(!again.first("/map_manager/map_list").isEmpty());
  }

  void linksAreDroppedAndCounted() {
    RosRobot robot;
    QTRY_COMPARE(robot.robot.openRosLinks(), 1);
    robot.robot.dropWebSockets();
    QCOMPARE(robot.robot.openRosLinks(), 0);
    QTRY_VERIFY(!robot->isOpen());
  }

  void aServerThatStallsKeepsItsSocketsAndSaysNothing() {
    RosRobot robot;
    robot->subscribe("/tf");
    QTRY_VERIFY(robot->count("/tf") > 2);
    int pongs = 0;
    connect(&robot->socket, &QWebSocket::pong, this, [&] { ++pongs; });
    robot.robot.stallRos();
    robot.robot.stallRos();  // once is enough
    QTest::qWait(100);       // what it had said before has come
    const qsizetype heard = robot->count("/tf");
    robot->socket.ping();
    robot->send(R"({"op":"call_service","id":"late","service":"/rosapi/topics"})");
    robot.robot.advance(1);  // nobody waits for it
    QTest::qWait(500);
    QVERIFY(robot->isOpen());
    QCOMPARE(robot->count("/tf"), heard);
    QCOMPARE(pongs, 0);
    QCOMPARE(robot->answers.size(), 0);
    robot.robot.unstallRos();
    QVERIFY(!robot->answerTo(QStringLiteral("late")).isEmpty());
    QTRY_VERIFY(robot->count("/tf") > heard && pongs > 0);
    robot.robot.stallRos();  // and may be stopped as it is
  }

  void aServiceMayRefuse() {
    RosRobot robot(with({FaultKind::Refuse, kWrites, 1, 0, "/map_manager/rename_map"}));
    robot->send(relabelling(robot));
    const QJsonObject answer = robot->answerTo(QStringLiteral("r"));
    QCOMPARE(at(answer, "result").toBool(true), false);
    QVERIFY(at(answer, "values")
                .toString()
                .startsWith(QLatin1String("service [/map_manager/rename_map] responded with an error: b'")));
    QVERIFY(robot->settle());
    QCOMPARE(label(*robot.client), QStringLiteral("Ground floor"));
  }

  void aChangeMayBeIgnoredThoughItIsAnswered() {
    RosRobot robot(with({FaultKind::Ignore, kWrites}));
    robot->send(relabelling(robot));
    const QJsonObject answer = robot->answerTo(QStringLiteral("r"));
    QCOMPARE(at(answer, "result").toBool(), true);
    QCOMPARE(at(answer, "values.result").toInt(-1), 0);
    QVERIFY(robot->settle());
    QCOMPARE(label(*robot.client), QStringLiteral("Ground floor"));
  }

  void aChangeMayBeDroppedWithTheLink() {
    RosRobot robot(with({FaultKind::Drop, kWrites}));
    robot->send(relabelling(robot));
    QTRY_VERIFY(!robot->isOpen());
    RosSocket again(robot.robot.rosPort());
    again.subscribe("/map_manager/map_list");
    again.first("/map_manager/map_list");
    QCOMPARE(label(again), QStringLiteral("Ground floor"));
  }

  void anAnswerMayBeLostWhenAllIsDone() {
    RosRobot robot(with({FaultKind::Silence, kWrites, 1, 0, "/map_manager/rename_map"}));
    robot->send(relabelling(robot));
    QTRY_COMPARE(label(*robot.client), QStringLiteral("Changed"));
    QVERIFY(robot->settle());
    QCOMPARE(robot->answers.size(), 1);
  }

  void theLinkMayBeCutWhenAllIsDone() {
    RosRobot robot(with({FaultKind::Cut, kWrites, 1, 0, "/map_manager/rename_map"}));
    robot->send(relabelling(robot));
    QTRY_VERIFY(!robot->isOpen());
    QCOMPARE(robot->answers.size(), 0);
    RosSocket again(robot.robot.rosPort());
    again.subscribe("/map_manager/map_list");
    again.first("/map_manager/map_list");
    QCOMPARE(label(again), QStringLiteral("Changed"));
  }

  void garbageComesBetweenMessages() {
    RosFaults faults;
    faults.garbage = true;
    RosRobot robot(with(faults));
    const auto odd = [&] {
      int count = 0;
      for (const QString& text : robot->texts)
        count += QJsonDocument::fromJson(text.toUtf8()).isNull() ? 1 : 0;
      return count;
    };
    QTRY_VERIFY(odd() >= 3 && robot->binaries.size() >= 2);
    QVERIFY(robot->settle());
  }

  void somebodyElseChangesThings() {
    RosFaults faults;
    faults.other_operator_every_s = 1;
    RosRobot robot(with(faults));
    robot->subscribe("/map_manager/current_map_waypoints");
    QTRY_VERIFY(robot->count("/map_manager/current_map_waypoints") >= 3);
    QVERIFY(robot->last("/map_manager/current_map_waypoints") !=
            robot->first("/map_manager/current_map_waypoints"));
  }

  void posesMayBeNoNumbers() {
    RosFaults faults;
    faults.nan_pose = true;
    RosRobot robot(with(faults));
    for (const char* topic : {"/amcl_pose", "/odom", "/tf", "/map_manager/current_map_waypoints"})
      robot->subscribe(topic);
    QVERIFY(at(robot->first("/amcl_pose"), "pose.pose.position.x").isNull());
    QVERIFY(at(robot->first("/odom"), "pose.pose.position.x").isNull());
    QVERIFY(at(robot->first("/tf"), "transforms.0.transform.translation.x").isNull());
    const QJsonObject waypoints = robot->first("/map_manager/current_map_waypoints");
    QVERIFY(at(waypoints, "waypoints.2.pose.position.x").isNull());
    QVERIFY(at(waypoints, "waypoints.0.pose.position.x").isDouble());
  }

  void orientationsMayBeZero() {
    RosFaults faults;
    faults.zero_quaternion = true;
    RosRobot robot(with(faults));
    for (const char* topic : {"/amcl_pose", "/tf", "/map_manager/current_map_waypoints"})
      robot->subscribe(topic);
    QCOMPARE(at(robot->first("/amcl_pose"), "pose.pose.orientation.w").toDouble(-1), 0.0);
    QCOMPARE(at(robot->first("/tf"), "transforms.0.transform.rotation.w").toDouble(-1), 0.0);
    const QJsonObject waypoints = robot->first("/map_manager/current_map_waypoints");
    QCOMPARE(at(waypoints, "waypoints.1.pose.orientation.w").toDouble(-1), 0.0);
    QCOMPARE(at(waypoints, "waypoints.2.pose.orientation.w").toDouble(-1), 2.0);
  }

  void framesMayHangInALoop() {
    RosFaults faults;
    faults.tf_loop = true;
    RosRobot robot(with(faults));
    robot->subscribe("/tf");
    const QJsonObject tf = robot->first("/tf");
    QCOMPARE(at(tf, "transforms.2.child_frame_id").toString(), QStringLiteral("map"));
    QCOMPARE(at(tf, "transforms.2.header.frame_id").toString(), QStringLiteral("base_link"));
  }

  void aCloudMayHaveItsBytesTheOtherWayRound() {
    RosFaults faults;
    faults.big_endian_cloud = true;
    RosRobot robot(with(faults)), plain;
    robot->subscribe("/points");
    plain->subscribe("/points");
    const QJsonObject cloud = robot->first("/points"), usual = plain->first("/points");
    QCOMPARE(at(cloud, "is_bigendian").toBool(), true);
    QCOMPARE(at(usual, "is_bigendian").toBool(true), false);
    const auto word = [](const QJsonObject& of) {
      return QByteArray::fromBase64(at(of, "data").toString().toLatin1()).first(4);
    };
    QCOMPARE(qFromBigEndian<quint32>(word(cloud).constData()),
             qFromLittleEndian<quint32>(word(usual).constData()));
  }

  void faultsComeAndGoWhileItRuns() {
    RosRobot robot;
    robot->subscribe("/amcl_pose");
    QVERIFY(at(robot->first("/amcl_pose"), "pose.pose.position.x").isDouble());
    mapwright::simulator::Faults faults;
    faults.ros.nan_pose = true;
    robot.robot.setFaults(faults);
    QTRY_VERIFY(at(robot->last("/amcl_pose"), "pose.pose.position.x").isNull());
  }
};

}  // namespace test_ros_faults

MAPWRIGHT_TEST(test_ros_faults, TestRosFaults, Core)
#include "test_ros_faults.moc"
