// Several robots in one system: what each sends lies where its own transforms put it.
#include <random>

#include <QTest>

#include "robot/ros/ros_world.h"
#include "ros_messages.h"
#include "test_program.h"

namespace test_ros_robots {

using namespace mapwright;
using namespace mapwright::robot::ros;
using map::Stream;
using test::byJson;

namespace {

constexpr double kNow = 1'700'000'000;

QByteArray number(double value) { return QByteArray::number(value, 'g', 17); }

QByteArray header(const std::string& frame) {
  return R"("header":{"stamp":{"sec":1700000000,"nanosec":0},"frame_id":")" +
         QByteArray::fromStdString(frame) + "\"}";
}

QByteArray turnOf(double yaw) {
  return R"({"x":0,"y":0,"z":)" + number(std::sin(yaw / 2)) + R"(,"w":)" + number(std::cos(yaw / 2)) + "}";
}

QByteArray tf(const std::string& parent, const std::string& child, const geometry::Pose2& pose) {
  return R"({"transforms":[{)" + header(parent) + R"(,"child_frame_id":")" +
         QByteArray::fromStdString(child) + R"(","transform":{"translation":{"x":)" + number(pose.x_m) +
         R"(,"y":)" + number(pose.y_m) + R"(,"z":0},"rotation":)" + turnOf(pose.yaw_rad) + "}}]}";
}

QByteArray scan(const std::string& frame, double range_m) {
  return "{" + header(frame) +
         R"(,"angle_min":0,"angle_increment":0.1,"range_min":0,"range_max":90,"ranges":[)" + number(range_m) +
         "]}";
}

QByteArray cube(const std::string& frame, int id) {
  return R"({"markers":[{)" + header(frame) + R"(,"ns":"cube","id":)" + QByteArray::number(id) +
         R"(,"type":1,"action":0,"pose":{"position":{"x":1,"y":0,"z":0},"orientation":)" + turnOf(0) +
         R"(},"scale":{"x":1,"y":1,"z":1}}]})";
}

std::vector<std::string> topicsOf(const std::vector<Source>& sources) {
  std::vector<std::string> topics;
  for (const Source& source : sources) topics.push_back(source.topic);
  return topics;
}

}  // namespace

/// How robots share a system.
enum class Layout {
  Apart,     // transforms in namespaces, the same names of frames
  WithRoot,  // the same, beside a robot without a namespace
  OneMap,    // the root tells where each odometry lies in the map; names begin with that of the robot
  OneTopic,  // all transforms on /tf, with such names; messages leave them out
};

}  // namespace test_ros_robots

namespace test_ros_robots {  // opened again: moc loses count of the braces in raw strings above

class RosRobotsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatARobotSendsLiesWhereItsOwnTransformsPutIt_data() {
    QTest::addColumn<Layout>("layout");
    QTest::newRow("namespaces") << Layout::Apart;
    QTest::newRow("beside a robot without one") << Layout::WithRoot;
    QTest::newRow("one map") << Layout::OneMap;
    QTest::newRow("one topic") << Layout::OneTopic;
  }
  void whatARobotSendsLiesWhereItsOwnTransformsPutIt() {
    QFETCH(Layout, layout);
    std::mt19937 random(11);
    const auto place = [&] {
      std::uniform_real_distribution<double> metres(-50, 50), turn(-3, 3);
      return geometry::Pose2{metres(random), metres(random), turn(random)};
    };
    struct Told {
      Source source;
      QByteArray text;
    };
    for (int trial = 0; trial < 200; ++trial) {
      std::vector<std::string> robots{"/r1", "/r2", "/fleet/r3"};
      if (layout == Layout::WithRoot) robots.push_back({});
      std::vector<Told> told;
      std::vector<Endpoint> found;
      const auto publish = [&](Stream stream, Form form, const std::string& topic, const char* type,
                               const QByteArray& text) {
        const Endpoint endpoint{topic, type};
        if (std::find(found.begin(), found.end(), endpoint) == found.end()) found.push_back(endpoint);
        told.push_back({{stream, form, topic, type, {}, true}, text});
      };
      std::map<std::string, Eigen::Vector2d> hits;   // by topic
      std::map<std::string, geometry::Pose2> cubes;  // by label
      int id = 0;
      for (const std::string& robot : robots) {
        const bool named = layout == Layout::OneMap || layout == Layout::OneTopic;
        const std::string prefix = named ? frameName(robot) + '/' : std::string();
        const std::string own_tf = layout == Layout::OneTopic ? "/tf" : robot + "/tf";
        const std::string map_tf = named ? "/tf" : own_tf;
        const geometry::Pose2 odom = place(), base = place(), laser = place();
        publish(Stream::Pose, Form::Tf, map_tf, "tf2_msgs/TFMessage", tf("map", prefix + "odom", odom));
        publish(Stream::Pose, Form::Tf, own_tf, "tf2_msgs/TFMessage",
                tf(prefix + "odom", prefix + "base_link", base));
        publish(Stream::Pose, Form::StaticTf, own_tf + "_static", "tf2_msgs/TFMessage",
                tf(prefix + "base_link", prefix + "laser", laser));
        const geometry::Pose2 sensor = odom * base * laser;
        const double range_m = 1 + double(++id);
        const std::string frame = layout == Layout::OneTopic ? "laser" : prefix + "laser";
        hits[robot + "/scan"] = {sensor.x_m + range_m * std::cos(sensor.yaw_rad),
                                 sensor.y_m + range_m * std::sin(sensor.yaw_rad)};
        cubes["cube " + std::to_string(id)] = sensor * geometry::Pose2{1, 0, 0};
        publish(Stream::Cloud, Form::LaserScan, robot + "/scan", "sensor_msgs/LaserScan",
                scan(frame, range_m));
        publish(Stream::SeenObjects, Form::Markers, robot + "/markers", "visualization_msgs/MarkerArray",
                cube(frame, id));
      }
      RosWorld world;
      world.setRobots(robotsIn(sourcesOf(found, {}), {}));
      std::shuffle(told.begin(), told.end(), random);
      std::map<std::string, int> placed;
      const auto check = [&](const WorldResults& results) {
        for (const WorldResult& result : results) {
          if (!result.message) continue;
          if (const auto* const cloud = std::get_if<map::PointCloudMessage>(&*result.message)) {
            QCOMPARE(cloud->points->size(), std::size_t(1));
            const map::CloudPoint& at = cloud->points->front();
            QVERIFY2((Eigen::Vector2d(at.x_m, at.y_m) - hits.at(result.topic)).norm() < 1e-6,
                     (result.topic + " in trial " + std::to_string(trial)).c_str());
            ++placed[result.topic];
          } else if (const auto* const seen = std::get_if<map::SeenObjectsMessage>(&*result.message)) {
            for (const map::GroundBox& box : seen->objects) {
              const geometry::Pose2& at = cubes.at(box.label);
              QVERIFY(std::hypot(box.pose.x_m - at.x_m, box.pose.y_m - at.y_m) < 1e-6);
            }
          }
        }
      };
      for (const Told& one : told) check(world.add(one.source, byJson(one.text).msg, kNow));
      check(world.overdue(kNow + 0.5));
      for (const auto& [topic, at] : hits) QVERIFY2(placed[topic] > 0, topic.c_str());
      QCOMPARE(world.seenObjects().objects.size(), cubes.size());
    }
  }

  void aRobotWhoseTransformsAreMissingIsNotPlacedByAnother() {
    RosWorld world;
    world.setRobots({"", "/r1"});
    const auto give = [&](const Source& source, const QByteArray& text) {
      return world.add(source, byJson(text).msg, kNow);
    };
    const Source root{Stream::Pose, Form::Tf, "/tf", {}, {}, true};
    give(root, tf("map", "odom", {1, 0, 0}));
    give(root, tf("odom", "laser", {1, 0, 0}));
    const auto results = give({Stream::Cloud, Form::LaserScan, "/r1/scan", {}, {}, true}, scan("laser", 1));
    QVERIFY(!results.front().message);
    QVERIFY(give({Stream::Cloud, Form::LaserScan, "/scan", {}, {}, true}, scan("laser", 1)).front().message);
    const auto late = world.overdue(kNow + 2);
    QVERIFY(!late.empty() && late.front().unplaced && late.front().topic == "/r1/scan");
  }

  void aRobotThatTellsNothingItselfIsPlacedByTheRootInTheEnd() {
    // Whoever listens makes a topic, too.
    RosWorld world;
    world.setRobots({"", "/r1"});
    const Source root{Stream::Pose, Form::Tf, "/tf", {}, {}, true};
    world.add(root, byJson(tf("map", "laser", {1, 0, 0})).msg, kNow);
    world.add({Stream::Cloud, Form::LaserScan, "/r1/scan", {}, {}, true}, byJson(scan("laser", 1)).msg, kNow);
    const auto results = world.add(root, byJson(tf("map", "laser", {1, 0, 0})).msg, kNow + 1.5);
    QVERIFY(std::any_of(results.begin(), results.end(), [](const WorldResult& result) {
      return result.topic == "/r1/scan" && result.message.has_value();
    }));
  }

  void theRobotIsTheOneOfTheNamespace() {
    for (const char* const ns : {"/r1", "/r2"}) {
      const std::vector<Endpoint> found{
          {"/r1/tf", "tf2_msgs/TFMessage"}, {"/r2/tf", "tf2_msgs/TFMessage"}, {"/tf", "tf2_msgs/TFMessage"}};
      RosWorld world(ns);
      world.setRobots(robotsIn(sourcesOf(found, ns), ns));
      for (const Source& source : sourcesOf(found, ns)) {
        const double x_m = source.topic == "/r1/tf" ? 1 : source.topic == "/r2/tf" ? 2 : 9;
        world.add(source, byJson(tf("map", "base_link", {x_m, 0, 0})).msg, kNow);
      }
      QVERIFY(world.pose() && *world.pose());
      QCOMPARE((*world.pose())->x_m, ns[2] - '0');
    }
  }

  void withANamespaceTopicsOfOtherRobotsAreLeftOut() {
    const std::vector<Endpoint> found{{"/r1/tf", "tf2_msgs/TFMessage"},
                                      {"/r2/tf", "tf2_msgs/TFMessage"},
                                      {"/r1/scan", "sensor_msgs/LaserScan"},
                                      {"/r2/front/scan", "sensor_msgs/LaserScan"},
                                      {"/r2/markers", "visualization_msgs/MarkerArray"},
                                      {"/r2/map", "nav_msgs/OccupancyGrid"},
                                      {"/r2/plan", "nav_msgs/Path"},
                                      {"/camera/points", "sensor_msgs/PointCloud2"},
                                      {"/map", "nav_msgs/OccupancyGrid"}};
    using Topics = std::vector<std::string>;
    QCOMPARE(topicsOf(sourcesOf(found, "/r1")), (Topics{"/map", "/r1/scan", "/camera/points", "/r1/tf"}));
    // Without it all scans are shown, each where its robot is.
    QCOMPARE(topicsOf(sourcesFor(Stream::Cloud, sourcesOf(found, {}))),
             (Topics{"/r1/scan", "/r2/front/scan", "/camera/points"}));
  }

  void robotsThatShareATopicOfTransformsAreToldByTheirSensors() {
    const std::vector<Endpoint> found{{"/tf", "tf2_msgs/TFMessage"},
                                      {"/r1/scan", "sensor_msgs/LaserScan"},
                                      {"/r2/scan", "sensor_msgs/LaserScan"},
                                      {"/r2/points", "sensor_msgs/PointCloud2"},
                                      {"/rear/scan_raw", "sensor_msgs/LaserScan"}};
    using Topics = std::vector<std::string>;
    QCOMPARE(topicsOf(sourcesOf(found, "/r1")), (Topics{"/r1/scan", "/rear/scan_raw", "/tf"}));
  }

  void oneRobotHasOneTopicOfTransforms() {
    const std::vector<Endpoint> found{{"/r1/tf", "tf2_msgs/TFMessage"},
                                      {"/tf_static", "tf2_msgs/TFMessage"},
                                      {"/old/r1/tf_static", "tf2_msgs/TFMessage"}};
    QCOMPARE(topicsOf(sourcesOf(found, {})), (std::vector<std::string>{"/r1/tf", "/tf_static"}));
  }
};

}  // namespace test_ros_robots

MAPWRIGHT_TEST(test_ros_robots, RosRobotsTest, Core)
#include "test_ros_robots.moc"
