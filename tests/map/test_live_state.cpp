#include <QTest>

#include "map/live_state.h"

using namespace mapwright::map;

class LiveStateTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void poseMovesTheRobotAndDrawsItsTrail() {
    LiveState state = reduce({}, TrackedPose{{1, 2, 0.5}});
    state = reduce(state, TrackedPose{{1.01, 2, 0.6}});
    QCOMPARE(state.trail.size(), std::size_t(1));  // less than a step
    state = reduce(state, TrackedPose{{1.2, 2, 0.7}});
    QCOMPARE(state.trail.size(), std::size_t(2));
    QCOMPARE(state.robot_pose->yaw_rad, 0.7);
  }

  void trailIsBounded() {
    LiveState state;
    for (std::size_t i = 0; i < LiveState::kTrailPoints + 10; ++i) {
      state = reduce(std::move(state), TrackedPose{{double(i), 0, 0}});
    }
    QCOMPARE(state.trail.size(), LiveState::kTrailPoints);
    QCOMPARE(state.trail.front().x(), 10.0);
  }

  void otherMessagesTouchOnlyTheirOwnPart() {
    LiveState state = reduce({}, TrackedPose{{1, 2, 3}});
    RobotModel model;
    model.footprint = {{0, 0}, {1, 0}, {0, 1}};
    state = reduce(state, model);
    state = reduce(state, SlamStatus{"positioning", true});
    state = reduce(state, SubmapList{});
    QCOMPARE(state.model.footprint.size(), std::size_t(3));
    QCOMPARE(state.slam.state, std::string("positioning"));
    QCOMPARE(state.robot_pose->x_m, 1.0);
  }

  void idsOrderAsTheyArePainted() {
    QVERIFY((SubmapId{0, 99} < SubmapId{1, 0}));
    QCOMPARE(toText({12, 3}), std::string("12-3"));
  }
};

QTEST_GUILESS_MAIN(LiveStateTest)
#include "test_live_state.moc"
