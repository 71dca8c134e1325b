// Messages that are drawn like markers, and scans and clouds of rare types.
#include <random>

#include <QTest>

#include "robot/ros/drawn_messages.h"
#include "robot/ros/faults.h"
#include "robot/ros/ros_world.h"
#include "ros_messages.h"
#include "test_program.h"

namespace test_ros_drawn {

using namespace mapwright;
using namespace mapwright::robot::ros;
using map::Stream;
using test::byJson;

namespace {

constexpr double kNow = 1'700'000'000;

QByteArray written(double value) { return QByteArray::number(value, 'g', 17); }

QByteArray header(const char* frame = "map") {
  return R"("header":{"stamp":{"sec":1700000000,"nanosec":0},"frame_id":")" + QByteArray(frame) + "\"}";
}

QByteArray point(double x, double y) {
  return R"({"x":)" + written(x) + R"(,"y":)" + written(y) + R"(,"z":0})";
}

QByteArray pose(double x, double y, double yaw = 0) {
  return R"({"position":)" + point(x, y) + R"(,"orientation":{"x":0,"y":0,"z":)" +
         written(std::sin(yaw / 2)) + R"(,"w":)" + written(std::cos(yaw / 2)) + "}}";
}

/// What is seen of a message of that type, in a frame that lies at (10, 0), turned by 90 degrees.
map::SeenObjectsMessage seenOf(const char* type, const QByteArray& message) {
  RosWorld world;
  world.add({Stream::Pose, Form::StaticTf, "/tf_static", {}, {}, true},
            byJson(R"({"transforms":[{"header":{"frame_id":"map"},"child_frame_id":"sensor","transform":)"
                   R"({"translation":{"x":10,"y":0,"z":0},"rotation":{"x":0,"y":0,"z":)" +
                   written(std::sin(M_PI / 4)) + R"(,"w":)" + written(std::cos(M_PI / 4)) + "}}}]}")
                .msg,
            kNow);
  world.add({Stream::SeenObjects, Form::Markers, "/drawn", type, {}, true}, byJson(message).msg, kNow);
  return world.seenObjects();
}

bool isAt(const Eigen::Vector2d& at, double x, double y) {
  return (at - Eigen::Vector2d(x, y)).norm() < 1e-6;
}

std::vector<std::string> topicsOf(Stream stream, const std::vector<Endpoint>& found) {
  std::vector<std::string> topics;
  for (const Source& source : sourcesFor(stream, sourcesOf(found, {}))) topics.push_back(source.topic);
  return topics;
}

}  // namespace

}  // namespace test_ros_drawn

namespace test_ros_drawn {  // opened again: moc loses count of the braces in raw strings above

class RosDrawnTest : public QObject {
  Q_OBJECT
  using Kind = map::GroundDrawing::Kind;

 private Q_SLOTS:
  void aPathOfAnyNameIsALine() {
    const auto seen = seenOf("nav_msgs/msg/Path", "{" + header("sensor") + R"(,"poses":[{"pose":)" +
                                                      pose(1, 0) + R"(},{"pose":)" + pose(2, 0) + "}]}");
    QCOMPARE(seen.drawings.size(), std::size_t(1));
    QCOMPARE(seen.drawings[0].kind, Kind::Line);
    QVERIFY(isAt(seen.drawings[0].points[0], 10, 1) && isAt(seen.drawings[0].points[1], 10, 2));
    // As thin as can be seen, in the colour of the layer.
    QCOMPARE(seen.drawings[0].size_m, 0.0);
    QVERIFY(!seen.drawings[0].rgba);
  }

  void anOutlineIsClosed() {
    const auto seen = seenOf("geometry_msgs/PolygonStamped",
                             "{" + header("sensor") + R"(,"polygon":{"points":[)" + point(0, 0) + "," +
                                 point(1, 0) + "," + point(0, 2) + "]}}");
    QCOMPARE(seen.drawings.size(), std::size_t(1));
    QCOMPARE(seen.drawings[0].points.size(), std::size_t(4));
    QVERIFY(isAt(seen.drawings[0].points[2], 8, 0) && isAt(seen.drawings[0].points[3], 10, 0));
  }

  void eachPoseOfAListIsAnArrow() {
    const QByteArray list = pose(1, 0, M_PI / 2) + "," + pose(3, 4);
    const auto array = seenOf("geometry_msgs/PoseArray", "{" + header() + R"(,"poses":[)" + list + "]}");
    const auto cloud = seenOf("nav2_msgs/msg/ParticleCloud",
                              "{" + header() + R"(,"particles":[{"weight":1,"pose":)" + pose(1, 0, M_PI / 2) +
                                  R"(},{"pose":)" + pose(3, 4) + "}]}");
    QVERIFY(array == cloud);
    QCOMPARE(array.drawings.size(), std::size_t(1));
    const map::GroundDrawing& arrows = array.drawings[0];
    QCOMPARE(arrows.kind, Kind::Segments);
    QCOMPARE(arrows.points.size(), std::size_t(12));
    QVERIFY(isAt(arrows.points[0], 1, 0) && isAt(arrows.points[1], 1, 0.2));
    QVERIFY(isAt(arrows.points[6], 3, 4) && isAt(arrows.points[7], 3.2, 4));
  }

  void aRangeIsTheConeThatItMeasured() {
    const auto message = [](const QByteArray& range) {
      return "{" + header("sensor") +
             R"(,"radiation_type":0,"field_of_view":1,"min_range":0.1,"max_range":4,)"
             R"("range":)" +
             range + "}";
    };
    const auto seen = seenOf("sensor_msgs/Range", message("2"));
    QCOMPARE(seen.drawings.size(), std::size_t(1));
    const auto& points = seen.drawings[0].points;
    QVERIFY(isAt(points.front(), 10, 0) && isAt(points.back(), 10, 0));
    double least = 9, most = -9;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const Eigen::Vector2d from = points[i] - Eigen::Vector2d(10, 0);
      QVERIFY(std::abs(from.norm() - 2) < 1e-9);
      const double angle = std::atan2(from.y(), from.x()) - M_PI / 2;
      least = std::min(least, angle);
      most = std::max(most, angle);
    }
    QVERIFY(std::abs(least + 0.5) < 1e-9 && std::abs(most - 0.5) < 1e-9);
    for (const char* const none : {"null", "5", "0.05", "4.1"})
      QVERIFY2(seenOf("sensor_msgs/Range", message(none)).drawings.empty(), none);
  }

  void cellsOfAGridLieAtTheirCentres() {
    const auto seen =
        seenOf("nav_msgs/GridCells", "{" + header() + R"(,"cell_width":0.5,"cell_height":0.5,"cells":[)" +
                                         point(1, 2) + "," + point(3, 4) + "]}");
    QCOMPARE(seen.drawings.size(), std::size_t(1));
    QCOMPARE(seen.drawings[0].kind, Kind::Points);
    QCOMPARE(seen.drawings[0].size_m, 0.5);
    QVERIFY(isAt(seen.drawings[0].points[1], 3, 4));
  }

  void aPointIsNamedAfterItsTopic() {
    const auto seen =
        seenOf("geometry_msgs/PointStamped", "{" + header("sensor") + R"(,"point":)" + point(1, 0) + "}");
    QCOMPARE(seen.objects.size(), std::size_t(1));
    QCOMPARE(seen.objects[0].label, std::string("/drawn"));
    QVERIFY(isAt({seen.objects[0].pose.x_m, seen.objects[0].pose.y_m}, 10, 1));
  }

  // By chi square with two degrees of freedom, whatever way the ellipse was made.
  void anUncertainPoseIsTheEllipseThatHolds95Percent() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-2, 2);
    for (int trial = 0; trial < 100; ++trial) {
      Eigen::Matrix2d root;
      root << any(random), any(random), any(random), any(random);
      const Eigen::Matrix2d spread = root * root.transpose() + Eigen::Matrix2d::Identity() * 1e-3;
      QByteArray covariance;
      for (int row = 0; row < 6; ++row) {
        for (int column = 0; column < 6; ++column)
          covariance +=
              (covariance.isEmpty() ? "" : ",") + written(row < 2 && column < 2 ? spread(row, column) : 0.0);
      }
      const auto seen = seenOf(
          "geometry_msgs/PoseWithCovarianceStamped",
          "{" + header() + R"(,"pose":{"pose":)" + pose(3, 4, 1) + R"(,"covariance":[)" + covariance + "]}}");
      QCOMPARE(seen.drawings.size(), std::size_t(1));
      const Eigen::Matrix2d inverse = spread.inverse();
      for (const Eigen::Vector2d& at : seen.drawings[0].points) {
        const Eigen::Vector2d from = at - Eigen::Vector2d(3, 4);
        QVERIFY(std::abs(from.dot(inverse * from) - 5.991) < 0.005);
      }
    }
  }

  void aPoseWithoutCovarianceHasNoEllipse() {
    QByteArray zeros = "0";
    for (int i = 1; i < 36; ++i) zeros += ",0";
    for (const QByteArray& covariance :
         {zeros, QByteArray(zeros).replace(0, 1, "-1"), QByteArray(zeros).replace(0, 1, "1e12")})
      QVERIFY(seenOf("geometry_msgs/PoseWithCovarianceStamped", "{" + header() + R"(,"pose":{"pose":)" +
                                                                    pose(3, 4) + R"(,"covariance":[)" +
                                                                    covariance + "]}}")
                  .drawings.empty());
  }

  void theNextMessageReplacesTheOneBefore() {
    RosWorld world;
    const Source source{Stream::SeenObjects, Form::Markers, "/a", "nav_msgs/Path", {}, true};
    const QByteArray two =
        "{" + header() + R"(,"poses":[{"pose":)" + pose(1, 0) + R"(},{"pose":)" + pose(2, 0) + "}]}";
    world.add(source, byJson(two).msg, kNow);
    QCOMPARE(world.seenObjects().drawings.size(), std::size_t(1));
    world.add(source, byJson("{" + header() + R"(,"poses":[]})").msg, kNow);
    QVERIFY(world.seenObjects().drawings.empty());
  }

  void whatIsNotAMessageOfItsTypeIsUnreadable() {
    for (const std::string& type : drawnTypes()) {
      RosWorld world;
      const auto results = world.add({Stream::SeenObjects, Form::Markers, "/a", type, {}, true},
                                     byJson(R"({"data":[1,2]})").msg, kNow);
      QVERIFY2(results.back().unreadable.has_value(), type.c_str());
    }
  }

  void meshesAndUnknownKindsAreNamed() {
    RosWorld world;
    const QByteArray rest =
        R"(,"ns":"a","action":0,"pose":)" + pose(1, 2) + R"(,"scale":{"x":1,"y":1,"z":1})";
    const auto results =
        world.add({Stream::SeenObjects, Form::Markers, "/markers", {}, {}, true},
                  byJson(R"({"markers":[{"id":1,"type":10,"mesh_resource":"package://a/b.dae",)" + header() +
                         rest + R"(},{"id":2,"type":77,)" + header() + rest + "}]}")
                      .msg,
                  kNow);
    QCOMPARE(results.back().notes.size(), std::size_t(2));
    QCOMPARE(results.back().notes[0], Fault(robot::ros::fault::RosMarkersUnknown, {std::int64_t(1)}));
    QCOMPARE(results.back().notes[1],
             Fault(robot::ros::fault::RosMeshesAsSpots, {std::int64_t(1), std::string("package://a/b.dae")}));
    QCOMPARE(world.seenObjects().drawings.size(), std::size_t(1));
    QVERIFY(isAt(world.seenObjects().drawings[0].points[0], 1, 2));
  }

  void markersThatAreLeftOutOrCutAreCounted() {
    RosWorld world;
    const QByteArray sound =
        R"({"id":1,"type":1,"ns":"a","action":0,"scale":{"x":1,"y":1,"z":1},)" + header();
    const auto results =
        world.add({Stream::SeenObjects, Form::Markers, "/markers", {}, {}, true},
                  byJson(R"({"markers":[)" + sound + R"(,"pose":)" + pose(1, 2) + "}," + sound +
                         R"(,"pose":{"position":{"x":null,"y":"?"}}},)" +  // nowhere
                         sound + R"(,"pose":)" + pose(1, 2) + R"(,"points":[{"x":1,"y":2},{"x":"NaN"}]}]})")
                      .msg,
                  kNow);
    QCOMPARE(results.back().notes.size(), std::size_t(1));
    QCOMPARE(results.back().notes[0], Fault(robot::ros::fault::RosMarkersLeftOut, {std::int64_t(2)}));
  }

  void trianglesAreFilled() {
    RosWorld world;
    world.add({Stream::SeenObjects, Form::Markers, "/markers", {}, {}, true},
              byJson(R"({"markers":[{"id":1,"type":11,)" + header() + R"(,"ns":"a","action":0,"pose":)" +
                     pose(1, 0) + R"(,"scale":{"x":1,"y":1,"z":1},"points":[)" + point(0, 0) + "," +
                     point(1, 0) + "," + point(0, 1) + "]}]}")
                  .msg,
              kNow);
    QCOMPARE(world.seenObjects().drawings.size(), std::size_t(1));
    QCOMPARE(world.seenObjects().drawings[0].kind, Kind::Triangles);
    QVERIFY(isAt(world.seenObjects().drawings[0].points[1], 2, 0));
  }

  void everyEchoIsAPoint() {
    const auto points = readMultiEchoScan(
        byJson("{" + header() +
               R"(,"angle_min":0,"angle_increment":1.5707963267948966,"range_min":0.1,)"
               R"("range_max":9,"ranges":[{"echoes":[1,2]},{"echoes":[]},{"echoes":[3,10]}],)"
               R"("intensities":[{"echoes":[10,200]},{"echoes":[]},{"echoes":[30,0]}]})")
            .msg);
    QVERIFY(points);
    QCOMPARE(points->points.size(), std::size_t(3));
    QCOMPARE(points->left_out, std::size_t(1));
    QVERIFY(isAt({points->points[1].x_m, points->points[1].y_m}, 2, 0));
    QVERIFY(isAt({points->points[2].x_m, points->points[2].y_m}, -3, 0));
    QCOMPARE(int(points->points[1].intensity), 200);
  }

  void pointsOfTheOldCloudHaveTheirIntensity() {
    const auto points = readPointCloud1(byJson("{" + header() + R"(,"points":[)" + point(1, 2) +
                                               R"(,{"x":null,"y":0,"z":0},)" + point(3, 4) +
                                               R"(],"channels":[{"name":"intensity","values":[7,8,9]}]})")
                                            .msg);
    QVERIFY(points);
    QCOMPARE(points->points.size(), std::size_t(2));
    QCOMPARE(points->left_out, std::size_t(1));
    QCOMPARE(int(points->points[1].intensity), 9);
  }

  void everyTopicThatCanBeDrawnIsShownOnce() {
    const std::vector<Endpoint> found{{"/plan", "nav_msgs/Path"},
                                      {"/local_plan", "nav_msgs/Path"},
                                      {"/teb/poses", "geometry_msgs/PoseArray"},
                                      {"/other/way", "nav_msgs/msg/Path"},
                                      {"/amcl_pose", "geometry_msgs/PoseWithCovarianceStamped"},
                                      {"/local_costmap/published_footprint", "geometry_msgs/PolygonStamped"},
                                      {"/global_costmap/published_footprint", "geometry_msgs/PolygonStamped"},
                                      {"/zone", "geometry_msgs/PolygonStamped"},
                                      {"/initialpose", "geometry_msgs/PoseWithCovarianceStamped"},
                                      {"/sonar", "sensor_msgs/Range"},
                                      {"/blobs", "visualization_msgs/Marker"},
                                      {"/odd/markers", "visualization_msgs/MarkerArray"},
                                      {"/multi", "sensor_msgs/MultiEchoLaserScan"},
                                      {"/old_cloud", "sensor_msgs/PointCloud"},
                                      {"/move_base_simple/goal", "geometry_msgs/PoseStamped"}};
    using Topics = std::vector<std::string>;
    QCOMPARE(topicsOf(Stream::Path, found), Topics{"/plan"});
    QCOMPARE(topicsOf(Stream::LocalPath, found), Topics{"/local_plan"});
    QCOMPARE(topicsOf(Stream::Cloud, found), (Topics{"/multi", "/old_cloud"}));
    QCOMPARE(topicsOf(Stream::Planning, found), Topics{"/move_base_simple/goal"});
    QCOMPARE(topicsOf(Stream::Model, found), Topics{"/local_costmap/published_footprint"});
    QCOMPARE(topicsOf(Stream::SeenObjects, found),
             (Topics{"/odd/markers", "/blobs", "/amcl_pose", "/other/way", "/sonar", "/teb/poses", "/zone"}));
  }

  void aPathOfAnyNameTakesTheLayerOfPathsWhereNoneHasAUsualName() {
    QCOMPARE(topicsOf(Stream::Path, {{"/far/away/way", "nav_msgs/Path"}, {"/way", "nav_msgs/Path"}}),
             std::vector<std::string>{"/way"});
    QCOMPARE(topicsOf(Stream::SeenObjects, {{"/far/away/way", "nav_msgs/Path"}, {"/way", "nav_msgs/Path"}}),
             std::vector<std::string>{"/far/away/way"});
  }

  void whatPeopleChooseIsNotShownTwice() {
    const std::vector<Endpoint> found{
        {"/plan", "nav_msgs/Path"}, {"/other/way", "nav_msgs/Path"}, {"/dock", "geometry_msgs/PoseArray"}};
    auto sources = sourcesOf(found, {});
    choose(sources, {{Stream::Path, "/other/way"}, {Stream::Planning, "/dock"}}, found);
    QVERIFY(sourcesFor(Stream::SeenObjects, sources).empty());
  }
};

}  // namespace test_ros_drawn

MAPWRIGHT_TEST(test_ros_drawn, RosDrawnTest, Core)
#include "test_ros_drawn.moc"
