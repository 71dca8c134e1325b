// The table of waypoints: what is pending, several at once, tags, pasting and importing, conflicts, history.
#include <ctime>

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QCompleter>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QTableWidget>
#include <QUndoView>
#include <QtTest>

#include "test_program.h"
#include "ui/maps/export_controller.h"
#include "ui/maps/maps_controller.h"
#include "ui/view/map_overlay.h"
#include "ui/waypoints/waypoint_conflicts.h"
#include "ui/waypoints/waypoint_forms.h"
#include "ui/waypoints/waypoint_text.h"
#include "ui/waypoints/waypoint_transfer.h"
#include "waypoints_desk.h"
#include "window_parts.h"

namespace test_window_waypoints_table {

using namespace mapwright;
using namespace mapwright::ui;
using test::waypoint;

namespace {

struct Desk : test::WaypointsDesk {
  void open() {
    store.points = {waypoint("a", 1, 1, "Dock"), waypoint("b", 3, 2, "Kitchen"), waypoint("c", 2, 2, "Gate")};
    store.points[0].tags = {"charger", "dock"};
    store.points[1].tags = {"food"};
    start();
    bringUp();
  }
  QString stateOf(const edit::Key& key) {
    return dock().model()->indexOf(key, WaypointsModel::StateColumn).data(Qt::AccessibleTextRole).toString();
  }
  int rowsShown() { return dock().table()->model()->rowCount(); }
  void show(Pending pending) {
    dock().pendingChoice()->setCurrentIndex(dock().pendingChoice()->findData(int(pending)));
  }
  ImportDialog& asked() { return *control().transfer()->dialog(); }
  QString asking(int row, int column) { return asked().table()->item(row, column)->text(); }
  void putOnClipboard(const QString& text) { QGuiApplication::clipboard()->setText(text); }
  void tablePress(QKeySequence::StandardKey key) {
    dock().table()->setFocus();
    QTest::keySequence(dock().table(), QKeySequence(key));
  }
};

}  // namespace

class TestWindowWaypointsTable : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatIsPendingIsSaidOfEach() {
    Desk desk;
    desk.open();
    desk.editing().select({"a"});
    desk.editing().moveSelected({0.5, 0});
    desk.editing().rename("a", QStringLiteral("Port"));
    QCOMPARE(desk.stateOf("a"), QStringLiteral("Not saved yet: renamed, moved."));
    QCOMPARE(desk.stateOf("b"), QString());
    const edit::Key fresh = desk.editing().add({2, 1});
    QCOMPARE(desk.stateOf(fresh), QStringLiteral("Not saved yet: new."));
    desk.editing().select({"c"});
    desk.editing().removeSelected();
    QCOMPARE(desk.stateOf("c"), QStringLiteral("Not saved yet: deleted."));
    QVERIFY(desk.dock().model()->indexOf("c").data(Qt::FontRole).value<QFont>().strikeOut());
    QCOMPARE(desk.rowsShown(), 4);
    desk.show(kDeleted);
    QCOMPARE(desk.rowsShown(), 1);
    desk.show(kMoved);
    QCOMPARE(desk.rowsShown(), 1);
    desk.show(kUnsaved);
    QCOMPARE(desk.rowsShown(), 3);
    desk.key(Qt::Key_S, Qt::ControlModifier);
    QTRY_COMPARE(desk.rowsShown(), 0);
    desk.dock().pendingChoice()->setCurrentIndex(0);
    QCOMPARE(desk.rowsShown(), 3);
  }

  void whatWasDeletedCanBeRestoredFromItsRow() {
    Desk desk;
    desk.open();
    desk.editing().select({"b", "c"});
    desk.editing().removeSelected();
    desk.dock().table()->selectAll();
    QCOMPARE(desk.editing().selected(), std::set<edit::Key>{"a"});
    QCOMPARE(desk.dock().selectedDeleted().size(), std::size_t(2));
    desk.editing().restore(desk.dock().selectedDeleted());
    QCOMPARE(desk.items().size(), std::size_t(3));
    QVERIFY(!desk.control().unsaved());
  }

  void severalAreChangedAtOnceAsOneStep() {
    Desk desk;
    desk.open();
    desk.dock().table()->selectAll();
    GroupForm& form = *desk.dock().groupForm();
    QVERIFY(form.isVisible() && desk.dock().form()->isHidden());
    QVERIFY2(
        form.placeLabel()->text().contains(QStringLiteral("3 waypoints: x 1.00 … 3.00 m, y 1.00 … 2.00 m")),
        qPrintable(form.placeLabel()->text()));
    form.shiftX()->setValue(0.5);
    QTest::mouseClick(form.shiftButton(), Qt::LeftButton);
    QVERIFY(desk.near("a", 1.5, 1) && desk.near("b", 3.5, 2) && desk.near("c", 2.5, 2));
    QCOMPARE(desk.undo().count(), 1);
    form.turnBox()->setValue(90);
    QTest::mouseClick(form.turnButton(), Qt::LeftButton);
    form.turnChoice()->setCurrentIndex(1);
    form.turnBox()->setValue(-45);
    QTest::mouseClick(form.turnButton(), Qt::LeftButton);
    QVERIFY(std::abs(*desk.editing().find("b")->yaw_rad - 0.7853981) < 1e-6);
    QTest::keyClicks(form.addTagsEdit(), QStringLiteral("food, new one"));
    QTest::keyClick(form.addTagsEdit(), Qt::Key_Return);
    QCOMPARE(desk.editing().find("a")->tags,
             (std::vector<std::string>{"charger", "dock", "food", "new one"}));
    QCOMPARE(desk.editing().find("b")->tags, (std::vector<std::string>{"food", "new one"}));
    QTest::keyClicks(form.removeTagsEdit(), QStringLiteral("food"));
    QTest::keyClick(form.removeTagsEdit(), Qt::Key_Return);
    QCOMPARE(desk.editing().find("b")->tags, (std::vector<std::string>{"new one"}));
    QTest::keyClicks(form.typeEdit(), QStringLiteral("shelf"));
    QTest::keyClick(form.typeEdit(), Qt::Key_Return);
    QCOMPARE(desk.editing().find("c")->type, std::string("shelf"));
    QCOMPARE(desk.undo().count(), 6);
    for (int i = 0; i < 6; ++i) desk.undo().undo();
    QVERIFY(!desk.control().unsaved());
  }

  void tagsAreCompletedOneByOne() {
    Desk desk;
    desk.open();
    desk.dock().table()->selectRow(1);
    QLineEdit* const tags = desk.dock().form()->tagsEdit();
    tags->setFocus();
    tags->selectAll();
    QTest::keyClicks(tags, QStringLiteral("x, cha"));
    QCompleter* const completer = tags->completer();
    QCOMPARE(completer->completionCount(), 1);
    QCOMPARE(completer->currentCompletion(), QStringLiteral("x, charger"));
  }

  void rowsOfASpreadsheetAreShownBeforeTheyChangeAnything() {
    Desk desk;
    desk.open();
    desk.putOnClipboard(QStringLiteral("Name\tx\ty\theading\nDock\t1,5\t1\t90\nLift\t0,5\t2\t\n"));
    desk.tablePress(QKeySequence::Paste);
    QVERIFY(desk.control().transfer()->dialog());
    QVERIFY(desk.asked().headerBox()->isChecked() && desk.asked().commaBox()->isChecked());
    QCOMPARE(desk.asked().table()->rowCount(), 2);
    QCOMPARE(desk.asking(0, 0), QStringLiteral("Dock"));
    QCOMPARE(desk.asking(0, 1), QStringLiteral("moved"));
    QVERIFY2(desk.asking(0, 2).contains(QStringLiteral("position 1.000, 1.000 m → position 1.500, 1.000 m")),
             qPrintable(desk.asking(0, 2)));
    QCOMPARE(desk.asking(1, 1), QStringLiteral("new"));
    QVERIFY(!desk.control().unsaved());
    QTest::mouseClick(desk.asked().applyButton(), Qt::LeftButton);
    QVERIFY(desk.near("a", 1.5, 1));
    QCOMPARE(desk.items().size(), std::size_t(4));
    QCOMPARE(desk.undo().count(), 1);
    QCOMPARE(desk.editing().selected().size(), std::size_t(2));
  }

  void howATableIsReadCanBeChosen() {
    Desk desk;
    desk.open();
    desk.putOnClipboard(QStringLiteral("1\t2\t1.5\n"));
    desk.control().transfer()->paste();
    QVERIFY2(desk.asking(0, 2).contains(QStringLiteral("heading 85.9°")), qPrintable(desk.asking(0, 2)));
    QVERIFY(desk.asked().statusShown().contains(QLatin1String("read as radians")));
    QVERIFY(desk.asking(0, 0).startsWith(QLatin1String("Waypoint ")));
    desk.asked().turnChoice()->setCurrentIndex(1);
    QVERIFY2(desk.asking(0, 2).contains(QStringLiteral("heading 1.5°")), qPrintable(desk.asking(0, 2)));
    QVERIFY(!desk.asked().statusShown().contains(QLatin1String("read as radians")));
    desk.asked().headerBox()->setChecked(true);
    QVERIFY(!desk.asked().applyButton()->isEnabled());
    QVERIFY(!desk.asked().statusShown().isEmpty());
  }

  void otherTextOnTheClipboardIsRefusedInWords() {
    Desk desk;
    desk.open();
    desk.putOnClipboard(QStringLiteral("just <b>words</b>"));
    desk.control().transfer()->paste();
    QVERIFY(desk.asked().statusShown().contains(QLatin1String("two adjacent columns of numbers")));
    QVERIFY(!desk.asked().applyButton()->isEnabled());
  }

  void waypointsGoToAnotherMapByTheClipboard() {
    Desk desk;
    desk.open();
    desk.editing().select({"a", "b"});
    desk.tablePress(QKeySequence::Copy);
    QVERIFY(QGuiApplication::clipboard()->text().startsWith(QLatin1String("id\tname\tx\ty\tyaw_rad\ttags")));
    part<MapsController>(*desk.window)->open({map::MapKind::Stored, "2"});
    QTRY_VERIFY(desk.control().list() && desk.control().list()->map().id == "2" && desk.editing().document());
    desk.action("pasteWaypoints")->trigger();
    // The fake keeps one list for all maps: those names are taken.
    QCOMPARE(desk.items().size(), std::size_t(5));
    QCOMPARE(desk.editing().selected().size(), std::size_t(2));
    std::set<std::string> names;
    for (const edit::Key& key : desk.editing().selected()) {
      names.insert(desk.editing().find(key)->name);
      QVERIFY(key != "a" && key != "b");
    }
    QCOMPARE(names, (std::set<std::string>{"Dock 2", "Kitchen 2"}));
    QCOMPARE(desk.undo().count(), 1);
  }

  // Another program has only the text of it.
  void copiesAreTheSameFromAnotherWindow() {
    Desk desk;
    desk.open();
    std::vector<std::vector<map::Waypoint>> pasted;
    desk.editing().selectAll();
    desk.control().transfer()->copy();
    auto* const bytes = new QMimeData;
    const QMimeData& copied = *QGuiApplication::clipboard()->mimeData();
    for (const QString& format : copied.formats()) bytes->setData(format, copied.data(format));
    QVERIFY(bytes->hasFormat(QLatin1String(WaypointTransfer::kMime)) && bytes->hasText());
    for (const bool other_window : {false, true}) {
      if (other_window) QGuiApplication::clipboard()->setMimeData(bytes);
      desk.control().transfer()->paste();
      pasted.emplace_back();
      for (const edit::Key& key : desk.editing().inOrder()) {
        pasted.back().push_back(*desk.editing().find(key));
        pasted.back().back().id.clear();
      }
      QVERIFY(pasted.back().size() > 2);
      desk.action("undo")->trigger();
    }
    QVERIFY(pasted[0] == pasted[1]);
  }

  void filesComeInWithAPreviewAndGoOut() {
    Desk desk;
    desk.open();
    for (const char* ending : {"geojson", "csv"}) {
      const QString path = desk.folder.filePath(QStringLiteral("points.") + QLatin1String(ending));
      desk.control().transfer()->exportTo(path);
      QVERIFY(QFile::exists(path));
      desk.control().transfer()->importFile(path);
      QVERIFY(desk.asked().statusShown().contains(QLatin1String("Nothing changes")));
      desk.editing().select({"c"});
      desk.editing().removeSelected();
      desk.control().transfer()->importFile(path);
      QCOMPARE(desk.asked().table()->rowCount(), 1);
      QTest::mouseClick(desk.asked().applyButton(), Qt::LeftButton);
      QVERIFY(!desk.control().unsaved());
    }
    desk.editing().add({1, 2});
    desk.control().transfer()->importFile(desk.folder.filePath(QStringLiteral("points.csv")));
    desk.asked().othersBox()->setChecked(true);
    QCOMPARE(desk.asking(0, 1), QStringLiteral("deleted"));
    desk.asked().close();
    desk.control().transfer()->importFile(desk.folder.filePath(QStringLiteral("nowhere.csv")));
    QVERIFY(part<MapOverlay>(*desk.window)
                ->toasts()
                ->texts()
                .last()
                .contains(QLatin1String("nowhere.csv cannot be read")));
  }

  void conflictsAreGoneThroughOneByOneAndDrawnSideBySide() {
    Desk desk;
    desk.open();
    desk.editing().select({"a", "b"});
    desk.editing().moveSelected({0.5, 0});
    const QImage before = part<ExportController>(*desk.window)->mapPicture();
    desk.store.put(waypoint("a", 0.5, 2.5, "Dock"));
    desk.store.put(waypoint("b", 3.5, 1, "Kitchen"));
    Q_EMIT desk.store.changed();
    QTRY_VERIFY2(desk.dock().conflicts()->shown().contains(
                     QLatin1String("Dock was changed here and elsewhere (1 of 2).")),
                 qPrintable(desk.dock().conflicts()->shown()));
    QVERIFY(part<ExportController>(*desk.window)->mapPicture() != before);
    QTest::mouseClick(desk.dock().conflicts()->nextButton(), Qt::LeftButton);
    QVERIFY(desk.dock().conflicts()->shown().contains(
        QLatin1String("Kitchen was changed here and elsewhere (2 of 2).")));
    desk.show(kConflicting);
    QCOMPARE(desk.rowsShown(), 2);
    QTest::mouseClick(desk.dock().conflicts()->theirsButton(), Qt::LeftButton);
    QVERIFY(desk.near("b", 3.5, 1));
    QVERIFY(desk.dock().conflicts()->shown().contains(QLatin1String("Dock was changed here and elsewhere.")));
    desk.editing().select({"a"});
    desk.dock().conflicts()->mineButton()->setFocus();
    QTest::keyClick(desk.dock().conflicts()->mineButton(), Qt::Key_Space);
    QVERIFY(desk.dock().conflicts()->shown().isEmpty());
    // Not the next field: a key that is meant for the map would be typed into it.
    QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(desk.dock().table()));
  }

  void theHistoryGoesBackByAClick() {
    Desk desk;
    desk.open();
    desk.editing().rename("a", QStringLiteral("One"));
    desk.editing().rename("a", QStringLiteral("Two"));
    auto* const view = desk.window->findChild<QUndoView*>();
    QVERIFY(view);
    QCOMPARE(view->model()->rowCount(), 3);
    view->setCurrentIndex(view->model()->index(1, 0));
    QCOMPARE(desk.editing().find("a")->name, std::string("One"));
    view->setCurrentIndex(view->model()->index(0, 0));
    QCOMPARE(desk.editing().find("a")->name, std::string("Dock"));
  }

  void thousandsAreSelectedAndChangedAtOnce() {
    Desk desk;
    desk.store.points.clear();
    for (int i = 0; i < 20'000; ++i)
      desk.store.points.push_back(
          waypoint("p" + std::to_string(i), i % 200, i / 200, "P" + std::to_string(i)));
    desk.start();
    // The processor's time: what else the machine does is no matter. Told, not judged.
    std::clock_t begun = std::clock();
    const auto lap = [&](const char* what) {
      const std::clock_t now = std::clock();
      qInfo("%s: %.0f ms", what, 1000.0 * double(now - begun) / CLOCKS_PER_SEC);
      begun = now;
    };
    desk.dock().table()->selectAll();
    lap("select all");
    QCOMPARE(desk.editing().selected().size(), std::size_t(20'000));
    desk.editing().moveSelected({0.5, 0}, 7);
    lap("move");
    desk.editing().moveSelected({0.5, 0}, 7);
    lap("move once more");
    QCOMPARE(desk.undo().count(), 1);
    desk.undo().undo();
    lap("undo");
    desk.undo().redo();
    lap("redo");
    desk.editing().removeSelected();
    lap("delete");
    desk.undo().undo();
    lap("undo");
    desk.key(Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY(!desk.control().unsaved());
    lap("save");
  }
};

}  // namespace test_window_waypoints_table

MAPWRIGHT_TEST(test_window_waypoints_table, TestWindowWaypointsTable, Widgets)
#include "test_window_waypoints_table.moc"
