// What a map dispatcher of REP 130 projects, behind a rosbridge server and a ROS master.
#include <QSignalSpy>
#include <QTest>

#include "robot/faults.h"
#include "robot/map_dispatch.h"
#include "robot/ros/ros_robot.h"
#include "scripted_bridge.h"
#include "test_program.h"

namespace test_ros_projections {

using namespace mapwright;
using namespace mapwright::robot;
using map::Projection;
using ros::RosRobot;
using std::chrono::milliseconds;
using testing::ScriptedBridge;

namespace {

constexpr int kPatienceMs = 30'000;

QString text(const char* latin) { return QString::fromLatin1(latin); }

QJsonObject grid(const char* frame = "map") {
  QJsonObject grid =
      QJsonDocument::fromJson(
          R"({"info":{"resolution":0.05,"width":2,"height":1,"origin":{"position":{"x":1,"y":2,"z":0},)"
          R"("orientation":{"x":0,"y":0,"z":0,"w":1}}},"data":[0,100]})")
          .object();
  grid[text("header")] = QJsonObject{{text("frame_id"), text(frame)}};
  return grid;
}

QJsonObject projected(double min_z, const char* frame = "map") {
  return {{text("map"), grid(frame)}, {text("min_z"), min_z}, {text("max_z"), min_z + 2}};
}

}  // namespace

class RosProjectionsTest : public QObject {
  Q_OBJECT
  std::unique_ptr<ScriptedBridge> server_;
  std::unique_ptr<RosRobot> robot_;
  QMap<QString, QString> types_;
  QSet<QString> sent_;  // topics that a node sends by

  void make(ros::DispatchSettings wish = {}) {
    ros::LinkOptions options;
    options.url = server_->url();
    options.look_every = milliseconds(50);
    options.look_timeout = milliseconds(20'000);
    options.dispatch = std::move(wish);
    options.dispatch_timeouts.settles = milliseconds(400);
    robot_ = std::make_unique<RosRobot>(text("ros+test"), options);
  }
  /// Connects, and waits until it is known what there is.
  bool begin() {
    robot_->connectToRobot();
    return QTest::qWaitFor([this] { return robot_->connection().phase == ConnectionPhase::Online; },
                           kPatienceMs);
  }
  MapDispatch* dispatch() { return robot_->mapDispatch(); }
  void serve(const char* service, const char* type, const QJsonObject& answer) {
    types_[text(service)] = text(type);
    server_->serve(text(service), [answer](const QJsonObject&) { return answer; });
  }
  template <typename T>
  Outcome<T> outcome(const std::function<Call(OutcomeTo<T>)>& ask) {
    std::optional<Outcome<T>> ended;
    const Call call = ask([&](Outcome<T> told) { ended = std::move(told); });
    if (!QTest::qWaitFor([&] { return ended.has_value(); }, kPatienceMs)) qFatal("no answer");
    return *ended;
  }
  Outcome<std::vector<Projection>> askProjections() {
    return outcome<std::vector<Projection>>([&](auto reply) { return dispatch()->projections(reply); });
  }
  Outcome<std::vector<Projection>> askProject(const std::vector<Projection>& wanted) {
    return outcome<std::vector<Projection>>([&](auto reply) { return dispatch()->project(wanted, reply); });
  }
  /// As a ROS master does it: a topic is there as long as anybody listens, or sends.
  void serveProjections(int count) {
    types_[text("/d/set_map_projections")] = text("map_msgs/ProjectedMapsInfo");
    const auto send = [this](int number) {
      for (int i = 0; i < 8; ++i) {
        const QString topic = text("/d/projected_map_") + QString::number(i);
        sent_.remove(topic);
        server_->forgetLatched(topic);
        if (i >= number) continue;
        sent_.insert(topic);
        server_->advertise(topic, text("map_msgs/ProjectedMap"));
        server_->latch(topic, projected(i));
      }
    };
    send(count);
    server_->serve(text("/d/set_map_projections"), [send](const QJsonObject& args) {
      send(int(args[text("projected_maps_info")].toArray().size()));
      return QJsonObject{};
    });
    server_->serve(text("/rosapi/publishers"), [this](const QJsonObject& args) {
      const bool sent = sent_.contains(args[text("topic")].toString());
      return QJsonObject{{text("publishers"), sent ? QJsonArray{text("/d")} : QJsonArray()}};
    });
  }
  static std::vector<Projection> wanted(int count) {
    std::vector<Projection> all;
    for (int i = 0; i < count; ++i) all.push_back({"map", {1, 2}, {0.1, 0.05}, double(i), i + 2.0});
    return all;
  }

 private Q_SLOTS:
  void init() {
    server_ = std::make_unique<ScriptedBridge>();
    types_.clear();
    sent_.clear();
    server_->serve(text("/rosapi/service_type"), [this](const QJsonObject& args) {
      return QJsonObject{{text("type"), types_.value(args[text("service")].toString())}};
    });
    make();
  }
  void cleanup() {
    robot_.reset();
    server_.reset();
  }

  void fewerProjectionsAreFewerAtOnce_data() {
    QTest::addColumn<bool>("tells_who_sends");
    QTest::newRow("rosapi tells who sends") << true;
    QTest::newRow("it does not") << false;
  }
  void fewerProjectionsAreFewerAtOnce() {
    QFETCH(bool, tells_who_sends);
    serveProjections(3);
    if (!tells_who_sends) server_->withdraw(text("/rosapi/publishers"));
    QVERIFY(begin());
    QTRY_COMPARE_WITH_TIMEOUT(dispatch()->projected().size(), std::size_t(3), kPatienceMs);
    const auto two = askProject(wanted(2));
    QVERIFY(two);
    QCOMPARE(two->size(), std::size_t(2));
    QTRY_COMPARE_WITH_TIMEOUT(dispatch()->projected().size(), std::size_t(2), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(!server_->isAskedFor("/d/projected_map_2"), kPatienceMs);
    const auto none = askProject({});
    QVERIFY(none && none->empty());
    QTRY_VERIFY_WITH_TIMEOUT(dispatch()->projected().empty(), kPatienceMs);
    const auto three = askProject(wanted(3));
    QVERIFY(three);
    QCOMPARE(three->size(), std::size_t(3));
  }

  void whatASetListHasLeftIsNotListedAgain() {
    serveProjections(3);
    // A dispatcher that goes on sending what it sent last.
    server_->serve(text("/d/set_map_projections"), [](const QJsonObject&) { return QJsonObject{}; });
    QVERIFY(begin());
    QTRY_COMPARE_WITH_TIMEOUT(dispatch()->projected().size(), std::size_t(3), kPatienceMs);
    QCOMPARE(askProject(wanted(2))->size(), std::size_t(2));
    QCOMPARE(askProjections()->size(), std::size_t(2));
    QVERIFY(dispatch()->silent().empty());
    // Until it says something else.
    server_->latch(text("/d/projected_map_2"), projected(7));
    QTRY_COMPARE_WITH_TIMEOUT(dispatch()->projected().size(), std::size_t(3), kPatienceMs);
  }

  void aTopicThatNobodySendsByIsNoProjection() {
    serveProjections(2);
    QVERIFY(begin());
    QTRY_COMPARE_WITH_TIMEOUT(dispatch()->projected().size(), std::size_t(2), kPatienceMs);
    sent_.remove(text("/d/projected_map_1"));  // set by somebody else
    QTRY_COMPARE_WITH_TIMEOUT(dispatch()->projected().size(), std::size_t(1), kPatienceMs);
    QCOMPARE(askProjections()->size(), std::size_t(1));
    QTRY_VERIFY_WITH_TIMEOUT(!server_->isAskedFor("/d/projected_map_1"), kPatienceMs);
    sent_.insert(text("/d/projected_map_1"));
    QTRY_COMPARE_WITH_TIMEOUT(dispatch()->projected().size(), std::size_t(2), kPatienceMs);
  }

  void aProjectedMapThatStaysSilentIsNamed() {
    serveProjections(1);
    server_->advertise(text("/d/projected_map_1"), text("map_msgs/ProjectedMap"));
    sent_.insert(text("/d/projected_map_1"));
    QVERIFY(begin());
    const auto told = askProjections();
    QVERIFY(told);
    QCOMPARE(told->size(), std::size_t(1));
    QCOMPARE(dispatch()->silent(), std::vector<std::string>{"/d/projected_map_1"});
    server_->latch(text("/d/projected_map_1"), projected(3));
    QTRY_COMPARE_WITH_TIMEOUT(dispatch()->projected().size(), std::size_t(2), kPatienceMs);
    QCOMPARE(askProjections()->size(), std::size_t(2));
    QVERIFY(dispatch()->silent().empty());
  }

  void theFrameOfTheMapIsSentWhereNoneIsNamed_data() {
    QTest::addColumn<bool>("map_asked");
    QTest::addColumn<int>("projected_before");
    QTest::addColumn<QString>("frame");
    QTest::newRow("of the map") << true << 1 << text("map_b");
    QTest::newRow("of what is projected") << false << 1 << text("level_2");
    QTest::newRow("not known") << false << 0 << text("map");
  }
  void theFrameOfTheMapIsSentWhereNoneIsNamed() {
    QFETCH(bool, map_asked);
    QFETCH(int, projected_before);
    QFETCH(QString, frame);
    serveProjections(projected_before);
    serve("/d/get_sub_map", "map_msgs/GetMapROI", {{text("sub_map"), grid("map_b")}});
    if (projected_before > 0) server_->latch(text("/d/projected_map_0"), projected(0, "level_2"));
    QVERIFY(begin());
    if (map_asked) {
      QVERIFY(outcome<map::GridPart>([&](auto reply) {
        return dispatch()->grid(map::GridRegion{{3, 4}, {10, 20}}, reply);
      }));
    }
    std::vector<Projection> without = wanted(2);
    without[0].frame.clear();
    without[1].frame = "own";
    QVERIFY(askProject(without));
    const QJsonArray sent =
        server_->argumentsOf(text("/d/set_map_projections")).at(0)[text("projected_maps_info")].toArray();
    QCOMPARE(sent[0][text("frame_id")].toString(), frame);
    QCOMPARE(sent[1][text("frame_id")].toString(), text("own"));
  }

  void withoutRosapiProjectedMapsAreFoundByTheirUsualNames() {
    for (const char* service : {"/rosapi/topics", "/rosapi/services", "/rosapi/service_type"})
      server_->withdraw(text(service));
    ros::DispatchSettings wish;
    wish.expected = true;
    wish.ns = "/d";
    make(wish);
    serve("/d/set_map_projections", "", {});
    QVERIFY(begin());
    // Nothing has come, and nobody tells whether there is anything.
    const auto unknown = askProjections();
    QVERIFY(!unknown);
    QCOMPARE(unknown.error().cause.code, robot::fault::ProjectionsNotTold);
    server_->latch(text("/d/projected_map_0"), projected(0));
    server_->latch(text("/d/projected_map_1"), projected(3));
    QTRY_COMPARE_WITH_TIMEOUT(dispatch()->projected().size(), std::size_t(2), kPatienceMs);
    const auto told = askProjections();
    QVERIFY(told);
    QCOMPARE(told->size(), std::size_t(2));
    QVERIFY(dispatch()->silent().empty());
    // What would set something is not asked in order to read it.
    QCOMPARE(server_->timesCalled(text("/d/set_map_projections")), 0);
  }
};

}  // namespace test_ros_projections

MAPWRIGHT_TEST(test_ros_projections, RosProjectionsTest, Core)
#include "test_ros_projections.moc"
