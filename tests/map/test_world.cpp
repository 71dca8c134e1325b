// The world as a value: what it is made of, when two are equal, and that nothing but the messages makes it.
#include <random>

#include <QTest>

#include "map/world.h"
#include "test_program.h"

namespace test_world {

using namespace mapwright::map;

namespace {

StampedMessage at(double s, TopicMessage message) { return {std::move(message), s, std::nullopt}; }

TopicMessage cloud(double x_m) {
  return PointCloudMessage{
      "/points", std::make_shared<const std::vector<CloudPoint>>(std::vector{CloudPoint{x_m, 0, 0, 0}})};
}

TopicMessage picture(const char* bytes) {
  GridMessage grid;
  grid.topic = "/map";
  grid.png = std::make_shared<const std::string>(bytes);
  return grid;
}

TopicMessage submaps(const char* uuid, int version) {
  SubmapList list;
  list.uuid = uuid;
  list.entries.push_back({{0, 1}, version, {}, false, false, false});
  return list;
}

/// Half a minute of everything that depends on what was before.
std::vector<StampedMessage> recording() {
  std::vector<StampedMessage> messages;
  std::mt19937 random(7);
  double x_m = 0;
  for (int i = 0; i < 300; ++i) {
    const double s = 1000 + i * 0.1;
    x_m += double(random() % 100) / 1000;
    messages.push_back(at(s, TrackedPose{{x_m, 1, 0}}));
    if (i % 10 == 0) messages.push_back(at(s, cloud(x_m)));
    if (i % 50 == 0) messages.push_back(at(s, submaps(i < 200 ? "a" : "b", i)));
    if (i % 70 == 0)
      messages.push_back(
          at(s, AlertsMessage{i % 140 ? std::vector<Alert>{}
                                      : std::vector<Alert>{{6004, AlertLevel::Error, "hot", 0}}}));
    if (i % 90 == 0) messages.push_back(at(s, picture(i % 180 ? "x" : "y")));
    if (i % 33 == 0) messages.push_back(at(s, WheelState{"auto", i % 66 == 0, false}));
  }
  return messages;
}

World after(World world, const std::vector<StampedMessage>& messages, std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i) world = reduce(std::move(world), messages[i]);
  return world;
}

}  // namespace

class WorldTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void holdsTheLiveStateTheListAndItsTime() {
    const World world = reduce(reduce({}, at(5, TrackedPose{{1, 2, 0}})), at(6, submaps("u", 3)));
    QCOMPARE(world.at_s, 6.0);
    QVERIFY(world.submaps && world.submaps->uuid == "u" && world.live.session_uuid == "u");
    QVERIFY(!reduce({}, at(5, TrackedPose{{1, 2, 0}})).submaps);
  }

  void equalIsWhatLooksTheSame() {
    for (const auto& make : {cloud(1), picture("x"), submaps("u", 1)}) {
      QVERIFY(reduce({}, at(1, make)) == reduce({}, at(1, make)));
      QVERIFY(!(reduce({}, at(1, make)) == World{}));
    }
    // The same content at another place in memory.
    QVERIFY(reduce({}, at(1, cloud(1))) == reduce({}, at(1, cloud(1))));
    QVERIFY(reduce({}, at(1, picture("x"))) == reduce({}, at(1, picture("x"))));
    QVERIFY(!(reduce({}, at(1, cloud(1))) == reduce({}, at(1, cloud(2)))));
    QVERIFY(!(reduce({}, at(1, picture("x"))) == reduce({}, at(1, picture("y")))));
    QVERIFY(!(reduce({}, at(1, submaps("u", 1))) == reduce({}, at(1, submaps("u", 2)))));
    QVERIFY(!(reduce({}, at(1, cloud(1))) == reduce({}, at(2, cloud(1)))));
  }

  void everyPartCounts() {
    const World world = after({}, recording(), 0, recording().size());
    QVERIFY(world == world);
    const auto differs = [&](auto change) {
      World other = world;
      change(other.live);
      return !(other == world);
    };
    QVERIFY(differs([](LiveState& s) { s.session_uuid = "c"; }));
    QVERIFY(differs([](LiveState& s) { s.robot_pose->yaw_rad = 1; }));
    QVERIFY(differs([](LiveState& s) { s.trail.pop_back(); }));
    QVERIFY(differs([](LiveState& s) { s.model.width_m = 1; }));
    QVERIFY(differs([](LiveState& s) { s.slam.state = "x"; }));
    QVERIFY(differs([](LiveState& s) { s.clouds.clear(); }));
    QVERIFY(differs([](LiveState& s) { s.path = {{1, 1}}; }));
    QVERIFY(differs([](LiveState& s) { s.trajectory = {{1, 1}}; }));
    QVERIFY(differs([](LiveState& s) { s.local_path.width_m = 2; }));
    QVERIFY(differs([](LiveState& s) { s.planning = PlanningState{}; }));
    QVERIFY(differs([](LiveState& s) { s.map_info = MapInfo{}; }));
    QVERIFY(differs([](LiveState& s) { s.alerts.push_back({}); }));
    QVERIFY(differs([](LiveState& s) { s.battery = BatteryState{}; }));
    QVERIFY(differs([](LiveState& s) { s.wheels.reset(); }));
    QVERIFY(differs([](LiveState& s) { s.sensors = SensorState{}; }));
    QVERIFY(differs([](LiveState& s) { s.nearby_robots.push_back({}); }));
    QVERIFY(differs([](LiveState& s) { s.nearby_footprints["a"]; }));
    QVERIFY(differs([](LiveState& s) { s.landmarks.push_back({}); }));
    QVERIFY(differs([](LiveState& s) { s.doors.push_back({}); }));
    QVERIFY(differs([](LiveState& s) { s.pallets.push_back({}); }));
    QVERIFY(differs([](LiveState& s) { s.features[BoxKind::Charger].push_back({}); }));
    QVERIFY(differs([](LiveState& s) { s.jack = JackState{}; }));
    QVERIFY(differs([](LiveState& s) { s.towing = TowingState{}; }));
    QVERIFY(differs([](LiveState& s) { s.racks.push_back({}); }));
    QVERIFY(differs([](LiveState& s) { s.seen_objects.push_back({}); }));
    QVERIFY(differs([](LiveState& s) { s.constraints.by_name["a"]; }));
    QVERIFY(differs([](LiveState& s) { s.global_positioning = GlobalPositioning{}; }));
    QVERIFY(differs([](LiveState& s) { s.barcode = BarcodeMessage{}; }));
    QVERIFY(differs([](LiveState& s) { s.safety.push_back({}); }));
    QVERIFY(!differs([](LiveState& s) { ++s.frame; }));  // a count of the way, not of the place
  }

  void aWorldThatIsKeptAndGoneOnFromIsTheOneThatWasPlayedThrough() {
    const std::vector<StampedMessage> messages = recording();
    const World whole = after({}, messages, 0, messages.size());
    for (const std::size_t key : {std::size_t(0), std::size_t(57), messages.size() / 2, messages.size()}) {
      const World kept = after({}, messages, 0, key);
      QVERIFY(after(kept, messages, key, messages.size()) == whole);
    }
  }

  void timesComeFromTheStamps() {
    World world = reduce({}, at(100, AlertsMessage{{{6004, AlertLevel::Error, "hot", 0}}}));
    world = reduce(std::move(world), at(160, AlertsMessage{{{6004, AlertLevel::Error, "hot", 0}}}));
    QCOMPARE(world.live.alerts.front().since_s, 100.0);
    world = reduce(std::move(world), at(161, TrackedPose{{1, 2, 0}}));
    QCOMPARE(world.live.trail.back().at_s, 161.0);
  }

  void aStepBackInTimeTakesTheEndOfTheTrailBack() {
    World world;
    for (int i = 0; i < 10; ++i)
      world = reduce(std::move(world), at(100 + i, TrackedPose{{double(i), 0, 0}}));
    world = reduce(std::move(world), at(104.5, BatteryState{}));
    QCOMPARE(world.live.trail.size(), std::size_t(5));
    QCOMPARE(world.at_s, 104.5);
  }
};

}  // namespace test_world

MAPWRIGHT_TEST(test_world, WorldTest, Nothing)
#include "test_world.moc"
