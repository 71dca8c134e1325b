// What the map says of a place: its cell, the next wall, and what is doubtful about a waypoint there.
#include <QtTest>

#include "geometry/pose.h"
#include "grids/grid_pyramid.h"
#include "ground_maps.h"
#include "map/live_topics.h"
#include "placing/warnings.h"
#include "test_program.h"

namespace test_placing_ground {

using namespace mapwright;
using namespace mapwright::placing;

namespace {

using Patience = Ground::Access;

bool near(double a, double b) { return std::abs(a - b) < 1e-9; }

/// Every occupied cell is looked at: slow and plain.
std::optional<double> wallByHand(const PlacedMap& map, const Eigen::Vector2d& world_m, double reach_m) {
  const Eigen::Vector2d from = map.reference.cellFromWorld(world_m);
  std::optional<double> best;
  for (int y = 0; y < map.reference.height; ++y) {
    for (int x = 0; x < map.reference.width; ++x) {
      if (map.cells->at(x, y) != 100) continue;
      const Eigen::Vector2d on(std::clamp(from.x(), double(x), x + 1.0),
                               std::clamp(from.y(), double(y), y + 1.0));
      const double distance = (on - from).norm() * map.reference.resolution_m;
      if (distance < reach_m && (!best || distance < *best)) best = distance;
    }
  }
  return best;
}

std::vector<WarningKind> kindsOf(const Warnings& warnings) {
  std::vector<WarningKind> kinds;
  for (const Warning& warning : warnings) kinds.push_back(warning.kind);
  return kinds;
}

Warnings at(const PlacedMap& map, double x, double y, double radius_m = 0.25) {
  return groundWarnings({{x, y}}, map, radius_m, nullptr).of.front();
}

}  // namespace

class TestPlacingGround : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aCellIsWhatTheMapSaysThere() {
    const PlacedMap map = test::mapOf({"..#", ". ."});
    for (const Patience patience : {Patience::AtHand, Patience::Wait}) {
      Ground ground(map, patience);
      QVERIFY(ground.there());
      QCOMPARE(ground.at({0.05, 0.15}), Cell::Free);
      QCOMPARE(ground.at({0.25, 0.15}), Cell::Occupied);
      QCOMPARE(ground.at({0.15, 0.05}), Cell::Unknown);
      QCOMPARE(ground.at({0.35, 0.05}), Cell::Outside);
      QCOMPARE(ground.at({-0.01, 0.05}), Cell::Outside);
      QCOMPARE(ground.at({std::nan(""), 0}), Cell::Outside);
      QCOMPARE(ground.at({1e300, -1e300}), Cell::Outside);
    }
  }

  void aMapThatIsTurnedIsAskedWhereItLies() {
    PlacedMap map = test::mapOf({"..#"});
    map.reference.origin = {5, 5, geometry::radiansFromDegrees(90)};
    Ground ground(map, Patience::Wait);
    QCOMPARE(ground.at({4.95, 5.25}), Cell::Occupied);  // along y now
    const auto wall = ground.nearestWall({4.95, 5.05}, 1);
    QVERIFY(wall && near(wall->distance_m, 0.15));
    QVERIFY((wall->at_m - Eigen::Vector2d(4.95, 5.2)).norm() < 1e-9);
  }

  void theDistanceIsThatToTheEdgeOfTheNearestWall() {
    const PlacedMap map = test::mapOf({".....", "....#", ".....", "#...."});
    Ground ground(map, Patience::Wait);
    const auto wall = ground.nearestWall({0.25, 0.25}, 1);
    QVERIFY(wall && near(wall->distance_m, 0.15));
    QVERIFY((wall->at_m - Eigen::Vector2d(0.4, 0.25)).norm() < 1e-9);
    QVERIFY(near(ground.nearestWall({0.05, 0.02}, 1)->distance_m, 0));
    QVERIFY(!ground.nearestWall({0.25, 0.25}, 0.14));
    QVERIFY(!ground.nearestWall({0.25, 0.25}, 0));
    QVERIFY(near(ground.nearestWall({0.45, 0.95}, 1)->distance_m, 0.65));  // from beside the map
    QVERIFY(!ground.nearestWall({500, -1e9}, 1));
  }

  void theCoarserLevelsFindTheSameAsEveryCell_data() {
    QTest::addColumn<int>("reduction");
    QTest::newRow("the fullest cell wins") << int(grids::Reduction::OccupiedWins);
    QTest::newRow("averages, which tell nothing of single cells") << int(grids::Reduction::Average);
  }
  void theCoarserLevelsFindTheSameAsEveryCell() {
    QFETCH(int, reduction);
    const PlacedMap map = test::mapOf(
        611, 300,
        [](int x, int y) {
          const std::uint32_t dice = test::noise(std::uint32_t(y * 611 + x)) % 1000;
          return dice < 2 ? '#' : dice < 100 ? ' ' : '.';
        },
        grids::Reduction(reduction));
    Ground ground(map, Patience::Wait);
    for (std::uint32_t i = 0; i < 50; ++i) {
      const Eigen::Vector2d place(test::noise(3 * i) % 63000 / 1000.0 - 1,
                                  test::noise(3 * i + 1) % 32000 / 1000.0 - 1);
      for (const double reach_m : {0.3, 1.1, 6.0}) {
        const auto by_hand = wallByHand(map, place, reach_m);
        const auto found = ground.nearestWall(place, reach_m);
        QCOMPARE(found.has_value(), by_hand.has_value());
        if (found)
          QVERIFY2(near(found->distance_m, *by_hand), qPrintable(QString::number(found->distance_m)));
      }
    }
  }

  void whatIsAtHandFindsTheSameNearBy() {
    const PlacedMap map = test::mapOf(
        300, 300, [](int x, int y) { return test::noise(std::uint32_t(y * 300 + x)) % 300 ? '.' : '#'; });
    Ground quick(map, Patience::AtHand), exact(map, Patience::Wait);
    for (std::uint32_t i = 0; i < 100; ++i) {
      const Eigen::Vector2d place(test::noise(i) % 30000 / 1000.0, test::noise(i + 999) % 30000 / 1000.0);
      const auto one = quick.nearestWall(place, 2), other = exact.nearestWall(place, 2);
      QCOMPARE(one.has_value(), other.has_value());
      if (one) QVERIFY(near(one->distance_m, other->distance_m));
    }
  }

  void aWaypointIsWarnedOfByWhatIsBelow() {
    const PlacedMap map = test::mapOf({"..........", "..........", "#.......  ", "#.......  "});
    QVERIFY(at(map, 0.55, 0.15).empty());
    QCOMPARE(kindsOf(at(map, 0.05, 0.05)), std::vector{WarningKind::InWall});
    QCOMPARE(kindsOf(at(map, 0.2, 0.1)), std::vector{WarningKind::NearWall});
    QVERIFY(near(at(map, 0.2, 0.1).front().distance_m, 0.1));
    QVERIFY(near(at(map, 0.2, 0.1).front().radius_m, 0.25));
    QVERIFY(at(map, 0.2, 0.1, 0.05).empty());
    QVERIFY(at(map, 0.2, 0.1, 0).empty());  // of no radius
    QCOMPARE(kindsOf(at(map, 0.85, 0.05)), std::vector{WarningKind::OnUnknown});
    QCOMPARE(kindsOf(at(map, 5, 5)), std::vector{WarningKind::OutsideMap});
    QCOMPARE(kindsOf(at(map, -0.1, 0.05)), (std::vector{WarningKind::OutsideMap, WarningKind::NearWall}));
  }

  void wherePartOfAMapEndsNothingIsKnownOfTheMap() {
    PlacedMap part = test::mapOf({"..........", "#........."});
    part.is_part = true;
    QVERIFY(at(part, 5, 5).empty());
    QCOMPARE(kindsOf(at(part, -0.1, 0.05)), std::vector{WarningKind::NearWall});
    QCOMPARE(kindsOf(at(part, 0.05, 0.05)), std::vector{WarningKind::InWall});
  }

  void aMapThatKnowsNothingSaysSoOnce() {
    const PlacedMap map = test::mapOf({"   ", "   "});
    const auto found = groundWarnings({{0.1, 0.1}, {9, 9}}, map, 0.3, nullptr);
    QCOMPARE(found.state, GroundState::Unknown);
    QVERIFY(found.of[0].empty());
    QCOMPARE(kindsOf(found.of[1]), std::vector{WarningKind::OutsideMap});
    QCOMPARE(groundWarnings({{0, 0}}, {}, 0.3, nullptr).state, GroundState::None);
    QCOMPARE(groundWarnings({}, test::mapOf({"."}), 0.3, nullptr).state, GroundState::Known);
  }

  void aMapWithoutASizeOfItsCellsIsNone() {
    PlacedMap map = test::mapOf({"..."});
    map.reference.resolution_m = 0;
    QVERIFY(!Ground(map, Patience::Wait).there());
    QVERIFY(!Ground(map, Patience::Wait).nearestWall({0, 0}, 1));
    QCOMPARE(groundWarnings({{0, 0}}, map, 0.3, nullptr).state, GroundState::None);
  }

  void allComesTogetherTheGravestFirst() {
    const Warnings ground{{WarningKind::NearWall, 0.1, 0.3}};
    QCOMPARE(kindsOf(together(ground, "Dock", true, true)),
             (std::vector{WarningKind::NearWall, WarningKind::NameTwice, WarningKind::ZeroTurn}));
    QVERIFY(together({}, "Dock", false, false).empty());
    QCOMPARE(kindsOf(together({}, "Dock ~1", false, false)), std::vector{WarningKind::TemporaryName});
  }

  void groupsTogetherSayTheSameAsAll() {
    const PlacedMap map = test::mapOf(900, 700, [](int x, int y) {
      const std::uint32_t dice = test::noise(std::uint32_t(y * 900 + x)) % 100;
      return dice < 3 ? '#' : dice < 6 ? ' ' : '.';
    });
    std::vector<Eigen::Vector2d> places;
    for (std::uint32_t i = 0; i < 1'000; ++i)
      places.emplace_back(test::noise(2 * i) % 95000 / 1000.0 - 1,
                          test::noise(2 * i + 1) % 75000 / 1000.0 - 1);
    places.emplace_back(std::nan(""), 0);
    const auto all = groundWarnings(places, map, 0.3, nullptr);
    const auto groups = groupsOf(places, map.reference, 300);
    QCOMPARE(groups.size(), std::size_t(4));
    std::vector<int> seen(places.size());
    for (const std::vector<std::size_t>& group : groups) {
      QVERIFY(group.size() <= 300);
      std::vector<Eigen::Vector2d> part;
      for (const std::size_t i : group) part.push_back(places[i]);
      const auto found = groundWarnings(part, map, 0.3, nullptr);
      for (std::size_t i = 0; i < group.size(); ++i) {
        ++seen[group[i]];
        QVERIFY(found.of[i] == all.of[group[i]]);
      }
    }
    QCOMPARE(seen, std::vector<int>(places.size(), 1));
    QCOMPARE(groupsOf(places, {}, 5'000).size(), std::size_t(1));  // no map
    QVERIFY(groupsOf({}, map.reference, 300).empty());
  }

  void aRobotReachesAsFarAsItsFarthestCorner() {
    map::RobotModel model;
    QCOMPARE(radiusOf(model), 0.0);
    model.width_m = 0.8;
    QCOMPARE(radiusOf(model), 0.4);
    model.footprint = {{0.3, 0.4}, {-0.1, 0.1}};
    QCOMPARE(radiusOf(model), 0.5);
    model.footprint = {{300, 400}};
    QCOMPARE(radiusOf(model), 0.0);  // none is as large as that
  }

  void whatIsCancelledEndsEarly() {
    const PlacedMap map = test::mapOf({"#"});
    const std::atomic<bool> cancelled{true};
    const auto found = groundWarnings({{0.05, 0.05}}, map, 0.3, &cancelled);
    QCOMPARE(found.of.size(), std::size_t(1));
    QVERIFY(found.of[0].empty());
  }
};

}  // namespace test_placing_ground

MAPWRIGHT_TEST(test_placing_ground, TestPlacingGround, Nothing)
#include "test_placing_ground.moc"
