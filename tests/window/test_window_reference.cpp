// A map file under what a robot shows: laid by hand, by numbers, by pairs of points, by its walls, and
// remembered.
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QTableView>
#include <QtTest>

#include "reference_bench.h"
#include "test_program.h"
#include "ui/maps/reference_tool.h"
#include "ui/scene/map_scene.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"

namespace test_window_reference {

using namespace mapwright;
using namespace mapwright::ui;
using test::FakeRobot;
using test::kAddress;
using test::kFile;
using test::kTurnedBack;
using test::ReferenceBench;
using test::Site;

namespace {

bool near(const geometry::Pose2& a, const geometry::Pose2& b, double within) {
  return std::abs(a.x_m - b.x_m) <= within && std::abs(a.y_m - b.y_m) <= within &&
         std::abs(geometry::normalizeAngle(a.yaw_rad - b.yaw_rad)) <= within;
}

}  // namespace

class TestWindowReference : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void isMovedAndTurnedByTheMouse() {
    ReferenceBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.lay();
    QTest::mouseClick(part<ReferenceDock>(window)->moveButton(), Qt::LeftButton);
    bench.look();
    bench.drag(bench.at(0, 0), bench.at(2, 1));
    QVERIFY(near(bench.reference()->pose(), {2, 1, 0}, 0.06));
    QVERIFY(std::abs(part<ReferenceDock>(window)->xBox()->value() - 2) < 0.06);
    bench.drag(bench.at(5, 0), bench.at(0, 5), Qt::ShiftModifier);
    // A quarter around the middle of the view.
    QVERIFY(near(bench.reference()->pose(), {-1, 2, geometry::radiansFromDegrees(90)}, 0.06));
  }

  void isLaidByPairsOfPointsWithTheirResiduals() {
    ReferenceBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.lay();
    auto* const dock = part<ReferenceDock>(window);
    QTest::mouseClick(dock->pairsButton(), Qt::LeftButton);
    bench.look();
    bench.click(0, 0);
    bench.click(3, 0);
    QVERIFY(near(bench.reference()->pose(), {3, 0, 0}, 0.06));
    // What lies at (5, 0) now belongs at (3, 2): a quarter around (3, 0).
    bench.click(5, 0);
    bench.click(3, 2);
    QCOMPARE(dock->table()->model()->rowCount(), 2);
    QVERIFY(near(bench.reference()->pose(), {3, 0, geometry::radiansFromDegrees(90)}, 0.06));
    QVERIFY2(dock->told().startsWith(QLatin1String("2 pairs")), qPrintable(dock->told()));
    dock->table()->selectRow(1);
    QTest::keyClick(dock->table(), Qt::Key_Delete);
    QCOMPARE(dock->table()->model()->rowCount(), 1);
  }

  void numbersAreTyped() {
    ReferenceBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.lay();
    auto* const dock = part<ReferenceDock>(window);
    dock->yawBox()->setValue(90);
    dock->xBox()->setValue(-4);
    QVERIFY(near(bench.reference()->pose(), {-4, 0, geometry::radiansFromDegrees(90)}, 1e-9));
  }

  void isRememberedForTheRobotAndItsMap() {
    ReferenceBench bench;
    bench.openOnRobot();
    bench.lay();
    part<ReferenceDock>(*bench.window)->xBox()->setValue(7);
    bench.say("Other hall");
    // Nothing is remembered there: it stays, and is remembered there from now on.
    QVERIFY(near(bench.reference()->pose(), {7, 0, 0}, 1e-9));
    part<ReferenceDock>(*bench.window)->xBox()->setValue(9);
    test::FakeRobot* const live = bench.robot;
    bench.say("Hall");
    bench.robot = live;
    QVERIFY(near(bench.reference()->pose(), {7, 0, 0}, 1e-9));
    bench.say("Other hall");
    bench.robot = live;
    QVERIFY(near(bench.reference()->pose(), {9, 0, 0}, 1e-9));
    QTest::mouseClick(part<ReferenceDock>(*bench.window)->removeButton(), Qt::LeftButton);
    QVERIFY(!part<ReferenceDock>(*bench.window)->moveButton()->isEnabled());
  }

  void theSameFileKeepsItsPlaceAndAnotherHasItsOwn() {
    ReferenceBench bench;
    bench.openOnRobot();
    bench.lay();
    part<ReferenceDock>(*bench.window)->xBox()->setValue(7);
    test::FakeRobot* const live = bench.robot;
    bench.reference()->lay(kFile);
    QCOMPARE(bench.reference()->pose().x_m, 7.0);
    bench.reference()->lay(QStringLiteral("file:/maps/other.yaml"));
    QTRY_COMPARE(bench.reference()->pose().x_m, 0.0);
    bench.reference()->lay(kFile);
    QTRY_COMPARE(bench.reference()->pose().x_m, 7.0);
    bench.robot = live;
  }

  void aFileThatCannotBeReadLeavesWhatIsLaid() {
    ReferenceBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.lay();
    part<ReferenceDock>(window)->xBox()->setValue(7);
    test::FakeRobot* const live = bench.robot;
    bench.reference()->lay(QStringLiteral("bad"));
    QVERIFY(part<ReferenceDock>(window)->moveButton()->isEnabled());
    bench.prepare = [](test::FakeRobot& made) {
      made.has_catalogue = true;
      made.maps.map_error = "There is no such map.";
    };
    bench.reference()->lay(QStringLiteral("file:/maps/gone.yaml"));
    QTRY_VERIFY(!part<MapOverlay>(window)->toasts()->texts().isEmpty());
    QVERIFY(part<ReferenceDock>(window)->moveButton()->isEnabled());
    QCOMPARE(bench.reference()->pose().x_m, 7.0);
    bench.robot = live;
  }

  void pairsLayTheMapAgainAfterItWasMoved() {
    ReferenceBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.lay();
    auto* const dock = part<ReferenceDock>(window);
    QTest::mouseClick(dock->pairsButton(), Qt::LeftButton);
    bench.look();
    bench.click(0, 0);
    bench.click(3, 0);
    dock->xBox()->setValue(20);
    QMetaObject::invokeMethod(dock, "fitWanted");
    QVERIFY(near(bench.reference()->pose(), {3, 0, 0}, 0.06));
  }

  void aPairTooManyIsRefusedWithAWord() {
    ReferenceBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.lay();
    auto* const dock = part<ReferenceDock>(window);
    auto* const tool = part<ReferenceTool>(window);
    const placing::PointPair pair{{1, 2}, {3, 4}};
    for (int i = 0; i < 200; ++i) Q_EMIT tool->paired(pair);
    QCOMPARE(dock->table()->model()->rowCount(), 200);
    auto* const toasts = part<MapOverlay>(window)->toasts();
    const QString refused =
        QStringLiteral("There are 200 pairs of points already, the most that are kept. Remove one first.");
    QVERIFY(!toasts->texts().contains(refused));
    Q_EMIT tool->paired(pair);
    QCOMPARE(dock->table()->model()->rowCount(), 200);
    QVERIFY2(toasts->texts().contains(refused), qPrintable(toasts->texts().join(QLatin1Char('\n'))));
  }

  void garbageThatIsRememberedIsNothing() {
    ReferenceBench bench;
    bench.openOnRobot();
    bench.lay();
    bench.settings.beginGroup(QStringLiteral("reference"));
    for (const QString& key : bench.settings.allKeys())
      bench.settings.setValue(key, QStringLiteral("{\"map\":7,\"pose\":[1],\"pairs\":[[1,2],{}]}"));
    bench.settings.endGroup();
    test::FakeRobot* const live = bench.robot;
    bench.say("Other hall");
    bench.robot = live;
    bench.say("Hall");
    bench.robot = live;
    QVERIFY(std::isfinite(bench.reference()->pose().x_m));
  }

  void whatLaysItIsUndoneAndRedone() {
    ReferenceBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.lay();
    auto* const dock = part<ReferenceDock>(window);
    QVERIFY(!bench.action("undo")->isEnabled());
    QTest::mouseClick(dock->moveButton(), Qt::LeftButton);
    bench.look();
    bench.drag(bench.at(0, 0), bench.at(2, 1));  // one step, however many moves
    bench.drag(bench.at(5, 0), bench.at(0, 5), Qt::ShiftModifier);
    QTest::mouseClick(dock->pairsButton(), Qt::LeftButton);
    bench.look();
    bench.click(-2, 3);
    bench.click(1, 3);
    dock->xBox()->setValue(7);
    const geometry::Pose2 last = bench.reference()->pose();
    QCOMPARE(dock->table()->model()->rowCount(), 1);
    bench.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(bench.reference()->pose().x_m != 7.0);
    QVERIFY(bench.action("undo")->text().contains(QLatin1String("pair of points")));
    bench.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(dock->table()->model()->rowCount(), 0);
    QVERIFY(near(bench.reference()->pose(), {-1, 2, geometry::radiansFromDegrees(90)}, 0.06));
    bench.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(near(bench.reference()->pose(), {2, 1, 0}, 0.06));
    bench.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(near(bench.reference()->pose(), {0, 0, 0}, 1e-9));
    QVERIFY(!bench.action("undo")->isEnabled());
    for (int i = 0; i < 4; ++i) bench.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(near(bench.reference()->pose(), last, 1e-9));
    QCOMPARE(dock->table()->model()->rowCount(), 1);
    // A drag that is given up is no step.
    QTest::mouseClick(dock->moveButton(), Qt::LeftButton);
    const QString before = bench.action("undo")->text();
    QTest::mousePress(window.view()->viewport(), Qt::LeftButton, {}, bench.at(0, 0));
    QMouseEvent move(QEvent::MouseMove, bench.at(3, 3), QPoint(), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(window.view()->viewport(), &move);
    bench.key(Qt::Key_Escape);
    QTest::mouseRelease(window.view()->viewport(), Qt::LeftButton, {}, bench.at(0, 0));
    QVERIFY(near(bench.reference()->pose(), last, 1e-9));
    QCOMPARE(bench.action("undo")->text(), before);
    // Steps go with the map.
    QTest::mouseClick(dock->removeButton(), Qt::LeftButton);
    QVERIFY(!bench.action("undo")->isEnabled());
  }

  void aTypedNumberIsUndoneFromItsField() {
    ReferenceBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.lay();
    auto* const x = part<ReferenceDock>(window)->xBox();
    x->setFocus();
    x->selectAll();
    QTest::keyClicks(x, QStringLiteral("7"));
    QTest::keyClick(x, Qt::Key_Return);
    QCOMPARE(bench.reference()->pose().x_m, 7.0);
    QTest::keyClick(x, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench.reference()->pose().x_m, 0.0);
  }

  void aNumberThatIsTooLargeIsShownAndNotTaken() {
    ReferenceBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.lay();
    auto* const yaw = part<ReferenceDock>(window)->yawBox();
    const double turned = yaw->value();
    yaw->setFocus();
    yaw->selectAll();
    QTest::keyClicks(yaw, QStringLiteral("1234"));
    QVERIFY2(yaw->text().startsWith(QLatin1String("1234")), qPrintable(yaw->text()));
    QVERIFY(yaw->property("beyond").toBool());
    QVERIFY(yaw->accessibleDescription().contains(QLatin1String("360")));
    QTest::keyClick(yaw, Qt::Key_Return);
    QCOMPARE(yaw->value(), turned);
    QVERIFY(!yaw->property("beyond").toBool());
    auto* const x = part<ReferenceDock>(window)->xBox();
    const double was = x->value();
    x->setFocus();
    x->selectAll();
    QTest::keyClicks(x, QStringLiteral("-99999999"));
    x->clearFocus();
    QCOMPARE(x->value(), was);
  }

  void everyNotationOfANumberIsTypedWhole_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<double>("taken");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* typed, double taken, const char* said) {
      QTest::newRow(typed) << QString::fromLatin1(typed) << taken << QString::fromLatin1(said);
    };
    row("1e9", 5, "1e9 is too large: at most 10000000.000 m.");
    row("1.5E2", 150, "");
    row("0.0001", 0, "0.0001 has too many decimals: 0.000 m is used.");
    row("12345678901234567890", 5, "12345678901234567890 is too large: at most 10000000.000 m.");
    row("0.12345678901234567890", 0.123, "0.12345678901234567890 has too many decimals: 0.123 m is used.");
    row("-2.", -2, "");
    row("1e", 5, "1e is no number.");
    row("-", 5, "- is no number.");
  }
  void everyNotationOfANumberIsTypedWhole() {
    QFETCH(QString, typed);
    QFETCH(double, taken);
    QFETCH(QString, said);
    ReferenceBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.lay();
    auto* const x = part<ReferenceDock>(window)->xBox();
    x->setValue(5);
    x->setFocus();
    x->selectAll();
    QTest::keyClicks(x, typed);
    QVERIFY2(x->text().startsWith(typed), qPrintable(x->text()));
    QTest::keyClick(x, Qt::Key_Return);
    QCOMPARE(x->value(), taken);
    QCOMPARE(bench.reference()->pose().x_m, taken);
    auto* const note = window.findChild<QLabel*>(QStringLiteral("outOfRange"));
    QCOMPARE(note ? note->text() : QString(), said);
  }

  void liesAboveWhileItIsLaidAndBelowAfterwards() {
    ReferenceBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.lay();
    auto* const dock = part<ReferenceDock>(window);
    QVERIFY(!window.mapScene()->referenceAbove());
    for (QPushButton* const button : {dock->moveButton(), dock->pairsButton()}) {
      QTest::mouseClick(button, Qt::LeftButton);
      QVERIFY(window.mapScene()->referenceAbove());
      QTest::mouseClick(button, Qt::LeftButton);
      QVERIFY(!window.mapScene()->referenceAbove());
    }
    QCOMPARE(window.mapScene()->layerOpacity(ui::scene::Layer::Reference), 1.0);
  }

  void aPointOutsideOfTheReferenceMapIsRefused() {
    ReferenceBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.lay();  // 4 x 3 m from the origin
    auto* const dock = part<ReferenceDock>(window);
    QTest::mouseClick(dock->pairsButton(), Qt::LeftButton);
    bench.look();
    bench.click(8, 2);
    QCOMPARE(part<MapOverlay>(window)->toasts()->texts().size(), qsizetype(1));
    bench.click(-9, 2);
    QCOMPARE(dock->table()->model()->rowCount(), 0);
    bench.click(1, 1);
    bench.click(9, 9);  // where it is may be anywhere
    QCOMPARE(dock->table()->model()->rowCount(), 1);
    bench.click(10, 10);  // the map has moved there
    bench.click(11, 10);
    QCOMPARE(dock->table()->model()->rowCount(), 2);
  }

  void escTakesTheFirstPointBackThenLeaves() {
    ReferenceBench bench;
    MainWindow& window = bench.openOnRobot();
    bench.lay();
    auto* const dock = part<ReferenceDock>(window);
    QTest::mouseClick(dock->pairsButton(), Qt::LeftButton);
    bench.look();
    bench.click(0, 0);
    bench.key(Qt::Key_Escape);
    QVERIFY(dock->pairsButton()->isChecked());
    bench.key(Qt::Key_Escape);
    QVERIFY(!dock->pairsButton()->isChecked());
    QCOMPARE(dock->table()->model()->rowCount(), 0);
  }

  void isLaidWhereItsWallsAre() {
    ReferenceBench bench;
    bench.openOn(Site::rooms(), Site::rooms().turned());
    bench.align();
    QVERIFY2(near(bench.reference()->pose(), kTurnedBack, 0.02), qPrintable(bench.dock()->alignmentSaid()));
    QVERIFY(bench.dock()->alignmentSaid().startsWith(QLatin1String("Sure")));
    QVERIFY(bench.dock()->alignmentFigures().contains(QLatin1String("Overlap: 100 %")));
    QVERIFY(!bench.dock()->bestButton()->isVisible());
    // One step, and what was found is said only while the map lies there.
    bench.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(near(bench.reference()->pose(), {}, 1e-9));
    QVERIFY(!bench.action("undo")->isEnabled());
    QVERIFY(bench.dock()->alignmentSaid().contains(QLatin1String("was moved since")));
    QVERIFY(bench.dock()->alignmentFigures().isEmpty());
    bench.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(bench.dock()->alignmentSaid().startsWith(QLatin1String("Sure")));
  }

  void aPartThatLiesBesideIsShown() {
    ReferenceBench bench;
    bench.openOn(Site::rooms(), Site::rooms());
    ui::AlignmentShown shown;
    shown.agreement.emplace();
    bench.dock()->setAlignment(shown);
    QVERIFY(!bench.dock()->partButton()->isVisible());
    shown.agreement->part = align::OffSquare{{4.5, -1.5}, 30, 0.15};
    bench.dock()->setAlignment(shown);
    QTest::mouseClick(bench.dock()->partButton(), Qt::LeftButton);
    const auto& marker = bench.window->mapScene()->marker();
    QVERIFY(marker && *marker == Eigen::Vector2d(4.5, -1.5));
    bench.dock()->setAlignment({});
    QVERIFY(!bench.dock()->partButton()->isVisible());
  }

  void nothingMovesWhereItIsNotSure() {
    ReferenceBench bench;
    bench.openOn(Site::halves(), Site::halves());
    auto* const dock = bench.dock();
    dock->xBox()->setValue(3);
    bench.align();
    QVERIFY2(dock->alignmentSaid().startsWith(QLatin1String("Not sure")), qPrintable(dock->alignmentSaid()));
    QVERIFY(near(bench.reference()->pose(), {3, 0, 0}, 1e-9));
    QVERIFY(dock->alignmentFigures().contains(QLatin1String("Second best: score ")));
    QTest::mouseClick(dock->bestButton(), Qt::LeftButton);
    const geometry::Pose2 best = bench.reference()->pose();
    QVERIFY(!dock->bestButton()->isEnabled());
    QTest::mouseClick(dock->secondButton(), Qt::LeftButton);
    QVERIFY(!near(bench.reference()->pose(), best, 0.05));
    QVERIFY(dock->bestButton()->isEnabled());
    bench.key(Qt::Key_Z, Qt::ControlModifier);
    bench.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(near(bench.reference()->pose(), {3, 0, 0}, 1e-9));
  }

  void onePairDecidesAndTwoNeedNoWalls() {
    ReferenceBench bench;
    bench.openOn(Site::halves(), Site::halves());
    auto* const dock = bench.dock();
    QTest::mouseClick(dock->pairsButton(), Qt::LeftButton);
    bench.look();
    bench.click(3, 3);
    bench.click(3, 3);
    bench.align();
    QVERIFY2(dock->alignmentSaid().startsWith(QLatin1String("Chosen by the pair")),
             qPrintable(dock->alignmentSaid()));
    QVERIFY(near(bench.reference()->pose(), {}, 0.02));
    bench.click(5, 3);
    bench.click(5, 3);
    QVERIFY(!dock->alignmentSaid().contains(QLatin1String("Chosen")));
    const geometry::Pose2 before = bench.reference()->pose();
    bench.align();
    QVERIFY(dock->alignmentSaid().contains(QLatin1String("Fit again")));
    QCOMPARE(bench.reference()->pose(), before);
  }

  void whatIsMovedMeanwhileStaysWhereItIs() {
    ReferenceBench bench;
    bench.openOn(Site::rooms(), Site::rooms().turned());
    auto* const dock = bench.dock();
    QTest::mouseClick(dock->alignButton(), Qt::LeftButton);
    QVERIFY(dock->cancelButton()->isVisible());
    dock->xBox()->setValue(3);
    QVERIFY(!dock->cancelButton()->isVisible());
    QVERIFY(dock->alignmentSaid().contains(QLatin1String("moved meanwhile")));
    QTest::mouseClick(dock->alignButton(), Qt::LeftButton);
    QTest::mouseClick(dock->cancelButton(), Qt::LeftButton);
    QVERIFY(dock->alignmentSaid().isEmpty());
    QVERIFY(near(bench.reference()->pose(), {3, 0, 0}, 1e-9));
  }

  void whatWasFoundOnAnotherMapIsForgotten() {
    ReferenceBench bench;
    bench.openOn(Site::rooms(), Site::rooms().turned());
    bench.align();
    part<MapsController>(*bench.window)->open({map::MapKind::Stored, "2"});
    QTRY_VERIFY(!bench.dock()->alignmentSaid().startsWith(QLatin1String("Sure")));
    QVERIFY(bench.dock()->alignmentFigures().isEmpty());
    bench.dock()->removeButton()->click();
    QVERIFY(bench.dock()->alignmentSaid().isEmpty());
  }

  void aMapThatIsChosenToBeAlignedIs() {
    ReferenceBench bench;
    bench.openOn(Site::rooms(), Site::rooms().turned());
    test::FakeRobot* const live = bench.robot;
    bench.reference()->alignWith(QStringLiteral("file:/maps/other.yaml"));
    bench.robot = live;
    QTRY_VERIFY_WITH_TIMEOUT(bench.dock()->alignmentSaid().startsWith(QLatin1String("Sure")), 60'000);
    QVERIFY(near(bench.reference()->pose(), kTurnedBack, 0.02));
  }

  void anotherMapOfTheRobotIsAligned() {
    ReferenceBench bench;
    bench.openOn(Site::rooms(), Site::rooms());
    bench.robot->maps.pictures["2"] = Site::rooms().turned().map({map::MapKind::Stored, "2"});
    const std::size_t before = bench.robot->maps.opened.size();
    Q_EMIT part<MapsController>(*bench.window)->alignWanted({map::MapKind::Stored, "2"});
    QTRY_VERIFY_WITH_TIMEOUT(bench.dock()->alignmentSaid().startsWith(QLatin1String("Sure")), 60'000);
    QVERIFY(near(bench.reference()->pose(), kTurnedBack, 0.02));
    QCOMPARE(bench.robot->maps.opened.size(), before + 1);
    QCOMPARE(bench.window->session()->wholeMap().shown().key.id, std::string("1"));
    // Its place is remembered; the robot is not asked for it again by itself.
    bench.say("Other hall");
    bench.say("Hall");
    QCOMPARE(bench.robot->maps.opened.size(), before + 1);
    QVERIFY(near(bench.reference()->pose(), kTurnedBack, 0.02));
  }

  void submapsAreAlignedWithWhereTheyAreOnScreen() {
    ReferenceBench bench;
    bench.openOnRobot();
    bench.load();
    bench.lay();
    bench.align();
    const QString said = bench.dock()->alignmentSaid();
    QVERIFY2(said.startsWith(QLatin1String("Not sure")), qPrintable(said));
    bench.robot->list({test::entry(0, 0, 2, 0, 0), test::entry(0, 1, 1, 5, 0), test::entry(1, 0, 3, 41, 0)});
    QTRY_VERIFY(bench.dock()->alignmentSaid().contains(QLatin1String("changed since then")));
  }

  void withoutAMapThereIsNothingToAlignWith() {
    ReferenceBench bench;
    bench.openOnRobot();
    bench.lay();
    bench.align();
    QVERIFY(bench.dock()->alignmentSaid().startsWith(QLatin1String("There is no map on screen")));
    QVERIFY(!bench.dock()->differencesBox()->isEnabled());
  }

  void differencesLieAboveTheMapWhereTheyAreWanted() {
    ReferenceBench bench;
    MainWindow& window = bench.openOn(Site::rooms(), Site::room());
    const auto colorAt = [&](double x_m, double y_m) {
      return window.view()->viewport()->grab().toImage().pixelColor(bench.at(x_m, y_m));
    };
    const QPoint wall{112, 200};  // on the robot's map only
    const Eigen::Vector2d at_m((wall.x() - 0.5) * Site::kCell_m, (240 - wall.y()) * Site::kCell_m);
    QVERIFY(bench.dock()->differencesBox()->isEnabled());
    bench.dock()->differencesBox()->click();
    const auto isRed = [](const QColor& color) { return color.red() > color.green() + 80; };
    QTRY_VERIFY(isRed(colorAt(at_m.x(), at_m.y())));
    bench.dock()->differencesBox()->click();
    QTRY_VERIFY(!isRed(colorAt(at_m.x(), at_m.y())));
  }

  void aMapThatIsFetchedIsNotAlignedOnceItIsCancelled() {
    ReferenceBench bench;
    bench.openOn(Site::rooms(), Site::halves());
    Q_EMIT part<MapsController>(*bench.window)->alignWanted({map::MapKind::Stored, "2"});
    QCOMPARE(bench.dock()->alignmentSaid(), QStringLiteral("Fetching the map…"));
    QVERIFY(bench.dock()->cancelButton()->isVisible());
    QTest::mouseClick(bench.dock()->cancelButton(), Qt::LeftButton);
    QVERIFY(!bench.dock()->cancelButton()->isVisible());
    QCOMPARE(bench.dock()->alignmentSaid(), QString());
    // Its answer comes nevertheless, and what was laid before stays.
    QCOMPARE(bench.robot->maps.opened.back(), (map::MapKey{map::MapKind::Stored, "2"}));
    QCoreApplication::processEvents();
    QCoreApplication::processEvents();
    QCOMPARE(bench.dock()->alignmentSaid(), QString());
    bench.robot->maps.pictures["2"] = Site::rooms().turned().map({map::MapKind::Stored, "2"});
    Q_EMIT part<MapsController>(*bench.window)->alignWanted({map::MapKind::Stored, "2"});
    QTRY_VERIFY_WITH_TIMEOUT(bench.dock()->alignmentSaid().startsWith(QLatin1String("Sure")), 60'000);
  }

  void aMapThatCannotBeFetchedToBeAlignedIsSaid() {
    ReferenceBench bench;
    bench.openOn(Site::rooms(), Site::rooms());
    bench.robot->maps.map_error = "The robot is asleep.";
    Q_EMIT part<MapsController>(*bench.window)->alignWanted({map::MapKind::Stored, "2"});
    QTRY_VERIFY(bench.dock()->alignmentSaid().startsWith(
        QLatin1String("The map to align with could not be fetched.")));
    QVERIFY(!bench.dock()->cancelButton()->isVisible());
    QVERIFY(bench.dock()->alignButton()->isEnabled());
  }

  void wallsThatAreFarFromThoseOfTheOtherMapAreMarked() {
    Site before = Site::rooms(), after = Site::rooms();
    before.wall(60, 100, 90, 103), after.wall(60, 104, 90, 107);    // by 0.2 m
    before.wall(250, 90, 280, 93), after.wall(250, 102, 280, 105);  // by 0.6 m
    after.wall(185, 105, 200, 108);                                 // nothing is near
    ReferenceBench bench;
    bench.openOn(after, before);
    const WallsOffMarks& marks = bench.reference()->wallsOff();
    QTest::keyClick(bench.dock()->wallsOffBox(), Qt::Key_Space);
    QTRY_VERIFY(!marks.running() && marks.shown() && !marks.shown()->walls.empty());
    QVERIFY(bench.dock()->wallsOffLegend()->isVisible());
    // The most that is off there, within a metre.
    const auto most = [&](double x_m, double y_m) {
      double most_m = 0;
      for (const scene::OffWall& wall : marks.shown()->walls) {
        if ((wall.at_m - Eigen::Vector2d(x_m, y_m)).norm() < 0.1) most_m = std::max(most_m, wall.off_m);
      }
      return most_m;
    };
    const auto is = [](double off_m, double wanted_m) { return std::abs(off_m - wanted_m) < 0.06; };
    QVERIFY(is(most(3.75, 6.98), 0.2) && is(most(3.75, 6.68), 0.2));  // both ways
    QVERIFY(is(most(13.25, 7.48), 0.6) && is(most(13.25, 6.78), 0.6));
    QVERIFY(most(9.6, 6.7) > 1);
    QCOMPARE(most(5.6, 11), 0.0);
    // They are seen.
    bench.window->view()->moveTo(
        [&] {
          geometry::ViewTransform view = bench.window->mapScene()->view();
          view.center_m = {9.6, 6.7};
          view.scale_m_per_px = 0.01;
          return view;
        }(),
        false);
    const QPoint there = bench.at(9.6, 6.7);
    QTRY_COMPARE(bench.window->view()->viewport()->grab().toImage().pixelColor(there), scene::offColor(2));
    // The box and the eye of the layer are one.
    scene::MapScene& map = *bench.window->mapScene();
    QVERIFY(map.layerVisible(scene::Layer::WallsOff));
    QVERIFY(map.layerBounds(scene::Layer::WallsOff).contains({9.6, 6.7}));
    const auto legendRows = [&] {
      for (const scene::LegendSection& section : map.legend(1)) {
        if (section.title == scene::layerTitle(scene::Layer::WallsOff)) return section.rows.size();
      }
      return std::size_t(0);
    };
    QCOMPARE(legendRows(), std::size_t(3));
    map.setLayerVisible(scene::Layer::WallsOff, false);
    QVERIFY(!bench.dock()->wallsOffBox()->isChecked());
    QVERIFY(!marks.shown());
    QCOMPARE(legendRows(), std::size_t(0));
    map.setLayerVisible(scene::Layer::WallsOff, true);
    QTRY_VERIFY(!marks.running() && marks.shown());
    QVERIFY(bench.dock()->wallsOffBox()->isChecked());
    QTest::keyClick(bench.dock()->wallsOffBox(), Qt::Key_Space);
    QVERIFY(!marks.shown());
    QVERIFY(!bench.dock()->wallsOffLegend()->isVisible());
  }

  void wallsThatAreOffFollowTheReferenceMap() {
    ReferenceBench bench;
    bench.openOn(Site::rooms(), Site::rooms());
    const WallsOffMarks& marks = bench.reference()->wallsOff();
    QTest::keyClick(bench.dock()->wallsOffBox(), Qt::Key_Space);
    QTRY_VERIFY(!marks.running() && marks.shown());
    QVERIFY(marks.shown()->walls.empty());
    QVERIFY(!bench.dock()->wallsOffLegend()->isVisible());
    bench.dock()->xBox()->setValue(0.4);
    QTRY_VERIFY(!marks.running() && marks.shown() && !marks.shown()->walls.empty());
    bench.dock()->removeButton()->click();
    QVERIFY(!marks.shown());
    QVERIFY(!bench.dock()->wallsOffBox()->isEnabled());
  }

  void isSwipedOverTheMapOnScreen() {
    ReferenceBench bench;
    bench.also = [](FakeRobot& made) { made.maps.pictures[""].overlays.emplace_back(); };
    bench.openOn(Site::rooms(), Site::rooms().turned());
    bench.align();
    QTest::mouseClick(bench.dock()->swipeButton(), Qt::LeftButton);
    QCOMPARE(bench.window->mapScene()->compareMode(), ui::scene::CompareMode::Swipe);
    const session::MapSlot& compared = bench.window->session()->comparedMap();
    QTRY_VERIFY(compared.cells() && compared.settled());
    QVERIFY(near(compared.reference().origin, bench.reference()->pose(), 1e-9));
    QVERIFY(compared.shown().overlays.empty());  // they lie where they were on the old map
    QVERIFY(near(bench.reference()->pose(), kTurnedBack, 0.05));
    bench.key(Qt::Key_Escape);
    QCOMPARE(bench.window->mapScene()->compareMode(), ui::scene::CompareMode::Off);
    bench.dock()->removeButton()->click();
    QVERIFY(!bench.dock()->swipeButton()->isEnabled());
  }

  void keysMoveAndTurnIt() {
    ReferenceBench bench;
    bench.openOnRobot();
    bench.lay();
    QTest::mouseClick(bench.dock()->moveButton(), Qt::LeftButton);
    bench.look();
    bench.window->view()->setFocus();
    bench.key(Qt::Key_Right);
    bench.key(Qt::Key_Up, Qt::ShiftModifier);
    bench.key(Qt::Key_Up);
    QVERIFY(near(bench.reference()->pose(), {0.05, 0.55, 0}, 1e-9));
    bench.key(Qt::Key_BracketLeft);
    bench.key(Qt::Key_BraceLeft, Qt::ShiftModifier);
    bench.key(Qt::Key_BracketRight);
    QVERIFY(std::abs(bench.reference()->pose().yaw_rad - geometry::radiansFromDegrees(1)) < 1e-9);
    QCOMPARE(bench.window->mapScene()->view().rotation_rad, 0.0);
    // One step, until the mouse is used.
    bench.drag(bench.at(0, 0), bench.at(2, 1));
    bench.key(Qt::Key_Left);
    bench.key(Qt::Key_Z, Qt::ControlModifier);
    bench.key(Qt::Key_Z, Qt::ControlModifier);
    bench.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(near(bench.reference()->pose(), {}, 1e-9));
    QVERIFY(!bench.action("undo")->isEnabled());
    // While points are added the arrows pan the view.
    QTest::mouseClick(bench.dock()->pairsButton(), Qt::LeftButton);
    bench.key(Qt::Key_Right);
    QVERIFY(near(bench.reference()->pose(), {}, 1e-9));
  }
};

}  // namespace test_window_reference

MAPWRIGHT_TEST(test_window_reference, TestWindowReference, Widgets)
#include "test_window_reference.moc"
