// A map by the regions in view, against the map itself.
#include <random>
#include <set>

#include <QtTest>

#include "fake_dispatch.h"
#include "map_shown.h"
#include "regions/map_regions.h"
#include "regions/region_sheet.h"
#include "test_program.h"

namespace test_map_regions {

using namespace mapwright;
using namespace mapwright::regions;

namespace {

constexpr Millis kStart{10'000};

FakeGround small() {
  FakeGround ground;
  ground.width = 1500;
  ground.height = 900;
  ground.origin = {-30, -20, 0};
  return ground;
}

MapRegions::Options options(int region_cells) {
  MapRegions::Options options;
  options.plan.region_cells = region_cells;
  return options;
}

/// Answers everything that is asked for until nothing is due.
void settle(MapRegions& regions, const FakeGround& ground, Millis now = kStart) {
  for (int i = 0; i < 1000; ++i) {
    const auto asks = regions.take(now);
    if (asks.empty()) return;
    for (const RegionRequest& ask : asks) regions.answered(ask.id, ground.part(askedFor(ask.rect)), now);
  }
}

void verifyShows(const MapRegions& regions, const FakeGround& ground, const geometry::WorldRect& view) {
  QCOMPARE(wrongIn(regions, ground, view), 0);
}

}  // namespace

class TestMapRegions : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theViewShowsTheMap() {
    const FakeGround ground = small();
    MapRegions regions(options(256));
    const geometry::WorldRect view{-20, -15, 10, 12};
    regions.setView(view, view.center());
    settle(regions, ground);
    verifyShows(regions, ground, view);
    QVERIFY(regions.plan().settled(1));
    QCOMPARE(regions.sheets().size(), std::size_t(1));
    QCOMPARE(regions.frame(), std::string("map"));
  }
  void theEdgeOfTheMapIsNothingAndNoHole() {
    const FakeGround ground = small();
    MapRegions regions(options(256));
    const geometry::WorldRect view{30, 10, 80, 60};
    regions.setView(view, view.center());
    settle(regions, ground);
    verifyShows(regions, ground, view);
    const RegionCounts counts = regions.counts();
    QCOMPARE(counts.answered, counts.in_view);
    QVERIFY(counts.nothing > 0);
    QCOMPARE(regions.at({70, 50})->state, RegionState::Nothing);
    QCOMPARE(regions.at({31, 11})->state, RegionState::Held);
  }
  void turnedMapsFillTheirView() {
    FakeGround ground = small();
    ground.origin = {-30, -20, 0.4};
    MapRegions regions(options(256));
    const geometry::WorldRect view{-20, 0, 10, 20};
    regions.setView(view, view.center());
    settle(regions, ground);
    verifyShows(regions, ground, view);
    QCOMPARE(regions.sheets().size(), std::size_t(1));
  }
  void anAnswerWithTheWholeMapAnswersForAllOfIt() {
    const FakeGround ground = small();
    MapRegions regions(options(256));
    const geometry::WorldRect view{-14, -10, 10, 12};
    regions.setView(view, view.center());
    int asked = 0;
    for (int i = 0; i < 100; ++i) {
      const auto asks = regions.take(kStart);
      asked += int(asks.size());
      for (const RegionRequest& ask : asks) regions.answered(ask.id, ground.all(), kStart);
    }
    verifyShows(regions, ground, view);
    QCOMPARE(asked, 1);
    QVERIFY(regions.plan().settled(1));
  }
  void paddedAnswersAreUnknownNotMissing() {
    MapRegions regions(options(256));
    const geometry::WorldRect view{0, 0, 10, 10};
    regions.setView(view, view.center());
    FakeGround ground = small();
    ground.origin = {-300, -300, 0};
    ground.width = ground.height = 30'000;
    ground.cell = [](int, int) { return std::int8_t(-1); };
    settle(regions, ground);
    QCOMPARE(int(shown(regions, {5, 5})), int(grids::kUnknownOccupancy));
    QCOMPARE(regions.at({5, 5})->state, RegionState::Held);
  }
  void anotherRegionIsPlacedAndTheOneWantedCountsAsFailed() {
    const FakeGround ground = small();
    MapRegions regions(options(256));
    const geometry::WorldRect view{1, 1, 9, 9};
    regions.setView(view, view.center());
    const auto probe = regions.take(kStart);
    regions.answered(probe[0].id, ground.part(askedFor(probe[0].rect)), kStart);
    const auto asks = regions.take(kStart);
    QVERIFY(!asks.empty());
    regions.answered(asks[0].id, ground.part({{-25, -15}, {4, 4}}), kStart);
    QCOMPARE(int(shown(regions, {-25.01, -15.01})), int(truth(ground, {-25.01, -15.01})));
    const RegionView region = *regions.at(asks[0].rect.center());
    QCOMPARE(region.state, RegionState::Failed);
    QCOMPARE(region.trouble.kind, RegionTrouble::Kind::Elsewhere);
  }
  void aRegionThatHasBecomeNothingLeavesNothing() {
    const FakeGround ground = small();
    MapRegions regions(options(256));
    const geometry::WorldRect view{1, 1, 9, 9};
    regions.setView(view, view.center());
    settle(regions, ground);
    regions.refresh();
    for (int i = 0; i < 20; ++i) {
      for (const RegionRequest& ask : regions.take(kStart)) {
        if (!ask.is_first)
          QVERIFY(shown(regions, ask.rect.center()) != kNotFetched);  // the old stays until the new is there
        regions.answered(ask.id, map::GridPart{}, kStart);
      }
    }
    QCOMPARE(int(shown(regions, {5, 5})), int(kNotFetched));
    QCOMPARE(regions.at({5, 5})->state, RegionState::Nothing);
  }
  void aMapWithFinerCellsIsCutAnew() {
    FakeGround ground = small();
    MapRegions regions(options(256));
    const geometry::WorldRect view{1, 1, 9, 9};
    regions.setView(view, view.center());
    settle(regions, ground);
    ground.resolution_m = 0.02;
    ground.width = 4000;
    ground.height = 3000;
    regions.refresh();
    settle(regions, ground);
    QCOMPARE(*regions.plan().resolution(), 0.02);
    verifyShows(regions, ground, view);
  }
  void resolutionsThatAlternateComeToAnEnd() {
    FakeGround one = small(), other = small();
    other.resolution_m = 0.01;
    MapRegions regions(options(128));
    const geometry::WorldRect view{1, 1, 9, 9};
    regions.setView(view, view.center());
    int asked = 0;
    for (int i = 0; i < 5000; ++i) {
      const auto asks = regions.take(kStart);
      if (asks.empty()) break;
      for (const RegionRequest& ask : asks)
        regions.answered(ask.id, (asked++ % 2 == 0 ? one : other).part(askedFor(ask.rect)), kStart);
    }
    QVERIFY2(asked < 400, qPrintable(QString::number(asked)));
    QVERIFY(regions.plan().settled(1) || regions.plan().tooFar());
  }

  void walksShowTheMapAskNothingTwiceAndKeepToTheBudget_data() {
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 6; ++seed) QTest::addRow("seed %d", seed) << seed;
  }
  void walksShowTheMapAskNothingTwiceAndKeepToTheBudget() {
    QFETCH(int, seed);
    std::minstd_rand random{unsigned(seed)};
    const auto number = [&](double from, double to) {
      return std::uniform_real_distribution<double>(from, to)(random);
    };
    FakeGround ground;
    ground.width = ground.height = 3000;
    ground.origin = {-75, -75, seed % 3 == 0 ? 0.25 : 0.0};
    if (seed % 2 == 0) ground.origin.x_m += 0.0123;
    MapRegions::Options options;
    options.plan.region_cells = 256;
    options.plan.most_in_view = 24;
    options.budget_bytes = std::size_t(12) << 20;
    MapRegions regions(options);
    std::vector<RegionRequest> in_progress;
    std::set<std::uint64_t> cancelled;
    Millis now = kStart;
    Eigen::Vector2d at(0, 0);
    std::size_t most_bytes = 0;
    int failures = 0;
    const auto step = [&](bool may_fail) {
      for (const RegionRequest& ask : regions.take(now)) {
        for (const RegionRequest& other : in_progress)
          QVERIFY(other.is_first || other.key != ask.key || cancelled.contains(other.id));
        // What has an answer of this round is not asked for.
        in_progress.push_back(ask);
        if (ask.is_first) continue;
        QVERIFY(!regions.plan().row(ask.key).answered);
        QVERIFY(regions.plan().inView().contains(ask.key));
      }
      QVERIFY(int(in_progress.size()) <= options.plan.most_in_progress);
      for (const std::uint64_t id : regions.unwanted()) cancelled.insert(id);
      if (in_progress.empty()) return;
      const std::size_t which = random() % in_progress.size();
      const RegionRequest ask = in_progress[which];
      in_progress.erase(in_progress.begin() + std::ptrdiff_t(which));
      if (cancelled.contains(ask.id) && number(0, 1) < 0.5) {
        regions.answered(ask.id, tl::unexpected(map::Failure{.kind = map::FailureKind::Cancelled}), now);
      } else if (may_fail && number(0, 1) < 0.15) {
        ++failures;
        regions.answered(ask.id, tl::unexpected(map::Failure{.kind = map::FailureKind::TimedOut}), now);
      } else {
        regions.answered(ask.id, ground.part(askedFor(ask.rect)), now);
      }
      if (regions.counts().in_view > 0) most_bytes = std::max(most_bytes, regions.bytes());
    };
    geometry::WorldRect view;
    for (int i = 0; i < 400; ++i) {
      now += Millis(int(number(0, 400)));
      if (i % 4 == 0) {
        at += Eigen::Vector2d(number(-12, 12), number(-12, 12));
        at = at.cwiseMax(Eigen::Vector2d(-90, -90)).cwiseMin(Eigen::Vector2d(90, 90));
        const double half = number(2, 22);
        view = {at.x() - half, at.y() - half * 0.6, at.x() + half, at.y() + half * 0.6};
        regions.setView(view, at);
      }
      step(true);
      if (QTest::currentTestFailed()) return;
    }
    // In view at most 24 regions of 16 tiles and their coarser ones; a turned sheet has more tiles at the
    // rim.
    QVERIFY2(most_bytes <= options.budget_bytes + (std::size_t(14) << 20),
             qPrintable(QString::number(most_bytes)));
    QVERIFY(failures > 0);
    for (int i = 0; i < 2000 && !(regions.plan().settled(1'000) && in_progress.empty()); ++i) {
      now += Millis(10'000);
      step(false);
      if (QTest::currentTestFailed()) return;
    }
    QVERIFY(!regions.plan().tooFar());
    QCOMPARE(regions.counts().answered, regions.counts().in_view);
    verifyShows(regions, ground, view);
  }
};

}  // namespace test_map_regions

MAPWRIGHT_TEST(test_map_regions, TestMapRegions, Nothing)
#include "test_map_regions.moc"
