// Grids, poses, lines and transforms as ROS 1 and ROS 2 send them.
#include <atomic>
#include <cmath>

#include <QTest>

#include "grids/faults.h"
#include "grids/grid_pyramid.h"
#include "map/faults.h"
#include "robot/ros/faults.h"
#include "robot/ros/map_values.h"
#include "robot/ros/read_messages.h"
#include "ros_messages.h"
#include "test_program.h"

namespace test_ros_messages {

using namespace mapwright;
using namespace mapwright::robot::ros;
using test::byCbor;
using test::byJson;
using test::Sent;

namespace {

using Cells = std::vector<std::int8_t>;

const char* const kPose = R"({"position":{"x":1,"y":-2.5,"z":0.3},"orientation":{"x":0,"y":0,"z":1,"w":0}})";

QByteArray gridText(const QByteArray& info, const QByteArray& data) {
  return R"({"header":{"frame_id":"\/map","stamp":{"secs":12,"nsecs":500000000},"seq":7},"info":{)" + info +
         R"(},"data":)" + data + "}";
}

QByteArray infoOf(int width, int height, const QByteArray& resolution = "0.05000000074505806") {
  return R"("map_load_time":{"secs":0,"nsecs":0},"resolution":)" + resolution + R"(,"width":)" +
         QByteArray::number(width) + R"(,"height":)" + QByteArray::number(height) + R"(,"origin":)" + kPose;
}

Fault unavailableReason(const QByteArray& grid) {
  const auto read = readGrid(byJson(grid).msg);
  return read ? Fault() : read.error();
}

std::optional<FaultCode> remarkOf(const Grid& grid) {
  return grid.notes.empty() ? std::nullopt : std::optional(grid.notes.front().code);
}

Grid gridOf(int width, int height, Cells cells) {
  Grid grid;
  grid.width = width;
  grid.height = height;
  grid.resolution_m = 0.5;
  grid.cells = std::move(cells);
  return grid;
}

GridPatch patchOf(int x, int y, int width, int height, Cells cells) {
  GridPatch patch;
  patch.x = x;
  patch.y = y;
  patch.width = width;
  patch.height = height;
  patch.cells = std::move(cells);
  return patch;
}

}  // namespace

class RosMessagesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aGridIsReadFromBothWires_data() {
    QTest::addColumn<QByteArray>("header");
    QTest::addColumn<bool>("binary");
    for (const bool binary : {false, true}) {
      QTest::addRow("ROS 1, %s", binary ? "cbor" : "json")
          << QByteArray(R"({"seq":3,"stamp":{"secs":12,"nsecs":500000000},"frame_id":"/map"})") << binary;
      QTest::addRow("ROS 2, %s", binary ? "cbor" : "json")
          << QByteArray(R"({"stamp":{"sec":12,"nanosec":500000000},"frame_id":"map"})") << binary;
    }
  }
  void aGridIsReadFromBothWires() {
    QFETCH(QByteArray, header);
    QFETCH(bool, binary);
    const QByteArray text =
        R"({"header":)" + header + R"(,"info":{)" + infoOf(3, 2) + R"(},"data":[-1,0,100,5,50,99]})";
    QCborMap map = test::cborOf(text);
    map[QStringLiteral("data")] =
        test::typed(test::TypedArray::Int8, QByteArray("\xff\x00\x64\x05\x32\x63", 6));
    const Sent sent = binary ? byCbor(map) : byJson(text);
    const auto grid = readGrid(sent.msg);
    QVERIFY(grid);
    QCOMPARE(grid->header.frame, std::string("map"));
    QCOMPARE(grid->header.stamp_s, std::optional(12.5));
    QCOMPARE(grid->width, 3);
    QCOMPARE(grid->height, 2);
    QVERIFY(std::abs(grid->resolution_m - 0.05) < 1e-8);
    QCOMPARE(grid->origin.x_m, 1.0);
    QCOMPARE(grid->origin.y_m, -2.5);
    QVERIFY(std::abs(std::abs(grid->origin.yaw_rad) - 3.14159265358979) < 1e-9);
    QCOMPARE(grid->cells, (Cells{-1, 0, 100, 5, 50, 99}));
    QVERIFY(grid->notes.empty());
  }

  void theGridOfAProjectedMapIsReadLikeAnyOther() {
    const auto grid = readGrid(
        byJson(R"({"map":)" + gridText(infoOf(2, 1), "[0,100]") + R"(,"min_z":0.1,"max_z":1.8})").msg);
    QVERIFY(grid);
    QCOMPARE(grid->cells, (Cells{0, 100}));
    QCOMPARE(QByteArray::fromStdString(grid->header.frame), QByteArray("map"));
  }

  void aStampOfZeroIsNone() {
    const auto grid =
        readGrid(byJson(R"({"header":{"frame_id":"map","stamp":{"sec":0,"nanosec":0}},"info":{)" +
                        infoOf(1, 1) + R"(},"data":[0]})")
                     .msg);
    QVERIFY(grid);
    QCOMPARE(grid->header.stamp_s, std::nullopt);
  }

  void aZeroQuaternionIsYawZeroAndSaysSo() {
    for (const char* const turn : {R"({"x":0,"y":0,"z":0,"w":0})", R"({"x":null,"y":0,"z":0,"w":1})", "{}"}) {
      const auto grid =
          readGrid(byJson(gridText(R"("resolution":0.1,"width":1,"height":1,"origin":{"position":)"
                                   R"({"x":1,"y":2,"z":0},"orientation":)" +
                                       QByteArray(turn) + "}",
                                   "[0]"))
                       .msg);
      QVERIFY(grid);
      QCOMPARE(grid->origin, (geometry::Pose2{1, 2, 0}));
      QCOMPARE(remarkOf(*grid), std::optional(robot::ros::fault::RosTurnIsZero));
    }
  }

  void anUnnormalisedQuaternionIsATurnLikeAnyOther() {
    const auto grid = readGrid(
        byJson(gridText(R"("resolution":0.1,"width":1,"height":1,"origin":{"position":{"x":1,"y":2},)"
                        R"("orientation":{"x":0,"y":0,"z":5,"w":5}})",
                        "[0]"))
            .msg);
    QVERIFY(grid);
    QVERIFY(std::abs(grid->origin.yaw_rad - 1.5707963267949) < 1e-9);
    QVERIFY(grid->notes.empty());
  }

  void aGridWithoutCellsSaysSo() {
    QCOMPARE(unavailableReason(gridText(infoOf(0, 0), "[]")), Fault(robot::ros::fault::RosGridEmpty, {0, 0}));
    QCOMPARE(unavailableReason(gridText(infoOf(5, 0), "[]")), Fault(robot::ros::fault::RosGridEmpty, {5, 0}));
  }

  void aGridOfAnotherLengthThanItSaysIsNotShown() {
    QCOMPARE(unavailableReason(gridText(infoOf(2, 2), "[0,0,0]")),
             Fault(robot::ros::fault::RosLengthDiffers, {"data", 3, 4}));
    QCOMPARE(unavailableReason(gridText(infoOf(2, 2), "[0,0,0,0,0]")),
             Fault(robot::ros::fault::RosLengthDiffers, {"data", 5, 4}));
    QCOMPARE(unavailableReason(gridText(infoOf(2, 2), "[]")),
             Fault(robot::ros::fault::RosLengthDiffers, {"data", 0, 4}));
  }

  void cellsThatMeanNothingAreUnknownAndCounted() {
    // As bytes, beyond bytes, broken and absent: by the short way and by the long one.
    for (const char* const data : {"[0,-2,101,127,100,-1]", "[0,255,-300,2.5,100,null]"}) {
      const auto grid = readGrid(byJson(gridText(infoOf(6, 1), data)).msg);
      QVERIFY(grid);
      QCOMPARE(grid->cells, (Cells{0, -1, -1, -1, 100, -1}));
      QCOMPARE(remarkOf(*grid), std::optional(grids::fault::RosCellsOutOfRange));
      const bool null_counts = QByteArray(data).contains("null");
      QCOMPARE(std::get<std::int64_t>(grid->notes[0].arguments[0]), null_counts ? 4 : 3);
    }
  }

  void anAbsurdResolutionOrPlaceIsNamed() {
    QCOMPARE(unavailableReason(gridText(infoOf(1, 1, "0"), "[0]")).code, map::fault::ResolutionNotPositive);
    QCOMPARE(unavailableReason(gridText(infoOf(1, 1, "-0.05"), "[0]")).code,
             map::fault::ResolutionNotPositive);
    QCOMPARE(unavailableReason(gridText(infoOf(1, 1, "1e9"), "[0]")).code, map::fault::ResolutionOutOfBounds);
    QCOMPARE(unavailableReason(gridText(infoOf(1, 1, "null"), "[0]")).code, map::fault::ResolutionNoNumber);
    QCOMPARE(unavailableReason(gridText(R"("resolution":1,"width":1,"height":1)", "[0]")).code,
             map::fault::OriginNoNumber);
  }

  void absurdSizesTakeNoMemory() {
    QCOMPARE(unavailableReason(gridText(infoOf(2'000'000'000, 2'000'000'000), "[0]")),
             Fault(robot::ros::fault::RosFieldWrong, {"info.width", 2e9}));
    QCOMPARE(unavailableReason(gridText(infoOf(200'000'000, 200'000'000), "[0]")).code,
             robot::ros::fault::RosFieldWrong);
    QCOMPARE(unavailableReason(gridText(infoOf(-1, 5), "[0]")),
             Fault(robot::ros::fault::RosFieldWrong, {"info.width", -1.0}));
  }

  void whatIsMissingIsNamed() {
    QCOMPARE(unavailableReason("{}"), Fault(robot::ros::fault::RosFieldMissing, {"info"}));
    QCOMPARE(unavailableReason(gridText(R"("height":2)", "[0]")),
             Fault(robot::ros::fault::RosFieldMissing, {"info.width"}));
    QCOMPARE(unavailableReason(gridText(R"("width":"a","height":2)", "[0]")).arguments[0],
             FaultArgument("info.width"));
    QCOMPARE(unavailableReason(gridText(infoOf(1, 1), R"("AAAA")")),
             Fault(robot::ros::fault::RosFieldMissing, {"data"}));
    QCOMPARE(unavailableReason(gridText(infoOf(1, 1), "{}")),
             Fault(robot::ros::fault::RosFieldMissing, {"data"}));
  }

  void aPatchGoesIntoItsGrid() {
    const auto patch = readGridPatch(
        byJson(R"({"header":{"frame_id":"map"},"x":1,"y":1,"width":2,"height":1,"data":[7,-1]})").msg);
    QVERIFY(patch);
    Grid grid = gridOf(3, 2, {0, 0, 0, 50, 50, 50});
    QVERIFY(!applyPatch(grid, *patch));
    QCOMPARE(grid.cells, (Cells{0, 0, 0, 50, 7, -1}));
  }

  void aPatchThatLiesElsewhereChangesNothing() {
    const Cells before{0, 1, 2, 3};
    constexpr int kFar = 1 << 30;
    for (const GridPatch& patch :
         {patchOf(1, 0, 2, 1, {9, 9}), patchOf(0, 2, 1, 1, {9}), patchOf(-1, 0, 1, 1, {9}),
          patchOf(kFar, kFar, 1, 1, {9}), patchOf(0, 0, 3, 1, {9, 9, 9}), patchOf(0, 0, 2, 2, {9})}) {
      Grid grid = gridOf(2, 2, before);
      const auto why = applyPatch(grid, patch);
      QVERIFY(why);
      QCOMPARE(why->code, robot::ros::fault::RosPatchOutside);
      QCOMPARE(grid.cells, before);
    }
    const auto far = readGridPatch(byJson(R"({"x":1e15,"y":0,"width":1,"height":1,"data":[0]})").msg);
    QVERIFY(!far);
    QCOMPARE(far.error().arguments[0], FaultArgument("x"));
  }

  void theCellsOfAGridComeBackExactlyFromItsPicture() {
    Cells cells;
    for (int cell = -1; cell <= 100; ++cell) cells.push_back(std::int8_t(cell));
    const Grid grid = gridOf(51, 2, cells);
    grids::GridOptions options;
    options.reading = kPgmReading;
    const auto reading = grids::openGrid(std::make_shared<const std::string>(pgmOf(grid)), options);
    QVERIFY(reading);
    const std::atomic<bool> never{false};
    QVERIFY(!(*reading)->read(never, [] {}));
    const auto pyramid = (*reading)->pyramid();
    QCOMPARE(pyramid->code(), grids::CellCode::Occupancy);
    QCOMPARE(pyramid->width(), 51);
    const grids::CellMeaning& meaning = grids::meaningOf(pyramid->code());
    for (int n = 0; n < 102; ++n) {
      // Its first row lies at the bottom.
      const std::uint8_t byte = pyramid->at(n % 51, 1 - n / 51);
      QCOMPARE(int(meaning.occupancy[byte]), n - 1);
      QCOMPARE(meaning.known[byte], n > 0);
    }
    QVERIFY(pgmOf(gridOf(3, 2, {0})).empty());
    QVERIFY(pgmOf(Grid()).empty());
  }

  void aGridIsPlacedByTheFrameItIsIn() {
    Grid grid = gridOf(2, 1, {0, 100});
    grid.origin = {1, 0, 0};
    const Transform3 odom{{10, 20, 0},
                          Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()))};
    const map::GridMessage message = gridMessage(grid, "/costs", map::GridKind::CostmapLow, odom);
    QCOMPARE(message.topic, std::string("/costs"));
    QCOMPARE(message.kind, map::GridKind::CostmapLow);
    QCOMPARE(message.reading.mode, map::CellReading::Mode::Raw);
    QCOMPARE(message.grid.width, 2);
    QCOMPARE(message.grid.resolution_m, 0.5);
    QVERIFY((message.grid.worldFromCell({2, 1}) - Eigen::Vector2d(10, 22)).norm() < 1e-9);
    QCOMPARE(*message.png, pgmOf(grid));
  }

  void aPathIsItsPointsInItsFrame() {
    const auto path = readPath(
        byJson(R"({"header":{"frame_id":"odom"},"poses":[{"pose":{"position":{"x":1,"y":2,"z":0}}},)"
               R"({"pose":{"position":{"x":null,"y":2,"z":0}}},{},{"pose":{"position":{"x":3,"y":4}}}]})")
            .msg);
    QVERIFY(path);
    QCOMPARE(path->header.frame, std::string("odom"));
    QVERIFY(path->points == (map::Polyline{{1, 2}, {3, 4}}));
    QCOMPARE(path->left_out, std::size_t(2));
    const map::Polyline placed = placedIn(*path, Transform3{{10, 0, 5}, Eigen::Quaterniond::Identity()});
    QVERIFY(placed == (map::Polyline{{11, 2}, {13, 4}}));
    const auto empty = readPath(byJson(R"({"poses":[]})").msg);
    QVERIFY(empty && empty->points.empty());
    QCOMPARE(readPath(byJson("{}").msg).error(), Fault(robot::ros::fault::RosFieldMissing, {"poses"}));
  }

  void aPathWithoutAFrameHasThatOfItsFirstPose() {
    const auto path = readPath(byJson(R"({"header":{"frame_id":""},"poses":[{"header":{"frame_id":"/map"}},)"
                                      R"({"header":{"frame_id":"odom"}}]})")
                                   .msg);
    QVERIFY(path);
    QCOMPARE(path->header.frame, std::string("map"));
  }

  void anEndlessPathIsThinned() {
    QByteArray text = R"({"poses":[)";
    const int count = int(kMostOutlinePoints) * 2 + 2;
    for (int n = 0; n < count; ++n) {
      if (n > 0) text += ',';
      text += R"({"pose":{"position":{"x":)" + QByteArray::number(n) + R"(,"y":0}}})";
    }
    const auto path = readPath(byJson(text + "]}").msg);
    QVERIFY(path);
    QVERIFY(path->points.size() > kMostOutlinePoints / 2 && path->points.size() <= kMostOutlinePoints);
    QCOMPARE(path->points[1].x(), 3.0);
  }

  void aPolygonIsItsPoints() {
    const auto polygon =
        readPolygon(byJson(R"({"header":{"frame_id":"base_link","stamp":{"sec":1,"nanosec":0}},)"
                           R"("polygon":{"points":[{"x":1,"y":2,"z":0},{"x":-1,"y":0,"z":0}]}})")
                        .msg);
    QVERIFY(polygon);
    QVERIFY(polygon->points == (map::Polyline{{1, 2}, {-1, 0}}));
    QCOMPARE(readPolygon(byJson("{}").msg).error().arguments[0], FaultArgument("polygon.points"));
  }

  void posesOfAllKindsAreRead() {
    const QByteArray header = R"({"header":{"frame_id":"map"},)", pose = kPose;
    const Sent stamped = byJson(header + R"("pose":)" + pose + "}");
    const Sent with_covariance = byJson(header + R"("pose":{"covariance":[0],"pose":)" + pose + "}}");
    const Sent odometry =
        byJson(header + R"("child_frame_id":"/base_link","pose":{"pose":)" + pose + R"(},"twist":{}})");
    for (const auto& read : {readPoseStamped(stamped.msg), readPoseWithCovariance(with_covariance.msg),
                             readOdometry(odometry.msg)}) {
      QVERIFY(read);
      QCOMPARE(read->header.frame, std::string("map"));
      QCOMPARE(read->pose.x_m, 1.0);
      QCOMPARE(read->pose.y_m, -2.5);
      QVERIFY(std::abs(std::abs(read->pose.yaw_rad) - M_PI) < 1e-9);
      QVERIFY(!read->upright);
    }
    QCOMPARE(readOdometry(odometry.msg)->child_frame, std::string("base_link"));
    const geometry::Pose2 placed =
        placedIn(*readPoseStamped(stamped.msg), Transform3{{1, 1, 0}, Eigen::Quaterniond::Identity()});
    QCOMPARE(placed.x_m, 2.0);
    QCOMPARE(placed.y_m, -1.5);
  }

  void aPoseWithoutATurnIsUpright() {
    const auto pose = readPoseStamped(
        byJson(R"({"pose":{"position":{"x":1,"y":2,"z":0},"orientation":{"x":0,"y":0,"z":0,"w":0}}})").msg);
    QVERIFY(pose);
    QVERIFY(pose->upright);
    QCOMPARE(pose->pose, (geometry::Pose2{1, 2, 0}));
  }

  void aPoseWithoutAPlaceIsNone() {
    QCOMPARE(readPoseStamped(byJson(R"({"pose":{"position":{"x":1,"y":null}}})").msg).error(),
             Fault(robot::ros::fault::RosFieldMissing, {"pose.position.y"}));
    QCOMPARE(readOdometry(byJson("{}").msg).error(),
             Fault(robot::ros::fault::RosFieldMissing, {"pose.pose.position.x"}));
  }

  void transformsAreRead() {
    const auto rows = readTf(
        byJson(
            R"({"transforms":[{"header":{"frame_id":"/map","stamp":{"secs":5,"nsecs":0}},"child_frame_id":)"
            R"("odom","transform":{"translation":{"x":1,"y":2,"z":3},"rotation":{"x":0,"y":0,"z":1,"w":0}}},)"
            R"({"header":{"frame_id":""},"child_frame_id":"x"},{"header":{"frame_id":"a"}},)"
            R"({"header":{"frame_id":"a"},"child_frame_id":"b","transform":{"translation":{"x":null}}}]})")
            .msg);
    QCOMPARE(rows.size(), std::size_t(2));
    QCOMPARE(rows[0].parent, std::string("map"));
    QCOMPARE(rows[0].child, std::string("odom"));
    QCOMPARE(rows[0].stamp_s, 5.0);
    QVERIFY(rows[0].transform.t_m == Eigen::Vector3d(1, 2, 3));
    QVERIFY(rows[0].transform.q.z() == 1 && rows[0].transform.q.w() == 0);
    Transforms transforms;
    const TfRow& broken = rows[1];
    QCOMPARE(transforms.setTransform(broken.parent, broken.child, broken.transform, 1, false),
             Transforms::Taken::NoNumbers);
    QVERIFY(readTf(byJson(R"({"transforms":5})").msg).empty());
  }

  void typesOfBothGenerationsAreOne() {
    QCOMPARE(plainType("nav_msgs/msg/OccupancyGrid"), std::string("nav_msgs/OccupancyGrid"));
    QCOMPARE(plainType("nav_msgs/OccupancyGrid"), std::string("nav_msgs/OccupancyGrid"));
    QCOMPARE(plainType("std_srvs/srv/Empty"), std::string("std_srvs/Empty"));
    QCOMPARE(plainType("odd"), std::string("odd"));
    QCOMPARE(plainType(""), std::string());
  }

  void garbageIsReadWithoutHarm() {
    for (const char* const text :
         {"{}",
          R"({"info":[],"data":{},"header":5,"poses":{},"polygon":[],"markers":"x","transforms":[[],5,null],)"
          R"("pose":"x","ranges":7,"fields":{"x":1},"points":[]})",
          R"({"header":{"frame_id":{},"stamp":"now"},"info":{"width":{},"height":[]},"poses":[null,5,[]],)"
          R"("polygon":{"points":[null,{}]},"markers":[null,5,{}],"fields":[null,5],"width":1,"height":1,)"
          R"("point_step":1,"data":"!!"})"}) {
      const Sent sent = byJson(text);
      QVERIFY(!readGrid(sent.msg));
      QVERIFY(!readGridPatch(sent.msg));
      QVERIFY(!readPoseStamped(sent.msg));
      QVERIFY(!readLaserScan(sent.msg));
      QVERIFY(!readPointCloud2(sent.msg));
      const auto path = readPath(sent.msg);
      QVERIFY(!path || path->points.empty());
      const auto polygon = readPolygon(sent.msg);
      QVERIFY(!polygon || polygon->points.empty());
      std::int64_t left_out = 0;
      const auto markers = readMarkers(sent.msg, &left_out);
      QVERIFY(!markers || (markers->empty() && left_out == std::int64_t(sent.msg["markers"].size())));
      QVERIFY(readTf(sent.msg).empty());
    }
    QVERIFY(!readGrid(Field()));
  }
};

}  // namespace test_ros_messages

MAPWRIGHT_TEST(test_ros_messages, RosMessagesTest, Core)
#include "test_ros_messages.moc"
