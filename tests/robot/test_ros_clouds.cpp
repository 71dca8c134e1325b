// Scans and clouds as ROS sends them.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <QTest>

#include "robot/ros/faults.h"
#include "robot/ros/map_values.h"
#include "robot/ros/read_messages.h"
#include "robot/wire/faults.h"
#include "ros_messages.h"
#include "test_program.h"

namespace test_ros_clouds {

using namespace mapwright;
using namespace mapwright::robot::ros;
using test::byCbor;
using test::byJson;
using test::Sent;

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

template <typename T>
void append(QByteArray& bytes, T value, bool big_endian = false) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (big_endian) std::reverse(raw, raw + sizeof value);
  bytes.append(raw, sizeof value);
}

QByteArray floats(const std::vector<float>& values) {
  QByteArray bytes;
  for (const float value : values) append(bytes, value);
  return bytes;
}

struct CloudText {
  QByteArray fields =
      R"([{"name":"x","offset":0,"datatype":7,"count":1},{"name":"y","offset":4,"datatype":7,"count":1},)"
      R"({"name":"z","offset":8,"datatype":7,"count":1}])";
  qint64 width = 1, height = 1, point_step = 12, row_step = 12;
  bool big_endian = false;
  QByteArray text(const QByteArray& data) const {
    return R"({"header":{"frame_id":"laser","stamp":{"sec":3,"nanosec":0}},"fields":)" + fields +
           R"(,"width":)" + QByteArray::number(width) + R"(,"height":)" + QByteArray::number(height) +
           R"(,"point_step":)" + QByteArray::number(point_step) + R"(,"row_step":)" +
           QByteArray::number(row_step) + R"(,"is_bigendian":)" + (big_endian ? "true" : "false") +
           R"(,"is_dense":false,"data":)" + data + "}";
  }
  Sent sent(const QByteArray& bytes) const { return byJson(text('"' + bytes.toBase64() + '"')); }
};

Fault unavailableReason(const CloudText& cloud, const QByteArray& bytes) {
  const auto read = readPointCloud2(cloud.sent(bytes).msg);
  return read ? Fault() : read.error();
}

QByteArray scanText(const QByteArray& rest) {
  return R"({"header":{"frame_id":"/laser","stamp":{"secs":3,"nsecs":0}},"angle_min":0,"angle_max":3.2,)"
         R"("angle_increment":1.5707963267948966,"time_increment":0,"scan_time":0.1,)" +
         rest + "}";
}

bool isAt(const map::CloudPoint& point, double x_m, double y_m) {
  return std::abs(point.x_m - x_m) < 1e-6 && std::abs(point.y_m - y_m) < 1e-6;
}

}  // namespace

class RosCloudsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aScanIsTheEndsOfItsRays_data() {
    QTest::addColumn<bool>("binary");
    QTest::newRow("json") << false;
    QTest::newRow("cbor") << true;
  }
  void aScanIsTheEndsOfItsRays() {
    QFETCH(bool, binary);
    const QByteArray text =
        scanText(R"("range_min":0.1,"range_max":10,"ranges":[1,2,3],"intensities":[0,128,255])");
    QCborMap map = test::cborOf(text);
    map[QStringLiteral("ranges")] = test::typed(test::TypedArray::Float32, floats({1, 2, 3}));
    map[QStringLiteral("intensities")] = test::typed(test::TypedArray::Float32, floats({0, 128, 255}));
    const Sent sent = binary ? byCbor(map) : byJson(text);
    const auto scan = readLaserScan(sent.msg);
    QVERIFY(scan);
    QCOMPARE(scan->header.frame, std::string("laser"));
    QCOMPARE(scan->header.stamp_s, std::optional(3.0));
    QCOMPARE(scan->points.size(), std::size_t(3));
    QVERIFY(isAt(scan->points[0], 1, 0) && isAt(scan->points[1], 0, 2) && isAt(scan->points[2], -3, 0));
    QCOMPARE(int(scan->points[1].intensity), 128);
    QCOMPARE(scan->left_out, std::size_t(0));
    QVERIFY(scan->notes.empty());
  }

  void raysThatHitNothingAreLeftOutAndCounted() {
    // No number, too near, too far; infinities come as null or, by cbor, as what they are.
    const auto scan = readLaserScan(
        byJson(scanText(R"("range_min":0.5,"range_max":10,"ranges":[null,0.4,10.5,0.5,10])")).msg);
    QVERIFY(scan);
    QCOMPARE(scan->points.size(), std::size_t(2));
    QCOMPARE(scan->left_out, std::size_t(3));
    QVERIFY(isAt(scan->points[0], 0, -0.5) && isAt(scan->points[1], 10, 0));
    QCborMap map = test::cborOf(scanText(R"("range_min":0.5,"range_max":10)"));
    map[QStringLiteral("ranges")] =
        test::typed(test::TypedArray::Float32, floats({kNaN, std::numeric_limits<float>::infinity(), 2}));
    const auto by_cbor = readLaserScan(byCbor(map).msg);
    QVERIFY(by_cbor);
    QCOMPARE(by_cbor->points.size(), std::size_t(1));
    QCOMPARE(by_cbor->left_out, std::size_t(2));
  }

  void aScanWithoutAFarEndHasNone() {
    for (const char* const range :
         {R"("range_min":0,"range_max":null,)", R"("range_min":0,"range_max":0,)", ""}) {
      const auto scan = readLaserScan(byJson(scanText(QByteArray(range) + R"("ranges":[1,500])")).msg);
      QVERIFY(scan);
      QCOMPARE(scan->points.size(), std::size_t(2));
    }
  }

  void intensitiesAreBroughtTo255() {
    const auto brightest = [](const QByteArray& intensities) {
      const auto scan = readLaserScan(
          byJson(scanText(R"("range_min":0,"range_max":9,"ranges":[1,1],"intensities":)" + intensities)).msg);
      return scan ? int(scan->points[1].intensity) : -1;
    };
    QCOMPARE(brightest("[0.5,1]"), 255);
    QCOMPARE(brightest("[5,200]"), 200);
    QCOMPARE(brightest("[1000,8000]"), 255);
    QCOMPARE(brightest("[8000,4000]"), 128);
    QCOMPARE(brightest("[7]"), 0);
    QCOMPARE(brightest("[]"), 0);
    QCOMPARE(brightest("[null,null]"), 0);
  }

  void aScanKnowsWhenEachOfItsPointsWas() {
    QByteArray text = scanText(R"("range_min":0,"range_max":10,"ranges":[1,null,2,3])");
    QVERIFY(readLaserScan(byJson(text).msg)->when.empty());
    text.replace(R"("time_increment":0)", R"("time_increment":0.1)");
    const auto scan = readLaserScan(byJson(text).msg);
    QVERIFY(scan);
    QVERIFY(std::abs(scan->sweep_s - 0.3) < 1e-9);
    QCOMPARE(scan->points.size(), std::size_t(3));
    QCOMPARE(scan->when.size(), std::size_t(3));
    QVERIFY(scan->when[0] == 0 && std::abs(scan->when[1] - 2.0f / 3) < 1e-6f && scan->when[2] == 1);
    // A time that no scan takes is none.
    for (const char* absurd : {"-0.1", "1e9", "null"}) {
      QByteArray odd = text;
      odd.replace(R"("time_increment":0.1)", R"("time_increment":)" + QByteArray(absurd));
      const auto read = readLaserScan(byJson(odd).msg);
      QVERIFY2(read && read->sweep_s == 0 && read->when.empty(), absurd);
    }
  }

  void pointsOfASweepAreEachPlacedAsItsFrameLayThen() {
    Points points;
    points.points = {{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}};
    points.when = {0, 0.5f, 1};
    points.sweep_s = 0.1;
    const Transform3 from,
        to{{2, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ()))};
    const auto placed = placedAlong(points, "/scan", {from, to});
    QVERIFY(isAt(placed.points->at(0), 1, 0));
    QVERIFY(isAt(placed.points->at(1), 1, 1));
    QVERIFY(isAt(placed.points->at(2), 1, 0));
    const auto at_once = placedAlong(points, "/scan", {to});
    for (const map::CloudPoint& point : *at_once.points) QVERIFY(isAt(point, 1, 0));
  }

  void aScanWithoutItsAnglesIsNone() {
    QCOMPARE(readLaserScan(byJson(R"({"angle_min":0,"ranges":[1]})").msg).error(),
             Fault(robot::ros::fault::RosFieldMissing, {"angle_increment"}));
    QCOMPARE(readLaserScan(byJson(R"({"angle_min":null,"ranges":[1]})").msg).error(),
             Fault(robot::ros::fault::RosFieldMissing, {"angle_min"}));
    QCOMPARE(readLaserScan(byJson(scanText(R"("range_min":0)")).msg).error(),
             Fault(robot::ros::fault::RosFieldMissing, {"ranges"}));
  }

  void aCloudIsReadFromBothWires() {
    CloudText cloud;
    cloud.width = 2;
    cloud.row_step = 24;
    const QByteArray bytes = floats({1, 2, 3, -4, 5, 6});
    QCborMap map = test::cborOf(cloud.text("[]"));
    map[QStringLiteral("data")] = bytes;
    QByteArray numbers;
    for (const char byte : bytes)
      numbers += (numbers.isEmpty() ? "[" : ",") + QByteArray::number(uchar(byte));
    for (const Sent& sent : {cloud.sent(bytes), byJson(cloud.text(numbers + "]")), byCbor(map)}) {
      const auto points = readPointCloud2(sent.msg);
      QVERIFY(points);
      QCOMPARE(points->header.frame, std::string("laser"));
      QVERIFY(points->points == (std::vector<map::CloudPoint>{{1, 2, 3, 0}, {-4, 5, 6, 0}}));
    }
  }

  void everyTypeAtAnyOffsetIsRead_data() {
    QTest::addColumn<int>("datatype");
    QTest::addColumn<bool>("big_endian");
    for (int type = 1; type <= 8; ++type) {
      for (const bool big_endian : {false, true})
        QTest::addRow("%d, %s endian", type, big_endian ? "big" : "little") << type << big_endian;
    }
  }
  void everyTypeAtAnyOffsetIsRead() {
    QFETCH(int, datatype);
    QFETCH(bool, big_endian);
    const auto put = [&](QByteArray& bytes, int value) {
      switch (datatype) {
        case 1:
          return append(bytes, std::int8_t(value), big_endian);
        case 2:
          return append(bytes, std::uint8_t(value), big_endian);
        case 3:
          return append(bytes, std::int16_t(value), big_endian);
        case 4:
          return append(bytes, std::uint16_t(value), big_endian);
        case 5:
          return append(bytes, std::int32_t(value), big_endian);
        case 6:
          return append(bytes, std::uint32_t(value), big_endian);
        case 7:
          return append(bytes, float(value), big_endian);
        default:
          return append(bytes, double(value), big_endian);
      }
    };
    const bool has_sign = datatype != 2 && datatype != 4 && datatype != 6;
    const int y_m = has_sign ? -90 : 90;
    QByteArray bytes("\x7f\x7f\x7f", 3);  // nothing is where it would be aligned
    put(bytes, y_m);
    put(bytes, 100);
    bytes += QByteArray(5, '\x7f');
    const int size = int(bytes.size() - 8) / 2;
    CloudText cloud;
    const QByteArray type = QByteArray::number(datatype);
    cloud.fields = R"([{"name":"y","offset":3,"datatype":)" + type +
                   R"(},{"name":"rgb","offset":900,"datatype":7},)" + R"({"name":"x","offset":)" +
                   QByteArray::number(3 + size) + R"(,"datatype":)" + type + "}]";
    cloud.point_step = cloud.row_step = bytes.size();
    cloud.big_endian = big_endian;
    const auto points = readPointCloud2(cloud.sent(bytes).msg);
    QVERIFY(points);
    QVERIFY(points->points == (std::vector<map::CloudPoint>{{100, double(y_m), 0, 0}}));
  }

  void anOrganisedCloudMayHaveRowsThatArePadded() {
    CloudText cloud;
    cloud.width = 2;
    cloud.height = 2;
    cloud.row_step = 24 + 7;
    const QByteArray padding(7, '\x11');
    const QByteArray bytes = floats({1, 1, 1, 2, 2, 2}) + padding + floats({3, 3, 3, 4, 4, 4});
    for (const QByteArray& data : {bytes, bytes + padding}) {  // also behind the last one
      const auto points = readPointCloud2(cloud.sent(data).msg);
      QVERIFY(points);
      QCOMPARE(points->points.size(), std::size_t(4));
      QCOMPARE(points->points[3].x_m, 4.0);
      QCOMPARE(points->points[2].x_m, 3.0);
    }
  }

  void aCloudWithoutAStepOfRowsIsPacked() {
    CloudText cloud;
    cloud.width = 2;
    cloud.row_step = 0;
    const auto points = readPointCloud2(cloud.sent(floats({1, 1, 1, 2, 2, 2})).msg);
    QVERIFY(points);
    QCOMPARE(points->points.size(), std::size_t(2));
  }

  void pointsThatAreNoNumbersAreLeftOutAndCounted() {
    CloudText cloud;
    cloud.width = 5;
    cloud.row_step = 60;
    const auto points =
        readPointCloud2(cloud.sent(floats({kNaN, 1, 1, 1, kNaN, 1, 1, 1, kNaN, 1e9f, 0, 0, 7, 8, 9})).msg);
    QVERIFY(points);
    QVERIFY(points->points == (std::vector<map::CloudPoint>{{7, 8, 9, 0}}));
    QCOMPARE(points->left_out, std::size_t(4));
  }

  void aCloudWithoutZIsFlatAndIntensityIsKept() {
    CloudText cloud;
    cloud.fields = R"([{"name":"x","offset":0,"datatype":7},{"name":"y","offset":4,"datatype":7},)"
                   R"({"name":"intensity","offset":8,"datatype":2},{"name":"rgb","offset":8,"datatype":7}])";
    QByteArray bytes = floats({1, 2});
    bytes += QByteArray("\x01\x00\x00\x00", 4);
    const auto points = readPointCloud2(cloud.sent(bytes).msg);
    QVERIFY(points);
    QVERIFY(points->points == (std::vector<map::CloudPoint>{{1, 2, 0, 1}}));  // bytes stay what they are
  }

  void anEmptyCloudIsOne() {
    CloudText cloud;
    cloud.width = 0;
    const auto points = readPointCloud2(cloud.sent({}).msg);
    QVERIFY(points);
    QVERIFY(points->points.empty());
    // A driver that sees nothing sends a message that was never filled in.
    cloud.point_step = cloud.row_step = 0;
    cloud.fields = "[]";
    const auto unfilled = readPointCloud2(cloud.sent({}).msg);
    QVERIFY(unfilled && unfilled->points.empty());
  }

  void whatDoesNotFitIsNamed() {
    const QByteArray point = floats({1, 2, 3});
    CloudText cloud;
    QCOMPARE(unavailableReason(cloud, point.left(11)),
             Fault(robot::ros::fault::RosLengthDiffers, {"data", 11, 12}));
    cloud.height = 2;
    QCOMPARE(unavailableReason(cloud, point), Fault(robot::ros::fault::RosLengthDiffers, {"data", 12, 24}));
    cloud.row_step = 11;
    QCOMPARE(unavailableReason(cloud, point + point),
             Fault(robot::ros::fault::RosFieldWrong, {"row_step", 11.0}));
    CloudText huge;
    huge.width = huge.height = huge.point_step = qint64(1) << 32;
    huge.row_step = 0;
    QCOMPARE(unavailableReason(huge, point),
             Fault(robot::ros::fault::RosFieldWrong, {"width", 4294967296.0}));
    huge.width = huge.height = huge.point_step = qint64(1) << 28;
    QCOMPARE(unavailableReason(huge, point).code, robot::ros::fault::RosLengthDiffers);
    huge.height = 1;
    QCOMPARE(unavailableReason(huge, point).code, robot::ros::fault::RosLengthDiffers);
    CloudText no_step;
    no_step.point_step = 0;
    QCOMPARE(unavailableReason(no_step, point), Fault(robot::ros::fault::RosFieldWrong, {"point_step", 0.0}));
    CloudText negative;
    negative.width = -1;
    QCOMPARE(unavailableReason(negative, point), Fault(robot::ros::fault::RosFieldWrong, {"width", -1.0}));
    QCOMPARE(readPointCloud2(byJson("{}").msg).error(), Fault(robot::ros::fault::RosFieldMissing, {"width"}));
    QCOMPARE(readPointCloud2(byJson(CloudText().text("5")).msg).error(),
             Fault(robot::ros::fault::RosFieldMissing, {"data"}));
  }

  void aFieldThatDoesNotLieInItsRecordIsNone() {
    for (const char* const x :
         {R"("offset":9,"datatype":7)", R"("offset":-1,"datatype":7)", R"("offset":0,"datatype":9)",
          R"("offset":0,"datatype":0)", R"("datatype":7)", R"("offset":4294967295,"datatype":8)"}) {
      CloudText cloud;
      cloud.fields = R"([{"name":"x",)" + QByteArray(x) + R"(},{"name":"y","offset":4,"datatype":7}])";
      QCOMPARE(unavailableReason(cloud, floats({1, 2, 3})).code, robot::wire::fault::PointsWithoutFields);
    }
  }

  void tooManyPointsAreThinnedAndItIsSaid() {
    CloudText cloud;
    cloud.fields = R"([{"name":"x","offset":0,"datatype":6},{"name":"y","offset":0,"datatype":2}])";
    constexpr int kCount = 2 * int(kMostPoints) + 1;
    cloud.width = kCount;
    cloud.point_step = 4;
    cloud.row_step = 4 * qint64(kCount);
    QByteArray bytes;
    bytes.reserve(4 * kCount);
    for (int n = 0; n < kCount; ++n) append(bytes, n);
    const auto points = readPointCloud2(cloud.sent(bytes).msg);
    QVERIFY(points);
    QVERIFY(points->points.size() > kMostPoints / 2 && points->points.size() <= kMostPoints);
    QCOMPARE(points->points[1].x_m, 3.0);
    QCOMPARE(points->notes.at(0), Fault(robot::ros::fault::RosPointsThinned, {kCount, 3}));
  }

  void pointsArePlacedByTheFrameTheyAreIn() {
    Points points;
    points.points = {{1, 0, 0.5f, 9}};
    // The laser hangs upside down and looks to the left.
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
    const map::PointCloudMessage placed = placedIn(points, "/scan", Transform3{{10, 20, 1}, turn});
    QCOMPARE(placed.topic, std::string("/scan"));
    const map::CloudPoint& point = placed.points->at(0);
    QVERIFY(isAt(point, 10, 21));
    QVERIFY(std::abs(point.z_m - 0.5f) < 1e-6f);
    QCOMPARE(int(point.intensity), 9);
  }
};

}  // namespace test_ros_clouds

MAPWRIGHT_TEST(test_ros_clouds, RosCloudsTest, Core)
#include "test_ros_clouds.moc"
