// Asking a dispatcher for regions, and for one rectangle.
#include <QtTest>

#include "../patience.h"
#include "fake_dispatch.h"
#include "regions/region_fetch.h"

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

QTEST_GUILESS_MAIN(TestRegionFetch)
#include "test_region_fetch.moc"
