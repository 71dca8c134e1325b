// What people pass on when they ask for help holds no addresses, names and secrets; and how stalls are
// counted.
#include <QEvent>
#include <QTest>

#include "test_program.h"
#include "ui/window/left_out.h"
#include "ui/window/made_of.h"
#include "ui/window/stalls.h"
#include "ui/window/support_text.h"

namespace test_window_support {

using namespace mapwright::ui;
using std::chrono::milliseconds;

class WindowSupportTest : public QObject {
  Q_OBJECT
 private:
  static Privacy office() {
    Privacy privacy;
    privacy.robots = {
        {QStringLiteral("192.0.2.7"), QStringLiteral("192.0.2.7:8090"), QStringLiteral("Rosie")},
        {QStringLiteral("dock-3.local"), QStringLiteral("SN-4711")},
        {QString(), QStringLiteral("192.0.2.7"), QStringLiteral("Rosie in the hall")}};
    privacy.home = QStringLiteral("/home/anna");
    privacy.user = QStringLiteral("anna");
    privacy.computer = QStringLiteral("annas-pc");
    return privacy;
  }
  static quint64 total(const Stalls& stalls) {
    quint64 all = 0;
    for (const quint64 count : stalls.counts()) all += count;
    return all;
  }

 private Q_SLOTS:
  void whatIsPrivateIsReplaced_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("left");
    const auto row = [](const char* text, const char* left) {
      QTest::newRow(text) << QString::fromUtf8(text) << QString::fromUtf8(left);
    };
    row("axbot+http://192.0.2.7:8090", "axbot+http://robot-1");
    row("GET http://192.0.2.7:8090/maps/1?token=abc, then http://DOCK-3.local/x",
        "GET http://robot-1, then http://robot-2");
    row("ws://anna:hunter2@10.1.2.3:9090/", "ws://robot-3");
    row("https://[fe80::1]:8443/x and fe80::1", "https://robot-3 and robot-3");
    row("192.0.2.7:8090 refused, 10.0.0.9 too, 10.0.0.8 and 10.0.0.9",
        "robot-1 refused, robot-3 too, robot-4 and robot-3");
    row("[2001:db8::7]:8090: timed out", "robot-3: timed out");
    row("Rosie stands, ROSIE moves", "robot-1 stands, robot-1 moves");
    row("Rosie in the hall", "robot-1");
    row("SN-4711, not XSN-4711", "robot-2, not XSN-4711");
    row("AA:BB:cc:11:22:33", "hardware-address");
    row("/home/anna/maps/hall.yaml", "~/maps/hall.yaml");
    row("/home/bert/maps/hall.yaml", "~/maps/hall.yaml");
    row("anna on annas-pc", "user on computer");
    row("\"token\": \"abc\", password=hunter2 Authorization: Bearer abc.def",
        "\"token\": ***, password=*** Authorization: ***");
    row("Rosie-maps/c.yaml", "robot-1-maps/c.yaml");
    row("axbot+http://192.0.2.7:8090，已连接", "axbot+http://robot-1，已连接");
    row("password=hunter2，然后", "password=***，然后");
    row("机器人Rosie已连接", "机器人robot-1已连接");
    // What looks like it and is none.
    row("12:31:07.412 Qt 6.4.2, 1.2.3", "12:31:07.412 Qt 6.4.2, 1.2.3");
    row("2026-11-30T02:48:49Z, ns::name, savannah, 0:12", "2026-11-30T02:48:49Z, ns::name, savannah, 0:12");
    row("file:///home/anna/hall.yaml", "file://~/hall.yaml");
  }
  void whatIsPrivateIsReplaced() {
    QFETCH(QString, text);
    QFETCH(QString, left);
    QCOMPARE(withoutPrivate(text, office()), left);
  }

  void theTextHoldsVersionsSystemNumbersAndTheLastProblems() {
    Support support{QStringLiteral("Jobs\t3")};
    support.robot = {QStringLiteral("Open: axbot+http://192.0.2.7:8090, online")};
    for (int i = 1; i <= 25; ++i) support.problems << QStringLiteral("problem %1 at 192.0.2.7").arg(i);
    const QString text = supportText(support, {QStringLiteral("Debian on annas-pc")}, office());
    QVERIFY(text.startsWith(QLatin1String("mapwright ")));
    for (const Library& library : libraries())
      QVERIFY2(text.contains(library.name), qPrintable(library.name));
    for (const char* there : {"\nDebian on computer\n", "\nOpen: axbot+http://robot-1, online\n",
                              "\nJobs\t3\n", "\nproblem 6 at robot-1\n", "\nproblem 25 at robot-1\n"})
      QVERIFY2(text.contains(QLatin1String(there)), there);
    QVERIFY(!text.contains(QLatin1String("problem 5 ")));
    QVERIFY(text.contains(leftOutSentence()));
  }

  void eachEventIsCountedByItsTime_data() {
    QTest::addColumn<int>("ms");
    QTest::addColumn<int>("bucket");
    const auto row = [](int ms, int bucket) { QTest::addRow("%d ms", ms) << ms << bucket; };
    row(0, 0);
    row(15, 0);
    row(16, 1);
    row(32, 1);
    row(33, 2);
    row(50, 3);
    row(100, 4);
    row(499, 5);
    row(500, 6);
    row(60'000, 6);
  }
  void eachEventIsCountedByItsTime() {
    QFETCH(int, ms);
    QFETCH(int, bucket);
    Stalls stalls;
    stalls.add(milliseconds(ms), {});
    QCOMPARE(total(stalls), 1U);
    QCOMPARE(stalls.counts()[std::size_t(bucket)], 1U);
  }

  void theLongestIsNamed() {
    StallMeter meter;
    const auto event = [&](int from, int to, const Busy& busy) {
      QVERIFY(meter.begins(1, milliseconds(from), busy));
      meter.ends(milliseconds(to));
    };
    event(0, 20, {"MapView", QEvent::Paint});
    event(100, 170, {"MapsController", QEvent::Timer});
    event(200, 230, {"QPushButton", QEvent::MouseButtonRelease});
    QVERIFY(meter.stalls().longest() == milliseconds(70));
    QCOMPARE(meter.stalls().duringLongest().text(), QStringLiteral("Timer, MapsController"));
  }

  void whatIsSentWithinAnEventIsPartOfIt() {
    StallMeter meter;
    QVERIFY(meter.begins(1, milliseconds(0), {"outer", QEvent::Timer}));
    QVERIFY(!meter.begins(1, milliseconds(10), {"inner", QEvent::Show}));
    meter.ends(milliseconds(120));
    QCOMPARE(total(meter.stalls()), 1U);
    QCOMPARE(meter.stalls().counts()[4], 1U);
    QCOMPARE(QByteArray(meter.stalls().duringLongest().receiver), QByteArray("outer"));
  }

  void whatHappensBeforeTheWindowIsThereIsNoStall() {
    StallMeter meter;
    QVERIFY(!meter.begins(0, milliseconds(0), {"style", QEvent::StyleChange}));
    QCOMPARE(total(meter.stalls()), 0U);
  }

  void aDialogThatIsOpenForMinutesIsNoStall() {
    StallMeter meter;
    QVERIFY(meter.begins(1, milliseconds(0), {"click", QEvent::MouseButtonRelease}));
    meter.waits(milliseconds(40));  // 40 ms until the dialog was there
    meter.wakes(milliseconds(60'000));
    QVERIFY(meter.begins(2, milliseconds(60'001), {"typed", QEvent::KeyPress}));
    meter.ends(milliseconds(60'021));  // 20 ms
    meter.waits(milliseconds(60'021));
    meter.wakes(milliseconds(120'000));
    QVERIFY(meter.begins(2, milliseconds(120'000), {"closed", QEvent::MouseButtonRelease}));
    meter.ends(milliseconds(120'005));
    meter.ends(milliseconds(120'115));  // 110 ms of work after it
    QVERIFY(meter.stalls().longest() == milliseconds(110));
    QCOMPARE(QByteArray(meter.stalls().duringLongest().receiver), QByteArray("click"));
    QCOMPARE(total(meter.stalls()), 4U);
    QCOMPARE(meter.stalls().counts()[2], 1U);  // 40 ms
    QCOMPARE(meter.stalls().counts()[1], 1U);  // 20 ms
  }
};

}  // namespace test_window_support

MAPWRIGHT_TEST(test_window_support, WindowSupportTest, Widgets)
#include "test_window_support.moc"
