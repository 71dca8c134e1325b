#include <QtTest>

#include "frames_for_tests.h"
#include "net/rosbridge/frame.h"
#include "test_program.h"

namespace test_rosbridge_frame {

using namespace mapwright::net::rosbridge;
using Fault = Frame::Fault;
using testing::cbor;
using testing::json;
using testing::pictureFrame;
using testing::pictureOf;

class TestRosbridgeFrame : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void readsBothWaysOfWriting() {
    for (const char* text :
         {R"({"op":"publish","topic":"\/a\/b","msg":{"name":"\u00e4"}})",
          "{ \"msg\" : { \"name\" : \"\xc3\xa4\" },\n \"topic\" : \"/a/b\", \"op\":\"publish\" }"}) {
      const auto frame = json(text);
      QCOMPARE(frame->fault(), Fault::None);
      QCOMPARE(frame->root()["topic"].text(), std::string("/a/b"));
      QCOMPARE(QString::fromStdString(frame->root()["msg"]["name"].text()), QStringLiteral("ä"));
      QCOMPARE(frame->bytes(), qint64(qstrlen(text)));
    }
  }

  void numbersThatAreNoneAreNull() {
    const auto frame =
        json(R"({"a":[NaN,1,Infinity,-Infinity,nan,inf],"b":1e999,"c":123456789012345678901234567890,)"
             R"("d":18446744073709551615,"e":"NaN, \u0022Infinity\u0022","f":null,"g":-1.5e-3})");
    QCOMPARE(frame->fault(), Fault::None);
    const Field root = frame->root();
    QCOMPARE(root["a"].size(), std::size_t(6));
    int nulls = 0;
    root["a"].each([&](const Field& item) { nulls += item.isNull(); });
    QCOMPARE(nulls, 5);
    QVERIFY(root["b"].isNull() && root["c"].isNull() && root["f"].isNull());
    QCOMPARE(root["d"].number(), 18446744073709551615.0);
    QCOMPARE(root["e"].text(), std::string("NaN, \"Infinity\""));
    QCOMPARE(root["g"].number(), -1.5e-3);
  }

  void whatLooksLikeANumberInATextStays() {
    const auto frame = json("{\"a\":NaN,\"t\":\"\\\"NaN\\\\\",\"u\":-Infinity}");
    QCOMPARE(frame->root()["t"].text(), std::string("\"NaN\\"));
    QVERIFY(frame->root()["u"].isNull());
  }

  void textThatIsNoneIsMadeReadable() {
    QCOMPARE(QString::fromStdString(json(R"({"t":"a\ud800b\udc00\ud83d\ude00"})")->root()["t"].text()),
             QStringLiteral("a\uFFFDb\uFFFD") + QString::fromUtf8("\xf0\x9f\x98\x80"));
    QCOMPARE(QString::fromStdString(json("{\"t\":\"a\xff\"}")->root()["t"].text()),
             QStringLiteral("a\uFFFD"));
  }

  void aPictureIsTheMessageThatItHolds() {
    for (int length = 1; length < 40; ++length) {
      const QByteArray name(length, 'n');
      const QByteArray frame =
          pictureFrame("{\"op\":\"publish\",\"topic\":\"/m\",\"msg\":{\"s\":\"" + name + "\"}}");
      const auto read = json(frame);
      QCOMPARE(read->fault(), Fault::None);
      QCOMPARE(read->root()["op"].text(), std::string("publish"));
      QCOMPARE(read->root()["msg"]["s"].text(), name.toStdString());
      QCOMPARE(read->bytes(), qint64(frame.size()));
    }
  }

  void aPictureMayHoldNumbersThatAreNone() {
    QCOMPARE(json(pictureFrame(R"({"op":"publish","msg":[NaN,1]})"))->root()["msg"].size(), std::size_t(2));
  }

  void whatIsNoPictureOfAMessageIsAFault() {
    QImage gray(5, 5, QImage::Format_Grayscale8);
    gray.fill(Qt::black);
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    gray.save(&buffer, "PNG");
    const auto wrapped = [](const QByteArray& data) { return "{\"op\":\"png\",\"data\":\"" + data + "\"}"; };
    for (const QByteArray& text :
         {wrapped(png.toBase64()), wrapped("!"), wrapped(""), QByteArray(R"({"op":"png"})"),
          QByteArray(R"({"op":"png","data":7})"), pictureFrame("no message"),
          pictureFrame(pictureFrame(R"({"op":"publish"})")), wrapped(pictureOf("{}").left(50).toBase64())}) {
      const auto frame = json(text);
      QVERIFY2(frame->fault() == Fault::NotAPicture, text.constData());
      QVERIFY(frame->root().isNull());
    }
  }

  void aPictureThatClaimsMoreThanItsBytesCanHoldIsRefusedBeforeMemoryIsTaken() {
    QByteArray png = pictureOf(QByteArray(3000, 'x'));
    QVERIFY(textOfPng({png.constData(), std::size_t(png.size())}, 31 * 33 * 3));
    QVERIFY(!textOfPng({png.constData(), std::size_t(png.size())}, 31 * 33 * 3 - 1));
    // Width and height of the header are bytes 16 to 23; a checksum follows.
    const auto claimed = [&](quint32 width, quint32 height) {
      QByteArray header(8, '\0');
      qToBigEndian(width, header.data());
      qToBigEndian(height, header.data() + 4);
      png.replace(16, 8, header);
      quint32 crc = 0xffffffff;
      for (const char c : png.mid(12, 17)) {
        crc ^= quint8(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320U : 0U);
      }
      qToBigEndian(quint32(~crc), png.data() + 29);
      return textOfPng({png.constData(), std::size_t(png.size())}, std::size_t(1) << 40);
    };
    QVERIFY(!claimed(20'000, 20'000));
    QVERIFY(!claimed(0x7fffffff, 0x7fffffff));
    QVERIFY(!claimed(0, 0));
  }

  void whatIsNoJsonIsAFaultWithoutARoot() {
    for (const char* text : {"", " ", "{", "{\"a\":", "{\"a\":1}}", "[1,]", "nope", "\"", "{\"a\" 1}",
                             "\xff\xfe", "{\"a\":NaNa}"}) {
      const auto frame = json(text);
      QVERIFY2(frame->fault() == Fault::NotJson, text);
      QVERIFY(frame->root().isNull());
    }
  }

  void whatIsNoCborIsAFaultWithoutARoot_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("a map that is cut off") << QByteArray(
        "\xa1\x61"
        "a",
        3);
    QTest::newRow("a text longer than the frame") << QByteArray("\x7b\x7f\xff\xff\xff\xff\xff\xff\xff", 9);
    QTest::newRow("bytes longer than the frame") << QByteArray("\x5b\xff\xff\xff\xff\xff\xff\xff\xff", 9);
    QTest::newRow("a list longer than the frame")
        << QByteArray("\x9b\xff\xff\xff\xff\xff\xff\xff\xff\x01", 10);
    QTest::newRow("a map longer than the frame") << QByteArray("\xbb\x80\0\0\0\0\0\0\0\x01", 10);
    QTest::newRow("no end") << QByteArray("\x9f\x01", 2);
    QTest::newRow("an end only") << QByteArray("\xff", 1);
    QTest::newRow("a name without a value, and the end") << QByteArray(
        "\xbf\x61"
        "a\xff",
        4);
    QTest::newRow("a length that is reserved") << QByteArray("\x1c", 1);
    QTest::newRow("a tag of nothing") << QByteArray("\xc0", 1);
    QTest::newRow("chunks of another kind") << QByteArray(
        "\x5f\x61"
        "a\xff",
        4);
    QTest::newRow("more behind it") << QByteArray("\x01\x01", 2);
  }

  void whatIsNoCborIsAFaultWithoutARoot() {
    QFETCH(const QByteArray, bytes);
    const auto frame = cbor(bytes);
    QCOMPARE(frame->fault(), Fault::NotCbor);
    QVERIFY(frame->root().isNull());
  }

  void onlyAnObjectHasMembers_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("a list") << QByteArray("\x83\x61\x61\x61\x61\x01");
    QTest::newRow("a list of pairs without an end") << QByteArray("\x9f\x61\x61\x01\xff");
    QTest::newRow("a text") << QByteArray("\x61\x61");
    QTest::newRow("bytes") << QByteArray("\x41\x61");
    QTest::newRow("a number") << QByteArray("\x18\x61");
    QTest::newRow("null") << QByteArray("\xf6");
    QTest::newRow("a tag before a list") << QByteArray("\xc1\x82\x61\x61\x01");
  }
  void onlyAnObjectHasMembers() {
    QFETCH(QByteArray, bytes);
    const auto frame = Frame::read(bytes, Frame::Wire::Binary);
    QVERIFY(!frame->rawMember("a"));
    const auto object = Frame::read(QByteArray("\xa1\x61\x61\x01"), Frame::Wire::Binary);
    QCOMPARE(object->rawMember("a"), std::optional<std::string_view>("\x01"));
  }

  void aMemberAsItWasReceivedIsTheOneThatIsRead() {
    const auto frame = Frame::read(R"({"op":"publish","\u006dsg":{"a":1},"msg":{"a":2}})", Frame::Wire::Text);
    QCOMPARE(frame->root()["msg"]["a"].integer(), std::optional<std::int64_t>(1));
    QCOMPARE(frame->rawMember("msg"), std::optional<std::string_view>(R"({"a":1})"));
  }

  void textInChunksIsPassedOver() {
    const auto frame =
        cbor(QByteArray("\xa2\x61"
                        "a\x7f\x61"
                        "x\x61"
                        "y\xff\x61"
                        "b\x05",
                        12));
    QCOMPARE(frame->fault(), Fault::None);
    QVERIFY(frame->root()["a"].isNull());
    QCOMPARE(frame->root()["b"].integer(), 5);
  }

  void whatIsTooDeepIsRefused() {
    QCOMPARE(json(QByteArray(100, '[') + QByteArray(100, ']'))->fault(), Fault::None);
    QCOMPARE(json(QByteArray(100'000, '[') + QByteArray(100'000, ']'))->fault(), Fault::TooDeep);
    QCOMPARE(json(QByteArray("{\"a\":").repeated(100'000) + "1" + QByteArray(100'000, '}'))->fault(),
             Fault::TooDeep);
    QCOMPARE(cbor(QByteArray(100, '\x81') + '\x01')->fault(), Fault::None);
    QCOMPARE(cbor(QByteArray(1'000'000, '\x81'))->fault(), Fault::TooDeep);
    QCOMPARE(cbor(QByteArray(1'000'000, '\xc1'))->fault(), Fault::TooDeep);
  }

  void whatIsTooLongIsRefused() {
    QCOMPARE(Frame::read("[1,2]", Frame::Wire::Text, {5})->fault(), Fault::None);
    QCOMPARE(Frame::read("[1,2]", Frame::Wire::Text, {4})->fault(), Fault::TooLarge);
    QCOMPARE(Frame::read("\x01", Frame::Wire::Binary, {0})->fault(), Fault::TooLarge);
  }

  void fieldsLiveAsLongAsTheirFrame() {
    QByteArray bytes = testing::typedArray(72, "\x01\x02");
    auto frame = cbor(bytes);
    bytes.fill('x');
    QCOMPARE(frame->root()["a"].size(), std::size_t(2));
    QByteArray text = "{\"name\":\"value\"}";
    frame = json(text);
    text.fill('x');
    QCOMPARE(frame->root()["name"].text(), std::string("value"));
  }
};

}  // namespace test_rosbridge_frame

MAPWRIGHT_TEST(test_rosbridge_frame, TestRosbridgeFrame, Core)
#include "test_rosbridge_frame.moc"
