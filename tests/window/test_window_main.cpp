// The whole window on a fake robot: states, notices, docks, theme, settings.
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>
#include <QtTest>

#include "render/tile_colors.h"
#include "test_program.h"
#include "ui/kit/plain_label.h"
#include "ui/layers/layers_controller.h"
#include "ui/layers/layers_dock.h"
#include "ui/maps/maps_dock.h"
#include "ui/plots/messages_dock.h"
#include "ui/replay/recordings_dock.h"
#include "ui/robot/connect_dialog.h"
#include "ui/robot/connection_chip.h"
#include "ui/robot/problems_dock.h"
#include "ui/robot/robot_dock.h"
#include "ui/scene/map_theme.h"
#include "ui/shell/window_status_bar.h"
#include "ui/slam/inspector_dock.h"
#include "ui/view/empty_state.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/notice_bar.h"
#include "ui/view/toast_stack.h"
#include "ui/window/appearance_controller.h"
#include "ui/window/main_window.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_main {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;
using test::kAddress;

class TestWindowMain : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void saysWhatToDoWithoutARobot() {
    Bench bench;
    MainWindow& window = bench.open();
    QCOMPARE(*part<MapOverlay>(window)->card()->kind(), EmptyState::Kind::NoRobot);
    QCOMPARE(part<WindowStatusBar>(window)->connectionShown(), QStringLiteral("no robot"));
    QVERIFY(!bench.action("retry")->isEnabled());
    for (QPushButton* button : part<MapOverlay>(window)->card()->findChildren<QPushButton*>()) {
      if (button->text() == QLatin1String("Try the demo robot")) QTest::mouseClick(button, Qt::LeftButton);
    }
    QVERIFY(window.session());
    QCOMPARE(window.session()->robot().address(), QStringLiteral("demo:"));
  }

  void givesTheMapMostOfASmallScreen() {
    Bench bench;
    MainWindow& window = bench.open({1366, 768});
    QCOMPARE(window.width(), 1366);
    QVERIFY2(window.view()->width() >= int(0.6 * 1366), qPrintable(QString::number(window.view()->width())));
    QVERIFY(window.minimumSizeHint().width() <= 1366);
    QVERIFY(window.minimumSizeHint().height() <= 768);
  }

  void followsTheStates() {
    Bench bench;
    bench.prepare = [](test::FakeRobot& robot) { robot.auto_online = false; };
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    robot::ConnectionState connecting;
    connecting.phase = robot::ConnectionPhase::Connecting;
    bench.robot->setState(connecting);
    QCOMPARE(*part<MapOverlay>(window)->card()->kind(), EmptyState::Kind::Connecting);
    QCOMPARE(part<ConnectionChip>(window)->word(), QStringLiteral("connecting"));
    bench.robot->goOnline();
    QCOMPARE(*part<MapOverlay>(window)->card()->kind(), EmptyState::Kind::WaitingForList);
    QCOMPARE(part<WindowStatusBar>(window)->connectionShown(), QStringLiteral("connected 12 ms"));
    bench.robot->list({});
    QTRY_COMPARE(*part<MapOverlay>(window)->card()->kind(), EmptyState::Kind::NoSubmaps);
    bench.load();
    QTRY_VERIFY(!part<MapOverlay>(window)->card()->kind());
    QTRY_COMPARE(part<WindowStatusBar>(window)->loadingShown(), QStringLiteral("3 of 3 submaps"));
    bench.robot->goAway(QStringLiteral("connection refused"));
    QVERIFY(!part<MapOverlay>(window)->card()->kind());  // nothing disappears
    QVERIFY(part<MapOverlay>(window)->notice()->isVisible());
    QVERIFY(part<MapOverlay>(window)->notice()->sentence().startsWith(QLatin1String("No connection since ")));
    QCOMPARE(part<WindowStatusBar>(window)->connectionShown(),
             QStringLiteral("reconnecting in 3 s (attempt 2): connection refused"));
    robot::ConnectionState refused;
    refused.phase = robot::ConnectionPhase::Refused;
    refused.reason = fault::said("the certificate has changed. " + std::string(200, 'x'));
    bench.robot->setState(refused);
    QVERIFY(part<MapOverlay>(window)->notice()->sentence().contains(QLatin1String(". The certificate")));
    for (const PlainLabel* label : part<WindowStatusBar>(window)->findChildren<PlainLabel*>()) {
      if (label->text() == part<WindowStatusBar>(window)->loadingShown())
        QTRY_VERIFY(label->width() >= label->sizeHint().width());
    }
    bench.robot->goAway(QStringLiteral("connection refused"));
    const int before = bench.robot->connects;
    QTest::mouseClick(part<MapOverlay>(window)->notice()->findChild<QPushButton*>(), Qt::LeftButton);
    QCOMPARE(bench.robot->connects, before + 1);
    bench.robot->goOnline();
    QVERIFY(!part<MapOverlay>(window)->notice()->isVisible());
    window.leaveRobot();
    QCOMPARE(*part<MapOverlay>(window)->card()->kind(), EmptyState::Kind::NoRobot);
  }

  void refusesABadAddressAndStaysWhereItIs() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    session::Session* session = window.session();
    QCOMPARE(*window.connectTo(QStringLiteral("bad")), QStringLiteral("This is no address."));
    QCOMPARE(window.session(), session);
  }

  void asksForTheSecretThatWasRefused_data() {
    QTest::addColumn<bool>("had_been_online");
    QTest::newRow("by the card") << false;
    QTest::newRow("by the notice") << true;
  }
  void asksForTheSecretThatWasRefused() {
    QFETCH(bool, had_been_online);
    Bench bench;
    bench.prepare = [&](test::FakeRobot& robot) { robot.auto_online = had_been_online; };
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    if (had_been_online) bench.load();
    robot::ConnectionState refused;
    refused.phase = robot::ConnectionPhase::Refused;
    refused.reason = fault::said("the robot refuses the connection");
    const auto offer = [&]() -> QPushButton* {
      for (QPushButton* button : window.findChildren<QPushButton*>()) {
        if (button->isVisible() && button->text() == QStringLiteral("Enter secret…")) return button;
      }
      return nullptr;
    };
    bench.robot->setState(refused);  // for another reason
    QVERIFY(!offer());
    refused.failure = map::FailureKind::Refused;
    bench.robot->setState(refused);
    QVERIFY(offer());
    QTest::mouseClick(offer(), Qt::LeftButton);
    ConnectDialog* dialog = part<ConnectDialog>(window);
    QVERIFY(dialog);
    QVERIFY(QTest::qWaitForWindowActive(dialog));
    auto* secret = dialog->findChild<QLineEdit*>(QStringLiteral("secret"));
    QCOMPARE(dialog->findChild<QLineEdit*>(QStringLiteral("address"))->text(), kAddress);
    QCOMPARE(dialog->errorText(), QStringLiteral("The robot refuses the connection"));
    QCOMPARE(dialog->focusWidget(), secret);
    QTest::keyClicks(secret, QStringLiteral("hunter2"));
    QVERIFY(dialog->errorText().isEmpty());
    QTest::keyClick(secret, Qt::Key_Return);
    QCOMPARE(bench.secret, QByteArray("hunter2"));
    QCOMPARE(window.session()->robot().address(), kAddress);
  }

  void showsNamesOfRobotsAsTheyAre() {
    Bench bench;
    bench.prepare = [](test::FakeRobot& robot) { robot.read_only_maker = QStringLiteral("<b>Maker</b>"); };
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.robot->identify({QStringLiteral("<b>model</b>"), {}, QStringLiteral("<img src=x>&amp; Co"), {}});
    QCOMPARE(part<ConnectionChip>(window)->name(), QStringLiteral("<img src=x>&amp; Co"));
    QVERIFY(!part<ConnectionChip>(window)->toolTip().contains(QLatin1String("<b>")));
    int with_markup = 0;
    for (const QLabel* label : window.findChildren<QLabel*>()) {
      if (!label->text().contains(QLatin1Char('<'))) continue;
      ++with_markup;
      QCOMPARE(label->textFormat(), Qt::PlainText);
    }
    QVERIFY(with_markup > 0);
    bench.robot->failing = {{0, 0}};
    bench.robot->list({test::entry(0, 0, 1, 0, 0)});
    QTRY_COMPARE(part<ProblemsDock>(window)->model()->rowCount(), 1);
    const QModelIndex sentence = part<ProblemsDock>(window)->model()->index(0, ProblemsModel::SentenceColumn);
    QVERIFY(sentence.data().toString().contains(QLatin1String("<b>500</b>")));
    QVERIFY(!sentence.data(Qt::ToolTipRole).toString().contains(QLatin1String("<b>")));
  }

  void switchesTheme() {
    Bench bench;
    MainWindow& window = bench.open();
    bench.action("themeDark")->trigger();
    QVERIFY(qApp->palette().color(QPalette::Window).lightness() < 128);
    QVERIFY(window.mapScene()->theme().dark);
    bench.action("themeLight")->trigger();
    QVERIFY(qApp->palette().color(QPalette::Window).lightness() > 128);
    QVERIFY(!window.mapScene()->theme().dark);
    bench.action("themeSystem")->trigger();
    QCOMPARE(part<AppearanceController>(window)->theme(), ThemeChoice::System);
  }

  void remembersTheLayout() {
    Bench bench;
    {
      MainWindow& window = bench.open();
      part<LayersDock>(window)->close();
      bench.action("themeDark")->trigger();
      window.mapScene()->setLayerVisible(ui::scene::Layer::Grid, false);
      window.mapScene()->setLayerOpacity(ui::scene::Layer::Trail, 0.5);
      part<LayersController>(window)->setColorMode(render::ColorMode::Version);
      QVERIFY(!window.connectTo(kAddress));
      bench.key(Qt::Key_M);
      window.close();
    }
    MainWindow& again = bench.open();
    QVERIFY(!part<LayersDock>(again)->isVisible());
    QVERIFY(part<InspectorDock>(again)->isVisible());
    QCOMPARE(part<AppearanceController>(again)->theme(), ThemeChoice::Dark);
    QVERIFY(!again.mapScene()->layerVisible(ui::scene::Layer::Grid));
    QCOMPARE(again.mapScene()->layerOpacity(ui::scene::Layer::Trail), 0.5);
    QCOMPARE(again.mapScene()->colorMode(), render::ColorMode::Version);
    QCOMPARE(again.view()->tool()->name(), QStringLiteral("measure"));
    bench.action("resetLayout")->trigger();
    QVERIFY(part<LayersDock>(again)->isVisible());
    QVERIFY(again.mapScene()->layerVisible(ui::scene::Layer::Grid));
    QCOMPARE(again.mapScene()->colorMode(), render::ColorMode::Normal);
    bench.action("themeSystem")->trigger();
  }

  void remembersWhichTabsAreInFront_data() {
    QTest::addColumn<bool>("others");
    QTest::newRow("as at first") << false;
    QTest::newRow("the other ones") << true;
  }
  void remembersWhichTabsAreInFront() {
    QFETCH(bool, others);
    Bench bench;
    bench.offerMaps();
    const auto in_front = [](const QDockWidget* dock) { return !dock->visibleRegion().isEmpty(); };
    const auto front = [&](MainWindow& window) {
      return std::vector<bool>{in_front(part<MapsDock>(window)),     in_front(part<LayersDock>(window)),
                               in_front(part<RobotDock>(window)),    in_front(part<InspectorDock>(window)),
                               in_front(part<MessagesDock>(window)), in_front(part<RecordingsDock>(window))};
    };
    const std::vector<bool> wanted = others ? std::vector<bool>{true, false, true, false, true, false}
                                            : std::vector<bool>{false, true, false, true, false, true};
    {
      MainWindow& window = bench.open();
      part<MessagesDock>(window)->show();
      part<RecordingsDock>(window)->show();
      QTRY_VERIFY(in_front(part<InspectorDock>(window)) && in_front(part<LayersDock>(window)));
      QDockWidget* const first[] = {part<MapsDock>(window), part<RobotDock>(window),
                                    part<MessagesDock>(window)};
      QDockWidget* const second[] = {part<LayersDock>(window), part<InspectorDock>(window),
                                     part<RecordingsDock>(window)};
      for (QDockWidget* dock : others ? first : second) dock->raise();
      QTRY_COMPARE(front(window), wanted);
      window.close();
    }
    // Neither the start nor a robot that has only whole maps brings another tab to the front.
    MainWindow& again = bench.open();
    QTRY_COMPARE(front(again), wanted);
    bench.prepare = [](test::FakeRobot& robot) { robot.has_catalogue = true, robot.has_submaps = false; };
    QVERIFY(!again.connectTo(QStringLiteral("file:/maps")));
    QCoreApplication::processEvents();
    QTRY_COMPARE(front(again), wanted);
  }

  void bringsTheRobotToTheFrontWhereThereAreNoSubmaps() {
    Bench bench;
    const auto in_front = [](const QDockWidget* dock) { return !dock->visibleRegion().isEmpty(); };
    bench.prepare = [](test::FakeRobot& robot) { robot.has_submaps = false; };
    MainWindow& window = bench.open();
    QTRY_VERIFY(in_front(part<InspectorDock>(window)));
    QVERIFY(!window.connectTo(test::kAddress));
    QTRY_VERIFY(in_front(part<RobotDock>(window)));
    bench.prepare = {};
    QVERIFY(!window.connectTo(test::kAddress));
    QTRY_VERIFY(in_front(part<InspectorDock>(window)));
    // Whoever has chosen another panel keeps it.
    part<RobotDock>(window)->raise();
    QVERIFY(!window.connectTo(test::kAddress));
    QCoreApplication::processEvents();
    QTRY_VERIFY(in_front(part<RobotDock>(window)));
  }

  void bringsAPanelThatIsOpenedToTheFront() {
    Bench bench;
    MainWindow& window = bench.open();
    for (QDockWidget* dock : {static_cast<QDockWidget*>(part<ProblemsDock>(window)),
                              static_cast<QDockWidget*>(part<MessagesDock>(window)),
                              static_cast<QDockWidget*>(part<RobotDock>(window)),
                              static_cast<QDockWidget*>(part<ProblemsDock>(window))}) {
      dock->toggleViewAction()->trigger();  // also where it is open, behind another
      QTRY_VERIFY(!dock->visibleRegion().isEmpty());
    }
  }

  void nothingThatNeedsARobotIsEnabledWithoutOne() {
    // Everything else acts on a robot, a file, or on what they show.
    const QSet<QByteArray> may{
        // Getting one, the program itself, help.
        "connect", "demo", "openFile", "quit", "about", "diagnostics", "copyDiagnostics", "manual", "palette",
        "shortcuts",
        // How maps are to look, and how the window does: remembered, whoever comes next.
        "modeSubmaps", "modeWhole", "modeBoth", "grid", "showIds", "showOutlines", "colorsNormal",
        "colorsIncremental", "colorsActive", "colorsTrajectory", "colorsAge", "colorsVersion",
        "layersNavigation", "layersMapping", "layersMapOnly", "layersAll", "saveLayerPreset", "furniture",
        "pan", "replayReadAll", "fullScreen", "resetLayout", "focusMap", "nextPane", "previousPane",
        "layoutOperate", "layoutInspect", "layoutReplay", "showRecordings"};
    Bench bench;
    MainWindow& window = bench.open();
    const auto check = [&](const char* when) {
      for (const Actions::Entry& entry : window.actionList().entries()) {
        const QString id = entry.action->objectName();
        const bool setting = id.startsWith(QLatin1String("theme")) || id.startsWith(QLatin1String("snap")) ||
                             id.startsWith(QLatin1String("language"));
        const bool panel = qobject_cast<QDockWidget*>(entry.action->parent()) != nullptr;
        if (panel || setting || may.contains(id.toUtf8())) continue;
        QVERIFY2(!entry.action->isEnabled(),
                 qPrintable(QLatin1String(when) + id + QLatin1Char(' ') + entry.action->text()));
      }
    };
    check("at first: ");
    bench.prepare = [](test::FakeRobot& made) { made.has_live = true; };
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    for (const char* id : {"fit", "zoomIn", "goTo", "measure", "export", "compare", "follow", "filter"})
      QVERIFY2(bench.action(id)->isEnabled(), id);
    window.leaveRobot();
    check("afterwards: ");
    // What is disabled does nothing by its key either.
    const auto camera = window.mapScene()->view();
    for (const Qt::Key key : {Qt::Key_Plus, Qt::Key_BracketLeft, Qt::Key_0}) bench.key(key);
    QCOMPARE(window.mapScene()->view(), camera);
  }

  void whatIsOfARobotIsDisabledWhileAFileIsOpenAndSaysWhy() {
    Bench bench;
    MainWindow& window = bench.open();
    const std::vector<const char*> of_robot{"retry",       "disconnect",   "record",        "showRecordings",
                                            "follow",      "fetchRegion",  "fetchWholeMap", "saveMapOnRobot",
                                            "cloudRegion", "cloudSection", "projections",   "refreshRegions"};
    QVERIFY(!window.connectTo(QStringLiteral("file:/maps/office.yaml")));
    for (const char* id : of_robot) {
      QVERIFY2(!bench.action(id)->isEnabled(), id);
      const QString tip = bench.action(id)->toolTip();
      QVERIFY2(tip.contains(QLatin1String("file")) || tip.contains(QLatin1String("no ")) ||
                   tip.contains(QLatin1String("not")),
               qPrintable(QLatin1String(id) + QLatin1String(": ") + tip));
    }
    QVERIFY(bench.action("closeFile")->isEnabled() && bench.action("readAgain")->isEnabled());
    bench.robot->goAway(QStringLiteral("gone"));
    const int before = bench.robot->connects;
    bench.key(Qt::Key_F5);
    QCOMPARE(bench.robot->connects, before + 1);
    bench.action("closeFile")->trigger();
    QVERIFY(!window.session());
    bench.prepare = [](test::FakeRobot& made) { made.has_live = true; };
    QVERIFY(!window.connectTo(kAddress));
    QVERIFY(!bench.action("closeFile")->isEnabled() && !bench.action("readAgain")->isEnabled());
    for (const char* id : {"retry", "disconnect", "follow", "cloudRegion"}) {
      // It has no clouds, and that has another reason.
      QVERIFY2(bench.action(id)->isEnabled() == (qstrcmp(id, "cloudRegion") != 0), id);
      QVERIFY2(!bench.action(id)->toolTip().contains(QLatin1String("file")), id);
    }
    bench.robot->goAway(QStringLiteral("gone"));
    const int again = bench.robot->connects;
    bench.key(Qt::Key_F5);
    QCOMPARE(bench.robot->connects, again + 1);
  }

  void leavesTheProblemsAsTheyWereLeft_data() {
    QTest::addColumn<bool>("open");
    QTest::newRow("open") << true;
    QTest::newRow("closed") << false;
  }
  void leavesTheProblemsAsTheyWereLeft() {
    QFETCH(bool, open);
    Bench bench;
    const auto fail = [&] {
      bench.robot->failing = {{0, 0}};
      bench.robot->list({test::entry(0, 0, 1, 0, 0)});
    };
    {
      MainWindow& window = bench.open();
      QVERIFY(!window.connectTo(kAddress));
      fail();
      part<ProblemsDock>(window)->setVisible(open);
      window.close();
    }
    MainWindow& again = bench.open();
    QCOMPARE(part<ProblemsDock>(again)->isVisible(), open);
    QVERIFY(!again.connectTo(kAddress));
    fail();
    QTRY_VERIFY(part<WindowStatusBar>(again)->problemsButton()->isVisible());
    QCOMPARE(part<ProblemsDock>(again)->isVisible(), open);
  }

  void givesTheMaximisedWindowBackFromTheFullScreen() {
    Bench bench;
    MainWindow& window = bench.open();
    window.showMaximized();
    QTRY_VERIFY(window.isMaximized());
    bench.key(Qt::Key_F11);
    QVERIFY(window.isFullScreen());
    QVERIFY(bench.action("fullScreen")->isChecked());
    bench.key(Qt::Key_F11);
    QVERIFY(!window.isFullScreen());
    QVERIFY(window.isMaximized());
    window.setWindowState(Qt::WindowFullScreen);  // by the desktop
    QVERIFY(bench.action("fullScreen")->isChecked());
    window.setWindowState(Qt::WindowNoState);
    QVERIFY(!bench.action("fullScreen")->isChecked());
  }

  void comesUpAsLargeAsItWasLeft_data() {
    QTest::addColumn<Qt::WindowStates>("state");
    QTest::newRow("normal") << Qt::WindowStates(Qt::WindowNoState);
    QTest::newRow("maximised") << Qt::WindowStates(Qt::WindowMaximized);
    QTest::newRow("full screen over maximised") << (Qt::WindowMaximized | Qt::WindowFullScreen);
  }
  void comesUpAsLargeAsItWasLeft() {
    QFETCH(Qt::WindowStates, state);
    Bench bench;
    {
      MainWindow& window = bench.open();
      window.setWindowState(state);
      window.close();
    }
    MainWindow& again = bench.open();
    constexpr auto kOfInterest = Qt::WindowMaximized | Qt::WindowFullScreen;
    QCOMPARE(again.windowState() & kOfInterest, state);
    QCOMPARE(bench.action("fullScreen")->isChecked(), state.testFlag(Qt::WindowFullScreen));
  }

  void tellsOfTheFirstProblemAndOpensNothingByItself() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    const auto in_front = [&] { return !part<ProblemsDock>(window)->visibleRegion().isEmpty(); };
    QVERIFY(!in_front());
    QVERIFY(!part<WindowStatusBar>(window)->problemsButton()->isVisible());
    bench.robot->failing = {{0, 0}};
    bench.robot->list({test::entry(0, 0, 1, 0, 0), test::entry(0, 1, 1, 5, 0)});
    QTRY_COMPARE(part<MapOverlay>(window)->toasts()->texts().size(), qsizetype(1));
    QVERIFY(part<MapOverlay>(window)->toasts()->texts()[0].startsWith(QLatin1String("Submap 0-0: ")));
    QVERIFY(!in_front());
    for (QPushButton* button : part<MapOverlay>(window)->toasts()->findChildren<QPushButton*>()) {
      if (button->text() == QLatin1String("Show problems")) QTest::mouseClick(button, Qt::LeftButton);
    }
    QTRY_VERIFY(in_front());
    QCOMPARE(part<WindowStatusBar>(window)->problemsButton()->text(), QStringLiteral("1 problem"));
    part<ProblemsDock>(window)->table()->selectAll();
    for (QPushButton* button : part<ProblemsDock>(window)->findChildren<QPushButton*>()) {
      if (button->text() == QLatin1String("Copy selected")) QTest::mouseClick(button, Qt::LeftButton);
    }
    QVERIFY(QApplication::clipboard()->text().contains(QLatin1String("Submap 0-0")));
    part<ProblemsDock>(window)->close();
    QTest::mouseClick(part<WindowStatusBar>(window)->problemsButton(), Qt::LeftButton);
    QVERIFY(part<ProblemsDock>(window)->isVisible());
  }

  void tellsOfANewSession() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.robot->list({test::entry(0, 0, 1, 0, 0)}, "session-a");
    QVERIFY(part<MapOverlay>(window)->toasts()->texts().isEmpty());
    bench.robot->list({test::entry(0, 0, 1, 0, 0)}, "session-b");
    QCOMPARE(part<MapOverlay>(window)->toasts()->texts().size(), qsizetype(1));
    QVERIFY(part<MapOverlay>(window)->toasts()->texts()[0].contains(QLatin1String("new SLAM session")));
  }

  void everyActionCanBeFoundInAMenu() {
    Bench bench;
    MainWindow& window = bench.open();
    QSet<QAction*> in_menus;
    for (const QMenu* menu : window.findChildren<QMenu*>()) {
      for (QAction* action : menu->actions()) in_menus.insert(action);
    }
    QVERIFY(!window.actionList().entries().empty());
    for (const Actions::Entry& entry : window.actionList().entries()) {
      QVERIFY2(in_menus.contains(entry.action), qPrintable(entry.action->objectName()));
      QVERIFY2(!entry.action->toolTip().isEmpty(), qPrintable(entry.action->objectName()));
    }
    QSet<QString> keys;
    for (const Actions::Entry& entry : window.actionList().entries()) {
      for (const QKeySequence& key : entry.action->shortcuts()) {
        QVERIFY2(!keys.contains(key.toString()), qPrintable(key.toString()));
        keys.insert(key.toString());
      }
    }
  }
};

}  // namespace test_window_main

MAPWRIGHT_TEST(test_window_main, TestWindowMain, Widgets)
#include "test_window_main.moc"
