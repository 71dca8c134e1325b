// What the program takes of the computer: shown, copied, and chosen for the next start.
#include <future>

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include "test_program.h"
#include "ui/kit/plain_label.h"
#include "ui/window/diagnostics_dialog.h"
#include "ui/window/work_settings.h"
#include "window_bench.h"

namespace test_window_diagnostics {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;

class WindowDiagnosticsTest : public QObject {
  Q_OBJECT
 private:
  static DiagnosticsDialog* openDialog(Bench& bench) {
    bench.action("diagnostics")->trigger();
    auto* const dialog = bench.window->findChild<DiagnosticsDialog*>();
    (void)QTest::qWaitForWindowActive(dialog);
    return dialog;
  }
  static QStringList shownIn(const DiagnosticsDialog& dialog) {
    QStringList texts;
    for (const PlainLabel* label : dialog.findChildren<PlainLabel*>()) texts << label->text();
    return texts;
  }

 private Q_SLOTS:
  void tellsWhatIsHeldOfWhatIsAllowed() {
    Bench bench;
    bench.budgets = work::budgetsFrom(std::size_t(240) << 20);
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(test::kAddress));
    bench.load();
    DiagnosticsDialog* const dialog = openDialog(bench);
    QVERIFY(dialog && dialog->isVisible());
    const work::Budgets held = window.session()->memory() + window.mapScene()->memory();
    QVERIFY(held.textures > 0);
    const QStringList lines = dialog->text().split(QLatin1Char('\n'));
    QVERIFY(lines.contains(QStringLiteral("Cells of submaps\t%1\t80.0")
                               .arg(double(held.textures) / double(1 << 20), 0, 'f', 1)));
    QVERIFY(lines.last().startsWith(QLatin1String("All\t")) &&
            lines.last().endsWith(QLatin1String("\t240.0")));
  }

  void followsWhatGoesOn() {
    Bench bench;
    bench.workers = std::make_shared<work::Workers>(3);
    bench.open();
    DiagnosticsDialog* const dialog = openDialog(bench);
    const auto crew = [&] { return shownIn(*dialog).mid(5, 3); };
    QCOMPARE(crew(), QStringList({QStringLiteral("3"), QStringLiteral("0"), QStringLiteral("0")}));
    std::promise<void> gate;
    work::Tasks other(bench.workers);
    other.startLong([opened = gate.get_future().share()] { opened.wait(); });
    QTRY_COMPARE(crew(), QStringList({QStringLiteral("3"), QStringLiteral("1"), QStringLiteral("0")}));
    gate.set_value();
    QVERIFY(other.waitForDone());
    QTRY_COMPARE(crew(), QStringList({QStringLiteral("3"), QStringLiteral("0"), QStringLiteral("0")}));
  }

  void isCopiedWithoutAddressesAndSecrets() {
    Bench bench;
    bench.workers = std::make_shared<work::Workers>(3);
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(test::kAddress, "hush-hush"));
    DiagnosticsDialog* const dialog = openDialog(bench);
    QTest::mouseClick(dialog->copyButton(), Qt::LeftButton);
    const QString copied = QGuiApplication::clipboard()->text();
    QVERIFY(copied.contains(QLatin1String("\nBackground work\tThreads\tBusy\tWaiting\nJobs\t3\t0\t0\n")));
    QVERIFY2(copied.contains(QLatin1String("\nOpen: axbot+http://robot-1, ")), qPrintable(copied));
    QVERIFY(!copied.contains(QLatin1String("192.0.2.7")) && !copied.contains(QLatin1String("hush")));
    QGuiApplication::clipboard()->clear();
    bench.action("copyDiagnostics")->trigger();
    QVERIFY(QGuiApplication::clipboard()->text().contains(QLatin1String("axbot+http://robot-1")));
    QVERIFY(dialog->copyButton()->toolTip().contains(QLatin1String("addresses")));
  }

  void howLongTheWindowWasBusyStandsThere() {
    Bench bench;
    Diagnostics now;
    DiagnosticsDialog dialog([&] { return now; }, bench.settings);
    QVERIFY(!dialog.text().contains(QLatin1String("busy")));
    now.stalls.emplace();
    now.stalls->add(std::chrono::milliseconds(20), {"MapView", QEvent::Timer});
    now.stalls->add(std::chrono::milliseconds(700), {"MapView", QEvent::Timer});
    QVERIFY2(dialog.text().contains(QLatin1String("\nless than 16 ms\t0\nless than 33 ms\t1\n")),
             qPrintable(dialog.text()));
    QVERIFY(
        dialog.text().contains(QLatin1String("\n500 ms and longer\t1\nLongest, ms (Timer, MapView)\t700.0")));
  }

  void howMessagesArriveStandsThere() {
    Bench bench;
    Diagnostics now;
    DiagnosticsDialog dialog([&] { return now; }, bench.settings);
    dialog.show();
    QVERIFY(!dialog.text().contains(QLatin1String("Came")));
    now.reception = robot::Reception{1'234, 5, 6, {{QStringLiteral("map"), QStringLiteral("odom"), 12.34}}};
    QVERIFY(dialog.text().contains(QLatin1String("\nCame\t1,234\nDropped for newer ones\t5\n")));
    QVERIFY(dialog.text().contains(QLatin1String("odom in map\t12.3")));
    QTRY_VERIFY(shownIn(dialog).contains(QStringLiteral("12.3")));
    now.reception->transforms.front().age_s = 0.5;
    QTRY_VERIFY(shownIn(dialog).contains(QStringLiteral("0.5")));
    now.reception.reset();
    QTRY_VERIFY(!shownIn(dialog).contains(QStringLiteral("1,234")));
  }

  void transformsThatAreLeftOutAreCounted() {
    Bench bench;
    Diagnostics now;
    DiagnosticsDialog dialog([&] { return now; }, bench.settings);
    now.reception.emplace();
    for (int i = 0; i < 8; ++i)
      now.reception->transforms.push_back({QStringLiteral("map"), QStringLiteral("f%1").arg(i), 1});
    QVERIFY(!dialog.text().contains(QLatin1String("not listed")));
    for (int i = 8; i < 11; ++i)
      now.reception->transforms.push_back({QStringLiteral("map"), QStringLiteral("f%1").arg(i), 1});
    QVERIFY2(dialog.text().endsWith(QLatin1String("f7 in map\t1.0\n3 more are not listed.\t")),
             qPrintable(dialog.text()));
  }

  void openedAgainItIsTheSameOne() {
    Bench bench;
    bench.open();
    DiagnosticsDialog* const dialog = openDialog(bench);
    QCOMPARE(openDialog(bench), dialog);
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY(!bench.window->findChild<DiagnosticsDialog*>());
    QVERIFY(openDialog(bench)->isVisible());
  }

  void whatIsChosenIsKeptForTheNextStart() {
    Bench bench;
    bench.open();
    DiagnosticsDialog* dialog = openDialog(bench);
    QVERIFY(workSettingsIn(bench.settings).settings == WorkSettings{});
    const auto type = [](QSpinBox* box, const QString& text) {
      box->setFocus();
      box->selectAll();
      QTest::keyClicks(box, text);
      QTest::keyClick(box, Qt::Key_Return);
    };
    type(dialog->threadsBox(), QStringLiteral("2"));
    type(dialog->memoryBox(), QStringLiteral("1024"));
    QCOMPARE(workSettingsIn(bench.settings).settings.threads, 2);
    QCOMPARE(workSettingsIn(bench.settings).settings.budget_mb, 1024);
    QCOMPARE(WorkSettings({2, 1024}).budgets().all() >> 20, std::size_t(1023));  // shares are whole bytes
    delete dialog;
    dialog = openDialog(bench);
    QCOMPARE(dialog->threadsBox()->value(), 2);
    QCOMPARE(dialog->memoryBox()->value(), 1024);
    dialog->threadsBox()->setValue(dialog->threadsBox()->minimum());
    dialog->memoryBox()->setValue(dialog->memoryBox()->minimum());
    QVERIFY(!bench.settings.contains(QStringLiteral("work/threads")));
    QVERIFY(!bench.settings.contains(QStringLiteral("memory/budget_mb")));
  }

  void ofNonsenseTheUsualIsTakenAndItIsSaid_data() {
    QTest::addColumn<QVariant>("threads");
    QTest::addColumn<QVariant>("budget_mb");
    QTest::addColumn<int>("sentences");
    QTest::addColumn<int>("taken_threads");
    QTest::addColumn<int>("taken_mb");
    QTest::newRow("nothing") << QVariant() << QVariant() << 0 << 0 << 0;
    QTest::newRow("zero is the usual") << QVariant(0) << QVariant(0) << 0 << 0 << 0;
    QTest::newRow("numbers") << QVariant(8) << QVariant(2048.0) << 0 << 8 << 2048;
    QTest::newRow("the limits") << QVariant(256) << QVariant(128) << 0 << 256 << 128;
    QTest::newRow("beyond the limits") << QVariant(257) << QVariant(127) << 2 << 0 << 0;
    QTest::newRow("negative") << QVariant(-1) << QVariant(-640) << 2 << 0 << 0;
    QTest::newRow("too large") << QVariant(1e30) << QVariant(qlonglong(1) << 40) << 2 << 0 << 0;
    QTest::newRow("words") << QVariant(QStringLiteral("<b>all\x1b</b>")) << QVariant(1.5) << 2 << 0 << 0;
  }
  void ofNonsenseTheUsualIsTakenAndItIsSaid() {
    QFETCH(QVariant, threads);
    QFETCH(QVariant, budget_mb);
    QFETCH(int, sentences);
    QFETCH(int, taken_threads);
    QFETCH(int, taken_mb);
    Bench bench;
    if (threads.isValid()) bench.settings.setValue(QStringLiteral("work/threads"), threads);
    if (budget_mb.isValid()) bench.settings.setValue(QStringLiteral("memory/budget_mb"), budget_mb);
    const KeptWorkSettings kept = workSettingsIn(bench.settings);
    QCOMPARE(kept.nonsense.size(), sentences);
    QVERIFY((kept.settings == WorkSettings{taken_threads, taken_mb}));
    if (sentences == 0) return;
    QVERIFY(kept.nonsense[0].contains(QLatin1String("work/threads")));
    QVERIFY(kept.nonsense[0].contains(bench.settings.fileName()));
    QVERIFY(!kept.nonsense[0].contains(QLatin1Char('\x1b')));
    bench.open();
    QStringList said;
    for (const QLabel* label : openDialog(bench)->findChildren<QLabel*>()) {
      if (label->textFormat() == Qt::PlainText) said << label->text();
    }
    QCOMPARE(said, kept.nonsense);
  }
};

}  // namespace test_window_diagnostics

MAPWRIGHT_TEST(test_window_diagnostics, WindowDiagnosticsTest, Widgets)
#include "test_window_diagnostics.moc"
