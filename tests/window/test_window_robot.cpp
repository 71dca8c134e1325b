// The Robot panel and the inspector of messages.
#include <QClipboard>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>
#include <QTimeZone>
#include <QtTest>

#include "test_program.h"
#include "ui/kit/pretty_json.h"
#include "ui/plots/message_view.h"
#include "ui/plots/messages_dock.h"
#include "ui/robot/robot_dock.h"
#include "ui/robot/robot_status.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_robot {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;
using test::kAddress;

namespace {

robot::RawMessage raw(const char* topic, const QByteArray& text) {
  robot::RawMessage message;
  message.topic = QLatin1String(topic);
  message.bytes = text.size();
  message.text = text;
  return message;
}

QStringList lines(const RobotDock& dock) { return dock.shownText().split(QLatin1Char('\n')); }

}  // namespace

class TestWindowRobot : public QObject {
  Q_OBJECT

  static void openLive(Bench& bench) {
    bench.prepare = [](test::FakeRobot& robot) { robot.has_live = true; };
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
  }

 private Q_SLOTS:
  void showsHowTheRobotIs() {
    Bench bench;
    openLive(bench);
    RobotDock& dock = *part<RobotDock>(*bench.window);
    for (const char* topic : {"/battery_state", "/alerts", "/planning_state", "/wheel_state"})
      QVERIFY2(bench.robot->wanted.contains(QLatin1String(topic)), topic);
    map::BatteryState battery;
    battery.level = 0.42;
    battery.voltage_v = 26.31;
    battery.supply = "charging";
    bench.robot->say(battery);
    map::WheelState wheels;
    wheels.control_mode = "auto";
    wheels.emergency_stop = true;
    wheels.wheels_released = true;
    bench.robot->say(wheels);
    map::SlamStatus slam;
    slam.state = "positioning";
    slam.position_quality = 10;
    slam.lidar_matching_score = 0.5;
    bench.robot->say(slam);
    map::PlanningState planning;
    planning.action_type = "standard";
    planning.move_state = "failed";
    planning.fail_reason = "<b>blocked</b>";
    planning.remaining_distance_m = 12.34;
    bench.robot->say(planning);
    dock.refresh();
    const QStringList shown = lines(dock);
    for (const char* line :
         {"Battery / Level: 42 %", "Battery / Supply: charging", "Battery / Voltage: 26.3 V",
          "Wheels / Control: auto", "Wheels / Emergency stop: PRESSED", "SLAM / Position: excellent",
          "SLAM / Lidar matching: 0.50", "Planning / State: failed", "Planning / Remaining: 12.3 m",
          "Planning / Failure: <b>blocked</b>"}) {
      QVERIFY2(shown.contains(QLatin1String(line)), line);
    }
  }

  void greysWhatIsNoLongerLive() {
    Bench bench;
    openLive(bench);
    RobotDock& dock = *part<RobotDock>(*bench.window);
    bench.robot->say(map::BatteryState{0.5, {}, {}, {}});
    dock.refresh();
    QVERIFY(!dock.greyed());
    bench.robot->goAway(QStringLiteral("connection refused"));
    QVERIFY(dock.greyed());
    QVERIFY(lines(dock).contains(QStringLiteral("Battery / Level: 50 %")));
    bench.robot->goOnline();
    QVERIFY(!dock.greyed());
  }

  void listsAlertsWithTheirTimes() {
    Bench bench;
    openLive(bench);
    RobotDock& dock = *part<RobotDock>(*bench.window);
    QVERIFY(!dock.shownText().contains(QLatin1String("No alerts")));
    bench.robot->say(map::AlertsMessage{});
    dock.refresh();
    QVERIFY(dock.shownText().contains(QLatin1String("No alerts")));
    map::AlertsMessage message;
    message.alerts = {{6004, map::AlertLevel::Warning, "Wheel slips", 0},
                      {1001, map::AlertLevel::Error, "<b>Lidar</b> is silent", 0}};
    bench.robot->say(message);
    dock.refresh();
    QVERIFY(dock.shownText().contains(QLatin1String("error 1001 <b>Lidar</b> is silent since ")));
    QVERIFY(!dock.shownText().contains(QLatin1String("No alerts")));
  }

  void sortsAlertsByTheirWeightAndSaysSinceWhen() {
    const QDateTime now = QDateTime(QDate(2026, 2, 3), QTime(12, 0), QTimeZone::utc()).toUTC();
    const double today =
        double(QDateTime(QDate(2026, 2, 3), QTime(9, 8, 7), QTimeZone::utc()).toSecsSinceEpoch());
    const auto made = alertLines({{7, map::AlertLevel::Warning, "w", today},
                                  {8, map::AlertLevel::Error, "e", today - 86'400},
                                  {9, map::AlertLevel::None, "n", 0}},
                                 now);
    QCOMPARE(made[0].code, QStringLiteral("8"));
    QCOMPARE(made[0].since, QStringLiteral("2026-02-02 09:08:07"));
    QCOMPARE(made[1].since, QStringLiteral("09:08:07"));
    QCOMPARE(made[1].mark, Mark::Warning);
    QVERIFY(made[2].since.isEmpty());
  }

  void leavesOutWhatIsUnknownAndSurvivesNonsense() {
    map::LiveState live;
    QVERIFY(statusSections(live).empty());
    live.battery = map::BatteryState{std::nan(""), std::nan(""), {}, {}};
    live.planning = map::PlanningState{};
    live.slam.position_quality = 5;
    live.map_info = map::MapInfo{std::string(5000, 'x'), {}, {}, {}, {}};
    const auto sections = statusSections(live);
    QCOMPARE(sections.size(), std::size_t(3));
    QCOMPARE(sections[0].fields[0].value, QStringLiteral("?"));
    QCOMPARE(sections[1].fields[0].value, QStringLiteral("quality 5"));
    QVERIFY(sections[2].fields[0].value.size() <= 200);
  }

  void aRobotOfTopicsIsToldByWhereItIsAndGoes() {
    map::LiveState live;
    QVERIFY(topicSections(live).empty());
    live.robot_pose = geometry::Pose2{1, 2, 0};
    live.planning = map::PlanningState{};
    live.planning->targets = {{4, 6, M_PI / 2}};
    live.path = {{1, 2}, {4, 2}, {4, 6}};
    QStringList lines;
    for (const StatusSection& section : topicSections(live)) {
      for (const StatusField& field : section.fields)
        lines << QStringLiteral("%1 / %2: %3").arg(section.title, field.name, field.value);
    }
    QCOMPARE(
        lines,
        (QStringList{QStringLiteral("Pose / Position: 1.00 m, 2.00 m"), QStringLiteral("Pose / Heading: 0°"),
                     QStringLiteral("Goal / Position: 4.00 m, 6.00 m"), QStringLiteral("Goal / Heading: 90°"),
                     QStringLiteral("Goal / Distance: 5.0 m"), QStringLiteral("Path / Length: 7.0 m")}));
  }

  void countsMessagesAndTheirRates() {
    TopicLog log;
    for (int i = 0; i < 50; ++i) log.record(raw("/a", QByteArray(100, 'x')), i * 100);
    QCOMPARE(log.find(QStringLiteral("/a"))->count, quint64(50));
    QCOMPARE(log.messagesPerSecond(QStringLiteral("/a"), 5'000), 9.8);  // the one at 0 is out of the span
    QCOMPARE(log.bytesPerSecond(QStringLiteral("/a"), 5'000), 980.0);
    QCOMPARE(log.messagesPerSecond(QStringLiteral("/a"), 20'000), 0.0);
    log.record(raw("/b", "x"), 100);
    QCOMPARE(log.messagesPerSecond(QStringLiteral("/b"), 101), 1.0);  // not a thousand a second
  }

  // Played at any speed they are those of the robot then, and stand still with the replay.
  void ratesOfARecordingAreReckonedByItsOwnTime() {
    TopicLog log;
    log.setRecorded(true);
    const QString topic = QStringLiteral("/a");
    const auto at = [](qint64 ms) {
      robot::RawMessage message = raw("/a", QByteArray(100, 'x'));
      message.received = QDateTime::fromMSecsSinceEpoch(ms);
      return message;
    };
    log.beginRatesAnew(1'000'000);
    for (int i = 0; i < 20; ++i) log.record(at(970'000), 970'000, TopicLog::Telling::Again);
    QCOMPARE(log.find(topic)->count, quint64(1));
    QVERIFY(!log.ratesKnown(topic, 1'000'000));
    for (int i = 1; i <= 20; ++i) log.record(at(1'000'000 + i * 100), 1'000'000 + i * 100);
    QCOMPARE(log.find(topic)->count, quint64(21));
    QCOMPARE(log.messagesPerSecond(topic, 1'002'000), 10.0);
    QVERIFY(log.ratesKnown(topic, 1'002'000));
    log.beginRatesAnew(500'000);  // a jump back
    log.record(at(499'950), 499'950, TopicLog::Telling::Again);
    QVERIFY(!log.ratesKnown(topic, 500'000));
    QCOMPARE(log.messagesPerSecond(topic, 500'000), 0.0);
  }

  void staysBoundedWhateverComes() {
    TopicLog log;
    for (int i = 0; i < 3'000; ++i) log.record(raw(qPrintable(QStringLiteral("/t%1").arg(i)), "x"), i);
    QCOMPARE(log.topics().size(), std::size_t(TopicLog::kMaxTopics));
    QCOMPARE(log.dropped(), quint64(2'500));
    log.record(raw("/t1", QByteArray(2'000'000, 'x')), 0);
    QVERIFY(log.find(QStringLiteral("/t1"))->cut);
    QCOMPARE(log.find(QStringLiteral("/t1"))->text.size(), TopicLog::kMaxText);
    log.clear();
    QVERIFY(log.topics().empty());
  }

  void laysOutJsonAsItWasSent() {
    QCOMPARE(prettyJson("{\"b\":1.50,\"a\":[1,2,3],\"c\":{\"d\":\"x, y\"}}"),
             QStringLiteral("{\n  \"b\": 1.50,\n  \"a\": [1,2,3],\n  \"c\": {\"d\":\"x, y\"}\n}"));
    QCOMPARE(prettyJson("no json <b>"), QStringLiteral("no json <b>"));
    QVERIFY(prettyJson("[[[[[[").size() < 200);
    QVERIFY(prettyJson("{\"a\":\"open").startsWith(QLatin1Char('{')));
    const QString cut = prettyJson("{\"data\":\"" + QByteArray(100'000, 'x') + "\",\"n\":nan}");
    QVERIFY(cut.contains(QLatin1String("(100,000 characters)")));
    QVERIFY(cut.contains(QLatin1String("nan")));
    const QString big = prettyJson("[" + QByteArray("{\"x\":[1]},").repeated(50'000) + "]", 10'000);
    QVERIFY(big.size() < 10'200);
    QVERIFY(big.contains(QLatin1String("truncated")));
  }

  void listensOnlyWhileItCanBeSeen() {
    Bench bench;
    openLive(bench);
    MessagesDock& dock = *part<MessagesDock>(*bench.window);
    QVERIFY(!bench.robot->watching);
    dock.show();
    QTRY_VERIFY(bench.robot->watching);
    bench.robot->sayRaw(QStringLiteral("/alerts"), "{\"topic\":\"/alerts\"}");
    dock.refresh();
    QCOMPARE(dock.rows()->rowCount(), 1);
    QTest::mouseClick(dock.pauseButton(), Qt::LeftButton);
    QVERIFY(!bench.robot->watching);
    bench.robot->sayRaw(QStringLiteral("/other"), "{}");
    dock.refresh();
    QCOMPARE(dock.rows()->rowCount(), 1);
    QTest::mouseClick(dock.pauseButton(), Qt::LeftButton);
    QVERIFY(bench.robot->watching);
    dock.close();
    QTRY_VERIFY(!bench.robot->watching);
  }

  void showsTheLastMessageOfTheChosenTopicAsPlainText() {
    Bench bench;
    openLive(bench);
    MessagesDock& dock = *part<MessagesDock>(*bench.window);
    dock.show();
    QTRY_VERIFY(bench.robot->watching);
    bench.robot->sayRaw(QStringLiteral("/alerts"), "{\"text\":\"<b>1</b>\"}");
    bench.robot->sayRaw(QStringLiteral("/map"), "00 01 02", true);
    dock.refresh();
    dock.chooseTopic(QStringLiteral("/alerts"));
    QVERIFY(dock.messageView()->toPlainText().contains(QLatin1String("<b>1</b>")));
    dock.filterEdit()->setText(QStringLiteral("MAP"));
    QCOMPARE(dock.rows()->rowCount(), 1);
    QCOMPARE(dock.rows()->index(0, TopicsModel::TypeColumn).data().toString(), QStringLiteral("binary"));
    dock.filterEdit()->clear();
    QCOMPARE(dock.rows()->rowCount(), 2);
    dock.chooseTopic(QStringLiteral("/alerts"));
    QTest::mouseClick(dock.copyButton(), Qt::LeftButton);
    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("{\"text\":\"<b>1</b>\"}"));
    QTest::mouseClick(dock.clearButton(), Qt::LeftButton);
    QCOMPARE(dock.rows()->rowCount(), 0);
    QVERIFY(dock.messageView()->toPlainText().isEmpty());
  }

  void asksForAnyTopicAndLetsGoOfItWhenClosed() {
    Bench bench;
    openLive(bench);
    MessagesDock& dock = *part<MessagesDock>(*bench.window);
    dock.show();
    QTRY_VERIFY(bench.robot->watching);
    QTest::keyClicks(dock.topicEdit(), QStringLiteral("my_topic"));
    QTest::keyClick(dock.topicEdit(), Qt::Key_Return);
    QVERIFY(bench.robot->wanted.contains(QStringLiteral("/my_topic")));
    QVERIFY(dock.topicEdit()->text().isEmpty());
    QCOMPARE(dock.rows()->rowCount(), 1);
    QCOMPARE(dock.rows()->index(0, TopicsModel::TypeColumn).data().toString(), QStringLiteral("waiting"));
    dock.close();
    QVERIFY(!bench.robot->wanted.contains(QStringLiteral("/my_topic")));
  }
};

}  // namespace test_window_robot

MAPWRIGHT_TEST(test_window_robot, TestWindowRobot, Widgets)
#include "test_window_robot.moc"
