// A ROS robot behind a scripted rosbridge server: what it is asked for, and what comes of it.
#include <QSignalSpy>
#include <QTest>

#include "robot/faults.h"
#include "robot/map_administration.h"
#include "robot/ros/faults.h"
#include "robot/ros/ros_robot.h"
#include "scripted_bridge.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "test_program.h"

namespace test_ros_robot {

using namespace mapwright;
using namespace mapwright::robot;
using map::Stream;
using ros::RosRobot;
using std::chrono::milliseconds;
using testing::ScriptedBridge;

namespace {

QJsonObject json(const QByteArray& text) {
  const QJsonDocument document = QJsonDocument::fromJson(text);
  if (!document.isObject()) qFatal("a test writes what is no JSON");
  return document.object();
}

QString text(const char* latin) { return QString::fromLatin1(latin); }

const QByteArray kUpright = R"({"x":0,"y":0,"z":0,"w":1})";

QJsonObject grid(int cell = 0) {
  return json(
      R"({"header":{"frame_id":"map","stamp":{"secs":5,"nsecs":0}},"info":{"resolution":0.05,"width":2,)"
      R"("height":1,"origin":{"position":{"x":1,"y":2,"z":0},"orientation":)" +
      kUpright + R"(}},"data":[)" + QByteArray::number(cell) + ",100]}");
}

QJsonObject tf(const char* parent, const char* child, double x) {
  return json(R"({"transforms":[{"header":{"frame_id":")" + QByteArray(parent) +
              R"(","stamp":{"secs":5,"nsecs":0}},"child_frame_id":")" + child +
              R"(","transform":{"translation":{"x":)" + QByteArray::number(x) +
              R"(,"y":0,"z":0},"rotation":)" + kUpright + "}}]}");
}

QByteArray waypoint(const char* id, const char* name, double x, const char* map = "m1") {
  return R"({"id":")" + QByteArray(id) + R"(","name":")" + name +
         R"(","frame_id":"map","waypoint_tags":["a"],"map_id":")" + map + R"(","pose":{"position":{"x":)" +
         QByteArray::number(x) + R"(,"y":0,"z":0},"orientation":)" + kUpright + "}}";
}

QJsonObject waypoints(const QByteArrayList& rows) {
  return json(R"({"waypoints":[)" + rows.join(',') + "]}");
}

template <typename T, typename Ask>
Outcome<T> answerTo(Ask ask) {
  std::optional<Outcome<T>> answer;
  const Call call = ask([&](Outcome<T> given) { answer = std::move(given); });
  if (!QTest::qWaitFor([&] { return answer.has_value(); }, 30'000))
    return tl::make_unexpected(map::Failure{.subject = "test", .detail = "no answer"});
  return *answer;
}

}  // namespace

}  // namespace test_ros_robot

namespace test_ros_robot {  // opened again: moc loses count of the braces in raw strings above

class RosRobotTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<ScriptedBridge> server_;
  std::unique_ptr<RosRobot> robot_;
  std::vector<map::StampedMessage> messages_;
  std::vector<map::Problem> problems_;
  std::vector<map::Recovery> recoveries_;
  QByteArrayList held_;

  void makeRobot(const std::function<void(ros::LinkOptions&)>& change = {}) {
    ros::LinkOptions options;
    options.url = server_->url();
    options.look_every = milliseconds(50);
    options.look_timeout = milliseconds(20'000);
    options.topics = {milliseconds(60), milliseconds(120), milliseconds(10)};
    options.kabam.confirm = milliseconds(400);
    options.kabam.topic = milliseconds(100);
    options.kabam.look_again = milliseconds(10);
    options.client.link.backoff_first = milliseconds(5);
    options.client.link.backoff_limit = milliseconds(20);
    if (change) change(options);
    robot_ = std::make_unique<RosRobot>(QStringLiteral("ros+test"), options);
    messages_.clear();
    problems_.clear();
    recoveries_.clear();
    connect(robot_.get(), &Robot::topicReceived, this,
            [this](const map::StampedMessage& message) { messages_.push_back(message); });
    connect(robot_.get(), &Robot::problemFound, this,
            [this](const map::Problem& problem) { problems_.push_back(problem); });
    connect(robot_.get(), &Robot::recovered, this,
            [this](const map::Recovery& recovery) { recoveries_.push_back(recovery); });
  }
  bool online() {
    robot_->connectToRobot();
    return QTest::qWaitFor([&] { return isIn(ConnectionPhase::Online); }, 30'000);
  }
  bool isIn(ConnectionPhase phase) const { return robot_->connection().phase == phase; }
  void want(const map::Streams& streams, const QStringList& topics = {}) {
    robot_->liveTopics()->setWanted(streams, topics);
  }
  template <typename T>
  const T* last() const {
    for (auto message = messages_.rbegin(); message != messages_.rend(); ++message) {
      if (const T* const found = std::get_if<T>(&message->message)) return found;
    }
    return nullptr;
  }
  const map::Problem* problemOf(const char* topic, map::ProblemCode code) const {
    for (const map::Problem& problem : problems_) {
      if (problem.subject == map::Subject(map::SubjectKind::Topic, topic) && problem.code == code)
        return &problem;
    }
    return nullptr;
  }
  bool isWell(const char* topic) const {
    return std::any_of(recoveries_.begin(), recoveries_.end(), [&](const map::Recovery& recovery) {
      return recovery.subject == map::Subject(map::SubjectKind::Topic, topic);
    });
  }
  /// A map manager with two maps and two waypoints on the first.
  void manage() {
    const auto topic = [&](const char* name, const char* type, const QJsonObject& msg) {
      server_->advertise(text("/map_manager/") + QLatin1String(name),
                         text("kabam_msgs/") + QLatin1String(type));
      server_->latch(text("/map_manager/") + QLatin1String(name), msg);
    };
    topic("current_map_info", "MapInfo",
          json(R"({"map_id":"m1","map_name":"one","map_label":"One","map_manager_state":"ACTIVE"})"));
    topic("map_list", "MapList",
          json(R"({"maps":[{"map_id":"m1","map_name":"one","map_label":"One"},)"
               R"({"map_id":"m2","map_name":"two","map_label":"Two"}]})"));
    topic("archived_map_list", "MapList", json(R"({"maps":[]})"));
    hold({waypoint("w1", "Dock", 1), waypoint("w2", "Desk", 2)});
    topic("current_map_waypoints", "MapWaypointList", waypoints(held_));
    for (const char* name : {"load_map", "rename_map", "create_waypoint", "delete_waypoint",
                             "rename_waypoint", "reposition_waypoint"}) {
      server_->serve(text("/map_manager/") + QLatin1String(name),
                     [](const QJsonObject&) { return json(R"({"result":6})"); });
    }
    serve("get_waypoint", [this](const QJsonObject& args) {
      const QJsonObject all = waypoints(held_);
      const QString id = args[text("waypoint_id")].toString();
      QJsonArray asked;
      for (const QJsonValue& row : all[text("waypoints")].toArray()) {
        if (id.isEmpty() || row[text("id")].toString() == id) asked << row;
      }
      return QJsonObject{{text("waypoints"), QJsonObject{{text("waypoints"), asked}}}};
    });
  }
  /// What the manager answers; the topic has not shown it yet.
  void hold(const QByteArrayList& rows) { held_ = rows; }
  void serve(const char* name, ScriptedBridge::Service service) {
    server_->serve(text("/map_manager/") + QLatin1String(name), std::move(service));
  }
  void showWaypoints(const QByteArrayList& rows) {
    hold(rows);
    server_->latch(QStringLiteral("/map_manager/current_map_waypoints"), waypoints(rows));
  }
  Outcome<StoredWaypoints> read(const char* id = "m1") {
    return answerTo<StoredWaypoints>([&](auto reply) {
      return robot_->waypointStore()->read({map::MapKind::Stored, id}, reply);
    });
  }
  Outcome<WaypointReceipt> perform(const WaypointChange& change, const char* id = "m1") {
    return answerTo<WaypointReceipt>([&](auto reply) {
      return robot_->waypointStore()->perform({map::MapKind::Stored, id}, {{change}, "r"}, reply);
    });
  }
  /// The waypoint as it is kept now.
  map::Waypoint kept(const char* id) {
    const auto stored = read();
    for (const map::Waypoint& point : stored->points) {
      if (point.id == id) return point;
    }
    return {};
  }

  Call order(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) {
    return robot_->mapAdministration()->carryOut(order, std::move(reply));
  }

 private Q_SLOTS:
  void init() {
    server_ = std::make_unique<ScriptedBridge>();
    server_->advertise(QStringLiteral("/map"), QStringLiteral("nav_msgs/OccupancyGrid"));
    server_->advertise(QStringLiteral("/tf"), QStringLiteral("tf2_msgs/TFMessage"));
    server_->latch(QStringLiteral("/map"), grid());
    makeRobot();
  }
  void cleanup() {
    robot_.reset();
    server_.reset();
  }

  void itIsOnlineOnceItIsKnownWhatThereIs() {
    QVERIFY(online());
    QVERIFY(server_->timesCalled(QStringLiteral("/rosapi/topics")) >= 1);
    QVERIFY(robot_->liveTopics()->known().contains(QLatin1String("/map")));
    QVERIFY(!robot_->waypointStore() && !robot_->mapAdministration());
    const QString why = sentences::absenceReason(Capability::WaypointEditing,
                                                 robot_->unavailableReason(Capability::WaypointEditing));
    QVERIFY2(why.contains(QLatin1String("KABAM")), qPrintable(why));
    robot_->disconnectFromRobot();
    QTRY_VERIFY(isIn(ConnectionPhase::Offline));
  }

  void onlyWhatIsWantedIsAskedFor() {
    server_->advertise(QStringLiteral("/scan"), QStringLiteral("sensor_msgs/LaserScan"));
    robot_->liveTopics()->setBasics({false, false, false});
    QVERIFY(online());
    want({Stream::WholeMap});
    QTRY_VERIFY(server_->isAskedFor("/map"));
    QVERIFY(!server_->isAskedFor("/tf") && !server_->isAskedFor("/scan"));
    want({Stream::Cloud});  // which lies somewhere else than the robot's own frame
    QTRY_VERIFY(server_->isAskedFor("/scan") && server_->isAskedFor("/tf"));
    QTRY_VERIFY(!server_->isAskedFor("/map"));
  }

  void whoeverRecordsGetsEveryMessage() {
    server_->advertise(text("/scan"), text("sensor_msgs/LaserScan"));
    server_->advertise(text("/odom"), text("nav_msgs/Odometry"));
    makeRobot();
    want({Stream::Cloud, Stream::Pose}, {text("/chatter")});
    QVERIFY(online());
    const auto throttled = [&](const char* topic) {
      return server_->subscriptionOf(QLatin1String(topic)).contains(QLatin1String("throttle_rate"));
    };
    const QList<const char*> topics{"/scan", "/odom", "/chatter"};
    for (const char* topic : topics) QTRY_VERIFY2(server_->isAskedFor(topic) && throttled(topic), topic);
    robot_->setDeliveryTap([](const Delivery&) {});
    for (const char* topic : topics) QTRY_VERIFY2(server_->isAskedFor(topic) && !throttled(topic), topic);
    // What is wanted only now is no exception.
    want({Stream::Cloud, Stream::Pose}, {text("/chatter"), text("/more")});
    QTRY_VERIFY(server_->isAskedFor("/more") && !throttled("/more"));
    robot_->setDeliveryTap({});
    for (const char* topic : topics) QTRY_VERIFY2(server_->isAskedFor(topic) && throttled(topic), topic);
  }

  void theMapComesCompressedAndIsExact() {
    QVERIFY(online());
    want({Stream::WholeMap});
    QTRY_VERIFY(last<map::GridMessage>());
    QCOMPARE(server_->subscriptionOf(QStringLiteral("/map"))[QLatin1String("compression")].toString(),
             QStringLiteral("cbor"));
    QCOMPARE(server_->subscriptionOf(QStringLiteral("/map"))[QLatin1String("type")].toString(),
             QStringLiteral("nav_msgs/OccupancyGrid"));
    const map::GridMessage& map = *last<map::GridMessage>();
    QCOMPARE(map.grid.origin, (geometry::Pose2{1, 2, 0}));
    QCOMPARE(*map.png, std::string("P5\n2 1\n255\n") + '\0' + 'd');
  }

  void aMapThatIsLostInCompressionIsAskedForPlain() {
    server_->lost_in_cbor << QStringLiteral("/map");
    QVERIFY(online());
    want({Stream::WholeMap});
    QTRY_VERIFY(last<map::GridMessage>());
    QVERIFY(server_->subscriptionOf(QStringLiteral("/map"))[QLatin1String("compression")].toString() !=
            QLatin1String("cbor"));
  }

  void withoutRosapiTheUsualNamesAreAskedFor() {
    server_->withdraw(QStringLiteral("/rosapi/topics"));
    server_->withdraw(QStringLiteral("/rosapi/services"));
    QVERIFY(online());
    want({Stream::WholeMap, Stream::Path});
    QTRY_VERIFY(last<map::GridMessage>());
    QTRY_VERIFY(server_->isAskedFor("/plan") && server_->isAskedFor("/move_base/NavfnROS/plan"));
    QVERIFY(!server_->subscriptionOf(QStringLiteral("/plan")).contains(QLatin1String("type")));
    // Of a stream that may come by several topics one is told of.
    QTRY_VERIFY(problemOf("/move_base/NavfnROS/plan", map::ProblemCode::Unavailable) ||
                problemOf("/plan", map::ProblemCode::Unavailable));
    QVERIFY(!problemOf("/map", map::ProblemCode::Unavailable));
  }

  void aSilentTopicIsWaitedForAndSaysWhy() {
    server_->advertise(QStringLiteral("/quiet"), QStringLiteral("x/Y"));
    server_->serve(QStringLiteral("/rosapi/publishers"),
                   [](const QJsonObject&) { return json(R"({"publishers":[]})"); });
    QVERIFY(online());
    want({}, {QStringLiteral("/quiet"), QStringLiteral("/nowhere")});
    QTRY_VERIFY(problemOf("/quiet", map::ProblemCode::Unavailable));
    QTRY_VERIFY(problemOf("/nowhere", map::ProblemCode::Unavailable));
    QCOMPARE(problemOf("/quiet", map::ProblemCode::Unavailable)->reason.because.front().code,
             robot::ros::fault::TopicNobodySends);
    QCOMPARE(problemOf("/nowhere", map::ProblemCode::Unavailable)->reason.because.front().code,
             robot::ros::fault::TopicNotListed);
    server_->send(QStringLiteral("/quiet"), json(R"({"data":1})"));
    QTRY_VERIFY(isWell("/quiet"));
    want({});
    QTRY_VERIFY(isWell("/nowhere"));  // nobody waits for it any more
  }

  void aSubscriptionThatTheServerRefusesSaysWhatItSaid() {
    server_->advertise(QStringLiteral("/quiet"), QStringLiteral("x/Y"));
    QVERIFY(online());
    want({}, {QStringLiteral("/quiet")});
    QTRY_VERIFY(server_->isAskedFor("/quiet"));
    server_->refuse(QStringLiteral("/quiet"), QStringLiteral("Unable to load the manifest for package x."));
    QTRY_VERIFY(problemOf("/quiet", map::ProblemCode::Unavailable));
    QCOMPARE(problemOf("/quiet", map::ProblemCode::Unavailable)->reason.because.front(),
             Fault(robot::fault::ItAnswered, {"Unable to load the manifest for package x."}));
  }

  void whatCameAllTheTimeAndStopsIsTold() {
    server_->advertise(QStringLiteral("/odom"), QStringLiteral("nav_msgs/Odometry"));
    server_->serve(QStringLiteral("/rosapi/publishers"),
                   [](const QJsonObject&) { return json(R"({"publishers":["/dead"]})"); });
    QVERIFY(online());
    QTRY_VERIFY(server_->isAskedFor("/odom"));
    const auto drive = [this](int times) {
      for (int i = 0; i < times; ++i) server_->send(QStringLiteral("/odom"), json(R"({"pose":{}})"));
    };
    drive(20);
    QTRY_VERIFY(problemOf("/odom", map::ProblemCode::Unavailable));
    const map::Problem silent = *problemOf("/odom", map::ProblemCode::Unavailable);
    QCOMPARE(silent.reason, Fault(robot::ros::fault::TopicSilent));
    QCOMPARE(silent.severity, map::Severity::Warning);
    recoveries_.clear();
    drive(1);
    QTRY_VERIFY(isWell("/odom"));
  }

  void topicsThatComeLaterAreFound() {
    QVERIFY(online());
    want({Stream::CostmapHigh});
    QSignalSpy changed(robot_.get(), &Robot::capabilitiesChanged);
    const QString topic = QStringLiteral("/local_costmap/costmap");
    QVERIFY(robot_->liveTopics()->topicsOf(Stream::CostmapHigh).isEmpty());
    server_->advertise(topic, QStringLiteral("nav_msgs/OccupancyGrid"));
    server_->latch(topic, grid(99));
    QTRY_VERIFY(last<map::GridMessage>() && last<map::GridMessage>()->kind == map::GridKind::CostmapHigh);
    QVERIFY(!changed.isEmpty());
    QCOMPARE(robot_->liveTopics()->topicsOf(Stream::CostmapHigh), QStringList{topic});
  }

  void aLayerIsTakenFromTheTopicThatPeopleChoose() {
    const auto path = [](double x) {
      const QByteArray header = R"("header":{"frame_id":"map","stamp":{"secs":5,"nsecs":0}})";
      return json("{" + header + R"(,"poses":[{)" + header + R"(,"pose":{"position":{"x":)" +
                  QByteArray::number(x) + R"(,"y":0,"z":0},"orientation":)" + kUpright + "}}]}");
    };
    for (const char* const name : {"/plan", "/other/way"})
      server_->advertise(text(name), QStringLiteral("nav_msgs/Path"));
    server_->latch(QStringLiteral("/plan"), path(1));
    server_->latch(QStringLiteral("/other/way"), path(2));
    server_->advertise(QStringLiteral("/semantic"), QStringLiteral("nav_msgs/OccupancyGrid"));
    server_->latch(QStringLiteral("/semantic"), grid(42));
    QVERIFY(online());
    want({Stream::Path, Stream::CostmapLow});
    QTRY_VERIFY(last<map::PathMessage>() && last<map::PathMessage>()->points.size() == 1);
    QCOMPARE(robot_->choicesFor(Stream::Path), (QStringList{text("/other/way"), text("/plan")}));
    QCOMPARE(robot_->choicesFor(Stream::CostmapLow), (QStringList{text("/map"), text("/semantic")}));
    QVERIFY(robot_->choicesFor(Stream::Cloud).isEmpty());
    robot_->choose({{Stream::Path, text("/other/way")}, {Stream::CostmapLow, text("/semantic")}});
    QTRY_VERIFY(last<map::PathMessage>()->points == map::Polyline{Eigen::Vector2d(2, 0)});
    QTRY_VERIFY(!server_->isAskedFor("/plan"));
    QTRY_VERIFY(last<map::GridMessage>() && last<map::GridMessage>()->topic == "/semantic");
    QCOMPARE(robot_->liveTopics()->topicsOf(Stream::Path), QStringList{text("/other/way")});
    robot_->choose({});
    QTRY_VERIFY(last<map::PathMessage>()->points == map::Polyline{Eigen::Vector2d(1, 0)});
    // Chosen while it is away, it is waited for; the path of the topic before does not stay.
    robot_->choose({{Stream::Path, text("/to/come")}});
    QTRY_VERIFY(last<map::PathMessage>()->points.empty());
    QTRY_VERIFY(server_->isAskedFor("/to/come"));
    server_->send(QStringLiteral("/to/come"), path(3));
    QTRY_VERIFY(last<map::PathMessage>()->points == map::Polyline{Eigen::Vector2d(3, 0)});
  }

  void howMessagesArriveIsCounted() {
    server_->advertise(QStringLiteral("/odom"), QStringLiteral("nav_msgs/Odometry"));
    QVERIFY(online());
    QTRY_VERIFY(server_->isAskedFor("/odom"));
    const double now_s = double(QDateTime::currentMSecsSinceEpoch()) / 1000;
    const auto odometry = [](double stamp_s) {
      const auto whole = qint64(stamp_s);
      return json(
          R"({"header":{"frame_id":"odom","stamp":{"secs":)" + QByteArray::number(whole) +
          R"(,"nsecs":0}},"child_frame_id":"base_link","pose":{"pose":{"position":{"x":0,"y":0,"z":0},)"
          R"("orientation":)" +
          kUpright + "}}}");
    };
    server_->send(QStringLiteral("/odom"), odometry(now_s));
    server_->send(QStringLiteral("/odom"), odometry(now_s - 60));
    server_->send(QStringLiteral("/tf"), tf("map", "odom", 1));
    QTRY_VERIFY(robot_->reception() && robot_->reception()->came >= 3);
    QTRY_COMPARE(robot_->reception()->late, 1);
    QTRY_COMPARE(robot_->reception()->transforms.size(), std::size_t(1));
    QCOMPARE(robot_->reception()->transforms.front().child, text("odom"));
  }

  void whereTheRobotIsIsTold() {
    QVERIFY(online());
    QTRY_VERIFY(server_->isAskedFor("/tf"));
    server_->send(QStringLiteral("/tf"), tf("map", "odom", 1));
    server_->send(QStringLiteral("/tf"), tf("odom", "base_link", 2));
    QTRY_VERIFY(last<map::TrackedPose>() && last<map::TrackedPose>()->pose.x_m == 3);
    // Not more often than it can be drawn.
    const auto before = messages_.size();
    for (int i = 0; i < 200; ++i) server_->send(QStringLiteral("/tf"), tf("odom", "base_link", 2 + i * 0.01));
    QTRY_COMPARE(last<map::TrackedPose>()->pose.x_m, 3 + 1.99);
    QVERIFY(messages_.size() - before < 100);
  }

  void eachOfSeveralRobotsIsPlacedByItself_data() {
    QTest::addColumn<QString>("ns");
    QTest::newRow("all") << QString();
    QTest::newRow("the first") << QStringLiteral("/r1");
    QTest::newRow("the second") << QStringLiteral("/r2");
  }
  void eachOfSeveralRobotsIsPlacedByItself() {
    QFETCH(QString, ns);
    server_->forget(QStringLiteral("/tf"));
    server_->forget(QStringLiteral("/tf_static"));
    for (const char* const robot : {"/r1", "/r2"}) {
      const QString name = text(robot);
      server_->advertise(name + QStringLiteral("/tf"), QStringLiteral("tf2_msgs/TFMessage"));
      server_->advertise(name + QStringLiteral("/scan"), QStringLiteral("sensor_msgs/LaserScan"));
      const double place = name == QLatin1String("/r1") ? -2 : 2;
      server_->latch(name + QStringLiteral("/tf"), tf("map", "base_link", place));
      server_->latch(name + QStringLiteral("/scan"),
                     json(R"({"header":{"frame_id":"base_link","stamp":{"secs":5,"nsecs":0}},"angle_min":0,)"
                          R"("angle_increment":1,"range_min":0,"range_max":9,"ranges":[1]})"));
    }
    makeRobot([&](ros::LinkOptions& options) { options.ns = ns.toStdString(); });
    QVERIFY(online());
    want({Stream::Cloud});
    const auto hit = [&](const char* topic) -> std::optional<double> {
      std::optional<double> x_m;
      for (const map::StampedMessage& message : messages_) {
        const auto* const cloud = std::get_if<map::PointCloudMessage>(&message.message);
        if (cloud && cloud->topic == topic && !cloud->points->empty()) x_m = cloud->points->front().x_m;
      }
      return x_m;
    };
    for (const auto& [robot, place] : {std::pair{"/r1", -1.0}, std::pair{"/r2", 3.0}}) {
      const std::string scan = std::string(robot) + "/scan";
      if (!ns.isEmpty() && ns != text(robot)) {
        QVERIFY(!server_->isAskedFor(scan.c_str()) && !hit(scan.c_str()));
        continue;
      }
      QTRY_VERIFY(hit(scan.c_str()));
      QCOMPARE(*hit(scan.c_str()), place);
    }
    QTRY_VERIFY(last<map::TrackedPose>());
    QCOMPARE(last<map::TrackedPose>()->pose.x_m, ns == QLatin1String("/r2") ? 2 : -2);
    const bool told = std::any_of(problems_.begin(), problems_.end(), [](const map::Problem& problem) {
      return problem.reason.code == ros::fault::RosSeveralRobots;
    });
    QCOMPARE(told, ns.isEmpty());
  }

  void whatHasNoPlaceIsToldUntilItHas() {
    server_->advertise(QStringLiteral("/local_plan"), QStringLiteral("nav_msgs/Path"));
    const QByteArray header = R"("header":{"frame_id":"odom","stamp":{"secs":5,"nsecs":0}})";
    server_->latch(QStringLiteral("/local_plan"),
                   json("{" + header + R"(,"poses":[{)" + header +
                        R"(,"pose":{"position":{"x":1,"y":0,"z":0},"orientation":)" + kUpright + "}}]}"));
    QVERIFY(online());
    want({Stream::LocalPath});
    QTRY_VERIFY(problemOf("/local_plan", map::ProblemCode::Unplaced));
    server_->send(QStringLiteral("/tf"), tf("map", "odom", 10));
    QTRY_VERIFY(last<map::LocalPathMessage>());
    QCOMPARE(last<map::LocalPathMessage>()->points.front().x(), 11.0);
    QTRY_VERIFY(isWell("/local_plan"));
  }

  void whatCannotBeReadIsTold() {
    server_->latch(QStringLiteral("/map"), json(R"({"data":"text"})"));
    QVERIFY(online());
    want({Stream::WholeMap});
    QTRY_VERIFY(problemOf("/map", map::ProblemCode::Unreadable));
    server_->latch(QStringLiteral("/map"), grid());
    QTRY_VERIFY(isWell("/map"));
  }

  void anyTopicCanBeWatched() {
    server_->latch(QStringLiteral("/anything"), json(R"({"data":"<b>x"})"));
    QSignalSpy raw(robot_.get(), &Robot::rawReceived);
    robot_->liveTopics()->setWatching(true);
    std::atomic<int> frames{0};
    robot_->liveTopics()->setTap([&](const RawFrame&) { ++frames; });
    QVERIFY(online());
    want({}, {QStringLiteral("/anything")});
    QTRY_VERIFY(!raw.isEmpty());
    const auto message = raw.first().first().value<RawMessage>();
    QCOMPARE(message.topic, QStringLiteral("/anything"));
    QVERIFY(message.text.contains("<b>x"));
    QVERIFY(frames > 0);
    robot_->liveTopics()->setTap({});
  }

  void afterALossAllIsAskedForAgain() {
    QVERIFY(online());
    want({Stream::WholeMap});
    QTRY_VERIFY(last<map::GridMessage>());
    messages_.clear();
    server_->cut();
    QTRY_VERIFY(last<map::GridMessage>());
    QVERIFY(isIn(ConnectionPhase::Online));
  }

  void theOnlyMapIsTheLiveOne() {
    QVERIFY(online());
    const auto entries = answerTo<std::vector<map::CatalogueEntry>>(
        [&](auto reply) { return robot_->mapCatalogue()->list(reply); });
    QVERIFY(entries && entries->size() == 1);
    QVERIFY(entries->front().key.kind == map::MapKind::Live && entries->front().is_current);
    const auto whole = answerTo<map::WholeMap>([&](auto reply) {
      return robot_->wholeMapSource()->fetch({map::MapKind::Live, {}}, reply);
    });
    QVERIFY(whole && whole->reading.mode == map::CellReading::Mode::Raw);
    const auto other = answerTo<map::WholeMap>([&](auto reply) {
      return robot_->wholeMapSource()->fetch({map::MapKind::Stored, "7"}, reply);
    });
    QVERIFY(!other && other.error().kind == map::FailureKind::RejectedByRobot);
  }

  void whoAsksWithoutAConnectionIsTold() {
    const auto entries = answerTo<std::vector<map::CatalogueEntry>>(
        [&](auto reply) { return robot_->mapCatalogue()->list(reply); });
    QVERIFY(!entries);
    QCOMPARE(entries.error().kind, map::FailureKind::Unreachable);
    const QString sentence = QString::fromStdString(sentences::sentenceOf(entries.error()));
    QVERIFY2(sentence.contains(QLatin1String("no connection")), qPrintable(sentence));
  }

  // KABAM.

  void whoInsistsOnAMapManagerWaitsForIt() {
    makeRobot([](ros::LinkOptions& options) { options.kabam_only = true; });
    robot_->connectToRobot();
    QTRY_VERIFY(isIn(ConnectionPhase::Interrupted));
    QVERIFY(robot_->connection().reason.code == robot::ros::fault::NoMapManagerThere);
    QVERIFY(robot_->connection().retry_in_ms);
    const auto entries = answerTo<std::vector<map::CatalogueEntry>>(
        [&](auto reply) { return robot_->mapCatalogue()->list(reply); });
    QVERIFY(!entries && entries.error().kind == map::FailureKind::Unreachable);
    manage();
    QTRY_VERIFY(isIn(ConnectionPhase::Online));  // by itself
    QVERIFY(robot_->waypointStore());
  }

  void aMapManagerThatIsLookedForAgainIsThereAtOnce() {
    makeRobot([](ros::LinkOptions& options) {
      options.kabam_only = true;
      options.look_every = std::chrono::hours(1);
    });
    robot_->connectToRobot();
    QTRY_VERIFY(isIn(ConnectionPhase::Interrupted));
    manage();
    QVERIFY(online());  // retried by hand
  }

  // Nothing is taken away because nothing was heard.

  void aServerThatAnswersNothingForAWhileTakesNothingAway() {
    manage();
    makeRobot([](ros::LinkOptions& options) { options.look_timeout = milliseconds(40); });
    QVERIFY(online());
    QTRY_VERIFY(robot_->waypointStore());
    QVERIFY(read());  // all is told
    QSignalSpy changed(robot_.get(), &Robot::capabilitiesChanged);
    QSignalSpy maps(robot_.get(), &Robot::mapsChanged);
    server_->silent = true;
    const auto looks = server_->timesCalled(QStringLiteral("/rosapi/topics"));
    QTRY_VERIFY(server_->timesCalled(QStringLiteral("/rosapi/topics")) > looks + 3);
    QVERIFY(isIn(ConnectionPhase::Online));
    QVERIFY(robot_->waypointStore() && robot_->mapAdministration());
    QCOMPARE(robot_->identity().model, QStringLiteral("ROS (KABAM)"));
    QVERIFY(changed.isEmpty() && maps.isEmpty());
    server_->silent = false;
  }

  void noneOfItGoesWhileTheNextConnectionIsSilentToo() {
    manage();
    makeRobot([](ros::LinkOptions& options) { options.look_timeout = milliseconds(40); });
    QVERIFY(online());
    QTRY_VERIFY(robot_->waypointStore());
    QSignalSpy changed(robot_.get(), &Robot::capabilitiesChanged);
    server_->silent = true;
    server_->cut();
    QTRY_VERIFY(!isIn(ConnectionPhase::Online));
    const auto looks = server_->timesCalled(QStringLiteral("/rosapi/topics"));
    QTRY_VERIFY(server_->timesCalled(QStringLiteral("/rosapi/topics")) > looks + 3);
    QVERIFY(robot_->waypointStore());
    server_->silent = false;
    const auto after = server_->timesCalled(QStringLiteral("/rosapi/topics"));
    QTRY_VERIFY(server_->timesCalled(QStringLiteral("/rosapi/topics")) > after + 2);
    QTRY_VERIFY(isIn(ConnectionPhase::Online));
    QVERIFY(robot_->waypointStore());
    QVERIFY(changed.isEmpty());
  }

  void aMapManagerWhoseEndIsToldGoes() {
    manage();
    QVERIFY(online());
    QTRY_VERIFY(robot_->waypointStore());
    for (const char* name : {"current_map_info", "map_list", "archived_map_list", "current_map_waypoints"})
      server_->forget(text("/map_manager/") + QLatin1String(name));
    server_->withdraw(QStringLiteral("/map_manager/load_map"));
    QTRY_VERIFY(!robot_->waypointStore());
  }

  void aTopicThatTheServerDidNotKnowYetIsAskedForAgain() {
    server_->withdraw(QStringLiteral("/rosapi/topics"));
    server_->withdraw(QStringLiteral("/rosapi/services"));
    makeRobot([](ros::LinkOptions& options) { options.topics.again = milliseconds(30); });
    QVERIFY(online());
    want({Stream::WholeMap});
    QTRY_VERIFY(server_->isAskedFor("/map"));
    server_->keep(QStringLiteral("/map"), grid());  // to who asks from now on
    QTRY_VERIFY(last<map::GridMessage>());
  }

  void aMapManagerWithoutRosapiIsFoundByAsking() {
    server_->withdraw(QStringLiteral("/rosapi/topics"));
    server_->withdraw(QStringLiteral("/rosapi/services"));
    manage();
    makeRobot([](ros::LinkOptions& options) { options.kabam_only = true; });
    QVERIFY(online());
    QVERIFY(robot_->mapAdministration());
  }

  void aMapManagerMayComeAndGo() {
    QVERIFY(online());
    QSignalSpy changed(robot_.get(), &Robot::capabilitiesChanged);
    manage();
    QTRY_VERIFY(robot_->waypointStore());
    QVERIFY(!changed.isEmpty());
    const auto entries = answerTo<std::vector<map::CatalogueEntry>>(
        [&](auto reply) { return robot_->mapCatalogue()->list(reply); });
    QVERIFY(entries && entries->size() == 2);
    QCOMPARE(entries->front().name, std::string("One"));
    QVERIFY(entries->front().is_current);
  }

  void theMapThatItWorksWithIsSentAndNoOther() {
    manage();
    QVERIFY(online());
    const auto fetch = [&](const char* id) {
      return answerTo<map::WholeMap>([&](auto reply) {
        return robot_->wholeMapSource()->fetch({map::MapKind::Stored, id}, reply);
      });
    };
    const auto own = fetch("m1");
    QVERIFY(own && own->key.id == "m1" && own->name == "One");
    const auto other = fetch("m2");
    QVERIFY(!other && other.error().kind == map::FailureKind::Unsupported);
    QVERIFY(!fetch("m3"));
    QTRY_VERIFY(last<map::MapInfo>() && last<map::MapInfo>()->uid == "m1");
  }

  void waypointsAreAskedForAlsoThoseOfTheCurrentMap() {
    manage();
    QVERIFY(online());
    const auto stored = read();
    QVERIFY(stored && stored->points.size() == 2);
    QCOMPARE(server_->timesCalled(QStringLiteral("/map_manager/get_waypoint")), 1);
    serve("get_waypoint", [](const QJsonObject& args) {
      return QJsonObject{{text("waypoints"),
                          waypoints({waypoint("w9", "Far", 9, args[text("map_id")].toString().toUtf8())})}};
    });
    const auto other = read("m2");
    QVERIFY(other && other->points.size() == 1 && other->points.front().name == "Far");
    QVERIFY(!read("m7"));
  }

  // There may be very many: how long that may take is a time of its own.
  void whoAsksForAllWaypointsSaysHowLongThatMayTake() {
    makeRobot([](ros::LinkOptions& options) { options.kabam.read = milliseconds(50); });
    manage();
    serve("get_waypoint", [](const QJsonObject&) { return std::optional<QJsonObject>(); });
    QVERIFY(online());
    const auto stored = read("m2");
    QVERIFY(!stored);
    QCOMPARE(stored.error().kind, map::FailureKind::TimedOut);
  }

  void aChangeIsDoneWhenTheTopicShowsIt() {
    manage();
    serve("reposition_waypoint", [&](const QJsonObject& args) {
      QTimer::singleShot(30, this, [this, args] {
        showWaypoints(
            {QJsonDocument(args[text("waypoint_info")].toObject()).toJson(), waypoint("w2", "Desk", 2)});
      });
      return json(R"({"result":3})");
    });
    QVERIFY(online());
    map::Waypoint before = kept("w1"), after = before;
    after.position_m.x() = 7;
    QSignalSpy changed(robot_->waypointStore(), &WaypointStore::changed);
    const auto receipt = perform({"w1", before, after});
    QVERIFY2(receipt, receipt ? "" : sentences::sentenceOf(receipt.error()).c_str());
    QVERIFY(receipt->ids.empty());
    QVERIFY(!changed.isEmpty());
    const QJsonObject args = server_->argumentsOf(QStringLiteral("/map_manager/reposition_waypoint")).first();
    QCOMPARE(args[text("delete_waypoint")], QJsonValue(false));
    QCOMPARE(args[text("waypoint_info")][text("name")].toString(), QStringLiteral("Dock"));
    QCOMPARE(kept("w1").position_m.x(), 7.0);
  }

  void aChangeThatIsNotShownIsNotConfirmed() {
    manage();
    serve("rename_waypoint", [](const QJsonObject&) { return json(R"({"result":3})"); });
    QVERIFY(online());
    map::Waypoint before = kept("w1"), after = before;
    after.name = "Other";
    const auto receipt = perform({"w1", before, after});
    QVERIFY(!receipt);
    QCOMPARE(receipt.error().cause.code, robot::ros::fault::NotConfirmed);
    QCOMPARE(receipt.error().applied, map::Applied::Maybe);
    QVERIFY(sentences::sentenceOf(receipt.error()).find("not confirmed") != std::string::npos);
  }

  void aCreatedWaypointGetsItsIdFromTheRobot() {
    manage();
    serve("create_waypoint", [&](const QJsonObject& args) {
      QJsonObject made = args[text("waypoint_info")].toObject();
      made[text("id")] = QStringLiteral("theirs");
      showWaypoints({waypoint("w1", "Dock", 1), waypoint("w2", "Desk", 2), QJsonDocument(made).toJson()});
      return QJsonObject{{text("result"), 0}, {text("waypoint_response"), made}};
    });
    QVERIFY(online());
    map::Waypoint fresh;
    fresh.id = "ours";
    fresh.name = "New";
    const auto receipt = perform({"ours", {}, fresh});
    QVERIFY(receipt);
    QCOMPARE(receipt->ids.at("ours"), std::string("theirs"));
    const QJsonObject args = server_->argumentsOf(QStringLiteral("/map_manager/create_waypoint")).first();
    QCOMPARE(args[text("waypoint_info")][text("id")].toString(), QString());
  }

  void aRefusalSaysWhyAndChangesNothing() {
    manage();
    serve("rename_waypoint", [](const QJsonObject&) { return json(R"({"result":2})"); });
    QVERIFY(online());
    map::Waypoint before = kept("w1"), after = before;
    after.name = "Desk";
    const auto receipt = perform({"w1", before, after});
    QVERIFY(!receipt);
    QCOMPARE(receipt.error().robot_code, std::string("2"));
    QCOMPARE(receipt.error().applied, map::Applied::No);
    QVERIFY(sentences::sentenceOf(receipt.error()).find("Desk") != std::string::npos);
  }

  void whatSomebodyElseHasChangedIsAConflict() {
    manage();
    QVERIFY(online());
    map::Waypoint before = kept("w1"), after = before;
    after.position_m.y() = 3;
    showWaypoints({waypoint("w1", "Dock", 4), waypoint("w2", "Desk", 2)});
    QTRY_COMPARE(kept("w1").position_m.x(), 4.0);
    const auto receipt = perform({"w1", before, after});
    QVERIFY(!receipt);
    QCOMPARE(receipt.error().kind, map::FailureKind::Conflict);
    QCOMPARE(server_->timesCalled(QStringLiteral("/map_manager/reposition_waypoint")), 0);
  }

  // The topic may lag: what it tells is no proof of how a waypoint is kept.
  void whatTheTopicDoesNotShowYetIsNotWrittenOver() {
    manage();
    QVERIFY(online());
    const map::Waypoint before = kept("w1");
    map::Waypoint moved = before, renamed = before;
    moved.position_m.y() = 3;
    renamed.name = "Berth";
    hold({waypoint("w1", "Dock", 4), waypoint("w2", "Desk", 2)});
    for (const WaypointChange& change :
         {WaypointChange{"w1", before, moved}, WaypointChange{"w1", before, renamed},
          WaypointChange{"w1", before, std::nullopt}}) {
      const auto receipt = perform(change);
      QVERIFY(!receipt);
      QCOMPARE(receipt.error().kind, map::FailureKind::Conflict);
      QCOMPARE(receipt.error().applied, map::Applied::No);
    }
    for (const char* service : {"reposition_waypoint", "rename_waypoint", "delete_waypoint"})
      QCOMPARE(server_->timesCalled(text("/map_manager/") + QLatin1String(service)), 0);
    // From now on the manager is asked how they are.
    QCOMPARE(kept("w1").position_m.x(), 4.0);
  }

  void aChangeThatTheTopicDoesNotShowIsAskedFor() {
    manage();
    serve("rename_waypoint", [&](const QJsonObject& args) {
      hold({QJsonDocument(args[text("waypoint_info")].toObject()).toJson(), waypoint("w2", "Desk", 2)});
      return json(R"({"result":3})");
    });
    serve("delete_waypoint", [&](const QJsonObject&) {
      hold({waypoint("w2", "Desk", 2)});
      return json(R"({"result":5})");
    });
    QVERIFY(online());
    const map::Waypoint before = kept("w1");
    map::Waypoint after = before;
    after.name = "Other";
    const auto receipt = perform({"w1", before, after});
    QVERIFY2(receipt, receipt ? "" : sentences::sentenceOf(receipt.error()).c_str());
    QCOMPARE(kept("w1").name, std::string("Other"));
    QVERIFY(perform({"w1", after, std::nullopt}));
    QCOMPARE(kept("w1").name, std::string());
  }

  void whatIsNotUnderstoodOfAWaypointGoesBackAsItIsNow() {
    manage();
    serve("rename_waypoint", [&](const QJsonObject& args) {
      showWaypoints(
          {QJsonDocument(args[text("waypoint_info")].toObject()).toJson(), waypoint("w2", "Desk", 2)});
      return json(R"({"result":3})");
    });
    QVERIFY(online());
    const map::Waypoint before = kept("w1");
    map::Waypoint after = before;
    after.name = "Other";
    hold({waypoint("w1", "Dock", 1).replace("\"z\":0},\"orientation", "\"z\":1.5},\"orientation")});
    QVERIFY(perform({"w1", before, after}));
    const QJsonObject args = server_->argumentsOf(QStringLiteral("/map_manager/rename_waypoint")).first();
    QCOMPARE(args[text("waypoint_info")][text("pose")][text("position")][text("z")].toDouble(), 1.5);
  }

  void whatIsDoneAllTheSameIsNoFailure() {
    manage();
    serve("delete_waypoint", [&](const QJsonObject&) {
      showWaypoints({waypoint("w2", "Desk", 2)});
      return json(R"({"refused":"transport error completing service call"})");
    });
    QVERIFY(online());
    const auto receipt = perform({"w1", kept("w1"), {}});
    QVERIFY(receipt);
    QCOMPARE(
        server_->argumentsOf(QStringLiteral("/map_manager/delete_waypoint")).first()[text("delete_waypoint")],
        QJsonValue(true));
  }

  void tagsThatTheRobotKeepsAreTold() {
    manage();
    serve("reposition_waypoint", [](const QJsonObject&) { return json(R"({"result":3})"); });
    QVERIFY(online());
    map::Waypoint before = kept("w1"), after = before;
    after.tags.clear();
    const auto receipt = perform({"w1", before, after});
    QVERIFY(!receipt);
    QCOMPARE(receipt.error().cause.code, robot::ros::fault::TagsNotTaken);
  }

  void changesOfAnotherMapAreLookedUp() {
    manage();
    auto x = std::make_shared<double>(9);
    serve("get_waypoint", [x](const QJsonObject&) {
      return QJsonObject{{text("waypoints"), waypoints({waypoint("w9", "Far", *x, "m2")})}};
    });
    serve("reposition_waypoint", [x](const QJsonObject&) {
      *x = 12;
      return json(R"({"result":3})");
    });
    QVERIFY(online());
    const map::Waypoint before = read("m2")->points.front();
    map::Waypoint after = before;
    after.position_m.x() = 12;
    QVERIFY(perform({"w9", before, after}, "m2"));
  }

  void aChangeOfAnotherMapThatSomebodyElseMadeFirstIsAConflict() {
    manage();
    auto x = std::make_shared<double>(9);
    serve("get_waypoint", [x](const QJsonObject&) {
      return QJsonObject{{text("waypoints"), waypoints({waypoint("w9", "Far", *x, "m2")})}};
    });
    serve("reposition_waypoint", [](const QJsonObject&) { return json(R"({"result":3})"); });
    serve("delete_waypoint", [](const QJsonObject&) { return json(R"({"result":5})"); });
    QVERIFY(online());
    const map::Waypoint before = read("m2")->points.front();
    map::Waypoint after = before;
    after.position_m.x() = 12;
    *x = 10;
    for (const WaypointChange& change :
         {WaypointChange{"w9", before, after}, WaypointChange{"w9", before, std::nullopt}}) {
      const auto outcome = perform(change, "m2");
      QVERIFY(!outcome);
      QVERIFY(outcome.error().kind == map::FailureKind::Conflict);
      QVERIFY(outcome.error().applied == map::Applied::No);
      QCOMPARE(outcome.error().cause, Fault(robot::ros::fault::ChangedMeanwhile, {"Far"}));
    }
    QCOMPARE(server_->timesCalled(text("/map_manager/reposition_waypoint")), 0);
    QCOMPARE(server_->timesCalled(text("/map_manager/delete_waypoint")), 0);
    QCOMPARE(server_->argumentsOf(text("/map_manager/get_waypoint")).last()[text("waypoint_id")].toString(),
             text("w9"));
  }

  void aMapIsRenamedWhenTheListSaysSo() {
    manage();
    serve("rename_map", [&](const QJsonObject& args) {
      server_->latch(
          QStringLiteral("/map_manager/map_list"),
          json(
              R"({"maps":[{"map_id":"m1","map_name":"one","map_label":"One"},{"map_id":"m2","map_name":"two","map_label":")" +
              args[text("new_map_label")].toString().toUtf8() + R"("}]})"));
      return json(R"({"result":0})");
    });
    QVERIFY(online());
    const auto entry = answerTo<map::CatalogueEntry>([&](auto reply) {
      return order({MapChange::Rename, {map::MapKind::Stored, "m2"}, "Attic"}, reply);
    });
    QVERIFY2(entry, entry ? "" : sentences::sentenceOf(entry.error()).c_str());
    QCOMPARE(entry->name, std::string("Attic"));
    const QJsonObject args = server_->argumentsOf(QStringLiteral("/map_manager/rename_map")).first();
    for (const char* member : {"map_id", "updated_image", "new_map_label", "set_archive", "delete_map"})
      QVERIFY2(args.contains(QLatin1String(member)), member);
  }

  void aMapIsLoadedWhenItIsTheCurrentOne() {
    manage();
    serve("load_map", [&](const QJsonObject& args) {
      if (args[text("map_id")].toString() == QLatin1String("m1")) return json(R"({"result":2})");
      server_->latch(
          QStringLiteral("/map_manager/current_map_info"),
          json(R"({"map_id":"m2","map_name":"two","map_label":"Two","map_manager_state":"ACTIVE"})"));
      return json(R"({"result":0})");
    });
    QVERIFY(online());
    const auto load = [&](const char* id) {
      return answerTo<map::CatalogueEntry>([&](auto reply) {
        return order({.change = MapChange::Load, .key = {map::MapKind::Stored, id}, .place = "Dock"}, reply);
      });
    };
    const auto same = load("m1");  // it is loaded already
    QVERIFY(same && same->is_current);
    QSignalSpy changed(robot_.get(), &Robot::mapsChanged);
    const auto other = load("m2");
    QVERIFY(other && other->is_current && other->key.id == "m2");
    QVERIFY(!changed.isEmpty());
    const auto unknown = load("m5");
    QVERIFY(!unknown && unknown.error().reason == map::FailureReason::NotThere);
    QCOMPARE(server_->argumentsOf(QStringLiteral("/map_manager/load_map"))
                 .first()[text("loc_waypoint_name")]
                 .toString(),
             QStringLiteral("Dock"));
  }

  void mapsAreArchivedTakenOutAndDeletedWhenTheListsSaySo() {
    manage();
    const auto put = [&](const char* list, const char* rows) {
      server_->latch(text("/map_manager/") + text(list), json(QByteArray("{\"maps\":[") + rows + "]}"));
    };
    constexpr const char* kOne = R"({"map_id":"m1","map_name":"one","map_label":"One"})";
    constexpr const char* kTwo = R"({"map_id":"m2","map_name":"two","map_label":"Two"})";
    const QByteArray both = QByteArray(kOne) + ',' + kTwo;
    serve("archive_map", [&](const QJsonObject& args) {
      const bool away = args[text("set_archive")].toBool();
      put("archived_map_list", away ? kTwo : "");
      put("map_list", away ? kOne : both.constData());
      return json(R"({"result":0})");
    });
    serve("delete_map", [&](const QJsonObject& args) {
      if (!args[text("delete_map")].toBool()) return json(R"({"result":3})");
      put("map_list", kOne);
      return json(R"({"result":1})");
    });
    QVERIFY(online());
    const auto ask = [&](MapChange change) {
      return answerTo<map::CatalogueEntry>([&](auto reply) {
        return order({change, {map::MapKind::Stored, "m2"}}, reply);
      });
    };
    const auto archived = ask(MapChange::Archive);
    QVERIFY2(archived, archived ? "" : sentences::sentenceOf(archived.error()).c_str());
    QVERIFY(archived->is_archived);
    const auto out = ask(MapChange::Unarchive);
    QVERIFY(out && !out->is_archived);
    const auto deleted = ask(MapChange::Delete);
    QVERIFY(deleted && deleted->name == "Two");
    const auto gone = ask(MapChange::Delete);
    QVERIFY(!gone && gone.error().reason == map::FailureReason::NotThere);
    QVERIFY(gone.error().applied == map::Applied::No);
  }

  void mappingIsStartedStoppedAndSavedAsItsStateAllows() {
    manage();
    const auto state = [&](const char* now) {
      const QByteArray begins =
          "{\"map_id\":\"\",\"map_name\":\"\",\"map_label\":\"\",\"map_manager_state\":\"";
      server_->latch(text("/map_manager/current_map_info"), json(begins + now + "\"}"));
    };
    serve("start_mapping", [&](const QJsonObject&) {
      state("MAPPING");
      return json(R"({"success":true,"message":""})");
    });
    bool stops = false;
    serve("stop_mapping", [&](const QJsonObject&) {
      if (!stops) return json(R"({"success":false,"message":"wheels are blocked"})");
      state("IDLE");
      return json(R"({"success":true,"message":""})");
    });
    serve("save_map", [&](const QJsonObject& args) {
      if (args[text("map_name")].toString() == text("One")) return json(R"({"result":2,"map_id":""})");
      server_->latch(
          text("/map_manager/map_list"),
          json(
              R"({"maps":[{"map_id":"m1","map_name":"one","map_label":"One"},{"map_id":"m7","map_name":"Hall","map_label":"Hall"}]})"));
      return json(R"({"result":0,"map_id":"m7"})");
    });
    QVERIFY(online());
    MapAdministration& maps = *robot_->mapAdministration();
    QTRY_VERIFY(!maps.obstacle(MapChange::StartMapping, nullptr));
    QVERIFY(maps.obstacle(MapChange::StopMapping, nullptr) == Obstacle::NotMapping);
    const auto ask = [&](MapChange change, const char* name = "") {
      return answerTo<map::CatalogueEntry>(
          [&](auto reply) { return order({.change = change, .name = name}, reply); });
    };
    QVERIFY(ask(MapChange::StartMapping));
    QTRY_VERIFY(maps.obstacle(MapChange::StartMapping, nullptr) == Obstacle::WhileMapping);
    QVERIFY(!maps.obstacle(MapChange::StopMapping, nullptr));
    const auto blocked = ask(MapChange::StopMapping);
    QVERIFY(!blocked && blocked.error().kind == map::FailureKind::RejectedByRobot);
    QCOMPARE(blocked.error().detail, std::string("wheels are blocked"));
    stops = true;
    QVERIFY(ask(MapChange::StopMapping));
    const auto taken = ask(MapChange::Save, "One");
    QVERIFY(!taken && taken.error().cause.code == robot::ros::fault::ResultMapNameTaken);
    const auto saved = ask(MapChange::Save, "Hall");
    QVERIFY2(saved, saved ? "" : sentences::sentenceOf(saved.error()).c_str());
    QCOMPARE(saved->key.id, std::string("m7"));
  }
};

}  // namespace test_ros_robot

MAPWRIGHT_TEST(test_ros_robot, RosRobotTest, Core)
#include "test_ros_robot.moc"
