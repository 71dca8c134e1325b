// Messages of ROS written by their definition: what the decoder reads comes out of the encoder again.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <QtTest>

#include "net/rosbridge/frame.h"
#include "recorder/ros_encode.h"
#include "recording/ros_cbor.h"
#include "test_program.h"

namespace test_ros_encode {

using namespace mapwright;
using net::rosbridge::Frame;
using recorder::encodeRos;
using recording::RosWire;

namespace {

/// Definitions and messages by chance, the bytes made here by the rules of ROS and of CDR.
class Chance {
 public:
  Chance(std::uint32_t seed, RosWire wire) : random_(seed), cdr_(wire == RosWire::Cdr) {}

  std::string definition() {
    std::string rest;
    std::string own = section(0, rest);
    return own + rest;
  }

  /// With numbers that JSON can say, where `plain`.
  std::string message(const recording::RosSchema& schema, bool plain) {
    plain_ = plain;
    out_.clear();
    object(schema, 0);
    return cdr_ ? std::string("\0\1\0\0", 4) + out_ : out_;
  }

 private:
  std::size_t upTo(std::size_t most) { return std::uniform_int_distribution<std::size_t>(0, most)(random_); }

  std::string section(int depth, std::string& rest) {
    static const std::vector<std::string> kBoth{"bool",    "int8",   "uint8", "int16",  "uint16",
                                                "int32",   "uint32", "int64", "uint64", "float32",
                                                "float64", "string", "char",  "byte"};
    std::string text;
    const std::size_t fields = upTo(6);
    for (std::size_t i = 0; i < fields; ++i) {
      std::string type = kBoth[upTo(kBoth.size() - 1)];
      if (const std::size_t kind = upTo(9); kind == 0 && depth < 3) {
        type = "pkg/T" + std::to_string(++types_);
        const std::string inner = section(depth + 1, rest);
        rest += std::string(80, '=') + "\nMSG: " + type + '\n' + inner;
      } else if (kind == 1) {
        type = cdr_ ? "builtin_interfaces/Time" : upTo(1) ? "time" : "duration";
      }
      const std::size_t many = upTo(4);
      if (many == 0) type += "[]";
      if (many == 1) type += '[' + std::to_string(upTo(5)) + ']';
      text += type + " f" + std::to_string(i) + '\n';
    }
    return text;
  }

  void object(const recording::RosSchema& schema, std::size_t index) {
    const recording::RosType& type = schema.types[index];
    for (const recording::RosField& field : type.fields) {
      std::size_t count = 1;
      if (field.many == recording::RosField::Many::Fixed) count = field.count;
      if (field.many == recording::RosField::Many::Open) {
        count = upTo(4);
        put(std::uint32_t(count));
      }
      for (std::size_t i = 0; i < count; ++i) one(schema, field);
    }
    if (cdr_ && type.fields.empty()) out_ += '\0';
  }

  void one(const recording::RosSchema& schema, const recording::RosField& field) {
    using recording::RosKind;
    switch (field.kind) {
      case RosKind::Flag:
        return put(std::uint8_t(upTo(1)));
      case RosKind::Int8:
      case RosKind::Uint8:
        return put(std::uint8_t(random_()));
      case RosKind::Int16:
      case RosKind::Uint16:
        return put(std::uint16_t(random_()));
      case RosKind::Int32:
      case RosKind::Uint32:
        return put(std::uint32_t(random_()));
      case RosKind::Int64:
      case RosKind::Uint64:
        return put(wide());
      case RosKind::Float32:
        return put(float(real()));
      case RosKind::Float64:
        return put(real());
      case RosKind::Text: {
        std::string text;
        for (std::size_t i = upTo(5); i > 0; --i) text += char('a' + upTo(25));
        if (upTo(3) == 0) text += "\"\\ \n\xc3\xa4";
        put(std::uint32_t(text.size() + (cdr_ ? 1 : 0)));
        out_ += text;
        if (cdr_) out_ += '\0';
        return;
      }
      case RosKind::Time:
      case RosKind::Duration:
        put(std::uint32_t(random_()) >> 1);
        return put(std::uint32_t(random_()) >> 2);
      case RosKind::Nested:
        return object(schema, field.type);
      case RosKind::WideText:
        return;
    }
  }

  std::uint64_t wide() { return std::uint64_t(random_()) << 32 | random_(); }
  double real() {
    const std::size_t kind = plain_ ? 9 : upTo(9);
    if (kind == 0) return std::numeric_limits<double>::quiet_NaN();
    if (kind == 1) return std::numeric_limits<double>::infinity();
    if (kind == 2) return -std::numeric_limits<double>::infinity();
    return std::ldexp(double(int(random_())), int(upTo(20)) - 30);
  }

  template <typename T>
  void put(T value) {
    if (cdr_) out_.resize((out_.size() + sizeof(T) - 1) / sizeof(T) * sizeof(T), '\0');
    out_.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }

  std::mt19937 random_;
  bool cdr_, plain_ = false;
  int types_ = 0;
  std::string out_;
};

recording::RosSchema schemaOf(const std::string& definition, RosWire wire) {
  const auto dialect = wire == RosWire::Cdr ? recording::RosDialect::Ros2 : recording::RosDialect::Ros1;
  auto schema = recording::parseRosSchema("pkg/Root", definition, dialect);
  return schema ? std::move(*schema) : recording::RosSchema();
}

std::span<const std::uint8_t> spanOf(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

}  // namespace

class RosEncodeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatTheDecoderReadsIsWrittenTheSame_data() {
    QTest::addColumn<bool>("cdr");
    QTest::addColumn<bool>("json");
    for (const bool cdr : {false, true}) {
      for (const bool json : {false, true})
        QTest::addRow("%s by way of %s", cdr ? "cdr" : "ros1", json ? "JSON" : "CBOR") << cdr << json;
    }
  }
  void whatTheDecoderReadsIsWrittenTheSame() {
    QFETCH(bool, cdr);
    QFETCH(bool, json);
    const RosWire wire = cdr ? RosWire::Cdr : RosWire::Ros1;
    std::size_t fields = 0;
    for (std::uint32_t seed = 1; seed <= 2'000; ++seed) {
      Chance chance(seed, wire);
      const std::string definition = chance.definition();
      const recording::RosSchema schema = schemaOf(definition, wire);
      QVERIFY2(!schema.types.empty(), definition.c_str());
      fields += schema.types.front().fields.size();
      const std::string bytes = chance.message(schema, json);
      const auto cbor = recording::rosToCbor(schema, wire, spanOf(bytes));
      QVERIFY2(cbor, definition.c_str());
      auto frame = Frame::read(*cbor, Frame::Wire::Binary);
      if (json) frame = Frame::read(frame->root().toWholeJson(), Frame::Wire::Text);
      const auto encoded = encodeRos(schema, wire, frame->root());
      QVERIFY2(encoded, (definition + (encoded ? "" : "at " + encoded.error())).c_str());
      QVERIFY2(*encoded == bytes, definition.c_str());
    }
    QVERIFY(fields > 4'000);
  }

  void whatIsNotAsTheDefinitionSaysIsNotWritten_data() {
    QTest::addColumn<QByteArray>("json");
    const auto row = [](const char* name, const char* json) { QTest::newRow(name) << QByteArray(json); };
    row("a member is missing", R"({"x":1,"name":"a"})");
    row("a member too many", R"({"x":1,"name":"a","list":[1,2],"more":1})");
    row("a text for a number", R"({"x":"1","name":"a","list":[1,2]})");
    row("a fraction for a whole number", R"({"x":1.5,"name":"a","list":[1,2]})");
    row("a number that does not fit", R"({"x":70000,"name":"a","list":[1,2]})");
    row("a number for a text", R"({"x":1,"name":5,"list":[1,2]})");
    row("an array of another length", R"({"x":1,"name":"a","list":[1,2,3]})");
    row("no object", "[1]");
  }
  void whatIsNotAsTheDefinitionSaysIsNotWritten() {
    QFETCH(QByteArray, json);
    const recording::RosSchema schema = schemaOf("int16 x\nstring name\nfloat32[2] list\n", RosWire::Ros1);
    const auto of = [&](const QByteArray& text) {
      return encodeRos(schema, RosWire::Ros1, Frame::read(text, Frame::Wire::Text)->root()).has_value();
    };
    QVERIFY(of(R"({"list":[1,null],"x":1,"name":"a"})"));
    QVERIFY(!of(json));
  }

  void bothNamesOfATimeAreRead() {
    for (const char* json : {R"({"t":{"secs":5,"nsecs":7}})", R"({"t":{"sec":5,"nanosec":7}})"}) {
      const auto frame = Frame::read(QByteArray(json), Frame::Wire::Text);
      const std::string ros1("\5\0\0\0\7\0\0\0", 8);
      QCOMPARE(*encodeRos(schemaOf("time t\n", RosWire::Ros1), RosWire::Ros1, frame->root()), ros1);
      QCOMPARE(*encodeRos(schemaOf("builtin_interfaces/Time t\n", RosWire::Cdr), RosWire::Cdr, frame->root()),
               std::string("\0\1\0\0", 4) + ros1);
    }
  }
};

}  // namespace test_ros_encode

MAPWRIGHT_TEST(test_ros_encode, RosEncodeTest, Core)
#include "test_ros_encode.moc"
