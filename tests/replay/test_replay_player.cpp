// The time that is looked at while a bag is played, and what is only for the eye.
#include <cmath>

#include <QTest>

#include "replay/player.h"
#include "replay/world_at.h"
#include "test_program.h"

namespace test_replay_player {

using namespace mapwright;
using namespace mapwright::replay;

namespace {

/// Poses at whole and half seconds, 1 m/s along x.
PrefixIndex straight(double jump_at_s = 1e9) {
  Digest digest;
  digest.from_s = 0;
  digest.until_s = 100;
  for (std::uint32_t i = 0; i < 40; ++i) {
    const double s = 10 + i * 0.5;
    digest.poses.push_back({s, i, {s + (s >= jump_at_s ? 50 : 0), 0, i % 2 ? 3.1 : -3.1}});
  }
  PrefixIndex index;
  index.add(0, digest);
  return index;
}

}  // namespace

class ReplayPlayerTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void itPlaysAtItsSpeedAndStopsAtTheEnd() {
    Player player(100, 110);
    QCOMPARE(player.at(5000), 100.0);
    player.play(5000);
    QCOMPARE(player.at(7000), 102.0);
    player.setSpeed(4, 7000);
    QCOMPARE(player.at(8000), 106.0);
    QVERIFY(player.playing(8000));
    QCOMPARE(player.at(20'000), 110.0);
    QVERIFY(!player.playing(20'000));
    player.play(20'000);  // anew
    QCOMPARE(player.at(20'500), 102.0);
  }

  void speedsStayWithinTheirBounds() {
    Player player(0, 1000);
    player.setSpeed(1000, 0);
    QCOMPARE(player.speed(), 20.0);
    player.setSpeed(-0.01, 0);
    QCOMPARE(player.speed(), -0.1);
    player.setSpeed(std::nan(""), 0);
    QCOMPARE(player.speed(), -0.1);
  }

  void itPlaysBackwardsToTheStart() {
    Player player(100, 110);
    player.seek(108, 0);
    player.setSpeed(-2, 0);
    player.play(0);
    QCOMPARE(player.at(1000), 106.0);
    QCOMPARE(player.at(60'000), 100.0);
    QVERIFY(!player.playing(60'000));
  }

  void aRangeIsPlayedAgainAndAgain() {
    Player player(100, 200);
    player.setLoop(Player::Loop{120, 130}, 0);
    player.play(0);
    QCOMPARE(player.at(0), 120.0);
    QCOMPARE(player.at(9'000), 129.0);
    QCOMPARE(player.at(12'000), 122.0);
    QVERIFY(player.playing(100'000));
    player.setSpeed(-1, 12'000);
    QCOMPARE(player.at(15'000), 129.0);
    player.setLoop(Player::Loop{130, 130}, 15'000);
    QVERIFY(!player.loop());
  }

  void itStandsStillWhileSomethingIsMissing() {
    Player player(0, 100);
    player.play(0);
    player.setWaiting(true, 2000);
    QCOMPARE(player.at(9000), 2.0);
    QVERIFY(player.playing(9000));
    player.setWaiting(false, 9000);
    QCOMPARE(player.at(10'000), 3.0);
  }

  void stepsAndSeeksStayWithinTheBag() {
    Player player(0, 100);
    player.play(0);
    player.step(0.1, 5000);
    QCOMPARE(player.at(9000), 5.1);
    player.step(-50, 9000);
    QCOMPARE(player.at(9000), 0.0);
    player.seek(1e12, 9000);
    QCOMPARE(player.at(9000), 100.0);
    player.seek(std::nan(""), 9000);
    QCOMPARE(player.at(9000), 100.0);
  }

  void itStopsWhereItWasToldTo() {
    Player player(0, 100);
    player.playUntil(3, 0);
    QCOMPARE(player.at(2000), 2.0);
    QCOMPARE(player.at(9000), 3.0);
    QVERIFY(!player.playing(9000));
  }

  void posesAreInterpolatedTheShorterWayRound() {
    const PrefixIndex index = straight();
    const auto pose = poseBetween(index, 10.25);
    QVERIFY(pose);
    QCOMPARE(pose->x_m, 10.25);
    QVERIFY(std::abs(pose->yaw_rad) > 3.1);  // over the back, not through zero
    QCOMPARE(poseBetween(index, 10.5)->x_m, 10.5);
    QVERIFY(!poseBetween(index, 9.9));
  }

  void posesAreNotInterpolatedAcrossAJumpOrAGap() {
    const PrefixIndex index = straight(15);
    QCOMPARE(poseBetween(index, 14.75)->x_m, 14.5);
    QCOMPARE(poseBetween(index, 15)->x_m, 65.0);
    QCOMPARE(poseBetween(index, 60)->x_m, 29.5 + 50);  // after the last
  }

  void posesAreNotInterpolatedIntoAnotherMap() {
    PrefixIndex index = straight();
    Digest digest = index.digests().begin()->second;
    map::MapInfo info;
    info.uid = "b";
    digest.history.push_back({10.2, 1, info});
    index.add(0, digest);
    QCOMPARE(poseBetween(index, 10.25)->x_m, 10.0);
    QCOMPARE(poseBetween(index, 10.75)->x_m, 10.75);
  }
};

}  // namespace test_replay_player

MAPWRIGHT_TEST(test_replay_player, ReplayPlayerTest, Nothing)
#include "test_replay_player.moc"
