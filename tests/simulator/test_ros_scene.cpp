// What the simulated ROS robot says on its topics: the same building as its siblings', in frames that fit.
#include <cmath>
#include <complex>
#include <cstring>

#include <QTest>

#include "ros_socket.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_ros_scene {

using mapwright::simulator::Options;

namespace {

/// A pose of the plane as a rotation and a shift: world = r * p + t.
struct Plane {
  std::complex<double> r{1, 0}, t{0, 0};
  Plane operator*(const Plane& o) const { return {r * o.r, r * o.t + t}; }
  std::complex<double> apply(std::complex<double> p) const { return r * p + t; }
};

Plane planeOf(const QJsonObject& place, const QJsonObject& turn) {
  const double z = at(turn, "z").toDouble(), w = at(turn, "w").toDouble();
  return {{w * w - z * z, 2 * w * z}, {at(place, "x").toDouble(), at(place, "y").toDouble()}};
}

Plane poseOf(const QJsonObject& pose) {
  return planeOf(at(pose, "position").toObject(), at(pose, "orientation").toObject());
}

/// The transform of `child` in a TFMessage.
Plane transformOf(const QJsonObject& message, const char* child) {
  for (const QJsonValue& one : at(message, "transforms").toArray()) {
    const QJsonObject stamped = one.toObject();
    if (at(stamped, "child_frame_id").toString() == QLatin1String(child))
      return planeOf(at(stamped, "transform.translation").toObject(),
                     at(stamped, "transform.rotation").toObject());
  }
  return {{0, 0}, {0, 0}};
}

/// The cell at a place of the grid's own frame; -2 outside.
int cellAt(const QJsonObject& grid, const QJsonArray& cells, std::complex<double> place) {
  const double resolution = at(grid, "info.resolution").toDouble();
  const int u = int(std::floor((place.real() - at(grid, "info.origin.position.x").toDouble()) / resolution));
  const int v = int(std::floor((place.imag() - at(grid, "info.origin.position.y").toDouble()) / resolution));
  const int width = at(grid, "info.width").toInt(), height = at(grid, "info.height").toInt();
  return u < 0 || v < 0 || u >= width || v >= height ? -2 : cells[qsizetype(v) * width + u].toInt();
}

}  // namespace

class TestRosScene : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theFramesLeadFromTheMapToTheRobotAndItsLaser() {
    RosRobot robot;
    for (const char* topic : {"/tf", "/tf_static", "/amcl_pose", "/odom"}) robot->subscribe(topic);
    const QJsonObject tf = robot->first("/tf");
    const Plane base = transformOf(tf, "odom") * transformOf(tf, "base_link");
    const Plane amcl = poseOf(at(robot->first("/amcl_pose"), "pose.pose").toObject());
    QVERIFY(std::abs(base.t - amcl.t) < 1e-6 && std::abs(base.r - amcl.r) < 1e-6);
    QCOMPARE(at(robot->first("/amcl_pose"), "header.frame_id").toString(), QStringLiteral("map"));
    const Plane odometry = poseOf(at(robot->first("/odom"), "pose.pose").toObject());
    QVERIFY(std::abs(odometry.t - transformOf(tf, "base_link").t) < 1e-6);
    QVERIFY(std::abs(transformOf(tf, "odom").t) > 0.1);  // odometry has drifted
    QVERIFY(std::abs(transformOf(robot->first("/tf_static"), "laser").t) > 0.1);
  }

  void whatTheLaserHitsIsOccupiedInTheMap() {
    RosRobot robot;
    for (const char* topic : {"/tf", "/tf_static", "/scan", "/map", "/points"}) robot->subscribe(topic);
    const QJsonObject tf = robot->first("/tf"), map = robot->first("/map"), scan = robot->first("/scan");
    const Plane laser = transformOf(tf, "odom") * transformOf(tf, "base_link") *
                        transformOf(robot->first("/tf_static"), "laser");
    const QJsonArray cells = at(map, "data").toArray(), ranges = at(scan, "ranges").toArray();
    QCOMPARE(cells.size(), qsizetype(at(map, "info.width").toInt()) * at(map, "info.height").toInt());
    QCOMPARE(ranges.size(), 720);
    int seen = 0, fitting = 0;
    const auto fits = [&](std::complex<double> hit) {
      ++seen;
      for (double dx = -0.1; dx <= 0.11; dx += 0.05) {
        for (double dy = -0.1; dy <= 0.11; dy += 0.05) {
          if (cellAt(map, cells, hit + std::complex(dx, dy)) == 100) return true;
        }
      }
      return false;
    };
    for (qsizetype i = 0; i < ranges.size(); ++i) {
      if (ranges[i].isNull()) continue;
      const double angle =
          at(scan, "angle_min").toDouble() + double(i) * at(scan, "angle_increment").toDouble();
      if (ranges[i].toDouble() < 10 && fits(laser.apply(std::polar(ranges[i].toDouble(), angle)))) ++fitting;
    }
    QVERIFY(seen > 200);
    QVERIFY2(fitting > seen * 9 / 10, qPrintable(QStringLiteral("%1 of %2").arg(fitting).arg(seen)));

    seen = fitting = 0;
    const QJsonObject cloud = robot->first("/points");
    const QByteArray data = QByteArray::fromBase64(at(cloud, "data").toString().toLatin1());
    const int step = at(cloud, "point_step").toInt();
    QCOMPARE(data.size(), qsizetype(at(cloud, "width").toInt()) * step);
    for (qsizetype from = 0; from < data.size(); from += step) {
      float xy[2];
      std::memcpy(xy, data.constData() + from, sizeof xy);
      if (std::hypot(xy[0], xy[1]) < 10 && fits(laser.apply({xy[0], xy[1]}))) ++fitting;
    }
    QVERIFY2(fitting > seen * 9 / 10, qPrintable(QStringLiteral("%1 of %2").arg(fitting).arg(seen)));
  }

  void costsLieWhereTheMapIsOccupied() {
    RosRobot robot;
    for (const char* topic : {"/map", "/global_costmap/costmap", "/local_costmap/costmap", "/tf",
                              "/global_costmap/costmap_updates"})
      robot->subscribe(topic);
    const QJsonObject map = robot->first("/map"), costs = robot->first("/global_costmap/costmap"),
                      local = robot->first("/local_costmap/costmap"), tf = robot->first("/tf");
    QCOMPARE(at(costs, "info").toObject(), at(map, "info").toObject());
    QCOMPARE(at(local, "header.frame_id").toString(), QStringLiteral("odom"));
    const QJsonArray cells = at(map, "data").toArray(), cost = at(costs, "data").toArray(),
                     near = at(local, "data").toArray();
    int walls = 0, costly = 0, alike = 0, both = 0;
    for (qsizetype i = 0; i < cells.size(); i += 7) {
      if (cells[i].toInt() != 100) continue;
      ++walls;
      if (cost[i].toInt() >= 50) ++costly;
    }
    QVERIFY(walls > 500);
    QVERIFY2(costly > walls * 9 / 10, qPrintable(QStringLiteral("%1 of %2").arg(costly).arg(walls)));
    // The local one is turned against the map, and shows the same walls.
    const Plane odom = transformOf(tf, "odom");
    const int width = at(local, "info.width").toInt();
    for (qsizetype i = 0; i < near.size(); i += 5) {
      const double resolution = at(local, "info.resolution").toDouble();
      const std::complex<double> place(
          at(local, "info.origin.position.x").toDouble() + resolution * (double(i % width) + 0.5),
          at(local, "info.origin.position.y").toDouble() + resolution * (double(i / width) + 0.5));
      const int there = cellAt(costs, cost, odom.apply(place));
      if (there == -2) continue;
      ++both;
      if (std::abs(there - near[i].toInt()) < 40) ++alike;
    }
    QVERIFY(both > 1000);
    QVERIFY2(alike > both * 8 / 10, qPrintable(QStringLiteral("%1 of %2").arg(alike).arg(both)));
    const QJsonObject patch = robot->first("/global_costmap/costmap_updates");
    QCOMPARE(at(patch, "data").toArray().size(),
             qsizetype(at(patch, "width").toInt()) * at(patch, "height").toInt());
    QVERIFY(at(patch, "x").toInt() + at(patch, "width").toInt() <= at(map, "info.width").toInt());
  }

  void pathsBeginAtTheRobotAndTheFootprintLiesAroundIt() {
    RosRobot robot;
    for (const char* topic : {"/plan", "/local_plan", "/goal_pose", "/amcl_pose", "/odom", "/markers",
                              "/move_base/local_costmap/footprint"})
      robot->subscribe(topic);
    const Plane here = poseOf(at(robot->first("/amcl_pose"), "pose.pose").toObject());
    const QJsonArray plan = at(robot->first("/plan"), "poses").toArray();
    QVERIFY(plan.size() > 2);
    QVERIFY(std::abs(poseOf(at(plan.first().toObject(), "pose").toObject()).t - here.t) < 1e-6);
    QVERIFY(std::abs(poseOf(at(plan.last().toObject(), "pose").toObject()).t -
                     poseOf(at(robot->first("/goal_pose"), "pose").toObject()).t) < 1e-6);
    const Plane odom = poseOf(at(robot->first("/odom"), "pose.pose").toObject());
    const QJsonArray local = at(robot->first("/local_plan"), "poses").toArray();
    QVERIFY(std::abs(poseOf(at(local.first().toObject(), "pose").toObject()).t - odom.t) < 1e-6);
    const QJsonArray corners =
        at(robot->first("/move_base/local_costmap/footprint"), "polygon.points").toArray();
    QCOMPARE(corners.size(), 4);
    for (const QJsonValue& corner : corners) {
      const std::complex<double> point(corner[QLatin1String("x")].toDouble(),
                                       corner[QLatin1String("y")].toDouble());
      QVERIFY(std::abs(point - odom.t) < 0.5);
    }
    QSet<int> types;
    for (const QJsonValue& marker : at(robot->first("/markers"), "markers").toArray())
      types.insert(marker[QLatin1String("type")].toInt());
    QCOMPARE(types, QSet<int>({0, 1, 2, 3, 4, 8, 9}));
  }

  void aRobotThatStandsStillSaysTheSameAgain() {
    RosRobot robot, twin;
    for (const char* topic : {"/odom", "/scan", "/plan", "/map_manager/current_map_info"}) {
      robot->subscribe(topic);
      twin->subscribe(topic);
      QVERIFY(!robot->first(topic).isEmpty());
      QCOMPARE(robot->first(topic), twin->first(topic));
    }
    QTRY_VERIFY(robot->count("/odom") > 3);
    QCOMPARE(robot->last("/odom"), robot->first("/odom"));
    robot.robot.advance(2);
    QTRY_VERIFY(robot->last("/odom") != robot->first("/odom"));
    QTRY_VERIFY(robot->last("/plan") != robot->first("/plan"));
  }

  void aMapGrowsWhileMapping() {
    RosRobot robot;
    robot->subscribe("/map");
    robot->subscribe("/map_updates");
    const auto known = [&](const QJsonObject& grid) {
      int cells = 0;
      for (const QJsonValue& cell : at(grid, "data").toArray()) cells += cell.toInt() >= 0 ? 1 : 0;
      return cells;
    };
    const int whole = known(robot->first("/map"));
    QCOMPARE(at(robot->values("/map_manager/start_mapping"), "success").toBool(), true);
    QTRY_VERIFY(robot->count("/map") >= 2);
    const int begun = known(robot->last("/map"));
    QVERIFY2(begun > 0 && begun < whole, qPrintable(QStringLiteral("%1 of %2").arg(begun).arg(whole)));
    robot.robot.advance(40);
    QTRY_VERIFY(known(robot->last("/map")) > begun);
    const QJsonObject patch = robot->first("/map_updates");
    QCOMPARE(at(patch, "data").toArray().size(),
             qsizetype(at(patch, "width").toInt()) * at(patch, "height").toInt());
  }

  void topicsComeAsOftenAsOnRealRobots() {
    Options options = RosRobot::still();
    options.paused = false;
    RosRobot robot(options);
    for (const char* topic : {"/tf", "/odom", "/scan"}) robot->subscribe(topic, R"(,"queue_length":1)");
    QTRY_VERIFY(robot->count("/scan") >= 10);
    // Each is left out where the machine is busy, never sent more often.
    QVERIFY(robot->count("/tf") > robot->count("/odom"));
    QVERIFY(robot->count("/odom") > robot->count("/scan"));
    QVERIFY(robot->count("/tf") <= 6 * robot->count("/scan") + 20);
  }

  void theMapIsAServiceToo() {
    RosRobot robot;
    robot->subscribe("/map");
    QCOMPARE(at(robot->values("/static_map"), "map").toObject(), robot->first("/map"));
  }

  void aRobotWithoutAMapHasNothingToShow() {
    Options options = RosRobot::still();
    options.scene = "empty";
    RosRobot robot(options);
    robot->subscribe("/map");
    robot->subscribe("/map_manager/current_map_info");
    QCOMPARE(at(robot->first("/map_manager/current_map_info"), "map_manager_state").toString(),
             QStringLiteral("IDLE"));
    QCOMPARE(at(robot->ask("/static_map"), "result").toBool(true), false);
    QCOMPARE(robot->count("/map"), 0);
  }
};

}  // namespace test_ros_scene

MAPWRIGHT_TEST(test_ros_scene, TestRosScene, Core)
#include "test_ros_scene.moc"
