// An Agibot robot with a rosbridge beside its interface, over both simulators.
#include <QTcpServer>
#include <QTest>

#include "robot/aimdk/aimdk_robot.h"
#include "robot/aimdk/faults.h"
#include "robot/robot.h"
#include "robot/ros/ros_robot.h"
#include "robot/sends_map.h"
#include "sentences/absence_sentence.h"
#include "sentences/fault_sentence.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_aimdk_live {

using namespace mapwright;
using namespace mapwright::robot;
using aimdk::AimdkRobot;
using map::Stream;
using std::chrono::milliseconds;

class AimdkLiveTest : public QObject {
  Q_OBJECT
  std::unique_ptr<simulator::Simulator> simulator_;
  std::unique_ptr<AimdkRobot> robot_;
  std::vector<map::StampedMessage> messages_;
  std::vector<map::Problem> problems_;
  std::vector<map::Recovery> recoveries_;
  milliseconds quiet_after_{3'000};

  /// `bridge_port`: where its rosbridge should be.
  void makeRobot(quint16 bridge_port) {
    aimdk::LinkOptions options;
    options.base = QUrl(QStringLiteral("http://127.0.0.1:%1").arg(simulator_->aimdkPort()));
    ros::LinkOptions beside;
    beside.url = QUrl(QStringLiteral("ws://127.0.0.1:%1").arg(bridge_port));
    beside.client.link.ask_after = quiet_after_ / 4;
    beside.client.link.look_every = quiet_after_ / 10;
    beside.client.link.quiet_after = quiet_after_;
    beside.client.link.backoff_first = milliseconds(5);
    beside.client.link.backoff_limit = milliseconds(20);
    aimdk::RobotBeside bridge{std::make_unique<ros::RosRobot>(QStringLiteral("ros+test"), std::move(beside)),
                              QStringLiteral("127.0.0.1:9090")};
    robot_ =
        std::make_unique<AimdkRobot>(QStringLiteral("aimdk+test"), std::move(options), std::move(bridge));
    connect(robot_.get(), &Robot::topicReceived, this,
            [this](const map::StampedMessage& message) { messages_.push_back(message); });
    connect(robot_.get(), &Robot::problemFound, this,
            [this](const map::Problem& problem) { problems_.push_back(problem); });
    connect(robot_.get(), &Robot::recovered, this,
            [this](const map::Recovery& recovery) { recoveries_.push_back(recovery); });
    robot_->connectToRobot();
  }
  template <typename T>
  bool has() const {
    return std::any_of(messages_.begin(), messages_.end(), [](const map::StampedMessage& message) {
      return std::holds_alternative<T>(message.message);
    });
  }
  const map::Problem* away() const {
    for (const map::Problem& problem : problems_) {
      if (problem.reason.code == robot::aimdk::fault::PoseSourceAway) return &problem;
    }
    return nullptr;
  }

 private Q_SLOTS:
  void init() {
    simulator_ = std::make_unique<simulator::Simulator>(simulator::Options());
    QVERIFY(!simulator_->start());
    messages_.clear();
    problems_.clear();
    recoveries_.clear();
    quiet_after_ = milliseconds(3'000);
  }
  void cleanup() {
    robot_.reset();
    simulator_.reset();
  }

  void whereItIsAndWhatItSeesComesByTheRosbridge() {
    makeRobot(simulator_->rosPort());
    QTRY_COMPARE(robot_->connection().phase, ConnectionPhase::Online);
    QVERIFY(robot_->liveTopics());
    robot_->liveTopics()->setWanted(
        {Stream::Pose, Stream::Path, Stream::Cloud, Stream::WholeMap, Stream::MapInfo}, {});
    QTRY_VERIFY(has<map::TrackedPose>());
    QTRY_VERIFY(has<map::PathMessage>());
    QTRY_VERIFY(has<map::PointCloudMessage>());
    // The maps are those of the interface.
    QVERIFY(!has<map::GridMessage>() && !has<map::MapInfo>());
    QVERIFY(!sendsItsMap(*robot_));
    QVERIFY(robot_->liveTopics()->topicsOf(Stream::Pose).contains(QLatin1String("/tf")));
    QVERIFY(!sentences::limitsOf(*robot_).contains(QLatin1String("rosbridge")));
    QVERIFY(!away());
    robot_->disconnectFromRobot();
    QTRY_COMPARE(robot_->connection().phase, ConnectionPhase::Offline);
  }

  void aRosbridgeThatIsAwayIsToldAndKeepsNoMapAway() {
    QTcpServer place;
    QVERIFY(place.listen(QHostAddress::LocalHost));
    const quint16 nobody = place.serverPort();
    place.close();
    makeRobot(nobody);
    QTRY_COMPARE(robot_->connection().phase, ConnectionPhase::Online);
    QTRY_VERIFY(away());
    QCOMPARE(away()->subject, map::Subject(map::SubjectKind::Robot, "127.0.0.1:9090"));
    QVERIFY(away()->severity == map::Severity::Warning);
    const QString sentence = sentences::sentenceOf(away()->reason);
    QVERIFY2(sentence.contains(QLatin1String("127.0.0.1:9090")), qPrintable(sentence));
    std::optional<std::size_t> maps;
    robot_->mapCatalogue()->list([&](const auto& entries) { maps = entries ? entries->size() : 0; });
    QTRY_VERIFY(maps && *maps > 0);
    // Every try that fails alike is no news.
    const auto count = std::count_if(problems_.begin(), problems_.end(), [](const map::Problem& problem) {
      return problem.reason.code == robot::aimdk::fault::PoseSourceAway;
    });
    QCOMPARE(int(count), 1);
    simulator::Options options;
    options.ros.port = nobody;
    simulator::Simulator late(options);
    QVERIFY(!late.start());
    QTRY_VERIFY(!recoveries_.empty());
    QTRY_VERIFY(has<map::TrackedPose>());
  }

  void aRosbridgeThatStallsIsTold() {
    quiet_after_ = milliseconds(300);
    makeRobot(simulator_->rosPort());
    QTRY_COMPARE(robot_->connection().phase, ConnectionPhase::Online);
    robot_->liveTopics()->setWanted({Stream::Pose}, {});
    QTRY_VERIFY(has<map::TrackedPose>());
    QVERIFY(!silentSince(*robot_));
    const QDateTime before = QDateTime::currentDateTime();
    simulator_->stallRos();
    QTRY_VERIFY(silentSince(*robot_));
    QVERIFY(*silentSince(*robot_) >= before.addSecs(-2));
    QCOMPARE(robot_->connection().phase, ConnectionPhase::Online);  // the interface answers
    simulator_->unstallRos();
    QTRY_VERIFY(!silentSince(*robot_));
  }

  void aRosbridgeThatIsLostComesBack() {
    makeRobot(simulator_->rosPort());
    QTRY_VERIFY(has<map::TrackedPose>());
    simulator_->dropWebSockets();
    QTRY_VERIFY(away());
    messages_.clear();
    QTRY_VERIFY(has<map::TrackedPose>());
    QTRY_VERIFY(!recoveries_.empty());
    QCOMPARE(robot_->connection().phase, ConnectionPhase::Online);
  }
};

}  // namespace test_aimdk_live

MAPWRIGHT_TEST(test_aimdk_live, AimdkLiveTest, Core)
#include "test_aimdk_live.moc"
