// Where submaps contradict each other, in the window: the places, and stepping through the submaps of one.
#include <QCheckBox>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QtTest>

#include "submap/submap_store.h"
#include "test_program.h"
#include "ui/kit/plain_label.h"
#include "ui/slam/closures_dock.h"
#include "ui/slam/closures_model.h"
#include "ui/slam/disagreement_dock.h"
#include "ui/slam/place_square.h"
#include "ui/slam/work_pace.h"
#include "ui/view/map_view.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_disagreement {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;
using test::entry;
using test::kAddress;
using ui::scene::Layer;

namespace {

using Ids = std::set<map::SubmapId>;

/// The wall of 0-0 (y -0.5 .. 0, x -5 .. 0) is free in 0-1: 200 cells in each of five squares. 0-2 is far
/// away.
std::vector<map::SubmapEntry> contradicting() {
  return {entry(0, 0, 1, 0, 0), entry(0, 1, 1, 0, 2), entry(0, 2, 1, 60, 0)};
}

struct Desk {
  explicit Desk(std::vector<map::SubmapEntry> entries = contradicting(), bool open = true)
      : window(bench.open({1366, 1000})), dock(*part<DisagreementDock>(window)) {
    if (open) {
      dock.show();
      dock.raise();
    }
    (void)window.connectTo(kAddress);
    if (!entries.empty()) bench.robot->list(std::move(entries));
  }
  QString said() const { return dock.summary()->text(); }
  /// What is said of the submap in hand.
  QString step() const {
    for (const PlainLabel* const label : dock.findChildren<PlainLabel*>())
      if (label->text().startsWith(QStringLiteral("Submap "))) return label->text();
    return {};
  }
  /// Of 0-0, 0-1 and 0-2.
  std::vector<bool> shown() const {
    std::vector<bool> all;
    for (const auto& [id, row] : window.session()->submaps().rows()) all.push_back(row.visible);
    return all;
  }
  void clickRow(int row) {
    QTest::mouseClick(dock.table()->viewport(), Qt::LeftButton, {},
                      dock.table()->visualRect(dock.model()->index(row, 0)).center());
  }
  /// The rows of the chosen place, of which there is none or one, and where it lies.
  QPointF chosen() const {
    const QModelIndexList rows = dock.table()->selectionModel()->selectedRows();
    if (rows.size() != 1) return {};
    return {dock.model()->place(rows[0].row()).x, dock.model()->place(rows[0].row()).y};
  }
  /// The outline of the chosen place, if there is one.
  const PlaceSquare* square() const {
    for (QGraphicsItem* const item : window.mapScene()->items()) {
      const auto* const square = qgraphicsitem_cast<PlaceSquare*>(item);
      if (square && square->isVisible()) return square;
    }
    return nullptr;
  }
  bool found() {
    return QTest::qWaitFor([this] { return dock.model()->rowCount() == 5; }, 10'000);
  }

  Bench bench;
  MainWindow& window;
  DisagreementDock& dock;
};

using Shown = std::vector<bool>;

}  // namespace

class TestWindowDisagreement : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void placesAreListedAndCounted() {
    Desk desk;
    QVERIFY(desk.found());
    const PlacesModel& model = *desk.dock.model();
    for (int row = 0; row < 5; ++row) {
      QCOMPARE(model.place(row).cells, std::uint64_t(200));
      QCOMPARE(model.place(row).y, -0.5);
      QCOMPARE(model.place(row).submaps, (std::vector<agreement::Part>{{{0, 0}, 200, 0}, {{0, 1}, 0, 200}}));
      QCOMPARE(model.index(row, PlacesModel::SubmapsColumn).data(Qt::ToolTipRole).toString(),
               plainToolTip(QStringLiteral("0-0: occupied in 200 cells, free in 0\n"
                                           "0-1: occupied in 0 cells, free in 200")));
    }
    QTRY_VERIFY2(desk.said().contains(QStringLiteral("1,000 of 3,000")), qPrintable(desk.said()));
    QVERIFY(desk.said().contains(QStringLiteral("33.3 %")));
    QVERIFY(desk.dock.table()->isVisible() && desk.dock.blinkButton()->isVisible());
    // 0-1 moves away: there is nothing left.
    auto moved = contradicting();
    moved[1].pose = geometry::poseFromYaw(0, 30, 0);
    desk.bench.robot->list(moved);
    QTRY_COMPARE(model.rowCount(), 0);
    QTRY_COMPARE(desk.said(), QStringLiteral("No submaps contradict each other here."));
    QVERIFY(!desk.dock.table()->isVisible() && !desk.dock.blinkButton()->isVisible());
  }

  void withoutSubmapsItSaysSo() {
    Desk desk(std::vector<map::SubmapEntry>{});
    QTRY_COMPARE(desk.said(), QStringLiteral("No submaps are on the map so far."));
    desk.window.leaveRobot();
    QTRY_VERIFY(desk.said().startsWith(QStringLiteral("Connect to a robot")));
  }

  void whatIsMissingOrHiddenIsSaid() {
    Desk desk(std::vector<map::SubmapEntry>{});
    desk.bench.robot->missing = {{0, 2}};
    desk.bench.robot->list(contradicting());
    QTRY_VERIFY2(desk.said().contains(QStringLiteral("1 submap is still missing.")), qPrintable(desk.said()));
    desk.window.session()->setVisible({{0, 1}}, false);
    QTRY_VERIFY2(desk.said().startsWith(QStringLiteral("No submaps contradict")), qPrintable(desk.said()));
    QVERIFY(desk.said().contains(QStringLiteral("1 hidden submap does not count.")));
  }

  void aClickOrEnterGoesThere_data() {
    QTest::addColumn<bool>("click");
    QTest::newRow("click") << true;
    QTest::newRow("Enter") << false;
  }
  void aClickOrEnterGoesThere() {
    QFETCH(bool, click);
    Desk desk;
    QVERIFY(desk.found());
    if (click) {
      desk.clickRow(2);
    } else {
      desk.dock.table()->setCurrentIndex(desk.dock.model()->index(2, 0));
      QTest::keyClick(desk.dock.table(), Qt::Key_Return);
    }
    const agreement::Place& place = desk.dock.model()->place(2);
    const Eigen::Vector2d at(place.x, place.y);
    const ui::scene::MapScene& scene = *desk.window.mapScene();
    QTRY_VERIFY((scene.view().center_m - at).norm() < 1e-6);
    QCOMPARE(scene.highlighted(), (Ids{{0, 0}, {0, 1}}));
    // Its square takes a fifth of the view.
    QVERIFY(desk.square());
    const double fifth = std::min(scene.view().width_px, scene.view().height_px) / 5.0;
    QTRY_VERIFY(std::abs(desk.square()->seen().height() - fifth) < 1);
    desk.bench.key(Qt::Key_Escape);
    QVERIFY(!desk.square() && scene.highlighted().empty());
    QVERIFY(!desk.dock.nextButton()->isEnabled());
  }

  void stepsShowOneOfThemAndGiveBackTheRest_data() {
    QTest::addColumn<QString>("end");
    for (const char* end : {"All", "Esc", "another place", "closed"})
      QTest::newRow(end) << QString::fromLatin1(end);
  }
  void stepsShowOneOfThemAndGiveBackTheRest() {
    QFETCH(QString, end);
    Desk desk;
    QVERIFY(desk.found());
    QVERIFY(!desk.dock.nextButton()->isEnabled());
    desk.window.session()->setVisible({{0, 2}}, false);
    desk.clickRow(0);
    desk.dock.nextButton()->click();
    QCOMPARE(desk.shown(), (Shown{true, false, false}));
    QVERIFY(desk.window.mapScene()->highlighted().empty());  // what is to be seen is not tinted
    QVERIFY(desk.square());
    desk.dock.nextButton()->click();
    QCOMPARE(desk.shown(), (Shown{false, true, false}));
    desk.dock.nextButton()->click();
    QCOMPARE(desk.shown(), (Shown{true, false, false}));
    QCOMPARE(desk.dock.model()->rowCount(), 5);
    if (end == QLatin1String("All")) desk.dock.allButton()->click();
    if (end == QLatin1String("Esc")) desk.bench.key(Qt::Key_Escape);
    if (end == QLatin1String("another place")) desk.clickRow(1);
    if (end == QLatin1String("closed")) desk.dock.close();
    QTRY_COMPARE(desk.shown(), (Shown{true, true, false}));
    QVERIFY(!desk.dock.allButton()->isEnabled());
    QCOMPARE(desk.window.mapScene()->highlighted().size(),
             std::size_t(end == QLatin1String("closed") ? 0 : 2));
  }

  void escEndsTheStepsBeforeItTakesAnotherMark() {
    Desk desk;
    QVERIFY(desk.found());
    desk.clickRow(0);
    const Eigen::Vector2d gone_to(3, 3);
    desk.window.mapScene()->setMarker(gone_to);
    desk.dock.blinkButton()->click();
    QVERIFY(desk.shown() != (Shown{true, true, true}));
    desk.bench.key(Qt::Key_Escape);
    QCOMPARE(desk.shown(), (Shown{true, true, true}));
    QVERIFY(!desk.dock.blinkButton()->isChecked());
    QVERIFY(desk.window.mapScene()->marker() == gone_to && desk.square());
  }

  void anotherThingToLookAtTakesTheMarksAway_data() {
    QTest::addColumn<QString>("thing");
    for (const char* thing : {"closure", "tolerance", "closed"})
      QTest::newRow(thing) << QString::fromLatin1(thing);
  }
  void anotherThingToLookAtTakesTheMarksAway() {
    QFETCH(QString, thing);
    Desk desk;
    QVERIFY(desk.found());
    desk.clickRow(0);
    QVERIFY(desk.square() && desk.dock.blinkButton()->isEnabled());
    if (thing == QLatin1String("closure")) Q_EMIT part<ClosuresDock>(desk.window)->chosen({.at = {30, 30}});
    if (thing == QLatin1String("closed")) desk.dock.close();
    if (thing == QLatin1String("tolerance")) {
      desk.dock.toleranceBox()->setCurrentIndex(0);
      Q_EMIT desk.dock.toleranceBox()->activated(0);
    }
    QVERIFY(!desk.square() && desk.window.mapScene()->highlighted().empty());
    QVERIFY(!desk.dock.blinkButton()->isEnabled());
    QVERIFY(desk.chosen().isNull());
  }

  void theFocusAloneChoosesNothing() {
    Desk desk;
    QVERIFY(desk.found());
    desk.dock.table()->selectionModel()->setCurrentIndex(desk.dock.model()->index(1, 0),
                                                         QItemSelectionModel::NoUpdate);
    auto entries = contradicting();
    entries[2].pose = geometry::poseFromYaw(60, -20, 0);
    entries.push_back(entry(0, 3, 1, 60, -18));
    desk.bench.robot->list(entries);
    QTRY_COMPARE_WITH_TIMEOUT(desk.dock.model()->rowCount(), 10, 20'000);
    QVERIFY(desk.chosen().isNull() && !desk.dock.blinkButton()->isEnabled());
  }

  void whatTheUserHidesMeanwhileStaysHidden() {
    Desk desk;
    QVERIFY(desk.found());
    desk.clickRow(0);
    desk.dock.nextButton()->click();
    desk.window.session()->setVisible({{0, 0}}, false);
    desk.dock.allButton()->click();
    QCOMPARE(desk.shown(), (Shown{false, true, true}));
  }

  void theSubmapInHandIsHiddenAndShownAgain() {
    Desk desk;
    QVERIFY(desk.found());
    QPushButton* const hide = desk.dock.hideButton();
    desk.clickRow(0);
    QVERIFY(!hide->isEnabled());
    desk.dock.nextButton()->click();
    QVERIFY2(desk.step().startsWith(QStringLiteral("Submap 0-0, 1 of 2")), qPrintable(desk.step()));
    QVERIFY(desk.step().endsWith(QStringLiteral("occupied in 200 cells, free in 0")));
    desk.dock.nextButton()->click();
    QVERIFY(desk.step().endsWith(QStringLiteral("occupied in 0 cells, free in 200")));
    hide->click();
    // The others are back, and the place is no longer one.
    QCOMPARE(desk.shown(), (Shown{true, false, true}));
    QVERIFY(!desk.dock.allButton()->isEnabled());
    QCOMPARE(desk.step(), QStringLiteral("Submap 0-1 is hidden."));
    QTRY_COMPARE(desk.dock.model()->rowCount(), 0);
    QVERIFY(desk.said().contains(QStringLiteral("1 hidden submap does not count.")));
    QVERIFY(desk.dock.showHiddenButton()->isVisible() && hide->isVisible());
    QCOMPARE(hide->text(), QStringLiteral("Show"));
    hide->click();
    QCOMPARE(desk.shown(), (Shown{true, true, true}));
    QCOMPARE(hide->text(), QStringLiteral("Hide"));
    QVERIFY(desk.found());
    QTRY_VERIFY(!desk.dock.showHiddenButton()->isVisible());
    // The next one is the next one.
    desk.dock.nextButton()->click();
    QCOMPARE(desk.shown(), (Shown{true, false, true}));
  }

  void allHiddenOnesAreShownByOneButton() {
    Desk desk;
    QVERIFY(desk.found());
    desk.window.session()->setVisible({{0, 0}, {0, 2}}, false);
    QTRY_VERIFY(desk.dock.showHiddenButton()->isVisible());
    desk.dock.showHiddenButton()->click();
    QCOMPARE(desk.shown(), (Shown{true, true, true}));
    QTRY_VERIFY(!desk.dock.showHiddenButton()->isVisible());
  }

  void whatIsHiddenMeanwhileCanBeShownWhereItIsSteppedTo() {
    Desk desk;
    QVERIFY(desk.found());
    desk.window.session()->setVisible({{0, 0}}, false);
    QTRY_COMPARE(desk.dock.model()->rowCount(), 0);
    desk.dock.showHiddenButton()->click();
    QVERIFY(desk.found());
    desk.clickRow(0);
    desk.window.session()->setVisible({{0, 0}}, false);
    desk.dock.nextButton()->click();
    QCOMPARE(desk.shown(), (Shown{true, false, true}));  // shown for the step
    QVERIFY(desk.step().contains(QStringLiteral("otherwise hidden")));
    desk.dock.hideButton()->click();
    QCOMPARE(desk.shown(), (Shown{true, true, true}));
    QCOMPARE(desk.step(), QStringLiteral("Submap 0-0 is shown."));
  }

  void onlyTheFramesOfThePlaceAreDrawnWhileItIsSteppedThrough() {
    Desk desk({entry(0, 0, 1, 0, 0), entry(0, 1, 1, 0, 2), entry(0, 2, 1, 10, 0)});
    QVERIFY(desk.found());
    ui::scene::MapScene& scene = *desk.window.mapScene();
    scene.setLayersVisible({Layer::Outlines});
    desk.clickRow(0);
    part<MapView>(desk.window)->fit({-15, -15, 15, 15}, false);
    const auto inked = [&](double x, double y) {
      const Eigen::Vector2d px = scene.view().pixelFromWorld({x, y});
      QImage image(scene.view().width_px, scene.view().height_px, QImage::Format_RGB32);
      QPainter painter(&image);
      scene.render(&painter, image.rect(), image.rect());
      const QRgb ground = image.pixel(4, image.height() / 2);
      for (int dx = -2; dx <= 2; ++dx)
        if (image.pixel(int(px.x()) + dx, int(px.y())) != ground) return true;
      return false;
    };
    QVERIFY(inked(10, -0.75));  // of 0-2
    desk.dock.nextButton()->click();
    QVERIFY(!inked(10, -0.75) && inked(0, -0.75));
    desk.dock.allButton()->click();
    QVERIFY(inked(10, -0.75));
  }

  void blinkingShowsThemInTurn() {
    Desk desk;
    QVERIFY(desk.found());
    desk.clickRow(0);
    desk.dock.blinkButton()->click();
    QCOMPARE(desk.shown(), (Shown{true, false, true}));
    QTRY_COMPARE(desk.shown(), (Shown{false, true, true}));
    QTRY_COMPARE(desk.shown(), (Shown{true, false, true}));
    desk.dock.allButton()->click();
    QVERIFY(!desk.dock.blinkButton()->isChecked());
    QCOMPARE(desk.shown(), (Shown{true, true, true}));
  }

  void theChosenPlaceAndItsStepStayWhereverItIsListed() {
    Desk desk;
    QVERIFY(desk.found());
    desk.clickRow(2);
    const QPointF chosen = desk.chosen();
    desk.dock.nextButton()->click();
    desk.dock.nextButton()->click();
    QCOMPARE(desk.shown(), (Shown{false, true, true}));
    auto entries = contradicting();  // others come above it
    entries[2].pose = geometry::poseFromYaw(60, -20, 0);
    entries.push_back(entry(0, 3, 1, 60, -18));
    desk.bench.robot->list(entries);
    QTRY_COMPARE_WITH_TIMEOUT(desk.dock.model()->rowCount(), 10, 20'000);
    QCOMPARE(desk.dock.table()->currentIndex().row(), 7);
    QCOMPARE(desk.chosen(), chosen);
    QCOMPARE(desk.shown(), (Shown{false, true, true, true}));
    desk.dock.nextButton()->click();
    QCOMPARE(desk.shown(), (Shown{true, false, true, true}));
  }

  void aPlaceThatGoesAndComesBackIsStillChosen() {
    Desk desk;
    QVERIFY(desk.found());
    desk.clickRow(3);
    const QPointF chosen = desk.chosen();
    auto moved = contradicting();
    moved[1].pose = geometry::poseFromYaw(0, 30, 0);
    desk.bench.robot->list(moved);
    QTRY_COMPARE(desk.dock.model()->rowCount(), 0);
    QVERIFY(desk.dock.nextButton()->isVisible());  // or else there would be no way back to all
    desk.bench.robot->list(contradicting());
    QVERIFY(desk.found());
    QCOMPARE(desk.chosen(), chosen);
  }

  void theListStaysWhereItIsScrolledTo() {
    // A wall of 200 m: 200 places.
    std::vector<map::SubmapEntry> entries;
    for (int i = 0; i < 40; ++i) {
      entries.push_back(entry(0, 2 * i, 1, i * 5, 0));
      entries.push_back(entry(0, 2 * i + 1, 1, i * 5, 2));
    }
    Desk desk(entries);
    QTRY_COMPARE_WITH_TIMEOUT(desk.dock.model()->rowCount(), 200, 20'000);
    desk.clickRow(2);
    QScrollBar* const bar = desk.dock.table()->verticalScrollBar();
    bar->setValue(bar->maximum() / 2);
    const int scrolled = bar->value();
    QVERIFY(scrolled > 0);
    const QPointF chosen = desk.chosen();
    entries[20].pose = geometry::poseFromYaw(50, 500, 0);
    desk.bench.robot->list(entries);
    QTRY_VERIFY_WITH_TIMEOUT(desk.dock.model()->rowCount() < 200, 20'000);
    QCOMPARE(bar->value(), scrolled);
    QCOMPARE(desk.chosen(), chosen);
  }

  void whileARobotMovesNothingComesAndGoes() {
    Desk desk;
    QVERIFY(desk.found());
    QStringList said;
    for (int step = 0; step < 5; ++step) {
      auto entries = contradicting();
      entries[1].pose = geometry::poseFromYaw(0, 2 + 0.05 * (step % 2), 0);
      entries[2].pose = geometry::poseFromYaw(60 + step, 0, 0);
      desk.bench.robot->list(entries);
      (void)QTest::qWaitFor(
          [&] {
            if (said.isEmpty() || said.back() != desk.said()) said << desk.said();
            if (desk.dock.workButton()->isVisible()) said << QStringLiteral("Cancel");
            return desk.dock.toleranceBox()->isHidden();  // never
          },
          450);
    }
    for (const QString& text : said) {
      QVERIFY2(text.contains(QStringLiteral("of the occupied cells")), qPrintable(text));
      QVERIFY2(!text.contains(QStringLiteral("squares of the map")), qPrintable(text));
    }
    QTRY_VERIFY(!desk.said().contains(QStringLiteral("still being looked at")));
  }

  void noEndIsSaidBeforeAllIsLookedAt() {
    Desk desk({entry(0, 0, 1, 0, 0), entry(0, 1, 1, 30, 0)});
    QTRY_COMPARE(desk.said(), QStringLiteral("No submaps contradict each other here."));
    desk.bench.robot->list({entry(0, 0, 1, 0, 0), entry(0, 1, 1, 0, 2)});
    QTRY_COMPARE(desk.window.session()->submaps().placement({0, 1}, 0)->world_from_texture.x_m, 0.0);
    QVERIFY2(!desk.said().startsWith(QStringLiteral("No submaps contradict")), qPrintable(desk.said()));
    QVERIFY(desk.found());
  }

  void onlyWhatTakesLongAndAnEndThatLastsAreSaid() {
    using Ms = WorkPace::Ms;
    WorkPace pace;
    QVERIFY(!pace.isLong() && !pace.isSettled() && !pace.changesIn());
    pace.update(Ms(10), true, false);
    QCOMPARE(pace.changesIn(), std::optional(WorkPace::kLong));
    pace.update(Ms(10) + WorkPace::kLong - Ms(1), true, false);
    QVERIFY(!pace.isLong());
    QCOMPARE(pace.changesIn(), std::optional(Ms(1)));
    pace.update(Ms(10) + WorkPace::kLong, true, false);
    QVERIFY(pace.isLong() && !pace.changesIn());
    // The first end is said at once.
    pace.update(Ms(5000), false, true);
    QVERIFY(!pace.isLong() && pace.isSettled() && !pace.changesIn());
    // From then on one that lasts.
    Ms now(5000);
    for (int second = 0; second < 5; ++second) {
      pace.update(now += Ms(300), true, false);
      QVERIFY(!pace.isLong() && !pace.isSettled());
      pace.update(now += Ms(700), false, true);
      QVERIFY(!pace.isLong() && !pace.isSettled());
    }
    QCOMPARE(pace.changesIn(), std::optional(WorkPace::kQuiet));
    pace.update(now + WorkPace::kQuiet, false, true);
    QVERIFY(pace.isSettled() && !pace.changesIn());
  }

  void aNewSlamSessionEndsTheSteps() {
    Desk desk;
    QVERIFY(desk.found());
    desk.clickRow(0);
    desk.dock.nextButton()->click();
    auto entries = contradicting();
    entries[1].pose = geometry::poseFromYaw(0, 2.5, 0);
    desk.bench.robot->list(entries, "session-b");
    QTRY_COMPARE(desk.shown(), (Shown{true, true, true}));
    QVERIFY(!desk.dock.allButton()->isEnabled() && desk.window.mapScene()->highlighted().empty());
    QVERIFY(desk.found());
  }

  void nothingIsLookedForUnlessItIsSeen() {
    Desk desk(contradicting(), false);
    QTRY_COMPARE(desk.window.session()->counts().shown, 3);
    ui::scene::MapScene& scene = *desk.window.mapScene();
    QCoreApplication::processEvents();
    QVERIFY(scene.layerBounds(Layer::Coverage).empty());
    scene.setLayerVisible(Layer::Coverage, true);
    QTRY_COMPARE(scene.layerBounds(Layer::Disagreement), (geometry::WorldRect{-5, -1, 0, 0}));
    QVERIFY(!scene.layerBounds(Layer::Coverage).empty());
  }

  void theBoxShowsTheLayer() {
    Desk desk;
    ui::scene::MapScene& scene = *desk.window.mapScene();
    QVERIFY(!scene.layerVisible(Layer::Disagreement) && !desk.dock.layerBox()->isChecked());
    desk.dock.layerBox()->click();
    QVERIFY(scene.layerVisible(Layer::Disagreement));
    scene.setLayerVisible(Layer::Disagreement, false);
    QVERIFY(!desk.dock.layerBox()->isChecked());
  }

  void theToleranceIsChosenAndKept() {
    // The wall of 0-1 is 10 cm beside that of 0-0, and they overlap.
    Desk desk({entry(0, 0, 1, 0, 0), entry(0, 1, 1, 0, 0.1)});
    QTRY_COMPARE(desk.window.session()->counts().shown, 2);
    QTRY_COMPARE(desk.said(), QStringLiteral("No submaps contradict each other here."));
    QComboBox* const box = desk.dock.toleranceBox();
    QVERIFY(box->toolTip().contains(QStringLiteral("20 cm")));
    box->setCurrentIndex(0);
    Q_EMIT box->activated(0);
    QTRY_VERIFY(desk.dock.model()->rowCount() > 0);
    desk.window.close();
    QVERIFY(desk.bench.open({1366, 1000}).isVisible());
    QCOMPARE(part<DisagreementDock>(*desk.bench.window)->tolerance(), 0);
  }
};

}  // namespace test_window_disagreement

MAPWRIGHT_TEST(test_window_disagreement, TestWindowDisagreement, Widgets)
#include "test_window_disagreement.moc"
