// Two maps of one site are brought together, or it is said that this is not sure: never both wrong and sure.
// MAPWRIGHT_TEST_SEEDS asks for more random sites, MAPWRIGHT_TEST_MAPS for real ones (pictures of 5 cm a
// cell, separated by colons); the counts are printed (docs/count-alignments).
#include <array>
#include <functional>
#include <optional>

#include <QtTest>

#include "align/align.h"
#include "align/alignment_sentence.h"
#include "align/furniture.h"
#include "align/plan_of.h"
#include "buildings.h"
#include "grids/grid_pyramid.h"
#include "test_program.h"

namespace test_alignment {

using namespace mapwright;
using namespace mapwright::testing;
using align::Alignment;
using align::Doubt;
using placing::PointPair;

namespace {

/// Two maps, and where the second one really lies.
struct Case {
  Plan old_map, new_map;
  bool findable = true;  // a person would be sure
  bool one_site = true;  // `truth` says where; otherwise nothing is right
};

/// What happened between the two mappings.
struct Kind {
  const char* name;
  std::function<Case(const Plan& site, Chance& chance)> make;
  double resolution_m = 0.05;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"turned and moved",
       [](const Plan& site, Chance&) {
         return Case{site, site};
       }},
      {"cropped to 40 %",
       [](const Plan& site, Chance& chance) {
         return Case{site, cropped(site, chance, 0.4)};
       }},
      {"both cropped to 70 %",
       [](const Plan& site, Chance& chance) {
         return Case{cropped(site, chance, 0.7), cropped(site, chance, 0.7)};
       }},
      {"noise",
       [](const Plan& site, Chance& chance) {
         return Case{noisy(site, chance, 0.2, 0.002), noisy(site, chance, 0.3, 0.005)};
       }},
      {"furniture moved",
       [](const Plan& site, Chance& chance) {
         return Case{furnished(site, chance, 15), furnished(site, chance, 15)};
       }},
      {"cells of 2 cm",
       [](const Plan& site, Chance&) {
         return Case{site, site};
       },
       0.02},
      {"cells of 10 cm",
       [](const Plan& site, Chance&) {
         return Case{site, site};
       },
       0.1},
      {"all of it",
       [](const Plan& site, Chance& chance) {
         return Case{noisy(furnished(site, chance, 8), chance, 0.15, 0.002),
                     noisy(cropped(furnished(site, chance, 8), chance, 0.6), chance, 0.15, 0.002)};
       },
       0.1},
      {"mirrored",
       [](const Plan& site, Chance&) {
         return Case{site, mirrored(site), false, false};
       }},
      {"symmetric",
       [](const Plan& site, Chance&) {
         return Case{symmetric(site), symmetric(site), false, false};
       }},
      {"another site",
       [](const Plan& site, Chance& chance) {
         return Case{site, furnished(building(chance), chance, 12), false, false};
       }},
      {"a corridor",
       [](const Plan&, Chance& chance) {
         return Case{noisy(corridor(30), chance, 0.1, 0.002),
                     cropped(noisy(corridor(30), chance, 0.1, 0.002), chance, 0.7), false, false};
       }},
      {"almost no overlap",
       [](const Plan& site, Chance&) {
         Case made{site, site, false};
         fill(made.old_map, made.old_map.width / 2 + 10, 0, made.old_map.width, made.old_map.height,
              Ground::Unknown);
         fill(made.new_map, 0, 0, made.new_map.width / 2 - 10, made.new_map.height, Ground::Unknown);
         return made;
       }},
  };
  return all;
}

Pose2 somewhere(Chance& chance) {
  return {chance.between(-60, 60), chance.between(-60, 60), chance.between(-3.14, 3.14)};
}

/// Within 5 cm in the middle of the map and 0.3 degrees.
bool right(const Pose2& found, const Pose2& truth, const Plan& map) {
  const Eigen::Vector2d middle =
      map.corner_m + 0.5 * map.resolution_m * Eigen::Vector2d(map.width, map.height);
  return (found.apply(middle) - truth.apply(middle)).norm() <= 0.05 &&
         std::abs(geometry::normalizeAngle(found.yaw_rad - truth.yaw_rad)) <=
             geometry::radiansFromDegrees(0.3);
}

Plan realMap(const QString& path) {
  const auto reading = grids::openGridFile(path.toStdString(), {});
  const std::atomic<bool> cancelled = false;
  if (!reading || (*reading)->read(cancelled, [] {})) return {};
  const auto cells = (*reading)->pyramid();
  const render::PlacedGrid placed{cells, {cells->width(), cells->height(), 0.05, {}}};
  return align::trimmed(align::seenOnly(*align::planOf(placed, 0.05), 0.3));
}

/// Sites with furniture of their own; real ones if asked for.
std::vector<Plan> sites() {
  std::vector<Plan> all;
  for (const QString& path :
       qEnvironmentVariable("MAPWRIGHT_TEST_MAPS").split(QLatin1Char(':'), Qt::SkipEmptyParts))
    all.push_back(realMap(path));
  if (!all.empty()) return all;
  const unsigned seeds = 1 + unsigned(qEnvironmentVariableIntValue("MAPWRIGHT_TEST_SEEDS"));
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    Chance chance(seed);
    const Plan plain = building(chance);
    all.push_back(furnished(plain, chance, 12));
  }
  return all;
}

/// 24 m x 20 m of free ground with posts in rows, some of them missing; no wall is in sight.
Plan posts(Chance& chance) {
  Plan plan;
  plan.width = 480;
  plan.height = 400;
  plan.resolution_m = 0.05;
  plan.cells.assign(std::size_t(plan.width) * std::size_t(plan.height), Ground::Free);
  for (int row = 20; row < plan.height; row += 60) {
    for (int column = 20; column < plan.width; column += 48) {
      if (!chance.happens(0.25)) fill(plan, column, row, column + 1, row + 1, Ground::Wall);
    }
  }
  return plan;
}

/// A row of rooms that are alike beside a corridor, and a hall at its end.
constexpr int kSuite = 76;  // cells
Plan suites(int count) {
  constexpr int kDeep = 100, kCorridor = 40, kHall = 110;
  Plan plan;
  plan.width = count * kSuite + kHall;
  plan.height = kDeep + kCorridor;
  plan.resolution_m = 0.05;
  plan.cells.assign(std::size_t(plan.width) * std::size_t(plan.height), Ground::Wall);
  fill(plan, 2, kDeep, count * kSuite, plan.height - 3, Ground::Free);
  fill(plan, count * kSuite, 30, plan.width - 3, plan.height - 3, Ground::Free);
  for (int room = 0; room < count; ++room) {
    const int left = room * kSuite + 2;
    fill(plan, left, 2, left + kSuite - 4, kDeep - 3, Ground::Free);
    fill(plan, left + 10, kDeep - 2, left + 28, kDeep - 1, Ground::Free);
    fill(plan, left + 40, 2, left + 60, 30, Ground::Wall);
  }
  return plan;
}

/// Closed rooms with 10 cm between their faces. Of each five the first one was entered, and `own`.
Plan closedRooms(int own) {
  Chance chance(3);
  Plan plan;
  plan.width = 600;
  plan.height = 420;
  plan.resolution_m = 0.05;
  plan.cells.assign(std::size_t(plan.width) * std::size_t(plan.height), Ground::Unknown);
  int rooms = 0;
  for (int low = 2, high = 0; low + 80 < plan.height; low = high + 4) {
    high = low + int(chance.between(56, 76));
    for (int left = 2, right = 0; left + 100 < plan.width; left = right + 4) {
      right = left + int(chance.between(56, 96));
      if (const int room = rooms++ % 5; room != 0 && room != own) continue;
      fill(plan, left - 1, low - 1, right + 1, high + 1, Ground::Wall);
      fill(plan, left, low, right, high, Ground::Free);
    }
  }
  return plan;
}

/// 20 m x 12 m with 32 desks, of which some stand 1.1 m farther to the right; nullopt: there is none.
Plan roomWithDesks(const std::function<std::optional<bool>(int x, int y)>& moved) {
  Plan plan;
  plan.width = 400;
  plan.height = 240;
  plan.resolution_m = 0.05;
  plan.cells.assign(std::size_t(plan.width) * std::size_t(plan.height), Ground::Wall);
  fill(plan, 2, 2, plan.width - 3, plan.height - 3, Ground::Free);
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 4; ++y) {
      const std::optional<bool> there = moved(x, y);
      if (!there) continue;
      const int left = 20 + 46 * x + (*there ? 22 : 0), low = 25 + 55 * y;
      fill(plan, left, low, left + 14, low + 24, Ground::Wall);
    }
  }
  return plan;
}

/// A hall of 30 m x 22 m with rows of racks, in some of them goods. An office in a corner and columns at a
/// wall tell its ends apart.
struct Warehouse {
  static constexpr int kRows = 5, kBays = 7, kBay = 56, kRow = 80;  // cells
  std::array<bool, std::size_t(kRows* kBays)> goods{};

  explicit Warehouse(Chance& chance) { put(chance, 1); }
  /// Looks anew whether goods are in a bay, in that share of the bays.
  void put(Chance& chance, double share) {
    for (bool& bay : goods) {
      if (chance.happens(share)) bay = chance.happens(0.8);
    }
  }
  Plan plan(bool ends) const {
    Plan plan;
    plan.width = 600;
    plan.height = 440;
    plan.resolution_m = 0.05;
    plan.cells.assign(std::size_t(plan.width) * std::size_t(plan.height), Ground::Wall);
    fill(plan, 2, 2, plan.width - 3, plan.height - 3, Ground::Free);
    if (ends) {
      fill(plan, 2, 370, 80, 371, Ground::Wall);
      fill(plan, 80, 370, 81, 437, Ground::Wall);
      fill(plan, 30, 370, 48, 371, Ground::Free);
      for (const int column : {130, 220, 330}) fill(plan, column, 2, column + 10, 16, Ground::Wall);
    }
    for (int row = 0; row < kRows; ++row) {
      const int middle = 60 + row * kRow;
      for (int bay = 0; bay <= kBays; ++bay) {
        const int left = 104 + bay * kBay;
        for (const int leg : {middle - 11, middle + 10})
          fill(plan, left - 1, leg, left + 1, leg + 1, Ground::Wall);
        if (bay < kBays && goods[std::size_t(row * kBays + bay)])
          fill(plan, left + 6, middle - 10, left + kBay - 7, middle + 10, Ground::Wall);
      }
    }
    return plan;
  }
};

/// A small site whose halves look alike after half a turn, and where it really lies.
struct TwoWays {
  Plan site, again;
  Pose2 truth{7, -3, 1.2};
  TwoWays() {
    Chance chance(5);
    site = symmetric(furnished(building(chance), chance, 8));
    again = mappedAgain(site, truth, 0.05);
  }
};

PointPair pairAt(const Plan& site, const Pose2& truth, double x_share, double y_share, double off_m = 0) {
  const Eigen::Vector2d at =
      site.corner_m + site.resolution_m * Eigen::Vector2d(x_share * site.width, y_share * site.height);
  return {at, truth.apply(at) + Eigen::Vector2d(off_m, 0)};
}

}  // namespace

class TestAlignment : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsSureIsRight_data() {
    QTest::addColumn<int>("kind");
    for (std::size_t i = 0; i < kinds().size(); ++i) QTest::newRow(kinds()[i].name) << int(i);
  }

  void whatIsSureIsRight() {
    QFETCH(int, kind);
    const Kind& what = kinds()[std::size_t(kind)];
    int cases = 0, sure = 0, wrong = 0, expected = 0;
    for (const Plan& site : sites()) {
      Chance chance(unsigned(1000 * kind + cases));
      Case made = what.make(site, chance);
      const Pose2 truth = somewhere(chance);
      const Plan again = mappedAgain(made.new_map, truth, what.resolution_m);
      const Alignment found = *align::alignPlans(made.old_map, again);
      const bool fits = found.best && made.one_site && right(found.best->transform, truth, made.old_map);
      ++cases;
      sure += found.sure();
      wrong += found.sure() && !fits;
      expected += made.findable;
    }
    qInfo("%s: %d cases, %d sure, %d sure and wrong", what.name, cases, sure, wrong);
    QCOMPARE(wrong, 0);
    // Nine of ten where a person would be sure.
    QVERIFY(10 * sure >= 9 * expected);
  }

  void postsAloneAreFound() {
    Chance chance(1);
    const Plan site = posts(chance);
    const Pose2 truth{7, -3, 1.2};
    const Plan again = mappedAgain(cropped(noisy(site, chance, 0, 0.0005), chance, 0.7), truth, 0.05);
    const Alignment found = *align::alignPlans(noisy(site, chance, 0, 0.0005), again);
    QVERIFY(right(found.best->transform, truth, site));
  }

  void onePairDecidesBetweenTwoWays() {
    const TwoWays two;
    const Alignment alone = *align::alignPlans(two.site, two.again);
    QCOMPARE(alone.doubt, Doubt::Ambiguous);
    QVERIFY(alone.second.has_value());
    const Alignment decided =
        *align::alignPlans(two.site, two.again, {.pairs = {pairAt(two.site, two.truth, 0.2, 0.3, 0.2)}});
    QCOMPARE(decided.doubt, Doubt::None);
    QVERIFY(right(decided.best->transform, two.truth, two.site));
    QCOMPARE(decided.pair_residuals_m.size(), std::size_t(1));
    QVERIFY(std::abs(decided.pair_residuals_m.front() - 0.2) < 0.03);
  }

  void aPairWhereNothingFitsIsSaid() {
    const TwoWays two;
    PointPair elsewhere = pairAt(two.site, two.truth, 0.2, 0.3);
    elsewhere.in_world_m += Eigen::Vector2d(300, 0);
    const Alignment found = *align::alignPlans(two.site, two.again, {.pairs = {elsewhere}});
    QVERIFY(!found.sure());
  }

  void twoPairsAreAResultOfTheirOwn() {
    const TwoWays two;
    const Alignment found = *align::alignPlans(
        two.site, two.again,
        {.pairs = {pairAt(two.site, two.truth, 0.1, 0.1), pairAt(two.site, two.truth, 0.9, 0.8)}});
    QVERIFY(found.sure());
    QVERIFY(right(found.best->transform, two.truth, two.site));
    QVERIFY(found.agreement.forward.within_10cm > 0.9);
  }

  void ofThreePairsTheWorstOneIsSeen() {
    const TwoWays two;
    const Alignment found = *align::alignPlans(
        two.site, two.again,
        {.pairs = {pairAt(two.site, two.truth, 0.1, 0.1), pairAt(two.site, two.truth, 0.9, 0.1),
                   pairAt(two.site, two.truth, 0.5, 0.9), pairAt(two.site, two.truth, 0.4, 0.5, 0.4)}});
    QCOMPARE(found.pair_residuals_m.size(), std::size_t(4));
    QCOMPARE(std::max_element(found.pair_residuals_m.begin(), found.pair_residuals_m.end()),
             found.pair_residuals_m.begin() + 3);
    QVERIFY(std::abs(found.pair_residuals_m[3] - 0.4) < 1e-6);
  }

  void pairsThatCannotDecideAreRefused() {
    const TwoWays two;
    const auto doubt = [&](const PointPair& a, const PointPair& b) {
      return align::alignPlans(two.site, two.again, {.pairs = {a, b}})->doubt;
    };
    const PointPair one = pairAt(two.site, two.truth, 0.2, 0.3),
                    other = pairAt(two.site, two.truth, 0.8, 0.7);
    QCOMPARE(doubt(one, one), Doubt::PairsTooClose);
    PointPair beside = one;
    beside.on_map_m.x() += 0.5;
    QCOMPARE(doubt(one, beside), Doubt::PairsTooClose);
    // The distances are right, but the second map is held the wrong way round.
    PointPair shifted = one, shifted_other = other;
    for (PointPair* const pair : {&shifted, &shifted_other}) pair->in_world_m += Eigen::Vector2d(1.3, 0.9);
    QCOMPARE(doubt(shifted, shifted_other), Doubt::PairsAgainstWalls);
  }

  void ofARepeatingBuildingTheEndsDecide() {
    Chance chance(2);
    const Plan site = suites(7);
    const Pose2 truth{-11, 4, 2.1};
    const auto mapped = [&](const Plan& plan) { return noisy(plan, chance, 0.1, 0.001); };
    const Alignment whole = *align::alignPlans(mapped(site), mappedAgain(mapped(site), truth, 0.05));
    QVERIFY(whole.second->score > 0.7 * whole.best->score);
    QCOMPARE(whole.doubt, Doubt::None);
    QVERIFY(right(whole.best->transform, truth, site));
    // Rooms 1 to 4 and 3 to 6, without the ends: they fit in several ways.
    Plan first = mapped(site), last = mapped(site);
    fill(first, 0, 0, kSuite - 20, first.height, Ground::Unknown);
    fill(first, 5 * kSuite - 20, 0, first.width, first.height, Ground::Unknown);
    fill(last, 0, 0, 3 * kSuite - 20, last.height, Ground::Unknown);
    fill(last, 7 * kSuite - 20, 0, last.width, last.height, Ground::Unknown);
    QCOMPARE(align::alignPlans(first, mappedAgain(last, truth, 0.05))->doubt, Doubt::Ambiguous);
  }

  void otherGoodsInAWarehouseDoNotHideItsEnds_data() {
    QTest::addColumn<unsigned>("seed");
    QTest::addColumn<double>("share");
    QTest::newRow("few") << 7U << 0.15;
    QTest::newRow("many") << 4U << 0.35;
  }

  void otherGoodsInAWarehouseDoNotHideItsEnds() {
    QFETCH(unsigned, seed);
    QFETCH(double, share);
    Chance chance(seed);
    Warehouse site(chance);
    const Pose2 truth{-11, 4, 2.1};
    const auto mapped = [&](bool ends) { return noisy(site.plan(ends), chance, 0.1, 0.001); };
    const Plan before = mapped(true);
    site.put(chance, share);
    const Alignment found = *align::alignPlans(before, mappedAgain(mapped(true), truth, 0.05));
    QVERIFY(found.second->score > 0.7 * found.best->score);
    QCOMPARE(found.doubt, Doubt::None);
    QVERIFY(right(found.best->transform, truth, before));
    // With neither its ends nor its goods nothing tells.
    const Plan alike = mapped(false);
    site.put(chance, 1);
    QVERIFY(!align::alignPlans(alike, mappedAgain(mapped(false), truth, 0.05))->sure());
  }

  void aWallThatTheOtherMapSawFromBehindIsNotShifted() {
    // A wall of 20 cm with ground on both sides, of which each map saw one.
    Plan left;
    left.width = left.height = 60;
    left.resolution_m = 0.05;
    left.cells.assign(60 * 60, Ground::Unknown);
    Plan right = left;
    fill(left, 0, 0, 27, 59, Ground::Free);
    fill(left, 28, 0, 28, 59, Ground::Wall);
    fill(right, 31, 0, 31, 59, Ground::Wall);
    fill(right, 32, 0, 59, 59, Ground::Free);
    QCOMPARE(align::agreementOf(left, right, {}).shifted, std::size_t(0));
    // The same side of it, moved: that is a shift.
    QVERIFY(align::agreementOf(left, left, {0.15, 0, 0}).shifted > 0);
  }

  void wallsSeenFromTheirTwoSidesDoNotPullTheMap() {
    const Pose2 truth{7, -3, 0.6};
    const Plan old_map = closedRooms(3);
    const Alignment found = *align::alignPlans(old_map, mappedAgain(closedRooms(2), truth, 0.05));
    QVERIFY(found.sure());
    const Eigen::Vector2d middle =
        0.5 * old_map.resolution_m * Eigen::Vector2d(old_map.width, old_map.height);
    QVERIFY((found.best->transform.apply(middle) - truth.apply(middle)).norm() < 0.015);
  }

  void furnitureTellsAnotherFloorWithTheSameWalls() {
    const Pose2 truth{3, 4, 0.8};
    const Plan today = roomWithDesks([](int, int) { return false; });
    const auto furniture = [&](const Plan& later) {
      return align::furnitureOf(today, mappedAgain(later, truth, 0.05), truth);
    };
    QVERIFY(furniture(roomWithDesks([](int, int) { return true; })).allDiffers());
    // Half of it was moved: it is the same floor. Nothing stands free: nothing tells.
    const auto half = furniture(roomWithDesks([](int x, int y) { return (x + y) % 2 == 0; }));
    QVERIFY(!half.allDiffers() && !half.mostDiffers());
    const Plan empty = roomWithDesks([](int, int) { return std::nullopt; });
    QVERIFY(!align::furnitureOf(empty, empty, {}).allDiffers());
  }

  void littleFurnitureThatIsThereAgainIsSaid() {
    align::Alignment found;
    found.best = align::Candidate{{}, 0.9};
    found.doubt = align::Doubt::None;
    found.furniture = {11, 1};
    QVERIFY(align::alignmentText(found).contains(QLatin1String("Of 11 pieces of furniture 1 stand")));
    found.furniture = {20, 7};  // as by chance on another floor, seen in a pair of them
    QVERIFY(align::alignmentText(found).contains(QLatin1String("Of 20 pieces of furniture 7 stand")));
    found.furniture = {11, 6};
    QVERIFY(!align::alignmentText(found).contains(QLatin1String("furniture")));
    found.furniture = {3, 0};  // too few to tell anything
    QVERIFY(!align::alignmentText(found).contains(QLatin1String("furniture")));
  }

  void aBentMapIsNotSure_data() {
    QTest::addColumn<int>("cells");
    QTest::newRow("10 cm") << 2;
    QTest::newRow("30 cm") << 6;
  }

  void aBentMapIsNotSure() {
    QFETCH(int, cells);
    Chance chance(9);
    const Plan plain = building(chance), site = furnished(plain, chance, 10);
    // The right half has been mapped that much higher.
    Plan bent = site;
    for (int row = cells; row < bent.height; ++row) {
      for (int column = bent.width / 2; column < bent.width; ++column)
        cellOf(bent, column, row) = site.at(column, row - cells);
    }
    QCOMPARE(align::alignPlans(site, mappedAgain(bent, {3, 4, 0.8}, 0.05))->doubt, Doubt::Bent);
  }

  void pairsThatContradictEachOtherAreRefused() {
    const TwoWays two;
    PointPair close = pairAt(two.site, two.truth, 0.9, 0.8);
    close.in_world_m = pairAt(two.site, two.truth, 0.5, 0.5).in_world_m;
    const Alignment found =
        *align::alignPlans(two.site, two.again, {.pairs = {pairAt(two.site, two.truth, 0.1, 0.1), close}});
    QCOMPARE(found.doubt, Doubt::PairsDisagree);
  }

  void aMapWithoutWallsIsSaid() {
    Plan open = corridor(5);
    fill(open, 0, 0, open.width, open.height, Ground::Free);
    QCOMPARE(align::alignPlans(open, corridor(5))->doubt, Doubt::NoWalls);
    QCOMPARE(align::alignPlans(corridor(5), Plan{})->doubt, Doubt::NoWalls);
    QVERIFY(!align::alignPlans(Plan{}, Plan{}, {.pairs = {{}, {}}})->best->score);
  }

  void itCanBeCancelled() {
    const TwoWays two;
    int asked = 0;
    QVERIFY(!align::alignPlans(two.site, two.again, {.proceed = [&](double) { return ++asked < 3; }}));
    QCOMPARE(asked, 3);
  }

  void progressOnlyGrows() {
    double last = 0;
    QVERIFY(align::alignPlans(corridor(6), corridor(6), {.proceed = [&](double done) {
                                const bool grows = done >= last && done <= 1;
                                last = done;
                                return grows;
                              }}));
    QCOMPARE(last, 1.0);
  }

  void agreementIsMeasuredBothWays() {
    Chance chance(3);
    const Plan site = building(chance), part = cropped(site, chance, 0.4);
    const align::Agreement agreement = align::agreementOf(site, part, {});
    QCOMPARE(agreement.overlap, 1.0);
    QCOMPARE(agreement.backward.within_10cm, 1.0);
    QCOMPARE(agreement.backward.seen_share, 1.0);
    QVERIFY(agreement.forward.seen_share < 0.7);
    QVERIFY(agreement.squares >= 3);
    const align::Agreement shifted = align::agreementOf(site, site, {0.2, 0, 0});
    QVERIFY(shifted.forward.within_10cm < 0.8);
    QVERIFY(std::abs(shifted.forward.p95_m - 0.2) < 0.03);
  }

  void wallsBeyondTheSeenGroundDoNotCount() {
    const Plan site = corridor(6);
    // One wall of it, and a little ground before it, were not seen.
    Plan part = site;
    fill(part, 0, part.height - 5, part.width, part.height, Ground::Unknown);
    const align::Agreement agreement = align::agreementOf(site, part, {});
    QCOMPARE(agreement.forward.within_10cm, 1.0);
    QVERIFY(agreement.forward.seen_share < 0.6);
  }

  void whereTheMapsDifferIsListed() {
    Plan room;
    room.width = room.height = 240;
    room.resolution_m = 0.05;
    room.cells.assign(240 * 240, Ground::Free);
    Plan before = room, later = room;
    for (Plan* const plan : {&before, &later}) fill(*plan, 0, 0, 239, 1, Ground::Wall);
    fill(before, 130, 130, 150, 150, Ground::Wall);
    fill(later, 140, 145, 160, 165, Ground::Wall);
    const align::Agreement same = align::agreementOf(before, before, {});
    QCOMPARE(same.squares, std::size_t(5));
    QVERIFY(same.off.empty());
    const align::Agreement moved = align::agreementOf(before, later, {});
    QCOMPARE(moved.squares, std::size_t(5));
    QCOMPARE(moved.off.size(), std::size_t(1));
    QCOMPARE(moved.off.front().middle_m, Eigen::Vector2d(7.5, 7.5));
    QVERIFY(moved.off.front().off_m > 0.3);
  }
};

}  // namespace test_alignment

MAPWRIGHT_TEST(test_alignment, TestAlignment, Core)
#include "test_alignment.moc"
