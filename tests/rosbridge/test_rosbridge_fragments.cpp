#include <random>

#include <QtTest>

#include "frames_for_tests.h"
#include "net/rosbridge/fragment_joiner.h"
#include "net/rosbridge/requests.h"
#include "test_program.h"

namespace test_rosbridge_fragments {

using namespace mapwright::net::rosbridge;
using testing::json;
using testing::pieceFrame;
using Fault = FragmentJoiner::Fault;
using std::chrono::milliseconds;

namespace {

/// A joiner that tells in short what became of each piece.
struct Joined {
  explicit Joined(FragmentJoiner::Limits limits = {}) : joiner(limits) {}
  QByteArray add(const QJsonValue& id, int number, double total, const QByteArray& data) {
    return onFrame(pieceFrame(id, number, total, data));
  }
  QByteArray onFrame(const QByteArray& frame) {
    const auto taken = joiner.add(json(frame)->root(), now);
    if (!taken) return taken.error() == Fault::Malformed ? "(malformed)" : "(too large)";
    return taken->value_or("(wait)");
  }
  FragmentJoiner joiner;
  milliseconds now{0};
};

}  // namespace

class TestRosbridgeFragments : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theCountIsTheWholePartOfTheTotal() {
    Joined joined;
    QCOMPARE(joined.add(0, 0, 2.99, "{"), QByteArray("(wait)"));
    QCOMPARE(joined.add(0, 1, 2.99, "}"), QByteArray("{}"));
    QCOMPARE(joined.add(0, 0, 1.2, "{}"), QByteArray("{}"));
    QCOMPARE(joined.joiner.heldBytes(), std::size_t(0));
  }

  void aTotalThatIsOneTooManyIsNotWaitedFor() {
    Joined joined;
    QCOMPARE(joined.add(0, 0, 3, "{\"a\":\"}"), QByteArray("(wait)"));
    QCOMPARE(joined.add(0, 1, 3, "\\\"\"}"), QByteArray("{\"a\":\"}\\\"\"}"));
    QCOMPARE(joined.add(0, 0, 3, "{\"a\":{"), QByteArray("(wait)"));
    QCOMPARE(joined.add(0, 1, 3, "\"b\":1}"), QByteArray("(wait)"));
    QCOMPARE(joined.add(0, 2, 3, "}"), QByteArray("{\"a\":{\"b\":1}}"));
  }

  void idsMayBeNumbersTextsOrAbsent() {
    Joined joined;
    QCOMPARE(joined.add(7, 0, 2, "a"), QByteArray("(wait)"));
    QCOMPARE(joined.add(QStringLiteral("7"), 0, 2, "b"), QByteArray("(wait)"));
    QCOMPARE(joined.onFrame(R"({"op":"fragment","num":0,"total":2,"data":"c"})"), QByteArray("(wait)"));
    QCOMPARE(joined.joiner.heldMessages(), std::size_t(3));
    QCOMPARE(joined.onFrame(R"({"op":"fragment","num":1,"total":2,"data":"C"})"), QByteArray("cC"));
    QCOMPARE(joined.add(QStringLiteral("7"), 1, 2, "B"), QByteArray("bB"));
    QCOMPARE(joined.add(7, 1, 2, "A"), QByteArray("aA"));
  }

  void messagesMayComeInterleavedAndTheirPiecesInAnyOrder() {
    std::vector<std::pair<int, int>> pieces;
    for (int message = 0; message < 10; ++message) {
      for (int number = 0; number < 10; ++number) pieces.emplace_back(message, number);
    }
    std::mt19937 random(3);
    std::shuffle(pieces.begin(), pieces.end(), random);
    Joined joined;
    int complete = 0;
    for (const auto& [message, number] : pieces) {
      const QByteArray text =
          joined.add(message, number, 10.5, QByteArray(1, char('a' + message)) + char('0' + number));
      if (text == "(wait)") continue;
      ++complete;
      QByteArray expected;
      for (int i = 0; i < 10; ++i) expected += QByteArray(1, char('a' + message)) + char('0' + i);
      QCOMPARE(text, expected);
    }
    QCOMPARE(complete, 10);
    QCOMPARE(joined.joiner.heldBytes(), std::size_t(0));
  }

  void allIdsMayBeZero() {
    Joined joined;
    QCOMPARE(joined.add(0, 0, 2.5, "a"), QByteArray("(wait)"));
    QCOMPARE(joined.add(0, 0, 2.25, "x"), QByteArray("(wait)"));  // another length
    QCOMPARE(joined.add(0, 0, 2.5, "b"), QByteArray("(wait)"));   // the same
    QCOMPARE(joined.add(0, 1, 2.25, "X"), QByteArray("xX"));
    QCOMPARE(joined.add(0, 1, 2.5, "A"), QByteArray("aA"));
    QCOMPARE(joined.add(0, 1, 2.5, "B"), QByteArray("bB"));
  }

  void aPieceThatComesTwiceCountsOnce() {
    Joined joined;
    QCOMPARE(joined.add(0, 0, 2.5, "a"), QByteArray("(wait)"));
    const std::size_t held = joined.joiner.heldBytes();
    QCOMPARE(joined.add(0, 0, 2.5, "a"), QByteArray("(wait)"));
    QCOMPARE(joined.joiner.heldBytes(), held);
    QCOMPARE(joined.add(0, 1, 2.5, "b"), QByteArray("ab"));
    QCOMPARE(joined.joiner.heldMessages(), std::size_t(0));
  }

  void whatIsNoPieceIsRefused() {
    Joined joined;
    for (const char* frame :
         {"{}", R"({"id":0,"num":0,"total":1})", R"({"id":0,"num":0,"data":"x"})",
          R"({"id":0,"total":1,"data":"x"})", R"({"id":0,"num":-1,"total":1,"data":"x"})",
          R"({"id":0,"num":1,"total":1.9,"data":"x"})", R"({"id":0,"num":0,"total":0,"data":"x"})",
          R"({"id":0,"num":0,"total":-3,"data":"x"})", R"({"id":0,"num":0,"total":NaN,"data":"x"})",
          R"({"id":0,"num":0.5,"total":2,"data":"x"})", R"({"id":0,"num":0,"total":2,"data":7})",
          R"({"id":[],"num":0,"total":2,"data":"x"})", R"({"id":true,"num":0,"total":2,"data":"x"})", "[]",
          "7"}) {
      QVERIFY2(joined.onFrame(frame) == "(malformed)", frame);
    }
    QCOMPARE(joined.add(QString(300, QLatin1Char('x')), 0, 2, "x"), QByteArray("(malformed)"));
    QCOMPARE(joined.onFrame(R"({"id":0,"num":0,"total":1e18,"data":"x"})"), QByteArray("(too large)"));
    QCOMPARE(joined.onFrame(R"({"id":0,"num":0,"total":1e300,"data":"x"})"), QByteArray("(too large)"));
    QCOMPARE(joined.joiner.heldMessages(), std::size_t(0));
  }

  void memoryIsBoundedAndTheOldestGoes() {
    FragmentJoiner::Limits limits;
    limits.bytes = 2000;
    Joined joined(limits);
    QCOMPARE(joined.add(1, 0, 2, QByteArray(600, 'a')), QByteArray("(wait)"));
    QCOMPARE(joined.add(2, 0, 2, QByteArray(600, 'b')), QByteArray("(wait)"));
    QCOMPARE(joined.add(3, 0, 2, QByteArray(600, 'c')), QByteArray("(wait)"));
    QCOMPARE(joined.joiner.heldMessages(), std::size_t(2));
    QCOMPARE(joined.joiner.dropped(), std::uint64_t(1));
    QVERIFY(joined.joiner.heldBytes() <= 2000);
    QCOMPARE(joined.add(2, 1, 2, "B").size(), 601);
    QCOMPARE(joined.add(4, 0, 2, QByteArray(2000, 'd')), QByteArray("(too large)"));
    // Nothing but nothings is not for free.
    for (int i = 0; i < 1000; ++i) joined.add(5, i, 5000, "");
    QVERIFY(joined.joiner.heldBytes() <= 2000);
  }

  void onlySoManyMessagesAreOpen() {
    FragmentJoiner::Limits limits;
    limits.messages = 4;
    Joined joined(limits);
    for (int i = 0; i < 10; ++i) joined.add(i, 0, 2, "x");
    QCOMPARE(joined.joiner.heldMessages(), std::size_t(4));
    QCOMPARE(joined.joiner.dropped(), std::uint64_t(6));
    QCOMPARE(joined.add(9, 1, 2, "y"), QByteArray("xy"));
  }

  void whatWaitsTooLongIsDropped() {
    Joined joined;
    joined.add(1, 0, 3, "a");
    joined.now = milliseconds(20'000);
    joined.add(1, 1, 3, "b");
    joined.add(2, 0, 3, "c");
    joined.now = milliseconds(50'000);
    joined.joiner.expire(joined.now);
    QCOMPARE(joined.joiner.heldMessages(), std::size_t(2));
    joined.now = milliseconds(50'001);
    joined.joiner.expire(joined.now);
    QCOMPARE(joined.joiner.heldMessages(), std::size_t(0));
    QCOMPARE(joined.joiner.heldBytes(), std::size_t(0));
    QCOMPARE(joined.joiner.dropped(), std::uint64_t(2));
  }

  void theInnerWordsOfAnErrorAreFound() {
    const auto inner = [](const char* words) { return QString::fromStdString(innerWords(words)); };
    QCOMPARE(inner("service [/x] responded with an error: b'no map'"), QStringLiteral("no map"));
    QCOMPARE(inner("service [/x] responded with an error: b\"it's \\\\ gone\""),
             QStringLiteral("it's \\ gone"));
    QCOMPARE(inner("service [/x] responded with an error: 'no\\nmap'"), QStringLiteral("no\nmap"));
    QCOMPARE(inner("service [/x] responded with an error: b'\\xc3\\xbc\\xff'"), QStringLiteral("ü\uFFFD"));
    QCOMPARE(inner("service [/x] responded with an error: b'\\x4"), QStringLiteral("b'\\x4"));
    QCOMPARE(inner("service [/x] responded with an error: plain"), QStringLiteral("plain"));
    QCOMPARE(inner("service [/x] responded with an error: b''"), QString());
    QCOMPARE(inner("service [/x] responded with an error: b'"), QStringLiteral("b'"));
    QCOMPARE(inner("service [/x] responded with an error: b'\\'"), QStringLiteral("\\"));
    QCOMPARE(inner("Service /x does not exist"), QStringLiteral("Service /x does not exist"));
    QCOMPARE(inner(""), QString());
  }
};

}  // namespace test_rosbridge_fragments

MAPWRIGHT_TEST(test_rosbridge_fragments, TestRosbridgeFragments, Core)
#include "test_rosbridge_fragments.moc"
