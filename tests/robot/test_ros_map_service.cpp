// The map of a ROS robot whose map topic is silent, by a service of type nav_msgs/GetMap.
#include <QSignalSpy>
#include <QTest>

#include "robot/ros/faults.h"
#include "robot/ros/ros_robot.h"
#include "scripted_bridge.h"
#include "test_program.h"

namespace test_ros_map_service {

using namespace mapwright;
using namespace mapwright::robot;
using map::Stream;
using ros::RosRobot;
using std::chrono::milliseconds;
using testing::ScriptedBridge;

namespace {

QString text(const char* latin) { return QString::fromLatin1(latin); }

QJsonObject json(const QByteArray& text) { return QJsonDocument::fromJson(text).object(); }

QJsonObject grid(int cell = 0) {
  return json(
      R"({"header":{"frame_id":"map","stamp":{"sec":5,"nanosec":0}},"info":{"resolution":0.05,"width":2,)"
      R"("height":1,"origin":{"position":{"x":1,"y":2,"z":0},"orientation":{"x":0,"y":0,"z":0,"w":1}}},)"
      R"("data":[)" +
      QByteArray::number(cell) + ",100]}");
}

}  // namespace

class RosMapServiceTest : public QObject {
  Q_OBJECT
  std::unique_ptr<ScriptedBridge> server_;
  std::unique_ptr<RosRobot> robot_;
  std::vector<map::GridMessage> maps_;
  std::vector<map::Problem> problems_;
  std::vector<map::Recovery> recoveries_;

  void serveMap(const QString& service, const char* type = "nav_msgs/GetMap", int cell = 0) {
    server_->serve(service, [cell](const QJsonObject&) { return QJsonObject{{text("map"), grid(cell)}}; });
    server_->serve(text("/rosapi/service_type"), [service, type = text(type)](const QJsonObject& args) {
      const bool its = args[text("service")].toString() == service;
      return QJsonObject{{text("type"), its ? type : text("std_srvs/Empty")}};
    });
  }
  void wantMap() {
    robot_->liveTopics()->setWanted({Stream::WholeMap}, {});
    robot_->connectToRobot();
  }
  bool told(FaultCode code) const {
    return std::any_of(problems_.begin(), problems_.end(),
                       [&](const map::Problem& problem) { return problem.reason.code == code; });
  }

 private Q_SLOTS:
  void init() {
    server_ = std::make_unique<ScriptedBridge>();
    ros::LinkOptions options;
    options.url = server_->url();
    options.look_every = milliseconds(50);
    options.look_timeout = milliseconds(20'000);
    options.topics = {milliseconds(20), milliseconds(40), milliseconds(10)};
    options.map_service = {milliseconds(120), milliseconds(20'000), milliseconds(30)};
    options.client.link.backoff_first = milliseconds(5);
    options.client.link.backoff_limit = milliseconds(20);
    robot_ = std::make_unique<RosRobot>(text("ros+test"), options);
    maps_.clear();
    problems_.clear();
    recoveries_.clear();
    connect(robot_.get(), &Robot::topicReceived, this, [this](const map::StampedMessage& message) {
      if (const auto* const grid = std::get_if<map::GridMessage>(&message.message)) maps_.push_back(*grid);
    });
    connect(robot_.get(), &Robot::problemFound, this,
            [this](const map::Problem& problem) { problems_.push_back(problem); });
    connect(robot_.get(), &Robot::recovered, this,
            [this](const map::Recovery& recovery) { recoveries_.push_back(recovery); });
  }
  void cleanup() {
    robot_.reset();
    server_.reset();
  }

  void aSilentTopicIsReplacedByTheService_data() {
    QTest::addColumn<QString>("service");
    QTest::addColumn<QByteArray>("type");
    QTest::newRow("ROS 1") << text("/static_map") << QByteArray("nav_msgs/GetMap");
    QTest::newRow("ROS 2") << text("/map_server/map") << QByteArray("nav_msgs/srv/GetMap");
    QTest::newRow("while mapping") << text("/dynamic_map") << QByteArray("nav_msgs/GetMap");
  }
  void aSilentTopicIsReplacedByTheService() {
    QFETCH(QString, service);
    QFETCH(QByteArray, type);
    server_->advertise(text("/map"), text("nav_msgs/OccupancyGrid"));
    serveMap(service, type.constData());
    wantMap();
    QTRY_COMPARE(maps_.size(), std::size_t(1));
    QCOMPARE(maps_[0].topic, std::string("/map"));
    QCOMPARE(maps_[0].grid.width, 2);
    QTRY_VERIFY(told(robot::ros::fault::TopicAskedInstead));
    QCOMPARE(problems_.back().severity, map::Severity::Info);
    // It is asked once; a topic that speaks after all goes on from there, and all is well.
    server_->latch(text("/map"), grid(7));
    QTRY_COMPARE(maps_.size(), std::size_t(2));
    QCOMPARE(server_->timesCalled(service), 1);
    const map::Subject topic(map::SubjectKind::Topic, "/map");
    QTRY_VERIFY(std::any_of(recoveries_.begin(), recoveries_.end(),
                            [&](const map::Recovery& recovery) { return recovery.subject == topic; }));
  }

  void aTopicThatSpeaksIsEnough() {
    server_->advertise(text("/map"), text("nav_msgs/OccupancyGrid"));
    server_->latch(text("/map"), grid());
    serveMap(text("/static_map"));
    wantMap();
    QTRY_COMPARE(maps_.size(), std::size_t(1));
    const int looks = server_->timesCalled(text("/rosapi/topics"));
    QTRY_VERIFY(server_->timesCalled(text("/rosapi/topics")) > looks + 6);  // longer than silence is borne
    QCOMPARE(server_->timesCalled(text("/static_map")), 0);
  }

  void aMapByServiceAloneIsTheLiveMap() {
    serveMap(text("/static_map"));
    robot_->connectToRobot();
    QTRY_COMPARE(robot_->connection().phase, ConnectionPhase::Online);
    QCOMPARE(robot_->liveTopics()->topicsOf(Stream::WholeMap), QStringList{text("/static_map")});
    QCOMPARE(server_->timesCalled(text("/static_map")), 0);  // nobody wants it
    std::optional<Outcome<map::WholeMap>> answer;
    robot_->wholeMapSource()->fetch({map::MapKind::Live, {}},
                                    [&](Outcome<map::WholeMap> map) { answer = map; });
    QTRY_VERIFY(answer.has_value());
    QVERIFY(answer->has_value());
    QCOMPARE((*answer)->grid.width, 2);
  }

  void aServiceOfAnotherTypeIsNotAsked() {
    server_->advertise(text("/map"), text("nav_msgs/OccupancyGrid"));
    serveMap(text("/static_map"), "std_srvs/Trigger");
    wantMap();
    QTRY_VERIFY(told(robot::ros::fault::TopicSilent));
    const int looks = server_->timesCalled(text("/rosapi/topics"));
    QTRY_VERIFY(server_->timesCalled(text("/rosapi/topics")) > looks + 6);
    QCOMPARE(server_->timesCalled(text("/static_map")), 0);
  }

  void aServiceThatFailsIsToldAndAskedAgain() {
    serveMap(text("/static_map"));
    server_->serve(text("/static_map"), [](const QJsonObject&) {
      return QJsonObject{
          {text("refused"), text("service [/static_map] responded with an error: b'no map yet'")}};
    });
    wantMap();
    QTRY_VERIFY(told(robot::ros::fault::MapServiceFailed));
    QCOMPARE(problems_.back().reason.because.at(0), robot::ros::fault::said("no map yet"));
    server_->serve(text("/static_map"), [](const QJsonObject&) {
      return QJsonObject{{text("map"), grid()}};
    });
    QTRY_COMPARE(maps_.size(), std::size_t(1));
    QTRY_VERIFY(!recoveries_.empty());
  }

  void withoutRosapiTheUsualServicesAreTried() {
    server_->withdraw(text("/rosapi/topics"));
    server_->withdraw(text("/rosapi/services"));
    server_->serve(text("/map_server/map"), [](const QJsonObject&) {
      return QJsonObject{{text("map"), grid()}};
    });
    wantMap();
    QTRY_COMPARE(maps_.size(), std::size_t(1));
    QVERIFY(server_->timesCalled(text("/static_map")) >= 1);
    QVERIFY(!told(robot::ros::fault::MapServiceFailed));
  }
};

}  // namespace test_ros_map_service

MAPWRIGHT_TEST(test_ros_map_service, RosMapServiceTest, Core)
#include "test_ros_map_service.moc"
