// When a shot stops waiting, and what it says is lacking.
#include <QTest>

#include "test_program.h"
#include "ui/shot/map_shot.h"

namespace test_map_shot {

using namespace mapwright::ui::shot;

class MapShotTest : public QObject {
  Q_OBJECT
 private:
  static EndOfWaiting endOf(const MapShot& shot, double now_s, bool online = true, bool drawable = true) {
    return shot.end(now_s, online, [drawable] { return drawable; });
  }
  static MapShot connectedAt(double at_s, ShotLimits limits) {
    MapShot shot(limits);
    shot.enter(Stage::Settling, at_s);
    return shot;
  }

 private Q_SLOTS:
  void itDrawsAsSoonAsAllThatItAwaitsIsHere() {
    MapShot shot = connectedAt(1, {.timeout_s = 60});
    bool submaps = false, topics = false;
    shot.await(Awaited::Submaps, [&] { return submaps; });
    shot.await(Awaited::Topics, [&] { return topics; });
    QCOMPARE(shot.missing(), std::optional(Awaited::Submaps));
    topics = true;
    QCOMPARE(endOf(shot, 2), EndOfWaiting::None);
    submaps = true;
    QCOMPARE(shot.missing(), std::optional<Awaited>());
    QCOMPARE(endOf(shot, 2), EndOfWaiting::AllHere);
  }

  void whatStandsBehindTheFirstMissingOneIsNotAskedFor() {
    MapShot shot = connectedAt(0, {});
    int asked = 0;
    bool map = false;
    shot.await(Awaited::WholeMap, [&] { return map; });
    shot.await(Awaited::Cloud, [&] { return ++asked > 0; });
    QCOMPARE(shot.missing(), std::optional(Awaited::WholeMap));
    QCOMPARE(asked, 0);
    map = true;
    QVERIFY(!shot.missing());
    QCOMPARE(asked, 1);
  }

  void beforeItIsConnectedNothingEndsTheWaiting() {
    MapShot shot(ShotLimits{.timeout_s = 10});
    QCOMPARE(endOf(shot, 11), EndOfWaiting::None);
    QVERIFY(shot.timeUp(11) && !shot.connected());
    shot.enter(Stage::Reading, 11);
    QCOMPARE(endOf(shot, 12), EndOfWaiting::None);
    shot.enter(Stage::Settling, 13);
    QVERIFY(shot.connected());
    QCOMPARE(shot.sinceConnected(15), 2.0);
  }

  void whenTheTimeIsUpItDrawsWhatThereIs() {
    MapShot shot = connectedAt(1, {.timeout_s = 10, .grace_s = 0.5});
    shot.await(Awaited::Submaps, [] { return false; });
    QCOMPARE(endOf(shot, 9.9), EndOfWaiting::None);
    QCOMPARE(endOf(shot, 10), EndOfWaiting::TimeUp);
    shot.enter(Stage::Drawing, 10);
    QVERIFY(!shot.cutOff(10.4));
    QVERIFY(shot.cutOff(10.5));
  }

  void withoutALimitItWaitsAsLongAsItTakes() {
    MapShot shot = connectedAt(1, {});
    shot.await(Awaited::Messages, [] { return false; });
    QCOMPARE(endOf(shot, 1e6, false), EndOfWaiting::None);
    QVERIFY(!shot.cutOff(1e6));
    QVERIFY(!shot.untilLimit(5));
  }

  void collectingEndsAfterItsTimeAndNotBefore() {
    MapShot shot = connectedAt(2, {.timeout_s = 60, .collect_s = 5});
    QCOMPARE(endOf(shot, 6.9), EndOfWaiting::None);  // though nothing is awaited
    QCOMPARE(endOf(shot, 6.9, false), EndOfWaiting::None);
    QCOMPARE(endOf(shot, 7), EndOfWaiting::Collected);
  }

  void aLostRobotIsWaitedForUntilThereIsJustTimeToDraw() {
    MapShot shot = connectedAt(1, {.timeout_s = 20});
    shot.await(Awaited::Submaps, [] { return false; });
    QCOMPARE(endOf(shot, 15.9, false), EndOfWaiting::None);
    QCOMPARE(endOf(shot, 16.1, false), EndOfWaiting::LinkLost);
    QCOMPARE(endOf(shot, 16.1, true), EndOfWaiting::None);
    QCOMPARE(endOf(shot, 16.1, false, false), EndOfWaiting::None);  // there is nothing to draw
  }

  void theNextLimitIsKnown() {
    MapShot shot(ShotLimits{.timeout_s = 10, .collect_s = 3, .grace_s = 1});
    QCOMPARE(shot.untilLimit(4), std::optional(6.0));
    shot.enter(Stage::Settling, 4);
    QCOMPARE(shot.untilLimit(4), std::optional(3.0));
    shot.enter(Stage::Drawing, 8);
    QCOMPARE(shot.untilLimit(10.5), std::optional(0.5));
    QVERIFY(!shot.untilLimit(11));
  }

  void whatEndedStaysAsItEnded() {
    MapShot shot = connectedAt(1, {.timeout_s = 10});
    shot.enter(Stage::Failed, 2);
    shot.enter(Stage::Drawing, 3);
    QCOMPARE(shot.stage(), Stage::Failed);
    QVERIFY(shot.over() && !shot.waits());
    QCOMPARE(shot.enteredAt(Stage::Drawing), std::optional<double>());
  }

  void itIsCompleteOnceItIsDrawnAndLacksNothing() {
    MapShot shot = connectedAt(1, {});
    QVERIFY(!shot.complete());
    shot.enter(Stage::Drawing, 2);
    QVERIFY(shot.complete());
    shot.addIf(false, Lack::Overlays);
    QVERIFY(shot.complete());
    shot.addIf(true, Lack::Waypoints);
    shot.enter(Stage::Done, 3);
    QVERIFY(!shot.complete());
    QCOMPARE(shot.lacks(), std::set<Lack>{Lack::Waypoints});
  }
};

}  // namespace test_map_shot

MAPWRIGHT_TEST(test_map_shot, MapShotTest, Core)
#include "test_map_shot.moc"
