// What map dispatchers answer, read from whatever senders make of it.
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include <QCborArray>
#include <QTest>

#include "grids/faults.h"
#include "map/faults.h"
#include "robot/ros/dispatch_messages.h"
#include "robot/ros/dispatch_names.h"
#include "robot/ros/faults.h"
#include "ros_messages.h"
#include "test_program.h"

namespace test_dispatch_messages {

using namespace mapwright;
using namespace mapwright::robot;
using namespace mapwright::robot::ros;
using test::byCbor;
using test::byJson;
using test::Sent;

namespace {

constexpr int kU8 = 2, kI16 = 3, kU32 = 6, kF32 = 7, kF64 = 8;

QByteArray grid(const QByteArray& width, const QByteArray& height, const QByteArray& data,
                const QByteArray& resolution = "0.05",
                const QByteArray& turn = R"({"x":0,"y":0,"z":0,"w":1})") {
  return R"({"header":{"frame_id":"/map"},"info":{"resolution":)" + resolution + R"(,"width":)" + width +
         R"(,"height":)" + height + R"(,"origin":{"position":{"x":-3,"y":4.5,"z":0},"orientation":)" + turn +
         R"(}},"data":)" + data + "}";
}

/// A cloud in the making, its records laid down as one likes.
struct Cloud {
  QCborArray fields;
  QByteArray data;
  qint64 width = 0, height = 1, point_step = 0, row_step = 0;
  bool big_endian = false;

  void field(const char* name, int type, int offset) {
    fields.append(QCborMap{{QStringLiteral("name"), QString::fromLatin1(name)},
                           {QStringLiteral("offset"), offset},
                           {QStringLiteral("datatype"), type},
                           {QStringLiteral("count"), 1}});
  }
  template <typename T>
  void put(T value) {
    QByteArray bytes(int(sizeof(T)), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (big_endian) std::reverse(bytes.begin(), bytes.end());
    data += bytes;
  }
  Sent sent() const {
    return byCbor({{QStringLiteral("header"), QCborMap{{QStringLiteral("frame_id"), QStringLiteral("map")}}},
                   {QStringLiteral("width"), width},
                   {QStringLiteral("height"), height},
                   {QStringLiteral("fields"), fields},
                   {QStringLiteral("is_bigendian"), big_endian},
                   {QStringLiteral("point_step"), point_step},
                   {QStringLiteral("row_step"), row_step},
                   {QStringLiteral("data"), data}});
  }
};

/// Two points of three float32: (1, 2, 3) and (4, 5, 6).
Cloud twoPoints() {
  Cloud cloud;
  for (const auto& [name, offset] : {std::pair{"x", 0}, std::pair{"y", 4}, std::pair{"z", 8}})
    cloud.field(name, kF32, offset);
  for (int i = 1; i <= 6; ++i) cloud.put(float(i));
  cloud.width = 2;
  cloud.point_step = 12;
  cloud.row_step = 24;
  return cloud;
}

Eigen::Vector3d at(const map::SpatialCloud& cloud, std::size_t i) {
  return cloud.points.at(i).cast<double>() + cloud.origin_m;
}

bool notes(const std::vector<Fault>& all, FaultCode code) {
  return std::any_of(all.begin(), all.end(), [code](const Fault& one) { return one.code == code; });
}

}  // namespace

class DispatchMessagesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aGridLiesWhereItSays() {
    const auto part = readGridPart(byJson(grid("2", "1", "[-1,100]")).msg);
    QVERIFY(part);
    QCOMPARE(part->frame, std::string("map"));
    QCOMPARE(part->grid, (map::GridReference{2, 1, 0.05, {-3, 4.5, 0}}));
    QCOMPARE(*part->cells, (std::vector<std::int8_t>{-1, 100}));
    QVERIFY(part->notes.empty());
  }

  // A kilometre away the edges of cells of 0.05000000074505806 m lie on the wrong side of those of 0.05 m.
  void aResolutionOf32BitsIsTheNumberThatWasMeant() {
    const auto of = [](const char* written) {
      return readGridPart(byJson(grid("1", "1", "[1]", written)).msg)->grid.resolution_m;
    };
    QCOMPARE(of("0.05000000074505806"), 0.05);
    QCOMPARE(of("0.10000000149011612"), 0.1);
    QCOMPARE(of("0.05"), 0.05);
    QCOMPARE(of("0.25"), 0.25);
    QCOMPARE(of("0.050000012"), 0.050000012);
  }
  void aTurnedGridStaysTurned() {
    const auto part = readGridPart(byJson(grid("1", "1", "[0]", "0.1",
                                               R"({"x":0,"y":0,"z":0.7071067811865476,"w":)"
                                               R"(0.7071067811865476})"))
                                       .msg);
    QVERIFY(part);
    QVERIFY(std::abs(part->grid.origin.yaw_rad - std::acos(-1.0) / 2) < 1e-9);
    const auto none = readGridPart(byJson(grid("1", "1", "[0]", "0.1", R"({"x":0,"y":0,"z":0,"w":0})")).msg);
    QVERIFY(none && notes(none->notes, robot::ros::fault::RosTurnIsZero));
  }

  void nothingIsAnAnswer_data() {
    QTest::addColumn<QByteArray>("message");
    QTest::newRow("0 x 0") << grid("0", "0", "[]");
    QTest::newRow("0 wide") << grid("0", "5", "[]");
    QTest::newRow("no data") << grid("0", "0", "null");
    QTest::newRow("no resolution") << grid("0", "0", "[]", "0");
    QTest::newRow("nothing else") << QByteArray(R"({"info":{"width":0,"height":0}})");
  }
  void nothingIsAnAnswer() {
    QFETCH(QByteArray, message);
    const auto part = readGridPart(byJson(message).msg);
    QVERIFY(part);
    QVERIFY(part->cells && part->cells->empty());
    QCOMPARE(part->grid.width * part->grid.height, 0);
  }

  void aGridThatMeansNothingIsRefused_data() {
    QTest::addColumn<QByteArray>("message");
    QTest::addColumn<FaultCode>("why");
    const auto row = [](const char* name, const QByteArray& message, FaultCode why) {
      QTest::newRow(name) << message << why;
    };
    row("too few cells", grid("2", "2", "[1,2,3]"), robot::ros::fault::RosLengthDiffers);
    row("too many cells", grid("1", "1", "[1,2,3]"), robot::ros::fault::RosLengthDiffers);
    row("more than fits", grid("20000", "20000", "[1]"), robot::ros::fault::RosFieldWrong);
    row("a product that overflows", grid("4294967296", "4294967296", "[1]"),
        robot::ros::fault::RosFieldWrong);
    row("less than nothing", grid("-2", "1", "[1,2]"), robot::ros::fault::RosFieldWrong);
    row("no width", grid("null", "1", "[1]"), robot::ros::fault::RosFieldMissing);
    row("no resolution", grid("1", "1", "[1]", "null"), map::fault::ResolutionNoNumber);
    row("a resolution of 0", grid("1", "1", "[1]", "0"), map::fault::ResolutionNotPositive);
    row("no info", R"({"data":[1]})", robot::ros::fault::RosFieldMissing);
    row("nothing at all", "{}", robot::ros::fault::RosFieldMissing);
    row("no cells", grid("1", "1", R"("x")"), robot::ros::fault::RosFieldMissing);
  }
  void aGridThatMeansNothingIsRefused() {
    QFETCH(QByteArray, message);
    QFETCH(FaultCode, why);
    const auto part = readGridPart(byJson(message).msg);
    QVERIFY(!part);
    QCOMPARE(part.error().code, why);
  }

  void otherValuesAreShown() {
    const auto part = readGridPart(byJson(grid("4", "1", "[101,127,-7,50]")).msg);
    QVERIFY(part);
    QCOMPARE(*part->cells, (std::vector<std::int8_t>{100, 100, -1, 50}));
    QVERIFY(notes(part->notes, grids::fault::RosCellsOutOfRange));
    const auto large = readGridPart(byJson(grid("2", "1", "[254,null]")).msg);
    QVERIFY(large);
    QCOMPARE(*large->cells, (std::vector<std::int8_t>{100, -1}));
  }

  void aCloudIsReadAsItLies() {
    const auto cloud = readSpatialCloud(twoPoints().sent().msg);
    QVERIFY(cloud);
    QCOMPARE((*cloud)->frame, std::string("map"));
    QCOMPARE((*cloud)->points, (std::vector<Eigen::Vector3f>{{1, 2, 3}, {4, 5, 6}}));
    QVERIFY((*cloud)->has_z && (*cloud)->notes.empty() && (*cloud)->rgb.empty());
    QCOMPARE((*cloud)->origin_m, Eigen::Vector3d(0, 0, 0));
  }

  void numbersMayBeOfAnyKindAtAnyOffset_data() {
    QTest::addColumn<bool>("big_endian");
    QTest::newRow("little") << false;
    QTest::newRow("big") << true;
  }
  void numbersMayBeOfAnyKindAtAnyOffset() {
    QFETCH(bool, big_endian);
    Cloud cloud;
    cloud.big_endian = big_endian;
    cloud.field("intensity", kU8, 1);
    cloud.field("x", kF64, 3);
    cloud.field("y", kI16, 11);
    cloud.field("z", kF32, 13);
    cloud.field("rgb", kF32, 18);
    cloud.field("reserved", 0, 9999);
    cloud.data = "?";
    cloud.put(std::uint8_t(200));
    cloud.data += "?";
    cloud.put(1.5);
    cloud.put(std::int16_t(-7));
    cloud.put(2.5F);
    cloud.data += "?";
    cloud.put(std::uint32_t(0x00c0ffee));  // called a float
    cloud.width = 1;
    cloud.point_step = cloud.row_step = 22;
    const auto read = readSpatialCloud(cloud.sent().msg);
    QVERIFY(read);
    QCOMPARE(at(**read, 0), Eigen::Vector3d(1.5, -7, 2.5));
    QCOMPARE((*read)->intensity, std::vector<float>{200});
    QCOMPARE((*read)->rgb, std::vector<std::uint32_t>{0xc0ffee});
  }

  void anAlphaIsNoColour() {
    Cloud cloud = twoPoints();
    cloud.fields = {};
    cloud.field("x", kF32, 0);
    cloud.field("y", kF32, 4);
    cloud.field("rgba", kU32, 8);
    cloud.data.clear();
    cloud.put(1.0F);
    cloud.put(2.0F);
    cloud.put(std::uint32_t(0xff102030));
    cloud.width = 1;
    cloud.row_step = 12;
    const auto read = readSpatialCloud(cloud.sent().msg);
    QVERIFY(read);
    QVERIFY(!(*read)->has_z);
    QCOMPARE((*read)->points[0].z(), 0.0F);
    QCOMPARE((*read)->rgb, std::vector<std::uint32_t>{0x102030});
  }

  void farPointsKeepTheirMillimetres() {
    Cloud cloud;
    for (const auto& [name, offset] : {std::pair{"x", 0}, std::pair{"y", 8}, std::pair{"z", 16}})
      cloud.field(name, kF64, offset);
    const double x = 691'234.567, y = 5'334'567.891;
    // One that is near 0 does not take the others with it.
    for (const double far : {0.0, 1.0, 1.0, 1.0}) {
      cloud.put(x * far);
      cloud.put(y * far);
      cloud.put(12.345);
    }
    cloud.width = 4;
    cloud.point_step = 24;
    const auto read = readSpatialCloud(cloud.sent().msg);
    QVERIFY(read);
    QVERIFY((at(**read, 2) - Eigen::Vector3d(x, y, 12.345)).norm() < 1e-4);
    QVERIFY((at(**read, 0) - Eigen::Vector3d(0, 0, 12.345)).norm() < 1);
    QCOMPARE((*read)->origin_m.z(), 0.0);
  }

  void pointsThatAreNoNumbersAreLeftOut() {
    Cloud cloud = twoPoints();
    cloud.put(std::numeric_limits<float>::quiet_NaN());
    cloud.put(0.0F);
    cloud.put(0.0F);
    cloud.put(std::numeric_limits<float>::infinity());
    cloud.put(0.0F);
    cloud.put(0.0F);
    cloud.put(3e9F);
    cloud.put(0.0F);
    cloud.put(0.0F);
    cloud.width = 5;
    cloud.row_step = 60;
    const auto read = readSpatialCloud(cloud.sent().msg);
    QVERIFY(read);
    QCOMPARE((*read)->points.size(), std::size_t(2));
    QCOMPARE((*read)->left_out, std::uint64_t(3));
  }

  void anIntensityThatIsNoNumberIsNone() {
    Cloud cloud = twoPoints();
    cloud.field("intensity", kF32, 8);
    cloud.data.clear();
    for (const float value : {1.0F, 2.0F, std::numeric_limits<float>::infinity(), 4.0F, 5.0F, 0.5F})
      cloud.put(value);
    cloud.fields = {};
    cloud.field("x", kF32, 0);
    cloud.field("y", kF32, 4);
    cloud.field("intensity", kF32, 8);
    const auto read = readSpatialCloud(cloud.sent().msg);
    QVERIFY(read);
    QCOMPARE((*read)->intensity, (std::vector<float>{0, 0.5F}));
  }

  void rowsMayBePadded() {
    Cloud cloud = twoPoints();
    cloud.data.insert(12, "1234");
    cloud.width = 1;
    cloud.height = 2;
    cloud.row_step = 16;
    const auto read = readSpatialCloud(cloud.sent().msg);
    QVERIFY(read);
    QCOMPARE((*read)->points[1], Eigen::Vector3f(4, 5, 6));
    QVERIFY((*read)->notes.empty());
  }

  void rowsThatHoldMorePointsThanItSaysAreTold() {
    Cloud cloud = twoPoints();
    cloud.width = 1;
    cloud.row_step = 24;
    const auto read = readSpatialCloud(cloud.sent().msg);
    QVERIFY(read);
    QCOMPARE((*read)->points.size(), std::size_t(1));
    QCOMPARE((*read)->notes, (std::vector{Fault(robot::ros::fault::RosRowsHoldMore, {24, 12})}));
    QCOMPARE((*read)->missing, std::uint64_t(0));
  }

  void whatIsCutShortIsReadAsFarAsItIsSound_data() {
    QTest::addColumn<int>("bytes");
    QTest::addColumn<int>("points");
    QTest::newRow("half a point") << 20 << 1;
    QTest::newRow("one point") << 12 << 1;
    QTest::newRow("more than it says") << 30 << 2;
  }
  void whatIsCutShortIsReadAsFarAsItIsSound() {
    QFETCH(int, bytes);
    QFETCH(int, points);
    Cloud cloud = twoPoints();
    cloud.data.append("\0\0\0\0\0\0", 6);
    cloud.data.truncate(bytes);
    const auto read = readSpatialCloud(cloud.sent().msg);
    QVERIFY(read);
    QCOMPARE((*read)->points.size(), std::size_t(points));
    QVERIFY(notes((*read)->notes, robot::ros::fault::RosLengthDiffers));
    QCOMPARE((*read)->missing, std::uint64_t(2 - points));
  }

  void manyRowsMayBreakOffAnywhere() {
    for (int bytes = 0; bytes <= 60; ++bytes) {
      Cloud cloud;
      cloud.field("x", kF32, 0);
      cloud.field("y", kF32, 4);
      cloud.width = 2;
      cloud.height = 3;
      cloud.point_step = 8;
      cloud.row_step = 20;
      cloud.data = QByteArray(bytes, '\0');
      const auto read = readSpatialCloud(cloud.sent().msg);
      const int full = bytes / 20, rest = bytes % 20;
      const int whole = std::min(6, full * 2 + std::min(2, rest / 8));
      QCOMPARE(read.has_value(), whole > 0);
      if (read) QCOMPARE(int((*read)->points.size()), whole);
      if (read) QCOMPARE((*read)->notes.empty(), bytes == 56 || bytes == 60);
    }
  }

  void sizesThatLieTakeNoMemory_data() {
    QTest::addColumn<qint64>("width");
    QTest::addColumn<qint64>("height");
    QTest::addColumn<qint64>("point_step");
    QTest::addColumn<qint64>("row_step");
    constexpr qint64 kLarge = std::numeric_limits<qint64>::max();
    QTest::newRow("width") << kLarge << qint64(1) << qint64(12) << qint64(24);
    QTest::newRow("negative width") << qint64(-1) << qint64(1) << qint64(12) << qint64(24);
    QTest::newRow("height") << qint64(2) << kLarge << qint64(12) << qint64(24);
    QTest::newRow("point_step") << qint64(2) << qint64(1) << kLarge << qint64(24);
    QTest::newRow("no point_step") << qint64(2) << qint64(1) << qint64(0) << qint64(24);
    QTest::newRow("rows in rows") << qint64(2) << qint64(2) << qint64(12) << qint64(1);
    QTest::newRow("fields beyond the point") << qint64(6) << qint64(1) << qint64(4) << qint64(24);
  }
  void sizesThatLieTakeNoMemory() {
    QFETCH(qint64, width);
    QFETCH(qint64, height);
    QFETCH(qint64, point_step);
    QFETCH(qint64, row_step);
    Cloud cloud = twoPoints();
    cloud.width = width;
    cloud.height = height;
    cloud.point_step = point_step;
    cloud.row_step = row_step;
    QVERIFY(!readSpatialCloud(cloud.sent().msg));
  }

  void aWidthThatLiesIsReadAsFarAsItIsSound() {
    Cloud cloud = twoPoints();
    cloud.width = 1'000'000'000;
    cloud.row_step = 0;
    const auto read = readSpatialCloud(cloud.sent().msg);
    QVERIFY(read);
    QCOMPARE((*read)->points.size(), std::size_t(2));
    QVERIFY((*read)->points.capacity() < 100);
  }

  void aPointStepThatCutsZOffIsTold() {
    Cloud cloud = twoPoints();
    cloud.point_step = 8;
    cloud.width = 3;
    const auto read = readSpatialCloud(cloud.sent().msg);
    QVERIFY(read && !(*read)->has_z);
    QVERIFY(notes((*read)->notes, robot::ros::fault::RosFieldMissing));
  }

  void noPointsAreAnAnswer() {
    const auto read = readSpatialCloud(byJson(R"({"width":0,"height":1,"point_step":0})").msg);
    QVERIFY(read && (*read)->points.empty());
    QVERIFY(!readSpatialCloud(byJson("{}").msg));
    QVERIFY(!readSpatialCloud(byJson(R"({"width":1,"height":1,"point_step":8})").msg));
    Cloud cloud = twoPoints();
    cloud.fields = {};
    QVERIFY(!readSpatialCloud(cloud.sent().msg));
  }

  void projectionsHaveTwoNames() {
    for (const char* member : {"projected_maps_info", "projected_maps"}) {
      QByteArray text =
          R"({"NAME":[{"frame_id":"/m","x":1,"y":2,"width":3,"height":4,"min_z":5,"max_z":6}]})";
      const auto told = readProjections(byJson(text.replace("NAME", member)).msg);
      QVERIFY(told);
      QCOMPARE(*told, std::vector{(map::Projection{"m", {1, 2}, {3, 4}, 5, 6})});
    }
    QVERIFY(!readProjections(byJson("{}").msg));
    QVERIFY(!readProjections(byJson(R"({"projected_maps_info":[{"x":1}]})").msg));
    QVERIFY(!readProjections(byJson(R"({"projected_maps_info":[null]})").msg));
    const auto none = readProjections(byJson(R"({"projected_maps_info":[]})").msg);
    QVERIFY(none && none->empty());
  }

  void aProjectedMapNeedsItsHeights() {
    const QByteArray map = R"({"map":)" + grid("2", "1", "[0,1]");
    const auto part = readProjectedPart(byJson(map + R"(,"min_z":0.5,"max_z":2})").msg, 3);
    QVERIFY(part);
    QCOMPARE(part->index, 3);
    const map::Projection projection = projectionOf(*part);
    QCOMPARE(projection.corner_m, Eigen::Vector2d(-3, 4.5));
    QVERIFY((projection.size_m - Eigen::Vector2d(0.1, 0.05)).norm() < 1e-9);
    QVERIFY(!readProjectedPart(byJson(map + R"(,"min_z":null,"max_z":2})").msg, 3));
    QVERIFY(!readProjectedPart(byJson("{}").msg, 0));
  }

  void theSizeOfAMapIsReadOrNone_data() {
    QTest::addColumn<QByteArray>("width");
    QTest::addColumn<QByteArray>("height");
    QTest::addColumn<QByteArray>("resolution");
    QTest::addColumn<bool>("sound");
    QTest::newRow("a map") << QByteArray("4000") << QByteArray("3000") << QByteArray("0.05") << true;
    QTest::newRow("nothing") << QByteArray("0") << QByteArray("0") << QByteArray("0.05") << false;
    QTest::newRow("no height") << QByteArray("10") << QByteArray("0") << QByteArray("0.05") << false;
    QTest::newRow("negative") << QByteArray("-1") << QByteArray("10") << QByteArray("0.05") << false;
    QTest::newRow("-1 as uint32") << QByteArray("4294967295") << QByteArray("4294967295")
                                  << QByteArray("0.05") << false;
    QTest::newRow("beyond int64") << QByteArray("1e30") << QByteArray("10") << QByteArray("0.05") << false;
    QTest::newRow("words") << QByteArray("\"wide\"") << QByteArray("10") << QByteArray("0.05") << false;
    QTest::newRow("NaN") << QByteArray("10") << QByteArray("10") << QByteArray("null") << false;
    QTest::newRow("resolution 0") << QByteArray("10") << QByteArray("10") << QByteArray("0") << false;
    QTest::newRow("resolution below 0")
        << QByteArray("10") << QByteArray("10") << QByteArray("-0.05") << false;
    QTest::newRow("wider than 1,000 km")
        << QByteArray("900000000") << QByteArray("10") << QByteArray("0.05") << false;
  }
  void theSizeOfAMapIsReadOrNone() {
    QFETCH(QByteArray, width);
    QFETCH(QByteArray, height);
    QFETCH(QByteArray, resolution);
    QFETCH(bool, sound);
    const Sent sent =
        byJson(R"({"map_load_time":{"secs":0,"nsecs":0},"resolution":)" + resolution + R"(,"width":)" +
               width + R"(,"height":)" + height +
               R"(,"origin":{"position":{"x":-3,"y":4.5,"z":0},"orientation":{"x":0,"y":0,"z":0,"w":1}}})");
    const auto extent = readMapExtent(sent.msg);
    QCOMPARE(extent.has_value(), sound);
    if (!sound) return;
    QCOMPARE(extent->width, 4000);
    QCOMPARE(extent->height, 3000);
    QCOMPARE(extent->resolution_m, 0.05);
    QCOMPARE(extent->origin.x_m, -3.0);
  }
  void theSizeOfAMapWithoutPlaceIsNone() {
    QVERIFY(!readMapExtent(byJson(R"({"resolution":0.05,"width":4,"height":4})").msg));
    QVERIFY(!readMapExtent(
        byJson(
            R"({"resolution":0.05,"width":4,"height":4,"origin":{"position":{"x":null,"y":0,"z":0},"orientation":{"x":0,"y":0,"z":0,"w":1}}})")
            .msg));
    QVERIFY(!readMapExtent(byJson("{}").msg));
  }
};

}  // namespace test_dispatch_messages

MAPWRIGHT_TEST(test_dispatch_messages, DispatchMessagesTest, Nothing)
#include "test_dispatch_messages.moc"
