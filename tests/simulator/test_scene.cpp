// The parts behind the picture: the ways robots drive, and how large scenes get.
#include <cmath>

#include <QTest>

#include "simulator/lidar.h"
#include "simulator/robot_state.h"
#include "simulator/scene.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_scene {

using namespace mapwright;
using namespace mapwright::simulator;

class TestScene : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void robotsKeepClearOfEverything_data() {
    QTest::addColumn<QString>("name");
    for (const auto& [name, sentence] : sceneNames())
      QTest::newRow(name.c_str()) << QString::fromStdString(name);
  }
  void robotsKeepClearOfEverything() {
    QFETCH(QString, name);
    const auto scene = makeScene(name.toStdString(), 0, 3);
    QVERIFY(scene.has_value());
    const Eigen::Vector2d reach(2, 2);
    for (const Trajectory& trajectory : scene->trajectories) {
      QVERIFY(trajectory.submaps > 3);
      for (double s = 0; s < trajectory.drive.length_m(); s += 0.2) {
        const geometry::Pose2 pose = trajectory.drive.at(s);
        const Eigen::Vector2d here(pose.x_m, pose.y_m);
        for (const std::uint32_t index : scene->plan.near(here - reach, here + reach)) {
          const double distance = scene->plan.solids()[index].distanceTo(here);
          QVERIFY2(distance > 0.2,
                   qPrintable(QStringLiteral("trajectory %1 at %2 m: %3 m from something at %4, %5")
                                  .arg(trajectory.id)
                                  .arg(s)
                                  .arg(distance)
                                  .arg(here.x())
                                  .arg(here.y())));
        }
      }
    }
  }

  void headingsFollowTheWayWithoutJumps() {
    const auto scene = makeScene("office", 0, 1);
    QVERIFY(!scene->trajectories.empty());
    for (const Trajectory& trajectory : scene->trajectories) {
      for (double s = 0.5; s + 0.5 < trajectory.drive.length_m(); s += 0.02) {
        const geometry::Pose2 a = trajectory.drive.at(s), b = trajectory.drive.at(s + 0.02);
        QVERIFY(std::abs(geometry::normalizeAngle(b.yaw_rad - a.yaw_rad)) < 0.25);
        QVERIFY(std::hypot(b.x_m - a.x_m, b.y_m - a.y_m) < 0.021);
      }
    }
  }

  void aMapTooLargeToBeDrawnRepeatsItself() {
    const auto scene = makeScene("warehouse", 25'000, 1);
    QVERIFY(scene && scene->trajectories[0].submaps > 24'000);
    RobotState state(*scene, 1, {.paused = true});
    const auto bodyOf = [&](int index) { return makeSubmapBody(state.plan(), *state.find({0, index})); };
    QVERIFY(bodyOf(300) == bodyOf(300 - 256));
    QVERIFY(bodyOf(300) != bodyOf(301));
    const map::SubmapList list = state.list();
    QVERIFY(list.entries[300].pose.x != list.entries[300 - 256].pose.x ||
            list.entries[300].pose.y != list.entries[300 - 256].pose.y);
    // One that is changed is itself.
    const std::string before = bodyOf(300);
    state.bump({0, 300});
    QVERIFY(bodyOf(300) != before);
    QVERIFY(bodyOf(300 - 256) == before);
  }

  void closedDrivesWrap() {
    const Drive square({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true);
    const geometry::Pose2 a = square.at(3), b = square.at(3 + square.length_m()),
                          c = square.at(3 - square.length_m());
    QVERIFY(std::hypot(a.x_m - b.x_m, a.y_m - b.y_m) < 1e-9);
    QVERIFY(std::hypot(a.x_m - c.x_m, a.y_m - c.y_m) < 1e-9);
  }

  void scenesGrowToTheSizeAskedFor_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("submaps");
    for (const std::string name : {"office", "warehouse", "campus"}) {
      for (const int submaps : {1, 10, 500, 10'000}) {
        QTest::newRow((name + " " + std::to_string(submaps)).c_str())
            << QString::fromStdString(name) << submaps;
      }
    }
  }
  void scenesGrowToTheSizeAskedFor() {
    QFETCH(QString, name);
    QFETCH(int, submaps);
    const auto scene = makeScene(name.toStdString(), submaps, 1);
    QVERIFY(scene.has_value());
    QCOMPARE(scene->trajectories.front().submaps, submaps);
    QVERIFY(scene->trajectories.front().drive.length_m() >= submaps * 4.8);
  }

  void unknownScenesDoNotExist() { QVERIFY(!makeScene("moon", 0, 1).has_value()); }

  void aWallIsSeenWhereItStands() {
    // A wall across x = 3, seen from the origin; the slice frame is turned and its rows run along its -x.
    const FloorPlan plan({{{3.1, 0}, {0.1, 40}, 0, false, false}});
    const ScanGrid grid = scanGrid(plan, {}, {{{0, 0, 0}, 1}, {{0, 0.01, 0}, 2}}, {0.5, 0.25}, 0.7, {});
    int walls = 0;
    for (int v = 0; v < grid.height; ++v) {
      for (int u = 0; u < grid.width; ++u) {
        const int cell = grid.cells[std::size_t(v * grid.width + u)];
        const Eigen::Vector2d at = grid.world_from_slice.apply({-(v + 0.5) * 0.05, -(u + 0.5) * 0.05});
        if (cell == 0) continue;
        QVERIFY(at.x() < 3.2);
        if (cell > 150) {
          ++walls;
          QVERIFY2(at.x() > 2.9, qPrintable(QString::number(at.x())));
        } else if (cell < 110) {
          QVERIFY(at.x() < 3.05);
        }
      }
    }
    QVERIFY(walls > 20);
  }
};

}  // namespace test_scene

MAPWRIGHT_TEST(test_scene, TestScene, Core)
#include "test_scene.moc"
