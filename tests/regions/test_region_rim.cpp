// The rim of a map whose dispatcher cuts what is partly beyond it, or answers it with nothing, and answers
// that lie elsewhere. Source: docs/protocols/rep130-map-dispatcher.md, "Left open".
#include <random>

#include <QtTest>

#include "fake_dispatch.h"
#include "map_shown.h"
#include "regions/region_sheet.h"
#include "test_program.h"

namespace test_region_rim {

using namespace mapwright;
using namespace mapwright::regions;
using geometry::WorldRect;

namespace {

constexpr Millis kNow{10'000};

/// Lower left corner at -37.35, -12.8; counted in twentieths of a metre.
FakeGround hall(int width, int height) {
  FakeGround ground;
  ground.resolution_m = 0.1;
  ground.width = width / 2;
  ground.height = height / 2;
  ground.origin = {-37.35, -12.8, 0};
  return ground;
}

WorldRect boundsOf(const FakeGround& ground) {
  return {ground.origin.x_m, ground.origin.y_m, ground.origin.x_m + ground.width * ground.resolution_m,
          ground.origin.y_m + ground.height * ground.resolution_m};
}

/// As the strictest dispatcher answers: nothing, unless all of it is on the map.
map::GridPart strictly(const FakeGround& ground, const map::GridRegion& region) {
  const WorldRect map = boundsOf(ground);
  const Eigen::Vector2d low = region.centre_m - region.size_m / 2, high = region.centre_m + region.size_m / 2;
  if (map.contains(low) && map.contains(high)) return ground.part(region);
  map::GridPart nothing;
  nothing.frame = ground.frame;
  nothing.grid.resolution_m = ground.resolution_m;
  return nothing;
}

map::GridPart cutting(const FakeGround& ground, const map::GridRegion& region) { return ground.part(region); }

/// The same of one that rounds to the nearest edges of cells.
map::GridPart roundly(const FakeGround& ground, const map::GridRegion& region) {
  const auto snapped = [&](const Eigen::Vector2d& at) -> Eigen::Vector2d {
    const Eigen::Vector2d zero(ground.origin.x_m, ground.origin.y_m);
    return ((at - zero) / ground.resolution_m).array().round().matrix() * ground.resolution_m + zero;
  };
  const map::GridPart strict = strictly(ground, region);
  if (strict.grid.width == 0) return strict;
  const Eigen::Vector2d low = snapped(region.centre_m - region.size_m / 2);
  const Eigen::Vector2d high = snapped(region.centre_m + region.size_m / 2);
  return ground.part({(low + high) / 2, high - low});
}

MapRegions regionsOf(int region_cells, std::optional<WorldRect> only = {}) {
  MapRegions::Options options;
  options.plan.region_cells = region_cells / 2;
  options.plan.only = only;
  options.plan.most_in_view = 64;
  return MapRegions(options);
}

/// Answers everything that is asked for until nothing is due; how many questions that were.
template <typename Answer>
int settle(MapRegions& regions, const Answer& answer) {
  int asked = 0;
  while (asked < 5000) {
    const auto asks = regions.take(kNow);
    if (asks.empty()) break;
    for (const RegionRequest& ask : asks) {
      regions.answered(ask.id, answer(askedFor(ask.rect)), kNow);
      ++asked;
    }
  }
  return asked;
}

void look(MapRegions& regions, const WorldRect& view) { regions.setView(view, view.center()); }

/// Places of the view that show what the ground does not have there.
int misplacedIn(const MapRegions& regions, const FakeGround& ground, const WorldRect& view) {
  int misplaced = 0;
  for (double x = view.min_x + 0.013; x < view.max_x; x += 0.37) {
    for (double y = view.min_y + 0.017; y < view.max_y; y += 0.41) {
      const std::uint8_t cell = shown(regions, {x, y});
      misplaced += cell != kNotFetched && cell != truth(ground, {x, y});
    }
  }
  return misplaced;
}

}  // namespace

class TestRegionRim : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whereTheRobotTellsHowLargeItsMapIsOnlyThatIsAskedFor_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<WorldRect>("view");
    QTest::newRow("within one square") << 500 << 400 << WorldRect{-30, -10, -20, 0};
    QTest::newRow("all of a small map") << 500 << 400 << WorldRect{-60, -40, 20, 40};
    QTest::newRow("a corner") << 3000 << 2000 << WorldRect{-60, -30, -10, 20};
    QTest::newRow("an edge") << 3000 << 2000 << WorldRect{10, -30, 60, 10};
    QTest::newRow("all of it") << 3000 << 2000 << WorldRect{-45, -20, 120, 95};
    QTest::newRow("whole squares") << 2048 << 1024 << WorldRect{-45, -20, 75, 45};
  }
  void whereTheRobotTellsHowLargeItsMapIsOnlyThatIsAskedFor() {
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(WorldRect, view);
    const FakeGround ground = hall(width, height);
    for (const auto& answer : {strictly, roundly, cutting}) {
      MapRegions regions = regionsOf(512);
      regions.setExtent(ground.all().grid);
      look(regions, view);
      const int asked = settle(regions, [&](const auto& region) { return answer(ground, region); });
      QCOMPARE(wrongIn(regions, ground, view), 0);
      QVERIFY2(asked <= regions.counts().in_view + 1, qPrintable(QString::number(asked)));
      QVERIFY(regions.plan().settled(1));
      QCOMPARE(regions.counts().failed, 0);
      QCOMPARE(regions.counts().smaller, 0);
    }
  }

  void whereNobodyTellsTheRimOfAStrictMapStaysOpen() {
    const FakeGround ground = hall(3000, 2000);
    MapRegions regions = regionsOf(512);
    const WorldRect view{-60, -30, 40, 60}, inside{-20, 0, 40, 60};
    look(regions, view);
    const int asked = settle(regions, [&](const auto& region) { return strictly(ground, region); });
    QVERIFY2(asked <= 2 * regions.counts().in_view, qPrintable(QString::number(asked)));
    QVERIFY(regions.plan().settled(1));
    QCOMPARE(misplacedIn(regions, ground, view), 0);
    QCOMPARE(wrongIn(regions, ground, inside), 0);
    QVERIFY(regions.counts().nothing > 0);
  }

  void aSmallMapOfAStrictDispatcherIsLookedAtInSmallerSquares() {
    const FakeGround ground = hall(1000, 800);
    MapRegions regions = regionsOf(1024);
    const WorldRect view{-37, -12, 12, 27};
    look(regions, view);
    const int asked = settle(regions, [&](const auto& region) { return strictly(ground, region); });
    QVERIFY2(asked <= 200, qPrintable(QString::number(asked)));
    QCOMPARE(misplacedIn(regions, ground, view), 0);
    QCOMPARE(wrongIn(regions, ground, {-20, 0, -10, 10}), 0);
  }

  void whatIsAskedForByItselfIsThereThoughItsSquaresAreNot() {
    const FakeGround ground = hall(3000, 2000);
    std::mt19937 random(1);
    const WorldRect map = boundsOf(ground);
    for (int i = 0; i < 30; ++i) {
      const double wide = 5 + double(random() % 60), high = 5 + double(random() % 60);
      // A margin of half a cell is asked for.
      WorldRect rect{map.min_x + 0.1 + (map.width() - 0.2 - wide) * double(random() % 100) / 99,
                     map.min_y + 0.1 + (map.height() - 0.2 - high) * double(random() % 100) / 99, 0, 0};
      rect.max_x = rect.min_x + wide;
      rect.max_y = rect.min_y + high;
      MapRegions regions = regionsOf(1024, rect);
      look(regions, rect);
      settle(regions, [&](const auto& region) { return strictly(ground, region); });
      QCOMPARE(wrongIn(regions, ground, rect.grown(-0.1)), 0);
      QCOMPARE(regions.counts().answered, regions.counts().in_view);
    }
  }

  void panningAlongTheRimAndRefreshingShowTheMap() {
    const FakeGround ground = hall(3000, 2000);
    MapRegions regions = regionsOf(512);
    regions.setExtent(ground.all().grid);
    std::mt19937 random(2);
    WorldRect view{-10, 0, 30, 30};
    for (int i = 0; i < 60; ++i) {
      const Eigen::Vector2d by(double(random() % 41) - 20, double(random() % 41) - 20);
      const WorldRect next{view.min_x + by.x(), view.min_y + by.y(), view.max_x + by.x(),
                           view.max_y + by.y()};
      if (boundsOf(ground).contains(next.center())) view = next;
      look(regions, view);
      if (i % 7 == 6) regions.refresh();
      settle(regions, [&](const auto& region) { return strictly(ground, region); });
      QCOMPARE(wrongIn(regions, ground, view), 0);
    }
  }

  void aMapThatBecameSmallerLeavesNothingBeyondIt() {
    const FakeGround large = hall(3000, 2000), less = hall(2500, 1700);
    const WorldRect view{60, 60, 115, 90};
    for (const auto& answer : {strictly, cutting}) {
      MapRegions regions = regionsOf(512);
      regions.setExtent(large.all().grid);
      look(regions, view);
      settle(regions, [&](const auto& region) { return answer(large, region); });
      QCOMPARE(wrongIn(regions, large, view), 0);
      regions.setExtent(less.all().grid);
      regions.refresh();
      settle(regions, [&](const auto& region) { return answer(less, region); });
      QCOMPARE(wrongIn(regions, less, view), 0);
    }
  }

  void beyondTheMapLittleIsAskedFor() {
    const FakeGround ground = hall(500, 400);
    MapRegions regions = regionsOf(512);
    const WorldRect view{500, 500, 560, 560};
    look(regions, view);
    const int asked = settle(regions, [&](const auto& region) { return strictly(ground, region); });
    QCOMPARE(regions.counts().nothing, regions.counts().in_view);
    QVERIFY2(asked <= regions.counts().in_view + 1, qPrintable(QString::number(asked)));
    look(regions, view);
    QCOMPARE(settle(regions, [&](const auto& region) { return strictly(ground, region); }), 0);
  }

  void aMapThatIsCutAtItsRimCostsNothing() {
    const FakeGround ground = hall(2048, 2048);  // ends where squares do
    MapRegions regions = regionsOf(512);
    const WorldRect view{-37, -12, 80, 100};
    look(regions, view);
    const int asked = settle(regions, [&](const auto& region) { return ground.part(region); });
    QCOMPARE(wrongIn(regions, ground, view), 0);
    QVERIFY2(asked <= regions.counts().in_view + 1, qPrintable(QString::number(asked)));
  }

  void answersThatLieBesideInPartAreNotWhatWasAskedFor() {
    const FakeGround ground = hall(3000, 2000);
    const WorldRect view{0, 0, 40, 30};
    MapRegions regions = regionsOf(512);
    look(regions, view);
    // x, y as the lower left corner.
    settle(regions, [&](map::GridRegion region) {
      region.centre_m += region.size_m / 2;
      return ground.part(region);
    });
    QVERIFY(regions.counts().answered < regions.counts().in_view);
    const RegionView region = regions.inView().front();
    QCOMPARE(region.trouble.kind, RegionTrouble::Kind::Elsewhere);
    // What came lies where it belongs all the same.
    int wrong = 0, there = 0;
    for (double x = -30.013; x < 110; x += 0.7) {
      for (double y = -12.013; y < 85; y += 0.7) {
        const std::uint8_t cell = shown(regions, {x, y});
        there += cell != kNotFetched;
        wrong += cell != kNotFetched && cell != truth(ground, {x, y});
      }
    }
    QVERIFY(there > 1000);
    QCOMPARE(wrong, 0);
  }

  // The cells of a turned map that lie around a square may all lie beside it.
  void aCornerOfATurnedMapIsNoOtherRegion() {
    FakeGround ground = hall(3000, 2000);
    ground.origin.yaw_rad = 0.4;
    MapRegions regions = regionsOf(256);
    const WorldRect view{60, 20, 125, 110};
    look(regions, view);
    settle(regions, [&](const auto& region) { return ground.part(region); });
    QCOMPARE(regions.counts().failed, 0);
    QCOMPARE(regions.counts().answered, regions.counts().in_view);
    QVERIFY(liesElsewhere(ground.part({{0, 0}, {4, 4}}).grid, {60, 60, 64, 64}));
    QVERIFY(liesElsewhere(ground.part({{30, 30}, {4, 4}}).grid, {29, 29, 33, 33}));
    QVERIFY(!liesElsewhere(ground.part({{30, 30}, {4, 4}}).grid, {28, 28, 32, 32}));
  }

  void answersThatAreTooSmallAreTold() {
    const FakeGround ground = hall(3000, 2000);
    MapRegions regions = regionsOf(512);
    look(regions, {0, 0, 40, 30});
    settle(regions, [&](map::GridRegion region) {
      region.size_m = (region.size_m - Eigen::Vector2d(3, 3)).cwiseMax(0.001);
      return ground.part(region);
    });
    QCOMPARE(regions.counts().smaller, regions.counts().in_view);
    // At the edge of the map they end with it.
    MapRegions at_edge = regionsOf(512);
    look(at_edge, {-60, -30, 40, 30});
    settle(at_edge, [&](const auto& region) { return ground.part(region); });
    QCOMPARE(at_edge.counts().smaller, 0);
  }
};

}  // namespace test_region_rim

MAPWRIGHT_TEST(test_region_rim, TestRegionRim, Nothing)
#include "test_region_rim.moc"
