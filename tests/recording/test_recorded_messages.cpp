#include <QtTest>

#include "net/rosbridge/frame.h"
#include "recording/message.h"
#include "recording/ros_cbor.h"
#include "recordings.h"
#include "robot/ros/read_messages.h"
#include "test_program.h"

namespace test_recorded_messages {

using namespace recordings;
namespace ros = mapwright::robot::ros;
using mapwright::net::rosbridge::Frame;

class TestRecordedMessages : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void timesAreWhatTheirDigitsSay();
  void definitionsBecomeTrees();
  void whatIsNoDefinitionIsNamed();
  void messagesOfRos1AreReadByTheRosLayers();
  void whatWasInRoslibIsInStdMsgs();
  void messagesOfRos2AreReadByTheRosLayers();
  void everyKindOfMemberComesThrough();
  void alignmentCountsFromTheEncapsulation();
  void aMessageThatWasCutIsNamedByItsField();
  void countsThatLieTakeNoMemory();
  void garbageNeverDoesHarm();
};

namespace {

const std::string kRule = "\n" + std::string(80, '=') + "\nMSG: ";
const std::string kGrid1 =
    "# a map\nHeader header\nMapMetaData info\nint8[] data" + kRule +
    "std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n" + kRule +
    "nav_msgs/MapMetaData\ntime map_load_time\nfloat32 resolution\nuint32 width\nuint32 "
    "height\ngeometry_msgs/Pose origin\n" +
    kRule + "geometry_msgs/Pose\nPoint position\nQuaternion orientation\n" + kRule +
    "geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n" + kRule +
    "geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n";
const std::string kScan2 =
    "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\n"
    "float32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\n"
    "float32[] ranges\nfloat32[] intensities\n" +
    kRule + "std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n";

/// Bytes as a serialiser lays them out: packed, or aligned from behind the encapsulation.
struct Layout {
  bool cdr = false, big = false;
  std::string bytes;
  template <typename T>
  Layout& put(T value) {
    if (cdr) bytes.resize((bytes.size() + sizeof(T) - 1) / sizeof(T) * sizeof(T));
    std::string raw(reinterpret_cast<const char*>(&value), sizeof(T));
    if (big) std::reverse(raw.begin(), raw.end());
    bytes += raw;
    return *this;
  }
  Layout& text(const std::string& value) {
    put(std::uint32_t(value.size() + (cdr ? 1 : 0)));
    bytes += value;
    if (cdr) bytes += '\0';
    return *this;
  }
  std::string done() const {
    return cdr ? std::string("\0", 1) + (big ? '\0' : '\1') + std::string(2, '\0') + bytes : bytes;
  }
};

RosSchema schemaOf(const std::string& name, const std::string& text, RosDialect dialect) {
  auto schema = parseRosSchema(name, text, dialect);
  return schema ? std::move(*schema) : RosSchema();
}

std::shared_ptr<const Frame> frameOf(const RosSchema& schema, RosWire wire, const std::string& bytes) {
  const auto cbor = rosToCbor(schema, wire, bytesOf(bytes));
  return Frame::read(cbor ? *cbor : QByteArray(), Frame::Wire::Binary);
}

}  // namespace

void TestRecordedMessages::timesAreWhatTheirDigitsSay() {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20'000; ++i) {
    // A stamp that is printed to its last digit and typed again is the same time.
    const std::int64_t ns = 1'500'000'000'000'000'000 + std::int64_t(random() % 500'000'000'000'000'000);
    const QByteArray printed = QByteArray::number(qlonglong(ns / 1'000'000'000)) + '.' +
                               QByteArray::number(qlonglong(ns % 1'000'000'000)).rightJustified(9, '0');
    QCOMPARE(secondsOf(ns), printed.toDouble());
    // Microseconds, as robots send them, survive a double.
    const std::int64_t us = ns / 1000 * 1000;
    QCOMPARE(nanosecondsOf(secondsOf(us)), us);
  }
  QCOMPARE(nanosecondsOf(1717405200.123456), std::int64_t(1'717'405'200'123'456'000));
  QCOMPARE(nanosecondsOf(-0.25), std::int64_t(-250'000'000));
  QCOMPARE(nanosecondsOf(0.1234567896), std::int64_t(123'456'790));
  QCOMPARE(nanosecondsOf(5), std::int64_t(5'000'000'000));
  QCOMPARE(nanosecondsOf(std::nan("")), std::int64_t(0));
  QCOMPARE(nanosecondsOf(1e300), std::int64_t(9'200'000'000'000'000'000));
}

void TestRecordedMessages::definitionsBecomeTrees() {
  const RosSchema schema = schemaOf("nav_msgs/OccupancyGrid", kGrid1, RosDialect::Ros1);
  QCOMPARE(schema.types.size(), std::size_t(6));
  const RosType& grid = schema.types[0];
  QCOMPARE(grid.name, std::string("nav_msgs/OccupancyGrid"));
  QCOMPARE(grid.fields.size(), std::size_t(3));
  QCOMPARE(schema.types[grid.fields[0].type].name, std::string("std_msgs/Header"));
  QCOMPARE(grid.fields[2].kind, RosKind::Int8);
  QCOMPARE(grid.fields[2].many, RosField::Many::Open);

  const RosSchema two =
      schemaOf("a_msgs/msg/B",
               "string NAME='a # b'\nint32 LEFT = -1\nstring<=10 name \"x\"\nfloat64[36] covariance\n"
               "int32[<=5] few [1, 2]\nC[] rows # many\nwstring wide\nbyte b" +
                   kRule + "a_msgs/msg/C\nbuiltin_interfaces/Duration d",
               RosDialect::Ros2);
  QCOMPARE(two.types.size(), std::size_t(3));
  const std::vector<RosField>& fields = two.types[0].fields;
  QCOMPARE(fields.size(), std::size_t(6));
  QVERIFY(fields[0].name == "name" && fields[0].kind == RosKind::Text);
  QVERIFY(fields[1].many == RosField::Many::Fixed && fields[1].count == 36);
  QVERIFY(fields[2].many == RosField::Many::Open && fields[2].kind == RosKind::Int32);
  QCOMPARE(two.types[fields[3].type].name, std::string("a_msgs/C"));
  QVERIFY(fields[4].kind == RosKind::WideText && fields[5].kind == RosKind::Uint8);
}

void TestRecordedMessages::whatIsNoDefinitionIsNamed() {
  using Code = RosSchemaFault::Code;
  const auto faultOf = [](const std::string& text) {
    const auto schema = parseRosSchema("a/B", text, RosDialect::Ros1);
    return schema ? RosSchemaFault{Code::TooLong, 999, {}} : schema.error();
  };
  QCOMPARE(faultOf("int32 a\nint32").code, Code::NotAField);
  QCOMPARE(faultOf("int32 a\nint32").line, std::size_t(2));
  QCOMPARE(faultOf("int32[x] a").code, Code::NotAField);
  QCOMPARE(faultOf("Other o").code, Code::UnknownType);
  QCOMPARE(faultOf("Other o").word, std::string("a/Other"));
  QCOMPARE(faultOf("B[] again").code, Code::HoldsItself);
  QCOMPARE(faultOf("C c" + kRule + "a/C\nB b").code, Code::HoldsItself);
  QCOMPARE(faultOf(std::string(std::size_t(2) << 20, ' ')).code, Code::TooLong);
  std::string deep = "T0 a";
  for (int i = 0; i < 100; ++i)
    deep += kRule + "a/T" + std::to_string(i) + "\nT" + std::to_string(i + 1) + " a";
  QCOMPARE(faultOf(deep).code, Code::TooLong);
}

void TestRecordedMessages::messagesOfRos1AreReadByTheRosLayers() {
  const RosSchema schema = schemaOf("nav_msgs/OccupancyGrid", kGrid1, RosDialect::Ros1);
  Layout bytes;
  bytes.put<std::uint32_t>(1).put<std::uint32_t>(100).put<std::uint32_t>(500'000'000).text("map");
  bytes.put<std::uint64_t>(0).put(0.05f).put<std::uint32_t>(3).put<std::uint32_t>(2);
  for (const double value : {1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 1.0}) bytes.put(value);
  bytes.put<std::uint32_t>(6).bytes += std::string("\x00\x64\xff\x00\x00\x32", 6);
  const auto frame = frameOf(schema, RosWire::Ros1, bytes.done());
  QCOMPARE(frame->fault(), Frame::Fault::None);
  const auto grid = ros::readGrid(frame->root());
  QVERIFY(grid);
  QCOMPARE(grid->header.frame, std::string("map"));
  QCOMPARE(grid->header.stamp_s, 100.5);
  QVERIFY(grid->width == 3 && grid->height == 2);
  QCOMPARE(grid->cells == (std::vector<std::int8_t>{0, 100, -1, 0, 0, 50}), true);
  QCOMPARE(grid->origin.x_m, 1.0);
}

// Until ROS moved it, in 2010, every bag said "MSG: roslib/Header".
void TestRecordedMessages::whatWasInRoslibIsInStdMsgs() {
  const std::string header = "\nuint32 seq\ntime stamp\nstring frame_id\n";
  for (const char* const field : {"Header", "roslib/Header", "std_msgs/Header"}) {
    for (const char* const section : {"roslib/Header", "std_msgs/Header"}) {
      const auto schema = parseRosSchema(
          "sensor_msgs/LaserScan",
          field + std::string(" header\nfloat32[] ranges\n") + kRule + section + header, RosDialect::Ros1);
      QVERIFY2(schema, field);
      QCOMPARE(schema->types[schema->types[0].fields[0].type].fields.size(), std::size_t(3));
    }
  }
  // A package may have a header of its own all the same.
  const RosSchema own =
      schemaOf("a/B", "Header h\n" + kRule + "a/Header\nint8 x\n" + kRule + "roslib/Header" + header,
               RosDialect::Ros1);
  QCOMPARE(own.types[own.types[0].fields[0].type].fields.size(), std::size_t(1));
}

void TestRecordedMessages::messagesOfRos2AreReadByTheRosLayers() {
  const RosSchema schema = schemaOf("sensor_msgs/msg/LaserScan", kScan2, RosDialect::Ros2);
  for (const bool big : {false, true}) {
    Layout bytes{.cdr = true, .big = big, .bytes = {}};
    bytes.put<std::int32_t>(7).put<std::uint32_t>(250'000'000).text("laser");
    for (const float value : {0.0f, 3.0f, 1.5f, 0.0f, 0.1f, 0.1f, 30.0f}) bytes.put(value);
    bytes.put<std::uint32_t>(3)
        .put(1.0f)
        .put(2.0f)
        .put(std::numeric_limits<float>::infinity())
        .put<std::uint32_t>(0);
    const auto frame = frameOf(schema, RosWire::Cdr, bytes.done());
    QCOMPARE(frame->fault(), Frame::Fault::None);
    const auto scan = ros::readLaserScan(frame->root());
    QVERIFY(scan);
    QCOMPARE(scan->header.frame, std::string("laser"));
    QCOMPARE(scan->header.stamp_s, 7.25);
    QCOMPARE(scan->points.size(), std::size_t(2));
    QVERIFY(std::abs(double(scan->points[0].x_m) - 1.0) < 1e-6);
  }
}

void TestRecordedMessages::everyKindOfMemberComesThrough() {
  const RosSchema schema =
      schemaOf("a/B",
               "bool f\nint8 a\nuint8 b\nint16 c\nuint16 d\nint32 e\nuint32 g\nint64 h\nuint64 i\n"
               "float32 j\nfloat64 k\nstring l\nduration m\nbool[] n\nuint8[] o\nint16[2] p\n"
               "uint64[] q\nfloat64[] r\nstring[] s\ntime[] t\nC[] u\nD v" +
                   kRule + "a/C\nint32 x" + kRule + "a/D\n",
               RosDialect::Ros1);
  Layout bytes;
  bytes.put(true).put<std::int8_t>(-1).put<std::uint8_t>(255).put<std::int16_t>(-300).put<std::uint16_t>(
      60'000);
  bytes.put<std::int32_t>(-70'000).put<std::uint32_t>(4'000'000'000).put<std::int64_t>(-5'000'000'000'000);
  bytes.put<std::uint64_t>(18'000'000'000'000'000'000u).put(1.5f).put(-2.25).text("text");
  bytes.put<std::int32_t>(-1).put<std::int32_t>(500'000'000);
  bytes.put<std::uint32_t>(2)
      .put(true)
      .put(false)
      .put<std::uint32_t>(2)
      .put<std::uint8_t>(1)
      .put<std::uint8_t>(254);
  bytes.put<std::int16_t>(-7).put<std::int16_t>(7).put<std::uint32_t>(1).put<std::uint64_t>(1);
  bytes.put<std::uint32_t>(1).put(0.5).put<std::uint32_t>(2).text("one").text("");
  bytes.put<std::uint32_t>(1).put<std::uint32_t>(3).put<std::uint32_t>(0);
  bytes.put<std::uint32_t>(2).put<std::int32_t>(10).put<std::int32_t>(-10);
  const auto frame = frameOf(schema, RosWire::Ros1, bytes.done());
  QCOMPARE(frame->fault(), Frame::Fault::None);
  const auto root = frame->root();
  QCOMPARE(root["f"].flag(), true);
  QCOMPARE(root["a"].integer(), -1);
  QCOMPARE(root["b"].integer(), 255);
  QCOMPARE(root["c"].integer(), -300);
  QCOMPARE(root["d"].integer(), 60'000);
  QCOMPARE(root["e"].integer(), -70'000);
  QCOMPARE(root["g"].integer(), 4'000'000'000);
  QCOMPARE(root["h"].integer(), -5'000'000'000'000);
  QCOMPARE(root["i"].number(), 1.8e19);
  QCOMPARE(root["j"].number(), 1.5);
  QCOMPARE(root["k"].number(), -2.25);
  QCOMPARE(root["l"].text(), std::string("text"));
  QCOMPARE(root["m"].time(), -0.5);
  QCOMPARE(root["n"].toWholeJson(), QByteArray("[true,false]"));
  QCOMPARE(root["o"].bytes(10), std::string("\1\xfe"));
  QCOMPARE(root["p"].numbers(10) == std::vector<double>({-7, 7}), true);
  QCOMPARE(root["q"].numbers(10) == std::vector<double>({1}), true);
  QCOMPARE(root["r"].numbers(10) == std::vector<double>({0.5}), true);
  QCOMPARE(root["s"].size(), std::size_t(2));
  QCOMPARE(root["t"].size(), std::size_t(1));
  std::vector<std::int64_t> rows;
  root["u"].each([&](const auto& row) { rows.push_back(row["x"].integer().value_or(0)); });
  QCOMPARE(rows == std::vector<std::int64_t>({10, -10}), true);
  QVERIFY(root["v"].isObject());
}

void TestRecordedMessages::alignmentCountsFromTheEncapsulation() {
  const RosSchema schema =
      schemaOf("a/B", "uint8 a\nfloat64 b\nuint8 c\nfloat64[] none\nuint8 d\nE e\nuint16 f" + kRule + "a/E\n",
               RosDialect::Ros2);
  for (const bool big : {false, true}) {
    Layout bytes{.cdr = true, .big = big, .bytes = {}};
    bytes.put<std::uint8_t>(1).put(2.5).put<std::uint8_t>(3).put<std::uint32_t>(0).put<std::uint8_t>(4);
    bytes.put<std::uint8_t>(0).put<std::uint16_t>(5);  // a message without members is a byte
    const auto frame = frameOf(schema, RosWire::Cdr, bytes.done());
    QCOMPARE(frame->root()["b"].number(), 2.5);
    QCOMPARE(frame->root()["d"].integer(), 4);
    QCOMPARE(frame->root()["f"].integer(), 5);
  }
  // Version 2 aligns to four bytes at most.
  std::string two("\0\7\0\0\1\0\0\0", 8);
  const double value = 2.5;
  two.append(reinterpret_cast<const char*>(&value), 8);
  QCOMPARE(frameOf(schemaOf("a/B", "uint8 a\nfloat64 b", RosDialect::Ros2), RosWire::Cdr, two)
               ->root()["b"]
               .number(),
           2.5);
  const auto other = rosToCbor(schema, RosWire::Cdr, bytesOf(std::string("\0\3\0\0\1\0\0\0", 8)));
  QCOMPARE(other.error().code, RosDecodeFault::Code::NotThisEncoding);
}

void TestRecordedMessages::aMessageThatWasCutIsNamedByItsField() {
  const RosSchema schema = schemaOf("a/B", "uint32 first\nstring second\nfloat64[] third", RosDialect::Ros1);
  Layout bytes;
  bytes.put<std::uint32_t>(1).text("hello").put<std::uint32_t>(2).put(1.0).put(2.0);
  for (std::size_t cut = 0; cut < bytes.bytes.size(); ++cut) {
    const auto cbor = rosToCbor(schema, RosWire::Ros1, bytesOf(bytes.bytes.substr(0, cut)));
    QVERIFY(!cbor);
    QCOMPARE(cbor.error().code, RosDecodeFault::Code::CutOff);
    QCOMPARE(cbor.error().field, std::string(cut < 4 ? "first" : cut < 13 ? "second" : "third"));
  }
  QVERIFY(rosToCbor(schema, RosWire::Ros1, bytesOf(bytes.bytes + "more")));
}

void TestRecordedMessages::countsThatLieTakeNoMemory() {
  for (const std::string type :
       {"uint8[] a", "float64[] a", "string[] a", "C[] a", "D[] a", "D[4000000000] a", "string a"}) {
    const RosSchema schema =
        schemaOf("a/B", type + kRule + "a/C\nfloat64 x" + kRule + "a/D\n", RosDialect::Ros1);
    QVERIFY(!schema.types.empty());
    QVERIFY(!rosToCbor(schema, RosWire::Ros1, bytesOf("\xff\xff\xff\xff some more bytes")));
  }
}

void TestRecordedMessages::garbageNeverDoesHarm() {
  const int rounds =
      qEnvironmentVariableIsSet("MAPWRIGHT_FUZZ") ? qEnvironmentVariableIntValue("MAPWRIGHT_FUZZ") : 2000;
  std::mt19937 random(5);
  for (int round = 0; round < rounds; ++round) {
    std::string text = random() % 2 == 0 ? kGrid1 : kScan2;
    for (std::size_t i = random() % 4; i > 0; --i) text[random() % text.size()] = char(random() % 128);
    const auto dialect = random() % 2 == 0 ? RosDialect::Ros1 : RosDialect::Ros2;
    const auto schema = parseRosSchema("nav_msgs/OccupancyGrid", text, dialect);
    if (!schema) continue;
    std::string bytes(random() % 300, '\0');
    for (char& byte : bytes) byte = random() % 3 == 0 ? char(random()) : char(random() % 4);
    if (bytes.size() > 4 && random() % 2 == 0) bytes.replace(0, 4, std::string("\0\1\0\0", 4));
    const auto cbor = rosToCbor(*schema, random() % 2 == 0 ? RosWire::Ros1 : RosWire::Cdr, bytesOf(bytes));
    if (cbor) QCOMPARE(Frame::read(*cbor, Frame::Wire::Binary)->fault(), Frame::Fault::None);
  }
}

}  // namespace test_recorded_messages

MAPWRIGHT_TEST(test_recorded_messages, TestRecordedMessages, Core)
#include "test_recorded_messages.moc"
