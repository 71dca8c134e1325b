// The whole window on a fake robot: what is done with the map.
#include <QAbstractSpinBox>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QToolButton>
#include <QTreeView>
#include <QtTest>

#include "submap/submap_store.h"
#include "test_program.h"
#include "ui/layers/layers_dock.h"
#include "ui/maps/export_controller.h"
#include "ui/maps/maps_dock.h"
#include "ui/plots/messages_dock.h"
#include "ui/robot/problems_dock.h"
#include "ui/shell/window_status_bar.h"
#include "ui/slam/inspector_dock.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/notice_bar.h"
#include "ui/view/toast_stack.h"
#include "ui/window/main_window.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_map {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;
using test::kAddress;

class TestWindowMap : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void locatesAndHighlights() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    QTreeView* tree = part<InspectorDock>(window)->tree();
    tree->expandAll();
    const QModelIndex row = bench.row({1, 0});
    tree->scrollTo(row);
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualRect(row).center());
    QCOMPARE(window.mapScene()->highlighted(), (std::set<map::SubmapId>{{1, 0}}));
    QVERIFY(part<InspectorDock>(window)
                ->findChild<QLabel*>(QStringLiteral("details"))
                ->text()
                .startsWith(QLatin1String("1-0 v3")));
    const QModelIndex locate = bench.row({1, 0}, SubmapTreeModel::LocateColumn);
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualRect(locate).center());
    // 100 cells of 5 cm run to -x and -y from its pose.
    QVERIFY((window.mapScene()->view().center_m - Eigen::Vector2d(37.5, -2.5)).norm() < 1e-6);
    window.view()->lookAt({0, 0});
    Q_EMIT tree->doubleClicked(row);
    QVERIFY((window.mapScene()->view().center_m - Eigen::Vector2d(37.5, -2.5)).norm() < 1e-6);
    bench.key(Qt::Key_Escape);
    QVERIFY(window.mapScene()->highlighted().empty());
  }

  void groupsCanBeSwitchedOffAndStayOff() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    auto near = test::entry(0, 1, 1, 5, 0);
    near.is_nearby = true;
    bench.robot->list({test::entry(0, 0, 1, 0, 0), near});
    QTRY_COMPARE(window.session()->counts().listed, 2);
    auto* const group = part<InspectorDock>(window)->findChild<QCheckBox*>(QStringLiteral("nearby"));
    group->setCheckState(Qt::Unchecked);
    Q_EMIT group->clicked(false);
    QVERIFY(!window.session()->submaps().find({0, 1})->visible);
    QVERIFY(window.session()->submaps().find({0, 0})->visible);
    auto newcomer = test::entry(0, 2, 1, 9, 0);
    newcomer.is_nearby = true;
    bench.robot->list({test::entry(0, 0, 1, 0, 0), near, newcomer, test::entry(0, 3, 1, 9, 9)});
    QTRY_VERIFY(!window.session()->submaps().find({0, 2})->visible);
    QVERIFY(window.session()->submaps().find({0, 3})->visible);
  }

  void keysWorkOnTheMapAndNotWhileTyping() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    const bool grid = window.mapScene()->layerVisible(ui::scene::Layer::Grid);
    window.view()->setFocus();
    bench.key(Qt::Key_G);
    QCOMPARE(window.mapScene()->layerVisible(ui::scene::Layer::Grid), !grid);
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
    QVERIFY(!part<MapOverlay>(window)->hint().isEmpty());
    bench.key(Qt::Key_Escape);
    QCOMPARE(window.view()->tool()->name(), QStringLiteral("pan"));
    bench.key(Qt::Key_H);
    QVERIFY(!part<MapOverlay>(window)->furniture()->isVisible());
    bench.key(Qt::Key_H);
    QVERIFY(part<MapOverlay>(window)->furniture()->isVisible());

    QLineEdit* filter = part<InspectorDock>(window)->filterEdit();
    filter->setFocus();
    const auto camera = window.mapScene()->view();
    QTest::keyClicks(filter, QStringLiteral("fgnrm0-"));
    QCOMPARE(filter->text(), QStringLiteral("fgnrm0-"));
    QCOMPARE(window.mapScene()->view(), camera);
    QCOMPARE(window.mapScene()->layerVisible(ui::scene::Layer::Grid), !grid);
  }

  void singleKeysWorkWhereverTheFocusIs() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    const auto types = [](QWidget* widget) {
      const auto* line = qobject_cast<QLineEdit*>(widget);
      const auto* box = qobject_cast<QComboBox*>(widget);
      return (line && !line->isReadOnly()) || qobject_cast<QAbstractSpinBox*>(widget) ||
             (box && box->isEditable());
    };
    int fields = 0, others = 0;
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
      dock->show();
      dock->raise();
      QCoreApplication::processEvents();
      for (auto* settings : dock->findChildren<QToolButton*>()) {
        if (settings->objectName().startsWith(QLatin1String("settings-"))) settings->setChecked(true);
      }
      QCoreApplication::processEvents();
      for (QWidget* widget : dock->findChildren<QWidget*>()) {
        if (!widget->isVisible() || !widget->isEnabled() || !(widget->focusPolicy() & Qt::TabFocus)) continue;
        widget->setFocus();
        if (!widget->hasFocus()) continue;  // it hands the focus on to a widget that is looked at by itself
        const QByteArray who = QByteArray(widget->metaObject()->className()) + ' ' +
                               widget->objectName().toUtf8() + " in " + dock->objectName().toUtf8();
        const bool grid = window.mapScene()->layerVisible(ui::scene::Layer::Grid);
        const double turn = window.mapScene()->view().rotation_rad;
        QTest::keyClick(widget, Qt::Key_G);
        QTest::keyClick(widget, Qt::Key_BracketLeft);
        const bool free = !types(widget);
        (free ? others : fields) += 1;
        QVERIFY2((window.mapScene()->layerVisible(ui::scene::Layer::Grid) != grid) == free, who);
        QVERIFY2((window.mapScene()->view().rotation_rad != turn) == free, who);
      }
    }
    QVERIFY2(fields >= 5, QByteArray::number(fields));
    QVERIFY2(others >= 20, QByteArray::number(others));
  }

  void tabGoesFromTheMapThroughTheControlsAndBack_data() {
    QTest::addColumn<bool>("backwards");
    QTest::newRow("Tab") << false;
    QTest::newRow("Shift+Tab") << true;
  }
  void tabGoesFromTheMapThroughTheControlsAndBack() {
    QFETCH(bool, backwards);
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    bench.action("compare")->trigger();  // a strip and a grip over the map
    int most = 0;
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
      dock->show();
      dock->raise();
      QCoreApplication::processEvents();
      window.view()->setFocus();
      QWidget* at = QApplication::focusWidget();
      QCOMPARE(at, static_cast<QWidget*>(window.view()));
      QStringList chain;
      bool dock_seen = false, over_map = false;
      do {
        QTest::keyClick(at, backwards ? Qt::Key_Backtab : Qt::Key_Tab,
                        backwards ? Qt::ShiftModifier : Qt::NoModifier);
        QWidget* const next = QApplication::focusWidget();
        QVERIFY(next);
        chain << QLatin1String(next->metaObject()->className()) + QLatin1Char(' ') + next->objectName();
        QVERIFY2(next != at, qPrintable(QStringLiteral("it ends at ") + chain.last()));
        QVERIFY2(chain.size() < 400, qPrintable(chain.mid(380).join(QStringLiteral(", "))));
        dock_seen |= dock->isAncestorOf(next);
        over_map |= window.view()->isAncestorOf(next);
        at = next;
      } while (at != window.view());
      most = std::max(most, int(chain.size()));
      QVERIFY2(over_map, "the strips over the map are on the way");
      const auto inside = dock->findChildren<QWidget*>();
      const bool has_any = std::any_of(inside.begin(), inside.end(), [&](const QWidget* widget) {
        return widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) &&
               !widget->focusProxy();
      });
      QVERIFY2(dock_seen || !has_any, qPrintable(dock->objectName()));
    }
    QVERIFY2(most > 10, QByteArray::number(most));
  }

  void fitLeavesTheStripsAlone() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    QTRY_VERIFY(window.session()->counts().pending == 0);
    NoticeBar* const strip = part<MapOverlay>(window)->safetyNotice();
    const auto tall = [&](int px) {
      strip->setMinimumHeight(px);
      strip->setNotice(Mark::Bad, QStringLiteral("Emergency stop"), {}, false);
      part<MapOverlay>(window)->layOut();
    };
    // A map that is taller than wide, so that its top would reach under the strip.
    bench.robot->list({test::entry(0, 0, 1, 0, 0), test::entry(0, 1, 1, 0, 60)});
    QTRY_COMPARE(window.session()->counts().shown, 2);
    tall(120);
    bench.key(Qt::Key_F);
    const auto fits = [&](double covered) {
      const auto all = window.session()->contentBounds();
      const auto& view = window.mapScene()->view();
      const double high = view.pixelFromWorld({all.center().x(), all.max_y}).y();
      const double low = view.pixelFromWorld({all.center().x(), all.min_y}).y();
      return high > covered && low < view.height_px &&
             std::abs((high - covered) - (view.height_px - low)) < 1;
    };
    QVERIFY(strip->geometry().bottom() >= 119);
    QVERIFY(fits(strip->geometry().bottom() + 1));
    // Chosen by hand it stays, whatever comes over the map.
    const auto chosen = window.mapScene()->view();
    tall(200);
    QCOMPARE(window.mapScene()->view(), chosen);
  }

  void whatIsFittedAtFirstMakesRoomForAStripThatComesLater() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.robot->list({test::entry(0, 0, 1, 0, 0), test::entry(0, 1, 1, 0, 60)});
    QTRY_COMPARE(window.session()->counts().shown, 2);
    const auto high = [&] {
      const auto all = window.session()->contentBounds();
      return window.mapScene()->view().pixelFromWorld({all.center().x(), all.max_y}).y();
    };
    // While only the poses were known, there was more room around them.
    QTRY_VERIFY(high() < 60);
    NoticeBar* const strip = part<MapOverlay>(window)->safetyNotice();
    const auto show = [&](int px) {
      strip->setMinimumHeight(px);
      strip->setNotice(Mark::Bad, QStringLiteral("Emergency stop"), {}, false);
      part<MapOverlay>(window)->layOut();
    };
    show(120);
    QTRY_VERIFY(high() > 120);
    // A strip that goes is no reason to move the map.
    const auto lower = window.mapScene()->view();
    strip->setNotice(Mark::None, {}, {});
    part<MapOverlay>(window)->layOut();
    QCOMPARE(window.mapScene()->view(), lower);
    // Never under the cursor.
    const QPoint at(200, 300);
    QMouseEvent move(QEvent::MouseMove, at, window.view()->viewport()->mapToGlobal(at), Qt::NoButton,
                     Qt::NoButton, {});
    QApplication::sendEvent(window.view()->viewport(), &move);
    show(200);
    QCOMPARE(window.mapScene()->view(), lower);
  }

  void aPanelThatOpensLeavesTheMapUnderTheCursor() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    window.addDockWidget(Qt::LeftDockWidgetArea, part<LayersDock>(window));
    QCoreApplication::processEvents();
    window.view()->lookAt({3, 4});
    const auto world = [&] {  // of a place on the screen
      const QPoint global = window.mapToGlobal(QPoint(600, 250));
      return window.view()->worldAt(window.view()->viewport()->mapFromGlobal(global));
    };
    const Eigen::Vector2d before = world();
    const QSize size = window.view()->size();
    part<MessagesDock>(window)->show();
    QTRY_VERIFY(window.view()->size() != size);
    QVERIFY((world() - before).norm() < 1e-6);
    part<LayersDock>(window)->hide();
    part<MapsDock>(window)->hide();
    QCoreApplication::processEvents();
    QVERIFY((world() - before).norm() < 1e-6);
    part<MessagesDock>(window)->hide();
    QTRY_VERIFY(window.view()->height() >= size.height());
    QVERIFY((world() - before).norm() < 1e-6);
    // With the window it grows around the middle.
    const Eigen::Vector2d middle = window.mapScene()->view().center_m;
    window.resize(window.width() + 120, window.height());
    QCoreApplication::processEvents();
    QVERIFY((window.mapScene()->view().center_m - middle).norm() < 1e-6);
  }

  void followsTheRobotUntilPanned() {
    Bench bench;
    bench.prepare = [](test::FakeRobot& made) { made.has_live = true; };
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
    QTRY_VERIFY(window.session()->counts().pending == 0 && window.mapScene()->settled());
    window.installEventFilter(&layouts);
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
      dock->installEventFilter(&layouts);
      dock->widget()->installEventFilter(&layouts);
    }
    // Until what the map itself has changed in the docks has come to rest. QTRY_VERIFY would ask once
    // more after the answer was yes, and asking lets further events in.
    const auto rests = [&] {
      layouts.requests = 0;
      QCoreApplication::processEvents();
      QCoreApplication::sendPostedEvents();
      return layouts.requests == 0;
    };
    QVERIFY(QTest::qWaitFor(rests, 30'000));
    for (int i = 0; i < 90; ++i) {
      bench.robot->say(map::TrackedPose{{i * 0.1, 0, 0}});
      QCoreApplication::sendPostedEvents();  // no timers: only what a pose itself causes
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
    QVERIFY(part<WindowStatusBar>(window)->cursorShown().startsWith(QLatin1String("x -2.5")));
    QTRY_VERIFY2(part<WindowStatusBar>(window)->occupancyShown().startsWith(QLatin1String("free")),
                 qPrintable(part<WindowStatusBar>(window)->occupancyShown()));
    hover(middle + QPoint(0, 150));  // 7.5 m further down lies nothing
    QTRY_COMPARE(part<WindowStatusBar>(window)->occupancyShown(), QStringLiteral("unknown"));
    QCOMPARE(part<WindowStatusBar>(window)->scaleShown().section(QLatin1String("  "), 1),
             QStringLiteral("5 cm/px"));
  }

  void layersFollowTheScene() {
    Bench bench;
    MainWindow& window = bench.open();
    QTest::mouseClick(part<LayersDock>(window)->eye(ui::scene::Layer::Trail), Qt::LeftButton);
    QVERIFY(!window.mapScene()->layerVisible(ui::scene::Layer::Trail));
    part<LayersDock>(window)->opacity(ui::scene::Layer::Submaps)->setValue(40);
    QCOMPARE(window.mapScene()->layerOpacity(ui::scene::Layer::Submaps), 0.4);
    window.mapScene()->setLayerVisible(ui::scene::Layer::Ids, true);
    QVERIFY(bench.action("showIds")->isChecked());
    QVERIFY(part<LayersDock>(window)->eye(ui::scene::Layer::Ids)->isChecked());
  }

  void takesPictures() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    const QString path = bench.folder.filePath(QStringLiteral("map.png"));
    QVERIFY(!part<ExportController>(window)->saveMapPicture(path));
    const QImage saved(path);
    QCOMPARE(saved.size(), window.view()->viewport()->size());
    QVERIFY(part<ExportController>(window)->saveMapPicture(
        bench.folder.filePath(QStringLiteral("none/map.png"))));
    bench.action("screenshotCopy")->trigger();
    QVERIFY(!QApplication::clipboard()->image().isNull());
    QVERIFY(part<MapOverlay>(window)->toasts()->texts().contains(QStringLiteral("Picture copied")));
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
    QTRY_COMPARE(window.session()->submaps().find({0, 0})->shown_version, 2);
    QTRY_COMPARE(window.session()->counts().pending, 0);
    QVERIFY((window.mapScene()->view().center_m - Eigen::Vector2d(-100, -100)).norm() < 1e-9);
    bench.key(Qt::Key_F);
    QVERIFY((window.mapScene()->view().center_m - window.session()->contentBounds().center()).norm() < 1e-6);
  }
};

}  // namespace test_window_map

MAPWRIGHT_TEST(test_window_map, TestWindowMap, Widgets)
#include "test_window_map.moc"
