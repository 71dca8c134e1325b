#include <QTest>

#include "map/live_state.h"
#include "test_program.h"

namespace test_live_state {

using namespace mapwright::map;

class LiveStateTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void poseMovesTheRobotAndDrawsItsTrail() {
    LiveState state = reduce({}, TrackedPose{{1, 2, 0.5}}, 100);
    state = reduce(state, TrackedPose{{1.01, 2, 0.6}}, 100);
    QCOMPARE(state.trail.size(), std::size_t(1));  // less than a step
    state = reduce(state, TrackedPose{{1.2, 2, 0.7}}, 100);
    QCOMPARE(state.trail.size(), std::size_t(2));
    QCOMPARE(state.robot_pose->yaw_rad, 0.7);
  }

  void trailIsBounded() {
    LiveState state;
    for (std::size_t i = 0; i < LiveState::kTrailPoints + 10; ++i) {
      state = reduce(std::move(state), TrackedPose{{double(i), 0, 0}}, 100);
    }
    QCOMPARE(state.trail.size(), LiveState::kTrailPoints);
    QCOMPARE(state.trail.front().position_m.x(), 10.0);
  }

  void otherMessagesTouchOnlyTheirOwnPart() {
    LiveState state = reduce({}, TrackedPose{{1, 2, 3}}, 100);
    RobotModel model;
    model.footprint = {{0, 0}, {1, 0}, {0, 1}};
    state = reduce(state, model, 100);
    SlamStatus slam;
    slam.state = "positioning";
    state = reduce(state, slam, 100);
    state = reduce(state, SubmapList{}, 100);
    QCOMPARE(state.model.footprint.size(), std::size_t(3));
    QCOMPARE(state.slam.state, std::string("positioning"));
    QCOMPARE(state.robot_pose->x_m, 1.0);
  }

  void anAlertKeepsTheTimeWhenItWasFirstSeen() {
    const auto alerts = [](std::vector<std::int64_t> codes) {
      AlertsMessage message;
      for (const std::int64_t code : codes) message.alerts.push_back({code, AlertLevel::Error, "hot", 0});
      return message;
    };
    LiveState state = reduce({}, alerts({6004}), 100);
    state = reduce(state, alerts({8501, 6004}), 160);
    QCOMPARE(state.alerts.size(), std::size_t(2));
    QCOMPARE(state.alerts[0].code, 6004);
    QCOMPARE(state.alerts[0].since_s, 100.0);
    QCOMPARE(state.alerts[1].since_s, 160.0);
    state = reduce(state, alerts({}), 170);
    QVERIFY(state.alerts.empty());
    state = reduce(state, alerts({6004}), 200);
    QCOMPARE(state.alerts[0].since_s, 200.0);  // it went away in between
  }

  void theLastPictureOfEachKindAndTheLastCloudOfEachTopicAreKept() {
    GridMessage low, high;
    low.kind = GridKind::CostmapLow;
    high.kind = GridKind::CostmapHigh;
    low.topic = "first";
    LiveState state = reduce({}, low, 1);
    state = reduce(state, high, 1);
    low.topic = "second";
    state = reduce(state, low, 1);
    QCOMPARE(state.grids.size(), std::size_t(2));
    QCOMPARE(state.grids[GridKind::CostmapLow].topic, std::string("second"));
    GridMessage otherwise_read = low;
    otherwise_read.reading.mode = CellReading::Mode::Raw;
    QVERIFY(!(otherwise_read == low));
    const auto points = std::make_shared<const std::vector<CloudPoint>>(3);
    state = reduce(state, PointCloudMessage{"/a", points}, 1);
    state = reduce(state, PointCloudMessage{"/b", nullptr}, 1);
    QCOMPARE(state.clouds.size(), std::size_t(2));
    QCOMPARE(state.clouds["/a"], points);
  }

  /// Every part is there, and nothing is what it is by default.
  static LiveState full(SlamState slam_state = SlamState::Slam) {
    SubmapList list;
    list.uuid = "first";
    list.slam_state = slam_state;
    const Polyline line{{0, 0}, {1, 0}, {0, 1}};
    RobotModel model;
    model.footprint = line;
    SlamStatus slam;
    slam.state = "positioning";
    GridMessage whole, costs, incremental, match, symmetry, fine;
    costs.kind = GridKind::CostmapLow;
    fine.kind = GridKind::CostmapHigh;
    incremental.kind = GridKind::Incremental;
    match.kind = GridKind::EnvMatch;
    symmetry.kind = GridKind::EnvSymmetry;
    LocalPathMessage local;
    local.points = line;
    local.width_m = 1;
    PlanningState planning;
    planning.action_type = "charge";
    planning.targets = {{1, 2, 3}};
    planning.remaining_distance_m = 7;
    MapInfo info;
    info.name = "Hall";
    info.uid = "a";
    ConstraintsMessage constraints;
    constraints.by_name["x"] = {{{0, 0}, {1, 1}}};
    GlobalPositioning global;
    global.state = "succeeded";
    global.pose = mapwright::geometry::Pose2{1, 2, 3};
    BarcodeMessage barcode;
    barcode.id = "D1";
    barcode.pose = mapwright::geometry::Pose2{1, 2, 3};
    LiveState state;
    for (const TopicMessage& message :
         std::vector<TopicMessage>{list,
                                   TrackedPose{{1, 2, 3}},
                                   model,
                                   slam,
                                   whole,
                                   costs,
                                   fine,
                                   incremental,
                                   match,
                                   symmetry,
                                   PointCloudMessage{"/a", nullptr},
                                   PathMessage{line},
                                   local,
                                   TrajectoryMessage{line},
                                   planning,
                                   info,
                                   AlertsMessage{{{7, AlertLevel::Error, "hot", 0}}},
                                   BatteryState{0.5, {}, {}, "full"},
                                   WheelState{"auto", true, {}},
                                   SensorState{"on"},
                                   NearbyRobotsMessage{{{"r", {}, line, "aa"}}},
                                   NearbyFootprintsMessage{{{"aa", line}}},
                                   LandmarksMessage{{{"l", {1, 2}, true}}},
                                   AutoDoorsMessage{{{"d", "mac", "closed", line}}},
                                   PalletsMessage{{{"p", {}, 1, 1, false}}},
                                   RackMessage{{{"k", {}, 1, 1, true}}},
                                   SeenObjectsMessage{{{"s", {}, 1, 1, false}}},
                                   constraints,
                                   global,
                                   barcode}) {
      state = reduce(std::move(state), message, 100);
    }
    return state;
  }
  static void hasForgottenItsFrame(const LiveState& state, bool map_stays) {
    QVERIFY(!state.robot_pose && state.trail.empty());
    QVERIFY(state.clouds.empty() && state.path.empty() && state.trajectory.empty());
    QVERIFY(state.local_path.points.empty());
    QVERIFY(state.nearby_robots.empty() && state.landmarks.empty() && state.doors.empty());
    QVERIFY(state.pallets.empty() && state.racks.empty() && state.seen_objects.empty());
    QVERIFY(state.constraints.by_name.empty());
    QVERIFY(state.planning && state.planning->targets.empty() && !state.planning->remaining_distance_m);
    QVERIFY(!state.global_positioning->pose && !state.barcode->pose);
    QCOMPARE(state.grids.size(), std::size_t(map_stays ? 1 : 0));
    QCOMPARE(state.grids.contains(GridKind::WholeMap), map_stays);
    QCOMPARE(state.map_info.has_value(), map_stays);
    // No place, so it holds in every frame.
    QCOMPARE(state.model.footprint.size(), std::size_t(3));
    QCOMPARE(state.slam.state, std::string("positioning"));
    QCOMPARE(state.planning->action_type, std::string("charge"));
    QCOMPARE(state.alerts.size(), std::size_t(1));
    QCOMPARE(state.alerts[0].since_s, 100.0);
    QVERIFY(state.battery && state.wheels && state.sensors);
    QCOMPARE(state.nearby_footprints.size(), std::size_t(1));
    QCOMPARE(state.global_positioning->state, std::string("succeeded"));
    QCOMPARE(state.barcode->id, std::string("D1"));
  }

  void anotherSessionForgetsWhatLayInItsFrame_data() {
    QTest::addColumn<int>("slam_state");
    QTest::addColumn<bool>("map_stays");
    QTest::newRow("a new map is being made") << int(SlamState::Slam) << false;
    QTest::newRow("unknown") << int(SlamState::Invalid) << false;
    QTest::newRow("in the same map") << int(SlamState::Positioning) << true;
  }
  void anotherSessionForgetsWhatLayInItsFrame() {
    QFETCH(int, slam_state);
    QFETCH(bool, map_stays);
    LiveState state = full();
    const int frame = state.frame;
    QVERIFY(state.robot_pose && !state.trail.empty() && state.grids.size() == 6);
    SubmapList list;
    list.uuid = "second";
    list.slam_state = SlamState(slam_state);
    state = reduce(std::move(state), list, 200);
    QCOMPARE(state.frame, frame + 1);
    hasForgottenItsFrame(state, map_stays);
    state = reduce(std::move(state), TrackedPose{{5, 6, 0}}, 201);
    QCOMPARE(state.trail.size(), std::size_t(1));
    state = reduce(std::move(state), list, 202);
    QVERIFY(state.robot_pose);
  }

  void theSameOrNoSessionForgetsNothing() {
    for (const char* uuid : {"first", ""}) {
      SubmapList list;
      list.uuid = uuid;
      const LiveState state = reduce(full(), list, 200);
      QVERIFY(state.robot_pose && state.grids.size() == 6);
      QCOMPARE(state.frame, full().frame);
    }
    // After a pause without a session the next one is told by the last.
    SubmapList none, first, second;
    first.uuid = "first";
    second.uuid = "second";
    QVERIFY(reduce(reduce(full(), none, 200), first, 201).robot_pose);
    QVERIFY(!reduce(reduce(full(), none, 200), second, 201).robot_pose);
  }

  void anotherMapForgetsWhatLayInItsFrame_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("uid");
    QTest::addColumn<bool>("other");
    QTest::newRow("the same") << "Hall"
                              << "a" << false;
    QTest::newRow("renamed") << "Attic"
                             << "a" << false;
    QTest::newRow("another uid") << "Hall"
                                 << "b" << true;
    QTest::newRow("no uid, the same name") << "Hall"
                                           << "" << false;
    QTest::newRow("no uid, another name") << "Attic"
                                          << "" << true;
    QTest::newRow("nothing said") << ""
                                  << "" << false;
  }
  void anotherMapForgetsWhatLayInItsFrame() {
    QFETCH(QString, name);
    QFETCH(QString, uid);
    QFETCH(bool, other);
    MapInfo info;
    info.name = name.toStdString();
    info.uid = uid.toStdString();
    info.map_version = 77;
    LiveState state = reduce(full(), info, 200);
    QCOMPARE(state.frame, full().frame + (other ? 1 : 0));
    QCOMPARE(*state.map_info->map_version, 77);
    if (!other) {
      QVERIFY(state.robot_pose && state.grids.size() == 6);
      return;
    }
    state.map_info.reset();
    hasForgottenItsFrame(state, false);
  }

  void footprintsOfOtherRobotsAddUp() {
    NearbyFootprintsMessage first, second;
    first.by_digest["aa"] = {{0, 0}, {1, 0}, {0, 1}};
    second.by_digest["bb"] = {{0, 0}, {2, 0}, {0, 2}};
    LiveState state = reduce(reduce({}, first, 1), second, 2);
    QCOMPARE(state.nearby_footprints.size(), std::size_t(2));
  }

  void idsOrderAsTheyArePainted() {
    QVERIFY((SubmapId{0, 99} < SubmapId{1, 0}));
    QCOMPARE(toText(SubmapId{12, 3}), std::string("12-3"));
  }
};

}  // namespace test_live_state

MAPWRIGHT_TEST(test_live_state, LiveStateTest, Core)
#include "test_live_state.moc"
