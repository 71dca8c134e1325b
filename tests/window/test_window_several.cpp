// Several waypoints at once: named along a line, renamed, mirrored, headed along their way; each is one step.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QtTest>

#include "geometry/pose.h"
#include "test_program.h"
#include "ui/waypoints/line_bar.h"
#include "ui/waypoints/line_tool.h"
#include "ui/waypoints/mirror_tool.h"
#include "ui/waypoints/rename_dialog.h"
#include "ui/waypoints/waypoint_arranging.h"
#include "ui/waypoints/waypoint_forms.h"
#include "ui/waypoints/waypoint_placing.h"
#include "ui/waypoints/waypoints_dock.h"
#include "ui/waypoints/waypoints_model.h"
#include "waypoints_desk.h"

namespace test_window_several {

using namespace mapwright;
using namespace mapwright::ui;
using test::waypoint;

namespace {

constexpr double kQuarter = geometry::radiansFromDegrees(90);

struct Desk : test::WaypointsDesk {
  LineTool& line() { return *control().placing()->actions()->lineTool(); }
  LineBar& bar() { return *control().placing()->actions()->lineBar(); }
  RenameDialog* dialog() { return control().placing()->arranging()->renameDialog(); }
  /// As a hand does it: to whatever has the focus.
  static void type(const QString& text) {
    for (const QChar c : text) QTest::keyClicks(QApplication::focusWidget(), c);
  }
  static void type(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }
  void drawLine() {
    key(Qt::Key_L);
    bar().spacing()->setValue(0.5);
    drag(px(0.5, 0.5), px(2.52, 0.5));
    QVERIFY(line().ready());
  }
  QStringList names() {
    QStringList names;
    for (const auto& [key, point] : items()) names << QString::fromStdString(point.name);
    names.sort();
    return names;
  }
  std::string nameOf(const edit::Key& key) { return editing().find(key)->name; }
  double yawOf(const edit::Key& key) { return editing().find(key)->yaw_rad.value_or(99); }
  QString row(int row, int column) { return dialog()->model()->index(row, column).data().toString(); }
  void ask() {
    action("renameWaypoints")->trigger();
    QVERIFY(dialog());
  }
  void accept() {
    QTest::mouseClick(dialog()->renameButton(), Qt::LeftButton);
    QTRY_VERIFY(!dialog());
  }
};

struct Corridor : Desk {
  Corridor() {
    store.points = {waypoint("a", 3, 1, "Gate 10"), waypoint("b", 1, 1, "Gate 9"),
                    waypoint("c", 2, 2, "Lift")};
  }
};

}  // namespace

class TestWindowSeveral : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatIsTypedAfterALineIsTheirName() {
    Desk desk;
    desk.start();
    desk.drawLine();
    QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(desk.bar().prefixEdit()));
    const geometry::ViewTransform view = desk.window->mapScene()->view();
    Desk::type(QStringLiteral("Corr "));
    Desk::type(Qt::Key_Tab);
    Desk::type(QStringLiteral("08"));
    QCOMPARE(desk.bar().namesShown(), QStringLiteral("Corr 08 … Corr 12"));
    QVERIFY(desk.window->mapScene()->view() == view);
    Desk::type(Qt::Key_Return);
    QCOMPARE(desk.names(),
             QStringLiteral("Corr 08,Corr 09,Corr 10,Corr 11,Corr 12,Dock,Kitchen").split(QLatin1Char(',')));
    QCOMPARE(desk.undo().count(), 1);
    QCOMPARE(desk.editing().selected().size(), std::size_t(5));
    // The next line goes on.
    desk.drag(desk.px(0.5, 2.5), desk.px(1.02, 2.5));
    QCOMPARE(desk.bar().namesShown(), QStringLiteral("Corr 13 … Corr 14"));
    QCOMPARE(desk.bar().firstEdit()->placeholderText(), QStringLiteral("13"));
  }

  void takenNamesAreLeftOutAndTold() {
    Desk desk;
    desk.store.points[0].name = "Corr 2";
    desk.start();
    desk.drawLine();
    Desk::type(QStringLiteral("Corr "));
    // What cannot be counted from is not cut, and makes no names.
    for (const char* typed : {"12345678901234567890", "1e9", "0.5"}) {
      desk.bar().firstEdit()->clear();
      QTest::keyClicks(desk.bar().firstEdit(), QLatin1String(typed));
      QCOMPARE(desk.bar().firstEdit()->text(), QLatin1String(typed));
      QVERIFY(desk.bar().namesShown().contains(QLatin1String("at most 9")));
      QVERIFY(!desk.bar().createButton()->isEnabled());
    }
    desk.bar().firstEdit()->setText(QStringLiteral("1"));
    QCOMPARE(desk.bar().namesShown(), QStringLiteral("Corr 1 … Corr 6; Corr 2 is taken and left out"));
    // Another operator takes one more while it is typed.
    desk.store.put(waypoint("b", 3, 2, "Corr 4"));
    Q_EMIT desk.store.changed();
    QTRY_COMPARE(desk.bar().namesShown(), QStringLiteral("Corr 1 … Corr 7; 2 names are taken and left out"));
    desk.bar().stepBox()->setValue(10);
    QCOMPARE(desk.bar().namesShown(), QStringLiteral("Corr 1 … Corr 41"));
    QTest::mouseClick(desk.bar().createButton(), Qt::LeftButton);
    QVERIFY(desk.names().contains(QStringLiteral("Corr 41")));
  }

  void escLeavesTheLineBeforeTheTool() {
    Desk desk;
    desk.start();
    desk.drawLine();
    Desk::type(QStringLiteral("Corr"));
    Desk::type(Qt::Key_Escape);
    QVERIFY(!desk.line().ready());
    QVERIFY(desk.bar().isVisible());
    Desk::type(Qt::Key_Escape);
    QVERIFY(!desk.bar().isVisible());
    QCOMPARE(desk.items().size(), std::size_t(2));
  }

  void aSelectionIsRenamedAsItIsListed() {
    Corridor desk;
    desk.start();
    desk.bringUp();
    desk.editing().selectAll();
    desk.dock().table()->setFocus();
    Desk::type(Qt::Key_F2);
    QVERIFY(desk.dialog());
    QTRY_VERIFY(desk.dialog()->patternEdit()->hasFocus());
    Desk::type(QStringLiteral("Corr ##"));
    QCOMPARE(desk.row(0, NewNamesModel::NowColumn), QStringLiteral("Gate 9"));  // as people count
    QCOMPARE(desk.row(0, NewNamesModel::NewColumn), QStringLiteral("Corr 01"));
    QCOMPARE(desk.row(2, NewNamesModel::NewColumn), QStringLiteral("Corr 03"));
    QVERIFY(desk.names().contains(QStringLiteral("Lift")));  // nothing has changed yet
    Desk::type(Qt::Key_Return);
    QTRY_VERIFY(!desk.dialog());
    QCOMPARE(desk.nameOf("b"), std::string("Corr 01"));
    QCOMPARE(desk.nameOf("a"), std::string("Corr 02"));
    QCOMPARE(desk.undo().count(), 1);
    QCOMPARE(desk.action("undo")->text(), QStringLiteral("&Undo rename 3 waypoints"));
    desk.undo().undo();
    QCOMPARE(desk.nameOf("b"), std::string("Gate 9"));
  }

  void theyAreCountedInOtherOrders_data() {
    QTest::addColumn<int>("order");
    QTest::addColumn<bool>("reversed");
    QTest::addColumn<QString>("first");
    QTest::newRow("by x") << 1 << false << QStringLiteral("Gate 9");
    QTest::newRow("by x, reversed") << 1 << true << QStringLiteral("Gate 10");
    QTest::newRow("by y, reversed") << 2 << true << QStringLiteral("Lift");
    QTest::newRow("along their line") << 3 << false << QStringLiteral("Gate 9");
    QTest::newRow("as selected") << 4 << false << QStringLiteral("Lift");
  }
  void theyAreCountedInOtherOrders() {
    QFETCH(int, order);
    QFETCH(bool, reversed);
    QFETCH(QString, first);
    Corridor desk;
    desk.start();
    for (const char* key : {"c", "a", "b"}) desk.editing().toggle(key);
    desk.ask();
    desk.dialog()->patternEdit()->setText(QStringLiteral("N"));
    desk.dialog()->orderChoice()->setCurrentIndex(order);
    desk.dialog()->reverseBox()->setChecked(reversed);
    QCOMPARE(desk.row(0, NewNamesModel::NowColumn), first);
    QCOMPARE(desk.row(0, NewNamesModel::NewColumn), QStringLiteral("N 1"));
  }

  void collisionsAreMarkedBeforeAnythingChanges_data() {
    QTest::addColumn<bool>("may_double");
    QTest::newRow("a robot that refuses them") << false;
    QTest::newRow("a file that keeps them") << true;
  }
  void collisionsAreMarkedBeforeAnythingChanges() {
    QFETCH(bool, may_double);
    Corridor desk;
    desk.store.kept_fields.name_twice = may_double;
    desk.start();
    desk.editing().select({"a", "b"});
    desk.ask();
    desk.dialog()->howChoice()->setCurrentIndex(1);
    desk.dialog()->findEdit()->setText(QStringLiteral("Gate 9"));
    desk.dialog()->replacementEdit()->setText(QStringLiteral("Lift"));
    QCOMPARE(desk.row(0, NewNamesModel::TroubleColumn), QStringLiteral("another waypoint has this name"));
    QCOMPARE(desk.row(1, NewNamesModel::TroubleColumn), QStringLiteral("stays"));
    QCOMPARE(desk.dialog()->renameButton()->isEnabled(), may_double);
    QCOMPARE(desk.dialog()->statusShown(),
             may_double
                 ? QStringLiteral("1 name changes. 1 name would not be unique.")
                 : QStringLiteral("1 name changes. 1 name would not be unique. This robot refuses that."));
    desk.dialog()->replacementEdit()->clear();
    QVERIFY(!desk.dialog()->renameButton()->isEnabled());  // no name is left
    QCOMPARE(desk.undo().count(), 0);
  }

  void theListIsInOrderAfterSeveralWereRenamed() {
    Desk desk;
    desk.store.points = {waypoint("a", 1, 1, "Cafe"), waypoint("b", 2, 1, "Dock"),
                         waypoint("c", 3, 1, "Lift"), waypoint("d", 4, 1, "Start")};
    desk.start();
    desk.editing().renameAll({{"a", QStringLiteral("Z 1")}, {"b", QStringLiteral("Z 2")}});
    const auto listed = [&] {
      const QAbstractItemModel* rows = part<WaypointsDock>(*desk.window)->table()->model();
      QStringList names;
      for (int row = 0; row < rows->rowCount(); ++row)
        names << rows->index(row, WaypointsModel::NameColumn).data().toString();
      return names;
    };
    QCOMPARE(listed(), QStringList({QStringLiteral("Lift"), QStringLiteral("Start"), QStringLiteral("Z 1"),
                                    QStringLiteral("Z 2")}));
  }

  void anotherOperatorRenamesMeanwhile() {
    Corridor desk;
    desk.store.kept_fields.name_twice = false;
    desk.start();
    desk.editing().select({"a", "b"});
    desk.ask();
    desk.dialog()->patternEdit()->setText(QStringLiteral("Corr #"));
    QVERIFY(desk.dialog()->renameButton()->isEnabled());
    desk.store.put(waypoint("c", 2, 2, "Corr 2"));
    Q_EMIT desk.store.changed();
    QTRY_COMPARE(desk.row(1, NewNamesModel::TroubleColumn), QStringLiteral("another waypoint has this name"));
    QVERIFY(!desk.dialog()->renameButton()->isEnabled());
    desk.store.remove("b");
    Q_EMIT desk.store.changed();
    QTRY_COMPARE(desk.dialog()->model()->rowCount(), 1);
    desk.accept();
    QCOMPARE(desk.nameOf("a"), std::string("Corr 1"));
  }

  void namesAreTextWhateverIsInThem() {
    Desk desk;
    const QString odd = QString::fromUtf8("<b>Küche</b> & 😀");
    desk.store.points[0].name = odd.toStdString();
    desk.start();
    desk.editing().select({"a"});
    desk.ask();
    desk.dialog()->patternEdit()->setText(QStringLiteral("* #"));
    QCOMPARE(desk.row(0, NewNamesModel::NewColumn), odd + QStringLiteral(" 1"));
    QVERIFY(!desk.dialog()
                 ->model()
                 ->index(0, NewNamesModel::NewColumn)
                 .data(Qt::ToolTipRole)
                 .toString()
                 .contains(QLatin1String("<b>")));
    desk.accept();
    QCOMPARE(desk.nameOf("a"), (odd + QStringLiteral(" 1")).toStdString());
  }

  void twoThousandAreRenamedAndMirroredAtOnce() {
    Desk desk;
    desk.store.points.clear();
    for (int i = 0; i < 2'000; ++i)
      desk.store.points.push_back(
          waypoint("w" + std::to_string(i), 0.002 * i, 0.1 * (i % 20), "Rack " + std::to_string(i)));
    desk.start();
    desk.bringUp();
    desk.editing().selectAll();
    desk.ask();
    desk.dialog()->patternEdit()->setText(QStringLiteral("Rack ####"));
    QCOMPARE(desk.dialog()->model()->rowCount(), 2'000);
    QCOMPARE(desk.row(1'999, NewNamesModel::NewColumn), QStringLiteral("Rack 2000"));
    desk.accept();
    QCOMPARE(desk.undo().count(), 1);
    desk.action("mirrorWaypointsX")->trigger();
    QCOMPARE(desk.undo().count(), 2);
    QVERIFY(desk.near("w0", 3.998, 0));
    desk.action("headWaypointsNext")->trigger();
    QCOMPARE(desk.undo().count(), 3);
    desk.undo().undo();
    desk.undo().undo();
    QVERIFY(desk.near("w0", 0, 0));
    QCOMPARE(desk.nameOf("w0"), std::string("Rack 0001"));
  }

  void theyAreMirrored() {
    Corridor desk;
    desk.store.points[0].yaw_rad = 0;
    desk.start();
    desk.editing().select({"a", "b"});
    desk.key(Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(desk.near("a", 1, 1) && desk.near("b", 3, 1));
    QVERIFY(std::abs(std::abs(desk.yawOf("a")) - 2 * kQuarter) < 1e-9);
    QVERIFY(!desk.editing().find("b")->yaw_rad);
    QCOMPARE(desk.undo().count(), 1);
    desk.editing().select({"a", "c"});
    desk.action("mirrorWaypointsY")->trigger();
    QVERIFY(desk.near("a", 1, 2) && desk.near("c", 2, 1));
    desk.editing().select({});
    QVERIFY(!desk.action("mirrorWaypointsX")->isEnabled());
    QVERIFY(desk.action("mirrorWaypointsX")->toolTip().contains(QLatin1String("two")));
  }

  void aToolThatIsChosenHasItsKeysAtOnce() {
    Corridor desk;
    desk.start();
    desk.bringUp();
    for (const char* tool : {"waypointTool", "waypointLine"}) {
      desk.dock().addButton()->setFocus();
      desk.action(tool)->trigger();
      QVERIFY(desk.window->view()->hasFocus());
    }
    desk.action("waypointTool")->trigger();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(desk.editing().selected().size(), std::size_t(3));
  }

  void theyAreMirroredAboutALineThatIsDrawn() {
    Corridor desk;
    desk.store.points[0].yaw_rad = 0;
    desk.start();
    desk.chooseTool();
    desk.editing().select({"a", "b"});
    desk.action("mirrorWaypointsLine")->trigger();
    QCOMPARE(desk.window->view()->tool(),
             static_cast<MapTool*>(desk.control().placing()->arranging()->mirrorTool()));
    desk.click(desk.px(0.5, 2), Qt::AltModifier);
    desk.moveTo(desk.px(3.5, 2), Qt::AltModifier);
    QVERIFY(desk.editing().preview().contains("a"));  // seen before it is done
    desk.key(Qt::Key_Escape);
    QVERIFY(desk.editing().preview().empty());
    desk.click(desk.px(0.5, 2), Qt::AltModifier);
    desk.click(desk.px(3.5, 2), Qt::AltModifier);
    QVERIFY(desk.near("a", 3, 3) && desk.near("b", 1, 3));
    QVERIFY(std::abs(desk.yawOf("a")) < 0.02);
    QCOMPARE(desk.undo().count(), 1);
    QCOMPARE(desk.window->view()->tool(), static_cast<MapTool*>(desk.control().tool()));
    QCOMPARE(desk.editing().selected().size(), std::size_t(2));
  }

  void eachHeadsTowardsTheOneSelectedNext() {
    Corridor desk;
    desk.start();
    for (const char* key : {"b", "a", "c"}) desk.editing().toggle(key);
    desk.key(Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(std::abs(desk.yawOf("b")) < 1e-9);
    QVERIFY(std::abs(desk.yawOf("a") - 1.5 * kQuarter) < 1e-9);
    QVERIFY(std::abs(desk.yawOf("c") - 1.5 * kQuarter) < 1e-9);
    QCOMPARE(desk.undo().count(), 1);
    desk.action("headWaypointsLoop")->trigger();
    QVERIFY(std::abs(desk.yawOf("c") + 1.5 * kQuarter) < 1e-9);
    // Selected at once they are taken as people count: Gate 9, Gate 10, Lift.
    desk.editing().select({});
    desk.editing().selectAll();
    QCOMPARE(desk.editing().inOrder(), (std::vector<edit::Key>{"b", "a", "c"}));
  }
};

}  // namespace test_window_several

MAPWRIGHT_TEST(test_window_several, TestWindowSeveral, Widgets)
#include "test_window_several.moc"
