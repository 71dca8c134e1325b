// What a snapshot waits for: everything that its layers are to show is in the world that is drawn.
#include <QTest>

#include "../session/fake_robot.h"
#include "map/live_state.h"
#include "robot/offers_topics.h"
#include "session/session_options.h"
#include "test_program.h"
#include "ui/shot/layer_subscription.h"

namespace test_layer_subscription {

using namespace mapwright;
using test::FakeRobot;
using ui::scene::Layer;

namespace {

/// One that says which topics it has.
class TellingRobot : public FakeRobot, public robot::OffersTopics {
 public:
  QStringList topicsOf(map::Stream stream) const override {
    if (stream == map::Stream::Planning) return {};
    if (stream == map::Stream::Cloud) return {QStringLiteral("/scan"), QStringLiteral("/points")};
    if (stream == map::Stream::SeenObjects && !markers.isEmpty()) return markers;
    return FakeRobot::topicsOf(stream);
  }
  std::optional<std::vector<robot::OfferedTopic>> offered() const override { return told; }
  QStringList choicesFor(map::Stream) const override { return {}; }
  void choose(const robot::TopicChoices&) override {}
  robot::TopicChoices chosen() const override { return {}; }

  std::map<QString, int> unplacedMarkers() const override { return unplaced; }

  std::optional<std::vector<robot::OfferedTopic>> told;
  QStringList markers;
  std::map<QString, int> unplaced;
};

}  // namespace

class LayerSubscriptionTest : public QObject {
  Q_OBJECT
 private:
  TellingRobot* robot_ = nullptr;
  std::unique_ptr<session::Session> session_;
  std::unique_ptr<ui::shot::LayerSubscription> layers_;

  std::string topicOf(map::Stream stream) const { return robot_->topicsOf(stream).first().toStdString(); }

 private Q_SLOTS:
  void init() {
    layers_.reset();
    auto robot = std::make_unique<TellingRobot>();
    robot_ = robot.get();
    robot_->has_topics = true;
    session_ = std::make_unique<session::Session>(std::move(robot), session::Session::Options{});
    layers_ = std::make_unique<ui::shot::LayerSubscription>(*session_);
    robot_->setPhase(robot::ConnectionPhase::Online);
  }
  void cleanupTestCase() { layers_.reset(); }

  void nothingIsWaitedForWithoutLayersOfTheRobot() {
    layers_->ask({Layer::Grid, Layer::ScaleBar, Layer::Submaps}, false);
    QVERIFY(layers_->in());
  }

  void whereTheRobotIsIsWaitedForAlthoughItComesUnasked() {
    for (const Layer layer : {Layer::Robot, Layer::Trail, Layer::Boxes}) {
      init();
      layers_->ask({layer, Layer::Grid}, false);
      QVERIFY(!layers_->in());
      QVERIFY(!layers_->silent().isEmpty());
      for (const map::Stream stream : {map::Stream::Pallets, map::Stream::Racks, map::Stream::SeenObjects})
        robot_->say(map::AlertsMessage{}, topicOf(stream));
      QVERIFY(!layers_->in());
      robot_->say(map::TrackedPose{{1, 2, 0}}, topicOf(map::Stream::Pose));
      QVERIFY(layers_->in());
      QVERIFY(session_->live().robot_pose);
    }
  }

  void itsOutlineIsWaitedForWhereItIsDrawn() {
    for (const Layer layer : {Layer::Footprint, Layer::ExpandedFootprint}) {
      init();
      layers_->ask({layer}, false);
      robot_->say(map::TrackedPose{{1, 2, 0}}, topicOf(map::Stream::Pose));
      QCOMPARE(layers_->silent(), robot_->topicsOf(map::Stream::Model).mid(0, 1));
      robot_->say(map::RobotModel{}, topicOf(map::Stream::Model));
      QVERIFY(layers_->in());
    }
  }

  // Which of them comes first is chance: the picture is of both.
  void everyScannerThatTheRobotSaysItHasIsWaitedFor() {
    for (const char* const first : {"/scan", "/points"}) {
      const std::string second = first == std::string("/scan") ? "/points" : "/scan";
      init();
      layers_->ask({Layer::Cloud}, false);
      robot_->say(map::PointCloudMessage{}, first);
      QVERIFY(layers_->in());  // it does not say which it has
      init();
      robot_->told = {{QStringLiteral("/scan"), {}}, {QStringLiteral("/points"), {}}};
      layers_->ask({Layer::Cloud}, false);
      robot_->say(map::PointCloudMessage{}, first);
      QCOMPARE(layers_->silent(), QStringList{QString::fromStdString(second)});
      robot_->say(map::PointCloudMessage{}, second);
      QVERIFY(layers_->in());
    }
  }

  void markersAreWaitedForUntilAllHaveTheirPlace() {
    robot_->markers = {QStringLiteral("/a"), QStringLiteral("/b")};
    robot_->told = {{QStringLiteral("/a"), {}}, {QStringLiteral("/b"), {}}};
    layers_->ask({Layer::Boxes}, false);
    robot_->say(map::TrackedPose{{1, 2, 0}}, topicOf(map::Stream::Pose));
    for (const map::Stream stream : {map::Stream::Pallets, map::Stream::Racks})
      robot_->say(map::AlertsMessage{}, topicOf(stream));
    robot_->say(map::SeenObjectsMessage{}, "/a");
    QVERIFY(!layers_->in());
    QCOMPARE(layers_->silent(), QStringList{QStringLiteral("/b")});
    robot_->unplaced[QStringLiteral("/b")] = 3;
    robot_->say(map::SeenObjectsMessage{}, "/b");
    QVERIFY(!layers_->in() && layers_->silent().isEmpty());
    robot_->unplaced.clear();
    QVERIFY(layers_->in());
  }

  void whatHasNoPlaceIsNamedAsLongAsItHasNone() {
    layers_->ask({Layer::Path}, false);
    const std::string topic = topicOf(map::Stream::Path);
    const map::Subject subject(map::SubjectKind::Topic, topic);
    Q_EMIT robot_->problemFound(
        {map::Severity::Warning, subject, fault::said("no transform"), map::ProblemCode::Unplaced});
    QCOMPARE(layers_->unplaced(), QStringList{QString::fromStdString(topic)});
    Q_EMIT robot_->recovered({subject, map::ProblemCode::Unplaced});
    QVERIFY(layers_->unplaced().isEmpty());
  }

  void aLayerThatNoTopicFillsIsKnown() {
    layers_->ask({Layer::Target, Layer::Path, Layer::Grid}, false);
    QCOMPARE(layers_->unfillable(), std::vector{Layer::Target});
  }

  void whatCameBeforeItWasAskedForHasCome() {
    robot_->say(map::TrackedPose{{1, 2, 0}}, topicOf(map::Stream::Pose));
    layers_->ask({Layer::Robot}, false);
    QVERIFY(layers_->in());
  }

  // It is no message of nothing: what is wrong with it is told elsewhere.
  void aMessageThatCannotBeReadIsNotWaitedForAgain() {
    layers_->ask({Layer::Path}, false);
    QVERIFY(!layers_->in());
    const std::string topic = topicOf(map::Stream::Path);
    robot_->say(map::UnreadableMessage{topic, fault::said("no list")}, topic);
    QVERIFY(layers_->in());
  }
};

}  // namespace test_layer_subscription

MAPWRIGHT_TEST(test_layer_subscription, LayerSubscriptionTest, Widgets)
#include "test_layer_subscription.moc"
