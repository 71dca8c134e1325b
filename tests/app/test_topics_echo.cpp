// `topics echo` prints a message as it came, whatever its length; --shorten says what it leaves out.
#include <random>

#include <QTest>
#include <QTimer>

#include "../robot/scripted_bridge.h"
#include "../robot/scripted_robot.h"
#include "program.h"
#include "test_program.h"

namespace test_topics_echo {

using namespace mapwright;
using robot::testing::ScriptedBridge;
using robot::testing::ScriptedRobot;

namespace {

QJsonValue randomValue(std::mt19937& random, int depth);

QJsonArray randomList(std::mt19937& random, int depth) {
  QJsonArray list;
  const int size = int(random() % 3 == 0 ? random() % 200 : random() % 6);
  const bool numbers = depth == 0 || random() % 2 == 0;
  for (int i = 0; i < size; ++i)
    list << (numbers ? QJsonValue(double(random() % 100'000) / 7) : randomValue(random, depth - 1));
  return list;
}

QJsonObject randomObject(std::mt19937& random, int depth) {
  QJsonObject object;
  const int size = 1 + int(random() % 4);
  for (int i = 0; i < size; ++i)
    object.insert(QStringLiteral("m%1").arg(random() % 50), randomValue(random, depth - 1));
  return object;
}

QJsonValue randomValue(std::mt19937& random, int depth) {
  switch (random() % (depth > 0 ? 6 : 4)) {
    case 0:
      return int(random() % 1000) - 500;
    case 1:
      return random() % 2 == 0;
    case 2:
      return QString(int(random() % 4 == 0 ? 600 + random() % 3000 : random() % 9), QChar(0x263A));
    case 3:
      return double(random() % 1000) / 16;
    case 4:
      return randomList(random, depth);
    default:
      return randomObject(random, depth);
  }
}

/// An independent reading of what --shorten does: at most 32 items of a list, then how many are left out, and
/// at most 512 bytes of a text.
QJsonValue shortened(const QJsonValue& value, bool& any) {
  if (value.isArray()) {
    QJsonArray list;
    const QJsonArray all = value.toArray();
    for (int i = 0; i < std::min<int>(32, int(all.size())); ++i) list << shortened(all[i], any);
    if (all.size() > 32) list << QStringLiteral("… %1").arg(all.size() - 32);
    any |= all.size() > 32;
    return list;
  }
  if (value.isObject()) {
    QJsonObject object;
    const QJsonObject all = value.toObject();
    for (auto at = all.begin(); at != all.end(); ++at) object[at.key()] = shortened(at.value(), any);
    return object;
  }
  if (!value.isString() || value.toString().toUtf8().size() <= 512) return value;
  any = true;
  QString text = value.toString();
  while (text.toUtf8().size() > 512) text.chop(1);
  return text + QChar(0x2026);
}

QString compact(const QJsonObject& object) {
  return QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

}  // namespace

class TopicsEchoTest : public QObject {
  Q_OBJECT
  tests::Program program_;

  tests::Ended echo(const QString& robot, const QString& topic, const QStringList& more = {}) const {
    return program_.run(QStringList{QStringLiteral("topics"), QStringLiteral("echo"), topic,
                                    QStringLiteral("--robot"), robot, QStringLiteral("--count"),
                                    QStringLiteral("1"), QStringLiteral("--timeout"), QStringLiteral("20")} +
                        more);
  }

 private Q_SLOTS:
  void aMessageIsPrintedAsItCame_data() {
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 12; ++seed) QTest::addRow("%d", seed) << seed;
  }
  void aMessageIsPrintedAsItCame() {
    QFETCH(int, seed);
    std::mt19937 random{unsigned(seed)};
    QJsonObject message = randomObject(random, 4);
    message[QStringLiteral("data")] = randomList(random, 0);
    bool any = false;
    const QJsonObject shorter = shortened(message, any).toObject();
    ScriptedBridge bridge;
    bridge.advertise(QStringLiteral("/odd"), QStringLiteral("odd_msgs/Odd"));
    bridge.latch(QStringLiteral("/odd"), message);
    ScriptedRobot robot;
    robot.serve("/device/info", R"({"caps":{"supportsEnableTopicList":true}})");
    QJsonObject of_robot = message;
    of_robot[QStringLiteral("topic")] = QStringLiteral("/odd");
    robot.greeting = QJsonDocument(of_robot).toJson(QJsonDocument::Indented);  // with line breaks
    for (const bool ros : {true, false}) {
      const QString address = ros ? QStringLiteral("ros+") + bridge.url().toString()
                                  : QStringLiteral("axbot+") + robot.url().toString();
      const auto with = [&](QJsonObject object) {
        if (!ros) object[QStringLiteral("topic")] = QStringLiteral("/odd");
        return compact(object);
      };
      const tests::Ended whole = echo(address, QStringLiteral("/odd"));
      QCOMPARE(whole.code, 0);
      QCOMPARE(whole.out.count(QLatin1Char('\n')), 1);
      QCOMPARE(compact(whole.object()), with(message));
      const tests::Ended brief = echo(address, QStringLiteral("/odd"), {QStringLiteral("--shorten")});
      QCOMPARE(brief.code, 0);
      QCOMPARE(compact(brief.object()), with(shorter));
      QCOMPARE(brief.err.contains(QLatin1String("--shorten")), any);
    }
  }

  void lengthIsNoReasonToCut() {
    ScriptedRobot robot;
    robot.serve("/device/info", R"({"caps":{"supportsEnableTopicList":true}})");
    const QByteArray text(3 << 20, 'x');
    robot.greeting = "{\"topic\":\"/long\",\"text\":\"" + text + "\"}";
    const tests::Ended whole =
        echo(QStringLiteral("axbot+") + robot.url().toString(), QStringLiteral("/long"));
    QCOMPARE(whole.code, 0);
    QCOMPARE(whole.out.toUtf8(), robot.greeting + '\n');
    QVERIFY2(whole.err.isEmpty(), qPrintable(whole.err));
  }

  void bytesThatNobodyKnowsAreJsonToo() {
    ScriptedRobot robot;
    robot.serve("/device/info", R"({"caps":{"supportsEnableTopicList":true}})");
    QTimer again;
    connect(&again, &QTimer::timeout, &again,
            [&] { robot.sendBinary(QByteArray("\x04/odd\0", 6) + QByteArray(100'000, char(0xab))); });
    again.start(100);
    const tests::Ended whole =
        echo(QStringLiteral("axbot+") + robot.url().toString(), QStringLiteral("/odd"));
    QCOMPARE(whole.code, 0);
    QCOMPARE(whole.out.count(QLatin1Char('\n')), 1);
    const QJsonObject message = whole.object();
    QCOMPARE(message[QLatin1String("bytes")].toInt(), 100'000);
    QCOMPARE(QByteArray::fromBase64(message[QLatin1String("base64")].toString().toLatin1()),
             QByteArray(100'000, char(0xab)));
  }
};

}  // namespace test_topics_echo

MAPWRIGHT_TEST(test_topics_echo, TopicsEchoTest, Widgets)
#include "test_topics_echo.moc"
