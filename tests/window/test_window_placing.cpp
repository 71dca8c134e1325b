// Waypoints placed on the map by hand and by number: framed, turned as a group, caught, along a line, warned
// of.
#include <QAction>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

#include "../edit/fake_waypoint_store.h"
#include "geometry/pose.h"
#include "test_program.h"
#include "ui/maps/export_controller.h"
#include "ui/maps/maps_controller.h"
#include "ui/view/map_overlay.h"
#include "ui/waypoints/line_bar.h"
#include "ui/waypoints/line_tool.h"
#include "ui/waypoints/waypoint_forms.h"
#include "ui/waypoints/waypoint_placing.h"
#include "ui/waypoints/waypoint_tool.h"
#include "ui/waypoints/waypoints_controller.h"
#include "ui/waypoints/waypoints_dock.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_placing {

using namespace mapwright;
using namespace mapwright::ui;
using test::FakeWaypointStore;
using test::waypoint;

namespace {

/// A window on a robot of one map of 4 m x 3 m, a wall of 25 cm along its left edge; 1 cm a pixel, its middle
/// in the middle.
struct Desk : test::Bench {
  ~Desk() { window.reset(); }  // before what its robot keeps
  Desk() {
    store.points = {waypoint("a", 1, 1, "Dock"), waypoint("b", 3, 2, "Kitchen")};
    prepare = [this](test::FakeRobot& made) {
      made.has_catalogue = true;
      made.has_submaps = false;
      made.has_live = true;
      made.maps.entries = {test::catalogued("1", "Ground floor")};
      made.maps.entries[0].is_current = true;
      made.waypoint_store = &store;
    };
    edit.drafts_folder = folder.filePath(QStringLiteral("drafts"));
    edit.later = [](std::chrono::milliseconds, const std::function<void()>&) {};
  }
  void start() {
    open();
    QVERIFY(!window->connectTo(test::kAddress));
    part<MapsController>(*window)->open({map::MapKind::Stored, "1"});
    QTRY_VERIFY(editing().document());
    geometry::ViewTransform camera = window->mapScene()->view();
    camera.center_m = {2, 1.5};
    camera.scale_m_per_px = 0.01;
    window->view()->moveTo(camera, false);
    QTRY_COMPARE(warnings().ground(), placing::GroundState::Known);
    settle();
  }
  void settle() { QTRY_VERIFY(!warnings().looking()); }
  WaypointsController& control() { return *part<WaypointsController>(*window); }
  WaypointEditing& editing() { return *control().editing(); }
  WaypointsDock& dock() { return *control().dock(); }
  WaypointWarnings& warnings() { return *control().placing()->warnings(); }
  LineTool& line() { return *control().placing()->actions()->lineTool(); }
  LineBar& lineBar() { return *control().placing()->actions()->lineBar(); }
  const edit::Items& items() { return editing().document()->items(); }
  QUndoStack& undo() { return editing().document()->undoStack(); }
  QPoint px(double x, double y) {
    const Eigen::Vector2d at = window->mapScene()->view().pixelFromWorld({x, y});
    return {qRound(at.x()), qRound(at.y())};
  }
  void chooseTool() {
    key(Qt::Key_W);
    QCOMPARE(window->view()->tool(), static_cast<MapTool*>(control().tool()));
  }
  void click(const QPoint& at, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseClick(window->view()->viewport(), Qt::LeftButton, modifiers, at);
  }
  void moveTo(const QPoint& at, Qt::KeyboardModifiers modifiers = {},
              Qt::MouseButtons held = Qt::LeftButton) {
    QMouseEvent move(QEvent::MouseMove, at, window->view()->viewport()->mapToGlobal(at), Qt::NoButton, held,
                     modifiers);
    QApplication::sendEvent(window->view()->viewport(), &move);
  }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers) {
    QTest::mousePress(window->view()->viewport(), Qt::LeftButton, modifiers, from);
    moveTo((from + to) / 2, modifiers);
    moveTo(to, modifiers);
    QTest::mouseRelease(window->view()->viewport(), Qt::LeftButton, modifiers, to);
  }
  bool near(const edit::Key& key, double x, double y) {
    const map::Waypoint* const point = editing().find(key);
    return point && (point->position_m - Eigen::Vector2d(x, y)).norm() < 0.011;
  }
  std::vector<placing::WarningKind> kinds(const edit::Key& key) {
    std::vector<placing::WarningKind> kinds;
    for (const placing::Warning& warning : warnings().of(key)) kinds.push_back(warning.kind);
    return kinds;
  }

  FakeWaypointStore store{FakeWaypointStore::Mode::AllAtOnce};
};

using placing::WarningKind;

}  // namespace

class TestWindowPlacing : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void shiftAndADragFrameSeveral() {
    Desk desk;
    desk.store.points.push_back(waypoint("c", 1.5, 1.2, "Gate"));
    desk.start();
    desk.chooseTool();
    const Eigen::Vector2d center = desk.window->mapScene()->view().center_m;
    desk.drag(desk.px(0.7, 1.6), desk.px(1.8, 0.8), Qt::ShiftModifier);
    QCOMPARE(desk.editing().selected(), (std::set<edit::Key>{"a", "c"}));
    QCOMPARE(desk.window->mapScene()->view().center_m, center);
    // What was selected before stays.
    desk.drag(desk.px(2.8, 2.2), desk.px(3.2, 1.8), Qt::ShiftModifier);
    QCOMPARE(desk.editing().selected().size(), std::size_t(3));
    desk.key(Qt::Key_Escape);
    QVERIFY(desk.editing().selected().empty());
    QCOMPARE(desk.undo().count(), 0);
    desk.click(desk.px(2, 2.5), Qt::ShiftModifier);  // a frame of nothing makes none
    QCOMPARE(desk.items().size(), std::size_t(3));
  }

  void aFrameOfATurnedViewHoldsWhatIsSeenInIt() {
    Desk desk;
    desk.store.points.push_back(waypoint("c", 1.5, 1.2, "Gate"));
    desk.start();
    desk.chooseTool();
    geometry::ViewTransform camera = desk.window->mapScene()->view();
    camera.rotation_rad = geometry::radiansFromDegrees(40);
    desk.window->view()->moveTo(camera, false);
    const QPoint at = desk.px(1, 1);
    desk.drag(at - QPoint(15, 15), at + QPoint(15, 15), Qt::ShiftModifier);
    QCOMPARE(desk.editing().selected(), std::set<edit::Key>{"a"});
  }

  void allAreSelectedAndTheSelectionIsInverted() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    desk.key(Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(desk.editing().selected().size(), std::size_t(2));
    desk.editing().select({"a"});
    desk.action("invertWaypoints")->trigger();
    QCOMPARE(desk.editing().selected(), std::set<edit::Key>{"b"});
  }

  void aGroupTurnsAboutItsMiddleByItsHandle() {
    Desk desk;
    desk.store.points = {waypoint("a", 1, 1.5, "Dock"), waypoint("b", 3, 1.5, "Kitchen")};
    desk.store.points[0].yaw_rad = 0;
    desk.start();
    desk.chooseTool();
    desk.editing().select({"a", "b"});
    const auto handle = desk.control().tool()->handle();
    QVERIFY(handle);
    QVERIFY((*handle - desk.px(2, 1.5)).manhattanLength() > 20);
    // From above the middle to its left: a quarter, and Shift makes it exact.
    desk.drag(handle->toPoint(), desk.px(0.6, 1.52), Qt::ShiftModifier);
    QVERIFY(desk.near("a", 2, 0.5) && desk.near("b", 2, 2.5));
    QVERIFY(std::abs(*desk.editing().find("a")->yaw_rad - geometry::radiansFromDegrees(90)) < 1e-9);
    QVERIFY(!desk.editing().find("b")->yaw_rad);
    QCOMPARE(desk.undo().count(), 1);
    desk.undo().undo();
    QVERIFY(desk.near("a", 1, 1.5));
  }

  void theTurnOfAGroupIsSeenAndEscCancelsIt() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    desk.editing().select({"a", "b"});
    const QPoint handle = desk.control().tool()->handle()->toPoint();
    QTest::mousePress(desk.window->view()->viewport(), Qt::LeftButton, {}, handle);
    desk.moveTo(handle + QPoint(60, 60));
    QCOMPARE(desk.editing().preview().size(), std::size_t(2));
    QVERIFY2(part<MapOverlay>(*desk.window)->hint().contains(QLatin1String("Turned by -")),
             qPrintable(part<MapOverlay>(*desk.window)->hint()));
    desk.key(Qt::Key_Escape);
    QVERIFY(desk.editing().preview().empty());
    QCOMPARE(desk.undo().count(), 0);
    QCOMPARE(desk.editing().selected().size(), std::size_t(2));
  }

  void aDragIsCaughtByTheLinesOfOthers() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    // b comes to the x of a: five centimetres beside are five pixels.
    desk.drag(desk.px(3, 2), desk.px(1.05, 2.4), {});
    QCOMPARE(desk.editing().find("b")->position_m.x(), 1.0);
    desk.undo().undo();
    desk.drag(desk.px(3, 2), desk.px(1.05, 2.4), Qt::AltModifier);
    QVERIFY(desk.near("b", 1.05, 2.4));
    desk.undo().undo();
    desk.key(Qt::Key_S);
    QVERIFY(!desk.action("snap")->isChecked());
    desk.drag(desk.px(3, 2), desk.px(1.05, 2.4), {});
    QVERIFY(desk.near("b", 1.05, 2.4));
  }

  void aDragIsCaughtAtItsDistanceFromAWall() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    desk.action("snapWaypoints")->trigger();
    desk.action("snapWalls")->trigger();
    desk.drag(desk.px(3, 2), desk.px(0.8, 2.4), {});
    QVERIFY(desk.near("b", 0.75, 2.4));
  }

  void aGuideIsSeenBeforeAClick() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    desk.moveTo(desk.px(2, 1.5), {}, Qt::NoButton);
    const QImage without = desk.window->view()->grab().toImage();
    desk.moveTo(desk.px(2.4, 1.04), {}, Qt::NoButton);
    QVERIFY(desk.window->view()->grab().toImage() != without);
    desk.click(desk.px(2.4, 1.04));
    QCOMPARE(desk.editing().only()->position_m.y(), 1.0);
  }

  void whatCatchesIsRemembered() {
    Desk desk;
    desk.start();
    desk.action("snapGrid")->trigger();
    desk.action("snap")->trigger();
    desk.action("snapDistances")->trigger();
    PlacingDialog* const dialog = desk.control().placing()->dialog();
    QVERIFY(dialog);
    dialog->grid()->setValue(0.2);
    dialog->radius()->setValue(0.8);
    dialog->accept();
    QCOMPARE(desk.warnings().radius(), 0.8);
    desk.window->close();
    desk.window.reset();
    desk.start();
    QVERIFY(!desk.action("snap")->isChecked());
    QVERIFY(desk.action("snapGrid")->isChecked());
    QCOMPARE(desk.control().placing()->snapping()->rules().grid_m, 0.2);
    QCOMPARE(desk.warnings().radius(), 0.8);
  }

  void aWaypointIsMadeWhereTheRobotIs() {
    Desk desk;
    desk.start();
    QVERIFY(!desk.action("waypointAtRobot")->isEnabled());
    QVERIFY(desk.action("waypointAtRobot")->toolTip().contains(QLatin1String("unknown")));
    desk.robot->say(map::TrackedPose{{2, 1.25, 0.5}});
    QTRY_VERIFY(desk.action("waypointAtRobot")->isEnabled());
    desk.action("waypointAtRobot")->trigger();
    const map::Waypoint* const made = desk.editing().only();
    QVERIFY(made);
    QCOMPARE(made->position_m, Eigen::Vector2d(2, 1.25));
    QCOMPARE(made->yaw_rad, std::optional(0.5));
    QVERIFY(desk.control().nameEditor()->isVisible());
  }

  void aWaypointIsMadeByItsNumbers() {
    Desk desk;
    desk.start();
    desk.key(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
    NewWaypointDialog* const dialog = desk.control().placing()->actions()->dialog();
    QVERIFY(dialog);
    QTest::keyClicks(dialog->nameEdit(), QStringLiteral("Lift"));
    dialog->x()->setValue(2.125);
    dialog->y()->setValue(-0.5);
    dialog->heading()->setValue(90);
    QTest::keyClick(dialog->nameEdit(), Qt::Key_Return);
    const map::Waypoint* const made = desk.editing().only();
    QVERIFY(made);
    QCOMPARE(made->name, std::string("Lift"));
    QCOMPARE(made->position_m, Eigen::Vector2d(2.125, -0.5));
    QVERIFY(std::abs(*made->yaw_rad - geometry::radiansFromDegrees(90)) < 1e-9);
    desk.settle();
    QCOMPARE(desk.kinds(*desk.editing().selected().begin()), std::vector{WarningKind::OutsideMap});
  }

  void aLineOfTwoClicksMakesSeveral() {
    Desk desk;
    desk.start();
    desk.key(Qt::Key_L);
    QCOMPARE(desk.window->view()->tool(), static_cast<MapTool*>(&desk.line()));
    QVERIFY(desk.lineBar().isVisible());
    QVERIFY(!desk.lineBar().createButton()->isEnabled());
    desk.lineBar().spacing()->setValue(0.5);
    desk.click(desk.px(1.5, 0.5), Qt::AltModifier);
    desk.moveTo(desk.px(2.5, 0.5), Qt::AltModifier, Qt::NoButton);
    QCOMPARE(desk.line().spots().size(), std::size_t(3));
    QVERIFY2(desk.lineBar().countShown().startsWith(QLatin1String("3 waypoints on 1.00 m")),
             qPrintable(desk.lineBar().countShown()));
    QVERIFY(!desk.lineBar().createButton()->isEnabled());  // it still follows the hand
    desk.click(desk.px(3.5, 0.5), Qt::AltModifier);
    QCOMPARE(desk.line().spots().size(), std::size_t(5));
    desk.lineBar().spacing()->setValue(1);
    QCOMPARE(desk.items().size(), std::size_t(2));
    desk.lineBar().createButton()->click();
    QCOMPARE(desk.items().size(), std::size_t(5));
    QCOMPARE(desk.editing().selected().size(), std::size_t(3));
    QCOMPARE(desk.undo().count(), 1);
    for (const edit::Key& key : desk.editing().selected())
      QVERIFY(std::abs(*desk.editing().find(key)->yaw_rad) < 0.02);
    desk.key(Qt::Key_Escape);
    QVERIFY(!desk.lineBar().isVisible());
  }

  void aSpacingThatIsRefusedIsSaid_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("said");
    QTest::newRow("none") << QStringLiteral("0") << QStringLiteral("0 is too small: at least 0.05 m.");
    QTest::newRow("negative") << QStringLiteral("-1") << QStringLiteral("-1 is too small: at least 0.05 m.");
    QTest::newRow("too large") << QStringLiteral("200")
                               << QStringLiteral("200 is too large: at most 100.00 m.");
  }
  void aSpacingThatIsRefusedIsSaid() {
    QFETCH(QString, typed);
    QFETCH(QString, said);
    Desk desk;
    desk.start();
    desk.key(Qt::Key_L);
    desk.drag(desk.px(1.5, 0.5), desk.px(3.5, 0.5), Qt::AltModifier);
    QVERIFY(desk.line().ready());
    QDoubleSpinBox* const box = desk.lineBar().spacing();
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, typed);
    QVERIFY(!desk.window->findChild<QLabel*>(QStringLiteral("outOfRange")));
    QTest::keyClick(box, Qt::Key_Return);
    auto* const note = desk.window->findChild<QLabel*>(QStringLiteral("outOfRange"));
    QVERIFY(note && note->isVisible());
    QCOMPARE(note->text(), said);
    QCOMPARE(box->value(), 1.0);
    QCOMPARE(box->text(), QStringLiteral("1.00 m"));
    QCOMPARE(desk.line().spacing(), 1.0);
    QCOMPARE(desk.items().size(), std::size_t(2));  // nothing is made with another one
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(desk.items().size(), std::size_t(5));
    // Whoever goes on with the mouse is told as well.
    note->hide();
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, typed);
    desk.lineBar().prefixEdit()->setFocus();
    QVERIFY(note->isVisible());
    QCOMPARE(box->value(), 1.0);
  }

  void aLineIsDraggedAndEnterMakesIt() {
    Desk desk;
    desk.start();
    desk.key(Qt::Key_L);
    desk.drag(desk.px(2, 0.5), desk.px(2, 2.52), Qt::AltModifier);
    QVERIFY(desk.line().ready());
    desk.key(Qt::Key_Return);
    QCOMPARE(desk.items().size(), std::size_t(5));
    QVERIFY(!desk.line().ready());
    desk.drag(desk.px(2, 0.5), desk.px(2.1, 0.6), Qt::AltModifier);
    desk.key(Qt::Key_Escape);
    QCOMPARE(desk.line().length(), 0.0);
    QVERIFY(desk.lineBar().isVisible());
    QCOMPARE(desk.items().size(), std::size_t(5));
  }

  void whatIsSelectedIsDuplicatedBesideItself() {
    Desk desk;
    desk.store.points[0].tags = {"charger"};
    desk.store.points[0].yaw_rad = 1;
    desk.start();
    QVERIFY(!desk.action("duplicateWaypoints")->isEnabled());
    desk.editing().select({"a"});
    desk.key(Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(desk.items().size(), std::size_t(3));
    const map::Waypoint* const copy = desk.editing().only();
    QVERIFY(copy);
    QCOMPARE(copy->name, std::string("Dock 2"));
    QCOMPARE(copy->tags, std::vector<std::string>{"charger"});
    QCOMPARE(copy->yaw_rad, std::optional(1.0));
    QVERIFY((copy->position_m - Eigen::Vector2d(1, 1)).norm() > 0.2);
    desk.undo().undo();
    QCOMPARE(desk.items().size(), std::size_t(2));
  }

  void severalAreAlignedAndDistributed() {
    Desk desk;
    desk.store.points.push_back(waypoint("c", 3.5, 1.2, "Gate"));
    desk.start();
    desk.editing().select({"a", "b"});
    QVERIFY(desk.action("alignWaypointsY")->isEnabled());
    QVERIFY(!desk.action("distributeWaypointsX")->isEnabled());
    desk.action("alignWaypointsY")->trigger();
    QVERIFY(desk.near("a", 1, 1.5) && desk.near("b", 3, 1.5));
    desk.editing().selectAll();
    desk.action("distributeWaypointsX")->trigger();
    QVERIFY(desk.near("a", 1, 1.5) && desk.near("b", 2.25, 1.5) && desk.near("c", 3.5, 1.2));
    QCOMPARE(desk.undo().count(), 2);
  }

  void aWaypointInAWallIsWarnedOfEverywhere() {
    Desk desk;
    desk.store.points.push_back(waypoint("c", 0.1, 1.2, "Gate"));
    desk.start();
    QCOMPARE(desk.kinds("c"), std::vector{WarningKind::InWall});
    QVERIFY(desk.kinds("a").empty());
    QVERIFY(!desk.dock().warningsButton()->isHidden());
    QCOMPARE(desk.dock().warningsButton()->text(), QStringLiteral("1"));
    QCOMPARE(desk.dock().warningsButton()->accessibleName(), QStringLiteral("1 warning"));
    const QModelIndex row = desk.dock().model()->indexOf("c");
    QVERIFY(!row.data(Qt::DecorationRole).isNull());
    QVERIFY(row.data(Qt::ToolTipRole).toString().contains(QLatin1String("in a wall")));
    QVERIFY(row.data(Qt::AccessibleTextRole).toString().contains(QLatin1String("in a wall")));
    QVERIFY(desk.dock().model()->indexOf("a").data(Qt::DecorationRole).isNull());
    QVERIFY(desk.dock().form()->warningsShown().isEmpty());
    desk.dock().warningsButton()->click();
    QCOMPARE(desk.editing().selected(), std::set<edit::Key>{"c"});
    QVERIFY(desk.dock().form()->warningsShown().contains(QLatin1String("in a wall")));
    // Out of it, and all of it goes.
    desk.editing().select({});
    desk.editing().select({"c"});
    desk.editing().moveSelected({1.9, 0});
    QTRY_VERIFY(desk.kinds("c").empty());
    QVERIFY(desk.dock().warningsButton()->isHidden());
    QVERIFY(desk.dock().form()->warningsShown().isEmpty());
    QVERIFY(row.data(Qt::DecorationRole).isNull());
  }

  void theMarkOnTheMapIsAShapeOfItsOwn() {
    Desk desk;
    desk.store.points[0].yaw_rad = 0;
    desk.start();
    const QImage without = part<ExportController>(*desk.window)->mapPicture();
    desk.editing().rename("b", QStringLiteral("Dock"));  // twice the same name, and no place has changed
    QTRY_COMPARE(desk.warnings().count(), std::size_t(2));
    desk.undo().undo();
    QTRY_COMPARE(desk.warnings().count(), std::size_t(0));
    QCOMPARE(part<ExportController>(*desk.window)->mapPicture(), without);
    desk.warnings().setZeroTurns({"a"});
    QCOMPARE(desk.warnings().count(), std::size_t(1));
    QVERIFY(part<ExportController>(*desk.window)->mapPicture() != without);
  }

  void aWarningComesWhileTheHandMoves() {
    Desk desk;
    desk.start();
    desk.chooseTool();
    QTest::mousePress(desk.window->view()->viewport(), Qt::LeftButton, Qt::AltModifier, desk.px(1, 1));
    desk.moveTo(desk.px(0.6, 1.2), Qt::AltModifier);
    desk.moveTo(desk.px(0.4, 1.2), Qt::AltModifier);
    QTRY_COMPARE(desk.kinds("a"), std::vector{WarningKind::NearWall});
    QVERIFY(std::abs(desk.warnings().of("a").front().distance_m - 0.15) < 0.011);
    desk.key(Qt::Key_Escape);
    QTRY_VERIFY(desk.kinds("a").empty());
  }

  void theRobotsOwnShapeCounts() {
    Desk desk;
    desk.store.points[0].position_m = {0.65, 1};
    desk.start();
    QVERIFY(desk.kinds("a").empty());  // 40 cm, more than the 30 that a robot is taken to have
    map::RobotModel model;
    model.footprint = {{0.3, 0.4}, {-0.3, 0.4}, {-0.3, -0.4}, {0.3, -0.4}};
    desk.robot->say(model);
    QTRY_COMPARE(desk.warnings().radius(), 0.5);
    QTRY_COMPARE(desk.kinds("a"), std::vector{WarningKind::NearWall});
    desk.action("snapDistances")->trigger();
    QVERIFY(!desk.control().placing()->dialog()->radius()->isEnabled());
  }

  void aTurnOfZeroIsWarnedOfUntilItIsTurned() {
    Desk desk;
    // Of all that are kept so, however many, and not of one that is merely turned to zero, or called alike.
    for (int i = 0; i < 30; ++i) {
      desk.store.points.push_back(waypoint("z" + std::to_string(i), 2, 1, i % 2 ? "Pier" : ""));
      desk.store.zero_turns.insert(desk.store.points.back().id);
    }
    for (map::Waypoint& point : desk.store.points) point.yaw_rad = 0;
    desk.start();
    for (int i = 0; i < 30; ++i) QVERIFY(desk.kinds("z" + std::to_string(i)).back() == WarningKind::ZeroTurn);
    QVERIFY(desk.kinds("a").empty());
    map::Waypoint turned = *desk.editing().find("z0");
    turned.yaw_rad = 1;
    desk.editing().set("z0", turned, QStringLiteral("turn"));
    QVERIFY(desk.kinds("z0").empty());
    desk.undo().undo();
    QCOMPARE(desk.kinds("z0"), std::vector{WarningKind::ZeroTurn});
    desk.store.zero_turns.clear();
    Q_EMIT desk.store.changed();
    QTRY_VERIFY(desk.kinds("z0").empty());
  }

  void aDragOfManyIsDrawnWhereTheHandIs() {
    Desk desk;
    desk.store.points.clear();
    for (int i = 0; i < 1'000; ++i)
      desk.store.points.push_back(waypoint("p" + std::to_string(i), 0.5 + (i % 40) * 0.05,
                                           0.5 + (i / 40) * 0.05, "P" + std::to_string(i)));
    desk.start();
    desk.editing().selectAll();
    desk.chooseTool();
    const QImage before = part<ExportController>(*desk.window)->mapPicture();
    QTest::mousePress(desk.window->view()->viewport(), Qt::LeftButton, Qt::AltModifier, desk.px(0.5, 0.5));
    desk.moveTo(desk.px(0.7, 0.5), Qt::AltModifier);
    desk.moveTo(desk.px(1, 0.5), Qt::AltModifier);
    QVERIFY(part<ExportController>(*desk.window)->mapPicture() != before);
    desk.moveTo(desk.px(1.5, 1), Qt::AltModifier);
    const QImage there = part<ExportController>(*desk.window)->mapPicture();
    desk.key(Qt::Key_Escape);
    QVERIFY(part<ExportController>(*desk.window)->mapPicture() != there);
    QVERIFY(desk.near("p0", 0.5, 0.5));
    desk.drag(desk.px(0.5, 0.5), desk.px(1.5, 1), Qt::AltModifier);
    QVERIFY(desk.near("p0", 1.5, 1) && desk.near("p999", 3.45, 2.2));
    // They are found where they are now, and not where they were.
    desk.editing().select({});
    desk.click(desk.px(1.5, 1));
    QCOMPARE(desk.editing().selected(), std::set<edit::Key>{"p0"});
    desk.undo().undo();
    QVERIFY(desk.near("p0", 0.5, 0.5));
  }

  void theNextWarningGoesRound() {
    Desk desk;
    desk.store.points = {waypoint("a", 0.1, 1, "A"), waypoint("b", 2, 1, "B"), waypoint("c", 0.1, 2, "C")};
    desk.start();
    QCOMPARE(desk.dock().warningsButton()->accessibleName(), QStringLiteral("2 warnings"));
    for (const char* key : {"a", "c", "a"}) {
      desk.key(Qt::Key_F8);
      QCOMPARE(desk.editing().selected(), std::set<edit::Key>{key});
    }
  }

  void twentyThousandAreLookedAtBesideTheWindow() {
    Desk desk;
    desk.store.points.clear();
    for (int i = 0; i < 20'000; ++i)
      desk.store.points.push_back(
          waypoint("p" + std::to_string(i), (i % 200) * 0.02, (i / 200) * 0.03, "P" + std::to_string(i)));
    desk.start();
    QTRY_VERIFY(desk.warnings().count() > 1000);
    const auto before = desk.warnings().count();
    // Only what has changed is looked at again.
    desk.editing().select({"p0"});
    desk.editing().moveSelected({2, 1});
    desk.settle();
    QCOMPARE(desk.warnings().count(), before - 1);
  }
};

}  // namespace test_window_placing

MAPWRIGHT_TEST(test_window_placing, TestWindowPlacing, Widgets)
#include "test_window_placing.moc"
