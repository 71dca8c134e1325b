// The layouts of the window, its columns, and the keyboard.
#include <QAccessible>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QStandardItemModel>
#include <QStatusBar>
#include <QTabBar>
#include <QTableView>
#include <QToolBar>
#include <QToolButton>
#include <QtTest>

#include "test_program.h"
#include "ui/kit/name_column.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/wrapping_row.h"
#include "ui/layers/layers_dock.h"
#include "ui/maps/maps_dock.h"
#include "ui/objects/objects_model.h"
#include "ui/replay/events_dock.h"
#include "ui/robot/connection_chip.h"
#include "ui/robot/problems_dock.h"
#include "ui/robot/problems_model.h"
#include "ui/robot/robot_dock.h"
#include "ui/shell/notices.h"
#include "ui/shell/window_status_bar.h"
#include "ui/slam/inspector_dock.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/notice_bar.h"
#include "ui/view/toast_stack.h"
#include "ui/waypoints/waypoints_controller.h"
#include "ui/waypoints/waypoints_dock.h"
#include "ui/window/layout_controller.h"
#include "ui/window/main_window.h"
#include "waypoints_desk.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_layouts {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;
using test::kAddress;
using test::WaypointsDesk;

namespace {

const char* const kLayouts[] = {"layoutOperate", "layoutInspect", "layoutReplay"};

/// A layout in its first state, laid out.
void showAnew(Bench& bench, const char* layout) {
  bench.action(layout)->trigger();
  bench.action("resetLayout")->trigger();
  QCoreApplication::processEvents();
  QCoreApplication::processEvents();
}

bool inFront(const QWidget* dock) { return dock->isVisible() && !dock->visibleRegion().isEmpty(); }

std::vector<QDockWidget*> docksOf(MainWindow& window) {
  std::vector<QDockWidget*> docks;
  for (QDockWidget* dock : window.findChildren<QDockWidget*>()) docks.push_back(dock);
  return docks;
}

QToolBar* barOf(MainWindow& window) { return window.findChild<QToolBar*>(QStringLiteral("tools")); }

bool stopsTab(const QWidget* widget) {
  return (widget->focusPolicy() & Qt::TabFocus) && widget->isVisible() && widget->isEnabled();
}

/// The controls of a window that say nothing to those who cannot see them.
QStringList unnamed(QWidget& window) {
  QStringList found;
  QList<QWidget*> all = window.findChildren<QWidget*>();
  all << &window;
  for (QWidget* widget : all) {
    const bool control = widget->focusPolicy() != Qt::NoFocus || qobject_cast<QAbstractButton*>(widget);
    // Parts of a control, which has the name.
    bool part = false;
    for (const QWidget* above = widget->parentWidget(); above && !part; above = above->parentWidget())
      part = above->inherits("QAbstractSpinBox") || above->inherits("QComboBox") ||
             above->inherits("QTabBar") || above->inherits("QLineEdit") ||
             above->inherits("QCalendarWidget") || above->inherits("QMenu");
    const bool frame = widget->inherits("QScrollBar") || widget->inherits("QHeaderView") ||
                       widget->inherits("QMenu") || widget->inherits("QMenuBar") ||
                       widget->inherits("QComboBoxPrivateContainer") || widget->inherits("QLabel") ||
                       widget->inherits("QTableCornerButton") || widget->inherits("QSplitterHandle") ||
                       widget->inherits("QDialogButtonBox") || widget->inherits("QSizeGrip") ||
                       qstrcmp(widget->metaObject()->className(), "QScrollArea") == 0;
    const bool says_nothing_yet =
        widget->isHidden() && (qobject_cast<QAbstractButton*>(widget) || qobject_cast<QTabBar*>(widget));
    if (!control || part || frame || says_nothing_yet || widget->focusProxy() ||
        (widget->isWindow() && !widget->windowTitle().isEmpty()))
      continue;
    QAccessibleInterface* const face = QAccessible::queryAccessibleInterface(widget);
    if (face && !face->text(QAccessible::Name).trimmed().isEmpty()) continue;
    QString path =
        QString::fromLatin1(widget->metaObject()->className()) + QLatin1Char(' ') + widget->objectName();
    for (const QWidget* above = widget->parentWidget(); above; above = above->parentWidget())
      path.prepend(QString::fromLatin1(above->metaObject()->className()) + QLatin1Char('/'));
    found << path;
  }
  return found;
}

}  // namespace

class TestWindowLayouts : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theMapKeepsMostOfASmallScreen_data() {
    QTest::addColumn<QByteArray>("layout");
    QTest::addColumn<double>("part");
    QTest::newRow("operate") << QByteArray("layoutOperate") << 0.6;
    QTest::newRow("inspect") << QByteArray("layoutInspect") << 0.6;
    QTest::newRow("replay") << QByteArray("layoutReplay") << 0.4;
  }
  void theMapKeepsMostOfASmallScreen() {
    QFETCH(QByteArray, layout);
    QFETCH(double, part);
    Bench bench;
    MainWindow& window = bench.open({1366, 768});
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    showAnew(bench, layout);
    QCOMPARE(window.size(), QSize(1366, 768));
    const double kept = double(window.view()->width()) * window.view()->height() / (1366.0 * 768);
    QVERIFY2(kept >= part, qPrintable(QStringLiteral("%1 x %2: %3")
                                          .arg(window.view()->width())
                                          .arg(window.view()->height())
                                          .arg(kept)));
  }

  void whatSavesIsInViewInEveryLayoutOfASmallScreen() {
    WaypointsDesk desk;
    desk.start();
    desk.window->resize(1366, 768);
    for (const char* layout : kLayouts) {
      showAnew(desk, layout);
      desk.bringUp();
      const QPushButton* const save = desk.dock().saveButton();
      QTRY_VERIFY2(save->visibleRegion().boundingRect() == save->rect(), layout);
    }
  }

  void everyTabCanBeRead_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("small") << QSize(1366, 768);
    QTest::newRow("usual") << QSize(1920, 1080);
    QTest::newRow("large") << QSize(3840, 2160);
  }
  void everyTabCanBeRead() {
    QFETCH(QSize, size);
    Bench bench;
    MainWindow& window = bench.open(size);
    for (const char* layout : kLayouts) {
      showAnew(bench, layout);
      int tabs = 0;
      for (const QTabBar* bar : window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) {
        if (!bar->isVisible()) continue;
        for (int i = 0; i < bar->count(); ++i, ++tabs) {
          QVERIFY2(bar->rect().contains(bar->tabRect(i)),
                   qPrintable(QLatin1String(layout) + bar->tabText(i)));
          QVERIFY2(bar->tabRect(i).width() > bar->fontMetrics().horizontalAdvance(bar->tabText(i)),
                   qPrintable(bar->tabText(i)));
        }
      }
      QVERIFY2(tabs >= 2 || size.height() > 1000, layout);
    }
  }

  void everyDockCanBeReachedInEveryLayout() {
    Bench bench;
    MainWindow& window = bench.open();
    for (const char* layout : kLayouts) {
      showAnew(bench, layout);
      for (QDockWidget* dock : docksOf(window)) {
        QAction* const toggle = dock->toggleViewAction();
        if (!inFront(dock)) toggle->trigger();  // also if it is open, behind another
        QTRY_VERIFY2(inFront(dock), qPrintable(QLatin1String(layout) + dock->objectName()));
        toggle->trigger();
        QVERIFY2(!dock->isVisible(), qPrintable(dock->objectName()));
      }
    }
  }

  void theFirstStartGoesByWhatWasOpened() {
    {
      WaypointsDesk desk;
      desk.start();
      QCOMPARE(part<LayoutController>(*desk.window)->role(), Role::Operate);
      QTRY_VERIFY(inFront(&desk.dock()));
      desk.window->close();
    }
    Bench bench;
    MainWindow& window = bench.open();
    QCOMPARE(part<LayoutController>(window)->role(), Role::Inspect);
    QVERIFY(!window.connectTo(kAddress));
    QCOMPARE(part<LayoutController>(window)->role(), Role::Inspect);
    QTRY_VERIFY(inFront(part<InspectorDock>(window)));
  }

  void whatFailedDecidesNothing() {
    WaypointsDesk desk;
    MainWindow& window = desk.open();
    const auto prepare = desk.prepare;
    desk.prepare = [](test::FakeRobot& made) { made.auto_online = false; };
    QVERIFY(!window.connectTo(kAddress));
    QCOMPARE(part<LayoutController>(window)->role(), Role::Inspect);
    desk.prepare = prepare;
    QVERIFY(!window.connectTo(kAddress));
    QCOMPARE(part<LayoutController>(window)->role(), Role::Operate);
    // What is opened afterwards leaves it.
    desk.prepare = {};
    QVERIFY(!window.connectTo(kAddress));
    QCOMPARE(part<LayoutController>(window)->role(), Role::Operate);
  }

  void theFocusStaysWhereItCanBeSeen() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    showAnew(bench, "layoutInspect");
    QLineEdit* const filter = part<InspectorDock>(window)->filterEdit();
    filter->setFocus();
    for (int turn = 0; turn < 2; ++turn) {  // arranged, then restored
      bench.action("layoutReplay")->trigger();
      QCoreApplication::processEvents();
      QCoreApplication::processEvents();
      QCOMPARE(window.focusWidget(), static_cast<QWidget*>(window.view()));
      bench.action("layoutInspect")->trigger();
      QCoreApplication::processEvents();
      QCoreApplication::processEvents();
      QCOMPARE(window.focusWidget(), static_cast<QWidget*>(window.view()));
      filter->setFocus();
    }
    auto* const chip = part<ConnectionChip>(window);
    chip->setFocus();
    bench.action("layoutOperate")->trigger();
    QCoreApplication::processEvents();
    QCOMPARE(window.focusWidget(), static_cast<QWidget*>(chip));
  }

  void whatIsChosenIsStoredBeforeTheEnd() {
    Bench bench;
    MainWindow& window = bench.open();
    const auto stored = [&](const char* key) {
      bench.settings.sync();
      return QSettings(bench.settings.fileName(), QSettings::IniFormat).value(QLatin1String(key));
    };
    bench.key(Qt::Key_3, Qt::ControlModifier);
    QTRY_COMPARE(stored("layout/role").toString(), QStringLiteral("replay"));
    QVERIFY(!stored("layout/replay").toByteArray().isEmpty());
    QVERIFY(stored("window/geometry").isValid());
    QAction* const dark = bench.action("themeDark");
    dark->trigger();
    bench.key(Qt::Key_G);
    QTRY_COMPARE(stored("view/theme").toString(), QStringLiteral("dark"));
    QVERIFY(window.isVisible());
  }

  void otherPanelsOpenWhereThereIsTheMostRoom() {
    Bench bench;
    MainWindow& window = bench.open({1920, 1080});
    showAnew(bench, "layoutOperate");
    QDockWidget* const overlays = window.findChild<QDockWidget*>(QStringLiteral("overlays"));
    overlays->toggleViewAction()->trigger();
    QTRY_VERIFY(inFront(overlays));
    QVERIFY2(overlays->height() > 450, qPrintable(QString::number(overlays->height())));
    QVERIFY(inFront(part<RobotDock>(window)));
  }

  void laterTheUsersChoiceStands() {
    WaypointsDesk desk;
    {
      MainWindow& window = desk.open();
      QTest::keyClick(&window, Qt::Key_2, Qt::ControlModifier);
      QVERIFY(!window.connectTo(kAddress));
      QCOMPARE(part<LayoutController>(window)->role(), Role::Inspect);
      window.close();
    }
    MainWindow& again = desk.open();
    QVERIFY(!again.connectTo(kAddress));
    QCOMPARE(part<LayoutController>(again)->role(), Role::Inspect);
    QVERIFY(desk.action("layoutInspect")->isChecked() && !desk.action("layoutOperate")->isChecked());
  }

  void eachIsRememberedAndResetByItself() {
    Bench bench;
    {
      MainWindow& window = bench.open();
      showAnew(bench, "layoutOperate");
      part<MapsDock>(window)->close();
      showAnew(bench, "layoutInspect");
      part<LayersDock>(window)->close();
      bench.action("layoutOperate")->trigger();
      QVERIFY(!part<MapsDock>(window)->isVisible());
      QVERIFY(!part<LayersDock>(window)->isVisible());  // it is not a part of this one
      window.close();
    }
    MainWindow& again = bench.open();
    QCOMPARE(part<LayoutController>(again)->role(), Role::Operate);
    QVERIFY(!part<MapsDock>(again)->isVisible());
    bench.action("layoutInspect")->trigger();
    QVERIFY(!part<LayersDock>(again)->isVisible());
    bench.action("resetLayout")->trigger();
    QVERIFY(part<LayersDock>(again)->isVisible());
    bench.action("layoutOperate")->trigger();
    QVERIFY(!part<MapsDock>(again)->isVisible());
  }

  void theLayoutOfAnEarlierVersionIsNoTrouble() {
    Bench bench;
    {
      // One that had other docks, and nonsense.
      QMainWindow old;
      auto* const dock = new QDockWidget(QStringLiteral("Layers"), &old);
      dock->setObjectName(QStringLiteral("layers"));
      old.addDockWidget(Qt::RightDockWidgetArea, dock);
      bench.settings.setValue(QStringLiteral("window/state"), old.saveState(7));
      bench.settings.setValue(QStringLiteral("layout/inspect"), QByteArray("nonsense"));
      bench.settings.setValue(QStringLiteral("layout/role"), QStringLiteral("nobody"));
    }
    MainWindow& window = bench.open();
    QCOMPARE(part<LayoutController>(window)->role(), Role::Inspect);
    QTRY_VERIFY(inFront(part<InspectorDock>(window)) && inFront(part<LayersDock>(window)));
    window.close();
    QVERIFY(!bench.settings.contains(QStringLiteral("window/state")));
  }

  void theWindowFitsTheScreenWithAnyDockAnywhere() {
    Bench bench;
    MainWindow& window = bench.open();
    showAnew(bench, "layoutOperate");
    for (QDockWidget* dock : docksOf(window)) {
      dock->show();
      const int least = dock->minimumSizeHint().width();
      QVERIFY2(least <= 400, qPrintable(QStringLiteral("%1 %2").arg(dock->objectName()).arg(least)));
    }
    // All of them side by side with the map: the least that they need, not what they would like.
    for (QDockWidget* dock : docksOf(window)) window.addDockWidget(Qt::RightDockWidgetArea, dock);
    QTRY_VERIFY2(window.minimumSizeHint().width() <= 1366,
                 qPrintable(QString::number(window.minimumSizeHint().width())));
  }

  void textsKeepTheirMarginsInEveryTheme() {
    WaypointsDesk desk;
    desk.start();
    desk.bringUp();
    const auto inset = [&] {
      int count = 0;
      for (const QLabel* label : desk.dock().findChildren<QLabel*>())
        count += label->contentsMargins().left() == 8;
      return count;
    };
    QCOMPARE(inset(), 2);
    for (const char* theme : {"themeDark", "themeLight"}) {
      desk.action(theme)->trigger();
      QCOMPARE(inset(), 2);
    }
  }

  void tabsThatFindNoRoomAreListed() {
    Bench bench;
    MainWindow& window = bench.open({1366, 768});
    showAnew(bench, "layoutOperate");
    for (QDockWidget* dock : docksOf(window)) {
      if (window.dockWidgetArea(dock) == Qt::RightDockWidgetArea) dock->show();
    }
    QDockWidget* const waypoints = window.findChild<QDockWidget*>(QStringLiteral("waypoints"));
    waypoints->raise();
    QTabBar* tabs = nullptr;
    const auto found = [&] {
      for (QTabBar* bar : window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) {
        if (bar->isVisible() && bar->count() > 4) tabs = bar;
      }
      return tabs != nullptr;
    };
    QTRY_VERIFY(found());
    auto* const all = tabs->findChild<QToolButton*>(QStringLiteral("allTabs"));
    QTRY_VERIFY(all && all->isVisible());
    QVERIFY(tabs->rect().contains(all->geometry()));
    Q_EMIT all->menu()->aboutToShow();
    QCOMPARE(int(all->menu()->actions().size()), tabs->count());
    const int last = tabs->count() - 1;
    QVERIFY(!all->menu()->actions()[last]->isChecked());
    all->menu()->actions()[last]->trigger();
    QCOMPARE(tabs->currentIndex(), last);
    QTRY_VERIFY(!inFront(waypoints));
    // The one in front can be read, beside the button.
    QTRY_VERIFY(tabs->tabRect(last).right() <= all->geometry().left() + 1);
  }

  void theWindowFitsASmallScreen_data() {
    QTest::addColumn<QByteArray>("layout");
    for (const char* layout : kLayouts) QTest::newRow(layout) << QByteArray(layout);
  }
  void theWindowFitsASmallScreen() {
    QFETCH(QByteArray, layout);
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open({800, 570});
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    showAnew(bench, layout);
    QString needs;
    for (QWidget* part : window.findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
      const QSize least = part->minimumSizeHint().expandedTo(part->minimumSize());
      if (part->isVisible())
        needs += QStringLiteral("%1 %2: %3 x %4; ")
                     .arg(QLatin1String(part->metaObject()->className()), part->objectName())
                     .arg(least.width())
                     .arg(least.height());
    }
    const QSize least = window.minimumSizeHint();
    QVERIFY2(least.width() <= 800 && least.height() <= 570,
             qPrintable(QStringLiteral("%1 x %2 %3").arg(least.width()).arg(least.height()).arg(needs)));
    QCOMPARE(window.size(), QSize(800, 570));
    QVERIFY2(window.view()->width() >= 300 && window.view()->height() >= 200,
             qPrintable(QStringLiteral("%1 x %2").arg(window.view()->width()).arg(window.view()->height())));
  }

  void noTextThatComesAndGoesWidensTheWindow_data() { theWindowFitsASmallScreen_data(); }
  void noTextThatComesAndGoesWidensTheWindow() {
    QFETCH(QByteArray, layout);
    Bench bench;
    bench.prepare = [](test::FakeRobot& made) {
      made.has_live = made.has_catalogue = true;
      made.maps.entries = {test::catalogued("1", "A map whose name is longer than that of any other map")};
      made.maps.entries[0].is_current = true;
    };
    MainWindow& window = bench.open({800, 570});
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    showAnew(bench, layout);
    const QString longest =
        QStringLiteral("nothing for 12 min 34 s, as nobody would ever have thought ").repeated(4);
    part<ConnectionChip>(window)->setSafety({Mark::Bad, false, longest, longest, longest});
    part<ConnectionChip>(window)->setRobot(longest, Mark::Busy, longest, longest);
    map::AlertsMessage alerts;
    for (int code = 6000; code < 6020; ++code)
      alerts.alerts.push_back({code, map::AlertLevel::Error, longest.toStdString(), 0});
    bench.robot->say(alerts);
    bench.robot->goAway(longest);
    bench.action("compare")->trigger();
    for (const auto rank : {NoticeRank::Link, NoticeRank::Replay})
      part<Notices>(window)->set(rank, {Mark::Bad, longest, longest, {}, true});
    for (auto* label : window.findChildren<PlainLabel*>()) label->setText(longest);
    for (auto* label : window.findChildren<StateLabel*>()) label->setState({Mark::Warning, longest});
    for (QWidget* part : window.statusBar()->findChildren<QWidget*>()) {
      part->show();
      if (auto* const button = qobject_cast<QToolButton*>(part)) button->setText(longest);
    }
    // Laid out, and nothing else: the window itself would soon say something shorter.
    for (int turn = 0; turn < 4; ++turn) QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    QVERIFY2(window.minimumSizeHint().width() <= 800,
             qPrintable(QString::number(window.minimumSizeHint().width())));
    QCOMPARE(window.size(), QSize(800, 570));
    // Nothing in the bar lies over anything else; bars and what is under the cursor give way to the rest.
    std::map<int, QRect> boxes;
    QStringList said;
    for (QWidget* part : window.statusBar()->findChildren<QWidget*>()) {
      if (!part->isVisible() || part->layout() || part->width() == 0) continue;
      boxes[part->x()] = part->geometry();
      said << QStringLiteral("%1 at %2").arg(part->width()).arg(part->x());
    }
    int right = 0;
    for (const auto& [left, box] : boxes) {
      QVERIFY2(left >= right && box.width() >= 20, qPrintable(said.join(QLatin1String(", "))));
      right = box.right() + 1;
    }
    QVERIFY2(boxes.size() >= 8 && right <= 800, qPrintable(said.join(QLatin1String(", "))));
  }

  void messagesFitTheMapOfASmallScreen() {
    Bench bench;
    MainWindow& window = bench.open({800, 570});
    showAnew(bench, "layoutInspect");
    ToastStack* const toasts = part<MapOverlay>(window)->toasts();
    const QString text =
        QStringLiteral("The layout Replay has the timeline and all the rest of it. ").repeated(2);
    toasts->add(Mark::Warning, text, {QStringLiteral("Show all of them"), [] {}});
    toasts->add(Mark::Warning, text);
    QTRY_VERIFY(toasts->isVisible());
    QVERIFY2(toasts->x() >= 0, qPrintable(QString::number(toasts->x())));
    QVERIFY(toasts->geometry().right() < window.view()->width());
  }

  void alertsMoveNoTool() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    showAnew(bench, "layoutOperate");
    const auto boxes = [&] {
      QList<QRect> all;
      for (QAction* action : barOf(window)->actions())
        all << barOf(window)->widgetForAction(action)->geometry();
      return all;
    };
    const QList<QRect> before = boxes();
    auto* const chip = part<ConnectionChip>(window);
    chip->setSafety({Mark::Bad, false, QStringLiteral("Emergency stop +12"), {}, QStringLiteral("x")});
    QCoreApplication::processEvents();
    QCOMPARE(boxes(), before);
    chip->setRobot(QStringLiteral("A robot whose name is longer than any other"), Mark::Busy,
                   QStringLiteral("reconnecting"), {});
    QCoreApplication::processEvents();
    QCOMPARE(boxes(), before);
  }

  void toolsHaveTextWhereThereIsRoom() {
    Bench bench;
    MainWindow& window = bench.open({1366, 768});
    const auto texts = [&] {
      int count = 0;
      for (QAction* action : barOf(window)->actions()) {
        const auto* const button = qobject_cast<QToolButton*>(barOf(window)->widgetForAction(action));
        count +=
            button && !action->icon().isNull() && button->toolButtonStyle() == Qt::ToolButtonTextBesideIcon;
      }
      return count;
    };
    for (const char* layout : kLayouts) {
      showAnew(bench, layout);
      const int usual = texts();
      QVERIFY2(usual >= 3, layout);
      QVERIFY(barOf(window)->layout()->sizeHint().width() <=
              barOf(window)->width());  // none is in an overflow
    }
    showAnew(bench, "layoutInspect");
    const int usual = texts();
    window.resize(1920, 768);
    QTRY_VERIFY(texts() > usual);
    window.resize(1000, 768);
    QTRY_VERIFY(texts() < usual);
  }

  void namesGiveWayLast() {
    QStandardItemModel model(3, 4);
    model.setHorizontalHeaderLabels({QStringLiteral("n"), QStringLiteral("Name"), QStringLiteral("x"),
                                     QStringLiteral("Outcome of it all")});
    const QString name = QStringLiteral("Renamed by the night shift");
    for (int row = 0; row < 3; ++row) {
      model.setItem(row, 0, new QStandardItem(QString::number(row)));
      model.setItem(row, 1, new QStandardItem(name));
      model.setItem(row, 2, new QStandardItem(QStringLiteral("12.345")));
    }
    QTableView table;
    table.setModel(&model);
    table.verticalHeader()->hide();
    QHeaderView& header = *table.horizontalHeader();
    header.resizeSection(0, 60);
    header.resizeSection(2, 80);
    header.resizeSection(3, 200);
    auto* const columns = new NameColumn(&table, &header, 1, {{2}, {0}, {3, 30}});
    table.resize(900, 200);
    table.show();
    columns->fit();
    QCOMPARE(header.sectionSize(2), 80);
    QVERIFY(header.sectionSize(1) >= columns->wanted());
    // What is empty gives its room first.
    table.resize(columns->wanted() + 60 + 80 + 150, 200);
    columns->fit();
    QVERIFY(header.sectionSize(1) >= columns->wanted());
    QVERIFY(header.sectionSize(3) < 200 && !header.isSectionHidden(2));
    table.resize(columns->wanted() + 60 + 40, 200);
    columns->fit();
    QVERIFY(header.isSectionHidden(2));
    QVERIFY(header.sectionSize(1) >= columns->wanted());
    table.resize(900, 200);
    columns->fit();
    QVERIFY(!header.isSectionHidden(2));
    QCOMPARE(header.sectionSize(2), 80);
  }

  void namesGiveWayLastInEveryTable() {
    WaypointsDesk desk;
    desk.store.points = {test::waypoint("a", 1, 1, "Renamed by the night shift"),
                         test::waypoint("b", 3, 2, "Group room on the ground floor")};
    desk.start();
    MainWindow& window = *desk.window;
    int tables = 0;
    for (QTableView* table : window.findChildren<QTableView*>()) {
      auto* const columns = table->findChild<NameColumn*>({}, Qt::FindDirectChildrenOnly);
      if (!columns) {
        // Every column there is a number.
        const QStringList numbers{QStringLiteral("Projections"), QStringLiteral("Pairs of points"),
                                  QStringLiteral("Points of the overlay")};
        QVERIFY2(numbers.contains(table->accessibleName()), qPrintable(table->accessibleName()));
        continue;
      }
      ++tables;
      // What is hidden is not laid out.
      for (QWidget* above = table; above; above = above->parentWidget()) {
        if (qobject_cast<QDockWidget*>(above)) {
          above->show();
          above->raise();
        }
      }
      QCoreApplication::processEvents();
      QHeaderView& header = *table->horizontalHeader();
      for (const int width : {900, 380, 300, 220}) {
        table->resize(width, 200);
        columns->fit();
        const bool all = header.sectionSize(columns->column()) >= columns->wanted();
        const bool alone = std::all_of(
            columns->beside().begin(), columns->beside().end(),
            [&](const auto& beside) { return header.isSectionHidden(beside.column) || !beside.may_go; });
        const bool usual =
            header.sectionSize(columns->column()) >= 32 * table->fontMetrics().averageCharWidth();
        QStringList sizes;
        for (int i = 0; i < header.count(); ++i) sizes << QString::number(header.sectionSize(i));
        QVERIFY2(all || alone || usual,
                 qPrintable(QStringLiteral("%1 in %2: %3, wanted %4")
                                .arg(table->accessibleName(), QString::number(table->viewport()->width()),
                                     sizes.join(QLatin1Char(' ')), QString::number(columns->wanted()))));
        QVERIFY2(header.length() <= table->viewport()->width() || alone, qPrintable(table->accessibleName()));
      }
    }
    QVERIFY2(tables >= 6, qPrintable(QString::number(tables)));
    QTableView& waypoints = *desk.dock().table();
    auto* const columns = waypoints.findChild<NameColumn*>();
    waypoints.resize(300, 200);
    columns->fit();
    QVERIFY(waypoints.columnWidth(WaypointsModel::NameColumn) >= columns->wanted());
  }

  // The style keeps a copy of each picture that a cell gives it.
  void picturesInTablesAreMadeOnce() {
    WaypointsDesk desk;
    desk.store.points = {test::waypoint("a", 1, 1, "Hall"), test::waypoint("b", 3, 2, "Lift")};
    desk.start();
    for (QDockWidget* dock : docksOf(*desk.window)) dock->show();
    const auto* const objects = part<ObjectsModel>(*desk.window);
    QTRY_VERIFY(objects->rowCount() > 0);
    WaypointEditing& editing = *part<WaypointsController>(*desk.window)->editing();
    QTRY_VERIFY(editing.editable());
    editing.selectAll();
    editing.moveSelected({1, 1});
    int seen = 0;
    for (const QTableView* table : desk.window->findChildren<QTableView*>()) {
      const QStringList twice = picturesMadeTwice(*table->model(), seen);
      QVERIFY2(twice.isEmpty(),
               qPrintable(table->accessibleName() + QLatin1Char(' ') + twice.join(QLatin1Char(' '))));
    }
    QVERIFY(seen >= objects->rowCount() + 2);
  }

  // Qt makes wider ones, which it never deletes, where they are a single pixel.
  void linesBetweenDocksAreNoWidgets() {
    Bench bench;
    MainWindow& window = bench.open();
    for (QDockWidget* dock : docksOf(window)) {
      dock->show();
      QCoreApplication::processEvents();
      dock->hide();
    }
    QVERIFY(window.findChildren<QWidget*>(QStringLiteral("qt_qmainwindow_extended_splitter")).isEmpty());
  }

  void aProblemKeepsItsMarkAndItsTime() {
    Bench bench;
    MainWindow& window = bench.open();
    auto* const problems = part<ProblemsDock>(window);
    problems->show();
    problems->raise();
    QVERIFY(!window.connectTo(kAddress));
    bench.robot->failing = {{0, 0}};
    bench.robot->list({test::entry(0, 0, 1, 0, 0)});
    QTRY_COMPARE(problems->model()->rowCount(), 1);
    auto* const table = problems->findChild<QTableView*>();
    table->resize(220, 200);
    table->findChild<NameColumn*>()->fit();
    QVERIFY(!table->isColumnHidden(ProblemsModel::TimeColumn));
    QVERIFY(table->isColumnHidden(ProblemsModel::DurationColumn));
  }

  void aRowOfToolsContinuesBelow() {
    QWidget box;
    auto* const row = new WrappingRow;
    box.setLayout(row);
    auto* const search = new QLineEdit(&box);
    row->add(search, 1, 120);
    std::vector<QToolButton*> buttons;
    for (int i = 0; i < 3; ++i) {
      buttons.push_back(new QToolButton(&box));
      buttons.back()->setFixedSize(100, 24);
      row->add(buttons.back());
    }
    box.resize(600, 100);
    box.show();
    QTRY_COMPARE(buttons[2]->y(), buttons[0]->y());
    QVERIFY(search->width() > 200);
    QCOMPARE(buttons[2]->geometry().right(), 600 - 8 - 1);
    box.resize(250, 100);
    QTRY_VERIFY(buttons[2]->y() > buttons[0]->y());
    QVERIFY(search->width() >= 120);
    QVERIFY(row->heightForWidth(250) > row->heightForWidth(600));
    QVERIFY(row->minimumSize().width() <= 120 + 16);
  }

  void f6GoesAroundBothWays() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    showAnew(bench, "layoutInspect");
    bench.robot->goAway(QStringLiteral("gone"));  // a strip with a button
    window.view()->setFocus();
    const auto pane = [&]() -> QWidget* {
      QWidget* at = QApplication::focusWidget();
      while (at && at != window.view() && !qobject_cast<QDockWidget*>(at) && !qobject_cast<QToolBar*>(at) &&
             !qobject_cast<NoticeBar*>(at) && !qobject_cast<QStatusBar*>(at))
        at = at->parentWidget();
      return at;
    };
    const auto around = [&](Qt::KeyboardModifiers modifiers) {
      QList<QWidget*> seen;
      for (int i = 0; i < 20; ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, modifiers);
        seen << pane();
        if (pane() == window.view()) break;
      }
      return seen;
    };
    QList<QWidget*> there = around({}), back = around(Qt::ShiftModifier);
    QCOMPARE(there.last(), window.view());
    for (QWidget* wanted :
         {static_cast<QWidget*>(part<LayersDock>(window)), static_cast<QWidget*>(part<InspectorDock>(window)),
          static_cast<QWidget*>(barOf(window)), static_cast<QWidget*>(part<MapOverlay>(window)->notice())})
      QVERIFY2(there.contains(wanted), wanted->metaObject()->className());
    there.removeLast();
    back.removeLast();
    std::reverse(back.begin(), back.end());
    QCOMPARE(back, there);
    // It remembers where it was.
    QLineEdit* const filter = part<InspectorDock>(window)->filterEdit();
    filter->setFocus();
    QTest::keyClick(filter, Qt::Key_F6, Qt::ShiftModifier);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6);
    QCOMPARE(QApplication::focusWidget(), filter);
  }

  void tabLeavesTheMapBothWays() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    showAnew(bench, "layoutInspect");
    for (const Qt::KeyboardModifiers modifiers :
         {Qt::KeyboardModifiers(), Qt::KeyboardModifiers(Qt::ShiftModifier)}) {
      window.view()->setFocus();
      QSet<QWidget*> seen;
      for (int i = 0; i < 400; ++i) {
        QTest::keyClick(QApplication::focusWidget(), modifiers ? Qt::Key_Backtab : Qt::Key_Tab, modifiers);
        QWidget* const at = QApplication::focusWidget();
        QVERIFY(at);
        if (at == window.view()) break;
        QVERIFY2(!seen.contains(at), at->metaObject()->className());
        seen.insert(at);
      }
      QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(window.view()));
      QVERIFY(seen.contains(part<InspectorDock>(window)->filterEdit()));
      QVERIFY(seen.contains(part<ConnectionChip>(window)));
      QVERIFY(std::any_of(seen.begin(), seen.end(),
                          [](const QWidget* widget) { return qobject_cast<const QTabBar*>(widget); }));
    }
  }

  void tabFollowsTheEye() {
    WaypointsDesk desk;
    desk.start();
    desk.editing().select({"a"});
    for (QDockWidget* dock : docksOf(*desk.window)) {
      dock->show();
      dock->raise();
      QCoreApplication::processEvents();
      QList<QWidget*> stops;
      for (QWidget* at = dock->nextInFocusChain(); at != dock; at = at->nextInFocusChain())
        if (dock->isAncestorOf(at) && stopsTab(at) && !at->visibleRegion().isEmpty() && !at->focusProxy())
          stops << at;
      for (qsizetype i = 1; i < stops.size(); ++i) {
        const QRect before(stops[i - 1]->mapTo(dock, QPoint()), stops[i - 1]->size());
        const QRect at(stops[i]->mapTo(dock, QPoint()), stops[i]->size());
        const bool same_row = at.center().y() >= before.top() && at.center().y() <= before.bottom();
        const bool inside = stops[i - 1]->isAncestorOf(stops[i]);
        QVERIFY2(inside || at.top() >= before.bottom() || (same_row && at.left() >= before.right()) ||
                     at.left() >= before.right(),
                 qPrintable(QStringLiteral("%1: %2 %3 after %4 %5")
                                .arg(dock->objectName(), QLatin1String(stops[i]->metaObject()->className()),
                                     stops[i]->accessibleName(),
                                     QLatin1String(stops[i - 1]->metaObject()->className()),
                                     stops[i - 1]->accessibleName())));
      }
    }
  }

  void arrowsGoAlongTheToolBar() {
    Bench bench;
    MainWindow& window = bench.open();
    showAnew(bench, "layoutInspect");
    part<ConnectionChip>(window)->setFocus();
    QSet<QWidget*> seen;
    for (int i = 0; i < 40 && !seen.contains(QApplication::focusWidget()); ++i) {
      seen.insert(QApplication::focusWidget());
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
    }
    for (QAction* action : barOf(window)->actions()) {
      auto* const button = qobject_cast<QToolButton*>(barOf(window)->widgetForAction(action));
      if (button && button->isEnabled()) QVERIFY2(seen.contains(button), qPrintable(action->objectName()));
    }
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Left);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);  // at the far end: the palette
    QTRY_VERIFY(window.findChild<QDialog*>());
  }

  void whatARobotCannotDoIsOffAndSaysWhy() {
    Bench bench;
    bench.prepare = [](test::FakeRobot& made) { made.auto_online = false; };
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QVERIFY(bench.action("cloudRegion")->isEnabled());  // not known yet
    bench.robot->goOnline();
    for (const char* id : {"cloudRegion", "cloudSection"}) {
      const QAction& action = *bench.action(id);
      QVERIFY2(!action.isEnabled(), id);
      QVERIFY2(action.toolTip() != action.property("tip").toString(), qPrintable(action.toolTip()));
    }
  }

  void namesSayByThemselvesWhatTheyDo() {
    Bench bench;
    MainWindow& window = bench.open();
    QStringList names;
    for (const Actions::Entry& entry : window.actionList().entries()) names << nameAlone(entry);
    for (const char* name : {"Panel: Maps", "Dark theme", "Layout: Operate", "Normal colours",
                             "Focus the map", "Fit the map", "Zoom to 1:1"})
      QVERIFY2(names.contains(QLatin1String(name)), name);
    QSet<QString> once(names.begin(), names.end());
    QCOMPARE(once.size(), names.size());
  }

  void everyControlHasAName() {
    WaypointsDesk desk;
    desk.start();
    desk.editing().select({"a"});
    for (QDockWidget* dock : docksOf(*desk.window)) dock->show();
    QStringList missing = unnamed(*desk.window);
    // Each command that asks something.
    QTimer looks;
    looks.setInterval(10);
    QSet<QString> dialogs;
    connect(&looks, &QTimer::timeout, this, [&] {
      for (QWidget* top : QApplication::topLevelWidgets()) {
        auto* const dialog = qobject_cast<QDialog*>(top);
        if (!dialog || !dialog->isVisible()) continue;
        if (!dialog->inherits("QFileDialog")) {
          missing += unnamed(*dialog);
          dialogs << dialog->windowTitle();
        }
        dialog->reject();
      }
    });
    looks.start();
    const auto open = [] {
      const QWidgetList all = QApplication::topLevelWidgets();
      return std::any_of(all.begin(), all.end(), [](const QWidget* top) {
        return qobject_cast<const QDialog*>(top) && top->isVisible();
      });
    };
    for (const char* id :
         {"connect", "goTo", "diagnostics", "about", "manual", "shortcuts", "palette", "export", "compare",
          "record", "importWaypoints", "exportWaypoints", "screenshotSave", "openFile", "newByNumbers",
          "snapDistances", "revertWaypoints"}) {
      QAction* const action = desk.action(id);
      if (!action || !action->isEnabled()) continue;
      action->trigger();
      QTRY_VERIFY(!open());
    }
    missing.removeDuplicates();
    QVERIFY2(missing.isEmpty(), qPrintable(missing.join(QLatin1Char('\n'))));
    QVERIFY2(dialogs.size() >= 7, qPrintable(QStringList(dialogs.values()).join(QLatin1Char(','))));
  }
};

}  // namespace test_window_layouts

MAPWRIGHT_TEST(test_window_layouts, TestWindowLayouts, Widgets)
#include "test_window_layouts.moc"
