// Which regions are asked for, and when.
#include <QtTest>

#include "regions/region_plan.h"
#include "test_program.h"

namespace test_region_plan {

using namespace mapwright;
using namespace mapwright::regions;

namespace {

constexpr Millis kNow{1'000};

/// A plan that knows its cells: regions of 10 m.
RegionPlan plan(PlanOptions options = {}) {
  options.region_cells = 100;
  RegionPlan plan(options);
  plan.setCells(0.1, {0, 0});
  return plan;
}
RegionTrouble lost() {
  return {RegionTrouble::Kind::Failed, {.kind = map::FailureKind::TimedOut}, Misfit::None};
}

}  // namespace

class TestRegionPlan : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void nothingIsAskedForWithoutAView() {
    RegionPlan one = plan();
    QVERIFY(one.take(kNow).empty());
    one.setView(geometry::WorldRect{0, 0, std::numeric_limits<double>::infinity(), 5}, {0, 0});
    QVERIFY(one.take(kNow).empty());
    one.setView(geometry::WorldRect{}, {0, 0});
    QVERIFY(one.take(kNow).empty());
    QVERIFY(one.settled(1));
  }
  void theFirstRegionIsSmallUntilTheSizeOfACellIsKnown() {
    RegionPlan one;
    one.setView(geometry::WorldRect{-1e6, -1e6, 1e6, 1e6}, {7, 3});
    const auto asks = one.take(kNow);
    QCOMPARE(asks.size(), std::size_t(1));
    QVERIFY(asks[0].is_first);
    QCOMPARE(asks[0].rect, (geometry::WorldRect{4.5, 0.5, 9.5, 5.5}));
    QVERIFY(one.take(kNow).empty());
    one.answered(asks[0].id, true);  // nothing there, and not a word of its cells
    QVERIFY(one.tooFar());           // in regions of a usual size the view has too many
    one.setView(geometry::WorldRect{0, 0, 10, 10}, {5, 5});
    QCOMPARE(one.take(kNow).size(), std::size_t(1));
    QVERIFY(!one.resolution());
  }
  void nearestToTheMiddleFirstAndTwoAtATime() {
    RegionPlan one = plan();
    one.setView(geometry::WorldRect{0, 0, 50, 10}, {24, 5});
    auto asks = one.take(kNow);
    QCOMPARE(asks.size(), std::size_t(2));
    QCOMPARE(asks[0].key, (RegionKey{2, 0}));
    QCOMPARE(asks[1].key, (RegionKey{1, 0}));
    QVERIFY(one.take(kNow).empty());
    one.answered(asks[1].id, false);
    asks = one.take(kNow);
    QCOMPARE(asks.size(), std::size_t(1));
    QCOMPARE(asks[0].key, (RegionKey{3, 0}));
  }
  void whatIsAskedForHasAMarginThatRoundingCannotEat() {
    RegionPlan one = plan();
    one.setView(geometry::WorldRect{1, 1, 9, 9}, {5, 5});
    const auto asks = one.take(kNow);
    QCOMPARE(asks.size(), std::size_t(1));
    QCOMPARE(asks[0].rect, (geometry::WorldRect{-0.05, -0.05, 10.05, 10.05}));
  }
  void whatHasLeftTheViewIsCancelledOnce() {
    RegionPlan one = plan();
    one.setView(geometry::WorldRect{1, 1, 9, 9}, {5, 5});
    const auto asks = one.take(kNow);
    QVERIFY(one.unwanted().empty());
    one.setView(geometry::WorldRect{101, 101, 109, 109}, {105, 105});
    QCOMPARE(one.unwanted(), std::vector<std::uint64_t>{asks[0].id});
    QVERIFY(one.unwanted().empty());
    // It goes on counting until it has ended: the robot goes on reckoning.
    QCOMPARE(one.take(kNow).size(), std::size_t(1));
    QCOMPARE(one.inProgress(), 2);
    one.cancelled(asks[0].id);
    QCOMPARE(one.row({0, 0}).state(), RegionState::NotAsked);
    one.setView(geometry::WorldRect{1, 1, 9, 9}, {5, 5});
    QCOMPARE(one.take(kNow).size(), std::size_t(1));
  }
  void failuresWaitAndWaitLonger() {
    RegionPlan one = plan();
    one.setView(geometry::WorldRect{1, 1, 9, 9}, {5, 5});
    Millis now = kNow;
    Millis wait{2'000};
    for (int tries = 0; tries < 12; ++tries) {
      const auto asks = one.take(now);
      QCOMPARE(asks.size(), std::size_t(1));
      one.failed(asks[0].id, lost(), now);
      QCOMPARE(one.row({0, 0}).state(), RegionState::Failed);
      QVERIFY(one.take(now).empty());
      QCOMPARE(one.nextDue(now), std::optional(now + wait));
      QVERIFY(one.take(now + wait - Millis(1)).empty());
      now += wait;
      wait = std::min(wait * 2, Millis(60'000));
    }
    QVERIFY(one.settled(12));
    QVERIFY(!one.settled(13));
  }
  void refreshingAsksForEverythingOnceMoreAndForgetsNothing() {
    RegionPlan one = plan();
    one.setView(geometry::WorldRect{1, 1, 19, 9}, {5, 5});
    auto asks = one.take(kNow);
    one.answered(asks[0].id, false);
    one.answered(asks[1].id, true);
    QVERIFY(one.settled(1));
    QVERIFY(!one.nextDue(kNow));
    one.refresh();
    QVERIFY(!one.settled(1));
    QCOMPARE(one.row({0, 0}).state(), RegionState::Held);
    QCOMPARE(one.row({1, 0}).state(), RegionState::Nothing);
    asks = one.take(kNow);
    QCOMPARE(asks.size(), std::size_t(2));
    QVERIFY(one.row({0, 0}).refreshing());
    QCOMPARE(one.row({0, 0}).state(), RegionState::Held);
    // It was asked for before the next word that all is old.
    one.refresh();
    one.answered(asks[0].id, false);
    QCOMPARE(one.take(kNow).size(), std::size_t(1));
  }
  void whatIsMissingGoesBeforeWhatIsOld() {
    RegionPlan one = plan();
    one.setView(geometry::WorldRect{1, 1, 9, 9}, {5, 5});
    auto asks = one.take(kNow);
    one.answered(asks[0].id, false);
    one.refresh();
    one.setView(geometry::WorldRect{1, 1, 29, 9}, {5, 5});
    asks = one.take(kNow);
    QCOMPARE(asks[0].key, (RegionKey{1, 0}));
    QCOMPARE(asks[1].key, (RegionKey{2, 0}));
  }
  void fromTooFarAwayNothingIsAskedFor() {
    PlanOptions options;
    options.most_in_view = 4;
    RegionPlan one = plan(options);
    one.setView(geometry::WorldRect{1, 1, 49, 9}, {5, 5});
    QVERIFY(one.tooFar());
    QVERIFY(one.take(kNow).empty());
    one.setView(geometry::WorldRect{-1e12, -1e12, 1e12, 1e12}, {0, 0});
    QVERIFY(one.tooFar());
    one.setView(geometry::WorldRect{1, 1, 39, 9}, {5, 5});
    QVERIFY(!one.tooFar());
    QCOMPARE(one.take(kNow).size(), std::size_t(2));
  }
  void otherCellsCutTheMapAnewButNotForEver() {
    RegionPlan one = plan();
    one.setView(geometry::WorldRect{1, 1, 9, 9}, {5, 5});
    const auto old = one.take(kNow);
    QVERIFY(!one.setCells(0.11, {0, 0}));  // hardly another size
    QVERIFY(one.setCells(0.05, {0, 0}));
    QCOMPARE(one.unwanted(), std::vector<std::uint64_t>{old[0].id});
    one.answered(old[0].id, false);  // of a lattice that is gone
    QVERIFY(!one.settled(1));
    int cuts = 0;
    for (int i = 0; i < 100; ++i) cuts += one.setCells(i % 2 == 0 ? 0.2 : 0.05, {0, 0});
    QVERIFY2(cuts < 5, qPrintable(QString::number(cuts)));
  }
  void answersOfNobodyChangeNothing() {
    RegionPlan one = plan();
    one.answered(99, false);
    one.failed(99, lost(), kNow);
    one.cancelled(99);
    QVERIFY(one.rows().empty());
  }
};

}  // namespace test_region_plan

MAPWRIGHT_TEST(test_region_plan, TestRegionPlan, Nothing)
#include "test_region_plan.moc"
