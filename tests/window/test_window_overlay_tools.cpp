// The tools for overlays besides drawing: what the robot sees, snapping, the clipboard, circles, arranging,
// several at once, parts of several, defaults of the map. By hand in the window, on the simulated robot.
#include <random>

#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QTableView>
#include <QTableWidget>
#include <QToolButton>
#include <QtTest>

#include "map/live_state.h"
#include "overlays/overlay_arrange.h"
#include "overlays/overlay_edits.h"
#include "overlays/overlay_merge.h"
#include "overlays/overlay_types.h"
#include "overlays_desk.h"
#include "test_program.h"
#include "ui/overlays/collection_dialog.h"
#include "ui/overlays/overlay_actions.h"
#include "ui/overlays/overlay_form.h"
#include "ui/overlays/overlay_marks.h"
#include "ui/overlays/overlay_marks_dialog.h"
#include "ui/overlays/overlay_snapping.h"
#include "ui/shell/current_session.h"

namespace test_window_overlay_tools {

using namespace mapwright;
using namespace mapwright::ui;
using overlays::OverlayDocument;
using overlays::Shape;
using test_overlays_desk::Desk;
using test_overlays_desk::kOverlays;

namespace {

bool near(const Eigen::Vector2d& a, double x, double y, double reach = 0.03) {
  return (a - Eigen::Vector2d(x, y)).norm() < reach;
}

Eigen::Vector2d robotAt(Desk& desk) {
  const auto& pose = part<CurrentSession>(*desk.window)->session()->live().robot_pose;
  return {pose->x_m, pose->y_m};
}

/// With the robot in the map that is edited.
void openThere(Desk& desk) {
  desk.open();
  QTRY_VERIFY(desk.action("overlayRobotPlace")->isEnabled());
}

OverlayTeaching& teaching(Desk& desk) { return *desk.control().actions()->teaching(); }

void setClipboard(const QString& text) { QGuiApplication::clipboard()->setText(text); }

void noSnapping(Desk& desk) { desk.control().snapping()->setOn(false); }

}  // namespace

class TestWindowOverlayTools : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void thePlaceOfTheRobotBecomesAPoint() {
    Desk desk;
    openThere(desk);
    QTest::keyClick(desk.window->view(), Qt::Key_T);
    const auto key = desk.editing().only();
    QVERIFY(key && *key == 3);
    const Eigen::Vector2d at = robotAt(desk);
    QVERIFY(near(desk.points(3)[0], at.x(), at.y(), 0.001));
    QVERIFY(desk.editing().find(3)->property("yaw"));
    desk.action("undo")->trigger();
    QVERIFY(!desk.document().find(3) && !desk.control().unsaved());
  }

  void thePlaceOfTheRobotIsTheNextPointOfWhatIsDrawn() {
    Desk desk;
    openThere(desk);
    const Eigen::Vector2d at = robotAt(desk);
    QTest::mouseClick(desk.dock().modeButton(OverlayMode::Line), Qt::LeftButton);
    QTest::keyClick(desk.window->view(), Qt::Key_T);
    desk.look();
    desk.click(desk.px(2, -2));
    desk.key(Qt::Key_Return);
    const auto line = desk.editing().only();
    QVERIFY(line && desk.points(*line).size() == 2);
    QVERIFY(near(desk.points(*line)[0], at.x(), at.y(), 0.001));
  }

  void whatTheRobotSeesBecomesAnOverlay_data() {
    QTest::addColumn<QByteArray>("action");
    QTest::addColumn<int>("type");
    QTest::addColumn<QByteArray>("reference");
    QTest::newRow("charger") << QByteArray("overlayCharger") << 9 << QByteArray();
    QTest::newRow("rack") << QByteArray("overlayRackFront") << 34 << QByteArray("center_of_front_edge");
    QTest::newRow("rear") << QByteArray("overlayRackRear") << 34 << QByteArray("center_of_rear_edge");
    QTest::newRow("pallet") << QByteArray("overlayPallet") << 34 << QByteArray("center_of_front_edge");
    QTest::newRow("trailer") << QByteArray("overlayTrailer") << 34 << QByteArray("center_of_front_edge");
  }
  void whatTheRobotSeesBecomesAnOverlay() {
    QFETCH(QByteArray, action);
    QFETCH(int, type);
    QFETCH(QByteArray, reference);
    Desk desk;
    openThere(desk);
    QTRY_VERIFY(desk.action(action)->isEnabled());
    desk.action(action)->trigger();
    QVERIFY(!desk.action(action)->isEnabled());  // until it answers
    QTRY_VERIFY(desk.editing().only() == std::optional<FeatureKey>(3));
    const Feature& seen = *desk.editing().find(3);
    QCOMPARE(seen.type(), type);
    QVERIFY(seen.property("yaw"));
    QCOMPARE(seen.property("ref").has_value(), !reference.isEmpty());
    if (!reference.isEmpty()) QCOMPARE(seen.property("ref")->string(), reference.toStdString());
    QVERIFY((desk.points(3)[0] - robotAt(desk)).norm() < 1);
    QTRY_VERIFY(desk.action(action)->isEnabled());
    // A second time the one that is selected is moved.
    desk.editing().set(3, overlays::movedBy(seen, {3, 0}), QStringLiteral("move"));
    desk.action(action)->trigger();
    QTRY_VERIFY((desk.points(3)[0] - robotAt(desk)).norm() < 1);
    QCOMPARE(desk.document().size(), std::size_t(4));
  }

  void thatTheRobotSeesNoneIsTold() {
    Desk desk;
    simulator::Faults faults;
    faults.sees_nothing = true;
    desk.sim.setFaults(faults);
    openThere(desk);
    desk.action("overlayCharger")->trigger();
    QTRY_VERIFY(desk.says("No charger was added. The robot sees no charger here."));
    QTRY_VERIFY(desk.action("overlayPallet")->isEnabled());
    desk.action("overlayPallet")->trigger();
    QTRY_VERIFY(desk.says("Nothing was detected"));
    QTRY_VERIFY(desk.action("overlayMarks")->isEnabled());
    QVERIFY(!desk.control().unsaved());
  }

  void collectedMarksAreTakenOver() {
    Desk desk;
    openThere(desk);
    desk.action("overlayMarks")->trigger();
    QTRY_VERIFY(teaching(desk).dialog());
    OverlayMarksDialog* dialog = teaching(desk).dialog();
    QVERIFY(dialog->table()->rowCount() >= 5);
    dialog->table()->item(0, 0)->setCheckState(Qt::Unchecked);
    const auto count = dialog->chosen().size();
    QVERIFY(count > 0);
    QTest::mouseClick(dialog->takeButton(), Qt::LeftButton);
    QCOMPARE(desk.editing().selected().size(), count);
    QCOMPARE(desk.document().steps(), std::size_t(1));
    for (const FeatureKey key : desk.editing().selected()) {
      const int type = desk.editing().find(key)->type();
      QVERIFY(type == overlays::kLandmark || type == overlays::kBarcode);
    }
    // Those are there now; one was left out, and one is offered as an update after it was moved.
    const FeatureKey moved = *desk.editing().selected().begin();
    desk.editing().set(moved, overlays::movedBy(*desk.editing().find(moved), {0.5, 0}),
                       QStringLiteral("move"));
    QTRY_VERIFY(desk.action("overlayMarks")->isEnabled() && !teaching(desk).dialog());
    desk.action("overlayMarks")->trigger();
    QTRY_VERIFY(teaching(desk).dialog());
    dialog = teaching(desk).dialog();
    int updates = 0;
    for (int row = 0; row < dialog->table()->rowCount(); ++row) {
      if (!dialog->table()->item(row, 2)->text().contains(QLatin1String("0.50 m away"))) continue;
      ++updates;
      QCOMPARE(dialog->table()->item(row, 0)->checkState(), Qt::Unchecked);
    }
    QCOMPARE(updates, 1);
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY(!teaching(desk).dialog());
  }

  void whatIsDrawnSnapsToOthers() {
    Desk desk;
    desk.open();
    QTest::mouseClick(desk.dock().modeButton(OverlayMode::Line), Qt::LeftButton);
    // The end of the wall, a side of the region, and a level line.
    desk.click(desk.px(4, 0) + QPoint(4, 3));
    desk.click(desk.px(3, 3.1) + QPoint(4, 0));
    desk.click(desk.px(5.3, 3.1) + QPoint(0, 4));
    desk.key(Qt::Key_Return);
    const auto line = desk.editing().only();
    QVERIFY(line);
    QCOMPARE(desk.points(*line)[0], Eigen::Vector2d(4, 0));
    QCOMPARE(desk.points(*line)[1].x(), 3.0);
    QCOMPARE(desk.points(*line)[2].y(), desk.points(*line)[1].y());
    // With Alt it does not.
    QTest::mouseClick(desk.dock().modeButton(OverlayMode::Point), Qt::LeftButton);
    desk.click(desk.px(4, 0) + QPoint(4, 3), Qt::AltModifier);
    QVERIFY(desk.points(*desk.editing().only())[0] != Eigen::Vector2d(4, 0));
    // Nor after it is turned off.
    QTest::keyClick(desk.window->view(), Qt::Key_S, Qt::ShiftModifier);
    QVERIFY(!desk.control().snapping()->on() && !desk.action("snapOverlays")->isChecked());
    desk.click(desk.px(1, 4) + QPoint(5, 0));
    QVERIFY(desk.points(*desk.editing().only())[0] != Eigen::Vector2d(1, 4));
    desk.action("snapOverlayGrid")->trigger();
    QVERIFY(desk.control().snapping()->on() && desk.control().snapping()->kinds().grid);
    desk.click(desk.px(-3, -2.5) + QPoint(5, -3));
    QCOMPARE(desk.points(*desk.editing().only())[0], Eigen::Vector2d(-3, -2.5));
  }

  void whatIsDraggedSnapsWithItsPointNearestToTheHand() {
    Desk desk;
    desk.open();
    // The wall is taken near its right end, which comes to the corner of the region.
    desk.drag(desk.px(3.8, 0), desk.px(0.8, 2) + QPoint(4, -3));
    QCOMPARE(desk.points(0)[1], Eigen::Vector2d(1, 2));
    QCOMPARE(desk.points(0)[0], Eigen::Vector2d(-3, 2));
    // A corner comes to the point.
    desk.editing().select({1});
    desk.drag(desk.px(1, 4), desk.px(-2, 1) + QPoint(5, 0));
    QCOMPARE(desk.points(1)[3], Eigen::Vector2d(-2, 1));
  }

  void overlaysAreCutAndPastedInTheirPlace() {
    Desk desk;
    desk.open();
    desk.editing().select({0, 2});
    desk.key(Qt::Key_C, Qt::ControlModifier);
    const QMimeData* const data = QGuiApplication::clipboard()->mimeData();
    QVERIFY(data->hasFormat(QStringLiteral("application/geo+json")) && data->hasText());
    desk.key(Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(desk.editing().selected(), (std::set<FeatureKey>{3, 4}));
    QCOMPARE(desk.coordinates(3), desk.coordinates(0));
    QVERIFY(desk.editing().find(3)->id() != "w1");
    QCOMPARE(desk.editing().find(3)->name(), std::string("W17 2"));
    desk.key(Qt::Key_Right);  // they can be moved at once
    QVERIFY(near(desk.points(3)[0], 0.05, 0, 0.001));
    for (int i = 0; i < 2; ++i) desk.action("undo")->trigger();
    desk.editing().select({0});
    desk.key(Qt::Key_X, Qt::ControlModifier);
    QVERIFY(!desk.document().find(0));
    desk.key(Qt::Key_V, Qt::ControlModifier);
    // Its id is free again.
    QCOMPARE(desk.editing().find(*desk.editing().only())->id(), std::string("w1"));
    // Ctrl+Shift+V brings it to the cursor.
    desk.moveTo(desk.px(-3, -3), false);
    desk.key(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(near(desk.points(*desk.editing().only())[0], -5, -3, 0.05));
  }

  void allAreSelectedByTheirKey() {
    Desk desk;
    desk.open();
    desk.key(Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(desk.editing().selected().size(), std::size_t(3));
  }

  void foreignTextIsPastedOrItsErrorTold() {
    Desk desk;
    desk.open();
    setClipboard(QStringLiteral("{\"type\":\"FeatureCollection\",\n\"features\":[{]}"));
    desk.key(Qt::Key_V, Qt::ControlModifier);
    QVERIFY2(desk.says("Line 2, column 14") && !desk.says(".."),
             qPrintable(desk.toasts().join(QLatin1Char('\n'))));
    setClipboard(QStringLiteral("no overlays"));
    desk.key(Qt::Key_V, Qt::ControlModifier);
    QVERIFY(desk.says("It contains no overlays"));
    QVERIFY(!desk.control().unsaved());
    setClipboard(QStringLiteral("{\"type\":\"Point\",\"coordinates\":[7.25,8]}"));
    desk.key(Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(desk.points(3)[0], Eigen::Vector2d(7.25, 8));
    // In a text field it is text.
    desk.dock().filterEdit()->setFocus();
    QTest::keyClick(desk.dock().filterEdit(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(desk.document().size(), std::size_t(4));
    QVERIFY(desk.dock().filterEdit()->text().contains(QLatin1String("7.25")));
  }

  void circlesAreDrawnFromTheirCentre() {
    Desk desk;
    desk.open();
    noSnapping(desk);
    QTest::mouseClick(desk.dock().modeButton(OverlayMode::Circle), Qt::LeftButton);
    QVERIFY(desk.dock().radiusBox()->isVisible());
    desk.drag(desk.px(-1, -2), desk.px(0, -2));
    auto key = desk.editing().only();
    QVERIFY(key && desk.points(*key).size() == std::size_t(overlays::kCircleVertices));
    for (const Eigen::Vector2d& at : desk.points(*key))
      QVERIFY(std::abs((at - Eigen::Vector2d(-1, -2)).norm() - 1) < 0.03);
    // By two clicks, and one with a number.
    desk.click(desk.px(4, 4));
    desk.click(desk.px(4, 5));
    QVERIFY(*desk.editing().only() != *key);
    desk.dock().radiusBox()->setValue(0.5);
    desk.click(desk.px(-3, -3));
    key = desk.editing().only();
    QVERIFY(std::abs((desk.points(*key)[0] - desk.points(*key)[16]).norm() - 1) < 0.001);
    // A click is no circle while the radius is dragged.
    desk.dock().radiusBox()->setValue(0);
    desk.click(desk.px(0, 5));
    desk.key(Qt::Key_Escape);
    desk.key(Qt::Key_Escape);
    QVERIFY(desk.control().tool()->mode() == OverlayMode::Select);
    QCOMPARE(desk.document().size(), std::size_t(6));
  }

  void theSelectionIsPutInLine() {
    Desk desk;
    desk.open();
    QVERIFY(!desk.action("alignOverlaysLeft")->isEnabled());
    desk.editing().select({0, 1, 2});
    desk.action("alignOverlaysLeft")->trigger();
    QCOMPARE(desk.points(0)[0], Eigen::Vector2d(-2, 0));
    QCOMPARE(desk.points(1)[0], Eigen::Vector2d(-2, 2));
    QCOMPARE(desk.coordinates(2), std::string("[-2,1,0.5]"));
    QCOMPARE(desk.document().steps(), std::size_t(1));
    desk.action("undo")->trigger();
    QVERIFY(!desk.control().unsaved());
    desk.action("spreadOverlaysY")->trigger();
    // The boxes from 0 to 0, 1 to 1 and 2 to 4: gaps of 1 already.
    QVERIFY(!desk.control().unsaved());
    desk.editing().select({0, 1});
    QVERIFY(!desk.action("spreadOverlaysY")->isEnabled());
  }

  void propertiesThatAllHaveAreEditedAtOnce() {
    Desk desk;
    QVERIFY(desk.hand(Desk::with(R"("lineType":"2",)", R"("lineType":"2","speed":0.4,"mapOverlay":true,)")));
    desk.open();
    desk.editing().select({0, 1});
    OverlayForm& form = *desk.dock().form();
    QCOMPARE(form.properties()->rowCount(), 1);
    QCOMPARE(form.properties()->item(0, 1)->text(), QStringLiteral("0.4"));
    QVERIFY(!form.typePicker()->isEnabled() && !form.nameEdit()->isEnabled());
    form.properties()->item(0, 1)->setText(QStringLiteral("1"));
    QCOMPARE(std::string(desk.editing().find(0)->property("speed")->text()), std::string("1"));
    QCOMPARE(std::string(desk.editing().find(1)->property("speed")->text()), std::string("1"));
    QCOMPARE(desk.document().steps(), std::size_t(1));
    desk.editing().set(0, overlays::withProperty(*desk.editing().find(0), "speed", "2"),
                       QStringLiteral("set"));
    QCOMPARE(form.properties()->item(0, 1)->text(), QStringLiteral("several values"));
    form.properties()->item(0, 1)->setText(QStringLiteral("fast"));
    QVERIFY(!form.problemShown().isEmpty());
    QCOMPARE(form.properties()->item(0, 1)->text(), QStringLiteral("several values"));
    desk.type(form.newKeyEdit(), "mac");
    QVERIFY(desk.editing().find(0)->property("mac") && desk.editing().find(1)->property("mac"));
  }

  void whatIsTooLongForListsIsCounted() {
    std::string members, points;
    for (int i = 0; i < 2100; ++i) members += ",\"k" + std::to_string(i) + "\":1";
    for (int i = 0; i < 2500; ++i) points += (i ? ",[" : "[") + std::to_string(i * 0.002) + ",0]";
    std::string text = kOverlays;
    const auto put = [&text](const std::string& from, const std::string& to) {
      text.replace(text.find(from), from.size(), to);
    };
    put("[[0.00,0],[4,0]]", "[" + points + "]");
    put("\"name\":\"W17\"", "\"name\":\"W17\"" + members);
    put("\"speed\":0.40", "\"speed\":0.40" + members);
    Desk desk;
    QVERIFY(desk.hand(text));
    desk.open();
    OverlayForm& form = *desk.dock().form();
    OverlayPoints& list = *desk.dock().points();
    desk.editing().select({0});
    QCOMPARE(list.table()->rowCount(), 2000);
    QCOMPARE(list.aboutShown(), QStringLiteral("2,000 of 2,500 points are shown."));
    QVERIFY2(desk.control().tool()->hint().endsWith(
                 QLatin1String("It has 2,500 points: too many to drag one by one.")),
             qPrintable(desk.control().tool()->hint()));
    QCOMPARE(form.moreShown(), QStringLiteral("100 more are not listed."));
    desk.editing().select({1});
    QCOMPARE(list.aboutShown(), QString());
    QVERIFY(!desk.control().tool()->hint().contains(QLatin1String("too many")));
    QCOMPARE(form.moreShown(), QStringLiteral("101 more are not listed."));
    desk.editing().select({0, 1});
    QCOMPARE(form.properties()->rowCount(), 2000);
    QCOMPARE(form.moreShown(), QStringLiteral("Only the first 2,000 properties are compared."));
    desk.editing().select({2});
    QCOMPARE(form.moreShown(), QString());
  }

  void partsOfSeveralAreReshaped() {
    Desk desk;
    QVERIFY(desk.hand(Desk::with(
        R"({"type":"Polygon","coordinates":[[[1,2],[3,2],[3,4],[1,4],[1,2]]]})",
        R"({"type":"MultiPolygon","coordinates":[[[[1,2],[3,2],[3,4],[1,4],[1,2]]],[[[-3,3],[-2,3],[-2,4]]]]})")));
    desk.open();
    noSnapping(desk);
    desk.editing().select({1});
    QCOMPARE(desk.dock().points()->table()->rowCount(), 7);
    desk.drag(desk.px(-2, 4), desk.px(-2, 5));
    QVERIFY(near(overlays::verticesOf(*desk.editing().find(1)).at(1)[2], -2, 5));
    desk.drag(desk.px(2, 2), desk.px(2, 1.5));  // the middle of a side
    QCOMPARE(desk.points(1).size(), std::size_t(5));
    QVERIFY(desk.dock().form()->typePicker()->isEnabled());
  }

  void eachUnsavedOneHasAMarkHoweverManyThereAre() {
    constexpr std::size_t kCount = 3'000;
    const overlays::Feature one = overlays::OverlayDocument::read(kOverlays)->features()[0];
    overlays::EditingDocument document;
    std::vector<overlays::FeatureEdit> edits;
    for (std::size_t i = 0; i < kCount; ++i) edits.push_back({document.newKey(), std::nullopt, one});
    QVERIFY(document.change(std::move(edits)));
    QCOMPARE(stateMarksOf(document).size(), kCount);
  }

  void aPartOfTheMapIsPaintedAsTheWholeIs() {
    Desk desk;
    overlays::OverlayDocument many = *overlays::OverlayDocument::read(kOverlays);
    for (int i = 0; i < 600; ++i) {  // so many that a picture of them is kept
      const overlays::Feature one =
          overlays::movedBy(many.features()[std::size_t(i % 3)], {i % 20 * 0.9 - 9, i / 20 * 0.45 - 7});
      many.add(overlays::withPart(one, {overlays::Part::Of::Member, "id"}, "\"n" + std::to_string(i) + '"'));
    }
    QVERIFY(desk.hand(many.text()));
    desk.start();
    QTest::keyClick(desk.window->view(), Qt::Key_E);
    QTRY_COMPARE(desk.document().size(), std::size_t(603));
    QCoreApplication::processEvents();
    desk.look();
    desk.editing().select([&] {
      std::set<FeatureKey> keys;
      for (FeatureKey key = 0; key < 603; ++key) keys.insert(key);
      return keys;
    }());
    // Away from half pixels, where pictures of marks may be rounded to either side.
    desk.editing().changeSelected(QStringLiteral("move"), [](const overlays::Feature& feature) {
      return overlays::movedBy(feature, {0.306, 0.104});
    });
    QWidget* const map = desk.map();
    QTRY_VERIFY(desk.window->mapScene()->settled());
    std::mt19937 random(5);
    const auto below = [&](int most) { return int(random() % unsigned(most)); };
    for (int i = 0; i < 20; ++i) {
      const QRect part(below(map->width() - 200), below(map->height() - 150), 20 + below(180),
                       20 + below(130));
      const QImage now = map->grab(part).toImage(), wanted = map->grab().toImage().copy(part);
      int other = 0;  // besides lines of text and the like, which Qt smooths otherwise at an edge
      for (int y = 0; y < part.height(); ++y) {
        for (int x = 0; x < part.width(); ++x)
          other += qAbs(qGray(now.pixel(x, y)) - qGray(wanted.pixel(x, y))) > 40 ? 1 : 0;
      }
      QVERIFY2(other <= 5, qPrintable(QDebug::toString(part)));
    }
  }

  void defaultsOfTheMapAreEditedAndSaved() {
    Desk desk;
    desk.open();
    desk.action("overlayDefaults")->trigger();
    CollectionDialog* const dialog = desk.control().actions()->defaultsDialog();
    QVERIFY(dialog);
    QCOMPARE(dialog->box(0)->text(), QStringLiteral("not set"));
    dialog->box(0)->setValue(0.8);
    dialog->box(3)->setValue(1.2);
    QTest::mouseClick(dialog->applyButton(), Qt::LeftButton);
    QVERIFY(desk.control().unsaved());
    desk.review();
    QVERIFY2(
        desk.control().review()->changesShown().join(QString()).contains(QLatin1String("width of racks")),
        qPrintable(desk.control().review()->changesShown().join(QString())));
    QTest::mouseClick(desk.control().review()->saveButton(), Qt::LeftButton);
    QTRY_VERIFY(!desk.control().busy() && !desk.control().unsaved());
    const std::string held = desk.held();
    QVERIFY(held.find(R"("defaultRackWidth")") != std::string::npos);
    QVERIFY(held.find(R"("future": 1.50)") != std::string::npos);
    desk.action("undo")->trigger();
    QVERIFY(desk.control().unsaved());
    desk.save();
    const std::string last = desk.held();
    QVERIFY2(last == kOverlays, last.c_str());
  }
};

}  // namespace test_window_overlay_tools

MAPWRIGHT_TEST(test_window_overlay_tools, TestWindowOverlayTools, Widgets)
#include "test_window_overlay_tools.moc"
