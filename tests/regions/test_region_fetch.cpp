// Asking a dispatcher for regions, and for one rectangle.
#include <QtTest>

#include "../test_timeouts.h"
#include "fake_dispatch.h"
#include "grids/grid_pyramid.h"
#include "regions/region_fetch.h"
#include "regions/region_sheet.h"
#include "test_program.h"

namespace test_region_fetch {

using namespace mapwright;
using namespace mapwright::regions;

namespace {

class Clock {
 public:
  Millis now{1'000};
  std::function<Millis()> reader() {
    return [this] { return now; };
  }
};

}  // namespace

class TestRegionFetch : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aMapAsksForItsViewAndNoMoreThanTwoAtATime() {
    FakeDispatch dispatch;
    Clock clock;
    RegionMap map(dispatch, {.regions = {}, .monotonic = clock.reader()});
    QSignalSpy cells(&map, &RegionMap::cellsChanged);
    map.setView(geometry::WorldRect{-60, -20, 60, 20}, {0, 0});
    while (dispatch.answerOne()) {
    }
    QCOMPARE(dispatch.most_at_once, 2);
    QVERIFY(map.regions().plan().settled(1));
    QVERIFY(cells.count() >= map.regions().counts().in_view);
    const int asked = int(dispatch.asked.size());
    map.setView(geometry::WorldRect{-50, -20, 50, 20}, {0, 0});
    QCOMPARE(int(dispatch.asked.size()), asked);  // nothing twice
    Q_EMIT dispatch.mapChanged();
    QVERIFY(int(dispatch.asked.size()) > asked);
  }
  void whoLooksAwayCancels() {
    FakeDispatch dispatch;
    RegionMap map(dispatch, {});
    map.setView(geometry::WorldRect{1, 1, 9, 9}, {5, 5});
    dispatch.answerOne();
    QVERIFY(!dispatch.waiting.empty());
    map.setView(std::nullopt, {0, 0});
    for (const auto& one : dispatch.waiting) QVERIFY(one->cancelled);
    while (dispatch.answerOne()) {
    }
    QVERIFY(dispatch.waiting.empty());
  }
  void answersAfterItsEndAreOfNoConsequence() {
    FakeDispatch dispatch;
    {
      RegionMap map(dispatch, {});
      map.setView(geometry::WorldRect{1, 1, 9, 9}, {5, 5});
      QCOMPARE(dispatch.waiting.size(), std::size_t(1));
    }
    QVERIFY(dispatch.waiting.front()->cancelled);
    while (dispatch.answerOne()) {
    }
  }
  void aDispatcherThatGoesLeavesWhatCame() {
    auto dispatch = std::make_unique<FakeDispatch>();
    RegionMap map(*dispatch, {});
    map.setView(geometry::WorldRect{1, 1, 9, 9}, {5, 5});
    while (dispatch->answerOne()) {
    }
    const std::size_t bytes = map.regions().bytes();
    QVERIFY(bytes > 0);
    dispatch.reset();
    QVERIFY(!map.offered());
    map.setView(geometry::WorldRect{100, 100, 110, 110}, {105, 105});
    map.refresh();
    QCOMPARE(map.regions().bytes(), bytes);
  }
  void withoutTheServiceNothingIsAskedForUntilItComes() {
    FakeDispatch dispatch;
    dispatch.offers_regions = false;
    RegionMap map(dispatch, {});
    map.setView(geometry::WorldRect{1, 1, 9, 9}, {5, 5});
    QVERIFY(dispatch.asked.empty());
    dispatch.offers_regions = true;
    Q_EMIT dispatch.offersChanged();
    QCOMPARE(dispatch.asked.size(), std::size_t(1));
  }
  void aRectangleBecomesAMapOfItsOwn() {
    FakeDispatch dispatch;
    dispatch.by_itself = true;
    const geometry::WorldRect rect{-3.2, 1.05, 60.3, 12.5};
    RegionFetch fetch(dispatch, rect, {});
    fetch.start();
    QTRY_VERIFY(fetch.over());
    QVERIFY(fetch.complete());
    const FetchedGrid fetched = cutOut(fetch.map().regions().sheets(), rect);
    QVERIFY(fetched.cells);
    QCOMPARE(fetched.reference.width, 1270);
    QCOMPARE(fetched.reference.height, 229);
    QVERIFY(std::abs(fetched.reference.origin.x_m + 3.2) < 1e-6);
    QVERIFY(std::abs(fetched.reference.origin.y_m - 1.05) < 1e-6);
    QCOMPARE(fetched.other_lattices, 0);
    for (int u = 0; u < fetched.reference.width; u += 13) {
      for (int v = 0; v < fetched.reference.height; v += 7) {
        const Eigen::Vector2d world = fetched.reference.worldFromCell({u + 0.5, v + 0.5});
        const Eigen::Vector2d cell = (world - Eigen::Vector2d(-204.8, -204.8)) / 0.05;
        QCOMPARE(int(fetched.cells->at(u, v)),
                 int(std::uint8_t(dispatch.ground.cell(int(cell.x()), int(cell.y())))));
      }
    }
  }
  /// A picture whose pixels are smaller than a cell has nothing blank at its edges.
  void whatReachesIntoARectangleIsCutOutWhereThatIsWanted_data() {
    QTest::addColumn<geometry::WorldRect>("rect");
    QTest::addColumn<double>("yaw");
    QTest::newRow("edges in cells") << geometry::WorldRect{-7.37, -3.16, 11.12, 2.24} << 0.0;
    QTest::newRow("less than a cell") << geometry::WorldRect{0.005, 0.005, 0.015, 0.01} << 0.0;
    QTest::newRow("whole cells") << geometry::WorldRect{-1, -1, 1, 1} << 0.0;
    QTest::newRow("turned") << geometry::WorldRect{-7.37, -3.16, 11.12, 2.24} << 0.3;
  }
  void whatReachesIntoARectangleIsCutOutWhereThatIsWanted() {
    QFETCH(geometry::WorldRect, rect);
    QFETCH(double, yaw);
    FakeGround ground;
    ground.origin.yaw_rad = yaw;
    RegionCells cells;
    QVERIFY(cells.put(ground.part({{0, 0}, {40, 40}})));
    const FetchedGrid fetched = cutOut(cells.sheets(), rect, CutEdge::Touched);
    QVERIFY(fetched.cells);
    const RegionSheet& sheet = *cells.sheets().front();
    constexpr int kSteps = 97;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        constexpr double kInside = 1e-9;
        const Eigen::Vector2d at(std::lerp(rect.min_x + kInside, rect.max_x - kInside, i / double(kSteps)),
                                 std::lerp(rect.min_y + kInside, rect.max_y - kInside, j / double(kSteps)));
        const Eigen::Vector2d wanted = sheet.reference().cellFromWorld(at),
                              cell = fetched.reference.cellFromWorld(at);
        const bool on_a_line = std::abs(wanted.x() - std::round(wanted.x())) < 1e-5 ||
                               std::abs(wanted.y() - std::round(wanted.y())) < 1e-5;
        if (on_a_line) continue;
        QVERIFY(cell.x() >= 0 && cell.y() >= 0 && cell.x() < fetched.reference.width &&
                cell.y() < fetched.reference.height);
        QCOMPARE(int(fetched.cells->at(int(cell.x()), int(cell.y()))),
                 int(sheet.at(int(wanted.x()), int(wanted.y()))));
      }
    }
    if (yaw == 0 && rect.width() == 2) QCOMPARE(fetched.reference.width, 40);
  }
  void whatIsCutOutIsTheSameAsAMapOfItsCells_data() {
    QTest::addColumn<geometry::WorldRect>("rect");
    QTest::addColumn<double>("yaw");
    QTest::newRow("odd") << geometry::WorldRect{-7.35, -3.15, 31.1, 22.2} << 0.0;
    QTest::newRow("whole tiles") << geometry::WorldRect{-12.8, -12.8, 12.8, 25.6} << 0.0;
    QTest::newRow("narrow") << geometry::WorldRect{-20, 1, 40, 1.35} << 0.0;
    QTest::newRow("beyond what came") << geometry::WorldRect{-60, -60, 10, 10} << 0.0;
    QTest::newRow("turned") << geometry::WorldRect{-7.35, -3.15, 21.1, 12.2} << 0.3;
  }
  void whatIsCutOutIsTheSameAsAMapOfItsCells() {
    QFETCH(geometry::WorldRect, rect);
    QFETCH(double, yaw);
    FakeGround ground;
    ground.origin.yaw_rad = yaw;
    RegionCells cells;
    for (const double x : {-20.0, 0.0, 20.0}) {
      for (const double y : {-20.0, 0.0, 20.0}) QVERIFY(cells.put(ground.part({{x, y}, {20, 20}})));
    }
    const FetchedGrid fetched = cutOut(cells.sheets(), rect);
    QVERIFY(fetched.cells);
    const int width = fetched.reference.width, height = fetched.reference.height;
    const auto builder =
        grids::buildGrid(width, height, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
    const RegionSheet& sheet = *cells.sheets().front();
    std::vector<std::uint8_t> row(std::size_t(width), 0);
    int known = 0;
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const Eigen::Vector2d world = fetched.reference.worldFromCell({u + 0.5, v + 0.5});
        const Eigen::Vector2d cell = sheet.reference().cellFromWorld(world);
        const std::uint8_t byte = sheet.at(int(cell.x()), int(cell.y()));
        const bool there = byte != kNotFetched && (yaw == 0 || rect.contains(world));
        row[std::size_t(u)] = there ? byte : grids::kUnknownOccupancy;
        known += row[std::size_t(u)] != grids::kUnknownOccupancy;
      }
      builder->pushRow(row);
    }
    builder->finish();
    QVERIFY(known > 100);
    const auto expected = builder->pyramid();
    QCOMPARE(fetched.cells->levels(), expected->levels());
    constexpr int kTile = grids::GridPyramid::kTileEdge;
    for (int level = expected->levels(); level-- > 0;) {
      for (int y = 0; y * kTile < expected->levelHeight(level); ++y) {
        for (int x = 0; x * kTile < expected->levelWidth(level); ++x) {
          const auto one = fetched.cells->tile(level, x, y), other = expected->tile(level, x, y);
          QVERIFY(one && other);
          QVERIFY(std::equal(one->cells.get(), one->cells.get() + kTile * kTile, other->cells.get()));
        }
      }
      QVERIFY(!fetched.cells->tile(level, (expected->levelWidth(level) + kTile - 1) / kTile, 0));
    }
    // What comes later is not in it.
    const std::vector<std::int8_t> before = *cellsOf(*fetched.cells);
    ground.cell = [](int, int) { return std::int8_t(55); };
    QVERIFY(cells.put(ground.part({{0, 0}, {20, 20}})));
    QCOMPARE(*cellsOf(*fetched.cells), before);
  }
  void whatFailsIsTriedAFewTimesAndToldOf() {
    FakeDispatch dispatch;
    Clock clock;
    RegionFetch fetch(dispatch, {-10, -10, 10, 10}, {.tries = 2, .monotonic = clock.reader()});
    fetch.start();
    dispatch.answerOne();
    dispatch.answer = [](const map::GridRegion&) -> robot::Outcome<map::GridPart> {
      return tl::unexpected(map::Failure{.kind = map::FailureKind::TimedOut});
    };
    for (int i = 0; i < 40 && !fetch.over(); ++i) {
      while (dispatch.answerOne()) {
      }
      clock.now += Millis(5'000);
      fetch.map().look();
      QCoreApplication::processEvents();
    }
    QVERIFY(fetch.over());
    QVERIFY(!fetch.complete());
    QCOMPARE(fetch.trouble().kind, RegionTrouble::Kind::Failed);
    QCOMPARE(fetch.counts().failed, fetch.counts().in_view);
  }
  void aRectangleThatIsTooLargeIsRefused() {
    FakeDispatch dispatch;
    dispatch.by_itself = true;
    RegionFetch fetch(dispatch, {-5000, -5000, 5000, 5000}, {});
    fetch.start();
    QTRY_VERIFY(fetch.over());
    QVERIFY(fetch.tooLarge());
    QVERIFY(!fetch.complete());
    QVERIFY(dispatch.asked.size() <= 1);
    QVERIFY(fetch.map().regions().cellsOf(fetch.rect()));
  }
  void aDispatcherThatRestartsIsWaitedFor() {
    FakeDispatch dispatch;
    dispatch.by_itself = true;
    RegionFetch fetch(dispatch, {-100, -100, 100, 100}, {});
    fetch.start();
    QTRY_VERIFY(fetch.counts().answered > 0);
    dispatch.offers_regions = false;
    Q_EMIT dispatch.offersChanged();
    QTRY_VERIFY(dispatch.waiting.empty());
    QCoreApplication::processEvents();
    QVERIFY(!fetch.over());
    dispatch.offers_regions = true;
    Q_EMIT dispatch.offersChanged();
    QTRY_VERIFY(fetch.over());
    QVERIFY(fetch.complete());
  }
  void aDispatcherThatStaysAwayEndsIt() {
    FakeDispatch dispatch;
    dispatch.by_itself = true;
    RegionFetch fetch(dispatch, {-100, -100, 100, 100}, {.offer_within = Millis(1)});
    fetch.start();
    QTRY_VERIFY(fetch.counts().answered > 0);
    dispatch.offers_regions = false;
    Q_EMIT dispatch.offersChanged();
    QTRY_VERIFY(fetch.over());
    QVERIFY(!fetch.complete());
  }
  void aRobotThatGoesEndsIt() {
    auto dispatch = std::make_unique<FakeDispatch>();
    RegionFetch fetch(*dispatch, {-10, -10, 10, 10}, {});
    fetch.start();
    dispatch->answerOne();
    QVERIFY(!dispatch->waiting.empty());
    dispatch.reset();
    // Its requests never end: nothing may wait for them.
    QTRY_VERIFY(fetch.over());
    QVERIFY(!fetch.complete());
  }
};

}  // namespace test_region_fetch

MAPWRIGHT_TEST(test_region_fetch, TestRegionFetch, Core)
#include "test_region_fetch.moc"
