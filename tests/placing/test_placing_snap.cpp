// What catches a waypoint that is moved by hand.
#include <QtTest>

#include "geometry/pose.h"
#include "ground_maps.h"
#include "placing/snap.h"
#include "test_program.h"

namespace test_placing_snap {

using namespace mapwright;
using namespace mapwright::placing;

namespace {

/// Everything off but what a test turns on; the hand reaches 10 cm, and sees 20 m x 20 m.
struct Bench {
  Bench() { rules.waypoints = rules.grid = rules.walls = false; }
  SnappedPlace at(double x, double y) {
    SnapScene scene;
    scene.seen = {0, 0, 20, 20};
    scene.reach_m = 0.1;
    scene.others = [this](const geometry::WorldRect& area,
                          const std::function<void(const Eigen::Vector2d&)>& found) {
      for (const Eigen::Vector2d& other : others) {
        if (area.contains(other)) found(other);
      }
    };
    scene.ground = ground ? &*ground : nullptr;
    return snapped({x, y}, rules, scene);
  }
  std::vector<Caught> why(double x, double y) {
    std::vector<Caught> what;
    for (const Guide& guide : at(x, y).guides) what.push_back(guide.what);
    return what;
  }
  SnapRules rules;
  std::vector<Eigen::Vector2d> others;
  std::optional<Ground> ground;
};

bool same(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return (a - b).norm() < 1e-9; }

}  // namespace

class TestPlacingSnap : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void withoutRulesNothingIsCaught() {
    Bench bench;
    bench.others = {{1, 1}};
    QCOMPARE(bench.at(1.01, 1.01).at_m, Eigen::Vector2d(1.01, 1.01));
    QVERIFY(bench.at(1.01, 1.01).guides.empty());
  }

  void anotherWaypointIsCaughtBeforeItsLines() {
    Bench bench;
    bench.rules.waypoints = true;
    bench.others = {{1, 1}, {1.05, 1.12}, {7, 1.01}};
    QCOMPARE(bench.at(1.02, 1.03).at_m, Eigen::Vector2d(1, 1));
    QCOMPARE(bench.why(1.02, 1.03), std::vector{Caught::Point});
  }

  void linesThroughOthersAreCaughtAlongBothAxes() {
    Bench bench;
    bench.rules.waypoints = true;
    bench.others = {{1, 1}, {7, 9}};
    QCOMPARE(bench.at(1.04, 5).at_m, Eigen::Vector2d(1, 5));
    QCOMPARE(bench.why(1.04, 5), std::vector{Caught::LineX});
    const SnappedPlace both = bench.at(0.96, 8.95);
    QCOMPARE(both.at_m, Eigen::Vector2d(1, 9));
    QCOMPARE(both.guides.size(), std::size_t(2));
    for (const Guide& guide : both.guides) QCOMPARE(guide.to_m, Eigen::Vector2d(1, 9));
    QCOMPARE(both.guides[0].from_m, Eigen::Vector2d(1, 1));
    QCOMPARE(both.guides[1].from_m, Eigen::Vector2d(7, 9));
    QVERIFY(bench.at(1.11, 5).guides.empty());
  }

  void ofSeveralLinesTheNearestIsTakenAndOfAlikeTheNearestWaypoint() {
    Bench bench;
    bench.rules.waypoints = true;
    bench.others = {{1.05, 1}, {0.98, 19}, {0.98, 7}};
    const SnappedPlace place = bench.at(1, 5);
    QCOMPARE(place.at_m, Eigen::Vector2d(0.98, 5));
    QCOMPARE(place.guides[0].from_m, Eigen::Vector2d(0.98, 7));
    bench.others = {{1, 50}};  // out of sight
    QVERIFY(bench.at(1.01, 5).guides.empty());
  }

  void theGridIsCaughtWithinReach() {
    Bench bench;
    bench.rules.grid = true;
    bench.rules.grid_m = 0.5;
    QCOMPARE(bench.at(1.04, 2.53).at_m, Eigen::Vector2d(1, 2.5));
    QCOMPARE(bench.why(1.04, 2.53), (std::vector{Caught::GridX, Caught::GridY}));
    QCOMPARE(bench.at(1.2, 2.53).at_m, Eigen::Vector2d(1.2, 2.5));
    QVERIFY(bench.at(1.2, 2.3).guides.empty());
    // A guide of the grid runs across all that is seen.
    const Guide guide = bench.at(1.2, 2.53).guides[0];
    QCOMPARE(guide.from_m, Eigen::Vector2d(0, 2.5));
    QCOMPARE(guide.to_m, Eigen::Vector2d(20, 2.5));
    // What is nearer counts.
    bench.rules.waypoints = true;
    bench.others = {{1.06, 9}};
    QCOMPARE(bench.at(1.04, 2.3).at_m.x(), 1.06);
    QCOMPARE(bench.at(1.01, 2.3).at_m.x(), 1.0);
  }

  void aPlaceIsCaughtAtItsDistanceFromAWall() {
    Bench bench;
    bench.rules.walls = true;
    bench.rules.wall_m = 0.5;
    // A wall of 10 cm along the left edge.
    bench.ground.emplace(test::mapOf(100, 100, [](int x, int) { return x == 0 ? '#' : '.'; }),
                         Ground::Access::AtHand);
    const SnappedPlace place = bench.at(0.65, 5.23);
    QVERIFY(same(place.at_m, {0.6, 5.23}));
    QCOMPARE(place.guides.size(), std::size_t(1));
    QCOMPARE(place.guides[0].what, Caught::Wall);
    QVERIFY(same(place.guides[0].from_m, {0.1, 5.23}));
    QVERIFY(same(bench.at(0.53, 5.2).at_m, {0.6, 5.2}));
    QVERIFY(bench.at(0.75, 5).guides.empty());
    QVERIFY(bench.at(0.05, 5).guides.empty());  // in it there is no side to go to
    // Along the wall other lines are caught, and its foot goes along.
    bench.rules.grid = true;
    const SnappedPlace both = bench.at(0.65, 5.04);
    QVERIFY(same(both.at_m, {0.6, 5}));
    QVERIFY(same(both.guides[0].from_m, {0.1, 5}) && same(both.guides[0].to_m, {0.6, 5}));
  }

  void inACornerTheDistanceHoldsToTheNearestOfTheWalls() {
    Bench bench;
    bench.rules.walls = true;
    bench.rules.wall_m = 0.5;
    bench.ground.emplace(test::mapOf(100, 100, [](int x, int y) { return x == 0 || y == 99 ? '#' : '.'; }),
                         Ground::Access::AtHand);
    for (const auto& [x, y] : {std::pair(0.62, 0.57), std::pair(0.57, 0.63), std::pair(0.66, 0.66)}) {
      const SnappedPlace place = bench.at(x, y);
      if (place.guides.empty()) continue;
      const auto wall = bench.ground->nearestWall(place.at_m, 2);
      QVERIFY2(std::abs(wall->distance_m - 0.5) < 0.031, qPrintable(QString::number(wall->distance_m)));
    }
    QVERIFY(!bench.at(0.62, 0.57).guides.empty());
  }

  void aWallAtAnAngleIsCaughtAcrossIt() {
    Bench bench;
    bench.rules.walls = true;
    bench.rules.wall_m = 0.5;
    bench.rules.grid = true;  // which must not pull it off
    bench.ground.emplace(test::mapOf(100, 100, [](int x, int y) { return x + 99 - y < 60 ? '#' : '.'; }),
                         Ground::Access::AtHand);
    const Eigen::Vector2d free = Eigen::Vector2d(3.03, 3.03) + Eigen::Vector2d(0.53, 0.53) / std::sqrt(2.0);
    const SnappedPlace place = bench.at(free.x(), free.y());
    QVERIFY(!place.guides.empty());
    QCOMPARE(place.guides[0].what, Caught::Wall);
    QVERIFY(std::abs(bench.ground->nearestWall(place.at_m, 2)->distance_m - 0.5) < 0.031);
  }

  void headingsAreCaughtBySteps() {
    const auto deg = geometry::radiansFromDegrees;
    const auto snapped = [&](double yaw, double reach) {
      return geometry::degreesFromRadians(snappedHeading(deg(yaw), deg(reach)));
    };
    QVERIFY(std::abs(snapped(43, 3) - 45) < 1e-9);
    QVERIFY(std::abs(snapped(41, 3) - 41) < 1e-9);
    QVERIFY(std::abs(snapped(-179, 3) - 180) < 1e-9);
    QVERIFY(std::abs(snapped(52, 180) - 45) < 1e-9);
  }

  void whatIsNoPlaceIsLeftAlone() {
    Bench bench;
    bench.rules = {};
    bench.rules.grid = bench.rules.walls = true;
    QVERIFY(bench.at(std::nan(""), 0).guides.empty());
  }
};

}  // namespace test_placing_snap

MAPWRIGHT_TEST(test_placing_snap, TestPlacingSnap, Nothing)
#include "test_placing_snap.moc"
