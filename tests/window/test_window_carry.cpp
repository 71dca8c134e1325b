// Waypoints of the reference map on the map on screen: what becomes of each, and those that are carried over.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QTableView>
#include <QtTest>

#include "../edit/fake_waypoint_store.h"
#include "overlays/overlay_shapes.h"
#include "reference_bench.h"
#include "test_program.h"
#include "ui/carry/carry_dock.h"
#include "ui/overlays/overlay_carrying.h"
#include "ui/overlays/overlays_controller.h"
#include "ui/scene/map_scene.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "ui/waypoints/waypoint_carrying.h"
#include "ui/waypoints/waypoints_controller.h"

namespace test_window_carry {

using namespace mapwright;
using namespace mapwright::ui;
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

/// Holds the overlays of one map.
class OneMapOverlays : public robot::OverlayStore {
 public:
  robot::Call read(const map::MapKey&, robot::OutcomeTo<robot::OverlayText> reply) override {
    QTimer::singleShot(0, &timers_, [this, reply] {
      if (unreadable) return reply(tl::make_unexpected(map::Failure{map::FailureKind::Unreachable}));
      reply(robot::OverlayText{.text = text, .version = 1, .map_uid = "u", .map_name = "Hall"});
    });
    return {};
  }
  robot::Call write(const map::MapKey&, const std::string&, robot::OutcomeTo<std::monostate>) override {
    ++writes;
    return {};
  }
  /// Points and lines by where they are on the map on screen, as with onOld().
  static std::string old() {
    const auto at = [](double x_m, double y_m) {
      return "[" + std::to_string(12 - y_m) + "," + std::to_string(x_m) + "]";
    };
    const auto point = [&](const char* id, const char* name, int type, double x_m, double y_m,
                           const std::string& more = {}) {
      return std::string(R"({"type":"Feature","id":")") + id +
             R"(","geometry":{"type":"Point","coordinates":)" + at(x_m, y_m) + R"(},"properties":{"type":")" +
             std::to_string(type) + R"(","name":")" + name + "\"" + more + "}}";
    };
    return R"({"type":"FeatureCollection","features":[)" +
           point("c1", "Charger", 9, 8, 2, R"(,"dockingPointId":"d1")") + "," +
           point("d1", "Docking", 10, 7.4, 2) + "," + point("p1", "Yard", 25, 30, 30) + "," +
           point("k1", "Known", 25, 3, 7) +
           R"(,{"type":"Feature","id":"w1","geometry":{"type":"LineString","coordinates":[)" + at(2, 6) +
           "," + at(4, 6) + R"(]},"properties":{"lineType":"2","name":"W17"}}]})";
  }

  std::string text = R"({"type":"FeatureCollection","features":[]})";
  bool unreadable = false;
  int writes = 0;

 private:
  QObject timers_;
};

struct CarryBench : test::ReferenceBench {
  CarryBench() {
    old_store.points = {onOld("Rack 10", 8, 2), onOld("Rack 9", 3, 7, 0.5), onOld("Hall", 10.5, 6),
                        onOld("Yard", 30, 30), onOld("Dock", 14, 5)};
    new_store.points = {test::waypoint("there", 14, 6, "Dock")};
    edit.drafts_folder = folder.filePath(QStringLiteral("drafts"));
    edit.later = [](std::chrono::milliseconds, const std::function<void()>&) {};
    old_overlays.text = OneMapOverlays::old();
    new_overlays.text =
        R"({"type":"FeatureCollection","features":[{"type":"Feature","id":"k1","geometry":{"type":"Point",)"
        R"("coordinates":[3,8]},"properties":{"type":"25","name":"Known"}}]})";
    also = [this](FakeRobot& made) {
      const bool of_old = made.address() == kFile;
      made.waypoint_store = of_old ? old : &new_store;
      made.overlay_store = of_old ? &old_overlays : &new_overlays;
    };
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
  void openOverlays() {
    openOn(Site::rooms(), Site::rooms().turned());
    align();
    QTRY_VERIFY(reference_dock().carryOverlaysButton()->isEnabled());
    QTest::mouseClick(reference_dock().carryOverlaysButton(), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(overlays().dock()->model()->rowCount(), 5, 60'000);
  }
  OverlayCarrying& overlays() { return *part<OverlaysController>(*window)->carrying(); }
  edit::OverlayEditing& overlayEditing() { return *part<OverlaysController>(*window)->editing(); }
  /// Texts of a column of that list, as shown.
  QString overlayColumn(int column) {
    QStringList texts;
    const QAbstractItemModel& shown = *overlays().dock()->table()->model();
    for (int row = 0; row < shown.rowCount(); ++row) texts << shown.index(row, column).data().toString();
    return texts.join(QLatin1Char('|'));
  }
  void clickOverlay(int row) {
    QTableView* const table = overlays().dock()->table();
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                      table->visualRect(table->model()->index(row, CarryModel::Called)).center());
  }
  /// By its id, in the overlays that are edited; none without it.
  std::optional<Eigen::Vector2d> overlayAt(const std::string& id) {
    const overlays::OverlayDocument mine = overlayEditing().document().mine();
    for (const overlays::Feature& feature : mine.features()) {
      if (feature.id() == id) return overlays::shapesOf(feature).somewhere();
    }
    return std::nullopt;
  }
  ReferenceDock& reference_dock() { return *part<ReferenceDock>(*window); }
  CarryDock& carry() { return *part<WaypointsController>(*window)->carrying()->dock(); }
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

  OneMapOverlays old_overlays, new_overlays;
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
             QStringLiteral("kept|kept|in an obstacle|outside|there already"));
    QCOMPARE(bench.carry().said(), QStringLiteral("2 sound, 2 to look at (1 in an obstacle, 1 outside), 1 on "
                                                  "the new map already"));
    QCOMPARE(bench.column(CarryModel::WallsOff)[3], QStringLiteral("–"));
    QVERIFY(bench.column(CarryModel::WallsOff)[0].toDouble() < 0.1);
  }

  void inANarrowPanelNeitherTheHeadsNorTheVerdictsAreCut() {
    CarryBench bench;
    bench.old_store.points[0].name = "Rack 10 behind the second door of the hall on the ground floor";
    bench.openList();
    bench.window->resize(1366, 768);
    QTableView* const table = bench.carry().table();
    const QHeaderView* const header = table->horizontalHeader();
    const auto wanted = [view = static_cast<const QAbstractItemView*>(table)](int column) {
      return view->sizeHintForColumn(column);
    };
    QTRY_VERIFY(header->length() <= table->viewport()->width());
    QTRY_VERIFY(header->sectionSize(CarryModel::Called) < wanted(CarryModel::Called));
    QVERIFY(header->sectionSize(CarryModel::WallsOff) >= header->sectionSizeHint(CarryModel::WallsOff));
    QVERIFY(header->sectionSize(CarryModel::Became) >= wanted(CarryModel::Became));
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
    // A long name is cut.
    const QAbstractItemModel& list = *bench.carry().table()->model();
    QVERIFY(list.index(0, CarryModel::Called)
                .data(Qt::ToolTipRole)
                .toString()
                .contains(list.index(0, CarryModel::Called).data().toString()));
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

  void aMapThatIsReadAgainHasChangedOnlyIfItsCellsHave() {
    CarryBench bench;
    const auto offers = bench.also;
    bench.also = [&](FakeRobot& made) {
      offers(made);
      made.maps.pictures["1"].fingerprint = "as it was";
    };
    bench.openList();
    const session::MapSlot& whole = bench.window->session()->wholeMap();
    const auto read_again = [&] {
      const auto before = whole.cells();
      bench.window->session()->openMap({map::MapKind::Stored, "1"});
      QTRY_VERIFY(whole.cells() && whole.cells() != before && whole.settled());
    };
    const QString said = bench.carry().said(), aligned = bench.reference_dock().alignmentSaid();
    read_again();
    QCOMPARE(bench.carry().said(), said);
    QCOMPARE(bench.reference_dock().alignmentSaid(), aligned);
    QVERIFY(!bench.carry().againButton()->isVisible());
    bench.robot->maps.pictures["1"].fingerprint = "otherwise";
    read_again();
    const QLatin1String changed("The map on screen has changed since then.");
    QVERIFY(bench.carry().said().startsWith(changed));
    QVERIFY(bench.carry().againButton()->isVisible());
    QVERIFY(bench.reference_dock().alignmentSaid().startsWith(changed));
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

  void overlaysHaveVerdictsToo() {
    CarryBench bench;
    bench.openOverlays();
    QCOMPARE(bench.overlayColumn(CarryModel::Called),
             QStringLiteral("Charger|Standby point Docking|Waypoint Yard|Waypoint Known|Virtual wall W17"));
    QCOMPARE(bench.overlayColumn(CarryModel::Became), QStringLiteral("kept|kept|outside|there already|kept"));
    QCOMPARE(bench.overlays().dock()->said(),
             QStringLiteral("3 sound, 1 to look at (1 outside), 1 on the new map already"));
    // A click shows what would become of it.
    bench.clickOverlay(4);
    QCOMPARE(bench.overlays().marks().shown().size(), std::size_t(1));
    QVERIFY((bench.overlays().marks().shown()[0].points[0] - Eigen::Vector2d(2, 6)).norm() < 0.05);
    QVERIFY((*bench.window->mapScene()->marker() - Eigen::Vector2d(3, 6)).norm() < 0.05);
  }

  void soundOverlaysBecomeUnsavedChanges() {
    CarryBench bench;
    bench.openOverlays();
    QTest::mouseClick(bench.overlays().dock()->soundButton(), Qt::LeftButton);
    QCOMPARE(bench.overlayEditing().document().mine().features().size(), std::size_t(4));
    QVERIFY((bench.overlayAt("c1").value() - Eigen::Vector2d(8, 2)).norm() < 0.05);
    QVERIFY(bench.overlayAt("w1") && !bench.overlayAt("p1"));
    QVERIFY((bench.overlayAt("k1").value() - Eigen::Vector2d(3, 8)).norm() < 1e-9);
    QVERIFY(bench.overlayEditing().document().unsaved());
    QCOMPARE(bench.new_overlays.writes, 0);
    QVERIFY(part<MapOverlay>(*bench.window)
                ->toasts()
                ->texts()
                .contains(QStringLiteral("3 features carried over. Nothing has been sent or saved yet.")));
    QCOMPARE(bench.overlayColumn(CarryModel::Became),
             QStringLiteral("carried over|carried over|outside|there already|carried over"));
    bench.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench.overlayEditing().document().mine().features().size(), std::size_t(1));
    QCOMPARE(bench.overlayColumn(CarryModel::Became), QStringLiteral("kept|kept|outside|there already|kept"));
  }

  void theBoxOfAllOverlaysGrowsWithThemAndIsTakenBackWithThem() {
    CarryBench bench;
    bench.new_overlays.text.insert(1, R"("bbox":[3,8,3,8],)");
    bench.openOverlays();
    const auto box = [&] {
      const auto collection = bench.overlayEditing().document().mine().collection();
      return std::string(collection->root().member("bbox")->text());
    };
    QTest::mouseClick(bench.overlays().dock()->soundButton(), Qt::LeftButton);
    QCOMPARE(bench.overlayEditing().document().mine().features().size(), std::size_t(4));
    const auto now = *overlays::JsonText::read(box());
    const auto sides = now.root().children();
    QCOMPARE(sides.size(), std::size_t(4));
    const std::vector<double> around{2, 2, 8, 8};  // the wall, the charger, the charger, what was there
    for (std::size_t i = 0; i < around.size(); ++i)
      QVERIFY2(std::abs(sides[i].number() - around[i]) < 0.05, box().c_str());
    bench.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(box(), std::string("[3,8,3,8]"));
    QVERIFY(!bench.overlayEditing().document().unsaved());
  }

  void aBoxOfAllOverlaysThatWasWrongStaysAndIsSaid() {
    CarryBench bench;
    bench.new_overlays.text.insert(1, R"("bbox":[0,0,1,1],)");
    bench.openOverlays();
    QTest::mouseClick(bench.overlays().dock()->soundButton(), Qt::LeftButton);
    QVERIFY(bench.overlayEditing().document().mine().text().find("[0,0,1,1]") != std::string::npos);
    QVERIFY(part<MapOverlay>(*bench.window)
                ->toasts()
                ->texts()
                .join(u' ')
                .contains(QLatin1String("The box (bbox) of all overlays did not fit them before")));
  }

  void overlaysThatReferToEachOtherGoTogether() {
    CarryBench bench;
    bench.openOverlays();
    bench.clickOverlay(1);
    QTest::mouseClick(bench.overlays().dock()->selectedButton(), Qt::LeftButton);
    QCOMPARE(bench.overlayColumn(CarryModel::Became),
             QStringLiteral("carried over|carried over|outside|there already|kept"));
    QVERIFY(bench.overlayAt("c1") && bench.overlayAt("d1") && !bench.overlayAt("w1"));
  }

  void whatBelongsToAnOverlayThatIsThereIsLeftOut() {
    CarryBench bench;
    bench.new_overlays.text =
        R"({"type":"FeatureCollection","features":[{"type":"Feature","id":"d1","geometry":{"type":"Point",)"
        R"("coordinates":[7,2]},"properties":{"type":"10","name":"Docking"}}]})";
    bench.openOverlays();
    QCOMPARE(bench.overlayColumn(CarryModel::Became),
             QStringLiteral("left out|there already|outside|kept|kept"));
    bench.clickOverlay(0);
    QVERIFY(!bench.overlays().dock()->selectedButton()->isEnabled());
    QTest::mouseClick(bench.overlays().dock()->soundButton(), Qt::LeftButton);
    QVERIFY(!bench.overlayAt("c1") && bench.overlayAt("w1"));
  }

  void overlaysThatCannotBeReadAreSaid() {
    CarryBench bench;
    bench.old_overlays.unreadable = true;
    bench.openOn(Site::rooms(), Site::rooms());
    QTRY_VERIFY(bench.reference_dock().carryOverlaysButton()->isEnabled());
    QTest::mouseClick(bench.reference_dock().carryOverlaysButton(), Qt::LeftButton);
    QTRY_VERIFY(bench.overlays().dock()->said().startsWith(
        QLatin1String("The overlays of the reference map cannot be read.")));
    bench.old_overlays.unreadable = false;
    bench.old_overlays.text = "{]";
    QTest::mouseClick(bench.overlays().dock()->againButton(), Qt::LeftButton);
    QTRY_VERIFY(bench.overlays().dock()->said().startsWith(
                    QLatin1String("The overlays of the reference map cannot be read.")) &&
                !bench.overlays().dock()->said().contains(QLatin1String("reached")));
  }

  void overlaysOfTheMapOnScreenMustBeReadable() {
    CarryBench bench;
    bench.new_overlays.unreadable = true;
    bench.openOn(Site::rooms(), Site::rooms());
    QPushButton* const button = bench.reference_dock().carryOverlaysButton();
    if (button->isEnabled()) {  // nobody has wanted to read them
      QTest::mouseClick(button, Qt::LeftButton);
      QTRY_VERIFY(
          bench.overlays().dock()->said().startsWith(QLatin1String("The overlays could not be read.")));
    }
    QVERIFY(!button->isEnabled());
    QVERIFY(button->toolTip().startsWith(QLatin1String("The overlays could not be read.")));
    QVERIFY(!bench.overlays().dock()->soundButton()->isEnabled());
  }

  void theListIsWorkedOffByKeys() {
    CarryBench bench;
    bench.openList();
    QTableView* const table = bench.carry().table();
    table->setFocus();
    const auto current = [&] { return table->currentIndex().data().toString(); };
    QTest::keyClick(table, Qt::Key_N);
    QCOMPARE(current(), QStringLiteral("Rack 10"));
    QVERIFY((*bench.window->mapScene()->marker() - Eigen::Vector2d(8, 2)).norm() < 0.05);
    QTest::keyClick(table, Qt::Key_A);
    QCOMPARE(bench.column(CarryModel::Became)[0], QStringLiteral("carried over"));
    QCOMPARE(current(), QStringLiteral("Rack 9"));
    QTest::keyClick(table, Qt::Key_X);
    QCOMPARE(bench.column(CarryModel::Became)[1], QStringLiteral("left out"));
    QCOMPARE(current(), QStringLiteral("Hall"));
    QCOMPARE(bench.carry().said(), QStringLiteral("0 sound, 2 to look at (1 in an obstacle, 1 outside), 1 on "
                                                  "the new map already, 1 left out, 1 carried over"));
    QTest::keyClick(table, Qt::Key_N);
    QCOMPARE(current(), QStringLiteral("Yard"));
    QTest::keyClick(table, Qt::Key_N);  // Dock is decided
    QCOMPARE(current(), QStringLiteral("Yard"));
    QTest::keyClick(table, Qt::Key_P);
    QTest::keyClick(table, Qt::Key_P);  // so are those above
    QCOMPARE(current(), QStringLiteral("Hall"));
    // It stays left out when they are looked at again, and comes back with the same key.
    bench.carry().adjustBox()->click();
    bench.waitForList();
    QCOMPARE(bench.column(CarryModel::Became)[1], QStringLiteral("left out"));
    bench.click(1);
    QTest::keyClick(table, Qt::Key_X);
    QVERIFY(bench.column(CarryModel::Became)[1] != QStringLiteral("left out"));
  }

  void keysGoOnWhereDecidedRowsAreHiddenOrMoved() {
    CarryBench bench;
    bench.openList();
    QTableView* const table = bench.carry().table();
    table->setFocus();
    table->sortByColumn(CarryModel::Became, Qt::AscendingOrder);
    QTest::keyClick(table, Qt::Key_N);
    QCOMPARE(table->currentIndex().data().toString(), QStringLiteral("Hall"));
    QTest::keyClick(table, Qt::Key_X);
    QCOMPARE(table->currentIndex().data().toString(), QStringLiteral("Yard"));
    bench.carry().filterBox()->setCurrentIndex(1);
    table->setCurrentIndex({});
    QTest::keyClick(table, Qt::Key_N);
    const QString first = table->currentIndex().data().toString();
    QTest::keyClick(table, Qt::Key_A);
    QCOMPARE(bench.column(CarryModel::Called).size(), 1);
    QVERIFY(table->currentIndex().data().toString() != first);
    QCOMPARE(bench.editing().document()->items().size(), std::size_t(2));
  }

  void thousandsAreListedAndCarriedOverAtOnce() {
    CarryBench bench;
    bench.old_store.points.clear();
    for (int i = 0; i < 5'000; ++i) {
      bench.old_store.points.push_back(
          onOld(("Rack " + std::to_string(i)).c_str(), 0.5 + i % 100 * 0.15, 0.5 + double(i / 100) * 0.2));
    }
    bench.openOn(Site::rooms(), Site::rooms().turned());
    bench.align();
    QTRY_VERIFY(bench.reference_dock().carryButton()->isEnabled());
    QTest::mouseClick(bench.reference_dock().carryButton(), Qt::LeftButton);
    bench.waitForList();
    QTableView* const table = bench.carry().table();
    QCOMPARE(table->model()->rowCount(), 5'000);
    table->setFocus();
    for (int i = 0; i < 20; ++i) QTest::keyClick(table, Qt::Key_PageDown);
    const int scrolled = table->currentIndex().row();
    QVERIFY(scrolled > 20);
    QTest::keyClick(table, Qt::Key_N);
    QVERIFY(table->currentIndex().row() > scrolled);
    table->selectAll();
    QTest::mouseClick(bench.carry().soundButton(), Qt::LeftButton);
    QVERIFY(bench.editing().document()->items().size() > 1'000);
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
