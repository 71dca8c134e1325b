// Waypoints of the reference map on the map on screen: what becomes of each, and those that are carried over.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QTableView>
#include <QtTest>

#include "../edit/fake_waypoint_store.h"
#include "reference_bench.h"
#include "scene/map_scene.h"
#include "test_program.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "ui/carry/carry_dock.h"
#include "ui/waypoints/waypoints_controller.h"

namespace test_window_carry {

using namespace mapwright;
using namespace mapwright::window;
using test::FakeRobot;
using test::FakeWaypointStore;
using test::kFile;
using test::Site;

namespace {

/// By where it is on the map on screen; the old one is turned by a quarter.
map::Waypoint onOld(const char* name, double x_m, double y_m, double yaw_rad = 0) {
  map::Waypoint made = test::waypoint(name, 12 - y_m, x_m, name);
  made.yaw_rad = yaw_rad + geometry::radiansFromDegrees(90);
  return made;
}

struct CarryBench : test::ReferenceBench {
  CarryBench() {
    old_store.points = {onOld("Rack 10", 8, 2), onOld("Rack 9", 3, 7, 0.5), onOld("Hall", 10.5, 6),
                        onOld("Yard", 30, 30), onOld("Dock", 14, 5)};
    new_store.points = {test::waypoint("there", 14, 6, "Dock")};
    edit.drafts_folder = folder.filePath(QStringLiteral("drafts"));
    edit.later = [](std::chrono::milliseconds, const std::function<void()>&) {};
    also = [this](FakeRobot& made) { made.waypoint_store = made.address() == kFile ? old : &new_store; };
  }
  ~CarryBench() { window.reset(); }  // before what its robots keep

  /// The hall has a new rack. Aligned, and the list is there.
  void openList() {
    Site now = Site::rooms();
    now.wall(200, 110, 220, 130);
    openOn(now, Site::rooms().turned());
    align();
    QTRY_VERIFY(reference_dock().carryButton()->isEnabled());
    QTest::mouseClick(reference_dock().carryButton(), Qt::LeftButton);
    waitForList();
  }
  void waitForList() {
    QTRY_COMPARE_WITH_TIMEOUT(carry().model()->rowCount(), int(old_store.points.size()), 60'000);
    QVERIFY(carry().table()->isVisible());
  }
  ReferenceDock& reference_dock() { return *part<ReferenceDock>(*window); }
  CarryDock& carry() { return *part<CarryDock>(*window); }
  WaypointEditing& editing() { return *part<WaypointsController>(*window)->editing(); }
  const map::Waypoint* called(const std::string& name) {
    for (const auto& [key, point] : editing().document()->items()) {
      if (point.name == name) return &point;
    }
    return nullptr;
  }
  QStringList column(int column) {
    QStringList texts;
    const QAbstractItemModel& shown = *carry().table()->model();
    for (int row = 0; row < shown.rowCount(); ++row) texts << shown.index(row, column).data().toString();
    return texts;
  }
  QPoint middleOf(int row) {
    return carry().table()->visualRect(carry().table()->model()->index(row, CarryModel::Called)).center();
  }
  void click(int row, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseClick(carry().table()->viewport(), Qt::LeftButton, modifiers, middleOf(row));
  }

  FakeWaypointStore old_store{FakeWaypointStore::Mode::AllAtOnce};
  FakeWaypointStore new_store{FakeWaypointStore::Mode::AllAtOnce};
  robot::WaypointStore* old = &old_store;  // null: the old map has no waypoints
};

bool liesAt(const map::Waypoint* point, double x_m, double y_m) {
  return point && (point->position_m - Eigen::Vector2d(x_m, y_m)).norm() < 0.05;
}

}  // namespace

class TestWindowCarry : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void eachHasAVerdict() {
    CarryBench bench;
    bench.openList();
    QCOMPARE(bench.column(CarryModel::Called).join(u'|'), QStringLiteral("Rack 10|Rack 9|Hall|Yard|Dock"));
    QCOMPARE(bench.column(CarryModel::Became).join(u'|'),
             QStringLiteral("kept|kept|in an obstacle|outside|on the new map already"));
    QCOMPARE(bench.carry().said(), QStringLiteral("2 sound, 2 to look at (1 in an obstacle, 1 outside), 1 on "
                                                  "the new map already"));
    QCOMPARE(bench.column(CarryModel::WallsOff)[3], QStringLiteral("–"));
    QVERIFY(bench.column(CarryModel::WallsOff)[0].toDouble() < 0.1);
  }

  void anotherMapOfTheRobotHasItsOwnWaypoints() {
    CarryBench bench;
    bench.openOn(Site::rooms(), Site::rooms());
    bench.robot->maps.pictures["2"] = Site::rooms().turned().map({map::MapKind::Stored, "2"});
    Q_EMIT part<MapsController>(*bench.window)->alignWanted({map::MapKind::Stored, "2"});
    QTRY_VERIFY_WITH_TIMEOUT(bench.reference_dock().alignmentSaid().startsWith(QLatin1String("Sure")),
                             60'000);
    QTRY_VERIFY(bench.reference_dock().carryButton()->isEnabled());
    QTest::mouseClick(bench.reference_dock().carryButton(), Qt::LeftButton);
    QCOMPARE(bench.new_store.read_of, (map::MapKey{map::MapKind::Stored, "2"}));
    QTRY_COMPARE_WITH_TIMEOUT(bench.carry().model()->rowCount(), 1, 60'000);
  }

  void thoseThatAreSoundBecomeChangesThatCanBeUndone() {
    CarryBench bench;
    bench.openList();
    QTest::mouseClick(bench.carry().soundButton(), Qt::LeftButton);
    QCOMPARE(bench.editing().document()->items().size(), std::size_t(3));
    QVERIFY(liesAt(bench.called("Rack 10"), 8, 2));
    QVERIFY(liesAt(bench.called("Rack 9"), 3, 7));
    QVERIFY(std::abs(*bench.called("Rack 9")->yaw_rad - 0.5) < 0.02);
    QVERIFY(liesAt(bench.called("Dock"), 14, 6));
    QCOMPARE(bench.column(CarryModel::Became)[0], QStringLiteral("carried over"));
    QVERIFY(part<MapOverlay>(*bench.window)
                ->toasts()
                ->texts()
                .contains(QStringLiteral("2 waypoints carried over. Nothing has been sent or saved yet.")));
    QCOMPARE(bench.new_store.points.size(), std::size_t(1));  // nothing was sent
    QVERIFY(!bench.carry().soundButton()->isEnabled());
    // One step, of the waypoints and not of the reference map that was laid before.
    bench.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench.editing().document()->items().size(), std::size_t(1));
    QCOMPARE(bench.column(CarryModel::Became)[0], QStringLiteral("kept"));
    QVERIFY(bench.carry().soundButton()->isEnabled());
  }

  void whatIsNotSoundGoesOnlyWhenItIsSelected() {
    CarryBench bench;
    bench.openList();
    QVERIFY(!bench.carry().selectedButton()->isEnabled());
    bench.click(4);  // it is there already
    QVERIFY(!bench.carry().selectedButton()->isEnabled());
    bench.click(2, Qt::ControlModifier);
    QTest::mouseClick(bench.carry().selectedButton(), Qt::LeftButton);
    QCOMPARE(bench.editing().document()->items().size(), std::size_t(2));
    QVERIFY(liesAt(bench.called("Hall"), 10.5, 6));
    QVERIFY(liesAt(bench.called("Dock"), 14, 6));
    // It is known when they are looked at again.
    bench.carry().adjustBox()->click();
    bench.waitForList();
    QCOMPARE(bench.column(CarryModel::Became)[2], QStringLiteral("carried over"));
  }

  void theListIsFilteredAndSorted() {
    CarryBench bench;
    bench.openList();
    bench.carry().filterBox()->setCurrentIndex(1);
    QCOMPARE(bench.column(CarryModel::Called).join(u'|'), QStringLiteral("Rack 10|Rack 9"));
    bench.carry().filterBox()->setCurrentIndex(2);
    QCOMPARE(bench.column(CarryModel::Called).join(u'|'), QStringLiteral("Hall|Yard"));
    bench.carry().filterBox()->setCurrentIndex(0);
    bench.carry().table()->sortByColumn(CarryModel::Called, Qt::AscendingOrder);
    QCOMPARE(bench.column(CarryModel::Called).join(u'|'), QStringLiteral("Dock|Hall|Rack 9|Rack 10|Yard"));
    bench.carry().table()->sortByColumn(CarryModel::Became, Qt::AscendingOrder);
    QCOMPARE(bench.column(CarryModel::Called).mid(0, 2).join(u'|'), QStringLiteral("Hall|Yard"));
    QCOMPARE(bench.column(CarryModel::Called).last(), QStringLiteral("Dock"));
    bench.carry().table()->sortByColumn(CarryModel::WallsOff, Qt::AscendingOrder);
    QCOMPARE(bench.column(CarryModel::Called).first(), QStringLiteral("Yard"));
  }

  void aRowIsShownOnTheMapByAClickOrEnter() {
    CarryBench bench;
    bench.openList();
    const auto shows = [&](double x_m, double y_m) {
      const Eigen::Vector2d at(x_m, y_m);
      const auto& marker = bench.window->mapScene()->marker();
      return marker && (*marker - at).norm() < 0.05 &&
             (bench.window->mapScene()->view().center_m - at).norm() < 0.1;
    };
    bench.click(0);
    QVERIFY(shows(8, 2));
    QTest::keyClick(bench.carry().table(), Qt::Key_Down);
    QTest::keyClick(bench.carry().table(), Qt::Key_Return);
    QVERIFY(shows(3, 7));
  }

  void aReferenceMapThatWasMovedIsCheckedAgain() {
    CarryBench bench;
    bench.openList();
    QVERIFY(!bench.carry().againButton()->isVisible());
    bench.reference_dock().xBox()->setValue(bench.reference_dock().xBox()->value() + 1);
    QCOMPARE(bench.carry().model()->rowCount(), 0);
    QVERIFY(bench.carry().said().contains(QLatin1String("was moved")));
    QVERIFY(!bench.carry().soundButton()->isEnabled());
    QTest::mouseClick(bench.carry().againButton(), Qt::LeftButton);
    bench.waitForList();
    QVERIFY((bench.carry().model()->rows()[0].carried.spot.position_m - Eigen::Vector2d(9, 2)).norm() < 0.05);
  }

  void isAdjustedToTheWallsNearby() {
    CarryBench bench;
    bench.openList();
    bench.reference_dock().xBox()->setValue(bench.reference_dock().xBox()->value() + 0.2);
    bench.carry().adjustBox()->click();
    bench.waitForList();
    QCOMPARE(bench.column(CarryModel::Became)[0], QStringLiteral("adjusted"));
    QTest::mouseClick(bench.carry().soundButton(), Qt::LeftButton);
    QVERIFY(liesAt(bench.called("Rack 10"), 8, 2));
  }

  void withoutWaypointsThereIsNothingToCarryOver() {
    CarryBench bench;
    bench.old = nullptr;
    bench.openOn(Site::rooms(), Site::rooms());
    QVERIFY(!bench.reference_dock().carryButton()->isEnabled());
    QCOMPARE(bench.reference_dock().carryButton()->toolTip(),
             QStringLiteral("The reference map has no waypoints."));
  }

  void anEmptyListOfWaypointsIsSaid() {
    CarryBench bench;
    bench.old_store.points.clear();
    bench.openOn(Site::rooms(), Site::rooms());
    QTRY_VERIFY(bench.reference_dock().carryButton()->isEnabled());
    QTest::mouseClick(bench.reference_dock().carryButton(), Qt::LeftButton);
    QTRY_COMPARE(bench.carry().said(), QStringLiteral("The reference map has no waypoints."));
    bench.reference_dock().removeButton()->click();
    QVERIFY(!bench.reference_dock().carryButton()->isEnabled());
  }

  void whatCannotBeReadIsSaid() {
    CarryBench bench;
    bench.old_store.unreadable = true;
    bench.openOn(Site::rooms(), Site::rooms());
    QTRY_VERIFY(bench.reference_dock().carryButton()->isEnabled());
    QTest::mouseClick(bench.reference_dock().carryButton(), Qt::LeftButton);
    QTRY_VERIFY(bench.carry().said().contains(QLatin1String("cannot be read")));
    QVERIFY(bench.carry().againButton()->isVisible());
  }
};

}  // namespace test_window_carry

MAPWRIGHT_TEST(test_window_carry, TestWindowCarry, Widgets)
#include "test_window_carry.moc"
