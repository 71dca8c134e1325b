// That what is said is also painted, the very first time: notices, cards, toasts, chips, badges.
#include <QLabel>
#include <QPushButton>
#include <QtTest>

#include "ink.h"
#include "test_program.h"
#include "ui/kit/plain_label.h"
#include "ui/robot/connection_chip.h"
#include "ui/shell/window_status_bar.h"
#include "ui/view/empty_state.h"
#include "ui/view/map_overlay.h"
#include "ui/view/notice_bar.h"
#include "ui/view/toast_stack.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_ink {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;
using test::ink;
using test::kAddress;

namespace {

constexpr double kSomeInk = 0.02;

/// The words of a label are on screen: where it lies in its window there is ink.
void verifyPainted(QWidget* label) {
  QVERIFY(label->isVisible());
  QVERIFY2(label->width() > 100, qPrintable(QString::number(label->width())));
  QWidget* const window = label->window();
  const QRect area(label->mapTo(window, QPoint()), label->size());
  QVERIFY2(ink(window, area) > kSomeInk, qPrintable(QString::number(ink(window, area))));
}

}  // namespace

class TestWindowInk : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theFirstNoticeOfALostConnection() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    bench.robot->goAway(QStringLiteral("connection refused"));
    verifyPainted(part<MapOverlay>(window)->notice()->findChild<PlainLabel*>());
  }

  void theFirstNoticeOfAllKinds_data() {
    QTest::addColumn<int>("which");
    QTest::addColumn<QString>("offer");
    QTest::addColumn<bool>("closable");
    for (int which = 0; which < 3; ++which) {
      QTest::addRow("plain %d", which) << which << QString() << false;
      QTest::addRow("with offer %d", which) << which << QStringLiteral("Retry now") << false;
      QTest::addRow("closable %d", which) << which << QString() << true;
    }
  }
  void theFirstNoticeOfAllKinds() {
    QFETCH(int, which);
    QFETCH(QString, offer);
    QFETCH(bool, closable);
    Bench bench;
    MainWindow& window = bench.open();
    MapOverlay& overlay = *part<MapOverlay>(window);
    NoticeBar* const notice = which == 0   ? overlay.notice()
                              : which == 1 ? overlay.safetyNotice()
                                           : overlay.placeNotice();
    notice->setNotice(Mark::Warning, QStringLiteral("Something lasts until it is over, and is said here."),
                      offer, closable);
    verifyPainted(notice->findChild<PlainLabel*>());
    QVERIFY(test::Ink(notice->findChild<PlainLabel*>()).reach() > 200);
  }

  void aLongNoticeTakesASecondLineAndAShortOneGivesItBack() {
    Bench bench;
    MainWindow& window = bench.open();
    window.resize(1000, 700);
    NoticeBar* const notice = part<MapOverlay>(window)->notice();
    notice->setNotice(Mark::Warning, QStringLiteral("Short."), QStringLiteral("Retry now"));
    QTRY_VERIFY(notice->height() > 0);
    const int one_line = notice->height();
    const QString words = QStringLiteral("So much is to be said here that one line has no room for it: ");
    notice->setNotice(Mark::Warning, words + words, QStringLiteral("Retry now"));
    QTRY_VERIFY(notice->height() > one_line);
    const int two_lines = notice->height();
    const PlainLabel* const label = notice->findChild<PlainLabel*>();
    verifyPainted(notice->findChild<PlainLabel*>());
    QVERIFY(label->height() >= label->heightForWidth(label->width()));
    // No more than two, whatever is said.
    notice->setNotice(Mark::Warning, words + words + words + words, QStringLiteral("Retry now"));
    QTRY_COMPARE(notice->height(), two_lines);
    notice->setNotice(Mark::Warning, QStringLiteral("Short."), QStringLiteral("Retry now"));
    QTRY_COMPARE(notice->height(), one_line);
  }

  void aNoticeFromBeforeTheWindowIsShown() {
    Bench bench;
    bench.settings.sync();
    MainWindow::Dependencies wanted{
        [](const QString&, const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          return tl::unexpected(QStringLiteral("This is no address of a robot."));
        },
        bench.settings, QStringLiteral("nonsense")};
    MainWindow window(std::move(wanted));
    window.resize(1366, 768);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    verifyPainted(part<MapOverlay>(window)->notice()->findChild<PlainLabel*>());
  }

  void theLimitsOfARobotAndTheRemarksOfAMap() {
    Bench bench;
    bench.prepare = [](test::FakeRobot& robot) {
      robot.has_submaps = false;
      robot.has_catalogue = true;
      robot.maps.entries = {test::catalogued("1", "Ground floor")};
      robot.read_only_maker = QStringLiteral("Maker");
    };
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QTRY_VERIFY(window.session()->wholeMap().phase() == session::MapSlot::Phase::Ready);
    verifyPainted(part<MapOverlay>(window)->notice()->findChild<PlainLabel*>());
  }

  void theCardOfEveryState() {
    Bench bench;
    MainWindow& window = bench.open();
    const auto verify = [&] {
      for (QLabel* label : part<MapOverlay>(window)->card()->findChildren<QLabel*>()) {
        if (!label->isVisible() || label->text().isEmpty()) continue;
        const QRect area(label->mapTo(&window, QPoint()), label->size());
        QVERIFY2(ink(&window, area) > kSomeInk, qPrintable(label->text()));
      }
    };
    verify();
    bench.prepare = [](test::FakeRobot& robot) { robot.auto_online = false; };
    QVERIFY(!window.connectTo(kAddress));
    robot::ConnectionState connecting;
    connecting.phase = robot::ConnectionPhase::Connecting;
    bench.robot->setState(connecting);
    verify();
    bench.robot->goAway(QStringLiteral("connection refused"));
    verify();
  }

  void aToastShowsAllOfWhatItSays() {
    Bench bench;
    MainWindow& window = bench.open();
    ToastStack& toasts = *part<MapOverlay>(window)->toasts();
    const QString wide = QStringLiteral("Exported 12,115 messages to /home/me/2024-06-03_08-50-00.mcap");
    const QString word =
        QStringLiteral("/home/me/") + QString(200, QLatin1Char('w')) + QStringLiteral(".mcap");
    for (const QString& text : {wide, word}) {
      toasts.add(Mark::Good, text);
      QCOMPARE(toasts.texts().back(), text);
      const auto* const label = toasts.findChildren<QLabel*>(QStringLiteral("toastText")).back();
      QTRY_VERIFY(label->isVisible() && label->width() > 100);
      const QFontMetrics metrics = label->fontMetrics();
      // Nothing is cut off at the right: it goes on in the next line.
      const QRect needed = metrics.boundingRect(QRect(0, 0, label->width(), 10'000),
                                                Qt::TextWordWrap | Qt::AlignLeft, label->text());
      QVERIFY2(needed.width() <= label->width() + 1, qPrintable(QString::number(needed.width())));
      QVERIFY(label->height() >= needed.height());
    }
  }

  void whatIsSaidAgainIsCounted() {
    Bench bench;
    ToastStack& toasts = *part<MapOverlay>(bench.open())->toasts();
    const QString same = QStringLiteral("Not saved yet");
    for (int i = 0; i < 3; ++i) toasts.add(Mark::Warning, same);
    QCOMPARE(toasts.texts(), QStringList{QStringLiteral("Not saved yet (3 times)")});
    toasts.add(Mark::Good, same);  // good news is another thing
    toasts.add(Mark::Warning, same);
    QCOMPARE(toasts.texts(), (QStringList{same, QStringLiteral("Not saved yet (4 times)")}));
    // What one offers is not lost.
    int taken = 0;
    for (int i = 0; i < 2; ++i)
      toasts.add(Mark::Good, QStringLiteral("Written"),
                 {QStringLiteral("Show"), [&taken, i] { taken = i + 1; }});
    QCOMPARE(toasts.texts().last(), QStringLiteral("Written (2 times)"));
    toasts.findChildren<QPushButton*>().back()->click();
    QCOMPARE(taken, 2);
    QCOMPARE(toasts.texts().size(), qsizetype(2));
  }

  void theFirstToast() {
    Bench bench;
    MainWindow& window = bench.open();
    part<MapOverlay>(window)->toasts()->add(Mark::Good, QStringLiteral("Copied 1.000, 2.000"));
    auto* const text = part<MapOverlay>(window)->toasts()->findChild<QLabel*>(QStringLiteral("toastText"));
    verifyPainted(text);
  }

  void theChipAndTheStripAboveTheMap() {
    Bench bench;
    bench.prepare = [](test::FakeRobot& robot) { robot.has_live = true; };
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    const QSize before = part<ConnectionChip>(window)->size();
    map::WheelState wheels;
    wheels.emergency_stop = true;
    bench.robot->say(wheels);
    QTRY_VERIFY(part<ConnectionChip>(window)->safety().mark == Mark::Bad);
    QCOMPARE(part<ConnectionChip>(window)->size(), before);  // the tools beside it stay where they are
    QVERIFY(ink(part<ConnectionChip>(window)) > kSomeInk);
    verifyPainted(part<MapOverlay>(window)->safetyNotice()->findChild<PlainLabel*>());
  }
};

}  // namespace test_window_ink

MAPWRIGHT_TEST(test_window_ink, TestWindowInk, Widgets)
#include "test_window_ink.moc"
