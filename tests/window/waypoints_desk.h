// A whole window on a robot whose waypoints are edited, for tests.
#pragma once

#include <QMessageBox>
#include <QPushButton>
#include <QTableView>

#include "../edit/fake_waypoint_store.h"
#include "ui/view/map_overlay.h"
#include "ui/view/notice_bar.h"
#include "ui/view/toast_stack.h"
#include "ui/waypoints/name_editor.h"
#include "ui/waypoints/waypoint_tool.h"
#include "ui/waypoints/waypoints_controller.h"
#include "ui/waypoints/waypoints_dock.h"
#include "window_bench.h"
#include "window_parts.h"

namespace mapwright::test {

using ui::MapTool;
using ui::NoticeBar;
using ui::WaypointEditing;
using ui::WaypointsController;
using ui::WaypointsDock;

/// A window on a robot of one map of 4 m x 3 m whose waypoints can be changed; 1 cm a pixel, its middle in
/// the middle.
struct WaypointsDesk : Bench {
  ~WaypointsDesk() { window.reset(); }  // before what its robot keeps
  explicit WaypointsDesk(FakeWaypointStore::Mode mode = FakeWaypointStore::Mode::AllAtOnce) : store(mode) {
    store.points = {waypoint("a", 1, 1, "Dock"), waypoint("b", 3, 2, "Kitchen")};
    prepare = [this](FakeRobot& made) {
      made.has_catalogue = true;
      made.has_submaps = false;
      made.maps.entries = {catalogued("1", "Ground floor"), catalogued("2", "Attic")};
      made.maps.entries[0].is_current = true;
      if (writable) made.waypoint_store = &store;
      if (!told.points.empty()) made.told_waypoints = &told;
    };
    edit.drafts_folder = folder.filePath(QStringLiteral("drafts"));
    edit.later = [](std::chrono::milliseconds, const std::function<void()>&) {};
  }
  void start() {
    open();
    QVERIFY(!window->connectTo(kAddress));
    QTRY_VERIFY(editing().document());
    look();
  }
  /// The dock in front of the others.
  void bringUp() {
    dock().show();
    dock().raise();
    QTRY_VERIFY(dock().table()->isVisible());
  }
  void look() {
    geometry::ViewTransform camera = window->mapScene()->view();
    camera.center_m = {2, 1.5};
    camera.scale_m_per_px = 0.01;
    window->view()->moveTo(camera, false);
  }
  WaypointsController& control() { return *ui::part<ui::WaypointsController>(*window); }
  WaypointEditing& editing() { return *control().editing(); }
  WaypointsDock& dock() { return *control().dock(); }
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
  void moveTo(const QPoint& at, Qt::KeyboardModifiers modifiers = {}) {
    QMouseEvent move(QEvent::MouseMove, at, window->view()->viewport()->mapToGlobal(at), Qt::NoButton,
                     Qt::LeftButton, modifiers);
    QApplication::sendEvent(window->view()->viewport(), &move);
  }
  void press(const QPoint& at) { QTest::mousePress(window->view()->viewport(), Qt::LeftButton, {}, at); }
  void release(const QPoint& at) { QTest::mouseRelease(window->view()->viewport(), Qt::LeftButton, {}, at); }
  void drag(const QPoint& from, const QPoint& to) {
    press(from);
    moveTo((from + to) / 2, Qt::AltModifier);
    moveTo(to, Qt::AltModifier);
    QTest::mouseRelease(window->view()->viewport(), Qt::LeftButton, Qt::AltModifier, to);
  }
  /// Whether to leave, or whether to discard all.
  void answer(QMessageBox::StandardButton button) {
    const auto asked = [this] {
      return control().discardQuestion() ? control().discardQuestion() : control().question();
    };
    QTRY_VERIFY(asked());
    asked()->button(button)->click();
  }
  void keepAsDraft() {
    QTRY_VERIFY(control().question());
    control().question()->findChild<QPushButton*>(QStringLiteral("keepDraft"))->click();
  }
  QStringList toasts() { return ui::part<ui::MapOverlay>(*window)->toasts()->texts(); }
  NoticeBar* notice() { return ui::part<ui::MapOverlay>(*window)->editNotice(); }
  bool near(const edit::Key& key, double x, double y) {
    const map::Waypoint* const point = editing().find(key);
    return point && (point->position_m - Eigen::Vector2d(x, y)).norm() < 0.011;
  }

  FakeWaypointStore store;
  map::WaypointList told;
  bool writable = true;
};

}  // namespace mapwright::test
