// Waypoints of an old map on a new one: where they go, and what is said of each.
#include <QtTest>

#include "site.h"
#include "test_program.h"

namespace test_carried {

using namespace mapwright;
using namespace mapwright::testing;
using carry::Carried;
using carry::Verdict;

namespace {

/// One beside a wall, one in the small room, one in the middle of the large one.
const std::vector<carry::Spot> kSpots{{{1.5, 2}, 0.5}, {{18, 5}, std::nullopt}, {{2.5, 8}, -3.0}};

std::vector<Carried> carriedTo(const TwoMaps& maps, bool adjust = false) {
  return maps.site().carried(kSpots, {.radius_m = 0.3, .adjust = adjust});
}

bool at(const Carried& one, const Eigen::Vector2d& old_m, double within_m = 1e-6) {
  return (one.spot.position_m - kTruth.apply(old_m)).norm() <= within_m;
}

}  // namespace

class TestCarried : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void positionsAndHeadingsTurnWithTheMap() {
    const std::vector<Carried> all = carriedTo({});
    for (std::size_t i = 0; i < all.size(); ++i) {
      QCOMPARE(all[i].verdict, Verdict::Kept);
      QVERIFY(at(all[i], kSpots[i].position_m));
      QVERIFY(*all[i].local_residual_m < 0.05);
    }
    QVERIFY(std::abs(*all[0].spot.yaw_rad - 2.6) < 1e-9);
    QVERIFY(!all[1].spot.yaw_rad);
    QVERIFY(std::abs(*all[2].spot.yaw_rad + 0.9) < 1e-9);
  }

  void aNewWallThereIsAnObstacle() {
    TwoMaps maps;
    box(maps.new_map, 1.2, 1.6, 1.9, 2.4);
    QCOMPARE(carriedTo(maps)[0].verdict, Verdict::InObstacle);
  }

  void aNewWallCloserThanTheRobotsRadiusIsAnObstacle() {
    TwoMaps maps;
    box(maps.new_map, 1.6, 1.0, 1.7, 3.0);
    QCOMPARE(carriedTo(maps)[0].verdict, Verdict::InObstacle);
  }

  void aPlaceBesideAWallAsBeforeIsKept() {
    TwoMaps maps;
    box(maps.old_map, 1.7, 1.0, 1.8, 3.0);
    box(maps.new_map, 1.7, 1.0, 1.8, 3.0);
    QCOMPARE(carriedTo(maps)[0].verdict, Verdict::Kept);
  }

  void whatTheNewMapDoesNotKnowIsOutside() {
    TwoMaps maps;
    box(maps.new_map, 15, 0, 21, 10, Ground::Unknown);
    QCOMPARE(carriedTo(maps)[1].verdict, Verdict::Outside);
    QCOMPARE(carriedTo(maps)[0].verdict, Verdict::Kept);
  }

  void aRoomWhoseDoorIsClosedIsUnreachable() {
    TwoMaps maps;
    box(maps.new_map, 13.9, 3.9, 14.2, 5.6);
    const std::vector<Carried> all = carriedTo(maps);
    QCOMPARE(all[1].verdict, Verdict::Unreachable);
    QCOMPARE(all[0].verdict, Verdict::Kept);
  }

  void withoutAWallThatAgreesAPlaceIsNotSupported() {
    TwoMaps maps;
    // In the middle of 8 m of free ground; and beside walls that are gone.
    const std::vector<Carried> open = maps.site().carried({{{7, 5}, 0.0}}, {});
    QCOMPARE(open[0].verdict, Verdict::NotSupported);
    QVERIFY(!open[0].local_residual_m);
    box(maps.old_map, 5, 4, 5.1, 6);
    const std::vector<Carried> gone = maps.site().carried({{{6, 5}, 0.0}}, {});
    QCOMPARE(gone[0].verdict, Verdict::NotSupported);
    QVERIFY(*gone[0].local_residual_m > 1);
  }

  void wallsThatAreNewAreOffAsMuchAsWallsThatAreGone() {
    TwoMaps maps;
    // Both walls are still there, and twice as many have come, 1.5 m and more from them.
    box(maps.old_map, 6, 7.5, 8, 7.6);
    box(maps.new_map, 6, 7.5, 8, 7.6);
    for (const double low : {3.0, 3.8}) box(maps.new_map, 5.5, low, 8.5, low + 0.1);
    const std::vector<Carried> all = maps.site().carried({{{7, 5.2}, 0.0}}, {});
    QVERIFY2(*all[0].local_residual_m > 1, qPrintable(QString::number(*all[0].local_residual_m)));
    QCOMPARE(all[0].verdict, Verdict::Kept);  // what stands there still agrees
  }

  void whereTheMapIsBentAPlaceIsAdjustedIfAsked() {
    TwoMaps maps;
    // A niche of the old map has moved by 20 cm along both axes.
    box(maps.old_map, 5, 5, 7, 5.1);
    box(maps.old_map, 5, 5, 5.1, 7);
    box(maps.new_map, 5.2, 5.2, 7.2, 5.3);
    box(maps.new_map, 5.2, 5.2, 5.3, 7.2);
    const Eigen::Vector2d old_m(6, 6);
    const auto carried = [&](bool adjust) { return maps.site().carried({{old_m, 0.0}}, {0.3, adjust})[0]; };
    const Carried plain = carried(false);
    QVERIFY(at(plain, old_m));
    QVERIFY(std::abs(*plain.local_residual_m - 0.28) < 0.06);
    const Carried adjusted = carried(true);
    QCOMPARE(adjusted.verdict, Verdict::Adjusted);
    QVERIFY(at(adjusted, old_m + Eigen::Vector2d(0.2, 0.2), 0.04));
  }

  void theOutlineOfARegionIsOutsideOnlyIfAllOfItIs() {
    TwoMaps maps;
    const carry::Site site = maps.site();
    QCOMPARE(site.carriedShape({{19, 9}, {22, 9}, {22, 12}}, false).verdict, Verdict::Kept);
    QCOMPARE(site.carriedShape({{30, 9}, {32, 9}, {32, 12}}, false).verdict, Verdict::Outside);
  }

  void whatScriptsReadStays() {
    const std::vector<std::string> names{"kept",    "adjusted",    "in_obstacle",
                                         "outside", "unreachable", "not_supported"};
    for (int i = 0; i < carry::kVerdicts; ++i)
      QCOMPARE(std::string(nameOf(Verdict(i))), names[std::size_t(i)]);
  }
};

}  // namespace test_carried

MAPWRIGHT_TEST(test_carried, TestCarried, Core)
#include "test_carried.moc"
