// What is wrong with overlays in the window: live, rules switched off, the robot's radius, the way to a point
// that cannot be reached; the states of overlays on the map.
#include <algorithm>

#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QToolButton>

#include "grids/grid_pyramid.h"
#include "overlays_desk.h"
#include "test_program.h"
#include "ui/overlays/overlay_flaws.h"
#include "ui/view/on_screen.h"

namespace test_window_overlay_flaws {

using namespace test_overlays_desk;

namespace {

/// A charger in the corridor, a desk, and a wall between them.
const char* const kCut =
    R"({"type":"FeatureCollection","features":[
{"id":"c","type":"Feature","geometry":{"type":"Point","coordinates":[-20.6,-9.2]},"properties":{"type":"9","name":"Dock","dockingPointId":"d"}},
{"id":"d","type":"Feature","geometry":{"type":"Point","coordinates":[-18,-9.2]},"properties":{"type":"36","name":"D"}},
{"id":"p","type":"Feature","geometry":{"type":"Point","coordinates":[-5,-9.2]},"properties":{"type":"25","name":"Desk"}},
{"id":"w","type":"Feature","geometry":{"type":"LineString","coordinates":[[-10,-15.5],[-10,20]]},"properties":{"lineType":"2","name":"W"}}]})";

QStringList flawsOf(Desk& desk) {
  QStringList all;
  for (int row = 0; row < desk.dock().flawList()->count(); ++row)
    all << desk.dock().flawList()->item(row)->text();
  return all;
}

/// With the whole map on screen.
void openCut(Desk& desk) {
  QVERIFY(desk.hand(kCut));
  desk.start();
  desk.window->session()->openMap({map::MapKind::Stored, "1"});
  QTRY_VERIFY(desk.window->session()->wholeMap().cells() &&
              desk.window->session()->wholeMap().cells()->complete());
  QTest::keyClick(desk.window->view(), Qt::Key_E);
  QTRY_COMPARE(desk.document().size(), std::size_t(4));
  QTRY_VERIFY(desk.control().checked());
}

}  // namespace

class TestWindowOverlayFlaws : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theWayToWhatCannotBeReachedIsDrawn() {
    Desk desk;
    openCut(desk);
    QTRY_COMPARE(flawsOf(desk),
                 QStringList{QStringLiteral("Waypoint Desk: The robot cannot get here from its charger.")});
    QVERIFY(desk.control().way().shown().empty());
    Q_EMIT desk.dock().flawList()->itemClicked(desk.dock().flawList()->item(0));
    QTRY_VERIFY(!desk.control().way().shown().empty());
    const auto& marks = desk.control().way().shown();
    QCOMPARE(marks.size(), std::size_t(3));
    QVERIFY(marks[0].kind == OverlayMark::Kind::Way && marks[2].kind == OverlayMark::Kind::Blocked);
    QVERIFY((marks[0].points.front() - Eigen::Vector2d(-20.6, -9.2)).norm() < 0.3);
    QVERIFY(std::abs(marks[2].points.front().x() + 10) < 0.8);
    QVERIFY(marks[1].points.back() == Eigen::Vector2d(-5, -9.2));
    // It goes with the selection, and the flaw with its cause.
    desk.editing().select({3});
    QVERIFY(desk.control().way().shown().empty());
    desk.editing().removeSelected();
    QTRY_VERIFY(flawsOf(desk).isEmpty());
    desk.action("undo")->trigger();
    QTRY_COMPARE(flawsOf(desk).size(), 1);
  }

  void wallsAreCheckedWhateverIsOnScreen() {
    Desk desk;
    QVERIFY(desk.hand(kCut));
    desk.start();
    setViewMode(*desk.window->mapScene(), ViewMode::Submaps);  // what the window opens with
    QTest::keyClick(desk.window->view(), Qt::Key_E);
    QTRY_COMPARE(desk.document().size(), std::size_t(4));
    QVERIFY(!(desk.window->session()->wholeMap().shown().key == map::MapKey{map::MapKind::Stored, "1"}));
    QTRY_COMPARE(flawsOf(desk),
                 QStringList{QStringLiteral("Waypoint Desk: The robot cannot get here from its charger.")});
  }

  void whatIsNotCheckedIsSaidInThePanelAndBeforeSaving() {
    Desk desk;
    simulator::Faults faults;  // before the window opens: a map on its way would still be whole
    faults.truncated_maps = true;
    desk.sim.setFaults(faults);
    desk.start();
    QTest::keyClick(desk.window->view(), Qt::Key_E);
    QTRY_COMPARE(desk.document().size(), std::size_t(3));
    const auto said = [&] {
      QStringList all;
      for (const QLabel* label : desk.dock().flaws()->findChildren<QLabel*>())
        if (!label->isHidden()) all << label->text();
      return all.join(QLatin1Char(' '));
    };
    // For good, not only while it is being read.
    QTRY_VERIFY2(said().contains(QLatin1String("Walls and reachability are not checked. ")),
                 qPrintable(said()));
    desk.editing().select({1});
    desk.editing().removeSelected();
    desk.action("save")->trigger();
    QTRY_VERIFY(desk.control().review());
    QStringList notes;
    for (const QLabel* label : desk.control().review()->findChildren<QLabel*>()) notes << label->text();
    QVERIFY(notes.join(QLatin1Char(' ')).contains(QLatin1String("Walls and reachability are not checked. ")));
  }

  void rulesAreSwitchedOffAndTheRadiusIsSetForGood() {
    const auto unreachable = [](Desk& desk) {
      const QList<QAction*> rules = desk.dock().flaws()->rulesButton()->menu()->actions();
      const auto found = std::find_if(rules.begin(), rules.end(), [](const QAction* rule) {
        return rule->text() == QLatin1String("Points that the robot cannot reach");
      });
      return found == rules.end() ? nullptr : *found;
    };
    {
      Desk desk;
      openCut(desk);
      QTRY_COMPARE(flawsOf(desk).size(), 1);
      OverlayFlaws& flaws = *desk.dock().flaws();
      QVERIFY(unreachable(desk));
      unreachable(desk)->trigger();
      QVERIFY(flaws.off().contains(overlays::Rule::Unreachable));
      QTRY_VERIFY(flawsOf(desk).isEmpty());
      flaws.radiusBox()->setValue(0.45);
      desk.window->close();
      desk.start();
      QVERIFY(desk.dock().flaws()->off().contains(overlays::Rule::Unreachable));
      QCOMPARE(desk.dock().flaws()->radius(), std::optional(0.45));
      QVERIFY(!unreachable(desk)->isChecked());
    }
  }

  void statesAreMarkedOnTheMap() {
    Desk desk;
    desk.open();
    QVERIFY(desk.control().states().shown().empty());
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    QCOMPARE(desk.control().states().shown().size(), std::size_t(1));
    QVERIFY(desk.control().states().shown()[0].state == ui::scene::WaypointMark::Unsaved);
    QVERIFY(desk.hand(Desk::with("\"speed\":0.40", "\"speed\":0.9")));
    desk.control().tool()->activate();
    QTRY_COMPARE(desk.control().states().shown().size(), std::size_t(2));
    QVERIFY(desk.control().states().shown()[1].state == ui::scene::WaypointMark::Theirs);
    desk.save();
    QVERIFY(desk.control().states().shown().empty());
  }
};

}  // namespace test_window_overlay_flaws

MAPWRIGHT_TEST(test_window_overlay_flaws, TestWindowOverlayFlaws, Widgets)
#include "test_window_overlay_flaws.moc"
