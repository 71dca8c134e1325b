// A bag as a robot: what is told on the way and what jumps make, put together, is the world of the time.
#include <random>

#include <QCoreApplication>
#include <QTest>

#include "generated_bag.h"
#include "replay/replay_robot.h"
#include "test_program.h"

namespace test_replay_robot {

using namespace mapwright;
using namespace mapwright::replay;

namespace {

constexpr int kLongMs = 30'000;

/// That of a robot which nobody is connected to.
class Silent : public robot::LiveTopics {
 public:
  QStringList known() const override { return {}; }
  QStringList topicsOf(map::Stream) const override { return {}; }
  void setWanted(const map::Streams&, const QStringList&) override {}
  void setWatching(bool) override {}
  void setTap(robot::FrameTap) override {}
};

/// The robot that a bag came from.
class Origin : public robot::Robot {
 public:
  explicit Origin(Bag bag) : bags(std::move(bag)) {}
  QString address() const override { return QStringLiteral("origin"); }
  void connectToRobot() override { connected = true; }
  void disconnectFromRobot() override {}
  robot::ConnectionState connection() const override { return {}; }
  robot::RobotIdentity identity() const override { return {}; }
  robot::BagLibrary* bagLibrary() override { return &bags; }
  robot::LiveTopics* liveTopics() override { return &topics; }

  BagRobot bags;
  Silent topics;
  bool connected = false;
};

/// Whoever shows it: keeps a world as a session does.
struct Viewer {
  explicit Viewer(Bag bag, ChunksOptions chunks = {}) {
    auto origin = std::make_unique<Origin>(std::move(bag));
    source = origin.get();
    Reading::Options options;
    options.chunks = chunks;
    robot = std::make_unique<ReplayRobot>(std::move(origin), "a.bag", options);
    QObject::connect(robot.get(), &ReplayRobot::jumped, robot.get(),
                     [this](const map::World& now, Knowledge) {
                       world = now;
                       ++jumps;
                     });
    QObject::connect(robot.get(), &robot::Robot::topicReceived, robot.get(),
                     [this](const map::StampedMessage& message) {
                       world = map::reduce(std::move(world), message);
                       ++messages;
                     });
  }
  bool waitFor(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, kLongMs); }
  bool open() {
    robot->connectToRobot();
    return waitFor([&] { return robot->connection().phase == robot::ConnectionPhase::Online; });
  }
  bool goTo(double at_s) {
    robot->goTo(at_s);
    return waitFor([&] { return robot->knowledge() == Knowledge::Exact; });
  }

  Origin* source = nullptr;
  std::unique_ptr<ReplayRobot> robot;
  map::World world;
  int jumps = 0, messages = 0;
};

}  // namespace

class ReplayRobotTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void playingOnAndJumpingMakeTheSameWorld() {
    BagWish wish;
    wish.jumps_back = true;
    const Bag bag = makeBag(wish);
    ChunksOptions chunks;
    chunks.messages_per_cell = 100;
    Viewer viewer(bag, chunks);
    QVERIFY(viewer.open());
    QVERIFY(!viewer.source->connected);  // it is only asked for its bag
    std::mt19937 random(3);
    double at_s = wish.start_s;
    for (int i = 0; i < 60; ++i) {
      at_s = i % 6 == 0 ? bag[random() % bag.size()].stamp_s : at_s + double(random() % 100) / 20;
      QVERIFY(viewer.goTo(at_s));
      QVERIFY(viewer.world == foldedUntil(bag, at_s));
      QVERIFY(viewer.robot->topics() == topicsUntil(bag, at_s));
    }
    QVERIFY(viewer.messages > 100);
    QVERIFY(viewer.jumps >= 10);
  }

  void picturesThatAreOnlyNamedAreFetched() {
    map::GridMessage named;
    named.kind = map::GridKind::WholeMap;
    named.topic = "/map";
    map::GridMessage lost = named;
    lost.kind = map::GridKind::CostmapLow;
    lost.topic = "/map/costmap_v2";
    Bag bag;
    bag.push_back({1000, "/map", named, false, true, "first"});
    bag.push_back({1001, "/map/costmap_v2", lost, false, true, "gone"});
    bag.push_back({1005, "/map", named, false, true, "second"});
    bag.push_back({1009, "/tracked_pose", map::TrackedPose{{1, 2, 3}}, false, true, {}});
    Viewer viewer(bag);
    std::vector<map::Problem> problems;
    connect(viewer.robot.get(), &robot::Robot::problemFound, viewer.robot.get(),
            [&](const map::Problem& problem) { problems.push_back(problem); });
    QVERIFY(viewer.open());
    QVERIFY(viewer.goTo(1002));
    QVERIFY(viewer.waitFor([&] { return viewer.robot->picturesUnderWay() == 0; }));
    const auto shown = [&] {
      const auto grid = viewer.world.live.grids.find(map::GridKind::WholeMap);
      return grid == viewer.world.live.grids.end() ? std::string() : *grid->second.png;
    };
    QCOMPARE(shown(), std::string("picture at first"));
    QVERIFY(!problems.empty());  // told again when the look back is over
    QCOMPARE(problems.front().subject.id, std::string("/map/costmap_v2"));
    QVERIFY(!viewer.world.live.grids.contains(map::GridKind::CostmapLow));
    QVERIFY(viewer.goTo(1006));
    QVERIFY(viewer.waitFor([&] { return shown() == "picture at second"; }));
  }

  void whoWantsTheSameAgainIsNotToldAgain() {
    const Bag bag = makeBag({});
    Viewer viewer(bag);
    QVERIFY(viewer.open());
    QVERIFY(viewer.goTo(bag[1000].stamp_s));
    const map::Streams streams{map::Stream::Path};
    // As a session does with every world that it gets.
    connect(viewer.robot.get(), &ReplayRobot::jumped, viewer.robot.get(),
            [&] { viewer.robot->liveTopics()->setWanted(streams, {}); });
    const int before = viewer.jumps;
    viewer.robot->liveTopics()->setWanted(streams, {});
    QVERIFY(viewer.waitFor([&] { return viewer.jumps > before; }));
    for (int turns = 0; turns < 20; ++turns) QCoreApplication::processEvents();
    QCOMPARE(viewer.jumps, before + 1);
    viewer.robot->liveTopics()->setWanted({map::Stream::Path, map::Stream::Cloud}, {});
    QVERIFY(viewer.waitFor([&] { return viewer.jumps == before + 2; }));
  }

  void whoAsksAnewForTheSameIsNotToldAgain() {
    const Bag bag = makeBag({});
    Viewer viewer(bag);
    QVERIFY(viewer.open());
    QVERIFY(viewer.goTo(bag[1000].stamp_s));
    robot::LiveTopics& live = *viewer.robot->liveTopics();
    const map::Streams streams{map::Stream::Path};
    const QStringList topics{QStringLiteral("/a"), QStringLiteral("/b")};
    const auto turn = [] {
      for (int turns = 0; turns < 20; ++turns) QCoreApplication::processEvents();
    };
    live.setWanted(streams, topics);
    turn();
    const int before = viewer.jumps;
    // None of it and all of it again, as for a new frame; at every jump, too.
    connect(viewer.robot.get(), &ReplayRobot::jumped, viewer.robot.get(), [&] {
      live.setWanted({}, {});
      live.setWanted(streams, topics);
    });
    live.setWanted({}, {});
    live.setWanted(streams, topics);
    turn();
    QCOMPARE(viewer.jumps, before);
    live.setWanted(streams, {topics.back(), topics.front()});  // in another order
    live.setWanted(streams, {topics.front()});                 // less
    turn();
    QCOMPARE(viewer.jumps, before);
    live.setWanted(streams, topics);
    QVERIFY(viewer.waitFor([&] { return viewer.jumps > before; }));
    turn();
    QCOMPARE(viewer.jumps, before + 1);
  }

  void whileItLooksBackItShowsWhatItKnows() {
    const Bag bag = makeBag({});
    ChunksOptions chunks;
    chunks.messages_per_cell = 50;
    Viewer viewer(bag, chunks);
    QVERIFY(viewer.open());
    std::vector<Knowledge> told;
    connect(viewer.robot.get(), &ReplayRobot::jumped, viewer.robot.get(),
            [&](const map::World&, Knowledge knowledge) { told.push_back(knowledge); });
    QVERIFY(viewer.goTo(bag.back().stamp_s));
    QVERIFY(told.size() >= 2);
    QCOMPARE(int(told.front()), int(Knowledge::LookingBack));
    QCOMPARE(int(told.back()), int(Knowledge::Exact));
  }
};

}  // namespace test_replay_robot

MAPWRIGHT_TEST(test_replay_robot, ReplayRobotTest, Core)
#include "test_replay_robot.moc"
