// What a broken or hostile server can send must neither crash the reader nor make it take memory out of
// proportion. Most is worth running under the sanitizers.
#include <fstream>
#include <random>

#include <QtTest>

#include "frames_for_tests.h"
#include "net/rosbridge/fragment_joiner.h"
#include "rosbridge_server.h"
#include "test_program.h"

namespace test_rosbridge_garbage {

using namespace mapwright::net::rosbridge;
using testing::cbor;
using testing::json;
using testing::pieceFrame;
using testing::quick;
using testing::RosbridgeServer;
using testing::written;
using Wire = Frame::Wire;

namespace {

/// Asks everything of a field and of all below it.
void askAll(const Field& field, int depth = 0) {
  field.toJson(500);
  field.number();
  field.integer();
  field.flag();
  field.text();
  field.bytes(10'000);
  field.int8s(10'000);
  field.numbers(10'000);
  field.time();
  field.size();
  field["data"];
  if (depth > 3) return;
  int asked = 0;
  field.each([&](const Field& item) {
    if (++asked < 20) askAll(item, depth + 1);
  });
  field.members([&](std::string_view name, const Field& value) {
    field[name];
    if (++asked < 20) askAll(value, depth + 1);
  });
}

QByteArray textMessage() {
  return R"({"op":"publish","topic":"\/map","msg":{"header":{"stamp":{"secs":1,"nsecs":2},"frame_id":"m\u00e4p"},)"
         R"("info":{"resolution":0.05000000074505806},"data":[-1,0,100,NaN,1e5,-0.5],"more":[true,null,{"a":[]}]}})";
}

QByteArray binaryMessage() {
  return written([](QCborStreamWriter& writer) {
    writer.startMap(2);
    writer.append(QStringLiteral("op"));
    writer.append(QStringLiteral("publish"));
    writer.append(QStringLiteral("msg"));
    writer.startMap();
    for (const int tag : {64, 69, 72, 77, 81, 85, 86, 40}) {
      writer.append(QString::number(tag));
      writer.append(QCborTag(tag));
      writer.append(QByteArray("0123456789abcdef"));
    }
    writer.append(QStringLiteral("list"));
    writer.startArray();
    writer.append(-5);
    writer.append(1.5);
    writer.append(nullptr);
    writer.endArray();
    writer.endMap();
    writer.endMap();
  });
}

/// Kilobytes of a line of /proc/self/status.
qint64 statusKb(const char* name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(name))
      return QByteArray::fromStdString(line.substr(strlen(name))).simplified().split(' ')[0].toLongLong();
  }
  return 0;
}

}  // namespace

class TestRosbridgeGarbage : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void framesThatAreCutOff() {
    for (const auto& [whole, wire] :
         {std::pair{textMessage(), Wire::Text}, {binaryMessage(), Wire::Binary}}) {
      QCOMPARE(Frame::read(whole, wire)->fault(), Frame::Fault::None);
      askAll(Frame::read(whole, wire)->root());
      for (qsizetype length = 0; length < whole.size(); ++length) {
        const auto frame = Frame::read(whole.left(length), wire);
        QVERIFY2(frame->fault() != Frame::Fault::None, whole.left(length).constData());
        askAll(frame->root());
      }
    }
  }

  void framesWithBytesThatAreWrong() {
    std::mt19937 random(11);
    for (const auto& [whole, wire] :
         {std::pair{textMessage(), Wire::Text}, {binaryMessage(), Wire::Binary}}) {
      for (int round = 0; round < 10'000; ++round) {
        QByteArray bytes = whole;
        for (unsigned wrong = 0; wrong <= random() % 4; ++wrong) {
          bytes[qsizetype(random() % unsigned(bytes.size()))] = char(random());
        }
        askAll(Frame::read(bytes, wire)->root());
      }
    }
  }

  void randomBytes() {
    std::mt19937 random(12);
    for (int round = 0; round < 20'000; ++round) {
      QByteArray bytes(qsizetype(random() % 60), '\0');
      for (char& byte : bytes) byte = char(random());
      askAll(cbor(bytes)->root());
      askAll(json(bytes)->root());
    }
  }

  void picturesThatAreWrong() {
    std::mt19937 random(13);
    const QByteArray png = testing::pictureOf(textMessage());
    for (int round = 0; round < 2'000; ++round) {
      QByteArray bytes = png;
      bytes[qsizetype(random() % unsigned(bytes.size()))] = char(random());
      askAll(json("{\"op\":\"png\",\"data\":\"" + bytes.left(qsizetype(random() % 2000)).toBase64() + "\"}")
                 ->root());
    }
  }

  void piecesThatAreWrong() {
    std::mt19937 random(14);
    FragmentJoiner::Limits limits;
    limits.bytes = 50'000;
    FragmentJoiner joiner(limits);
    for (int round = 0; round < 20'000; ++round) {
      const QByteArray frame =
          pieceFrame(int(random() % 5), int(random() % 30) - 2, double(random() % 250) / 8,
                     QByteArray(qsizetype(random() % 300), 'x'));
      (void)joiner.add(json(frame)->root(), std::chrono::milliseconds(round));
      QVERIFY(joiner.heldBytes() <= limits.bytes);
    }
  }

  void aLyingLengthTakesNoMemory() {
    const qint64 before = statusKb("VmHWM:");
    QByteArray lying;
    for (int i = 0; i < 1000; ++i) lying += QByteArray("\x9b\0\0\0\x7f\xff\xff\xff\xff", 9);
    askAll(cbor(lying)->root());
    askAll(cbor(QByteArray("\xd8\x48\x5a\xff\xff\xff\xff", 7))->root());
    QVERIFY2(statusKb("VmHWM:") - before < 20'000, "memory was taken for what is not there");
  }

  void aHundredMegabytesOfText() {
    // One long text, as a base64 image is; then numbers without an end.
    const qint64 before = statusKb("VmRSS:");
    {
      QByteArray text = "{\"op\":\"publish\",\"msg\":{\"data\":\"" + QByteArray(100'000'000, 'A') + "\"}}";
      const auto frame = json(text);
      QCOMPARE(frame->fault(), Frame::Fault::None);
      text.clear();
      QVERIFY(!frame->root()["msg"]["data"].bytes(1'000'000));
      QVERIFY(frame->root()["msg"].toJson(5000).size() < 1000);
#if !defined(__SANITIZE_ADDRESS__)
      QVERIFY2(statusKb("VmRSS:") - before < 250'000, "a frame holds more than its text");
#else
      Q_UNUSED(before);
#endif
    }
    QByteArray numbers = "[" + QByteArray("1,").repeated(10'000'000);
    QCOMPARE(json(numbers)->fault(), Frame::Fault::NotJson);
    numbers += "1]";
    QCOMPARE(json(numbers)->root().int8s(20'000'000).value_or(std::vector<std::int8_t>()).size(),
             std::size_t(10'000'001));
    QVERIFY(!json(numbers)->root().int8s(10'000'000));
  }

  void deepNests() {
    for (const char* open : {"[", "{\"a\":", "[[{\"a\":["}) {
      const auto frame = json(QByteArray(open).repeated(1'000'000));
      QVERIFY(frame->root().isNull());
    }
    for (const char open : {'\x81', '\x9f', '\xc1', '\xa1', '\xbf'}) {
      QVERIFY(cbor(QByteArray(5'000'000, open))->root().isNull());
    }
  }

  void aClientSurvivesAllOfIt() {
    RosbridgeServer server;
    Client client(server.url(), quick());
    int messages = 0;
    connect(&client, &Client::received, this, [&](const TopicMessage& message) {
      askAll(message.msg);
      ++messages;
    });
    Subscription wanted;
    wanted.topic = "/map";
    client.subscribe(wanted);
    client.open();
    testing::Replies replies;
    client.call(testing::request("/x"), replies.collect());
    QTRY_COMPARE(server.seen.size(), 2);
    std::mt19937 random(15);
    const QByteArray operations[] = {textMessage(),
                                     R"({"op":"service_response","id":"c1","values":{},"result":true})",
                                     R"({"op":"status","level":"error","msg":"x","id":"s1"})",
                                     pieceFrame(0, 0, 2.5, "{"), R"({"op":"png","data":"iVBORw0KGgo="})"};
    for (int round = 0; round < 2'000; ++round) {
      QByteArray text = operations[random() % 5];
      if (round % 7 == 0) text = text.left(qsizetype(1 + random() % unsigned(text.size())));
      // Printable: the socket itself refuses what is no UTF-8.
      text[qsizetype(random() % unsigned(text.size()))] = char(' ' + random() % 90);
      server.say(text);
      QByteArray bytes = binaryMessage();
      bytes[qsizetype(random() % unsigned(bytes.size()))] = char(random());
      server.sayBytes(bytes);
    }
    server.say(R"({"op":"publish","topic":"/map","msg":{"last":true}})");
    QTRY_VERIFY(messages > 0 && client.oddities() > 1000);
    QCOMPARE(client.link().state(), mapwright::net::WebSocketLink::State::Open);
    client.close();
    QTRY_COMPARE(replies.all.size(), 1);  // once, whatever it was
  }
};

}  // namespace test_rosbridge_garbage

MAPWRIGHT_TEST(test_rosbridge_garbage, TestRosbridgeGarbage, Core)
#include "test_rosbridge_garbage.moc"
