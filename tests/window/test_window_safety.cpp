// Dangers in the window: at once, everywhere, in colour, shape and words; and which map the robot is in.
#include <QPushButton>
#include <QTimeZone>
#include <QtTest>

#include "ink.h"
#include "test_program.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/safety_badge.h"
#include "ui/layers/layers_controller.h"
#include "ui/maps/maps_controller.h"
#include "ui/maps/maps_dock.h"
#include "ui/robot/connection_chip.h"
#include "ui/robot/problems_dock.h"
#include "ui/robot/robot_dock.h"
#include "ui/shell/window_status_bar.h"
#include "ui/slam/inspector_dock.h"
#include "ui/view/map_overlay.h"
#include "ui/view/notice_bar.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_safety {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;
using test::kAddress;

namespace {

const QDateTime kNow = QDateTime(QDate(2026, 2, 3), QTime(14, 5), QTimeZone::utc()).toUTC();

double at(int hour, int minute, int second, int days_ago = 0) {
  return double(QDateTime(kNow.date().addDays(-days_ago), QTime(hour, minute, second), QTimeZone::utc())
                    .toUTC()
                    .toSecsSinceEpoch());
}

map::SafetyCondition condition(map::SafetyKind kind, map::Severity severity, double since_s) {
  map::SafetyCondition made;
  made.kind = kind;
  made.severity = severity;
  made.since_s = since_s;
  return made;
}

map::SafetyCondition alert(int code, const std::string& text, double since_s) {
  map::SafetyCondition made = condition(map::SafetyKind::Alert, map::Severity::Error, since_s);
  made.code = code;
  made.text = text;
  return made;
}

map::WheelState stop(bool pressed) {
  map::WheelState wheels;
  wheels.control_mode = "auto";
  wheels.emergency_stop = pressed;
  return wheels;
}

map::AlertsMessage alerts(std::vector<std::pair<int, std::string>> errors) {
  map::AlertsMessage message;
  for (auto& [code, text] : errors) message.alerts.push_back({code, map::AlertLevel::Error, text, 0});
  return message;
}

constexpr FaultCode kNoPlace{"test", "Its position is unknown."};

/// Pixels of about the colour of errors.
int red(QWidget* widget) {
  const QImage image = widget->grab().toImage();
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor pixel = image.pixelColor(x, y);
      count += pixel.red() > pixel.green() + 60 && pixel.red() > pixel.blue() + 60;
    }
  }
  return count;
}

map::MapKey stored(const char* id) { return {map::MapKind::Stored, id}; }

}  // namespace

class TestWindowSafety : public QObject {
  Q_OBJECT

  static MainWindow& openLive(Bench& bench) {
    bench.prepare = [](test::FakeRobot& robot) {
      robot.has_live = robot.has_catalogue = true;
      robot.maps.entries = {test::catalogued("1", "Ground floor"), test::catalogued("2", "<b>Attic</b>")};
      robot.maps.entries[0].is_current = true;
    };
    MainWindow& window = bench.open();
    [&] { QVERIFY(!window.connectTo(kAddress)); }();
    return window;
  }

 private Q_SLOTS:
  void theGravestIsNamedAndTheOthersAreCounted() {
    using map::SafetyKind;
    const SafetyText text =
        safetyText({{condition(SafetyKind::EmergencyStop, map::Severity::Error, at(14, 3, 12)),
                     alert(6004, "Kernel temperature is high.", at(9, 8, 7, 1)),
                     condition(SafetyKind::ManualControl, map::Severity::Warning, at(14, 0, 0))},
                    {}},
                   kNow);
    QCOMPARE(text.mark, Mark::Bad);
    QVERIFY(!text.greyed);
    QCOMPARE(text.badge, QStringLiteral("Emergency stop +2"));
    QCOMPARE(text.sentence,
             QStringLiteral("Emergency stop pressed since 14:03:12. Also: Error 6004, Manual control"));
    QCOMPARE(text.detail, QStringLiteral("Emergency stop pressed since 14:03:12\n"
                                         "Error 6004 since 2026-02-02 09:08:07: Kernel temperature is high.\n"
                                         "Under manual control since 14:00:00"));
  }

  void oneSentenceEndsOnceBeforeTheNext() {
    const auto said = [](const char* words) {
      return safetyText({{alert(6004, words, at(14, 3, 12)),
                          condition(map::SafetyKind::ManualControl, map::Severity::Warning, at(14, 0, 0))},
                         {}},
                        kNow)
          .sentence;
    };
    for (const char* words : {"Too hot!", "Too hot.", "Too hot"})
      QVERIFY2(said(words).endsWith(QLatin1String(words[7] == '!' ? "Too hot! Also: Manual control"
                                                                  : "Too hot. Also: Manual control")),
               qPrintable(said(words)));
  }

  void nothingIsSaidWhenNothingIsWrong() {
    QCOMPARE(safetyText({}, kNow), SafetyText{});
    QCOMPARE(safetyText({{}, kNow}, kNow), SafetyText{});  // nor while the link is lost
  }

  void aWarningIsABadgeButNoNotice() {
    const SafetyText text = safetyText(
        {{condition(map::SafetyKind::WheelsReleased, map::Severity::Warning, at(14, 0, 0))}, {}}, kNow);
    QCOMPARE(text.mark, Mark::Warning);
    QCOMPARE(text.badge, QStringLiteral("Wheels released"));
    QVERIFY(text.sentence.isEmpty());
  }

  void whatIsNoLongerLiveSaysAsOfWhen() {
    const SafetyText text = safetyText(
        {{condition(map::SafetyKind::EmergencyStop, map::Severity::Error, at(14, 3, 12))}, kNow.addSecs(-30)},
        kNow);
    QVERIFY(text.greyed);
    QCOMPARE(text.sentence, QStringLiteral("As of 14:04:30: Emergency stop pressed since 14:03:12"));
    QVERIFY(text.detail.startsWith(QLatin1String("As of 14:04:30")));
  }

  void whatIsOnAndOffIsCalledSo() {
    auto flapping = condition(map::SafetyKind::EmergencyStop, map::Severity::Error, at(14, 3, 12));
    flapping.times = 7;
    QCOMPARE(safetySentence(flapping, kNow),
             QStringLiteral("Emergency stop pressed since 14:03:12, on and off, 7 times"));
  }

  void theWordsOfARobotAreOnePlainLine() {
    const std::string hostile =
        "<b>Hot</b>\n\x1b[31m\xe2\x80\xae"
        "redrum" +
        std::string(1'000'000, 'x');
    const SafetyText text = safetyText({{alert(6004, hostile, at(14, 3, 12))}, {}}, kNow);
    QVERIFY(text.sentence.startsWith(QLatin1String("Error 6004 since 14:03:12: <b>Hot</b> [31mredrumxxx")));
    QVERIFY(text.sentence.size() < 300);
    QVERIFY(!text.sentence.contains(QChar(0x202e)));
    QVERIFY(!text.sentence.contains(QChar(0x1b)));
    QCOMPARE(safetyText({{alert(0, "\xff\xfe", 0)}, {}}, kNow).badge, QStringLiteral("Error"));
  }

  void aPressedEmergencyStopIsSeenAtOnceAndGoneWhenItIsGone() {
    Bench bench;
    MainWindow& window = openLive(bench);
    part<RobotDock>(window)->close();  // no panel is needed for it
    QVERIFY(!part<MapOverlay>(window)->safetyNotice()->isVisible());
    const int red_before = red(part<ConnectionChip>(window));
    bench.robot->say(stop(true));
    QCOMPARE(part<ConnectionChip>(window)->safety().badge, QStringLiteral("Emergency stop"));
    QTRY_VERIFY(red(part<ConnectionChip>(window)) > red_before + 50);
    QVERIFY(part<ConnectionChip>(window)->accessibleName().contains(QLatin1String("Emergency stop")));
    QVERIFY(part<MapOverlay>(window)->safetyNotice()->isVisible());
    QVERIFY(part<MapOverlay>(window)->safetyNotice()->sentence().startsWith(
        QLatin1String("Emergency stop pressed since ")));
    QVERIFY(red(part<MapOverlay>(window)->safetyNotice()) > 50);
    QTest::mouseClick(part<MapOverlay>(window)->safetyNotice()->offerButton(), Qt::LeftButton);
    QVERIFY(part<RobotDock>(window)->isVisible());
    bench.robot->say(stop(false));
    QVERIFY(part<ConnectionChip>(window)->safety().badge.isEmpty());
    QVERIFY(!part<MapOverlay>(window)->safetyNotice()->isVisible());
    QTRY_COMPARE(red(part<ConnectionChip>(window)), red_before);
  }

  void itIsKeptInTheListOfProblems() {
    Bench bench;
    MainWindow& window = openLive(bench);
    bench.robot->say(stop(true));
    const auto row = [&]() -> const session::LoggedProblem* {
      for (const auto& each : window.session()->problems().rows()) {
        if (each.problem.subject.id == "emergency-stop") return &each;
      }
      return nullptr;
    };
    QVERIFY(row() && !row()->resolved);
    QTRY_VERIFY(part<WindowStatusBar>(window)->problemsButton()->isVisible());
    QVERIFY(part<ProblemsDock>(window)->visibleRegion().isEmpty());  // the notice has said it
    bench.robot->say(stop(false));
    QVERIFY(row() && row()->resolved);
    bench.robot->say(stop(true));
    QVERIFY(row() && !row()->resolved && row()->count == 2);
  }

  void whatWasKnownStaysGreyWhileTheLinkIsLost() {
    Bench bench;
    MainWindow& window = openLive(bench);
    bench.load();
    bench.robot->say(stop(true));
    map::SlamStatus slam;
    slam.state = "positioning";
    slam.reliable = true;
    bench.robot->say(slam);
    auto* const state = part<InspectorDock>(window)->findChild<PlainLabel*>(QStringLiteral("state"));
    QCOMPARE(state->text(), QStringLiteral("positioning, reliable"));  // as soon as the robot says so
    bench.robot->goAway(QStringLiteral("connection refused"));
    QVERIFY(part<ConnectionChip>(window)->safety().greyed);
    QCOMPARE(red(part<MapOverlay>(window)->safetyNotice()), 0);
    QVERIFY(part<MapOverlay>(window)->safetyNotice()->sentence().startsWith(QLatin1String("As of ")));
    QVERIFY(part<MapOverlay>(window)->notice()->isVisible());  // and that the link is lost
    QVERIFY(part<MapOverlay>(window)->notice()->y() >= part<MapOverlay>(window)->safetyNotice()->height());
    QVERIFY(state->secondary());
    QVERIFY(state->text().startsWith(QLatin1String("positioning, reliable (as of ")));
    bench.robot->goOnline();
    QVERIFY(!part<ConnectionChip>(window)->safety().greyed);
    QVERIFY(!state->secondary());
    QCOMPARE(state->text(), QStringLiteral("positioning, reliable"));
  }

  void anotherRobotHasNoneOfIt() {
    Bench bench;
    MainWindow& window = openLive(bench);
    bench.robot->say(stop(true));
    window.leaveRobot();
    QVERIFY(part<ConnectionChip>(window)->safety().badge.isEmpty());
    QVERIFY(!part<MapOverlay>(window)->safetyNotice()->isVisible());
  }

  void itFitsASmallWindowWhateverIsSaid() {
    Bench bench;
    MainWindow& window = openLive(bench);
    bench.robot->identify({{}, {}, QString(300, QLatin1Char('w')), {}});
    std::vector<std::pair<int, std::string>> many;
    for (int i = 0; i < 500; ++i) many.emplace_back(2'000'000'000 + i, std::string(5000, 'm'));
    bench.robot->say(alerts(many));
    bench.robot->say(stop(true));
    QCOMPARE(part<ConnectionChip>(window)->safety().badge, QStringLiteral("Emergency stop +500"));
    QCoreApplication::processEvents();
    QCOMPARE(window.width(), 1366);
    QVERIFY2(window.minimumSizeHint().width() <= 1366,
             qPrintable(QString::number(window.minimumSizeHint().width())));
    QCOMPARE(part<MapOverlay>(window)->safetyNotice()->width(), window.view()->width());
  }

  void whatIsNotInItsPlaceIsSaidAboveTheMap() {
    Bench bench;
    MainWindow& window = openLive(bench);
    NoticeBar* const strip = part<MapOverlay>(window)->placeNotice();
    const map::Subject topic(map::SubjectKind::Topic, "/scan");
    Q_EMIT bench.robot->problemFound({map::Severity::Warning, topic, kNoPlace, map::ProblemCode::Unplaced});
    QTRY_VERIFY(strip->isVisible());
    QVERIFY(strip->sentence().contains(QLatin1String("/scan")));
    Q_EMIT bench.robot->recovered({topic, map::ProblemCode::Unplaced});
    QTRY_VERIFY(!strip->isVisible());
    // Where no robot is drawn, what is odd may be the reason.
    Q_EMIT bench.robot->problemFound({map::Severity::Warning, topic, kNoPlace, map::ProblemCode::Odd});
    QTRY_VERIFY(strip->isVisible());
    bench.robot->say(map::TrackedPose{{1, 2, 0}});
    QTRY_VERIFY(!strip->sentence().contains(QLatin1String("/scan")));
  }

  void theRobotIsHiddenInAMapThatItIsNotIn() {
    Bench bench;
    MainWindow& window = openLive(bench);
    QTRY_COMPARE(part<MapsDock>(window)->model()->maps(), 2);
    bench.robot->say(map::TrackedPose{{1, 1, 0}});
    NoticeBar& notice = *part<MapOverlay>(window)->placeNotice();
    part<MapsController>(window)->open(stored("2"));
    QTRY_VERIFY(window.session()->wholeMap().phase() == session::MapSlot::Phase::Ready);
    QTRY_VERIFY(notice.isVisible());
    QCOMPARE(notice.sentence(),
             QStringLiteral(
                 "The robot is in Ground floor, not in this map. The robot and its sensor data are hidden."));
    QVERIFY(window.mapScene()->robotPlace().drawn == ui::scene::ScreenPart::None);
    QTest::mouseClick(notice.offerButton(), Qt::LeftButton);
    QVERIFY(window.mapScene()->robotPlace().drawn == ui::scene::ScreenPart::All);
    // It says so as long as it is drawn wrongly.
    QCOMPARE(notice.sentence(),
             QStringLiteral("The robot is in Ground floor, not in this map. It is shown anyway."));
    QCOMPARE(notice.mark(), Mark::Warning);
    QTest::mouseClick(notice.offerButton(), Qt::LeftButton);
    QVERIFY(window.mapScene()->robotPlace().drawn == ui::scene::ScreenPart::None);
    part<MapsController>(window)->open(stored("1"));
    QTRY_VERIFY(!notice.isVisible());
    QVERIFY(window.mapScene()->robotPlace().drawn == ui::scene::ScreenPart::All);
  }

  void thereIsNothingToFollowWhereTheRobotIsHidden() {
    Bench bench;
    MainWindow& window = openLive(bench);
    QTRY_COMPARE(part<MapsDock>(window)->model()->maps(), 2);
    part<MapsController>(window)->open(stored("2"));
    QTRY_VERIFY(window.mapScene()->robotPlace().drawn == ui::scene::ScreenPart::None);
    const Eigen::Vector2d before = window.mapScene()->view().center_m;
    bench.robot->say(map::TrackedPose{{500, 500, 0}});
    bench.action("follow")->trigger();
    bench.robot->say(map::TrackedPose{{501, 500, 0}});
    QCOMPARE(window.mapScene()->view().center_m.x(), before.x());
  }

  void aRobotThatDoesNotSayWhereItIsCanBeHidden() {
    Bench bench;
    MainWindow& window = openLive(bench);
    for (auto& entry : bench.robot->maps.entries) entry.is_current = false;
    window.session()->catalogue().refresh();
    QTRY_VERIFY(!window.session()->catalogue().current());
    bench.robot->say(map::TrackedPose{{1, 1, 0}});
    part<MapsController>(window)->open(stored("2"));
    NoticeBar& notice = *part<MapOverlay>(window)->placeNotice();
    QTRY_VERIFY(notice.isVisible());
    QVERIFY(notice.sentence().startsWith(QLatin1String("The robot does not report which map it is in.")));
    QVERIFY(window.mapScene()->robotPlace().drawn == ui::scene::ScreenPart::All);
    QVERIFY(notice.closeButton()->isVisible());
    QTest::mouseClick(notice.offerButton(), Qt::LeftButton);
    QVERIFY(window.mapScene()->robotPlace().drawn == ui::scene::ScreenPart::None);
    QTest::mouseClick(notice.offerButton(), Qt::LeftButton);
    QTest::mouseClick(notice.closeButton(), Qt::LeftButton);
    QVERIFY(!notice.isVisible());
  }

  void theMapOnScreenHasItsNameInTitleAndStatusBar() {
    Bench bench;
    MainWindow& window = openLive(bench);
    bench.robot->identify({{}, {}, QStringLiteral("dock-3"), {}});
    QTRY_COMPARE(window.windowTitle(), QStringLiteral("Submaps of Ground floor – dock-3 – mapwright"));
    bench.load();
    QTRY_COMPARE(part<WindowStatusBar>(window)->loadingShown(), QStringLiteral("3 of 3 submaps"));
    QCOMPARE(part<WindowStatusBar>(window)->mapShown(), QStringLiteral("Ground floor"));
    part<MapsController>(window)->open(stored("2"));
    QTRY_COMPARE(window.windowTitle(), QStringLiteral("Map 2 – dock-3 – mapwright"));
    bench.robot->identify({{}, {}, QStringLiteral("Map 2"), {}});
    QTRY_COMPARE(window.windowTitle(), QStringLiteral("Map 2 – mapwright"));
    QTRY_COMPARE(part<WindowStatusBar>(window)->mapShown(), QStringLiteral("Map 2, 80 x 60 cells"));
    QVERIFY(part<WindowStatusBar>(window)->loadingShown().isEmpty());  // no submap is on screen
    part<LayersController>(window)->setMode(ViewMode::Both);
    QVERIFY(part<WindowStatusBar>(window)
                ->loadingShown()
                .isEmpty());  // the robot, and its submaps, are elsewhere
    part<MapsController>(window)->open(stored("1"));
    QTRY_COMPARE(part<WindowStatusBar>(window)->loadingShown(), QStringLiteral("3 of 3 submaps"));
    QTRY_COMPARE(part<WindowStatusBar>(window)->mapShown(), QStringLiteral("Map 1, 80 x 60 cells"));
    window.leaveRobot();
    QCOMPARE(window.windowTitle(), QStringLiteral("mapwright"));
    QVERIFY(part<WindowStatusBar>(window)->mapShown().isEmpty());
  }
};

}  // namespace test_window_safety

MAPWRIGHT_TEST(test_window_safety, TestWindowSafety, Widgets)
#include "test_window_safety.moc"
