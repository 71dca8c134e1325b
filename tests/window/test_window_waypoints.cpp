// Waypoints in the window: on the map by hand, in the list, saved, merged, left.
#include <random>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTableView>
#include <QtTest>

#include "session/lacks_picture.h"
#include "test_program.h"
#include "ui/kit/actions.h"
#include "ui/maps/export_controller.h"
#include "ui/maps/maps_controller.h"
#include "ui/view/empty_state.h"
#include "ui/view/hit_list.h"
#include "ui/view/map_overlay.h"
#include "ui/view/notice_bar.h"
#include "ui/view/toast_stack.h"
#include "ui/waypoints/waypoint_conflicts.h"
#include "ui/waypoints/waypoint_forms.h"
#include "ui/waypoints/waypoint_snapping.h"
#include "ui/waypoints/waypoint_text.h"
#include "ui/waypoints/waypoint_tool.h"
#include "ui/waypoints/waypoints_controller.h"
#include "ui/waypoints/waypoints_dock.h"
#include "waypoints_desk.h"
#include "window_parts.h"

namespace test_window_waypoints {

using namespace mapwright;
using namespace mapwright::ui;
using test::waypoint;

namespace {

using Desk = test::WaypointsDesk;

}  // namespace

class TestWindowWaypoints : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void showsTheListAndDrawsIt() {
    Desk desk;
    desk.start();
    QCOMPARE(desk.dock().model()->rowCount(), 2);
    const QImage with = part<ExportController>(*desk.window)->mapPicture();
    desk.window->mapScene()->setLayerVisible(ui::scene::Layer::Waypoints, false);
    QVERIFY(part<ExportController>(*desk.window)->mapPicture() != with);
    QVERIFY2(desk.dock().statusShown().contains(QLatin1String("2 waypoints.")),
             qPrintable(desk.dock().statusShown()));
  }

  void anOpenMapThatIsDeletedByOthersSaysSoAndCanBeKept() {
    Desk desk;
    desk.start();
    auto& robot = *desk.robot;
    NoticeBar* const strip = part<MapOverlay>(*desk.window)->notice();
    const auto deleted = [&] {
      return strip->isVisible() && strip->sentence().contains(QLatin1String("not on the robot"));
    };
    Q_EMIT robot.mapsChanged();
    QTRY_VERIFY(!desk.window->session()->catalogue().loading());
    QVERIFY(!deleted());
    const auto kept = robot.maps.entries;
    robot.maps.entries.erase(robot.maps.entries.begin());
    Q_EMIT robot.mapsChanged();
    QTRY_VERIFY(deleted());
    QVERIFY2(strip->sentence().contains(QLatin1String("Ground floor")), qPrintable(strip->sentence()));
    QCOMPARE(strip->offerButton()->text(), QStringLiteral("Export it…"));
    QVERIFY(desk.window->session()->wholeMap().cells());
    robot.maps.entries = kept;
    Q_EMIT robot.mapsChanged();
    QTRY_VERIFY(!deleted());
  }

  void namesKeepClearOfTheHandleAndOfTheHint() {
    struct Shown {
      QImage picture;
      std::vector<QRectF> covered;
    };
    const auto shown = [](const std::string& name, bool at_hint) {
      Desk desk;
      desk.store.points = {waypoint("a", 1, 1, name)};
      desk.store.points[0].yaw_rad = 0;  // to where names stand
      desk.start();
      desk.chooseTool();
      desk.editing().select({"a"});
      QCoreApplication::processEvents();
      const auto frames = desk.window->view()->findChildren<QFrame*>(QStringLiteral("furniture"));
      const auto hint = std::find_if(frames.begin(), frames.end(), [](const QFrame* frame) {
        return frame->testAttribute(Qt::WA_TransparentForMouseEvents);
      });
      const QRectF hint_area = (*hint)->geometry();
      std::vector<QRectF> covered = desk.control().tool()->covered();
      if (at_hint) {
        const QPointF to = hint_area.center() - QPointF(hint_area.width() / 2 + 12, 0);
        const QPointF by = to - QPointF(desk.px(1, 1));
        desk.window->view()->moveTo(desk.window->mapScene()->view().pannedBy({by.x(), by.y()}), false);
        covered = {hint_area};
      }
      [&] { QTRY_VERIFY(desk.window->mapScene()->settled()); }();
      return Shown{part<ExportController>(*desk.window)->mapPicture(), covered};
    };
    for (const bool at_hint : {false, true}) {
      const Shown named = shown("Loading dock", at_hint), nameless = shown("", at_hint);
      QVERIFY(named.picture != nameless.picture && !named.covered.empty());
      for (const QRectF& area : named.covered)
        QCOMPARE(named.picture.copy(area.toRect()), nameless.picture.copy(area.toRect()));
    }
  }

  void aClickAddsOneAndOffersItsName() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    desk.click(desk.px(2, 2));
    QCOMPARE(desk.items().size(), std::size_t(3));
    NameEditor* const editor = desk.control().nameEditor();
    QVERIFY(editor->isVisible());
    QCOMPARE(editor->selectedText(), QStringLiteral("Waypoint 1"));
    QTest::keyClicks(editor, QStringLiteral("Lift w"));
    QTest::keyClick(editor, Qt::Key_Return);
    QVERIFY(!editor->isVisible());
    QVERIFY(desk.window->view()->hasFocus());
    const edit::Key key = *desk.editing().selected().begin();
    QCOMPARE(desk.editing().find(key)->name, std::string("Lift w"));
    QVERIFY(desk.near(key, 2, 2));
    // One hand's work, one step back.
    QTest::keyClick(desk.window->view(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(desk.items().size(), std::size_t(2));
    QTest::keyClick(desk.window->view(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(desk.editing().find(key)->name, std::string("Lift w"));
  }

  void escKeepsTheNameThatWasOffered() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    desk.click(desk.px(2, 2));
    QTest::keyClicks(desk.control().nameEditor(), QStringLiteral("x"));
    QTest::keyClick(desk.control().nameEditor(), Qt::Key_Escape);
    QCOMPARE(desk.editing().only()->name, std::string("Waypoint 1"));
    desk.click(desk.px(2.5, 2.5));
    QCOMPARE(desk.editing().only()->name, std::string("Waypoint 2"));
  }

  void aClickSelectsAndADragMoves() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    desk.click(desk.px(1, 1));
    QCOMPARE(desk.items().size(), std::size_t(2));
    QCOMPARE(desk.editing().selected(), std::set<edit::Key>{"a"});
    QCOMPARE(desk.dock().table()->selectionModel()->selectedRows().size(), 1);
    const Eigen::Vector2d center = desk.window->mapScene()->view().center_m;
    desk.drag(desk.px(1, 1), desk.px(1.5, 2.5));
    QVERIFY(desk.near("a", 1.5, 2.5));
    QCOMPARE(desk.undo().count(), 1);
    QCOMPARE(desk.window->mapScene()->view().center_m, center);  // the map stood still
    desk.undo().undo();
    QVERIFY(desk.near("a", 1, 1));
    desk.drag(desk.px(2, 2.8), desk.px(2.2, 2.8));  // beside them it pans
    QVERIFY(desk.window->mapScene()->view().center_m != center);
  }

  void severalMoveTogether() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    desk.click(desk.px(1, 1));
    desk.click(desk.px(3, 2), Qt::ShiftModifier);
    QCOMPARE(desk.editing().selected().size(), std::size_t(2));
    desk.drag(desk.px(1, 1), desk.px(1.5, 1));
    QVERIFY(desk.near("a", 1.5, 1) && desk.near("b", 3.5, 2));
    QCOMPARE(desk.undo().count(), 1);
  }

  void aDragIsSeenAndEscCancelsIt() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    const QImage before = part<ExportController>(*desk.window)->mapPicture();
    desk.press(desk.px(1, 1));
    desk.moveTo(desk.px(1.5, 2.5), Qt::AltModifier);
    QVERIFY(desk.editing().preview().contains("a"));
    QVERIFY(part<ExportController>(*desk.window)->mapPicture() != before);
    QVERIFY(desk.near("a", 1, 1));  // not true before the hand lets go
    QTest::keyClick(desk.window->view(), Qt::Key_Escape);
    QVERIFY(desk.editing().preview().empty());
    desk.moveTo(desk.px(2, 2));
    desk.release(desk.px(2, 2));
    QVERIFY(desk.near("a", 1, 1));
    QCOMPARE(desk.undo().count(), 0);
    QCOMPARE(desk.items().size(), std::size_t(2));
  }

  void theHandleTurns() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    desk.click(desk.px(1, 1));
    const auto handle = desk.control().tool()->handle();
    QVERIFY(handle);
    desk.drag(handle->toPoint(), desk.px(1, 2));
    QVERIFY(std::abs(*desk.editing().find("a")->yaw_rad - 1.5708) < 0.02);
    QVERIFY(desk.near("a", 1, 1));
    QVERIFY2(
        std::abs(desk.control().tool()->handle()->y() - (desk.px(1, 1).y() - WaypointTool::kHandlePx)) < 2,
        "up");
  }

  // A row of them, as far apart as the handle of the one before.
  void theNextOneMayLieWhereTheHandleIs() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    desk.click(desk.px(0.5, 2));
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("Corr 1"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    const geometry::ViewTransform view = desk.window->mapScene()->view();
    const auto handle = desk.control().tool()->handle();
    QVERIFY(handle);
    desk.moveTo(handle->toPoint());
    desk.click(handle->toPoint(), Qt::AltModifier);
    QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(desk.control().nameEditor()));
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("Corr 2"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QCOMPARE(desk.items().size(), std::size_t(4));
    QVERIFY(desk.editing().only());
    QCOMPARE(desk.editing().only()->name, std::string("Corr 2"));
    QVERIFY(desk.near(*desk.editing().selected().begin(), 0.5 + 0.01 * WaypointTool::kHandlePx, 2));
    QVERIFY(desk.window->mapScene()->view() == view);  // no letter of it was a command
    // One below the handle is the one that is meant.
    desk.editing().select({"a"});
    desk.editing().set(
        "b",
        [&] {
          map::Waypoint there = *desk.editing().find("b");
          const Eigen::Vector2d at = view.worldFromPixel(
              {desk.control().tool()->handle()->x(), desk.control().tool()->handle()->y()});
          there.position_m = at;
          return there;
        }(),
        QStringLiteral("move"));
    desk.click(desk.control().tool()->handle()->toPoint());
    QCOMPARE(desk.editing().selected(), std::set<edit::Key>{"b"});
    QCOMPARE(desk.items().size(), std::size_t(4));
  }

  void theLineForTheNameGoesAlongWithTheMap() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    desk.click(desk.px(2, 2));
    NameEditor* const editor = desk.control().nameEditor();
    QTest::keyClicks(editor, QStringLiteral("Co"));
    const QPoint before = editor->pos();
    geometry::ViewTransform camera = desk.window->mapScene()->view();
    camera.center_m.x() += 0.5;
    desk.window->view()->moveTo(camera, false);
    QVERIFY(editor->isVisible());
    QCOMPARE(editor->pos(), before - QPoint(50, 0));
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("rr"));
    QCOMPARE(desk.editing().only()->name, std::string("Corr"));
    camera.center_m.x() += 500;  // out of sight it is still there to be typed into
    desk.window->view()->moveTo(camera, false);
    QVERIFY(desk.window->view()->viewport()->rect().contains(editor->geometry()));
  }

  void whatIsNotKeptThereIsNotOffered() {
    Desk desk;
    desk.store.kept_fields = {.type = false, .no_heading = false};
    for (map::Waypoint& point : desk.store.points) point.yaw_rad = 1;
    desk.start();
    desk.bringUp();
    desk.editing().select({"a", "b"});
    QVERIFY(!desk.dock().groupForm()->typeEdit()->isVisible());
    QCOMPARE(desk.dock().groupForm()->turnChoice()->count(), 2);
    const edit::Key fresh = desk.editing().add({2, 2});
    QCOMPARE(desk.editing().find(fresh)->yaw_rad, std::optional(0.0));
    desk.editing().select({fresh});
    QVERIFY(desk.dock().form()->yawBox()->specialValueText().isEmpty());
    QCOMPARE(desk.dock().form()->yawBox()->minimum(), -180.0);
  }

  void aFileOffersAllOfIt() {
    Desk desk;
    desk.start();
    desk.bringUp();
    desk.editing().select({"a", "b"});
    QVERIFY(desk.dock().groupForm()->typeEdit()->isVisible());
    QCOMPARE(desk.dock().groupForm()->turnChoice()->count(), 3);
  }

  void nudgesAddUpToDecimals() {
    Desk desk;
    desk.store.points = {waypoint("a", 1, 1.1, "Dock"), waypoint("b", 3.123456789, 2, "Kitchen")};
    desk.start();
    desk.chooseTool();
    std::mt19937 dice(7);
    const auto shortest = [](double number) {
      return QString::number(number, 'g', QLocale::FloatingPointShortest);
    };
    desk.editing().select({"a", "b"});
    for (int step = 0; step < 60; ++step) {
      const Qt::Key keys[] = {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down};
      desk.key(keys[dice() % 4], dice() % 3 == 0 ? Qt::ShiftModifier : Qt::NoModifier);
      for (const char* id : {"a", "b"}) {
        for (const double metres : desk.editing().find(id)->position_m) {
          const QString written = shortest(metres);
          QVERIFY2(written.section(QLatin1Char('.'), 1).size() <= (metres == 3.123456789 ? 9 : 6),
                   qPrintable(written));
        }
      }
    }
  }

  void keysNudgeRenameAndDelete() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    const double cell = desk.editing().cell();
    desk.click(desk.px(1, 1));
    const Eigen::Vector2d center = desk.window->mapScene()->view().center_m;
    for (int i = 0; i < 3; ++i) desk.key(Qt::Key_Right);
    desk.key(Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY((desk.editing().find("a")->position_m - Eigen::Vector2d(1 + 3 * cell, 1 + 10 * cell)).norm() <
            1e-9);
    QCOMPARE(desk.undo().count(), 1);
    QCOMPARE(desk.window->mapScene()->view().center_m, center);
    desk.key(Qt::Key_F2);
    QVERIFY(desk.control().nameEditor()->isVisible());
    QTest::keyClicks(desk.control().nameEditor(), QStringLiteral("Charger"));
    QTest::keyClick(desk.control().nameEditor(), Qt::Key_Enter);
    QCOMPARE(desk.editing().find("a")->name, std::string("Charger"));
    desk.key(Qt::Key_Delete);
    QVERIFY(!desk.editing().find("a"));
    QVERIFY(desk.editing().selected().empty());
    desk.key(Qt::Key_Left);  // with nothing selected the arrows are the map's
    QVERIFY(desk.window->mapScene()->view().center_m != center);
    desk.key(Qt::Key_Escape);
    QVERIFY(desk.window->view()->tool() != desk.control().tool());
  }

  void spaceIsAHandThatGivesBackTheTool() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    const Eigen::Vector2d center = desk.window->mapScene()->view().center_m;
    QTest::keyPress(desk.window->view(), Qt::Key_Space);
    QVERIFY(desk.window->view()->activeTool() != desk.control().tool());
    desk.click(desk.px(2, 2));
    desk.drag(desk.px(1, 1), desk.px(1.5, 1));
    QTest::keyRelease(desk.window->view(), Qt::Key_Space);
    QCOMPARE(desk.window->view()->activeTool(), static_cast<MapTool*>(desk.control().tool()));
    QCOMPARE(desk.items().size(), std::size_t(2));
    QVERIFY(desk.near("a", 1, 1));
    QVERIFY(desk.window->mapScene()->view().center_m != center);
  }

  void theFormChangesWhatIsSelected() {
    Desk desk;
    desk.start();
    QVERIFY(!desk.dock().form()->isEnabled());
    desk.dock().table()->selectRow(0);
    QVERIFY(desk.dock().form()->isEnabled());
    QLineEdit* const name = desk.dock().form()->nameEdit();
    QCOMPARE(name->text(), QStringLiteral("Dock"));
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, QStringLiteral("<b>Bold</b>"));
    QTest::keyClick(name, Qt::Key_Return);
    QCOMPARE(desk.editing().find("a")->name, std::string("<b>Bold</b>"));
    const QModelIndex row = desk.dock().model()->indexOf("a");
    QCOMPARE(row.data().toString(), QStringLiteral("<b>Bold</b>"));
    QVERIFY(!row.data(Qt::ToolTipRole).toString().contains(QLatin1String("<b>Bold")));
    QVERIFY(!row.siblingAtColumn(WaypointsModel::StateColumn).data(Qt::DecorationRole).isNull());
    QVERIFY(row.siblingAtColumn(WaypointsModel::StateColumn)
                .data(Qt::AccessibleTextRole)
                .toString()
                .contains(QLatin1String("Not saved")));
  }

  void whatIsBeingTypedIsInTheListAtOnceAsOneStep() {
    Desk desk;
    desk.start();
    desk.dock().table()->selectRow(0);
    const edit::Key key = *desk.editing().selected().begin();
    QLineEdit* const name = desk.dock().form()->nameEdit();
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, QStringLiteral("Lift w"));
    QCOMPARE(desk.editing().find(key)->name, std::string("Lift w"));
    QCOMPARE(name->text(), QStringLiteral("Lift w"));
    QCOMPARE(desk.undo().count(), 1);
    // A name of nothing is none.
    name->selectAll();
    QTest::keyClick(name, Qt::Key_Backspace);
    QCOMPARE(desk.editing().find(key)->name, std::string("Dock"));
    QCOMPARE(desk.undo().count(), 0);
    QTest::keyClicks(name, QStringLiteral("Gate"));
    QTest::keyClick(name, Qt::Key_Return);
    QTest::keyClicks(name, QStringLiteral(" 2"));
    QTest::keyClick(name, Qt::Key_Return);
    QCOMPARE(desk.editing().find(key)->name, std::string("Gate 2"));
    QCOMPARE(desk.undo().count(), 2);
    desk.undo().undo();
    QCOMPARE(desk.editing().find(key)->name, std::string("Gate"));
  }

  void whatIsBeingTypedOnTheMapIsInTheListAtOnce() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    desk.click(desk.px(2, 2));
    QTest::keyClicks(desk.control().nameEditor(), QStringLiteral("Li"));
    QCOMPARE(desk.editing().only()->name, std::string("Li"));
    QCOMPARE(desk.undo().count(), 1);
    QTest::keyClick(desk.control().nameEditor(), Qt::Key_Escape);
    QCOMPARE(desk.editing().only()->name, std::string("Waypoint 1"));
  }

  void numbersInNamesAreSortedAsNumbers() {
    Desk desk;
    desk.store.points = {waypoint("a", 1, 1, "Rack 10"), waypoint("b", 3, 2, "rack 2"),
                         waypoint("c", 3, 1, "Dock")};
    desk.start();
    QStringList names;
    const QAbstractItemModel* const rows = desk.dock().table()->model();
    for (int row = 0; row < rows->rowCount(); ++row)
      names << rows->index(row, WaypointsModel::NameColumn).data().toString();
    QCOMPARE(names,
             (QStringList{QStringLiteral("Dock"), QStringLiteral("rack 2"), QStringLiteral("Rack 10")}));
  }

  void theFilterFindsNamesAndTags() {
    Desk desk;
    desk.store.points[1].tags = {"charger"};
    desk.start();
    desk.dock().filterEdit()->setText(QStringLiteral("CHARG"));
    QCOMPARE(desk.dock().table()->model()->rowCount(), 1);
    desk.dock().filterEdit()->setText(QStringLiteral("nothing like it"));
    QVERIFY(!desk.dock().emptyShown().isEmpty());
  }

  void saveWritesAndTheTitleTells() {
    Desk desk;
    desk.start();
    QVERIFY(!desk.action("save")->isEnabled());
    const QString title = desk.window->windowTitle();
    desk.chooseTool();
    desk.drag(desk.px(1, 1), desk.px(1.5, 1));
    QCOMPARE(desk.window->windowTitle(), QStringLiteral("• ") + title);
    QVERIFY(desk.action("save")->isEnabled());
    desk.key(Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY(!desk.control().unsaved());
    QVERIFY(std::abs(desk.store.find("Dock")->position_m.x() - 1.5) < 0.011);
    QCOMPARE(desk.window->windowTitle(), title);
    QTRY_VERIFY(part<MapOverlay>(*desk.window)
                    ->toasts()
                    ->texts()
                    .join(QLatin1Char('|'))
                    .contains(QLatin1String("saved")));
    QVERIFY(!desk.action("save")->isEnabled());
    QVERIFY(desk.action("undo")->isEnabled());  // what is saved can be undone, and saved again
  }

  void aNameWithAnAmpersandIsWholeInTheMenu() {
    Desk desk;
    desk.start();
    desk.editing().rename("a", QStringLiteral("R&D"));
    desk.editing().rename("a", QStringLiteral("Lab"));
    QCOMPARE(desk.action("undo")->text(), QStringLiteral("&Undo rename R&&D"));
    QCOMPARE(plainActionText(*desk.action("undo")), QStringLiteral("Undo rename R&D"));
    desk.action("undo")->trigger();
    QCOMPARE(desk.editing().find("a")->name, std::string("R&D"));
    QCOMPARE(plainActionText(*desk.action("redo")), QStringLiteral("Redo rename R&D"));
  }

  void whatCannotBeSavedStaysAndIsSaid() {
    Desk desk;
    desk.start();
    desk.editing().add({2, 2});
    map::Failure failure{map::FailureKind::RejectedByRobot};
    failure.detail = "the <disk> is full";
    failure.reason = map::FailureReason::Unfit;
    desk.store.failures = {failure};
    desk.action("save")->trigger();
    QTRY_VERIFY(desk.dock().statusShown().contains(QLatin1String("The <disk> is full.")));
    QVERIFY(desk.control().unsaved());
    QVERIFY(desk.toasts().last().contains(QLatin1String("is full")));
    desk.action("save")->trigger();
    QTRY_VERIFY(!desk.control().unsaved());
    QTRY_COMPARE(desk.toasts(), QStringList{QStringLiteral("Waypoints of Map 1 saved")});
  }

  void leavingWithChangesAsks_data() {
    QTest::addColumn<int>("departure");
    QTest::newRow("close") << 0;
    QTest::newRow("another map") << 1;
    QTest::newRow("another robot") << 2;
    QTest::newRow("disconnect") << 3;
  }
  void leavingWithChangesAsks() {
    QFETCH(int, departure);
    Desk desk;
    desk.start();
    desk.editing().add({2, 2});
    const auto leave = [&] {
      if (departure == 0) desk.window->close();
      if (departure == 1) part<MapsController>(*desk.window)->open({map::MapKind::Stored, "2"});
      if (departure == 2) (void)desk.window->connectTo(QStringLiteral("axbot+http://192.0.2.8:8090"));
      if (departure == 3) desk.action("disconnect")->trigger();
    };
    const auto left = [&] {
      if (departure == 0) return !desk.window->isVisible();
      if (departure == 1) return desk.window->session()->wholeMap().key().id == "2";
      if (departure == 2) return desk.window->session()->robot().address().contains(QLatin1String("2.8"));
      return desk.window->session() == nullptr;
    };
    leave();
    desk.answer(QMessageBox::Cancel);
    QVERIFY(!left());
    QVERIFY(desk.control().unsaved());
    leave();
    desk.answer(QMessageBox::Save);
    QTRY_VERIFY(left());
    QCOMPARE(desk.store.points.size(), std::size_t(3));
  }

  void discardingLeavesNothingBehind() {
    Desk desk;
    desk.start();
    desk.editing().add({2, 2});
    desk.window->close();
    desk.answer(QMessageBox::Discard);
    QTRY_VERIFY(!desk.window->isVisible());
    desk.window.reset();
    QCOMPARE(desk.store.points.size(), std::size_t(2));
    QVERIFY(QDir(desk.edit.drafts_folder).entryList(QDir::Files).isEmpty());
  }

  void whatIsKeptAsADraftIsOfferedAgain() {
    Desk desk;
    desk.start();
    desk.editing().add({2, 2});
    desk.window->close();
    desk.keepAsDraft();
    QTRY_VERIFY(!desk.window->isVisible());
    desk.start();
    QTRY_VERIFY(desk.notice()->isVisible());
    QVERIFY2(desk.notice()->sentence().contains(QLatin1String(": 1 change.")),
             qPrintable(desk.notice()->sentence()));
    QCOMPARE(desk.items().size(), std::size_t(2));
    desk.notice()->offerButton()->setFocus();
    desk.notice()->offerButton()->click();
    QCOMPARE(desk.items().size(), std::size_t(3));
    QVERIFY(desk.control().unsaved());
    QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(desk.dock().table()));
    QVERIFY(!desk.notice()->isVisible());
  }

  void aDraftCanBeThrownAway() {
    Desk desk;
    desk.start();
    desk.editing().add({2, 2});
    desk.window.reset();  // the program ends: what is there is kept
    desk.start();
    QTRY_VERIFY(desk.notice()->secondButton()->isVisible());
    desk.notice()->secondButton()->setFocus();
    desk.notice()->secondButton()->click();
    QVERIFY(!desk.notice()->isVisible());
    QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(desk.window->view()));
    QVERIFY(QDir(desk.edit.drafts_folder).entryList({QStringLiteral("*.json")}).isEmpty());
  }

  void changesFromElsewhereMergeOrAreToBeChosenFrom() {
    Desk desk;
    desk.start();
    desk.editing().select({"a"});
    desk.editing().moveSelected({0.5, 0});
    desk.store.put(waypoint("b", 3, 2, "Kitchen renamed"));
    Q_EMIT desk.store.changed();
    QTRY_COMPARE(desk.editing().find("b")->name, std::string("Kitchen renamed"));
    QVERIFY(desk.dock().conflicts()->shown().isEmpty());
    desk.store.put(waypoint("a", 0.5, 0.5, "Dock"));
    Q_EMIT desk.store.changed();
    QTRY_VERIFY(!desk.dock().conflicts()->shown().isEmpty());
    QVERIFY2(desk.dock().conflicts()->shown().contains(
                 QLatin1String("Here: position 1.500, 1.000 m. Elsewhere: position 0.500, 0.500 m.")),
             qPrintable(desk.dock().conflicts()->shown()));
    QVERIFY(desk.notice()->isVisible());
    QVERIFY(desk.dock().conflicts()->bothButton()->isVisibleTo(&desk.dock()));
    desk.editing().add({3, 1});
    desk.dock().conflicts()->theirsButton()->click();
    QVERIFY(desk.dock().saveButton()->isEnabled() && desk.action("save")->isEnabled());
    QVERIFY(desk.near("a", 0.5, 0.5));
    QVERIFY(desk.dock().conflicts()->shown().isEmpty() && !desk.notice()->isVisible());
  }

  void whoSavesDuringAConflictIsTakenToIt() {
    Desk desk;
    desk.start();
    desk.editing().select({"a", "b"});
    desk.editing().moveSelected({0.5, 0});
    desk.store.put(waypoint("b", 3, 1, "Kitchen"));
    Q_EMIT desk.store.changed();
    QTRY_COMPARE(desk.editing().document()->conflicts().size(), std::size_t(1));
    desk.dock().hide();
    desk.editing().select({});
    desk.window->view()->setFocus();
    const int sent = int(desk.store.asked.size());
    desk.key(Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY(desk.dock().isVisible());
    QVERIFY2(desk.toasts().last().contains(
                 QLatin1String("Nothing was saved: 1 waypoint changed here and elsewhere")),
             qPrintable(desk.toasts().last()));
    QVERIFY(desk.dock().conflicts()->isAncestorOf(QApplication::focusWidget()));
    QCOMPARE(desk.editing().selected(), std::set<edit::Key>{"b"});
    QCOMPARE(int(desk.store.asked.size()), sent);
    desk.dock().conflicts()->mineButton()->click();
    QVERIFY2(desk.toasts().isEmpty(), qPrintable(desk.toasts().join(QLatin1Char('\n'))));
    desk.key(Qt::Key_S, Qt::ControlModifier);
    // What was said of it before is over.
    QTRY_COMPARE(desk.toasts(), QStringList{QStringLiteral("Waypoints of Map 1 saved")});
  }

  void theConflictThatIsShownIsThatOfTheSelectedOne() {
    Desk desk;
    desk.start();
    desk.editing().select({"a", "b"});
    desk.editing().moveSelected({0.5, 0});
    desk.editing().select({"b"});  // before there is a conflict
    desk.store.put(waypoint("a", 0.5, 2.5, "Dock"));
    desk.store.put(waypoint("b", 3.5, 1, "Kitchen"));
    Q_EMIT desk.store.changed();
    QTRY_VERIFY2(desk.dock().conflicts()->shown().startsWith(QLatin1String("Kitchen was changed here")),
                 qPrintable(desk.dock().conflicts()->shown()));
    desk.dock().conflicts()->nextButton()->click();
    QVERIFY(desk.dock().conflicts()->shown().startsWith(QLatin1String("Dock was changed here")));
    QCOMPARE(desk.editing().selected(), std::set<edit::Key>{"a"});
    desk.editing().select({"b"});
    QVERIFY(desk.dock().conflicts()->shown().startsWith(QLatin1String("Kitchen was changed here")));
    desk.dock().conflicts()->theirsButton()->click();
    QVERIFY(desk.dock().conflicts()->shown().startsWith(QLatin1String("Dock was changed here")));
  }

  void aConflictIsDecidedOnTheMap_data() {
    QTest::addColumn<QString>("choice");
    QTest::addColumn<QPointF>("where");  // the menu is opened
    QTest::addColumn<QPointF>("a");
    QTest::addColumn<int>("count");
    QTest::newRow("mine") << QStringLiteral("conflictMine") << QPointF(1.5, 1) << QPointF(1.5, 1) << 2;
    QTest::newRow("theirs") << QStringLiteral("conflictTheirs") << QPointF(1.5, 1) << QPointF(0.5, 0.5) << 2;
    QTest::newRow("where theirs lies")
        << QStringLiteral("conflictMine") << QPointF(0.5, 0.5) << QPointF(1.5, 1) << 2;
    QTest::newRow("both") << QStringLiteral("conflictBoth") << QPointF(1.5, 1) << QPointF(0.5, 0.5) << 3;
  }
  void aConflictIsDecidedOnTheMap() {
    QFETCH(QString, choice);
    QFETCH(QPointF, where);
    QFETCH(QPointF, a);
    QFETCH(int, count);
    Desk desk;
    desk.start();
    desk.editing().select({"a"});
    desk.editing().moveSelected({0.5, 0});
    desk.store.put(waypoint("a", 0.5, 0.5, "Dock"));
    Q_EMIT desk.store.changed();
    QTRY_VERIFY(!desk.dock().conflicts()->shown().isEmpty());
    const auto menuAt = [&](const QPointF& at) {
      auto menu = std::make_unique<QMenu>();
      ui::fillMapMenu(*menu, desk.window->actionList(), {at.x(), at.y()});
      return menu;
    };
    QVERIFY2(!menuAt({2.5, 0.5})->findChild<QAction*>(choice), "nothing is in conflict there");
    const auto menu = menuAt(where);
    QAction* const action = menu->findChild<QAction*>(choice);
    QVERIFY(action && action->isEnabled());
    action->trigger();
    QVERIFY(desk.dock().conflicts()->shown().isEmpty());
    QVERIFY(desk.near("a", a.x(), a.y()));
    QCOMPARE(int(desk.items().size()), count);
    if (count == 3) {
      const edit::Key mine = *desk.editing().selected().begin();
      QVERIFY(desk.near(mine, 1.5, 1) && desk.editing().find(mine)->name != "Dock");
      desk.undo().undo();
      QCOMPARE(int(desk.items().size()), 2);
    }
    QVERIFY(!menuAt(where)->findChild<QAction*>(choice));
  }

  void ofAMapWithoutAPictureTheWaypointsAreShown() {
    Desk desk;
    desk.prepare = [&, before = desk.prepare](test::FakeRobot& made) {
      before(made);
      made.maps.without_picture = {"2"};
    };
    desk.open();
    QVERIFY(!desk.window->connectTo(test::kAddress));
    part<MapsController>(*desk.window)->open({map::MapKind::Stored, "2"});
    QTRY_VERIFY(session::lacksPicture(desk.window->session()->wholeMap()));
    QTRY_VERIFY(desk.editing().document() && desk.editing().editable());
    QCOMPARE(int(desk.items().size()), 2);
    // They are looked at, drawn, and can be taken; the sentence stands above them.
    const QImage with = part<ExportController>(*desk.window)->mapPicture();
    for (const auto& [key, point] : desk.items()) {
      const QPoint at = desk.px(point.position_m.x(), point.position_m.y());
      QVERIFY(desk.window->view()->viewport()->rect().contains(at));
    }
    desk.window->mapScene()->setLayerVisible(ui::scene::Layer::Waypoints, false);
    QVERIFY(part<ExportController>(*desk.window)->mapPicture() != with);
    desk.window->mapScene()->setLayerVisible(ui::scene::Layer::Waypoints, true);
    desk.chooseTool();
    const map::Waypoint& one = desk.items().begin()->second;
    desk.click(desk.px(one.position_m.x(), one.position_m.y()));
    QCOMPARE(desk.editing().selected(), std::set<edit::Key>{desk.items().begin()->first});
    QVERIFY(!part<MapOverlay>(*desk.window)->card()->isVisible());
    NoticeBar* const notice = part<MapOverlay>(*desk.window)->notice();
    QTRY_VERIFY(notice->isVisible());
    QVERIFY2(notice->sentence().contains(QLatin1String("only sends its current map")),
             qPrintable(notice->sentence()));
    // Once is enough.
    QCOMPARE(desk.toasts(), QStringList());
    QVERIFY(!part<MapOverlay>(*desk.window)->placeNotice()->isVisible());
    QCOMPARE(desk.window->session()->problems().unresolved(), 0);
  }

  void theMenuOfTheMapAddsOneWhereItWasOpened() {
    Desk desk;
    desk.start();
    const auto offered = [&] {
      auto menu = std::make_unique<QMenu>();
      ui::fillMapMenu(*menu, desk.window->actionList(), {12.5, 3.25});
      return menu;
    };
    const auto menu = offered();
    const auto actions = menu->actions();
    const auto add = std::find_if(actions.begin(), actions.end(), [](const QAction* action) {
      return action->text().contains(QLatin1String("waypoint here"));
    });
    QVERIFY(add != actions.end());
    const std::size_t before = desk.items().size();
    (*add)->trigger();
    QCOMPARE(desk.items().size(), before + 1);
    QVERIFY(desk.editing().only());
    QCOMPARE(desk.editing().only()->position_m, Eigen::Vector2d(12.5, 3.25));
    desk.window->leaveRobot();
    const auto none = offered();
    for (const QAction* action : none->actions())
      QVERIFY(!action->text().contains(QLatin1String("waypoint here")));
  }

  void aRobotThatTakesNoChangesShowsThemReadOnly() {
    Desk desk;
    desk.writable = false;
    desk.told.points = {waypoint("7", 1, 1, "Gate"), waypoint("7", 2, 2, "Second of that id")};
    desk.start();
    QTRY_COMPARE(desk.dock().model()->rowCount(), 2);
    QVERIFY(!desk.editing().editable());
    QVERIFY(!desk.dock().addButton()->isEnabled());
    QVERIFY(desk.dock().statusShown().contains(QLatin1String("read-only")));
    desk.chooseTool();
    desk.click(desk.px(2, 0.5));
    desk.drag(desk.px(1, 1), desk.px(1.5, 1));
    QVERIFY(desk.near("7", 1, 1));
    desk.key(Qt::Key_Delete);
    QCOMPARE(desk.items().size(), std::size_t(2));
    QVERIFY(!desk.control().unsaved());
  }

  void whereNoneCanBeDeletedItIsOffAndSaysWhy() {
    Desk desk;
    desk.store.kept_fields.removal = desk.store.kept_fields.tags = false;
    desk.start();
    for (const QLineEdit* field : desk.dock().findChildren<QLineEdit*>())
      QVERIFY(!field->accessibleName().startsWith(QLatin1String("Tags")) || field->isHidden());
    desk.editing().select({"a"});
    QPushButton* const remove = desk.dock().removeButton();
    QVERIFY(!remove->isEnabled());
    QCOMPARE(remove->objectName(), desk.dock().saveButton()->objectName());  // the style knows it by that
    QVERIFY2(remove->toolTip().contains(QLatin1String("cannot be deleted")), qPrintable(remove->toolTip()));
    desk.chooseTool();
    desk.editing().select({"a"});
    desk.key(Qt::Key_Delete);
    QCOMPARE(desk.items().size(), std::size_t(2));
    QVERIFY(desk.toasts().join(QLatin1Char(' ')).contains(QLatin1String("cannot be deleted")));
    // A new one is only taken back.
    const edit::Key made = desk.editing().add({2, 2});
    QVERIFY(remove->isEnabled());
    desk.editing().removeSelected();
    QVERIFY(!desk.editing().find(made));
    // One that is deleted all the same, as by a draft, is told at once.
    desk.editing().make({desk.editing().document()->to("b", std::nullopt)}, QStringLiteral("delete"));
    QVERIFY2(desk.dock().statusShown().contains(QLatin1String("cannot be deleted")),
             qPrintable(desk.dock().statusShown()));
  }

  void whatIsStoredWhereNoneCanBeDeletedIsNotUndone() {
    Desk desk;
    desk.store.kept_fields.removal = false;
    desk.start();
    desk.editing().add({2, 2});
    desk.undo().undo();  // not stored yet
    QCOMPARE(desk.items().size(), std::size_t(2));
    desk.undo().redo();
    desk.action("save")->trigger();
    QTRY_VERIFY(!desk.control().unsaved());
    desk.action("undo")->trigger();
    QCOMPARE(desk.items().size(), std::size_t(3));
    QVERIFY(!desk.control().unsaved());
    QVERIFY2(desk.toasts().join(QLatin1Char(' ')).contains(QLatin1String("it was not undone")),
             qPrintable(desk.toasts().join(QLatin1Char(' '))));
  }

  void aWaypointIsRenamedAndDeletedFromTheMenuOfTheMap() {
    Desk desk;
    desk.start();
    std::unique_ptr<QMenu> menu;
    const auto actionAt = [&](const char* begins, double x, double y) -> QAction* {
      menu = std::make_unique<QMenu>();
      ui::fillMapMenu(*menu, desk.window->actionList(), {x, y});
      for (QAction* const action : menu->actions()) {
        if (action->text().startsWith(QLatin1String(begins))) return action;
      }
      return nullptr;
    };
    QVERIFY(!actionAt("&Delete", 2, 0.5));
    QAction* const rename = actionAt("Re&name Dock", 1, 1);
    QVERIFY(rename);
    rename->trigger();
    auto* const field = desk.window->view()->findChild<NameEditor*>();
    QVERIFY(field && field->isOpen());
    QTest::keyClick(field, Qt::Key_Escape);
    QAction* const remove = actionAt("&Delete Kitchen", 3, 2);
    QVERIFY(remove && remove->isEnabled());
    remove->trigger();
    QVERIFY(!desk.editing().find("b") && desk.editing().find("a"));
    menu.reset();
  }

  void movesThatComeBackOnTheirPixelAreNone() {
    Desk desk;
    desk.store.kept_fields.pixel_m = 0.05;
    desk.start();
    map::Waypoint moved = *desk.editing().find("a");
    moved.position_m.x() += 0.02;
    desk.editing().set("a", moved, QStringLiteral("move"));
    QVERIFY(!desk.control().unsaved() && desk.near("a", 1, 1));
    moved.position_m.x() = 1.04;
    desk.editing().set("a", moved, QStringLiteral("move"));
    QVERIFY(desk.control().unsaved());
  }

  void aRobotWithoutWaypointsSaysSo() {
    Desk desk;
    desk.writable = false;
    desk.open();
    QVERIFY(!desk.action("waypointTool")->isEnabled());
    QVERIFY(!desk.dock().emptyShown().isEmpty());
    QVERIFY(!desk.window->connectTo(test::kAddress));
    QTRY_VERIFY(desk.window->session()->wholeMap().cells());
    QVERIFY(!desk.action("waypointTool")->isEnabled());
    QVERIFY(desk.dock().emptyShown().contains(QLatin1String("no waypoints")));
    QVERIFY(desk.action("waypointTool")->toolTip().contains(QLatin1String("no waypoints")));
  }

  void thousandsAreFoundAtOnce() {
    Desk desk;
    desk.store.points.clear();
    for (int i = 0; i < 10'000; ++i)
      desk.store.points.push_back(
          waypoint("p" + std::to_string(i), 10 + i % 100, 10 + i / 100, "P" + std::to_string(i)));
    desk.start();
    QCOMPARE(desk.dock().model()->rowCount(), 10'000);
    desk.window->view()->lookAt({50, 50}, false);
    desk.chooseTool();
    desk.click(desk.px(50, 50));
    QCOMPARE(desk.editing().only()->position_m, Eigen::Vector2d(50, 50));
    const edit::Key gone = *desk.editing().selected().begin();
    desk.key(Qt::Key_Delete);
    QVERIFY(!desk.editing().find(gone));
    desk.click(desk.px(50, 50));  // nothing lies there any more
    QCOMPARE(desk.items().size(), std::size_t(10'000));
  }

  void handsSnapToThingsAndToTheGrid() {
    ui::scene::MapScene scene({});
    geometry::ViewTransform camera = scene.view();
    camera.scale_m_per_px = 0.01;
    scene.setView(camera);
    HitList hits(scene);
    PointIndex points;
    hits.add(ui::scene::Layer::Waypoints, &points);
    points.put("near", {0.05, 0});
    points.put("nearer", {0.03, 0});
    points.put("nowhere", {std::nan(""), 0});
    QCOMPARE(points.size(), std::size_t(2));
    const auto found = hits.at({0, 0}, 9);
    QCOMPARE(found.size(), std::size_t(2));
    QCOMPARE(found[0].key, std::string("nearer"));
    QVERIFY(std::abs(found[0].distance_px - 3) < 1e-9);
    const auto none = [](const Hit&) { return false; };
    WaypointSnapping snapping(&scene, &hits);
    const auto place = [&](double x, double y, Qt::KeyboardModifiers modifiers) {
      return snapping.place({x, y}, modifiers, none).at_m;
    };
    QCOMPARE(place(0, 0, {}), Eigen::Vector2d(0.03, 0));
    QCOMPARE(snapping.place({0, 0}, {}, [](const Hit& hit) { return hit.key == "nearer"; }).at_m,
             Eigen::Vector2d(0.05, 0));
    QCOMPARE(place(0.01, 0.02, Qt::AltModifier), Eigen::Vector2d(0.01, 0.02));
    QVERIFY((place(0.96, 1.04, Qt::ControlModifier) - Eigen::Vector2d(1, 1)).norm() < 1e-9);
    snapping.setOn(false);
    QCOMPARE(place(0, 0, {}), Eigen::Vector2d(0, 0));
    points.put("nearer", {5, 5});
    QCOMPARE(hits.at({0, 0}, 9).size(), std::size_t(1));
    scene.setLayerVisible(ui::scene::Layer::Waypoints, false);
    QVERIFY(hits.at({0, 0}, 9).empty());
  }

  void wordsAreRight() {
    QCOMPARE(tagsFrom(QStringLiteral(" a, ,b c,")), (std::vector<std::string>{"a", "b c"}));
    QCOMPARE(yawText(1.5707963267948966), QStringLiteral("90.0°"));
    QCOMPARE(yawText({}), QString());
    QCOMPARE(waypointsText(10'000), QStringLiteral("10,000 waypoints"));
    map::Waypoint nameless;
    nameless.id = "17";
    QCOMPARE(shortWaypointName(nameless), QStringLiteral("17"));
  }

  // A swap of names that broke off has left one, and nobody knows of it any more.
  void aTemporaryNameIsOfferedToBePutRight() {
    Desk desk;
    desk.store.points = {waypoint("a", 1, 1, "Dock ~1"), waypoint("b", 3, 2, "Kitchen")};
    desk.start();
    QVERIFY(desk.notice()->sentence().contains(QStringLiteral("\"Dock ~1\" looks like a temporary name")));
    desk.notice()->offerButton()->click();
    QCOMPARE(desk.editing().find("a")->name, std::string("Dock"));
    QVERIFY(desk.control().unsaved());
    QVERIFY(desk.notice()->sentence().contains(QStringLiteral("it will be called \"Dock\"")));
    desk.notice()->offerButton()->click();  // sends the rest
    QTRY_VERIFY(desk.store.find("Dock"));
    QTRY_VERIFY(desk.notice()->sentence().isEmpty());
  }

  void aTemporaryNameWhosePlaceIsTakenIsAskedFor() {
    Desk desk;
    desk.store.points = {waypoint("a", 1, 1, "Dock ~1"), waypoint("b", 3, 2, "Dock")};
    desk.start();
    QVERIFY(desk.notice()->sentence().contains(QStringLiteral("Another waypoint is called \"Dock\"")));
    desk.notice()->offerButton()->click();
    QVERIFY(desk.control().nameEditor()->isVisible());
    QCOMPARE(desk.editing().selected(), (std::set<edit::Key>{"a"}));
    QCOMPARE(desk.editing().find("a")->name, std::string("Dock ~1"));
  }

  void aNameThatOnlyLooksTemporaryMayStay() {
    Desk desk;
    desk.store.points = {waypoint("a", 1, 1, "Dock ~1"), waypoint("b", 3, 2, "Gate ~2")};
    desk.start();
    desk.notice()->secondButton()->click();
    QVERIFY(desk.notice()->sentence().contains(QStringLiteral("Gate ~2")));
    desk.notice()->secondButton()->click();
    QVERIFY(desk.notice()->sentence().isEmpty());
    QVERIFY(!desk.control().unsaved());
  }

  void unsavedWaypointsDoNotVanishWithTheMapThatTheRobotLeaves() {
    Desk desk;
    desk.start();
    QVERIFY(!desk.editing().add({2, 2}).empty());
    QVERIFY(desk.control().unsaved());
    desk.robot->maps.entries[0].is_current = false;  // somebody else loads another map
    desk.robot->maps.entries[1].is_current = true;
    Q_EMIT desk.robot->mapsChanged();
    const auto notice = [&] { return part<MapOverlay>(*desk.window)->notice(); };
    QTRY_VERIFY2(notice()->sentence().contains(
                     QStringLiteral("The unsaved waypoints of Ground floor are kept as a draft.")),
                 qPrintable(notice()->sentence()));
    notice()->offerButton()->click();
    QTRY_VERIFY(desk.window->session()->wholeMap().shown().key == (map::MapKey{map::MapKind::Stored, "1"}));
    QTRY_VERIFY(!notice()->sentence().contains(QStringLiteral("kept as a draft")));
  }
};

}  // namespace test_window_waypoints

MAPWRIGHT_TEST(test_window_waypoints, TestWindowWaypoints, Widgets)
#include "test_window_waypoints.moc"
