// The world of a bag at a time is the same whichever way one came there.
#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QTest>
#include <QTimer>

#include "generated_bag.h"
#include "replay/events.h"
#include "replay/reading.h"
#include "test_program.h"

namespace test_replay_world {

using namespace mapwright;
using namespace mapwright::replay;

namespace {

constexpr qint64 kLongMs = 60'000;

/// As the window would: wants a time and waits until the world of it is exact.
class Player {
 public:
  explicit Player(BagRobot& robot, Reading::Options options = {}) : reading(robot, {}, std::move(options)) {
    bool opened = false;
    QObject::connect(&reading, &Reading::opened, &reading, [&] { opened = true; });
    reading.open();
    waitFor([&] { return opened; });
  }

  template <typename Condition>
  static bool waitFor(Condition condition) {
    // With a limit of its own processEvents() does not wait: what is waited for would have to share its core.
    QTimer look;
    look.start(50);
    const QDeadlineTimer deadline(kLongMs);
    while (!condition()) {
      if (deadline.hasExpired()) return false;
      QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    }
    return true;
  }

  Moment exactly(double at_s) {
    reading.want(at_s);
    Moment moment;
    bool changed = true;
    QObject context;
    QObject::connect(&reading, &Reading::changed, &context, [&] { changed = true; });
    waitFor([&] {
      // While much is missing there is no need to look each time.
      if (!std::exchange(changed, false)) return false;
      if (!reading.chunks().settledUntil(at_s)) return false;
      moment = reading.moment();
      return moment.knowledge == Knowledge::Exact;
    });
    return moment;
  }

  Reading reading;
};

/// What differs, for a message that helps.
std::string differences(const map::World& a, const map::World& b) {
  std::string found;
  const auto compare = [&](const char* name, bool same) {
    if (!same) found.append(name).append(" ");
  };
  compare("at", a.at_s == b.at_s);
  compare("submaps", a.submaps == b.submaps);
  compare("uuid", a.live.session_uuid == b.live.session_uuid);
  compare("pose", a.live.robot_pose == b.live.robot_pose);
  compare("trail", a.live.trail == b.live.trail);
  compare("model", a.live.model == b.live.model);
  compare("slam", a.live.slam == b.live.slam);
  compare("grids", a.live.grids == b.live.grids);
  compare("path", a.live.path == b.live.path);
  compare("planning", a.live.planning == b.live.planning);
  compare("map_info", a.live.map_info == b.live.map_info);
  compare("alerts", a.live.alerts == b.live.alerts);
  compare("battery", a.live.battery == b.live.battery);
  compare("wheels", a.live.wheels == b.live.wheels);
  compare("footprints", a.live.nearby_footprints == b.live.nearby_footprints);
  compare("landmarks", a.live.landmarks == b.live.landmarks);
  compare("constraints", a.live.constraints == b.live.constraints);
  compare("positioning", a.live.global_positioning == b.live.global_positioning);
  compare("barcode", a.live.barcode == b.live.barcode);
  compare("safety", a.live.safety == b.live.safety);
  return found;
}

}  // namespace

class ReplayWorldTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aSeekMakesTheWorldThatPlayingMakes_data() {
    QTest::addColumn<bool>("jumps_back");
    QTest::addColumn<bool>("duplicate_stamps");
    QTest::addColumn<bool>("end_inclusive");
    QTest::addColumn<bool>("repeats");
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 6; ++seed) {
      QTest::addRow("seed %u", seed) << bool(seed & 1) << bool(seed & 2) << (seed > 3) << (seed % 3 == 0)
                                     << seed;
    }
  }
  void aSeekMakesTheWorldThatPlayingMakes() {
    QFETCH(bool, jumps_back);
    QFETCH(bool, duplicate_stamps);
    QFETCH(bool, end_inclusive);
    QFETCH(bool, repeats);
    QFETCH(unsigned, seed);
    BagWish wish;
    wish.messages = 3000;
    wish.jumps_back = jumps_back;
    wish.duplicate_stamps = duplicate_stamps;
    wish.seed = seed;
    const Bag bag = makeBag(wish);
    BagRobot robot(bag);
    robot.end_inclusive = end_inclusive;
    robot.repeats_at_borders = repeats;
    Reading::Options options;
    options.chunks.messages_per_cell = 100;
    options.chunks.held_bytes = 300'000;  // little is held: most is asked for again
    Player player(robot, options);
    // Far and near, forwards and backwards, at a message, right before one and between them, once more where
    // it was, and beyond both ends.
    std::mt19937 random(seed);
    std::vector<double> times;
    for (int i = 0; i < 9; ++i) {
      const Recorded& near = bag[random() % bag.size()];
      times.push_back(near.stamp_s + (i % 3 == 0 ? 0 : i % 3 == 1 ? -0.0005 : double(random() % 20)));
    }
    times.push_back(times[random() % 8]);
    times.push_back(bag.back().stamp_s + 1000);
    times.push_back(times.front() + 0.3);
    times.push_back(wish.start_s - 100);
    const std::vector<map::World> expected = foldedAt(bag, times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const Moment moment = player.exactly(times[i]);
      QCOMPARE(int(moment.knowledge), int(Knowledge::Exact));
      QVERIFY2(moment.at.world == expected[i],
               (std::to_string(i) + ": " + differences(moment.at.world, expected[i])).c_str());
      QVERIFY(moment.topics == topicsUntil(bag, times[i]));
    }
    QVERIFY(robot.most_at_once <= 2);
  }

  void noMessageIsLostOrDoubled_data() {
    QTest::addColumn<bool>("end_inclusive");
    QTest::addColumn<bool>("repeats");
    QTest::newRow("the end of a range is not counted in") << false << false;
    QTest::newRow("the end of a range is counted in") << true << false;
    QTest::newRow("what is back-filled is told twice") << true << true;
  }
  void noMessageIsLostOrDoubled() {
    QFETCH(bool, end_inclusive);
    QFETCH(bool, repeats);
    BagWish wish;
    wish.jumps_back = true;
    wish.duplicate_stamps = true;
    Bag bag = makeBag(wish);
    // Exactly at the borders of ranges.
    for (std::size_t i = 0; i < bag.size(); i += 7) bag[i].stamp_s = std::floor(bag[i].stamp_s);
    BagRobot robot(bag);
    robot.end_inclusive = end_inclusive;
    robot.repeats_at_borders = repeats;
    Reading::Options options;
    options.chunks.messages_per_cell = 20;
    Player player(robot, options);
    player.reading.setWhole(true);
    player.reading.want(wish.start_s);
    QVERIFY(Player::waitFor([&] { return player.reading.chunks().wholeRead(); }));
    QCOMPARE(player.reading.chunks().messagesRead(), bag.size());
  }

  void messagesBeyondTheToldTimesAreFound() {
    Bag bag = makeBag({});
    // An hour later than the rest, and a day before.
    bag.front().stamp_s -= 86'400;
    Recorded late = bag.back();
    late.stamp_s += 3600;
    bag.insert(bag.end() - 1, late);
    BagRobot robot(bag);
    Player player(robot);
    const Moment moment = player.exactly(late.stamp_s + 1);
    QVERIFY(moment.at.world == foldedUntil(bag, late.stamp_s + 1));
    QCOMPARE(player.reading.chunks().messagesRead(), bag.size());
  }

  void aRobotThatIsOnlyBusyLosesNothingBeyondTheToldTimes() {
    Bag bag = makeBag({});
    bag.front().stamp_s -= 86'400;
    for (const int failures : {1, 2}) {
      BagRobot robot(bag);
      robot.busy_code = "503";
      robot.fail_next = failures;
      Reading::Options options;
      options.chunks.first_retry_ms = 1;
      options.chunks.last_retry_ms = 5;
      Player player(robot, options);
      const double at_s = bag.front().stamp_s + 1;
      QVERIFY(player.exactly(at_s).at.world == foldedUntil(bag, at_s));
      QVERIFY(player.reading.chunks().messagesRead() > 0);
    }
  }

  void aRobotThatRefusesOtherTimesHasNothingThere() {
    const Bag bag = makeBag({});
    BagRobot robot(bag);
    robot.refuses_beyond = true;
    Player player(robot);
    const double end_s = bag.back().stamp_s + 100;
    QVERIFY(player.exactly(end_s).at.world == foldedUntil(bag, end_s));
  }

  void answersThatAreTooLongAreAskedForInParts() {
    const Bag bag = makeBag({});
    BagRobot robot(bag);
    robot.most_messages = 60;
    Player player(robot);
    const double at_s = bag.back().stamp_s;
    QVERIFY(player.exactly(at_s).at.world == foldedUntil(bag, at_s));
  }

  void bagsOfOneMessageAndOfNone() {
    BagWish wish;
    wish.messages = 1;
    const Bag one = makeBag(wish);
    BagRobot robot(one);
    Player player(robot);
    QVERIFY(player.exactly(one.front().stamp_s).at.world == foldedUntil(one, one.front().stamp_s));
    QVERIFY(player.exactly(one.front().stamp_s - 0.001).at.world == map::World());

    BagRobot empty({});
    Player nothing(empty);
    const Moment moment = nothing.exactly(100);
    QCOMPARE(int(moment.knowledge), int(Knowledge::Exact));
    QVERIFY(moment.at.world == map::World());
    QVERIFY(moment.topics.empty());
    QCOMPARE(empty.asked, 0);
  }

  void aJumpShowsAtOnceWhatIsNearAndSaysThatItLooksBack() {
    BagWish wish;
    wish.messages = 4000;
    const Bag bag = makeBag(wish);
    BagRobot robot(bag);
    robot.holds_back = true;
    robot.answers_first = 1;
    Reading::Options options;
    options.chunks.messages_per_cell = 100;
    Player player(robot, options);
    const double at_s = bag.back().stamp_s;
    player.reading.want(at_s);
    QCOMPARE(int(player.reading.moment().knowledge), int(Knowledge::Buffering));
    Moment moment;
    QVERIFY(Player::waitFor([&] {
      moment = player.reading.moment();
      return moment.knowledge != Knowledge::Buffering;
    }));
    QCOMPARE(int(moment.knowledge), int(Knowledge::LookingBack));
    // What is latched is there from the start.
    QVERIFY(moment.at.world.live.map_info.has_value());
    QVERIFY(!moment.at.world.live.model.footprint.empty());
    robot.release();
    QVERIFY(player.exactly(at_s).at.world == foldedUntil(bag, at_s));
  }

  void theLastWantedTimeWins() {
    BagWish wish;
    wish.messages = 4000;
    const Bag bag = makeBag(wish);
    BagRobot robot(bag);
    robot.holds_back = true;
    Reading::Options options;
    options.chunks.messages_per_cell = 100;
    Player player(robot, options);
    player.reading.want(bag[3500].stamp_s);
    player.reading.want(bag[1800].stamp_s);
    player.reading.want(bag[100].stamp_s);
    const Cell* here = player.reading.chunks().cellAt(bag[100].stamp_s);
    QVERIFY(here->in_progress);
    QVERIFY(robot.cancelled >= 2);
    robot.release();
    QVERIFY(player.exactly(bag[100].stamp_s).at.world == foldedUntil(bag, bag[100].stamp_s));
  }

  void aRangeThatFailsIsAGapAndIsAskedForAgain() {
    const Bag bag = makeBag({});
    BagRobot robot(bag);
    robot.fail_next = 5;
    Reading::Options options;
    options.chunks.first_retry_ms = 1;
    options.chunks.last_retry_ms = 5;
    Player player(robot, options);
    const double at_s = bag.back().stamp_s;
    std::optional<map::Failure> gap;
    connect(&player.reading, &Reading::changed, &player.reading, [&] {
      if (const Cell* cell = player.reading.chunks().gapUntil(at_s)) gap = cell->failure;
    });
    player.reading.want(at_s);
    QVERIFY(Player::waitFor([&] { return gap.has_value(); }));
    QCOMPARE(int(gap->kind), int(map::FailureKind::TimedOut));
    QVERIFY(player.exactly(at_s).at.world == foldedUntil(bag, at_s));
  }

  void aRefusedRangeIsDividedUntilOnlyTheDamageIsMissing_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<int>("damages");
    for (const char* code : {"400", "500"}) {
      for (const int damages : {1, 3})
        QTest::addRow("%s, %d", code, damages) << QString::fromLatin1(code) << damages;
    }
  }
  /// Read in one pass, as a whole, and by jumps: all that no damaged second holds comes once.
  void aRefusedRangeIsDividedUntilOnlyTheDamageIsMissing() {
    QFETCH(QString, code);
    QFETCH(int, damages);
    BagWish wish;
    wish.messages = 3000;
    const Bag bag = makeBag(wish);
    std::mt19937 random(unsigned(damages) + 7);
    BagRobot robot(bag);
    robot.damaged_code = code.toStdString();
    for (int i = 0; i < damages; ++i) robot.damaged_s.push_back(bag[200 + random() % 2600].stamp_s);
    Reading::Options options;
    options.chunks.first_retry_ms = 1;
    options.chunks.last_retry_ms = 2;
    options.chunks.messages_per_cell = 1000;
    Player player(robot, options);
    player.reading.want(1e300);
    QVERIFY(Player::waitFor([&] { return player.reading.chunks().wholeSettled(); }));
    QVERIFY(!player.reading.chunks().obstacleUntil(1e300));
    const auto holes = player.reading.chunks().holes(-1e300, 1e300);
    QVERIFY(!holes.empty() && int(holes.size()) <= damages);
    double lost_s = 0;
    std::size_t left = bag.size();
    for (const Hole& hole : holes) {
      lost_s += hole.until_s - hole.from_s;
      for (const Recorded& each : bag) left -= each.stamp_s >= hole.from_s && each.stamp_s < hole.until_s;
    }
    QVERIFY(lost_s <= damages);
    QVERIFY(std::all_of(robot.damaged_s.begin(), robot.damaged_s.end(), [&](double s) {
      return std::any_of(holes.begin(), holes.end(),
                         [&](const Hole& hole) { return hole.from_s <= s && s < hole.until_s; });
    }));
    QCOMPARE(player.reading.chunks().messagesRead(), left);
    QVERIFY(robot.asked < 40 + 60 * damages);

    // A pass ends by itself and gives the same messages.
    Reading::Options once = options;
    once.chunks.look_back = false;
    Player passing(robot, once);
    RangeWalk walk(passing.reading, std::nullopt, std::nullopt);
    std::size_t passed = 0;
    QVERIFY(Player::waitFor([&] {
      while (const ChunkPtr chunk = walk.next()) passed += chunk->order.size();
      return walk.over();
    }));
    QCOMPARE(passed, left);
    QVERIFY(passing.reading.chunks().holes(-1e300, 1e300) == holes);

    // What came last before and after a hole is known there.
    Player jumping(robot, options);
    const double after_s = holes.front().until_s + 0.5;
    QCOMPARE(int(jumping.exactly(after_s).knowledge), int(Knowledge::Exact));
    Bag sound;
    for (const Recorded& each : bag) {
      const bool lost = std::any_of(holes.begin(), holes.end(), [&](const Hole& hole) {
        return each.stamp_s >= hole.from_s && each.stamp_s < hole.until_s;
      });
      if (!lost) sound.push_back(each);
    }
    const map::World known = jumping.exactly(holes.front().from_s - 0.001).at.world;
    QVERIFY(known == foldedUntil(bag, holes.front().from_s - 0.001));
    QVERIFY(jumping.exactly(after_s).at.world.live.robot_pose == foldedUntil(sound, after_s).live.robot_pose);
  }

  /// Of a bag of which nothing can be read few ranges are asked for.
  void aBagThatIsRefusedAltogetherEndsSoon() {
    const Bag bag = makeBag({});
    for (const char* code : {"400", "404"}) {
      BagRobot robot(bag);
      robot.damaged_code = code;
      for (const Recorded& each : bag) robot.damaged_s.push_back(each.stamp_s);
      Reading::Options options;
      options.chunks.first_retry_ms = 1;
      Player player(robot, options);
      player.reading.want(1e300);
      const Cell* obstacle = nullptr;
      QVERIFY(Player::waitFor([&] {
        obstacle = player.reading.chunks().obstacleUntil(1e300);
        return obstacle && isFinal(*obstacle);
      }));
      QCOMPARE(obstacle->failure.robot_code, std::string(code));
      QVERIFY2(robot.asked < 400, std::to_string(robot.asked).c_str());
    }
  }

  void theRefusedPartsAreNamed() {
    const map::Failure refused{
        .kind = map::FailureKind::RejectedByRobot, .robot_code = "400", .detail = "Broken."};
    const std::string words = inEnglish(faultOf({{1'717'405'200, 1'717'405'201, refused}}));
    for (const char* part : {"2024-06-03 09:00:00.000", "09:00:01.000 UTC", "Broken"})
      QVERIFY2(words.find(part) != std::string::npos, words.c_str());
  }

  void whatHappenedIsToldInOrder() {
    using namespace map;
    Bag bag;
    const auto add = [&](double s, const char* topic, TopicMessage message) {
      bag.push_back({1000 + s, topic, std::move(message), false, true, {}});
    };
    SlamStatus good, lost;
    good.position_quality = 10;
    lost.position_quality = 1;
    PlanningState idle, moving;
    idle.move_state = "idle";
    moving.move_state = "moving";
    MapInfo first, second;
    first.uid = "a";
    second.uid = "b";
    second.name = "cellar";
    add(0, "/map/info", first);
    add(1, "/tracked_pose", TrackedPose{{0, 0, 0}});
    add(2, "/planning_state", idle);
    add(3, "/alerts", AlertsMessage{{{6004, AlertLevel::Error, "hot", 0}}});
    add(3.5, "/slam/state", good);
    add(4, "/planning_state", moving);
    add(5, "/tracked_pose", TrackedPose{{30, 0, 0}});
    add(6, "/slam/state", lost);
    add(7, "/alerts", AlertsMessage{});
    add(8, "/slam/state", good);
    add(9, "/map/info", second);
    add(10, "/tracked_pose", TrackedPose{{90, 0, 0}});  // on another map: no jump
    BagRobot robot(bag);
    Player player(robot);
    player.reading.setWhole(true);
    player.reading.want(1000);
    QVERIFY(Player::waitFor([&] { return player.reading.chunks().wholeRead(); }));
    std::vector<std::pair<double, EventKind>> told;
    for (const Event& event : eventsOf(player.reading.index().digests()))
      told.emplace_back(event.at_s - 1000, event.kind);
    const std::vector<std::pair<double, EventKind>> expected{
        {3, EventKind::AlertBegan}, {4, EventKind::MoveState},  {5, EventKind::PositionJump},
        {6, EventKind::QualityLow}, {7, EventKind::AlertEnded}, {8, EventKind::QualityGood},
        {9, EventKind::MapChanged}};
    QVERIFY(told == expected);
  }
};

}  // namespace test_replay_world

MAPWRIGHT_TEST(test_replay_world, ReplayWorldTest, Core)
#include "test_replay_world.moc"
