// A large picture while it is edited: what is reckoned beside the window, what waits for it, and what is
// forgotten.
#include <QSignalSpy>
#include <QtTest>

#include "grids/grid_pyramid.h"
#include "window/picture/picture_editing.h"

using namespace mapwright;
using namespace mapwright::window;
using picture::CellRect;
using picture::Kind;

namespace {

constexpr int kEdge = 3'000;  // more cells than are changed at once
constexpr int kFree = 0, kOccupied = 100, kUnknown = 255;

/// Free, with a wall all across in row 1000.
std::shared_ptr<const grids::GridPyramid> hall() {
  const auto builder =
      grids::buildGrid(kEdge, kEdge, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
  const std::vector<std::uint8_t> free(kEdge, kFree), wall(kEdge, kOccupied);
  for (int y = 0; y < kEdge; ++y) builder->pushRow(y == 1000 ? wall : free);
  builder->finish();
  return builder->pyramid();
}

struct Desk {
  Desk() {
    map::GridReference place;
    place.width = place.height = kEdge;
    place.resolution_m = 1;
    editing.open(hall(), place, true);
    editing.setAcross(1);
  }
  int cell(int column, int row) const { return int(editing.grid()->at(column, row)); }
  static Eigen::Vector2d at(int column, int row) { return {column + 0.5, kEdge - row - 0.5}; }
  void fill(Kind kind) {
    editing.setKind(kind);
    editing.fill(at(5, 5));
  }
  bool done() {
    return QTest::qWaitFor([this] { return !editing.reckoning(); }, 30'000);
  }

  PictureEditing editing{std::make_shared<work::Workers>()};
};

}  // namespace

class TestPictureEditing : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void fillingIsReckonedBesideTheWindow() {
    Desk desk;
    desk.fill(Kind::Unknown);
    QVERIFY(desk.editing.reckoning());
    QCOMPARE(desk.cell(5, 5), kFree);
    QVERIFY(desk.done());
    QCOMPARE(desk.cell(5, 5), kUnknown);
    QCOMPARE(desk.cell(5, 1001), kFree);  // beyond the wall
    QCOMPARE(desk.editing.changedCells(), std::int64_t(kEdge) * 1000);
    desk.editing.undoStack().undo();
    QCOMPARE(desk.cell(5, 5), kFree);
    QVERIFY(!desk.editing.unsaved());
    desk.editing.undoStack().redo();
    QCOMPARE(desk.editing.changedCells(), std::int64_t(kEdge) * 1000);
  }

  void whatIsDrawnMeanwhileComesAfterIt() {
    Desk desk;
    desk.fill(Kind::Unknown);
    desk.editing.setKind(Kind::Occupied);
    desk.editing.beginStroke(false);
    QVERIFY(desk.editing.stroking());
    desk.editing.strokeTo(Desk::at(100, 100));
    desk.editing.strokeTo(Desk::at(110, 100));
    QCOMPARE(desk.cell(105, 100), kFree);
    QVERIFY(desk.done());
    QCOMPARE(desk.cell(105, 100), kOccupied);  // the hand is still down
    QVERIFY(desk.editing.stroking());
    desk.editing.strokeTo(Desk::at(120, 100));
    desk.editing.endStroke();
    QCOMPARE(desk.cell(115, 100), kOccupied);
    QCOMPARE(desk.cell(115, 101), kUnknown);
    QCOMPARE(desk.editing.undoStack().count(), 2);
    QCOMPARE(desk.editing.changedCells(), std::int64_t(kEdge) * 1000);
  }

  void aStrokeThatEndedMeanwhileIsWhole() {
    Desk desk;
    desk.fill(Kind::Unknown);
    desk.editing.setKind(Kind::Occupied);
    desk.editing.beginStroke(false);
    desk.editing.strokeTo(Desk::at(100, 100));
    desk.editing.endStroke();
    QVERIFY(!desk.editing.stroking());
    desk.editing.drawRectangle({200, 200, 210, 210});
    desk.fill(Kind::Free);
    QTRY_VERIFY(!desk.editing.reckoning() && desk.editing.undoStack().count() == 4);
    QCOMPARE(desk.cell(100, 100), kOccupied);
    QCOMPARE(desk.cell(205, 205), kOccupied);
    QCOMPARE(desk.cell(5, 5), kFree);
    QCOMPARE(desk.editing.changedCells(), std::int64_t(101));
  }

  void undoingAndEscEndWhatIsUnderWay() {
    Desk desk;
    desk.editing.setKind(Kind::Occupied);
    desk.editing.drawRectangle({0, 0, 10, 10});
    desk.fill(Kind::Unknown);
    desk.editing.drawRectangle({200, 200, 210, 210});
    desk.editing.undoStack().undo();
    QVERIFY(!desk.editing.reckoning());
    QVERIFY(!desk.editing.unsaved());
    desk.fill(Kind::Unknown);
    desk.editing.stop();
    QVERIFY(!desk.editing.reckoning());
    // Whatever still comes of it comes to nothing.
    desk.editing.setKind(Kind::Occupied);
    desk.editing.fill(Desk::at(5, 1500));
    QVERIFY(desk.done());
    QCOMPARE(desk.cell(5, 5), kFree);
    QCOMPARE(desk.cell(5, 1500), kOccupied);
  }

  void discardingVeryMuchCanBeUndone() {
    Desk desk;
    desk.fill(Kind::Unknown);
    QVERIFY(desk.done());
    desk.editing.revert();
    QVERIFY(desk.done());
    QVERIFY(!desk.editing.unsaved());
    QCOMPARE(desk.cell(5, 5), kFree);
    desk.editing.undoStack().undo();
    QCOMPARE(desk.editing.changedCells(), std::int64_t(kEdge) * 1000);
  }

  void theOldestStepsAreForgottenAndThatIsSaid() {
    Desk desk;
    constexpr std::size_t kBudget = std::size_t(2) << 20;
    desk.editing.setUndoBudget(kBudget);
    QSignalSpy forgotten(&desk.editing, &PictureEditing::stepsForgotten);
    desk.editing.setKind(Kind::Occupied);
    for (int i = 0; i < 40; ++i) desk.editing.drawRectangle({i, 40 * i + 1, i + 1, 40 * i + 2});
    QVERIFY(!forgotten.isEmpty());
    QVERIFY(desk.editing.undoBytes() <= kBudget);
    const int left = desk.editing.undoStack().count();
    QVERIFY(left > 1 && left < 40);
    QVERIFY(desk.editing.undoStack().canUndo());
    while (desk.editing.undoStack().canUndo()) desk.editing.undoStack().undo();
    QCOMPARE(desk.editing.changedCells(), std::int64_t(40 - left));
    while (desk.editing.undoStack().canRedo()) desk.editing.undoStack().redo();
    QCOMPARE(desk.editing.changedCells(), std::int64_t(40));
  }

  void theLastStepStaysHoweverLargeItIs() {
    Desk desk;
    desk.editing.setUndoBudget(1);
    desk.fill(Kind::Unknown);
    QVERIFY(desk.done());
    QCOMPARE(desk.editing.undoStack().count(), 1);
    desk.editing.undoStack().undo();
    QVERIFY(!desk.editing.unsaved());
  }

  void theirChangesAreTakenInWhileOneIsReckoned() {
    Desk desk;
    QSignalSpy merged(&desk.editing, &PictureEditing::mergeDone);
    picture::EditedGrid theirs(hall());
    picture::Canvas canvas(theirs);
    picture::drawRectangle(canvas, {50, 2000, 60, 2010}, {kOccupied, {}});
    theirs.apply(canvas.take());
    desk.fill(Kind::Unknown);
    desk.editing.takeIn(theirs.snapshot());
    QTRY_COMPARE(merged.size(), 1);
    QVERIFY(desk.done());
    QCOMPARE(desk.cell(5, 5), kUnknown);
    QCOMPARE(desk.cell(55, 2005), kOccupied);
    QCOMPARE(desk.editing.changedCells(), std::int64_t(kEdge) * 1000);
    QCOMPARE(desk.editing.conflicts(), std::int64_t(0));
  }
};

QTEST_MAIN(TestPictureEditing)
#include "test_picture_editing.moc"
