// What a snapshot waits for: everything that its layers are to show is in the world that is drawn.
#include <QTest>

#include "../session/fake_robot.h"
#include "app/layer_wish.h"

using namespace mapwright;
using scene::Layer;
using test::FakeRobot;

class LayerWishTest : public QObject {
  Q_OBJECT
 private:
  FakeRobot* robot_ = nullptr;
  std::unique_ptr<session::Session> session_;
  std::unique_ptr<app::LayerWish> wish_;

  std::string topicOf(map::Stream stream) const { return robot_->topicsOf(stream).first().toStdString(); }

 private Q_SLOTS:
  void init() {
    wish_.reset();
    auto robot = std::make_unique<FakeRobot>();
    robot_ = robot.get();
    robot_->has_topics = true;
    session_ = std::make_unique<session::Session>(std::move(robot), session::Session::Options{});
    wish_ = std::make_unique<app::LayerWish>(*session_);
    robot_->setPhase(robot::ConnectionPhase::Online);
  }
  void cleanupTestCase() { wish_.reset(); }

  void nothingIsWaitedForWithoutLayersOfTheRobot() {
    wish_->ask({Layer::Grid, Layer::ScaleBar, Layer::Submaps}, false);
    QVERIFY(wish_->in());
  }

  void whereTheRobotIsIsWaitedForAlthoughItComesUnasked() {
    for (const Layer layer : {Layer::Robot, Layer::Trail, Layer::Boxes}) {
      init();
      wish_->ask({layer, Layer::Grid}, false);
      QVERIFY(!wish_->in());
      QVERIFY(!wish_->silent().isEmpty());
      for (const map::Stream stream : {map::Stream::Pallets, map::Stream::Racks, map::Stream::SeenObjects})
        robot_->say(map::AlertsMessage{}, topicOf(stream));
      QVERIFY(!wish_->in());
      robot_->say(map::TrackedPose{{1, 2, 0}}, topicOf(map::Stream::Pose));
      QVERIFY(wish_->in());
      QVERIFY(session_->live().robot_pose);
    }
  }

  void itsOutlineIsWaitedForWhereItIsDrawn() {
    for (const Layer layer : {Layer::Footprint, Layer::ExpandedFootprint}) {
      init();
      wish_->ask({layer}, false);
      robot_->say(map::TrackedPose{{1, 2, 0}}, topicOf(map::Stream::Pose));
      QCOMPARE(wish_->silent(), robot_->topicsOf(map::Stream::Model).mid(0, 1));
      robot_->say(map::RobotModel{}, topicOf(map::Stream::Model));
      QVERIFY(wish_->in());
    }
  }

  void whatCameBeforeItWasAskedForHasCome() {
    robot_->say(map::TrackedPose{{1, 2, 0}}, topicOf(map::Stream::Pose));
    wish_->ask({Layer::Robot}, false);
    QVERIFY(wish_->in());
  }

  // It is no message of nothing: what is wrong with it is told elsewhere.
  void aMessageThatCannotBeReadIsNotWaitedForAgain() {
    wish_->ask({Layer::Path}, false);
    QVERIFY(!wish_->in());
    const std::string topic = topicOf(map::Stream::Path);
    robot_->say(map::UnreadableMessage{topic, map::said("no list")}, topic);
    QVERIFY(wish_->in());
  }
};

QTEST_MAIN(LayerWishTest)
#include "test_layer_wish.moc"
