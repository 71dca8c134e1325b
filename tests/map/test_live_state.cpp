#include <QTest>

#include "map/live_state.h"

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
    QCOMPARE(state.trail.front().x(), 10.0);
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
    const auto points = std::make_shared<const std::vector<CloudPoint>>(3);
    state = reduce(state, PointCloudMessage{"/a", points}, 1);
    state = reduce(state, PointCloudMessage{"/b", nullptr}, 1);
    QCOMPARE(state.clouds.size(), std::size_t(2));
    QCOMPARE(state.clouds["/a"], points);
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
    QCOMPARE(toText({12, 3}), std::string("12-3"));
  }
};

QTEST_GUILESS_MAIN(LiveStateTest)
#include "test_live_state.moc"
