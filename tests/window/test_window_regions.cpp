// A map by regions in the window.
#include <QDir>
#include <QDockWidget>
#include <QHelpEvent>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>
#include <QToolTip>
#include <QtTest>

#include "../regions/fake_dispatch.h"
#include "../test_timeouts.h"
#include "fake_robot.h"
#include "known_addresses.h"
#include "test_program.h"
#include "ui/maps/maps_controller.h"
#include "ui/maps/maps_dock.h"
#include "ui/regions/map_fetch.h"
#include "ui/regions/rectangle_tool.h"
#include "ui/regions/regions_controller.h"
#include "ui/regions/regions_text.h"
#include "ui/view/empty_state.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/notice_bar.h"
#include "ui/view/toast_stack.h"
#include "ui/window/main_window.h"
#include "window_parts.h"

namespace test_window_regions {

using namespace mapwright;
using regions::FakeDispatch;
using ui::MainWindow;
using ui::scene::Layer;

namespace {

/// A robot that gives its map by regions.
class DispatchRobot : public test::FakeRobot {
 public:
  using FakeRobot::FakeRobot;
  robot::MapDispatch* mapDispatch() override { return has_dispatch ? &dispatch : nullptr; }
  bool has_dispatch = true;
  FakeDispatch dispatch;
};

}  // namespace

class TestWindowRegions : public QObject {
  Q_OBJECT
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<QSettings> settings_;
  std::unique_ptr<MainWindow> window_;
  DispatchRobot* robot_ = nullptr;
  std::function<void(DispatchRobot&)> prepare_;

  void open() {
    window_.reset();
    MainWindow::Dependencies wanted{
        [this](const QString& address,
               const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          auto made = std::make_unique<DispatchRobot>(address);
          made->has_submaps = false;
          made->has_live = false;
          made->dispatch.by_itself = true;
          robot_ = made.get();
          if (prepare_) prepare_(*made);
          return std::unique_ptr<robot::Robot>(std::move(made));
        },
        *settings_};
    wanted.addresses = test::knownAddresses();
    window_ = std::make_unique<MainWindow>(std::move(wanted));
    window_->resize(1200, 800);
    window_->show();
    window_->view()->setAnimationMs(0);
    (void)QTest::qWaitForWindowActive(window_.get());
  }
  void connectRobot() {
    QVERIFY(!window_->connectTo(QStringLiteral("axbot+http://192.0.2.7:8090"), {}));
    robot_->goOnline();
    QTRY_VERIFY(controller()->map() || !robot_->has_dispatch);
  }
  ui::RegionsController* controller() const { return ui::part<ui::RegionsController>(*window_); }
  QAction* action(const char* id) const { return window_->actionList().find(QLatin1String(id)); }
  void look(double scale) {
    geometry::ViewTransform view = window_->mapScene()->view();
    view.center_m = {0, 0};
    view.scale_m_per_px = scale;
    window_->mapScene()->setView(view);
  }
  void waitUntilFetched() {
    QTRY_VERIFY(!controller()->map()->regions().inView().empty() &&
                controller()->map()->regions().plan().settled(1));
  }
  QString notice() const { return ui::part<ui::MapOverlay>(*window_)->notice()->sentence(); }
  QPushButton* offer() const { return ui::part<ui::MapOverlay>(*window_)->notice()->offerButton(); }
  QStringList toasts() const { return window_->findChild<ui::ToastStack*>()->texts(); }
  QPushButton* answerCalled(const char* name) const {
    return controller()->question()->findChild<QPushButton*>(QLatin1String(name));
  }

 private Q_SLOTS:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    settings_ = std::make_unique<QSettings>(folder_->filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
    prepare_ = {};
  }
  void cleanup() {
    window_.reset();
    settings_.reset();
    folder_.reset();
  }

  void whatIsInViewIsFetchedAndCounted() {
    open();
    connectRobot();
    look(0.05);
    waitUntilFetched();
    const regions::RegionCounts counts = controller()->map()->regions().counts();
    QCOMPARE(counts.answered, counts.in_view);
    QVERIFY(controller()->statusShown().startsWith(QStringLiteral("%1 of %1 regions").arg(counts.in_view)));
    QVERIFY(robot_->dispatch.most_at_once <= 2);
    QVERIFY2(notice().isEmpty(), qPrintable(notice()));
    QVERIFY(window_->mapScene()->occupancyAt({1, 1}).has_value() ||
            window_->mapScene()->occupancyAt({4, 4}).has_value());
    // Looking elsewhere fetches that.
    geometry::ViewTransform view = window_->mapScene()->view();
    view.center_m = {150, 100};
    window_->mapScene()->setView(view);
    QTRY_VERIFY(controller()->map()->regions().at({150, 100}).has_value() &&
                controller()->map()->regions().at({150, 100})->state == regions::RegionState::Held);
  }
  void fromTooFarAwayTheWholeMapIsOffered() {
    open();
    connectRobot();
    look(0.05);
    waitUntilFetched();
    const auto asked = robot_->dispatch.asked.size();
    look(5);
    QTRY_VERIFY(controller()->map()->regions().plan().tooFar());
    QVERIFY2(notice().contains(QStringLiteral("Zoom in")), qPrintable(notice()));
    QVERIFY2(notice().contains(QStringLiteral("cells, about")), qPrintable(notice()));
    QCOMPARE(robot_->dispatch.asked.size(), asked);
    offer()->click();
    QVERIFY(controller()->question());
    QCOMPARE(robot_->dispatch.asked_whole, 0);  // it asks first
    // How large it is makes no difference here, but takes time.
    robot_->dispatch.ground.width = robot_->dispatch.ground.height = 1024;
    answerCalled("fetchWhole")->click();
    QCOMPARE(robot_->dispatch.asked_whole, 1);
    QTRY_VERIFY(window_->session()->wholeMap().phase() == session::MapSlot::Phase::Ready);
    QCOMPARE(window_->session()->wholeMap().reference().width, robot_->dispatch.ground.width);
    QVERIFY(window_->mapScene()->layerVisible(Layer::WholeMap));
    QVERIFY(!window_->mapScene()->layerVisible(Layer::Regions));
  }
  static robot::MapExtent extentOf(int cells) {
    const std::int64_t all = std::int64_t(cells) * cells;
    return {{cells, cells, 0.05, {-cells * 0.025, -cells * 0.025, 0}},
            all * 7 / 2,
            all * 2,
            std::int64_t(256) << 20};
  }
  void howLargeTheWholeMapIsIsSaidBeforeItIsFetched() {
    prepare_ = [](DispatchRobot& robot) { robot.dispatch.told_extent = extentOf(8192); };
    open();
    connectRobot();
    action("fetchWholeMap")->trigger();
    const QString asked = controller()->question()->text();
    QVERIFY2(asked.contains(QStringLiteral("410 × 410 m")), qPrintable(asked));
    QVERIFY2(asked.contains(QStringLiteral("8,192 × 8,192 cells")), qPrintable(asked));
    QVERIFY2(asked.contains(QStringLiteral("about 235 MB over the network")), qPrintable(asked));
    QVERIFY2(!asked.contains(QStringLiteral("may fail")), qPrintable(asked));
    controller()->question()->button(QMessageBox::Cancel)->click();
    QTRY_VERIFY(!controller()->question());
    // What the robot does not tell is said to be unknown.
    robot_->dispatch.told_extent.reset();
    action("fetchWholeMap")->trigger();
    QVERIFY2(controller()->question()->text().contains(QStringLiteral("the robot does not report")),
             qPrintable(controller()->question()->text()));
  }
  void aWholeMapThatMayBreakTheLinkIsAskedAboutWithThat() {
    prepare_ = [](DispatchRobot& robot) { robot.dispatch.told_extent = extentOf(10'000); };
    open();
    connectRobot();
    action("fetchWholeMap")->trigger();
    QVERIFY2(controller()->question()->text().contains(QStringLiteral("may fail")),
             qPrintable(controller()->question()->text()));
    QVERIFY(answerCalled("fetchWhole"));
  }
  void aWholeMapBeyondTheLinkIsRefusedAndARegionOfferedInstead() {
    prepare_ = [](DispatchRobot& robot) { robot.dispatch.told_extent = extentOf(40'000); };
    open();
    connectRobot();
    action("fetchWholeMap")->trigger();
    QVERIFY2(controller()->question()->text().contains(QStringLiteral("too large")),
             qPrintable(controller()->question()->text()));
    QVERIFY(!answerCalled("fetchWhole"));
    answerCalled("fetchRegionInstead")->click();
    QVERIFY(action("fetchRegion")->isChecked());
    QCOMPARE(robot_->dispatch.asked_whole, 0);
    QTRY_VERIFY(!controller()->question());
    look(0.05);
    waitUntilFetched();
    look(5);
    QTRY_VERIFY(controller()->map()->regions().plan().tooFar());
    QVERIFY2(notice().contains(QStringLiteral("fetch a region")), qPrintable(notice()));
    action("fetchRegion")->setChecked(false);
    offer()->click();
    QVERIFY(action("fetchRegion")->isChecked());
  }
  void howMuchOfTheWholeMapHasComeIsSaidAndItCanBeCancelled() {
    prepare_ = [](DispatchRobot& robot) {
      robot.dispatch.by_itself = false;
      robot.dispatch.told_extent = extentOf(8192);
    };
    open();
    connectRobot();
    action("fetchWholeMap")->trigger();
    answerCalled("fetchWhole")->click();
    QCOMPARE(robot_->dispatch.asked_whole, 1);
    QVERIFY2(notice().contains(QStringLiteral("Nothing has arrived yet")), qPrintable(notice()));
    const auto whole = robot_->dispatch.waiting.back();
    QVERIFY(!whole->region);
    whole->state->on_progress({12 * 1024 * 1024, {}});
    QVERIFY2(notice().contains(QStringLiteral("12.6 MB of about 235 MB so far")), qPrintable(notice()));
    offer()->click();
    QVERIFY(whole->cancelled);
    QVERIFY2(!notice().contains(QStringLiteral("Fetching")), qPrintable(notice()));
  }
  void fittingShowsAllThatTheRobotSaysThereIs() {
    prepare_ = [](DispatchRobot& robot) { robot.dispatch.told_extent = extentOf(8192); };
    open();
    connectRobot();
    look(0.05);
    waitUntilFetched();
    const geometry::WorldRect bounds = window_->mapScene()->contentBounds();
    QVERIFY(std::abs(bounds.width() - 409.6) < 0.1);
    robot_->dispatch.told_extent.reset();
    Q_EMIT robot_->dispatch.extentChanged();
    QVERIFY(window_->mapScene()->contentBounds().width() < 400);
  }
  void whoDoesNotWantTheWholeMapAsksForNothing() {
    open();
    connectRobot();
    action("fetchWholeMap")->trigger();
    QVERIFY(controller()->question());
    controller()->question()->button(QMessageBox::Cancel)->click();
    QTRY_VERIFY(!controller()->question());
    QCOMPARE(robot_->dispatch.asked_whole, 0);
  }
  void aHiddenLayerAsksForNothing() {
    open();
    window_->mapScene()->setLayerVisible(Layer::Regions, false);
    connectRobot();
    look(0.05);
    QCoreApplication::processEvents();
    QVERIFY(robot_->dispatch.asked.empty());
    window_->mapScene()->setLayerVisible(Layer::Regions, true);
    QTRY_VERIFY(!robot_->dispatch.asked.empty());
  }
  void refreshingAsksOnceMore() {
    open();
    connectRobot();
    look(0.05);
    waitUntilFetched();
    const auto asked = robot_->dispatch.asked.size();
    action("refreshRegions")->trigger();
    QTRY_VERIFY(robot_->dispatch.asked.size() > asked);
    waitUntilFetched();
    const auto again = robot_->dispatch.asked.size();
    Q_EMIT robot_->dispatch.mapChanged();
    QTRY_VERIFY(robot_->dispatch.asked.size() > again);
  }
  void howLongAnAnswerTakesIsNoReasonToAskAgain() {
    prepare_ = [](DispatchRobot& robot) {
      robot.dispatch.answer = [](const map::GridRegion&) -> robot::Outcome<map::GridPart> {
        return tl::unexpected(map::Failure{.kind = map::FailureKind::RejectedByRobot});
      };
    };
    open();
    connectRobot();
    look(0.05);
    QTRY_VERIFY(!robot_->dispatch.asked.empty() && robot_->dispatch.waiting.empty());
    // What failed waits by itself; each time it is asked for would be one more.
    const std::size_t before = robot_->dispatch.asked.size();
    for (int i = 0; i < 20; ++i) {
      Q_EMIT robot_->connectionChanged();
      QCoreApplication::processEvents();
    }
    QVERIFY2(robot_->dispatch.asked.size() < before + 5,
             qPrintable(QString::number(robot_->dispatch.asked.size())));
  }
  void failuresAreToldAndTriedAgain() {
    prepare_ = [](DispatchRobot& robot) {
      robot.dispatch.answer = [&robot](const map::GridRegion& region) -> robot::Outcome<map::GridPart> {
        if (region.size_m.x() < 10) return robot.dispatch.ground.part(region);
        return tl::unexpected(map::Failure{
            .kind = map::FailureKind::RejectedByRobot, .robot_code = "7", .detail = "<b>no</b>"});
      };
    };
    open();
    connectRobot();
    look(0.05);
    QTRY_VERIFY(controller()->map()->regions().counts().failed > 1);
    QTRY_VERIFY(notice().contains(QStringLiteral("be fetched")));
    QVERIFY2(notice().contains(QStringLiteral("<b>no</b>")), qPrintable(notice()));
    robot_->dispatch.answer = {};
    offer()->click();
    waitUntilFetched();
    QTRY_VERIFY(notice().isEmpty());
  }
  QMessageBox* leaving() const {
    auto* const save = window_->findChild<QPushButton*>(QStringLiteral("saveFetched"));
    return save ? qobject_cast<QMessageBox*>(save->window()) : nullptr;
  }
  /// What the tip says in the middle of the map; empty = there is none.
  QString tip() {
    QToolTip::hideText();
    if (!QTest::qWaitFor([] { return !QToolTip::isVisible(); })) return QStringLiteral("the old tip stays");
    const QPoint at = window_->view()->viewport()->rect().center() + QPoint(7, 5);
    QHelpEvent event(QEvent::ToolTip, at, window_->view()->viewport()->mapToGlobal(at));
    QApplication::sendEvent(window_->view()->viewport(), &event);
    return QToolTip::isVisible() ? QToolTip::text() : QString();
  }
  void aPlaceIsBlankIsSaidWhereTheCursorRestsReason() {
    prepare_ = [](DispatchRobot& robot) {
      robot.dispatch.answer = [&robot](const map::GridRegion& region) -> robot::Outcome<map::GridPart> {
        if (region.size_m.x() < 10) return robot.dispatch.ground.part(region);
        return tl::unexpected(map::Failure{
            .kind = map::FailureKind::RejectedByRobot, .robot_code = "7", .detail = "<b>no</b> room"});
      };
    };
    open();
    connectRobot();
    look(0.05);
    QTRY_VERIFY(controller()->map()->regions().counts().failed > 1);
    QTRY_VERIFY(tip().contains(QStringLiteral("could not be fetched")));
    QVERIFY2(tip().contains(QStringLiteral("&lt;b&gt;no")), qPrintable(tip()));
    // What is there and current needs no words.
    robot_->dispatch.answer = {};
    action("refreshRegions")->trigger();
    waitUntilFetched();
    QTRY_VERIFY2(tip().isEmpty(), qPrintable(tip()));
    geometry::ViewTransform view = window_->mapScene()->view();
    view.center_m = {3000, 3000};
    window_->mapScene()->setView(view);
    QTRY_VERIFY2(tip().contains(QStringLiteral("has nothing")), qPrintable(tip()));
    view.center_m = {-3000, 3000};  // where nothing was fetched before
    view.scale_m_per_px = 5;
    window_->mapScene()->setView(view);
    QTRY_VERIFY2(tip().contains(QStringLiteral("Zoom in")), qPrintable(tip()));
    robot_->goAway(QStringLiteral("unplugged"));
    QTRY_VERIFY2(tip().contains(QStringLiteral("no connection")), qPrintable(tip()));
    window_->mapScene()->setLayerVisible(Layer::Regions, false);
    QVERIFY2(tip().isEmpty(), qPrintable(tip()));
  }
  void whatIsOnItsWayOrWaitsSaysSo() {
    prepare_ = [](DispatchRobot& robot) { robot.dispatch.by_itself = false; };
    open();
    connectRobot();
    look(0.05);
    QVERIFY2(tip().contains(QStringLiteral("first answer")), qPrintable(tip()));
    QTRY_VERIFY(!robot_->dispatch.waiting.empty());
    robot_->dispatch.answerOne();  // how large a cell is
    QTRY_VERIFY(!robot_->dispatch.waiting.empty());
    QVERIFY2(tip().contains(QStringLiteral("being fetched")), qPrintable(tip()));
  }
  void aRectangleIsDrawnAndKept() {
    open();
    connectRobot();
    look(0.05);
    waitUntilFetched();
    action("fetchRegion")->trigger();
    QVERIFY(action("fetchRegion")->isChecked());
    QWidget* const map = window_->view()->viewport();
    const QPoint from = map->rect().center() - QPoint(100, 60), to = map->rect().center() + QPoint(100, 60);
    QTest::mousePress(map, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 10; ++i) QTest::mouseMove(map, from + (to - from) * i / 10);
    QVERIFY2(controller()->tool()->hint().contains(QStringLiteral("cells, about")),
             qPrintable(controller()->tool()->hint()));
    QTest::mouseRelease(map, Qt::LeftButton, {}, to);
    QVERIFY(controller()->question());
    const QString asked = controller()->question()->text();
    QVERIFY(controller()->question()->informativeText().isEmpty());
    answerCalled("keepRegion")->click();
    QTRY_VERIFY(window_->session()->wholeMap().phase() == session::MapSlot::Phase::Ready);
    const map::GridReference grid = window_->session()->wholeMap().reference();
    // As many cells as was said.
    QVERIFY2(asked.contains(QStringLiteral(": %1 × %2 cells, about").arg(grid.width).arg(grid.height)),
             qPrintable(QStringLiteral("%1 x %2, %3").arg(grid.width).arg(grid.height).arg(asked)));
    QVERIFY(std::abs(grid.width - 200) <= 2 && std::abs(grid.height - 120) <= 2);
    QVERIFY(std::abs(grid.origin.x_m + 5) < 0.11);
    // The next one would take its place.
    controller()->fetch().onRectangle({-1.01, -1.03, 1.94, 1.92});
    QVERIFY(controller()->question());
    QVERIFY2(controller()->question()->text().contains(QStringLiteral(": 59 × 59 cells")),
             qPrintable(controller()->question()->text()));
    QVERIFY2(controller()->question()->informativeText().contains(QStringLiteral("replaces")),
             qPrintable(controller()->question()->informativeText()));
    answerCalled("keepRegion")->click();
    QTRY_COMPARE(window_->session()->wholeMap().reference().width, 59);
    QCOMPARE(window_->session()->wholeMap().reference().height, 59);
  }
  void aRectangleIsSaved() {
    open();
    connectRobot();
    const QString path = folder_->filePath(QStringLiteral("part.yaml"));
    controller()->fetch().saveRectangle({-10, -5, 10, 5}, path);
    QTRY_VERIFY(QFile::exists(path));
    QTRY_VERIFY(!toasts().isEmpty() && toasts().last().startsWith(QStringLiteral("Saved")));
    QFile pgm(folder_->filePath(QStringLiteral("part.pgm"))), yaml(path);
    QVERIFY(pgm.open(QIODevice::ReadOnly) && yaml.open(QIODevice::ReadOnly));
    QVERIFY(pgm.readAll().contains("400 200"));
    const QByteArray text = yaml.readAll();
    QVERIFY2(text.contains("resolution: 0.05"), text.constData());
    QVERIFY2(text.contains("-10"), text.constData());
  }
  void whatWasKeptIsAskedAboutBeforeTheRobotIsLeft() {
    open();
    connectRobot();
    action("disconnect")->trigger();
    QTRY_VERIFY(!window_->session());  // nothing was fetched: nothing is asked
    connectRobot();
    controller()->fetch().keepRectangle({-10, -10, 10, 10});
    QTRY_VERIFY(window_->session()->wholeMap().phase() == session::MapSlot::Phase::Ready);
    action("disconnect")->trigger();
    QTRY_VERIFY(leaving());
    QVERIFY2(leaving()->text().contains(QStringLiteral("20.0 × 20.0 m")), qPrintable(leaving()->text()));
    leaving()->button(QMessageBox::Cancel)->click();
    QTRY_VERIFY(!leaving());
    QVERIFY(window_->session());
    window_->close();
    QTRY_VERIFY(leaving());
    QVERIFY(window_->isVisible());
    leaving()->button(QMessageBox::Cancel)->click();
    QTRY_VERIFY(!leaving());
    // What is in a file is not lost.
    controller()->onExported();
    action("disconnect")->trigger();
    QTRY_VERIFY(!window_->session());
    QVERIFY(!leaving());
  }
  void whatWasKeptMayBeDiscarded() {
    open();
    connectRobot();
    controller()->fetch().keepRectangle({-10, -10, 10, 10});
    QTRY_VERIFY(window_->session()->wholeMap().phase() == session::MapSlot::Phase::Ready);
    action("disconnect")->trigger();
    QTRY_VERIFY(leaving());
    leaving()->button(QMessageBox::Discard)->click();
    QTRY_VERIFY(!window_->session());
  }
  void whatIsKeptIsARowOfTheMaps() {
    open();
    connectRobot();
    look(0.05);
    waitUntilFetched();
    QListView* const list = ui::part<ui::MapsDock>(*window_)->list();
    const auto row = [&] {
      for (int at = 0; at < list->model()->rowCount(); ++at) {
        const QModelIndex index = list->model()->index(at, 0);
        if (ui::part<ui::MapsDock>(*window_)->model()->isFetched(index)) return index;
      }
      return QModelIndex();
    };
    QVERIFY(!row().isValid());
    controller()->fetch().keepRectangle({-10, -5, 10, 5});
    QTRY_VERIFY(row().isValid());
    QTRY_VERIFY(window_->session()->wholeMap().phase() == session::MapSlot::Phase::Ready);
    QCOMPARE(row().data().toString(), QStringLiteral("Region 20.0 × 10.0 m"));
    const QString detail = row().data(ui::MapsModel::DetailRole).toString();
    const QRegularExpression told(QStringLiteral("^fetched \\d\\d:\\d\\d:\\d\\d, 400 x 200 cells$"));
    QVERIFY2(told.match(detail).hasMatch(), qPrintable(detail));
    ui::part<ui::MapsDock>(*window_)->show();
    ui::part<ui::MapsDock>(*window_)->raise();
    QTRY_VERIFY(list->isVisible());
    // It is looked at by mouse and by keyboard, and nobody is asked for it.
    const auto seen = [&] {
      const geometry::WorldRect view = window_->mapScene()->view().visibleWorld();
      return view.width() < 60 && std::abs(view.center().x()) < 1 && std::abs(view.center().y()) < 1;
    };
    const auto lookAway = [&] {
      geometry::ViewTransform away = window_->mapScene()->view();
      away.center_m = {500, 500};
      window_->mapScene()->setView(away);
      QVERIFY(!seen());
    };
    const QPoint at = list->visualRect(row()).center();
    lookAway();
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(list->viewport(), Qt::LeftButton, {}, at);
    QTRY_VERIFY(seen());
    lookAway();
    list->setCurrentIndex(row());
    QTest::keyClick(list, Qt::Key_Return);
    QTRY_VERIFY(seen());
    QVERIFY(window_->session()->wholeMap().phase() == session::MapSlot::Phase::Ready);
    // It is gone from the list when it is gone from the screen.
    QTimer::singleShot(0, this, [&] {
      auto* const menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      QVERIFY(menu);
      QAction* const forget = menu->findChild<QAction*>(QStringLiteral("forgetFetched"));
      QVERIFY(forget);
      menu->setActiveAction(forget);
      QTest::keyClick(menu, Qt::Key_Return);
    });
    QContextMenuEvent asked(QContextMenuEvent::Mouse, at, list->viewport()->mapToGlobal(at));
    QApplication::sendEvent(list->viewport(), &asked);
    QTRY_VERIFY(!row().isValid());
    QVERIFY(window_->session()->wholeMap().phase() == session::MapSlot::Phase::Empty);
    QVERIFY(window_->mapScene()->layerVisible(Layer::Regions));
  }
  void whatIsTooLargeIsRefused() {
    open();
    connectRobot();
    controller()->fetch().saveRectangle({-4000, -4000, 4000, 4000},
                                        folder_->filePath(QStringLiteral("huge.yaml")));
    QTRY_VERIFY(!toasts().isEmpty() && toasts().last().contains(QStringLiteral("too large")));
    QVERIFY(!QFile::exists(folder_->filePath(QStringLiteral("huge.yaml"))));
  }
  void aRobotThatGoesEndsEverything() {
    prepare_ = [](DispatchRobot& robot) { robot.dispatch.by_itself = false; };
    open();
    connectRobot();
    look(0.05);
    controller()->fetch().keepRectangle({-10, -10, 10, 10});
    QVERIFY(notice().contains(QStringLiteral("Fetching")));
    window_->leaveRobot();
    QVERIFY(!controller()->map());
    QVERIFY(!window_->mapScene()->regions());
    QVERIFY(!action("fetchRegion")->isEnabled());
    QVERIFY(!action("fetchWholeMap")->isEnabled());
    QVERIFY(!action("refreshRegions")->isEnabled());
    QVERIFY(controller()->statusShown().isEmpty());
    QVERIFY(notice().isEmpty());
  }
  void whereThereAreOnlyCloudsNothingIsWaitedForAndTheyAreOffered() {
    prepare_ = [](DispatchRobot& robot) {
      robot.dispatch.offers_regions = robot.dispatch.offers_whole = false;
      robot.dispatch.offers_clouds = true;
    };
    open();
    connectRobot();
    look(0.05);
    QVERIFY(!window_->mapScene()->regions());  // nothing is hatched
    QVERIFY2(notice().isEmpty(), qPrintable(notice()));
    QVERIFY2(tip().isEmpty(), qPrintable(tip()));
    ui::EmptyStateCard* const card = ui::part<ui::MapOverlay>(*window_)->card();
    QTRY_VERIFY(card->isVisible());
    QCOMPARE(card->kind(), std::optional(ui::EmptyState::Kind::NoMap));
    QPushButton* clouds = nullptr;
    for (QPushButton* button : card->findChildren<QPushButton*>())
      if (button->isVisible()) clouds = button;
    QVERIFY(clouds && clouds->text() == QStringLiteral("Fetch clouds…"));
    clouds->click();
    QTRY_VERIFY(window_->findChild<QDockWidget*>(QStringLiteral("clouds"))->isVisible());
    // Its dispatcher may learn to give regions.
    robot_->dispatch.offers_regions = true;
    Q_EMIT robot_->dispatch.offersChanged();
    QTRY_VERIFY(window_->mapScene()->regions());
    QTRY_VERIFY(!card->isVisible());
    waitUntilFetched();
  }
  void whatCameStaysInSightWhenTheConnectionIsLost() {
    open();
    connectRobot();
    look(0.05);
    waitUntilFetched();
    robot_->goAway(QStringLiteral("unplugged"));
    QCoreApplication::processEvents();
    QVERIFY(controller()->map()->regions().bytes() > 0);
    QVERIFY(!ui::part<ui::MapOverlay>(*window_)->card()->isVisible());
  }
  void whatCameStaysInSightWhenItsDispatcherGoes() {
    open();
    connectRobot();
    look(0.05);
    waitUntilFetched();
    robot_->dispatch.offers_regions = false;
    Q_EMIT robot_->dispatch.offersChanged();
    QCoreApplication::processEvents();
    QVERIFY(controller()->map()->regions().bytes() > 0);
    QVERIFY(window_->mapScene()->layerVisible(Layer::Regions));
    QVERIFY2(notice().contains(QStringLiteral("no longer sends its map by region")), qPrintable(notice()));
    QVERIFY(!controller()->statusShown().isEmpty());
    const auto asked = robot_->dispatch.asked.size();
    robot_->dispatch.offers_regions = true;
    Q_EMIT robot_->dispatch.offersChanged();
    QTRY_VERIFY(robot_->dispatch.asked.size() > asked);  // it may have another map now
    QVERIFY2(notice().isEmpty(), qPrintable(notice()));
  }
  void theWholeMapIsTheRobotsOwnAndTheRegionsAreBackByTheLiveMap() {
    prepare_ = [](DispatchRobot& robot) {
      robot.dispatch.ground.width = robot.dispatch.ground.height = 5000;
    };
    open();
    connectRobot();
    look(0.05);
    waitUntilFetched();
    action("fetchWholeMap")->trigger();
    QCOMPARE(controller()->question()->defaultButton(),
             controller()->question()->button(QMessageBox::Cancel));
    answerCalled("fetchWhole")->click();
    QTRY_VERIFY(window_->session()->wholeMap().phase() == session::MapSlot::Phase::Ready);
    QVERIFY(window_->mapScene()->robotPlace().drawn == ui::scene::ScreenPart::All);
    ui::part<ui::MapsController>(*window_)->open({map::MapKind::Live, {}});
    QVERIFY(window_->mapScene()->layerVisible(Layer::Regions));
    QVERIFY(window_->session()->wholeMap().phase() == session::MapSlot::Phase::Empty);
  }
  void theMapIsSavedOnTheRobot() {
    open();
    connectRobot();
    QVERIFY(action("saveMapOnRobot")->isEnabled());
    action("saveMapOnRobot")->trigger();
    const auto dialog = [this] { return window_->findChild<ui::SaveMapDialog*>(); };
    QVERIFY(dialog());
    auto* const name = dialog()->findChild<QLineEdit*>(QStringLiteral("saveMapName"));
    auto* const save = dialog()->findChild<QPushButton*>(QStringLiteral("primary"));
    name->setText(QStringLiteral("  "));
    QVERIFY(!save->isEnabled());
    name->setText(QStringLiteral("office.pgm"));
    save->click();
    QCOMPARE(robot_->dispatch.saved_as, (std::vector<std::string>{"office.pgm"}));
    QVERIFY(!save->isEnabled());
    robot_->dispatch.answer_save(
        tl::unexpected(map::Failure{.kind = map::FailureKind::Refused, .detail = "no room"}));
    QVERIFY(dialog());
    QVERIFY(save->isEnabled());
    save->click();
    robot_->dispatch.answer_save(std::string("/maps/office.pgm"));
    QTRY_VERIFY(!dialog());
    QTRY_VERIFY(action("saveMapOnRobot")->isEnabled());
  }
  void aCapabilityThatComesAndGoesIsFollowed() {
    prepare_ = [](DispatchRobot& robot) { robot.has_dispatch = false; };
    open();
    connectRobot();
    QVERIFY(!controller()->map());
    QVERIFY(!action("fetchRegion")->isEnabled());
    robot_->has_dispatch = true;
    Q_EMIT robot_->capabilitiesChanged();
    QVERIFY(controller()->map());
    QVERIFY(action("fetchRegion")->isEnabled());
    robot_->has_dispatch = false;
    Q_EMIT robot_->capabilitiesChanged();
    QVERIFY(!controller()->map());
  }
  void howOftenIsRemembered() {
    open();
    QCOMPARE(controller()->refreshEvery(), 0);
    controller()->setRefreshEvery(60);
    window_->close();
    open();
    QCOMPARE(controller()->refreshEvery(), 60);
    controller()->setRefreshEvery(-3);
    QCOMPARE(controller()->refreshEvery(), 0);
  }
};

}  // namespace test_window_regions

MAPWRIGHT_TEST(test_window_regions, TestWindowRegions, Widgets)
#include "test_window_regions.moc"
