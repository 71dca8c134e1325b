// The whole window on a fake robot: states, docks, tools, settings.
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeView>
#include <QtTest>

#include "fake_robot.h"
#include "window/docks/inspector_controls.h"
#include "window/docks/inspector_dock.h"
#include "window/docks/layers_dock.h"
#include "window/docks/problems_dock.h"
#include "window/look/plain_label.h"
#include "window/main_window.h"
#include "window/map/empty_state.h"
#include "window/map/map_furniture.h"
#include "window/map/map_overlay.h"
#include "window/map/map_view.h"
#include "window/map/measure_tool.h"
#include "window/map/notice_bar.h"
#include "window/map/toast_stack.h"
#include "window/status/connection_chip.h"
#include "window/status/window_status_bar.h"

using namespace mapwright;
using namespace mapwright::window;

namespace {

const QString kAddress = QStringLiteral("axbot+http://192.0.2.7:8090");

struct Bench {
  Bench() : settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat) {}

  MainWindow& open(const QSize& size = {1366, 768}) {
    window.reset();
    MainWindow::Dependencies wanted{
        [this](const QString& address,
               const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          if (address == QLatin1String("bad")) {
            return tl::unexpected(QStringLiteral("This is no address."));
          }
          auto made = std::make_unique<test::FakeRobot>(address);
          robot = made.get();
          if (prepare) prepare(*made);
          return std::unique_ptr<robot::Robot>(std::move(made));
        },
        settings};
    window = std::make_unique<MainWindow>(std::move(wanted));
    window->resize(size);
    window->show();
    window->view()->setAnimationMs(0);
    (void)QTest::qWaitForWindowActive(window.get());
    return *window;
  }
  QAction* action(const char* id) { return window->actionList().find(QLatin1String(id)); }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(window->view(), key, modifiers);
  }
  QModelIndex row(map::SubmapId id, int column = 0) {
    InspectorDock* dock = window->inspector();
    return dock->filterModel()->mapFromSource(dock->model()->indexOf(id)).siblingAtColumn(column);
  }
  /// Two trajectories, the second far to the right; all pictures in.
  void load() {
    robot->list({test::entry(0, 0, 1, 0, 0), test::entry(0, 1, 1, 5, 0), test::entry(1, 0, 3, 40, 0)});
    QTRY_COMPARE(window->session()->counts().shown, 3);
    QTRY_VERIFY(row({1, 0}).isValid());
  }

  QTemporaryDir folder;
  QSettings settings;
  std::unique_ptr<MainWindow> window;
  test::FakeRobot* robot = nullptr;
  std::function<void(test::FakeRobot&)> prepare;
};

}  // namespace

class TestWindowMain : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void saysWhatToDoWithoutARobot() {
    Bench bench;
    MainWindow& window = bench.open();
    QCOMPARE(*window.overlay()->card()->kind(), EmptyState::Kind::NoRobot);
    QCOMPARE(window.bar()->connectionShown(), QStringLiteral("no robot"));
    QVERIFY(!bench.action("retry")->isEnabled());
    for (QPushButton* button : window.overlay()->card()->findChildren<QPushButton*>()) {
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
    QCOMPARE(*window.overlay()->card()->kind(), EmptyState::Kind::Connecting);
    QCOMPARE(window.chip()->word(), QStringLiteral("connecting"));
    bench.robot->goOnline();
    QCOMPARE(*window.overlay()->card()->kind(), EmptyState::Kind::WaitingForList);
    QCOMPARE(window.bar()->connectionShown(), QStringLiteral("connected 12 ms"));
    bench.robot->list({});
    QTRY_COMPARE(*window.overlay()->card()->kind(), EmptyState::Kind::NoSubmaps);
    bench.load();
    QTRY_VERIFY(!window.overlay()->card()->kind());
    QTRY_COMPARE(window.bar()->loadingShown(), QStringLiteral("3 of 3 submaps"));
    bench.robot->goAway(QStringLiteral("connection refused"));
    QVERIFY(!window.overlay()->card()->kind());  // nothing disappears
    QVERIFY(window.overlay()->notice()->isVisible());
    QVERIFY(window.overlay()->notice()->sentence().startsWith(QLatin1String("No connection since ")));
    QCOMPARE(window.bar()->connectionShown(),
             QStringLiteral("reconnecting in 3 s (attempt 2): connection refused"));
    const int before = bench.robot->connects;
    QTest::mouseClick(window.overlay()->notice()->findChild<QPushButton*>(), Qt::LeftButton);
    QCOMPARE(bench.robot->connects, before + 1);
    bench.robot->goOnline();
    QVERIFY(!window.overlay()->notice()->isVisible());
    window.leaveRobot();
    QCOMPARE(*window.overlay()->card()->kind(), EmptyState::Kind::NoRobot);
  }

  void refusesABadAddressAndStaysWhereItIs() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    session::Session* session = window.session();
    QCOMPARE(*window.connectTo(QStringLiteral("bad")), QStringLiteral("This is no address."));
    QCOMPARE(window.session(), session);
  }

  void showsNamesOfRobotsAsTheyAre() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.robot->identify({QStringLiteral("<b>model</b>"), {}, QStringLiteral("<img src=x>&amp; Co"), {}});
    QCOMPARE(window.chip()->name(), QStringLiteral("<img src=x>&amp; Co"));
    QVERIFY(!window.chip()->toolTip().contains(QLatin1String("<b>")));
    for (const QLabel* label : window.findChildren<QLabel*>()) {
      if (label->text().contains(QLatin1Char('<'))) QCOMPARE(label->textFormat(), Qt::PlainText);
    }
    bench.robot->failing = {{0, 0}};
    bench.robot->list({test::entry(0, 0, 1, 0, 0)});
    QTRY_COMPARE(window.problems()->model()->rowCount(), 1);
    const QModelIndex sentence = window.problems()->model()->index(0, ProblemsModel::SentenceColumn);
    QVERIFY(sentence.data().toString().contains(QLatin1String("<b>500</b>")));
    QVERIFY(!sentence.data(Qt::ToolTipRole).toString().contains(QLatin1String("<b>")));
  }

  void locatesAndHighlights() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    QTreeView* tree = window.inspector()->tree();
    tree->expandAll();
    const QModelIndex row = bench.row({1, 0});
    tree->scrollTo(row);
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualRect(row).center());
    QCOMPARE(*window.mapScene()->highlighted(), (map::SubmapId{1, 0}));
    QVERIFY(window.inspector()->detailsText().startsWith(QLatin1String("1-0 v3")));
    const QModelIndex locate = bench.row({1, 0}, SubmapTreeModel::LocateColumn);
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualRect(locate).center());
    // 100 cells of 5 cm run to -x and -y from its pose.
    QVERIFY((window.mapScene()->view().center_m - Eigen::Vector2d(37.5, -2.5)).norm() < 1e-6);
    window.view()->lookAt({0, 0});
    Q_EMIT tree->doubleClicked(row);
    QVERIFY((window.mapScene()->view().center_m - Eigen::Vector2d(37.5, -2.5)).norm() < 1e-6);
    bench.key(Qt::Key_Escape);
    QVERIFY(!window.mapScene()->highlighted());
  }

  void groupsCanBeSwitchedOffAndStayOff() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    auto near = test::entry(0, 1, 1, 5, 0);
    near.is_nearby = true;
    bench.robot->list({test::entry(0, 0, 1, 0, 0), near});
    QTRY_COMPARE(window.session()->counts().listed, 2);
    Q_EMIT window.inspector()->controls()->nearbyWanted(false);
    QVERIFY(!window.session()->book().find({0, 1})->visible);
    QVERIFY(window.session()->book().find({0, 0})->visible);
    auto newcomer = test::entry(0, 2, 1, 9, 0);
    newcomer.is_nearby = true;
    bench.robot->list({test::entry(0, 0, 1, 0, 0), near, newcomer, test::entry(0, 3, 1, 9, 9)});
    QTRY_VERIFY(!window.session()->book().find({0, 2})->visible);
    QVERIFY(window.session()->book().find({0, 3})->visible);
  }

  void keysWorkOnTheMapAndNotWhileTyping() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    const bool grid = window.mapScene()->layerVisible(scene::Layer::Grid);
    window.view()->setFocus();
    bench.key(Qt::Key_G);
    QCOMPARE(window.mapScene()->layerVisible(scene::Layer::Grid), !grid);
    bench.key(Qt::Key_BracketLeft);
    QVERIFY(window.mapScene()->view().rotation_rad > 0);
    bench.key(Qt::Key_N);
    QCOMPARE(window.mapScene()->view().rotation_rad, 0.0);
    bench.key(Qt::Key_0);
    QCOMPARE(window.mapScene()->view().scale_m_per_px, 0.05);
    bench.key(Qt::Key_Minus);
    QCOMPARE(window.mapScene()->view().scale_m_per_px, 0.0625);
    bench.key(Qt::Key_M);
    QCOMPARE(window.view()->tool()->name(), QStringLiteral("measure"));
    QVERIFY(!window.overlay()->hint().isEmpty());
    bench.key(Qt::Key_Escape);
    QCOMPARE(window.view()->tool()->name(), QStringLiteral("pan"));
    bench.key(Qt::Key_Tab);
    QVERIFY(!window.overlay()->furniture()->isVisible());
    bench.key(Qt::Key_Tab);
    QVERIFY(window.overlay()->furniture()->isVisible());

    QLineEdit* filter = window.inspector()->controls()->filterEdit();
    filter->setFocus();
    const auto camera = window.mapScene()->view();
    QTest::keyClicks(filter, QStringLiteral("fgnrm0-"));
    QCOMPARE(filter->text(), QStringLiteral("fgnrm0-"));
    QCOMPARE(window.mapScene()->view(), camera);
    QCOMPARE(window.mapScene()->layerVisible(scene::Layer::Grid), !grid);
  }

  void followsTheRobotUntilPanned() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.robot->say(map::TrackedPose{{3, 4, 0}});
    bench.key(Qt::Key_R);
    QVERIFY(bench.action("follow")->isChecked());
    QVERIFY((window.mapScene()->view().center_m - Eigen::Vector2d(3, 4)).norm() < 1e-9);
    bench.robot->say(map::TrackedPose{{5, 6, 0}});
    QVERIFY((window.mapScene()->view().center_m - Eigen::Vector2d(5, 6)).norm() < 1e-9);
    bench.key(Qt::Key_Plus);  // zooming does not end it
    QVERIFY(window.view()->following());
    bench.key(Qt::Key_Left);
    QVERIFY(!window.view()->following());
    QVERIFY(!bench.action("follow")->isChecked());
  }

  void poseAtHighRateMovesNoDock() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    QCoreApplication::processEvents();
    struct Layouts : QObject {
      bool eventFilter(QObject*, QEvent* event) override {
        requests += event->type() == QEvent::LayoutRequest;
        return false;
      }
      int requests = 0;
    } layouts;
    QTRY_VERIFY(window.session()->counts().pending == 0);
    QTest::qWait(250);  // the last tick of the rows has passed
    window.installEventFilter(&layouts);
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
      dock->installEventFilter(&layouts);
      dock->widget()->installEventFilter(&layouts);
    }
    for (int i = 0; i < 90; ++i) {
      bench.robot->say(map::TrackedPose{{i * 0.1, 0, 0}});
      QCoreApplication::processEvents();
    }
    QCOMPARE(layouts.requests, 0);
  }

  void tellsWhatIsUnderTheCursor() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    window.view()->lookAt({-2.5, -2.5});  // free floor of 0-0
    window.view()->setScale(0.05);
    const QPoint middle = window.view()->viewport()->rect().center();
    const auto hover = [&](const QPoint& at) {
      QMouseEvent move(QEvent::MouseMove, at, window.view()->viewport()->mapToGlobal(at), Qt::NoButton,
                       Qt::NoButton, {});
      QApplication::sendEvent(window.view()->viewport(), &move);
    };
    hover(middle);
    QVERIFY(window.bar()->cursorShown().startsWith(QLatin1String("x -2.5")));
    QTRY_VERIFY2(window.bar()->occupancyShown().startsWith(QLatin1String("free")),
                 qPrintable(window.bar()->occupancyShown()));
    hover(middle + QPoint(0, 150));  // 7.5 m further down lies nothing
    QTRY_COMPARE(window.bar()->occupancyShown(), QStringLiteral("unknown"));
    QCOMPARE(window.bar()->scaleShown().section(QLatin1String("  "), 1), QStringLiteral("5 cm/px"));
  }

  void layersFollowTheScene() {
    Bench bench;
    MainWindow& window = bench.open();
    QTest::mouseClick(window.layers()->eye(scene::Layer::Trail), Qt::LeftButton);
    QVERIFY(!window.mapScene()->layerVisible(scene::Layer::Trail));
    window.layers()->opacity(scene::Layer::Submaps)->setValue(40);
    QCOMPARE(window.mapScene()->layerOpacity(scene::Layer::Submaps), 0.4);
    window.mapScene()->setLayerVisible(scene::Layer::Ids, true);
    QVERIFY(bench.action("showIds")->isChecked());
    QVERIFY(window.layers()->eye(scene::Layer::Ids)->isChecked());
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
    QCOMPARE(window.theme(), ThemeChoice::System);
  }

  void remembersTheLayout() {
    Bench bench;
    {
      MainWindow& window = bench.open();
      window.layers()->close();
      bench.action("themeDark")->trigger();
      window.mapScene()->setLayerVisible(scene::Layer::Grid, false);
      window.mapScene()->setLayerOpacity(scene::Layer::Trail, 0.5);
      window.setColorMode(render::ColorMode::Active);
      bench.key(Qt::Key_M);
      window.close();
    }
    MainWindow& again = bench.open();
    QVERIFY(!again.layers()->isVisible());
    QVERIFY(again.inspector()->isVisible());
    QCOMPARE(again.theme(), ThemeChoice::Dark);
    QVERIFY(!again.mapScene()->layerVisible(scene::Layer::Grid));
    QCOMPARE(again.mapScene()->layerOpacity(scene::Layer::Trail), 0.5);
    QCOMPARE(again.mapScene()->colorMode(), render::ColorMode::Active);
    QCOMPARE(again.view()->tool()->name(), QStringLiteral("measure"));
    bench.action("resetLayout")->trigger();
    QVERIFY(again.layers()->isVisible());
    QVERIFY(again.mapScene()->layerVisible(scene::Layer::Grid));
    QCOMPARE(again.mapScene()->colorMode(), render::ColorMode::Normal);
    bench.action("themeSystem")->trigger();
  }

  void opensTheProblemsWhenThereAreSome() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QVERIFY(!window.problems()->isVisible());
    QVERIFY(!window.bar()->problemsButton()->isVisible());
    bench.robot->failing = {{0, 0}};
    bench.robot->list({test::entry(0, 0, 1, 0, 0), test::entry(0, 1, 1, 5, 0)});
    QTRY_VERIFY(window.problems()->isVisible());
    QCOMPARE(window.bar()->problemsButton()->text(), QStringLiteral("1 problem"));
    window.problems()->table()->selectAll();
    for (QPushButton* button : window.problems()->findChildren<QPushButton*>()) {
      if (button->text() == QLatin1String("Copy selected")) QTest::mouseClick(button, Qt::LeftButton);
    }
    QVERIFY(QApplication::clipboard()->text().contains(QLatin1String("Submap 0-0")));
    window.problems()->close();
    QTest::mouseClick(window.bar()->problemsButton(), Qt::LeftButton);
    QVERIFY(window.problems()->isVisible());
  }

  void tellsOfANewSession() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.robot->list({test::entry(0, 0, 1, 0, 0)}, "session-a");
    QVERIFY(window.overlay()->toasts()->texts().isEmpty());
    bench.robot->list({test::entry(0, 0, 1, 0, 0)}, "session-b");
    QCOMPARE(window.overlay()->toasts()->texts().size(), qsizetype(1));
    QVERIFY(window.overlay()->toasts()->texts()[0].contains(QLatin1String("new SLAM session")));
  }

  void takesPictures() {
    Bench bench;
    MainWindow& window = bench.open();
    const QString path = bench.folder.filePath(QStringLiteral("map.png"));
    QVERIFY(!window.saveMapPicture(path));
    const QImage saved(path);
    QCOMPARE(saved.size(), window.view()->viewport()->size());
    QVERIFY(window.saveMapPicture(bench.folder.filePath(QStringLiteral("none/map.png"))));
    bench.action("screenshotCopy")->trigger();
    QVERIFY(!QApplication::clipboard()->image().isNull());
    QVERIFY(window.overlay()->toasts()->texts().contains(QStringLiteral("Picture copied")));
  }

  void fitsTheFirstMapButNotAgainstTheUser() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    QTRY_VERIFY(window.mapScene()->view().visibleWorld().contains({40, -2}));
    QTRY_VERIFY((window.mapScene()->view().center_m - window.session()->contentBounds().center()).norm() <
                1e-6);
    window.view()->lookAt({-100, -100});
    bench.robot->list({test::entry(0, 0, 2, 0, 0), test::entry(0, 1, 1, 5, 0), test::entry(1, 0, 3, 40, 0)});
    QTRY_COMPARE(window.session()->book().find({0, 0})->shown_version, 2);
    QTRY_COMPARE(window.session()->counts().pending, 0);
    QVERIFY((window.mapScene()->view().center_m - Eigen::Vector2d(-100, -100)).norm() < 1e-9);
    bench.key(Qt::Key_F);
    QVERIFY((window.mapScene()->view().center_m - window.session()->contentBounds().center()).norm() < 1e-6);
  }

  void everyActionCanBeFoundInAMenu() {
    Bench bench;
    MainWindow& window = bench.open();
    QSet<QAction*> in_menus;
    for (const QMenu* menu : window.findChildren<QMenu*>()) {
      for (QAction* action : menu->actions()) in_menus.insert(action);
    }
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

QTEST_MAIN(TestWindowMain)
#include "test_window_main.moc"
