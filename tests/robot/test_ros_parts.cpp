// Which topics of a ROS robot bring what, and where their messages lie; its addresses.
#include <QTest>

#include "robot/ros/faults.h"
#include "robot/ros/ros_address.h"
#include "robot/ros/ros_subscriptions.h"
#include "robot/ros/ros_topics.h"
#include "robot/ros/ros_world.h"
#include "ros_messages.h"
#include "test_program.h"

namespace test_ros_parts {

using namespace mapwright;
using namespace mapwright::robot::ros;
using map::Stream;
using test::byJson;
using test::Sent;

namespace {

constexpr double kNow = 100;

QByteArray header(const char* frame, double stamp_s) {
  return R"("header":{"frame_id":")" + QByteArray(frame) + R"(","stamp":{"sec":)" +
         QByteArray::number(int(stamp_s)) + R"(,"nanosec":)" +
         QByteArray::number(int((stamp_s - int(stamp_s)) * 1e9)) + "}}";
}

QByteArray pose(double x, double y, double yaw) {
  return R"({"position":{"x":)" + QByteArray::number(x) + R"(,"y":)" + QByteArray::number(y) +
         R"(,"z":0},"orientation":{"x":0,"y":0,"z":)" + QByteArray::number(std::sin(yaw / 2), 'g', 17) +
         R"(,"w":)" + QByteArray::number(std::cos(yaw / 2), 'g', 17) + "}}";
}

QByteArray tf(const char* parent, const char* child, double x, double y, double yaw, double stamp_s) {
  const QByteArray at = pose(x, y, yaw);
  QByteArray transform = at;
  transform.replace("position", "translation").replace("orientation", "rotation");
  return R"({"transforms":[{)" + header(parent, stamp_s) + R"(,"child_frame_id":")" + child +
         R"(","transform":)" + transform + "}]}";
}

QByteArray grid(const char* frame, double stamp_s) {
  return "{" + header(frame, stamp_s) + R"(,"info":{"resolution":0.5,"width":2,"height":2,"origin":)" +
         pose(1, 2, 0) + R"(},"data":[0,100,-1,50]})";
}

QByteArray path(const char* frame, double stamp_s) {
  return "{" + header(frame, stamp_s) + R"(,"poses":[{)" + header(frame, stamp_s) + R"(,"pose":)" +
         pose(1, 0, 0) + "},{" + header(frame, stamp_s) + R"(,"pose":)" + pose(2, 0, 0) + "}]}";
}

QByteArray marker(int id, const char* frame, const QByteArray& more = {}) {
  return "{" + header(frame, kNow) + R"(,"ns":"a","id":)" + QByteArray::number(id) +
         R"(,"type":1,"action":0,"pose":)" + pose(0, 0, 0) + R"(,"scale":{"x":1,"y":1,"z":1})" + more + "}";
}

const Source kTf{Stream::Pose, Form::Tf, "/tf", {}, {}, true};
const Source kStatic{Stream::Pose, Form::StaticTf, "/tf_static", {}, {}, true};
const Source kMap{Stream::WholeMap, Form::Grid, "/map", {}, {}, true};
const Source kLocal{Stream::CostmapHigh, Form::Grid, "/local_costmap/costmap", {}, {}, true};
const Source kPatches{Stream::CostmapHigh,
                      Form::GridPatch,
                      "/local_costmap/costmap_updates",
                      {},
                      "/local_costmap/costmap",
                      true};
const Source kScan{Stream::Cloud, Form::LaserScan, "/scan", {}, {}, true};
const Source kPath{Stream::LocalPath, Form::Path, "/local_plan", {}, {}, true};
const Source kFootprint{Stream::Model, Form::Polygon, "/footprint", {}, {}, true};
const Source kAmcl{Stream::Pose, Form::PoseWithCovariance, "/amcl_pose", {}, {}, true};
const Source kOdom{Stream::Pose, Form::Odometry, "/odom", {}, {}, true};
const Source kMarkers{Stream::SeenObjects, Form::Markers, "/markers", {}, {}, true};

WorldResults give(RosWorld& world, const Source& source, const QByteArray& text, double at_s = kNow) {
  const Sent sent = byJson(text);
  return world.add(source, sent.msg, at_s);
}

/// The first message of that type among the results.
template <typename T>
std::optional<T> messageOf(const WorldResults& results) {
  for (const WorldResult& result : results) {
    if (result.message && std::holds_alternative<T>(*result.message)) return std::get<T>(*result.message);
  }
  return std::nullopt;
}

std::optional<FaultCode> unplaced(const WorldResults& results) {
  for (const WorldResult& result : results) {
    if (!result.unplaced) continue;
    // That of markers says how many.
    return result.unplaced->because.empty() ? result.unplaced->code : result.unplaced->because.front().code;
  }
  return std::nullopt;
}

QStringList names(const std::vector<Source>& sources) {
  QStringList names;
  for (const Source& source : sources) names << QString::fromStdString(source.topic);
  return names;
}

QString normal(const QString& typed) {
  const robot::Addresses addresses({rosAddressScheme(), kabamAddressScheme(), rep130AddressScheme()});
  const auto address = addresses.parse(typed);
  return address ? address->text : QStringLiteral("refused: ") + address.error();
}

}  // namespace

}  // namespace test_ros_parts

namespace test_ros_parts {  // opened again: moc loses count of the braces in raw strings above

class RosPartsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void addressesAreMadeWhole_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("text");
    const auto row = [](const char* typed, const char* text) {
      QTest::newRow(typed) << QString::fromLatin1(typed) << QString::fromLatin1(text);
    };
    row("ros+ws://robot", "ros+ws://robot:9090");
    row("ros+robot:1234", "ros+ws://robot:1234");
    row("ROS+WSS://Robot:7/bridge/", "ros+wss://robot:7/bridge");
    row("kabam+ws://robot", "kabam+ws://robot:9090");
    row("ros+ws://robot?ns=/a/b/", "ros+ws://robot:9090?ns=/a/b");
    row("rep130+ws://robot", "rep130+ws://robot:9090");
    row("rep130+wss://robot?projected_map=p/q&get_sub_map=/other/name&ns=/map_dispatcher",
        "rep130+wss://robot:9090?ns=/map_dispatcher&get_sub_map=/other/name&projected_map=/map_dispatcher/p/"
        "q");
  }
  void addressesAreMadeWhole() {
    QFETCH(QString, typed);
    QFETCH(QString, text);
    QCOMPARE(normal(typed), text);
  }

  void addressesOfOtherThingsAreRefused_data() {
    QTest::addColumn<QString>("typed");
    for (const char* typed :
         {"ros+http://robot", "ros+ws://user:secret@robot", "ros+ws://robot?ns=a",
          "ros+ws://robot?ns=/a&ns=/b", "ros+ws://robot?other=/a", "ros+ws://robot#a", "ros+ws://",
          "ros+ftp://robot", "ros+ws://robot?ns=/a b", "ros+ws://robot?get_map=/a",
          "rep130+ws://robot?get_map=/a&get_map=/b", "rep130+ws://robot?get_map=1",
          "rep130+ws://robot?get_map=", "rep130+ws://robot?map=/a", "rep130+http://robot",
          "rep130+ws://user:secret@robot"})
      QTest::newRow(typed) << QString::fromLatin1(typed);
  }
  void addressesOfOtherThingsAreRefused() {
    QFETCH(QString, typed);
    const QString why = normal(typed);
    QVERIFY2(why.startsWith(QLatin1String("refused: ")) && why.endsWith(QLatin1Char('.')), qPrintable(why));
    QVERIFY(!why.contains(QLatin1String("secret@")));
  }

  // Topics.

  void topicsAreFoundByTypeAndName() {
    const std::vector<Endpoint> found{
        {"/move_base/global_costmap/costmap", "nav_msgs/OccupancyGrid"},
        {"/move_base/global_costmap/costmap_updates", "map_msgs/OccupancyGridUpdate"},
        {"/robot/map", "nav_msgs/msg/OccupancyGrid"},
        {"/front/scan", "sensor_msgs/LaserScan"},
        {"/rear_lidar", "sensor_msgs/LaserScan"},
        {"/move_base/NavfnROS/plan", "nav_msgs/Path"},
        {"/map", "std_msgs/String"},
        {"/tf", "tf2_msgs/TFMessage"}};
    const auto all = sourcesOf(found, {});
    QCOMPARE(names(sourcesFor(Stream::WholeMap, all)), QStringList{QStringLiteral("/robot/map")});
    QCOMPARE(names(sourcesFor(Stream::CostmapLow, all)),
             (QStringList{QStringLiteral("/move_base/global_costmap/costmap"),
                          QStringLiteral("/move_base/global_costmap/costmap_updates")}));
    QVERIFY(sourcesFor(Stream::CostmapHigh, all).empty());
    QCOMPARE(names(sourcesFor(Stream::Cloud, all)),
             (QStringList{QStringLiteral("/front/scan"), QStringLiteral("/rear_lidar")}));
    QCOMPARE(names(sourcesFor(Stream::Path, all)), QStringList{QStringLiteral("/move_base/NavfnROS/plan")});
    QCOMPARE(sourcesFor(Stream::WholeMap, all).front().type, std::string("nav_msgs/msg/OccupancyGrid"));
  }

  void aCostmapIsNoMap() {
    const auto all =
        sourcesOf(std::vector<Endpoint>{{"/local_costmap/costmap", "nav_msgs/OccupancyGrid"}}, {});
    QVERIFY(sourcesFor(Stream::WholeMap, all).empty());
  }

  void whatLiesBelowTheNamespaceGoesFirst() {
    const std::vector<Endpoint> found{{"/map", "nav_msgs/OccupancyGrid"},
                                      {"/r2/map", "nav_msgs/OccupancyGrid"},
                                      {"/r20/map", "nav_msgs/OccupancyGrid"}};
    QCOMPARE(names(sourcesFor(Stream::WholeMap, sourcesOf(found, {}))).first(), QStringLiteral("/map"));
    QCOMPARE(names(sourcesFor(Stream::WholeMap, sourcesOf(found, "/r2"))).first(), QStringLiteral("/r2/map"));
  }

  void whatPeopleChooseGoesBeforeTheUsualNames() {
    const std::vector<Endpoint> found{{"/map", "nav_msgs/OccupancyGrid"},
                                      {"/map_updates", "map_msgs/OccupancyGridUpdate"},
                                      {"/semantic/grid", "nav_msgs/msg/OccupancyGrid"},
                                      {"/semantic/grid_updates", "map_msgs/OccupancyGridUpdate"},
                                      {"/plan", "nav_msgs/Path"},
                                      {"/teb/trajectory", "nav_msgs/Path"},
                                      {"/particles", "geometry_msgs/PoseArray"},
                                      {"/dock", "geometry_msgs/PoseStamped"},
                                      {"/floor", "map_msgs/ProjectedMap"},
                                      {"/text", "std_msgs/String"}};
    using Names = std::vector<std::string>;
    QCOMPARE(choicesFor(Stream::CostmapLow, found), (Names{"/floor", "/map", "/semantic/grid"}));
    QCOMPARE(choicesFor(Stream::LocalPath, found), (Names{"/plan", "/teb/trajectory"}));
    QCOMPARE(choicesFor(Stream::Planning, found), (Names{"/dock", "/particles"}));
    QVERIFY(choicesFor(Stream::Cloud, found).empty());

    auto all = sourcesOf(found, {});
    QVERIFY(sourcesFor(Stream::Planning, all).empty() && sourcesFor(Stream::CostmapLow, all).empty());
    choose(all,
           {{Stream::CostmapLow, "/semantic/grid"},
            {Stream::Path, "/teb/trajectory"},
            {Stream::Planning, "/particles"},
            {Stream::LocalPath, "/not/yet"}},
           found);
    QCOMPARE(names(sourcesFor(Stream::CostmapLow, all)),
             (QStringList{QStringLiteral("/semantic/grid"), QStringLiteral("/semantic/grid_updates")}));
    QCOMPARE(names(sourcesFor(Stream::Path, all)), QStringList{QStringLiteral("/teb/trajectory")});
    QCOMPARE(sourcesFor(Stream::Planning, all).front().form, Form::PoseArray);
    QCOMPARE(sourcesFor(Stream::LocalPath, all).front().form, Form::Path);
    QVERIFY(!sourcesFor(Stream::LocalPath, all).front().found);
    QCOMPARE(names(sourcesFor(Stream::WholeMap, all)).first(), QStringLiteral("/map"));
  }

  void aListOfPosesIsSeveralTargets() {
    RosWorld world;
    give(world, kStatic, tf("map", "odom", 10, 0, 0, 0));
    const Source poses{Stream::Planning, Form::PoseArray, "/particles", {}, {}, true};
    const auto planning =
        messageOf<map::PlanningState>(give(world, poses,
                                           "{" + header("odom", kNow) + R"(,"poses":[)" + pose(1, 2, 0.5) +
                                               "," + R"({"position":{"x":null}},)" + pose(3, 4, 0) + "]}"));
    QVERIFY(planning && planning->targets.size() == 2);
    QCOMPARE(planning->targets[1], (geometry::Pose2{13, 4, 0}));
    QVERIFY(std::abs(planning->targets[0].yaw_rad - 0.5) < 1e-9);
  }

  void howOldTransformsAreIsToldByTheClockOfTheRobot() {
    RosWorld world;
    give(world, kStatic, tf("base_link", "laser", 0, 0, 0, 0), kNow);
    give(world, kTf, tf("map", "odom", 0, 0, 0, 100), kNow);  // its clock is elsewhere
    give(world, kTf, tf("odom", "base_link", 0, 0, 0, 103), kNow + 0.5);
    const auto ages = world.ages(kNow + 2.5);
    QCOMPARE(ages.size(), std::size_t(2));
    QCOMPARE(ages[0].first.child, std::string("odom"));
    QCOMPARE(ages[0].second, 5.0);
    QCOMPARE(ages[1].second, 2.0);
  }

  void aServerThatDoesNotTellIsAskedByTheUsualNames() {
    const auto all = sourcesOf(std::nullopt, {});
    const QStringList path = names(sourcesFor(Stream::Path, all));
    QVERIFY(path.contains(QLatin1String("/plan")));
    QVERIFY(path.contains(QLatin1String("/move_base/NavfnROS/plan")));
    QVERIFY(names(sourcesFor(Stream::WholeMap, all)).contains(QLatin1String("/map_updates")));
    for (const Source& source : all) QVERIFY(!source.found && source.type.empty());
  }

  // The world.

  void theMapLiesInItsOwnFrame() {
    RosWorld world;
    const auto map = messageOf<map::GridMessage>(give(world, kMap, grid("/world", kNow)));
    QVERIFY(map);
    QCOMPARE(world.fixedFrame(), std::string("world"));
    QCOMPARE(map->grid.origin, (geometry::Pose2{1, 2, 0}));
    QCOMPARE(map->reading.mode, map::CellReading::Mode::Raw);
    QVERIFY(!map->fingerprint.empty());
  }

  void aCostmapOfAnotherFrameIsMovedIntoTheMap() {
    RosWorld world;
    give(world, kTf, tf("map", "odom", 10, 0, M_PI / 2, kNow));
    const auto map = messageOf<map::GridMessage>(give(world, kLocal, grid("odom", kNow)));
    QVERIFY(map);
    QVERIFY(std::abs(map->grid.origin.x_m - 8) < 1e-9);
    QVERIFY(std::abs(map->grid.origin.y_m - 1) < 1e-9);
    QVERIFY(std::abs(map->grid.origin.yaw_rad - M_PI / 2) < 1e-9);
  }

  void aMessageWaitsForItsTransform() {
    RosWorld world;
    give(world, kTf, tf("map", "odom", 0, 0, 0, kNow));
    QVERIFY(!messageOf<map::LocalPathMessage>(give(world, kPath, path("odom", kNow + 0.1))));
    QVERIFY(world.overdue(kNow + 0.5).empty());
    const auto later =
        messageOf<map::LocalPathMessage>(give(world, kTf, tf("map", "odom", 1, 0, 0, kNow + 0.2)));
    QVERIFY(later);
    // Where the frame was at the time of the message: half-way.
    QVERIFY(std::abs(later->points.front().x() - 1.5) < 1e-6);
  }

  void aTransformThatDoesNotComeIsNamedAndNotGuessed() {
    RosWorld world;
    QVERIFY(!messageOf<map::LocalPathMessage>(give(world, kPath, path("odom", kNow))));
    QCOMPARE(unplaced(world.overdue(kNow + 2)), std::optional(robot::ros::fault::RosFrameUnknown));
    QVERIFY(world.overdue(kNow + 4).empty());  // told once
    // It is not forgotten.
    QVERIFY(messageOf<map::LocalPathMessage>(give(world, kStatic, tf("map", "odom", 0, 0, 0, 0), kNow + 5)));
  }

  // More of them come than are kept: none of those is ever as old as it takes to be late.
  void aFastTopicWithoutATransformIsTold() {
    RosWorld world;
    for (int i = 0; i < 30; ++i) {
      give(world, kPath, path("odom", kNow + 0.05 * i), kNow + 0.05 * i);
      QCOMPARE(unplaced(world.overdue(kNow + 0.05 * i)).has_value(), i == 21);
    }
    // The newest of them are there when it comes.
    give(world, kStatic, tf("map", "odom", 0, 0, 0, 0), kNow + 2);
    QVERIFY(world.overdue(kNow + 9).empty());
  }

  void markersThatHaveLivedTheirTimeGo() {
    RosWorld world;
    const QByteArray cube = "{" + header("map", kNow) + R"(,"ns":"a","id":1,"type":1,"action":0,"pose":)" +
                            pose(1, 2, 0) +
                            R"(,"scale":{"x":1,"y":1,"z":1},"lifetime":{"secs":2,"nsecs":0}})";
    const auto shown =
        messageOf<map::SeenObjectsMessage>(give(world, kMarkers, R"({"markers":[)" + cube + "]}", kNow));
    QVERIFY(shown && shown->objects.size() == 1);
    QVERIFY(world.overdue(kNow + 1).empty());
    const auto left = messageOf<map::SeenObjectsMessage>(world.overdue(kNow + 3));
    QVERIFY(left && left->objects.empty());
    QVERIFY(world.overdue(kNow + 4).empty());
  }

  void framesThatDoNotHangTogetherAreNamed() {
    RosWorld world;
    give(world, kStatic, tf("map", "other", 0, 0, 0, 0));
    give(world, kStatic, tf("odom", "base_link", 0, 0, 0, 0));
    give(world, kPath, path("odom", kNow));
    QCOMPARE(unplaced(world.overdue(kNow + 2)), std::optional(robot::ros::fault::RosFramesApart));
  }

  void anUpdateChangesTheGridThatItBelongsTo() {
    RosWorld world;
    world.keepGrids({"/local_costmap/costmap"});
    const QByteArray patch = "{" + header("map", kNow) + R"(,"x":1,"y":0,"width":1,"height":2,"data":[7,8]})";
    QVERIFY(!messageOf<map::GridMessage>(give(world, kPatches, patch)));  // of nothing
    give(world, kLocal, grid("map", kNow));
    const auto changed = messageOf<map::GridMessage>(give(world, kPatches, patch));
    QVERIFY(changed && changed->topic == "/local_costmap/costmap");
    const std::string cells = changed->png->substr(changed->png->size() - 4);
    QCOMPARE(cells, (std::string{char(255), 8, 0, 7}));  // row 0 on top
  }

  void anUpdateOfAnotherFrameIsLeftOutAndNamed() {
    RosWorld world;
    world.keepGrids({"/local_costmap/costmap"});
    give(world, kLocal, grid("map", kNow));
    const auto patch = [](const char* frame, double at_s) {
      return "{" + header(frame, at_s) + R"(,"x":1,"y":0,"width":1,"height":2,"data":[7,8]})";
    };
    const auto results = give(world, kPatches, patch("odom", kNow));
    QVERIFY(!messageOf<map::GridMessage>(results));
    QCOMPARE(results.back().unreadable, Fault(robot::ros::fault::RosPatchInOtherFrame, {"odom", "map"}));
    // One from before the grid is in it already.
    const auto late = give(world, kPatches, patch("map", kNow - 1));
    QVERIFY(!messageOf<map::GridMessage>(late) && !late.back().unreadable);
    QVERIFY(messageOf<map::GridMessage>(give(world, kPatches, patch("map", kNow + 1))));
  }

  // A lidar without a robot.
  void aScanThatNothingPlacesIsShownInItsOwnFrame() {
    RosWorld world;
    const auto scan = [](double at_s) {
      return "{" + header("laser", at_s) +
             R"(,"angle_min":0,"angle_increment":0.1,"range_min":0,"range_max":9,"ranges":[1,2]})";
    };
    QVERIFY(!messageOf<map::PointCloudMessage>(give(world, kScan, scan(kNow))));  // it may still be placed
    QVERIFY(world.overdue(kNow + 0.5).empty());
    const WorldResults late = world.overdue(kNow + 1.5);
    const auto shown = messageOf<map::PointCloudMessage>(late);
    QVERIFY(shown);
    QCOMPARE(shown->points->front().x_m, 1.0);
    QCOMPARE(late.front().notes, std::vector<Fault>({{robot::ros::fault::RosFrameAlone, {"laser"}}}));
    const WorldResults next = give(world, kScan, scan(kNow + 2), kNow + 2);
    QVERIFY(messageOf<map::PointCloudMessage>(next));
    QCOMPARE(next.back().notes.size(), std::size_t(1));  // as long as it is so
    // A map comes: where the scan lies on it nobody knows, and it does not stay as if it were known.
    const auto gone = messageOf<map::PointCloudMessage>(give(world, kMap, grid("map", kNow + 3), kNow + 3));
    QVERIFY(gone && gone->points->empty());
    QVERIFY(!messageOf<map::PointCloudMessage>(give(world, kScan, scan(kNow + 3), kNow + 3)));
    QCOMPARE(unplaced(world.overdue(kNow + 5)), std::optional(robot::ros::fault::RosFrameUnknown));
  }

  // Its frames are those of its wheels: they only took their time.
  void aScanThatTransformsPlaceInTheEndIsNotInItsOwnFrame() {
    RosWorld world;
    const auto scan = [](double at_s) {
      return "{" + header("laser", at_s) +
             R"(,"angle_min":0,"angle_increment":0.1,"range_min":0,"range_max":9,"ranges":[1,2]})";
    };
    give(world, kScan, scan(kNow));
    give(world, kStatic, tf("base_link", "laser", 0, 0, 0, 0), kNow + 0.5);
    give(world, kTf, tf("odom", "base_link", 5, 0, 0, kNow), kNow + 0.6);
    QVERIFY(!messageOf<map::PointCloudMessage>(world.overdue(kNow + 1.2)));
    for (const double at_s : {1.3, 1.7}) {
      for (const WorldResult& result :
           give(world, kTf, tf("odom", "base_link", 5, 0, 0, kNow + at_s), kNow + at_s))
        QVERIFY(result.notes.empty());
    }
    const WorldResults placed = give(world, kScan, scan(kNow + 1.5), kNow + 1.8);
    QVERIFY(messageOf<map::PointCloudMessage>(placed) && placed.back().notes.empty());
    QCOMPARE(messageOf<map::PointCloudMessage>(placed)->points->front().x_m, 6.0);
  }

  void aScanIsPutRightByWhereTheRobotWasMeanwhile() {
    RosWorld world;
    give(world, kTf, tf("map", "laser", 0, 0, 0, kNow));
    const QByteArray scan = "{" + header("laser", kNow) +
                            R"(,"angle_min":0,"angle_increment":0,"time_increment":0.5,"range_min":0,)"
                            R"("range_max":9,"ranges":[1,1,1]})";
    // The end of its sweep is not known yet.
    QVERIFY(!messageOf<map::PointCloudMessage>(give(world, kScan, scan)));
    const auto placed =
        messageOf<map::PointCloudMessage>(give(world, kTf, tf("map", "laser", 4, 0, 0, kNow + 1)));
    QVERIFY(placed);
    for (int i = 0; i < 3; ++i)
      QVERIFY(std::abs(placed->points->at(std::size_t(i)).x_m - (1 + 2 * i)) < 1e-6);
  }

  void aScanWhoseEndStaysUnknownIsPlacedByItsBeginning() {
    RosWorld world;
    give(world, kTf, tf("map", "laser", 3, 0, 0, kNow));
    const QByteArray scan = "{" + header("laser", kNow) +
                            R"(,"angle_min":0,"angle_increment":0,"time_increment":0.5,"range_min":0,)"
                            R"("range_max":9,"ranges":[1,1,1]})";
    QVERIFY(!messageOf<map::PointCloudMessage>(give(world, kScan, scan)));
    const auto placed = messageOf<map::PointCloudMessage>(world.overdue(kNow + 2));
    QVERIFY(placed);
    for (const map::CloudPoint& point : *placed->points) QVERIFY(std::abs(point.x_m - 4) < 1e-6);
  }

  void aMarkerWithoutAPlaceKeepsNoOtherFromItsOwn() {
    RosWorld world;
    give(world, kStatic, tf("map", "odom", 5, 0, 0, 0));
    const QByteArray both = R"({"markers":[)" + marker(1, "odom") + ',' + marker(2, "nowhere") + "]}";
    const auto results = give(world, kMarkers, both);
    const auto seen = messageOf<map::SeenObjectsMessage>(results);
    QVERIFY(seen && seen->objects.size() == 1);
    QVERIFY(std::abs(seen->objects[0].pose.x_m - 5) < 1e-9);
    QVERIFY(!unplaced(results));
    QCOMPARE(unplaced(world.overdue(kNow + 2)), std::optional(robot::ros::fault::RosFrameUnknown));
    const auto later = give(world, kStatic, tf("map", "nowhere", 1, 0, 0, 0), kNow + 3);
    QCOMPARE(messageOf<map::SeenObjectsMessage>(later)->objects.size(), std::size_t(2));
    QVERIFY(!unplaced(world.overdue(kNow + 4)));
  }

  void markersOfAllTopicsAreSeenTogetherAndGoWhenTheirTimeIsOver() {
    RosWorld world;
    give(world, kStatic, tf("map", "odom", 5, 0, 0, 0));
    const Source other{Stream::SeenObjects, Form::Markers, "/objects", {}, {}, true};
    give(world, kMarkers, marker(1, "map"));
    const auto both = messageOf<map::SeenObjectsMessage>(
        give(world, other, marker(1, "map", R"(,"lifetime":{"sec":2,"nanosec":0})")));
    QVERIFY(both && both->objects.size() == 2);
    QVERIFY(!messageOf<map::SeenObjectsMessage>(world.overdue(kNow + 1.9)));
    const auto left = messageOf<map::SeenObjectsMessage>(world.overdue(kNow + 2.1));
    QVERIFY(left && left->objects.size() == 1);
  }

  void aMarkerStaysWhereItWasPutUnlessItIsLockedToItsFrame() {
    RosWorld world;
    give(world, kTf, tf("map", "base_link", 1, 0, 0, kNow));
    give(world, kMarkers,
         R"({"markers":[)" + marker(1, "base_link") + ',' +
             marker(2, "base_link", R"(,"frame_locked":true)") + "]}");
    give(world, kTf, tf("map", "base_link", 9, 0, 0, kNow + 1), kNow + 1);
    const auto seen = messageOf<map::SeenObjectsMessage>(world.overdue(kNow + 1.1));
    QVERIFY(seen && seen->objects.size() == 2);
    QVERIFY(std::abs(seen->objects[0].pose.x_m - 1) < 1e-9);
    QVERIFY(std::abs(seen->objects[1].pose.x_m - 9) < 1e-9);
  }

  void aMarkerThatIsSentAgainIsSeenUntilTheNewOneHasItsPlace() {
    RosWorld world;
    give(world, kTf, tf("map", "base_link", 1, 0, 0, kNow));
    give(world, kMarkers, marker(1, "base_link"));
    QByteArray next = marker(1, "base_link");
    next.replace(R"("sec":100)", R"("sec":101)");
    const auto held = messageOf<map::SeenObjectsMessage>(give(world, kMarkers, next, kNow + 1));
    QVERIFY(held && held->objects.size() == 1 && std::abs(held->objects[0].pose.x_m - 1) < 1e-9);
    const auto moved = messageOf<map::SeenObjectsMessage>(
        give(world, kTf, tf("map", "base_link", 2, 0, 0, kNow + 1), kNow + 1.2));
    QVERIFY(moved && std::abs(moved->objects[0].pose.x_m - 2) < 1e-9);
  }

  void servicesThatGiveAMapAreKnownByTheirNames() {
    const auto like = likeMapServices({"/robot/dynamic_map", "/static_map", "/map_server/map", "/save_map",
                                       "/rosapi/topics", "/mapper/get_map"},
                                      "/robot");
    QCOMPARE(like, (std::vector<std::string>{"/robot/dynamic_map", "/static_map", "/map_server/map",
                                             "/mapper/get_map"}));
    std::vector<Source> sources{kMap};
    addMapServices(sources, {"/static_map"});
    QCOMPARE(sources.size(), std::size_t(2));
    QVERIFY(sources[1].form == Form::MapService && sources[1].base == "/map");
    // It is no topic, and nobody subscribes to it.
    QVERIFY(!topicsFor({{Stream::WholeMap}, {}, {}, {}, false}, sources, {}).contains("/static_map"));
  }

  void aTransformThatIsNoneIsNamed() {
    RosWorld world;
    QByteArray wrong = tf("odom", "base_link", 1, 0, 0, kNow);
    wrong.replace(R"("w":1)", R"("w":0)");
    const auto remarkOf = [](const WorldResults& results) {
      return results.back().notes.empty() ? Fault() : results.back().notes.front();
    };
    const Fault named(robot::ros::fault::RosFieldMissing, {"transforms[base_link].transform"});
    QCOMPARE(remarkOf(give(world, kTf, wrong)), named);
    QCOMPARE(remarkOf(give(world, kTf, tf("map", "odom", 1, 0, 0, kNow))), named);  // that is another one
    QCOMPARE(remarkOf(give(world, kTf, tf("odom", "base_link", 1, 0, 0, kNow))), Fault());
  }

  void whereTheRobotIsComesByTransforms() {
    RosWorld world;
    QVERIFY(!world.pose());
    give(world, kTf, tf("map", "odom", 1, 0, 0, kNow));
    give(world, kTf, tf("odom", "base_footprint", 1, 1, 0.5, kNow));
    QCOMPARE(world.robotFrame(), std::string("base_footprint"));
    const auto pose = world.pose();
    QVERIFY(pose && *pose);
    QVERIFY(std::abs((*pose)->x_m - 2) < 1e-9 && std::abs((*pose)->yaw_rad - 0.5) < 1e-9);
  }

  void withoutTransformsAPoseOnTheMapTells() {
    RosWorld world;
    give(world, kOdom, "{" + header("odom", kNow) + R"(,"pose":{"pose":)" + pose(9, 9, 0) + "}}");
    QVERIFY(world.pose() && !*world.pose());  // odom lies nowhere
    give(world, kAmcl, "{" + header("map", kNow) + R"(,"pose":{"pose":)" + pose(3, 4, 0) + "}}");
    QVERIFY(world.pose() && *world.pose());
    QCOMPARE((*world.pose())->x_m, 3.0);
  }

  void theFixedFrameIsTheRootWhereThereIsNoMap() {
    RosWorld world;
    QCOMPARE(world.fixedFrame(), std::string("map"));
    // What never changes comes first, and its root is nobody's map.
    give(world, kStatic, tf("base_link", "laser", 0, 0, 0, 0), kNow);
    QCOMPARE(world.fixedFrame(), std::string("map"));
    give(world, kTf, tf("odom", "base_link", 0, 0, 0, kNow), kNow + 0.5);
    QCOMPARE(world.fixedFrame(), std::string("map"));  // which may still come
    give(world, kTf, tf("odom", "base_link", 0, 0, 0, kNow + 1), kNow + 1.1);
    QCOMPARE(world.fixedFrame(), std::string("odom"));
    give(world, kTf, tf("map", "odom", 0, 0, 0, kNow + 1), kNow + 1.2);
    QCOMPARE(world.fixedFrame(), std::string("map"));
  }

  void theOutlineIsThatOfTheRobot() {
    RosWorld world;
    give(world, kTf, tf("odom", "base_link", 5, 5, 0, kNow));
    const auto model = messageOf<map::RobotModel>(give(
        world, kFootprint,
        "{" + header("odom", kNow) +
            R"(,"polygon":{"points":[{"x":4.5,"y":4.5,"z":0},{"x":5.5,"y":4.5,"z":0},{"x":5,"y":6,"z":0}]}})"));
    QVERIFY(model);
    QVERIFY((model->footprint.front() - Eigen::Vector2d(-0.5, -0.5)).norm() < 1e-9);
  }

  void loopsOfFramesAreTold() {
    RosWorld world;
    give(world, kTf, tf("map", "odom", 0, 0, 0, kNow));
    const WorldResults results = give(world, kTf, tf("odom", "map", 0, 0, 0, kNow));
    const bool told = std::any_of(results.begin(), results.end(), [](const WorldResult& result) {
      return !result.notes.empty() && result.notes.front().code == robot::ros::fault::RosTransformLoop;
    });
    QVERIFY(told);
  }

  void garbageIsUnreadable() {
    for (const Source& source : {kMap, kPath, kFootprint, kAmcl, kOdom}) {
      RosWorld world;
      const WorldResults results = give(world, source, R"({"header":7,"info":[],"poses":{},"data":"x"})");
      QVERIFY(results.size() == 1 && results.front().unreadable && !results.front().message);
    }
  }
};

}  // namespace test_ros_parts

MAPWRIGHT_TEST(test_ros_parts, RosPartsTest, Core)
#include "test_ros_parts.moc"
