// Editing the overlays of a map in the window, on the simulated robot: by hand on the map, in the list and
// the form, undoing, saving after a review, what others change meanwhile, drafts, leaving.
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSplitter>
#include <QTableView>
#include <QTableWidget>
#include <QTcpServer>
#include <QToolButton>
#include <QUndoGroup>
#include <QtTest>

#include "edit/overlays/overlay_drafts.h"
#include "map/live_state.h"
#include "overlays/overlay_shapes.h"
#include "overlays_desk.h"
#include "robot/axbot/axbot_address.h"
#include "robot/axbot/axbot_robot.h"
#include "robot/overlay_store.h"
#include "simulator/simulator.h"
#include "test_program.h"
#include "ui/kit/plain_label.h"
#include "ui/overlays/overlay_form.h"
#include "ui/overlays/overlay_review.h"
#include "ui/overlays/overlay_tool.h"
#include "ui/overlays/overlays_controller.h"
#include "ui/overlays/overlays_dock.h"
#include "ui/overlays/overlays_model.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "ui/window/main_window.h"
#include "window_parts.h"

namespace test_window_overlays {

using namespace mapwright;
using namespace mapwright::ui;
using overlays::OverlayDocument;
using overlays::Shape;
using test_overlays_desk::Desk;
using test_overlays_desk::kOverlays;

namespace {

bool near(const Eigen::Vector2d& a, double x, double y) { return (a - Eigen::Vector2d(x, y)).norm() < 0.03; }

}  // namespace

class TestWindowOverlays : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void tabGoesDownTheForm() {
    Desk desk;
    desk.open();
    desk.editing().select({2});  // a point
    QStringList seen;
    auto* const name = desk.dock().findChild<OverlayForm*>()->findChild<QLineEdit*>();
    name->setFocus();
    for (int i = 0; i < 5; ++i) {
      seen << QApplication::focusWidget()->accessibleName();
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    QCOMPARE(seen, (QStringList{QStringLiteral("Name of the overlay"), QStringLiteral("Type of the overlay"),
                                QStringLiteral("Heading of the overlay"),
                                QStringLiteral("Properties of the overlay"),
                                QStringLiteral("Name of the new property")}));
  }

  void whatSavesAndDiscardsIsInViewOnASmallScreen() {
    Desk desk;
    desk.open();
    desk.window->resize(1366, 768);
    desk.action("layoutInspect")->trigger();
    desk.action("resetLayout")->trigger();
    desk.dock().show();
    desk.dock().raise();
    for (const QPushButton* button : {desk.dock().reviewButton(), desk.dock().discardButton()})
      QTRY_VERIFY2(button->visibleRegion().boundingRect() == button->rect(), qPrintable(button->text()));
  }

  void whatIsDraggedIsMovedAndNothingElse() {
    Desk desk;
    desk.open();
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    QCOMPARE(desk.editing().selected(), std::set<FeatureKey>{0});
    QVERIFY(near(desk.points(0)[0], 0, 1) && near(desk.points(0)[1], 4, 1));
    QVERIFY(desk.control().unsaved() && desk.action("save")->isEnabled());
    QCOMPARE(desk.stateOf(0), QStringLiteral("changed, unsaved"));
    QCOMPARE(desk.stateOf(1), QStringLiteral("saved"));
    desk.review();
    QCOMPARE(desk.control().review()->changesShown(),
             QStringList{QStringLiteral("Move virtual wall W17 by 1.00 m")});
    QTest::mouseClick(desk.control().review()->saveButton(), Qt::LeftButton);
    QTRY_VERIFY(!desk.control().busy() && !desk.control().unsaved());
    QVERIFY(desk.says("saved"));
    QCOMPARE(desk.held(), Desk::with("[[0.00,0],[4,0]]", desk.coordinates(0)));
    QCOMPARE(desk.stateOf(0), QStringLiteral("saved"));
    // Undone after saving, it is to be saved again.
    desk.action("undo")->trigger();
    QVERIFY(desk.control().unsaved());
    desk.save();
    QCOMPARE(desk.held(), std::string(kOverlays));
  }

  /// Where the robot tells the version of its overlays, it is asked before the review and after the change.
  void savingAsksTheRobotTwice() {
    Desk desk;
    desk.open();
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    const auto told = [&] {
      const auto& info = desk.window->session()->live().map_info;
      return info ? info->overlays_version.value_or(0) : 0;
    };
    QTRY_VERIFY(told() > 0);
    const int before = told();
    desk.sim.clearRequestLog();
    desk.save();
    QVERIFY(desk.says("saved") && !desk.control().unsaved());
    QTRY_COMPARE(told(), before + 1);
    QStringList asked;
    for (const auto& request : desk.sim.requestLog()) {
      if (request.target == "/maps/1") asked << QString::fromStdString(request.method);
    }
    QCOMPARE(asked, (QStringList{QStringLiteral("GET"), QStringLiteral("PATCH"), QStringLiteral("GET")}));
  }

  void verticesAreDraggedInsertedAndDeleted() {
    Desk desk;
    desk.open();
    desk.click(desk.px(2, 3));
    QCOMPARE(desk.editing().selected(), std::set<FeatureKey>{1});
    desk.drag(desk.px(3, 4), desk.px(3.5, 4));
    QVERIFY(near(desk.points(1)[2], 3.5, 4));
    desk.drag(desk.px(2, 2), desk.px(2, 1.5));  // the middle of a side
    QCOMPARE(desk.points(1).size(), std::size_t(5));
    QVERIFY(near(desk.points(1)[1], 2, 1.5));
    QVERIFY(desk.control().tool()->vertex().has_value());
    desk.key(Qt::Key_Delete);
    QCOMPARE(desk.points(1).size(), std::size_t(4));
    for (int i = 0; i < 3; ++i) desk.action("undo")->trigger();
    QCOMPARE(desk.document().mine().text(), std::string(kOverlays));
    QVERIFY(!desk.control().unsaved());
  }

  void pointsAreTurnedByTheirHandle() {
    Desk desk;
    desk.open();
    desk.click(desk.px(-2, 1));
    QCOMPARE(desk.editing().only(), std::optional<FeatureKey>(2));
    const auto grip = desk.control().tool()->handle();
    QVERIFY(grip);
    desk.drag(grip->toPoint(), desk.px(-4, 1));
    QVERIFY(std::abs(*overlays::yawOf(*desk.editing().find(2))) > 179);
    QCOMPARE(desk.editing().find(2)->property("yaw")->kind(), overlays::JsonKind::String);
    QCOMPARE(desk.coordinates(2), std::string("[-2,1,0.5]"));
    QVERIFY(std::abs(desk.dock().form()->yawBox()->value()) > 179);
  }

  void severalAreSelectedByAFrameMovedAndDeleted() {
    Desk desk;
    desk.open();
    desk.drag(desk.px(-3, 5), desk.px(5, -1), Qt::ShiftModifier);
    QCOMPARE(desk.editing().selected().size(), std::size_t(3));
    for (int i = 0; i < 3; ++i) desk.key(Qt::Key_Right);
    QVERIFY(near(desk.points(0)[0], 0.15, 0));
    QCOMPARE(desk.document().steps(), std::size_t(1));
    desk.key(Qt::Key_Delete);
    QVERIFY(!desk.document().find(0) && !desk.document().find(1) && !desk.document().find(2));
    QCOMPARE(desk.dock().model()->rowCount(), 3);  // until that is saved
    desk.action("undo")->trigger();
    desk.action("undo")->trigger();
    QVERIFY(!desk.control().unsaved());
  }

  void newOnesAreDrawn() {
    Desk desk;
    desk.open();
    QTest::mouseClick(desk.dock().modeButton(OverlayMode::Line), Qt::LeftButton);
    desk.click(desk.px(0, -2));
    desk.click(desk.px(2, -2));
    desk.click(desk.px(2, -3));
    desk.key(Qt::Key_Backspace);
    desk.key(Qt::Key_Return);
    const auto line = desk.editing().only();
    QVERIFY(line && desk.editing().find(*line)->shape() == Shape::Line && desk.points(*line).size() == 2);
    QCOMPARE(std::string(desk.editing().find(*line)->property("lineType")->text()), std::string("\"2\""));
    QCOMPARE(desk.editing().find(*line)->id().size(), std::size_t(24));

    QTest::mouseClick(desk.dock().modeButton(OverlayMode::Polygon), Qt::LeftButton);
    desk.dock().newTypePicker()->setCurrentIndex(desk.dock().newTypePicker()->findData(12));
    Q_EMIT desk.dock().newTypePicker()->activated(desk.dock().newTypePicker()->currentIndex());
    desk.click(desk.px(-1, -2));
    desk.click(desk.px(-2, -2));
    desk.click(desk.px(-2, -3));
    QTest::mouseDClick(desk.map(), Qt::LeftButton, {}, desk.px(-2, -3));
    const auto region = desk.editing().only();
    QVERIFY(region && desk.editing().find(*region)->type() == 12 && desk.points(*region).size() == 3);

    QTest::mouseClick(desk.dock().modeButton(OverlayMode::Rectangle), Qt::LeftButton);
    desk.drag(desk.px(4, 3), desk.px(5, 5));
    QCOMPARE(desk.points(*desk.editing().only()).size(), std::size_t(4));
    QTest::mouseClick(desk.dock().modeButton(OverlayMode::Point), Qt::LeftButton);
    desk.click(desk.px(-3, 3));
    QVERIFY(desk.editing().find(*desk.editing().only())->shape() == Shape::Point);
    QCOMPARE(desk.document().unsavedCount(), std::size_t(4));

    // Esc leads out, step by step.
    desk.key(Qt::Key_Escape);
    QVERIFY(desk.control().tool()->mode() == OverlayMode::Select);
    desk.key(Qt::Key_Escape);
    QVERIFY(desk.editing().selected().empty());
    desk.key(Qt::Key_Escape);
    QVERIFY(desk.window->view()->tool() != desk.control().tool());
    desk.save();
    QCOMPARE(OverlayDocument::read(desk.held())->features().size(), std::size_t(7));
  }

  void theFormSetsOneValueAtATime() {
    Desk desk;
    desk.open();
    desk.editing().select({1});
    OverlayForm& form = *desk.dock().form();
    QCOMPARE(form.nameEdit()->text(), QStringLiteral("Lab"));
    desk.type(form.nameEdit(), "Lab 2");
    form.typePicker()->setCurrentIndex(form.typePicker()->findData(1));
    Q_EMIT form.typePicker()->activated(form.typePicker()->currentIndex());
    QCOMPARE(form.properties()->rowCount(), 1);
    form.properties()->item(0, 1)->setText(QStringLiteral("0.4"));  // the same
    form.properties()->item(0, 1)->setText(QStringLiteral("fast"));
    QVERIFY(!form.problemShown().isEmpty());
    QCOMPARE(form.properties()->item(0, 1)->text(), QStringLiteral("0.40"));
    form.properties()->item(0, 1)->setText(QStringLiteral("0.25"));
    QVERIFY(form.problemShown().isEmpty());
    desk.type(form.newKeyEdit(), "mac");
    QCOMPARE(desk.document().mine().text(),
             Desk::with(R"("regionType":2,"name":"Lab","speed":0.40)",
                        R"("regionType":1,"name":"Lab 2","speed":0.25,"mac":"")"));
    form.properties()->setCurrentCell(1, 0);
    QTest::mouseClick(form.removeButton(), Qt::LeftButton);
    QVERIFY(!desk.editing().find(1)->property("mac"));
    desk.dock().points()->table()->item(0, 1)->setText(QStringLiteral("2,5"));
    QCOMPARE(desk.coordinates(1), std::string("[[[1,2.5],[3,2],[3,4],[1,4],[1,2.5]]]"));
    QTest::mouseClick(desk.dock().discardButton(), Qt::LeftButton);
    QVERIFY(!desk.control().unsaved());
    desk.action("undo")->trigger();
    QVERIFY(desk.control().unsaved());
  }

  void theListFindsSelectsCopiesAndDeletes() {
    Desk desk;
    desk.open();
    OverlaysDock& dock = desk.dock();
    dock.filterEdit()->setText(QStringLiteral("slow"));
    QCOMPARE(dock.table()->model()->rowCount(), 1);
    QTest::mouseClick(dock.table()->viewport(), Qt::LeftButton, {},
                      dock.table()->visualRect(dock.table()->model()->index(0, 0)).center());
    QCOMPARE(desk.editing().selected(), std::set<FeatureKey>{1});
    QTest::keyClick(dock.table(), Qt::Key_C, Qt::ControlModifier);
    dock.filterEdit()->clear();
    QTest::keyClick(dock.table(), Qt::Key_V, Qt::ControlModifier);
    const auto copy = desk.editing().only();
    QVERIFY(copy && *copy == 3);
    QCOMPARE(desk.editing().find(3)->name(), std::string("Lab 2"));
    QVERIFY(near(desk.points(3)[0], 1, 2));  // in its place
    QCOMPARE(std::string(desk.editing().find(3)->property("speed")->text()), std::string("0.40"));
    QTest::mouseClick(dock.duplicateButton(), Qt::LeftButton);
    QCOMPARE(desk.editing().find(4)->name(), std::string("Lab 2 2"));
    // Several of one shape get their type at once.
    desk.editing().select({1, 3, 4});
    QComboBox& type = *dock.form()->typePicker();
    QCOMPARE(type.currentData().toInt(), 2);
    type.setCurrentIndex(type.findData(9));
    Q_EMIT type.activated(type.currentIndex());
    QVERIFY(desk.editing().find(1)->type() == 9 && desk.editing().find(4)->type() == 9);
    desk.editing().select({0, 1});
    QVERIFY(!type.isEnabled());
    desk.editing().select({4});
    QTest::keyClick(dock.table(), Qt::Key_Delete);
    QVERIFY(!desk.document().find(4) && !dock.removeButton()->isEnabled());
    desk.action("undo")->trigger();
    desk.action("undo")->trigger();
    QCOMPARE(desk.editing().find(1)->type(), 2);
    desk.action("undo")->trigger();
    dock.stateChoice()->setCurrentIndex(1);
    QCOMPARE(dock.table()->model()->rowCount(), 1);
  }

  void flawsAreToldWhileEditing() {
    Desk desk;
    desk.open();
    QTRY_VERIFY(desk.control().checked());
    desk.editing().set(0, overlays::withVertexAt(*desk.editing().find(0), {0, 1}, {0, 0}),
                       QStringLiteral("x"));
    QTRY_VERIFY(desk.control().checked());
    const QListWidget& flaws = *desk.dock().flawList();
    const auto told = [&] {
      QStringList texts;
      for (int row = 0; row < flaws.count(); ++row) texts << flaws.item(row)->text();
      return texts.join(QLatin1Char('\n'));
    };
    QVERIFY2(told().contains(QLatin1String("W17: A line needs at least two different points.")),
             qPrintable(told()));
    desk.action("undo")->trigger();
    QTRY_VERIFY(desk.control().checked());
    QVERIFY(!told().contains(QLatin1String("W17")));
  }

  void whatOthersChangeIsShownAndKept() {
    Desk desk;
    desk.open();
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    QVERIFY(desk.hand(Desk::with("\"speed\":0.40", "\"speed\":0.9")));
    QTRY_COMPARE(desk.stateOf(1), QStringLiteral("changed on the robot"));  // it tells that they changed
    QCOMPARE(desk.stateOf(0), QStringLiteral("changed, unsaved"));
    desk.save();
    std::string wanted = Desk::with("\"speed\":0.40", "\"speed\":0.9");
    const std::string at_first = "[[0.00,0],[4,0]]";
    wanted.replace(wanted.find(at_first), at_first.size(), desk.coordinates(0));
    QCOMPARE(desk.held(), wanted);
  }

  void whatOthersChangeWhileItIsReviewedIsNotReplaced() {
    Desk desk;
    desk.open();
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    desk.review();
    const std::string theirs = Desk::with("[[0.00,0],[4,0]]", "[[0.00,3],[4,3]]");
    QVERIFY(desk.hand(theirs));
    QTRY_VERIFY(!desk.control().review());  // what it listed is not what would be sent
    QTRY_VERIFY(!desk.dock().conflictShown().isEmpty());
    QCOMPARE(desk.held(), theirs);
  }

  void whatOthersChangeElsewhereStaysWhileItIsReviewed() {
    Desk desk;
    desk.open();
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    desk.review();
    QVERIFY(desk.hand(Desk::with("\"speed\":0.40", "\"speed\":0.9")));
    QTRY_COMPARE(desk.stateOf(1), QStringLiteral("changed on the robot"));
    QTRY_VERIFY(desk.control().review());
    QTest::mouseClick(desk.control().review()->saveButton(), Qt::LeftButton);
    QTRY_VERIFY(!desk.control().busy() && !desk.control().review());
    QVERIFY(desk.held().find("\"speed\":0.9") != std::string::npos);
    QVERIFY(desk.held().find("[[0.00,0],[4,0]]") == std::string::npos);
  }

  /// Nobody tells what is changed in a map that the robot is not in: it is looked at once more.
  void whatOthersChangeInAnotherMapWhileItIsReviewedStays() {
    Desk desk;
    desk.start();
    QVERIFY(desk.hand(kOverlays, "2"));
    const map::MapKey key{map::MapKind::Stored, "2"};
    desk.window->session()->openMap(key);
    const session::MapSlot& slot = desk.window->session()->wholeMap();
    QTRY_VERIFY(slot.cells() && slot.shown().key == key);
    desk.key(Qt::Key_E);
    QTRY_VERIFY(desk.editing().isOpen());
    QTRY_COMPARE(desk.document().base().text(), std::string(kOverlays));
    desk.editing().set(0, overlays::movedBy(*desk.document().find(0), {0, 1}), QStringLiteral("move"));
    QVERIFY(desk.control().unsaved());
    desk.review();
    QVERIFY(desk.hand(Desk::with("\"speed\":0.40", "\"speed\":0.9"), "2"));
    QTest::mouseClick(desk.control().review()->saveButton(), Qt::LeftButton);
    QTRY_VERIFY(!desk.control().busy() && !desk.control().review());
    QVERIFY(desk.held("2").find("\"speed\":0.9") != std::string::npos);
    QVERIFY(desk.held("2").find("[[0.00,0],[4,0]]") == std::string::npos);
  }

  /// The map draws all the others from the picture that it keeps.
  void manyInTheHandLeaveTheirPlacesAndComeBack() {
    Desk desk;
    QJsonArray walls;
    for (int i = 0; i < 120; ++i) {
      const double x = i % 12 * 0.5 - 2, y = i / 12 * 0.2 - 1;
      walls << QJsonObject{
          {QStringLiteral("type"), QStringLiteral("Feature")},
          {QStringLiteral("id"), QStringLiteral("w%1").arg(i)},
          {QStringLiteral("properties"), QJsonObject{{QStringLiteral("lineType"), QStringLiteral("2")}}},
          {QStringLiteral("geometry"), QJsonObject{{QStringLiteral("type"), QStringLiteral("LineString")},
                                                   {QStringLiteral("coordinates"),
                                                    QJsonArray{QJsonArray{x, y}, QJsonArray{x + 0.3, y}}}}}};
    }
    const QJsonObject all{{QStringLiteral("type"), QStringLiteral("FeatureCollection")},
                          {QStringLiteral("features"), walls}};
    QVERIFY(desk.hand(QJsonDocument(all).toJson().toStdString()));
    desk.start();
    desk.key(Qt::Key_E);
    QTRY_COMPARE(desk.document().size(), std::size_t(120));
    QCoreApplication::processEvents();
    desk.look();
    desk.key(Qt::Key_A, Qt::ControlModifier);
    QTRY_COMPARE(desk.editing().selected().size(), std::size_t(120));
    const QPoint old_place = desk.px(-1.85, -1), new_place = desk.px(-1.85, 2);
    const auto pixel = [&desk](const QPoint& at) { return desk.map()->grab().toImage().pixel(at); };
    const QRgb wall = pixel(old_place), ground = pixel(new_place);
    QVERIFY(wall != ground);
    QTest::mousePress(desk.map(), Qt::LeftButton, {}, old_place);
    desk.moveTo((old_place + new_place) / 2);
    desk.moveTo(new_place);
    QTRY_VERIFY(pixel(old_place) != wall && pixel(new_place) != ground);
    desk.key(Qt::Key_Escape);
    QTRY_COMPARE(pixel(old_place), wall);
    QTest::mouseRelease(desk.map(), Qt::LeftButton, {}, new_place);
    QCOMPARE(desk.editing().undoStack().count(), 0);
    desk.drag(old_place, new_place);
    QCOMPARE(desk.editing().undoStack().count(), 1);
    QTRY_VERIFY(pixel(old_place) != wall && pixel(new_place) != ground);
    QVERIFY(std::abs(desk.points(0)[0].y() - 2) < 0.02);
  }

  void whatComesAndGoesMovesNothingUnderTheHand() {
    Desk desk;
    desk.open();
    desk.window->resize(1366, 768);
    QVERIFY(desk.action("layoutInspect")->isChecked());
    QTRY_VERIFY(desk.dock().isVisible() && !desk.dock().visibleRegion().isEmpty());
    QTRY_VERIFY(desk.dock().table()->viewport()->height() / desk.dock().table()->rowHeight(0) >= 4);
    const auto* const split = desk.dock().findChild<QSplitter*>();
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    // The layout has come to its end.
    QList<int> last;
    int same = 0;
    QTRY_VERIFY((same = std::exchange(last, split->sizes()) == split->sizes() ? same + 1 : 0) >= 4);
    const QPoint table = desk.dock().table()->mapTo(desk.window.get(), QPoint());
    const QList<int> sizes = split->sizes();
    const QPoint button = desk.dock().reviewButton()->mapTo(desk.window.get(), QPoint());
    QVERIFY(desk.hand(Desk::with("[[0.00,0],[4,0]]", "[[0.00,3],[4,3]]")));
    desk.action("save")->trigger();
    QTRY_VERIFY(!desk.dock().conflictShown().isEmpty());
    QCOMPARE(split->sizes(), sizes);
    QCOMPARE(desk.dock().table()->mapTo(desk.window.get(), QPoint()), table);
    QCOMPARE(desk.dock().reviewButton()->mapTo(desk.window.get(), QPoint()), button);
  }

  void aLongHintTakesSeveralLines() {
    Desk desk;
    desk.open();
    desk.window->resize(800, 600);
    desk.click(desk.px(2, 0));
    const auto labels = desk.window->view()->findChildren<PlainLabel*>();
    const auto hint = std::find_if(labels.begin(), labels.end(), [&](const PlainLabel* label) {
      return label->text() == part<MapOverlay>(*desk.window)->hint();
    });
    QVERIFY(hint != labels.end());
    QTRY_VERIFY((*hint)->height() >= (*hint)->heightForWidth((*hint)->width()));
    QVERIFY((*hint)->heightForWidth((*hint)->width()) > (*hint)->sizeHint().height());
  }

  void whatOthersChangeDuringADragIsKept() {
    Desk desk;
    desk.open();
    desk.click(desk.px(2, 3));
    QTest::mousePress(desk.map(), Qt::LeftButton, {}, desk.px(3, 4));
    desk.moveTo(desk.px(3.2, 4));
    desk.moveTo(desk.px(3.5, 4));
    QVERIFY(near(desk.points(1)[2], 3.5, 4));
    QVERIFY(desk.hand(Desk::with("\"speed\":0.40", "\"speed\":0.9")));
    QTRY_COMPARE(desk.stateOf(1), QStringLiteral("changed on the robot"));
    desk.moveTo(desk.px(3.6, 4));
    QTest::mouseRelease(desk.map(), Qt::LeftButton, {}, desk.px(3.6, 4));
    QCOMPARE(std::string(desk.editing().find(1)->property("speed")->text()), std::string("0.9"));
    QVERIFY(!desk.control().unsaved());
    // The same for a shape as a whole, which goes on.
    QTest::mousePress(desk.map(), Qt::LeftButton, {}, desk.px(2, 3));
    desk.moveTo(desk.px(2.2, 3));
    desk.moveTo(desk.px(3, 3));
    QVERIFY(desk.hand(Desk::with("\"speed\":0.40", "\"speed\":0.7")));
    QTRY_COMPARE(std::string(desk.document().find(1)->property("speed")->text()), std::string("0.7"));
    desk.moveTo(desk.px(4, 3));
    QTest::mouseRelease(desk.map(), Qt::LeftButton, {}, desk.px(4, 3));
    QCOMPARE(std::string(desk.editing().find(1)->property("speed")->text()), std::string("0.7"));
    QVERIFY(near(desk.points(1)[0], 3, 2));
  }

  void undoDuringADragTakesBackTheStepBefore() {
    Desk desk;
    desk.open();
    QTest::mouseClick(desk.dock().modeButton(OverlayMode::Rectangle), Qt::LeftButton);
    desk.drag(desk.px(4, 3), desk.px(6, 5));
    desk.key(Qt::Key_Escape);
    QTest::mousePress(desk.map(), Qt::LeftButton, {}, desk.px(5, 4));
    desk.moveTo(desk.px(5.2, 4));
    desk.moveTo(desk.px(5.6, 4));
    QCOMPARE(desk.editing().preview().size(), std::size_t(1));
    desk.action("undo")->trigger();
    desk.moveTo(desk.px(6, 4));
    QTest::mouseRelease(desk.map(), Qt::LeftButton, {}, desk.px(6, 4));
    QVERIFY(!desk.control().unsaved() && desk.editing().selected().empty());
    QCOMPARE(desk.document().mine().text(), std::string(kOverlays));
    desk.action("redo")->trigger();
    QCOMPARE(desk.document().unsavedCount(), std::size_t(1));
  }

  void whatBothChangedHasToBeDecided() {
    Desk desk;
    desk.open();
    desk.editing().select({0});
    desk.type(desk.dock().form()->nameEdit(), "Mine");
    QVERIFY(desk.hand(Desk::with("W17", "Theirs")));
    QTRY_COMPARE(desk.stateOf(0), QStringLiteral("conflict"));
    QVERIFY(desk.dock().conflictShown().contains(QLatin1String("Mine: Mine\nTheirs: Theirs")));
    desk.action("save")->trigger();
    QVERIFY(!desk.control().review());
    QVERIFY(desk.says("Choose which version to keep"));
    QTest::mouseClick(desk.dock().theirsButton(), Qt::LeftButton);
    QVERIFY(!desk.control().unsaved() && desk.dock().conflictShown().isEmpty());
    desk.action("undo")->trigger();
    QCOMPARE(desk.stateOf(0), QStringLiteral("conflict"));
    QTest::mouseClick(desk.dock().mineButton(), Qt::LeftButton);
    QCOMPARE(desk.stateOf(0), QStringLiteral("changed, unsaved"));
    desk.save();
    QCOMPARE(desk.held(), Desk::with("W17", "Mine"));
  }

  void nothingIsCalledSavedThatIsNot() {
    Desk desk;
    desk.open();
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    simulator::Faults faults;
    faults.requests.push_back({simulator::FaultKind::Refuse, simulator::kWrites});
    desk.sim.setFaults(faults);
    desk.save();
    QVERIFY(desk.control().unsaved());
    QVERIFY2(desk.says("It is not known whether the overlays were saved.") && !desk.says("floor saved"),
             qPrintable(desk.toasts().join(QLatin1Char('|'))));
    QVERIFY(desk.dock().statusShown().contains(QLatin1String("not known")));
    QCOMPARE(desk.held(), std::string(kOverlays));
    // The answer is lost, but it was done: the robot is asked.
    faults = {};
    faults.requests.push_back({simulator::FaultKind::Cut, simulator::kWrites});
    desk.sim.setFaults(faults);
    desk.save();
    QVERIFY(!desk.control().unsaved());
    desk.sim.setFaults({});
    QCOMPARE(desk.held(), Desk::with("[[0.00,0],[4,0]]", desk.coordinates(0)));
  }

  void whatIsSavedIsNotCalledUnsavedBecauseOfOthers_data() {
    QTest::addColumn<bool>("answered");
    QTest::newRow("answered") << true;
    QTest::newRow("the answer is lost") << false;
  }
  void whatIsSavedIsNotCalledUnsavedBecauseOfOthers() {
    QFETCH(bool, answered);
    Desk desk;
    desk.open();
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    simulator::Faults faults;
    faults.requests.push_back({simulator::FaultKind::Delay, simulator::kWrites, 1, 1500});
    if (!answered) faults.requests.push_back({simulator::FaultKind::Cut, simulator::kWrites});
    desk.sim.setFaults(faults);
    desk.review();
    QTest::mouseClick(desk.control().review()->saveButton(), Qt::LeftButton);
    QTRY_VERIFY(desk.held() != kOverlays);
    // It is done, and not answered yet.
    desk.sim.setFaults({});
    std::string theirs = desk.held();
    theirs.replace(theirs.find("0.40"), 4, "0.9");
    QVERIFY(desk.hand(theirs) && desk.control().busy());
    QTRY_VERIFY(!desk.control().busy());
    QCOMPARE(desk.held(), theirs);
    QVERIFY(!desk.control().unsaved());
    const QString said = desk.toasts().join(QLatin1Char('|'));
    QVERIFY2(desk.says(answered ? "Someone else changed the overlays while they were being saved"
                                : "The robot already has these overlays."),
             qPrintable(said));
    QVERIFY2(!desk.says("unsaved") && !desk.says("not known"), qPrintable(said));
    QVERIFY(!desk.dock().retryButton()->isVisible());
    QVERIFY(!desk.dock().statusShown().contains(QLatin1String("not saved")));
  }

  void whatNobodyKnowsIsLookedAtWhenTheLinkIsBack_data() {
    QTest::addColumn<bool>("applied");
    QTest::newRow("it was saved") << true;
    QTest::newRow("it was not saved") << false;
  }
  void whatNobodyKnowsIsLookedAtWhenTheLinkIsBack() {
    QFETCH(bool, applied);
    simulator::Options options = Desk::options();
    {
      QTcpServer free;
      QVERIFY(free.listen(QHostAddress::LocalHost));
      options.port = free.serverPort();
    }
    Desk desk(options);
    desk.open();
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    simulator::Faults faults;
    faults.requests.push_back({simulator::FaultKind::Delay, simulator::kWrites, 1, 60'000});
    if (!applied) faults.requests.push_back({simulator::FaultKind::Drop, simulator::kWrites});
    desk.sim.setFaults(faults);
    desk.sim.clearRequestLog();
    const auto written = [&] {
      const auto log = desk.sim.requestLog();
      return std::any_of(log.begin(), log.end(),
                         [](const auto& request) { return request.method == "PATCH"; });
    };
    desk.review();
    QTest::mouseClick(desk.control().review()->saveButton(), Qt::LeftButton);
    QTRY_VERIFY(applied ? desk.held() != kOverlays : written());
    desk.sim.stop();
    QTRY_VERIFY(!desk.control().busy());
    QVERIFY(desk.says("It is not known whether") && desk.control().unsaved());
    QVERIFY(desk.dock().retryButton()->isVisible());
    desk.sim.setFaults({});
    QVERIFY(!desk.sim.start());
    desk.window->session()->retryNow();
    QTRY_VERIFY2(desk.says(applied ? "The robot already has these overlays."
                                   : "were not saved: the robot does not hold them"),
                 qPrintable(desk.toasts().join(QLatin1Char('|'))));
    QCOMPARE(desk.control().unsaved(), !applied);
    QVERIFY(!desk.dock().retryButton()->isVisible());
  }

  void draftsSurviveACrash() {
    Desk desk;
    desk.keeps_drafts = true;
    desk.open();
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    const std::string mine = desk.document().mine().text();
    const QDir drafts(desk.folder.filePath(QStringLiteral("drafts")));
    const auto files = [&] { return drafts.entryList({QStringLiteral("*.json")}, QDir::Files); };
    QTRY_COMPARE(files().size(), 1);
    desk.window.reset();
    QVERIFY(desk.hand(Desk::with("\"speed\":0.40", "\"speed\":0.9")));
    desk.start();
    QTRY_VERIFY(desk.says("There is an unsaved draft of the overlays"));
    desk.dock().show();
    desk.dock().raise();
    QTRY_VERIFY(desk.dock().restoreButton()->isVisible() && desk.dock().restoreButton()->isEnabled());
    QTest::mouseClick(desk.dock().restoreButton(), Qt::LeftButton);
    QVERIFY(near(desk.points(0)[0], 0, 1) && desk.document().unsavedCount() == 1);
    desk.save();
    QTRY_VERIFY(files().isEmpty());
    QVERIFY(desk.held() != mine && desk.held().find("\"speed\":0.9") != std::string::npos);
  }

  void leavingAsksFirst() {
    Desk desk;
    desk.open();
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    desk.window->close();
    QTRY_VERIFY(desk.control().question());
    QVERIFY(desk.window->isVisible());
    desk.control().question()->button(QMessageBox::Cancel)->click();
    QVERIFY(desk.window->isVisible() && desk.control().unsaved());
    desk.window->close();
    QTRY_VERIFY(desk.control().question());
    desk.control().question()->button(QMessageBox::Save)->click();
    QTRY_VERIFY(desk.control().review());
    QTest::mouseClick(desk.control().review()->saveButton(), Qt::LeftButton);
    QTRY_VERIFY(!desk.window->isVisible());
    QVERIFY(desk.held() != kOverlays);
  }

  void whatIsKeptAsADraftIsOfferedAndWhatIsDiscardedIsNot() {
    Desk desk;
    desk.keeps_drafts = true;
    const QDir drafts(desk.folder.filePath(QStringLiteral("drafts")));
    const auto files = [&] { return drafts.entryList({QStringLiteral("*.json")}, QDir::Files).size(); };
    desk.open();
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    desk.window->close();
    QTRY_VERIFY(desk.control().question());
    desk.control().question()->findChild<QPushButton*>(QStringLiteral("keepDraft"))->click();
    QTRY_VERIFY(!desk.window->isVisible());
    QCOMPARE(files(), 1);
    QCOMPARE(desk.held(), std::string(kOverlays));
    desk.open();
    QTRY_VERIFY(desk.dock().restoreButton()->isVisible());
    QTest::mouseClick(desk.dock().forgetButton(), Qt::LeftButton);
    QTRY_COMPARE(files(), 0);
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    QTRY_COMPARE(files(), 1);
    desk.window->close();
    QTRY_VERIFY(desk.control().question());
    desk.control().question()->button(QMessageBox::Discard)->click();
    QTRY_VERIFY(!desk.window->isVisible());
    desk.window.reset();
    QCOMPARE(files(), 0);
    QCOMPARE(desk.held(), std::string(kOverlays));
  }

  void aRobotThatIsGoneSavesNothingAndLosesNothing() {
    Desk desk;
    desk.open();
    desk.drag(desk.px(2, 0), desk.px(2, 1));
    desk.sim.stop();
    desk.action("save")->trigger();
    QTRY_VERIFY(!desk.control().busy() && desk.says("The overlays were not saved."));
    QVERIFY(!desk.control().review() && desk.control().unsaved() && desk.editing().editable());
    QVERIFY(near(desk.points(0)[0], 0, 1));
  }

  void withoutARobotTheToolSaysWhatItNeeds() {
    Desk desk;
    desk.start();
    desk.action("disconnect")->trigger();
    QTRY_VERIFY(!desk.window->session());
    QVERIFY(!desk.action("overlayTool")->isEnabled());
    QVERIFY(desk.action("overlayTool")->toolTip().contains(QLatin1String("Connect to a robot")));
    QVERIFY(desk.dock().emptyShown().contains(QLatin1String("Connect to a robot")) ||
            !desk.dock().isVisible());
  }

  void theMapShowsWhatIsEdited() {
    Desk desk;
    desk.open();
    desk.drag(desk.px(2, 0), desk.px(2, -2));
    int walls = 0;
    for (const ui::scene::MapObject& object : desk.window->mapScene()->objects(10'000)) {
      if (object.id.layer != ui::scene::Layer::Overlays || object.name != QLatin1String("W17")) continue;
      ++walls;
      QVERIFY(near(object.parts.at(0).at(0), 0, -2));
    }
    QCOMPARE(walls, 1);
  }
};

}  // namespace test_window_overlays

MAPWRIGHT_TEST(test_window_overlays, TestWindowOverlays, Widgets)
#include "test_window_overlays.moc"
