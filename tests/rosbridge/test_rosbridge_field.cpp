#include <limits>

#include <QtEndian>
#include <QtTest>

#include "frames_for_tests.h"
#include "net/rosbridge/field.h"
#include "test_program.h"

namespace test_rosbridge_field {

using namespace mapwright::net::rosbridge;
using testing::cbor;
using testing::json;
using testing::typedArray;
using testing::written;

namespace {

using Int8s = std::vector<std::int8_t>;

template <typename T>
QByteArray littleEndian(std::initializer_list<T> values) {
  QByteArray bytes(qsizetype(values.size() * sizeof(T)), '\0');
  qToLittleEndian<T>(std::data(values), qsizetype(values.size()), bytes.data());
  return bytes;
}

template <typename T>
QByteArray bigEndian(std::initializer_list<T> values) {
  QByteArray bytes(qsizetype(values.size() * sizeof(T)), '\0');
  qToBigEndian<T>(std::data(values), qsizetype(values.size()), bytes.data());
  return bytes;
}

QList<double> listOf(const Field& field) {
  QList<double> numbers;
  for (const double number : field.numbers(1000).value_or(std::vector<double>{-12345})) numbers << number;
  return numbers;
}

}  // namespace

class TestRosbridgeField : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void saysWhatItIs() {
    const auto frame = json(R"({"o":{"x":1},"l":[1,2,3],"t":"w\u00e4","n":2.5,"w":7,"b":true,"z":null})");
    const Field root = frame->root();
    QVERIFY(root.isObject() && !root.isList() && root);
    QVERIFY(root["o"].isObject() && root["l"].isList() && root["t"].isText());
    QVERIFY(root["n"].isNumber() && root["w"].isNumber() && !root["b"].isNumber() && !root["t"].isNumber());
    QVERIFY(root["z"].isNull() && root["absent"].isNull() && !root["z"]);
    QVERIFY(root["absent"]["deeper"]["still"].isNull());
    QCOMPARE(root["l"].size(), std::size_t(3));
    QCOMPARE(root["o"].size(), std::size_t(0));
    QCOMPARE(QString::fromStdString(root["t"].text()), QStringLiteral("wä"));
    QCOMPARE(root["n"].text(), std::string());
    QCOMPARE(root["o"]["x"].integer(), 1);
    QVERIFY(Field().isNull() && !Field().number() && !Field().flag() && Field()["x"].isNull());
    double sum = 0;
    root["l"].each([&](const Field& item) { sum += item.number().value_or(100); });
    QCOMPARE(sum, 6.0);
    QStringList names;
    root.members([&](std::string_view name, const Field&) {
      names << QString::fromUtf8(name.data(), qsizetype(name.size()));
    });
    QCOMPARE(names.join(QLatin1Char(' ')), QStringLiteral("o l t n w b z"));
  }

  void readsNumbersHoweverTheyAreWritten() {
    const auto frame = json(
        R"({"whole":3.0,"half":3.5,"text":" 2.5","digits":"9007199254740993","word":"ten",)"
        R"("big":9223372036854775807,"beyond":9223372036854775808,"huge":1e300,"yes":1,"no":0,"two":2,"empty":""})");
    const Field root = frame->root();
    QCOMPARE(root["whole"].integer(), 3);
    QCOMPARE(root["half"].integer(), std::nullopt);
    QCOMPARE(root["half"].number(), 3.5);
    QCOMPARE(root["text"].number(), 2.5);
    QCOMPARE(root["digits"].integer(), 9007199254740993);
    QCOMPARE(root["word"].number(), std::nullopt);
    QCOMPARE(root["empty"].number(), std::nullopt);
    QCOMPARE(root["big"].integer(), std::numeric_limits<std::int64_t>::max());
    QCOMPARE(root["beyond"].integer(), std::nullopt);
    QCOMPARE(root["beyond"].number(), 9223372036854775808.0);
    QCOMPARE(root["huge"].integer(), std::nullopt);
    QCOMPARE(root["yes"].flag(), true);
    QCOMPARE(root["no"].flag(), false);
    QCOMPARE(root["two"].flag(), std::nullopt);
    QCOMPARE(root["text"].flag(), std::nullopt);
  }

  void readsTheSameOutOfCbor() {
    const QByteArray bytes = written([](QCborStreamWriter& writer) {
      writer.startMap(10);
      writer.append(QStringLiteral("whole"));
      writer.append(-70000);
      writer.append(QStringLiteral("half"));
      writer.append(qfloat16(1.5F));
      writer.append(QStringLiteral("single"));
      writer.append(0.05F);
      writer.append(QStringLiteral("real"));
      writer.append(1e-3);
      writer.append(QStringLiteral("yes"));
      writer.append(true);
      writer.append(QStringLiteral("none"));
      writer.append(nullptr);
      writer.append(QStringLiteral("text"));
      writer.append(QStringLiteral("grüß"));
      writer.append(QStringLiteral("list"));
      writer.startArray();  // its end is marked
      writer.append(1);
      writer.startMap();
      writer.append(QStringLiteral("x"));
      writer.append(2.0);
      writer.endMap();
      writer.endArray();
      writer.append(QStringLiteral("nan"));
      writer.append(std::numeric_limits<double>::quiet_NaN());
      writer.append(QStringLiteral("last"));
      writer.append(quint64(1) << 63);
      writer.endMap();
    });
    const auto frame = cbor(bytes);
    const Field root = frame->root();
    QVERIFY(root.isObject());
    QCOMPARE(root["whole"].integer(), -70000);
    QCOMPARE(root["half"].number(), 1.5);
    QCOMPARE(root["single"].number(), double(0.05F));
    QCOMPARE(root["real"].number(), 1e-3);
    QCOMPARE(root["yes"].flag(), true);
    QVERIFY(root["none"].isNull() && root["nan"].isNull() && !root["nan"].isNumber());
    QCOMPARE(QString::fromStdString(root["text"].text()), QStringLiteral("grüß"));
    QVERIFY(root["list"].isList());
    QCOMPARE(root["list"].size(), std::size_t(2));
    std::vector<Field> items;
    root["list"].each([&](const Field& item) { items.push_back(item); });
    QCOMPARE(items.at(1)["x"].integer(), 2);
    QCOMPARE(root["last"].number(), 9223372036854775808.0);
    QCOMPARE(root["last"].integer(), std::nullopt);
    int members = 0;
    root.members([&](std::string_view, const Field&) { ++members; });
    QCOMPARE(members, 10);
  }

  void typedArraysAreListsOfNumbers_data() {
    QTest::addColumn<int>("tag");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QList<double>>("numbers");
    const auto row = [](int tag, const QByteArray& bytes, const QList<double>& numbers) {
      QTest::addRow("%d", tag) << tag << bytes << numbers;
    };
    row(64, littleEndian<quint8>({1, 255}), {1, 255});
    row(65, bigEndian<quint16>({1, 65535}), {1, 65535});
    row(66, bigEndian<quint32>({1, 4294967295U}), {1, 4294967295.0});
    row(67, bigEndian<quint64>({1, quint64(1) << 63}), {1, 9223372036854775808.0});
    row(68, littleEndian<quint8>({1, 255}), {1, 255});
    row(69, littleEndian<quint16>({1, 65535}), {1, 65535});
    row(70, littleEndian<quint32>({1, 4294967295U}), {1, 4294967295.0});
    row(71, littleEndian<quint64>({1, quint64(1) << 63}), {1, 9223372036854775808.0});
    row(72, littleEndian<qint8>({-128, 127}), {-128, 127});
    row(73, bigEndian<qint16>({-2, 300}), {-2, 300});
    row(74, bigEndian<qint32>({-2, 70000}), {-2, 70000});
    row(75, bigEndian<qint64>({-2, 1}), {-2, 1});
    row(77, littleEndian<qint16>({-2, 300}), {-2, 300});
    row(78, littleEndian<qint32>({-2, 70000}), {-2, 70000});
    row(79, littleEndian<qint64>({-2, 1}), {-2, 1});
    row(80, bigEndian<quint16>({0x3e00, 0xc000}), {1.5, -2});
    row(81, bigEndian<float>({1.5F, -0.25F}), {1.5, -0.25});
    row(82, bigEndian<double>({1e100, -0.1}), {1e100, -0.1});
    row(84, littleEndian<quint16>({0x3e00, 0x0001}), {1.5, 0x1p-24});
    row(85, littleEndian<float>({1.5F, -0.25F}), {1.5, -0.25});
    row(86, littleEndian<double>({1e100, -0.1}), {1e100, -0.1});
  }

  void typedArraysAreListsOfNumbers() {
    QFETCH(const int, tag);
    QFETCH(const QByteArray, bytes);
    QFETCH(const QList<double>, numbers);
    const auto frame = cbor(typedArray(quint64(tag), bytes));
    const Field array = frame->root()["a"];
    QVERIFY(array.isList() && !array.isText());
    QCOMPARE(array.size(), std::size_t(numbers.size()));
    QCOMPARE(listOf(array), numbers);
    QVERIFY(!array.numbers(1));
  }

  void aTypedArrayThatCannotBeIsNull_data() {
    QTest::addColumn<int>("tag");
    QTest::addColumn<int>("size");
    QTest::newRow("half an element") << 69 << 3;
    QTest::newRow("floats of 128 bits") << 83 << 32;
    QTest::newRow("floats of 128 bits, little-endian") << 87 << 32;
    QTest::newRow("reserved") << 76 << 4;
    QTest::newRow("a number beyond 64 bits") << 2 << 16;
  }

  void aTypedArrayThatCannotBeIsNull() {
    QFETCH(const int, tag);
    QFETCH(const int, size);
    const auto frame = cbor(typedArray(quint64(tag), QByteArray(size, 'x')));
    QCOMPARE(frame->fault(), Frame::Fault::None);
    QVERIFY(frame->root()["a"].isNull());
  }

  void cellsComeAsNumbersOrAsATypedArray() {
    const auto text = json(R"({"data":[-1,0,100,127,-128]})");
    const Int8s expected{-1, 0, 100, 127, -128};
    QCOMPARE(text->root()["data"].int8s(5), expected);
    QCOMPARE(cbor(typedArray(72, QByteArray("\xff\0\x64\x7f\x80", 5)))->root()["a"].int8s(5), expected);
    QCOMPARE(cbor(typedArray(77, littleEndian<qint16>({-1, 0, 100, 127, -128})))->root()["a"].int8s(5),
             expected);
    QVERIFY(!text->root()["data"].int8s(4));
    QVERIFY(!cbor(typedArray(72, "12345"))->root()["a"].int8s(4));
    QCOMPARE(json(R"({"data":[]})")->root()["data"].int8s(0), Int8s());
  }

  void oneCellOutOfRangeSpoilsThemAll() {
    for (const char* list :
         {"[0,128]", "[-129]", "[0.5]", "[null]", "[\"1\"]", "[true]", "[[1]]", "{}", "\"AAA=\"", "7"}) {
      QVERIFY2(!json(QByteArray("{\"data\":") + list + "}")->root()["data"].int8s(10), list);
    }
    QVERIFY(!cbor(typedArray(64, "\xc8"))->root()["a"].int8s(10));
    QVERIFY(!cbor(typedArray(77, littleEndian<qint16>({300})))->root()["a"].int8s(10));
  }

  void bytesComeAsBase64NumbersOrBytes() {
    const std::string expected("\0\x01\xff", 3);
    QCOMPARE(json(R"({"data":"AAH\/"})")->root()["data"].bytes(3), expected);
    QCOMPARE(json(R"({"data":[0,1,255]})")->root()["data"].bytes(3), expected);
    const QByteArray bytes =
        written([](QCborStreamWriter& writer) { writer.append(QByteArray("\0\1\xff", 3)); });
    QCOMPARE(cbor(bytes)->root().bytes(3), expected);
    QCOMPARE(cbor(bytes)->root().size(), std::size_t(3));
    QCOMPARE(cbor(typedArray(68, QByteArray("\0\1\xff", 3)))->root()["a"].bytes(3), expected);
    QCOMPARE(cbor(typedArray(69, littleEndian<quint16>({0, 1, 255})))->root()["a"].bytes(3), expected);
    QCOMPARE(json(R"({"data":"QUJD\nREU="})")->root()["data"].bytes(5), std::string("ABCDE"));
    QCOMPARE(json(R"({"data":""})")->root()["data"].bytes(0), std::string());
    for (const char* none : {R"("AAH/")", "[0,1,255]"}) {
      QVERIFY(!json(QByteArray("{\"data\":") + none + "}")->root()["data"].bytes(2));
    }
    for (const char* none : {R"("A?H/")", R"("A")", "[256]", "[-1]", "[0.5]", "{}", "7", "null"}) {
      QVERIFY2(!json(QByteArray("{\"data\":") + none + "}")->root()["data"].bytes(10), none);
    }
    QVERIFY(!cbor(bytes)->root().bytes(2));
  }

  void aMissingFloatIsNoNumber() {
    const std::vector<double> numbers = json(R"([1,null,2.5])")->root().numbers(3).value();
    QCOMPARE(numbers.size(), std::size_t(3));
    QVERIFY(numbers[0] == 1 && std::isnan(numbers[1]) && numbers[2] == 2.5);
    const float infinity = std::numeric_limits<float>::infinity();
    const auto frame = cbor(typedArray(85, littleEndian<float>({1, infinity, 2.5F})));
    const std::vector<double> same = frame->root()["a"].numbers(3).value();
    QVERIFY(same[0] == 1 && std::isnan(same[1]) && same[2] == 2.5);
    QVERIFY(!json(R"([1,"word"])")->root().numbers(3));
    QVERIFY(!json(R"([1,[2]])")->root().numbers(3));
    QVERIFY(!json(R"({})")->root().numbers(3));
  }

  void bothKindsOfTimeAreTimes() {
    QCOMPARE(json(R"({"secs":12,"nsecs":500000000})")->root().time(), 12.5);
    QCOMPARE(json(R"({"sec":12,"nanosec":500000000})")->root().time(), 12.5);
    QCOMPARE(json(R"({"secs":12})")->root().time(), 12.0);
    QCOMPARE(json(R"({"nsecs":12})")->root().time(), std::nullopt);
    QCOMPARE(json(R"({"secs":12,"nsecs":"x"})")->root().time(), std::nullopt);
    QCOMPARE(json(R"(12)")->root().time(), std::nullopt);
  }

  void textOfCborIsAlwaysUtf8() {
    const auto frame =
        cbor(QByteArray("\x63"
                        "a\xff"
                        "b",
                        4));
    QCOMPARE(QString::fromStdString(frame->root().text()), QStringLiteral("a\uFFFDb"));
    QVERIFY(frame->root().isText());
  }

  void showsItselfAsJson() {
    const QByteArray text = "{\"a\":[1,2.5,\"x\\\"\\n\"],\"b\":{\"c\":true,\"d\":null}}";
    QCOMPARE(json(text)->root().toJson(1000), text);
    QCOMPARE(json(text)->root().toJson(5), text.left(5));
    QCOMPARE(cbor(typedArray(72, "\xff\x05"))->root().toJson(100), QByteArray(R"({"a":[-1,5]})"));
    QByteArray long_list = "[0";
    for (int i = 1; i < 100; ++i) long_list += ",0";
    const QByteArray shown = json(long_list + "]")->root().toJson(1000);
    QVERIFY2(shown.endsWith(QStringLiteral("0,\"… 68\"]").toUtf8()), shown.constData());
    const QByteArray umlauts = '"' + QStringLiteral("ä").repeated(10).toUtf8() + '"';
    QCOMPARE(json(umlauts)->root().toJson(4), umlauts.left(3));
    const QByteArray shortened = json('"' + QByteArray(5000, 'x') + '"')->root().toJson(10'000);
    QCOMPARE(QString::fromUtf8(shortened),
             QStringLiteral("\"") + QString(512, QLatin1Char('x')) + QStringLiteral("…\""));
  }

  void showsAllOfItselfToPrograms() {
    QByteArray long_list = "[0";
    for (int i = 1; i < 100; ++i) long_list += ",0.5";
    QCOMPARE(json(long_list + "]")->root().toWholeJson(), QByteArray(long_list + "]"));
    const QByteArray long_text = '"' + QByteArray(5000, 'x') + '"';
    QCOMPARE(json(long_text)->root().toWholeJson(), long_text);
    QCOMPARE(cbor(typedArray(72, "\xff\x05"))->root().toWholeJson(), QByteArray(R"({"a":[-1,5]})"));
    // Whole numbers to their last digit.
    const quint64 most = std::numeric_limits<quint64>::max();
    QCOMPARE(cbor(typedArray(71, littleEndian<quint64>({most, 1})))->root().toWholeJson(),
             QByteArray(R"({"a":[18446744073709551615,1]})"));
    QCOMPARE(cbor(QByteArray::fromHex("a161611b8000000000000001"))->root().toWholeJson(),
             QByteArray(R"({"a":9223372036854775809})"));
    QCOMPARE(json(R"({"a":18446744073709551615})")->root().toWholeJson(),
             QByteArray(R"({"a":18446744073709551615})"));
    // Bytes are base64, and what is no finite number is null.
    QCOMPARE(cbor(typedArray(64, "\xff\x05"))->root().toWholeJson(), QByteArray(R"({"a":"/wU="})"));
    const QByteArray reals = littleEndian<float>(
        {0.5F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()});
    QCOMPARE(cbor(typedArray(85, reals))->root().toWholeJson(), QByteArray(R"({"a":[0.5,null,null]})"));
  }

  void countsMoreItemsThanTheParserDoes() {
    QByteArray text = "[" + QByteArray("0,").repeated(0xffffff + 5) + "0]";
    const auto frame = json(text);
    QCOMPARE(frame->root().size(), std::size_t(0xffffff + 6));
  }
};

}  // namespace test_rosbridge_field

MAPWRIGHT_TEST(test_rosbridge_field, TestRosbridgeField, Core)
#include "test_rosbridge_field.moc"
