// The rim of a map whose dispatcher answers what is partly beyond it with nothing, and answers that lie
// elsewhere. Source: docs/protocols/rep130-map-dispatcher.md, "Left open".
#include <random>

#include <QtTest>

#include "fake_dispatch.h"
#include "map_shown.h"
#include "regions/region_answer.h"
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

}  // namespace

class TestRegionRim : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theRimOfAMapIsFoundWhereNothingMayReachBeyondIt_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<WorldRect>("view");
    QTest::addColumn<int>("most_asked");
    // A dozen among them find out that they are not too much for one answer.
    QTest::newRow("within one square") << 500 << 400 << WorldRect{-30, -10, -20, 0} << 75;
    QTest::newRow("all of a small map") << 500 << 400 << WorldRect{-60, -40, 20, 40} << 115;
    QTest::newRow("a corner") << 3000 << 2000 << WorldRect{-60, -30, -10, 20} << 100;
    QTest::newRow("an edge") << 3000 << 2000 << WorldRect{10, -30, 60, 10} << 100;
    QTest::newRow("all of it") << 3000 << 2000 << WorldRect{-45, -20, 120, 95} << 250;
    QTest::newRow("whole squares") << 2048 << 1024 << WorldRect{-45, -20, 75, 45} << 160;
  }
  void theRimOfAMapIsFoundWhereNothingMayReachBeyondIt() {
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(WorldRect, view);
    QFETCH(int, most_asked);
    const FakeGround ground = hall(width, height);
    MapRegions regions = regionsOf(512);
    look(regions, view);
    const int asked = settle(regions, [&](const auto& region) { return strictly(ground, region); });
    QCOMPARE(wrongIn(regions, ground, view), 0);
    QVERIFY2(asked <= most_asked, qPrintable(QString::number(asked)));
    QVERIFY(regions.plan().settled(1));
    QCOMPARE(regions.counts().failed, 0);
    MapRegions rounded = regionsOf(512);
    look(rounded, view);
    settle(rounded, [&](const auto& region) { return roundly(ground, region); });
    QCOMPARE(wrongIn(rounded, ground, view), 0);
  }

  void whatIsAskedForByItselfIsThereThoughItsSquaresAreNot() {
    const FakeGround ground = hall(3000, 2000);
    std::mt19937 random(1);
    const WorldRect map = boundsOf(ground);
    for (int i = 0; i < 30; ++i) {
      const double wide = 5 + double(random() % 60), high = 5 + double(random() % 60);
      WorldRect rect{map.min_x + (map.width() - wide) * double(random() % 100) / 99,
                     map.min_y + (map.height() - high) * double(random() % 100) / 99, 0, 0};
      rect.max_x = rect.min_x + wide;
      rect.max_y = rect.min_y + high;
      MapRegions regions = regionsOf(1024, rect);
      look(regions, rect);
      settle(regions, [&](const auto& region) { return strictly(ground, region); });
      QCOMPARE(wrongIn(regions, ground, rect.grown(-0.1)), 0);
      QCOMPARE(regions.counts().answered, regions.counts().in_view);
    }
  }

  void whereTheRobotTellsHowLargeItsMapIsOnlyThatIsAskedFor() {
    const FakeGround ground = hall(3000, 2000);
    const WorldRect view{-60, -30, 40, 60};
    MapRegions searched = regionsOf(512), told = regionsOf(512);
    const auto strict = [&](const auto& region) { return strictly(ground, region); };
    look(searched, view);
    const int asked = settle(searched, strict);
    told.setExtent(ground.all().grid);
    look(told, view);
    const int asked_told = settle(told, strict);
    QCOMPARE(wrongIn(told, ground, view), 0);
    QVERIFY2(asked_told < asked, qPrintable(QString::number(asked_told)));
    // What is told may be wrong.
    for (const int cells : {300, 900, 4000}) {
      FakeGround other = ground;
      other.width = other.height = cells;
      for (const bool cuts : {true, false}) {
        MapRegions misled = regionsOf(512);
        misled.setExtent(map::GridReference{cells, cells, ground.resolution_m, ground.origin});
        look(misled, view);
        settle(misled,
               [&](const auto& region) { return cuts ? ground.part(region) : strictly(ground, region); });
        QCOMPARE(wrongIn(misled, ground, view), 0);
        QCOMPARE(misled.counts().smaller, 0);
      }
    }
  }

  void aMapThatReachesIntoACornerOfWhatIsAskedForIsFound() {
    const FakeGround ground = hall(3000, 2000);
    const WorldRect map = boundsOf(ground);
    for (const double x : {map.min_x + 0.35, map.max_x - 0.35, map.min_x - 4, map.max_x + 4}) {
      for (const double y : {map.min_y + 0.8, map.max_y - 0.8, map.min_y - 4}) {
        const WorldRect rect = WorldRect{x, y, x, y}.grown(10);
        MapRegions regions = regionsOf(1024, rect);
        look(regions, rect);
        settle(regions, [&](const auto& region) { return strictly(ground, region); });
        QCOMPARE(wrongIn(regions, ground, rect.grown(-0.1)), 0);
      }
    }
  }

  void whereThereIsNoMapAtAllTheLookingEnds() {
    const FakeGround ground = hall(3000, 2000);
    MapRegions one = regionsOf(512);
    look(one, {500, 500, 510, 510});
    const auto strict = [&](const auto& region) { return strictly(ground, region); };
    QVERIFY(settle(one, strict) <= 40);
    MapRegions many = regionsOf(512);
    look(many, {500, 500, 600, 600});
    const int asked = settle(many, strict);
    QVERIFY2(asked <= 200, qPrintable(QString::number(asked)));
    QVERIFY(many.plan().settled(1));
    // What is looked at next is not searched as finely again.
    look(many, {600, 600, 700, 700});
    const int further = settle(many, strict);
    QVERIFY2(further < asked && further <= 100, qPrintable(QString::number(further)));
  }

  void panningAlongTheRimAndRefreshingShowTheMap() {
    const FakeGround ground = hall(3000, 2000);
    MapRegions regions = regionsOf(512);
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
    MapRegions regions = regionsOf(512);
    const WorldRect view{60, 60, 115, 90};
    look(regions, view);
    settle(regions, [&](const auto& region) { return strictly(large, region); });
    QCOMPARE(wrongIn(regions, large, view), 0);
    regions.refresh();
    settle(regions, [&](const auto& region) { return strictly(less, region); });
    QCOMPARE(wrongIn(regions, less, view), 0);
  }

  void beyondTheMapLittleIsAskedFor() {
    const FakeGround ground = hall(500, 400);
    MapRegions regions = regionsOf(512);
    const WorldRect view{500, 500, 560, 560};
    look(regions, view);
    const int asked = settle(regions, [&](const auto& region) { return strictly(ground, region); });
    QCOMPARE(regions.counts().nothing, regions.counts().in_view);
    constexpr int kFineLooks = 64;  // for a map of which nothing is known
    QVERIFY2(asked <= 2 * regions.counts().in_view + 2 + kFineLooks, qPrintable(QString::number(asked)));
    look(regions, view);
    QCOMPARE(settle(regions, [&](const auto& region) { return strictly(ground, region); }), 0);
  }

  void aMapThatIsCutAtItsRimCostsAQuestionASideAtMost() {
    const FakeGround ground = hall(2048, 2048);  // ends where squares do
    MapRegions regions = regionsOf(512);
    const WorldRect view{-37, -12, 80, 100};
    look(regions, view);
    const int asked = settle(regions, [&](const auto& region) { return ground.part(region); });
    QCOMPARE(wrongIn(regions, ground, view), 0);
    QVERIFY2(asked <= 2 * regions.counts().in_view, qPrintable(QString::number(asked)));
  }

  void aSearchThatFailsIsTriedAgain() {
    const FakeGround ground = hall(3000, 2000);
    MapRegions regions = regionsOf(512);
    const WorldRect view{-60, -30, -10, 20};
    look(regions, view);
    std::mt19937 random(3);
    Millis now = kNow;
    for (int i = 0; i < 5000 && (!regions.plan().settled(100) || i == 0); ++i, now += Millis(60'000)) {
      for (const RegionRequest& ask : regions.take(now)) {
        if (random() % 3 == 0) {
          regions.answered(ask.id, tl::unexpected(map::Failure{.kind = map::FailureKind::TimedOut}), now);
        } else {
          regions.answered(ask.id, strictly(ground, askedFor(ask.rect)), now);
        }
      }
    }
    QCOMPARE(wrongIn(regions, ground, view), 0);
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

  void whoTakesPlacesForCornersIsAskedForCorners_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::newRow("lower left") << 0.5 << 0.5;
    QTest::newRow("upper left") << 0.5 << -0.5;
  }
  void whoTakesPlacesForCornersIsAskedForCorners() {
    QFETCH(double, x);
    QFETCH(double, y);
    const FakeGround ground = hall(3000, 2000);
    const WorldRect view{-60, -30, 40, 30};
    MapRegions regions = regionsOf(512);
    regions.setView(view, {0, 0});
    int asked = 0;
    for (auto asks = regions.take(kNow); !asks.empty() && asked < 1000; asks = regions.take(kNow)) {
      for (const RegionRequest& ask : asks) {
        ++asked;
        map::GridRegion region = questionOf(ask);
        region.centre_m += region.size_m.cwiseProduct(Eigen::Vector2d(x, y));
        regions.answered(ask.id, ground.part(region), kNow);
      }
    }
    QVERIFY(regions.asksForCorners());
    QCOMPARE(wrongIn(regions, ground, view), 0);
    QCOMPARE(regions.counts().failed, 0);
    QCOMPARE(regions.counts().answered, regions.counts().in_view);
    QVERIFY2(asked <= 2 * regions.counts().in_view, qPrintable(QString::number(asked)));
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

  void whatCameForANeighbourOfTheSameRoundIsNotForgotten() {
    const FakeGround ground = hall(3000, 2000);
    const WorldRect view{0, 0, 40, 30};
    // Each answer reaches far into the square to the left, and its own square is cut.
    const auto answer = [&](map::GridRegion region) {
      region.centre_m.x() -= region.size_m.x() * 0.4;
      region.size_m.x() *= 1.2;
      return ground.part(region);
    };
    std::vector<std::uint8_t> first;
    for (int order = 0; order < 4; ++order) {
      MapRegions regions = regionsOf(512);
      look(regions, view);
      std::mt19937 random{unsigned(order)};
      std::vector<RegionRequest> waiting;
      for (int i = 0; i < 1000; ++i) {
        for (const RegionRequest& ask : regions.take(kNow)) waiting.push_back(ask);
        if (waiting.empty()) break;
        const auto one = waiting.begin() + std::ptrdiff_t(random() % waiting.size());
        const RegionRequest ask = *one;
        waiting.erase(one);
        regions.answered(ask.id, answer(askedFor(ask.rect)), kNow);
      }
      std::vector<std::uint8_t> cells;
      for (double x = view.min_x; x < view.max_x; x += 0.31) {
        for (double y = view.min_y; y < view.max_y; y += 0.31) cells.push_back(shown(regions, {x, y}));
      }
      if (order == 0) first = cells;
      QVERIFY(cells == first);
    }
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
    MapRegions strict = regionsOf(512);
    look(strict, {-60, -30, 40, 30});
    settle(strict, [&](const auto& region) { return strictly(ground, region); });
    QCOMPARE(strict.counts().smaller, 0);
  }

  void aRectangleWithoutOthersIsWhatIsLeftOfIt() {
    std::mt19937 random(4);
    for (int i = 0; i < 200; ++i) {
      const auto any = [&] {
        const double x = double(random() % 20), y = double(random() % 20);
        return WorldRect{x, y, x + 1 + double(random() % 10), y + 1 + double(random() % 10)};
      };
      const WorldRect rect = any();
      std::vector<WorldRect> others(random() % 5);
      for (WorldRect& other : others) other = any();
      const auto left = without(rect, others);
      for (double x = 0.5; x < 32; ++x) {
        for (double y = 0.5; y < 32; ++y) {
          const Eigen::Vector2d at(x, y);
          const auto in = [&](const WorldRect& one) { return one.contains(at); };
          const bool expected = rect.contains(at) && std::none_of(others.begin(), others.end(), in);
          QCOMPARE(std::count_if(left.begin(), left.end(), in), expected ? 1 : 0);
        }
      }
    }
  }
};

}  // namespace test_region_rim

MAPWRIGHT_TEST(test_region_rim, TestRegionRim, Nothing)
#include "test_region_rim.moc"
