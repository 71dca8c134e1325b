// Recorded ways on a new map: what their line crosses there, also against a reading of its own.
#include <algorithm>
#include <limits>

#include <QtTest>

#include "carry/rehearsal.h"
#include "carry/rehearsal_sentence.h"
#include "site.h"
#include "test_program.h"

namespace test_rehearsal {

using namespace mapwright;
using namespace mapwright::testing;
using carry::Crossing;
using carry::Rehearsed;
using carry::Stretch;
using carry::WayPoint;

namespace {

constexpr double kRadius_m = 0.3;

/// A metre a second, a position every 10 cm.
std::vector<WayPoint> wayAlong(const std::vector<Eigen::Vector2d>& corners) {
  std::vector<WayPoint> way{{corners.front(), 1000, 0}};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Eigen::Vector2d side = corners[i] - corners[i - 1];
    const int steps = std::max(1, int(side.norm() / 0.1));
    for (int step = 1; step <= steps; ++step) {
      const Eigen::Vector2d at = corners[i - 1] + side * (double(step) / steps);
      way.push_back({at, way.back().stamp_s + (at - way.back().position_m).norm(), 0});
    }
  }
  return way;
}

Rehearsed rehearsed(const Plan& plan, const std::vector<WayPoint>& way, double radius_m = kRadius_m) {
  return carry::Rehearsal(gridOf(plan), {.radius_m = radius_m}).of(way);
}

/// Straight through the large room, and through the door into the small one.
const std::vector<WayPoint> kThroughTheDoor = wayAlong({{2, 4.65}, {18, 4.65}});

/// Reads the plan itself, cell by cell.
Crossing bruteAt(const Plan& plan, const Eigen::Vector2d& at, double radius_m) {
  const Eigen::Vector2d cell = (at - plan.corner_m) / plan.resolution_m;
  const int column = int(std::floor(cell.x())), row = int(std::floor(cell.y()));
  if (column < 0 || row < 0 || column >= plan.width || row >= plan.height) return Crossing::Outside;
  if (plan.at(column, row) == Ground::Unknown) return Crossing::Unknown;
  if (plan.at(column, row) == Ground::Wall) return Crossing::Obstacle;
  const int reach = int(radius_m / plan.resolution_m) + 2;
  for (int y = std::max(row - reach, 0); y <= std::min(row + reach, plan.height - 1); ++y) {
    for (int x = std::max(column - reach, 0); x <= std::min(column + reach, plan.width - 1); ++x) {
      if (plan.at(x, y) != Ground::Wall) continue;
      const double across = std::max({x - cell.x(), cell.x() - (x + 1), 0.0});
      const double along = std::max({y - cell.y(), cell.y() - (y + 1), 0.0});
      if (std::hypot(across, along) * plan.resolution_m < radius_m) return Crossing::TooClose;
    }
  }
  return Crossing::Free;
}

constexpr double kDense_m = 0.004;

/// Points of a line, at most that far from each other.
std::vector<Eigen::Vector2d> denseOn(const std::vector<Eigen::Vector2d>& line) {
  std::vector<Eigen::Vector2d> dense{line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const int steps = std::max(1, int(std::ceil((line[i] - line[i - 1]).norm() / kDense_m)));
    for (int step = 1; step <= steps; ++step)
      dense.push_back(line[i - 1] + (line[i] - line[i - 1]) * (double(step) / steps));
  }
  return dense;
}

}  // namespace

class TestRehearsal : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aWayThatNothingIsInIsFree() {
    const Rehearsed way = rehearsed(hall(), kThroughTheDoor);
    QVERIFY2(way.free(), qPrintable(carry::rehearsedText(way)));
    QVERIFY(std::abs(way.length_m - 16) < 1e-6);
    QCOMPARE(way.stretches.size(), 1U);
    QCOMPARE(way.from_s, 1000.0);
    QVERIFY(std::abs(way.to_s - 1016) < 1e-6);
  }

  void aNewShelfIsCrossedOnceWithTheRadiusAroundIt() {
    Plan plan = hall();
    box(plan, 6, 3, 7, 6);
    const Rehearsed way = rehearsed(plan, kThroughTheDoor);
    const std::vector<Stretch> crossed = way.crossed();
    QCOMPARE(crossed.size(), 1U);
    QCOMPARE(crossed[0].what, Crossing::Obstacle);
    QVERIFY(std::abs(crossed[0].length_m - (1.05 + 2 * kRadius_m)) < 0.06);
    QVERIFY((crossed[0].middle_m - Eigen::Vector2d(6.5, 4.65)).norm() < 0.06);
    QVERIFY(std::abs(crossed[0].from_s - 1003.7) < 0.06 && std::abs(crossed[0].to_s - 1005.35) < 0.06);
    QCOMPARE(way.reach, Rehearsed::Reach::Reached);  // around it
    QVERIFY(!way.free());
  }

  /// The wall between two positions is as thin as a cell.
  void theLineCountsNotOnlyItsPoints() {
    Plan plan = hall();
    box(plan, 6.02, 3, 6.03, 6);
    const std::vector<WayPoint> way{{{5.2, 4.5}, 0, 0}, {{6.8, 4.5}, 1, 0}};
    const std::vector<Stretch> crossed = rehearsed(plan, way, 0).crossed();
    QCOMPARE(crossed.size(), 1U);
    QCOMPARE(crossed[0].what, Crossing::Obstacle);
    QVERIFY(std::abs(crossed[0].length_m - 0.05) < 0.03);
  }

  void aJumpIsNoLineThroughAWall() {
    Plan plan = hall();
    box(plan, 6, 0.1, 6.3, 9.8);
    std::vector<WayPoint> way = wayAlong({{2, 4.65}, {5, 4.65}});
    const std::size_t before = way.size();
    for (WayPoint point : wayAlong({{8, 4.65}, {12, 4.65}})) {
      point.stamp_s += way[before - 1].stamp_s - 1000 + 0.1;
      way.push_back(point);
    }
    const Rehearsed far = rehearsed(plan, way);  // 3 m in 0.1 s
    QCOMPARE(far.jumps, 1U);
    QVERIFY(far.crossed().empty());
    QVERIFY(std::abs(far.length_m - 7) < 1e-6);
    QCOMPARE(far.reach, Rehearsed::Reach::CutOff);
    // As the recording says, also where the distance would be no jump.
    std::vector<WayPoint> said{{{5.7, 4}, 0, 0}, {{6.6, 4}, 1, 1}};
    QCOMPARE(rehearsed(plan, said, 0).jumps, 1U);
    QVERIFY(rehearsed(plan, said, 0).crossed().empty());
  }

  void unknownAndOutsideAreToldApart() {
    Plan plan = hall();
    box(plan, 6, 3, 7, 6, Ground::Unknown);
    const Rehearsed way = rehearsed(plan, wayAlong({{5, 4}, {8, 4}}));
    QCOMPARE(way.crossed().size(), 1U);
    QCOMPARE(way.crossed()[0].what, Crossing::Unknown);
    QVERIFY(std::abs(way.lengths_m[std::size_t(Crossing::Unknown)] - 1.05) < 0.06);
    const Rehearsed away = rehearsed(plan, wayAlong({{100, 100}, {103, 100}}));
    QCOMPARE(away.crossed()[0].what, Crossing::Outside);
    QCOMPARE(away.reach, Rehearsed::Reach::NoStart);
  }

  void whatIsNarrowerThanTheRobotIsTooClose() {
    Plan plan = hall();
    box(plan, 6, 4.85, 9, 4.9);  // 20 cm beside the line
    const std::vector<Stretch> crossed = rehearsed(plan, kThroughTheDoor).crossed();
    QCOMPARE(crossed.size(), 1U);
    QCOMPARE(crossed[0].what, Crossing::TooClose);
    QVERIFY(rehearsed(plan, kThroughTheDoor, 0.1).crossed().empty());
    QVERIFY(rehearsed(plan, kThroughTheDoor, 0).crossed().empty());
  }

  void asCloseToAWallAsOnTheOldMapIsNotTooClose() {
    Plan both = hall();
    box(both, 6, 4.85, 9, 4.9);
    TwoMaps maps;
    maps.old_map = maps.new_map = both;
    const auto crossedOn = [&](const TwoMaps& on) {
      return carry::Rehearsal(on.newGrid(),
                              {.radius_m = kRadius_m, .transform = kTruth, .old_map = gridOf(on.old_map)})
          .of(kThroughTheDoor)
          .crossed();
    };
    QVERIFY(crossedOn(maps).empty());
    box(maps.new_map, 10, 4.8, 12, 4.9);  // closer, and new
    const std::vector<Stretch> crossed = crossedOn(maps);
    QCOMPARE(crossed.size(), 1U);
    QCOMPARE(crossed[0].what, Crossing::TooClose);
    QVERIFY((crossed[0].middle_m - kTruth.apply({11, 4.65})).norm() < 0.15);
  }

  void aClosedDoorCutsTheEndOff() {
    Plan plan = hall();
    box(plan, 13.9, 3.9, 14.2, 5.6);
    const Rehearsed way = rehearsed(plan, kThroughTheDoor);
    QCOMPARE(way.reach, Rehearsed::Reach::CutOff);
    QCOMPARE(way.crossed().size(), 1U);
  }

  void aRobotThatStandsWhereAnObstacleIsNowIsSeen() {
    Plan plan = hall();
    box(plan, 1.5, 1.5, 2.5, 2.5);
    const Rehearsed way = rehearsed(plan, {{{2, 2}, 0, 0}, {{2, 2}, 60, 0}, {{2, 2}, 120, 0}});
    QCOMPARE(way.crossed().size(), 1U);
    QCOMPARE(way.crossed()[0].length_m, 0.0);
    QCOMPARE(way.crossed()[0].to_s, 120.0);
    QVERIFY(!way.free());
  }

  /// More than what is looked at together.
  void aWayOfManyKilometresIsStillOneWay() {
    std::vector<WayPoint> way;
    for (int i = 0; i < 40'000; ++i) way.push_back({{i % 2 == 0 ? 2.0 : 2.9, 5}, double(i), 0});
    const Rehearsed free = rehearsed(hall(), way);
    QVERIFY(free.free());
    QCOMPARE(free.stretches.size(), 1U);
    QCOMPARE(free.stretches[0].line.size(), way.size());
    QVERIFY(std::abs(free.length_m - 0.9 * 39'999) < 1e-3);
    QVERIFY(std::abs(free.stretches[0].length_m - free.length_m) < 1e-3);
    QCOMPARE(free.stretches[0].to_s, 39'999.0);
    QCOMPARE(free.jumps, 0U);
  }

  void numbersThatAreNoneAreLeftOutAndCounted() {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = HUGE_VAL;
    std::vector<WayPoint> way = kThroughTheDoor;
    way[3].position_m.x() = kNan;
    way[7].position_m.y() = kInf;
    way[9].stamp_s = kNan;
    const Rehearsed found = rehearsed(hall(), way);
    QCOMPARE(found.unusable, 3U);
    QVERIFY(found.free());
    QCOMPARE(rehearsed(hall(), {{{kNan, 0}, 0, 0}}).points, 0U);
    QCOMPARE(rehearsed(hall(), {{{1e300, -1e300}, 0, 0}, {{1e300, 1e300}, 1, 0}}).crossed().size(), 2U);
  }

  void withoutAMapEverythingIsOutside() {
    for (const render::PlacedGrid& none :
         {render::PlacedGrid(), render::PlacedGrid{gridOf(hall()).cells, {440, 240, 0, {}}}}) {
      const Rehearsed way = carry::Rehearsal(none, {}).of(kThroughTheDoor);
      QCOMPARE(way.stretches.size(), 1U);
      QCOMPARE(way.stretches[0].what, Crossing::Outside);
    }
    const Rehearsed nothing = rehearsed(hall(), {});
    QVERIFY(nothing.stretches.empty() && nothing.points == 0 && !nothing.free());
  }

  void randomWaysAgreeWithAReadingCellByCell_data() {
    QTest::addColumn<double>("radius");
    QTest::newRow("a robot") << 0.25;
    QTest::newRow("a line") << 0.0;
  }
  void randomWaysAgreeWithAReadingCellByCell() {
    QFETCH(double, radius);
    constexpr double kStep_m = 0.0125, kJoin_m = 0.2;
    std::array<int, carry::kCrossings> seen{};
    for (unsigned seed = 1; seed <= 12; ++seed) {
      Chance chance(seed);
      const Plan plain = building(chance);
      Plan plan = furnished(plain, chance, 12);
      for (int i = 0; i < 5; ++i) {
        const int column = chance.below(plan.width), row = chance.below(plan.height);
        fill(plan, column, row, column + chance.below(25), row + chance.below(25), Ground::Unknown);
      }
      const Eigen::Vector2d size = Eigen::Vector2d(plan.width, plan.height) * plan.resolution_m;
      std::vector<Eigen::Vector2d> corners;
      for (int i = 0; i < 5; ++i)
        corners.push_back(plan.corner_m + Eigen::Vector2d(chance.between(-0.1, 1.1) * size.x(),
                                                          chance.between(-0.1, 1.1) * size.y()));
      const Pose2 transform{chance.between(-9, 9), chance.between(-9, 9), chance.between(-3, 3)};
      std::vector<WayPoint> way = wayAlong(corners);
      const Pose2 back = transform.inverse();
      for (WayPoint& point : way) point.position_m = back.apply(point.position_m);
      const Rehearsed found =
          carry::Rehearsal(gridOf(plan), {.radius_m = radius, .transform = transform}).of(way);
      double length_m = 0, until_s = found.from_s;
      for (const Stretch& stretch : found.stretches) {
        length_m += stretch.length_m;
        QVERIFY(std::abs(stretch.from_s - until_s) < 1e-6);
        until_s = stretch.to_s;
        ++seen[std::size_t(stretch.what)];
        const std::vector<Eigen::Vector2d> dense = denseOn(stretch.line);
        std::vector<Crossing> brute;
        for (const Eigen::Vector2d& at : dense) brute.push_back(bruteAt(plan, at, radius));
        const auto isNear = [&](std::size_t i, double within_m, auto&& fits) {
          const auto reach = std::size_t(within_m / kDense_m) + 1;
          for (std::size_t j = i < reach ? 0 : i - reach; j < std::min(i + reach, brute.size()); ++j) {
            if (fits(brute[j])) return true;
          }
          return false;
        };
        const auto is = [](Crossing what) { return [what](Crossing one) { return one == what; }; };
        for (std::size_t i = 0; i < dense.size(); ++i) {
          if (brute[i] == stretch.what) continue;
          const QString where = QStringLiteral("seed %1, %2 at %3,%4: is %5")
                                    .arg(seed)
                                    .arg(QLatin1String(carry::nameOf(stretch.what)))
                                    .arg(dense[i].x())
                                    .arg(dense[i].y())
                                    .arg(QLatin1String(carry::nameOf(brute[i])));
          if (stretch.what == Crossing::Obstacle) {
            QVERIFY2(isNear(i, 2 * radius + kJoin_m, is(Crossing::Obstacle)), qPrintable(where));
            QVERIFY2(
                isNear(i, 1.5 * kStep_m,
                       [](Crossing one) { return one != Crossing::Unknown && one != Crossing::Outside; }),
                qPrintable(where));
          } else {
            const bool joined = stretch.what != Crossing::Free && brute[i] == Crossing::Free;
            QVERIFY2(isNear(i, joined ? kJoin_m : 1.5 * kStep_m, is(stretch.what)), qPrintable(where));
          }
        }
      }
      QVERIFY(std::abs(length_m - found.length_m) < 1e-6);
      QVERIFY(std::abs(until_s - found.to_s) < 1e-6);
    }
    for (int what = 0; what < carry::kCrossings; ++what)
      QVERIFY(seen[std::size_t(what)] > 2 || (Crossing(what) == Crossing::TooClose && radius == 0));
  }

  void ofTwoMapsThatTheRobotWasOnTheOldOneCounts() {
    // 4 m on another map, in coordinates of its own, then the way on this one.
    std::vector<WayPoint> way = wayAlong({{118, 4}, {122, 4}});
    for (WayPoint& point : way) point.map = 1, point.stamp_s -= 500;
    const std::size_t before = way.size();
    for (WayPoint point : kThroughTheDoor) {
      point.piece = 1;
      way.push_back(point);
    }
    for (const bool swapped : {false, true}) {
      if (swapped) std::rotate(way.begin(), way.begin() + std::ptrdiff_t(before), way.end());
      const Rehearsed found = rehearsed(hall(), way);
      QCOMPARE(found.points, kThroughTheDoor.size());
      QVERIFY(std::abs(found.length_m - 16) < 1e-6);
      QVERIFY(std::abs(found.elsewhere_m - 4) < 1e-6);
      QVERIFY(found.free());
      QCOMPARE(found.jumps, std::size_t(0));
      QVERIFY2(
          carry::rehearsedText(found).contains(QLatin1String("Driven on another map, not rehearsed: 4.0 m.")),
          qPrintable(carry::rehearsedText(found)));
    }
    // With an old map it is that one which counts, wherever the new one lies.
    const Plan old_map = hall();
    const carry::Rehearsal onto(gridOf(mappedAgain(old_map, kTruth, 0.05)),
                                {.transform = kTruth, .old_map = gridOf(old_map)});
    QCOMPARE(onto.of(way).points, kThroughTheDoor.size());
  }

  /// Both maps have the same coordinates: the ground cannot tell which part was driven on which.
  void theUidSaysWhichPartCounts() {
    using Part = Rehearsed::Part;
    const std::vector<map::MapIdentity> maps{{"u1", "Hall"}, {"u2", "Hall"}, {"u1", "Renamed"}};
    std::vector<WayPoint> way = wayAlong({{2, 3}, {5, 3}});
    for (const auto& [map, length_m] : {std::pair(1U, 2.0), {2U, 1.0}}) {
      for (WayPoint point : wayAlong({{2, 4}, {2 + length_m, 4}})) {
        point.map = map, point.piece = map, point.stamp_s += 1000 * map;
        way.push_back(point);
      }
    }
    const auto lengthFor = [&](const map::MapIdentity& driven_on, Part part, bool of_another) {
      const Rehearsed found = carry::Rehearsal(gridOf(hall()), {.driven_on = driven_on}).of(way, maps);
      if (found.part != part || found.of_another != of_another) return -1.0;
      return std::round(found.length_m * 1e6) / 1e6;
    };
    QCOMPARE(lengthFor({"u2", "Hall"}, Part::Recorded, false), 2.0);
    QCOMPARE(lengthFor({"u1", "Whatever"}, Part::Recorded, false), 4.0);  // also after it was renamed
    QCOMPARE(lengthFor({"", "Renamed"}, Part::ByGround, false), 4.0);
    QVERIFY(lengthFor({"", "Hall"}, Part::ByGround, false) > 0);  // two of one name
    QVERIFY(lengthFor({}, Part::ByGround, false) > 0);
    QVERIFY(lengthFor({"u3", "Hall"}, Part::ByGround, true) > 0);
    const Rehearsed guessed = carry::Rehearsal(gridOf(hall()), {}).of(way, maps);
    QVERIFY(carry::rehearsedText(guessed).contains(QLatin1String("which of them is meant is not known")));
  }

  void ofOneMapItIsSaidWhetherItIsAnother() {
    const carry::Rehearsal onto(gridOf(hall()), {.driven_on = {"u1", "Hall"}});
    const auto said = [&](const map::MapIdentity& recorded) {
      return carry::rehearsedText(onto.of(kThroughTheDoor, {recorded}));
    };
    QVERIFY(said({"u2", "Hall"}).contains(QLatin1String("it was driven on another map")));
    for (const map::MapIdentity& one : {map::MapIdentity{"u1", "Once"}, {"", "Other"}, {}})
      QVERIFY(!said(one).contains(QLatin1String("another map")));
  }

  void whatScriptsReadStays() {
    const std::vector<std::string> names{"free", "outside", "unknown", "too_close", "obstacle"};
    for (int i = 0; i < carry::kCrossings; ++i)
      QCOMPARE(std::string(nameOf(Crossing(i))), names[std::size_t(i)]);
  }

  void theSentenceSaysAllOfIt() {
    Plan plan = hall();
    box(plan, 13.9, 3.9, 14.2, 5.6);
    const QString said = carry::rehearsedText(rehearsed(plan, kThroughTheDoor));
    for (const char* part : {"16.0 m. Not free: ", " m in an obstacle.", "cannot be reached"})
      QVERIFY2(said.contains(QLatin1String(part)), qPrintable(said));
    QVERIFY(carry::rehearsedText(rehearsed(hall(), kThroughTheDoor))
                .startsWith(QLatin1String("16.0 m, all free.")));
  }
};

}  // namespace test_rehearsal

MAPWRIGHT_TEST(test_rehearsal, TestRehearsal, Core)
#include "test_rehearsal.moc"
