// A large picture while it is edited: what is reckoned beside the window, what waits for it, and what is
// forgotten.
#include <algorithm>
#include <cstring>
#include <random>

#include <QSignalSpy>
#include <QtTest>

#include "edit/picture/picture_editing.h"
#include "grids/grid_pyramid.h"
#include "test_program.h"

namespace test_picture_editing {

using namespace mapwright;
using namespace mapwright::edit;
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

  edit::PictureEditing editing{std::make_shared<work::Workers>()};
};

/// What is to come of it, reckoned in the simplest way: every state that can be gone back to, and what is
/// kept.
struct Model {
  static constexpr int kWidth = 600, kHeight = 400;
  using Cells = std::vector<std::uint8_t>;
  std::vector<Cells> states{Cells(std::size_t(kWidth) * kHeight, kFree)};
  std::size_t now = 0;
  Cells saved = states.front();
  std::vector<bool> met = std::vector<bool>(saved.size());

  static void paint(Cells& cells, const CellRect& rect, int byte) {
    for (int y = rect.top; y < rect.bottom; ++y) {
      for (int x = rect.left; x < rect.right; ++x)
        cells[std::size_t(y) * kWidth + std::size_t(x)] = std::uint8_t(byte);
    }
  }
  void paint(const CellRect& rect, int byte) {
    Cells next = states[now];
    paint(next, rect, byte);
    if (next == states[now]) return;
    states.resize(++now);
    states.push_back(std::move(next));
  }
  /// Where a state has what was kept, it has what is kept now.
  void mergeTheirs(const Cells& theirs) {
    // By pointers: a test is compiled without optimising, and these are most of its steps.
    const std::uint8_t *const kept = saved.data(), *const coming = theirs.data(), *mine = states[now].data();
    for (std::size_t at = 0; at < saved.size(); ++at) {
      if (mine[at] != kept[at] && coming[at] != kept[at] && coming[at] != mine[at]) met[at] = true;
    }
    for (Cells& state : states) {
      std::uint8_t* const cells = state.data();
      for (std::size_t at = 0; at < saved.size(); ++at) {
        if (cells[at] == kept[at]) cells[at] = coming[at];
      }
    }
    saved = theirs;
  }
  void decide(bool take_theirs) {
    Cells next = states[now];
    for (std::size_t at = 0; at < saved.size(); ++at) {
      if (take_theirs && met[at]) next[at] = saved[at];
    }
    met.assign(saved.size(), false);
    if (next == states[now]) return;
    states.resize(++now);
    states.push_back(std::move(next));
  }
  int differing(bool of_met) const {
    int count = 0;
    for (std::size_t at = 0; at < saved.size(); ++at)
      count += states[now][at] != saved[at] && (!of_met || met[at]) ? 1 : 0;
    return count;
  }
  static std::shared_ptr<const grids::GridPyramid> pyramidOf(const Cells& cells) {
    const auto builder =
        grids::buildGrid(kWidth, kHeight, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
    for (int y = 0; y < kHeight; ++y)
      builder->pushRow(std::span(cells).subspan(std::size_t(y) * kWidth, kWidth));
    builder->finish();
    return builder->pyramid();
  }
};

/// On all levels of detail.
bool looksLike(const grids::GridPyramid& grid, const Model::Cells& cells) {
  const auto wanted = Model::pyramidOf(cells);
  constexpr int kTile = grids::GridPyramid::kTileEdge;
  for (int level = 0; level < grid.levels(); ++level) {
    for (int y = 0; y * kTile < grid.levelHeight(level); ++y) {
      for (int x = 0; x * kTile < grid.levelWidth(level); ++x) {
        const auto a = grid.tile(level, x, y), b = wanted->tile(level, x, y);
        const int across = std::min(kTile, grid.levelWidth(level) - x * kTile),
                  down = std::min(kTile, grid.levelHeight(level) - y * kTile);
        for (int row = 0; row < down; ++row) {
          if (std::memcmp(a->cells.get() + row * kTile, b->cells.get() + row * kTile, std::size_t(across)) !=
              0)
            return false;
        }
      }
    }
  }
  return true;
}

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

  void undoingAndEscEndWhatIsInProgress() {
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
    QSignalSpy forgotten(&desk.editing, &edit::PictureEditing::stepsForgotten);
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
    QSignalSpy merged(&desk.editing, &edit::PictureEditing::mergeDone);
    picture::EditedGrid theirs(hall());
    picture::Canvas canvas(theirs);
    picture::drawRectangle(canvas, {50, 2000, 60, 2010}, {kOccupied, {}});
    theirs.apply(canvas.take());
    desk.fill(Kind::Unknown);
    desk.editing.mergeTheirs(theirs.snapshot(), "theirs");
    QTRY_COMPARE(merged.size(), 1);
    QVERIFY(desk.done());
    QCOMPARE(desk.cell(5, 5), kUnknown);
    QCOMPARE(desk.cell(55, 2005), kOccupied);
    QCOMPARE(desk.editing.changedCells(), std::int64_t(kEdge) * 1000);
    QCOMPARE(desk.editing.conflicts(), std::int64_t(0));
  }

  void escDoesNotDropWhatCameMeanwhile() {
    Desk desk;
    QSignalSpy merged(&desk.editing, &edit::PictureEditing::mergeDone);
    picture::EditedGrid theirs(hall());
    picture::Canvas canvas(theirs);
    picture::drawRectangle(canvas, {50, 2000, 60, 2010}, {kOccupied, {}});
    theirs.apply(canvas.take());
    desk.fill(Kind::Unknown);
    desk.editing.mergeTheirs(theirs.snapshot(), "theirs");
    desk.editing.stop();
    QTRY_COMPARE(merged.size(), 1);
    QCOMPARE(desk.cell(55, 2005), kOccupied);
    QVERIFY(!desk.editing.unsaved());
  }

  void whatIsPaintedHereAndElsewhereIsAllThere_data() {
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 8; ++seed) QTest::addRow("seed %u", seed) << seed;
  }

  /// Strokes, undoing, redoing, saving and deciding at random, while somebody else paints all the time:
  /// before and in the middle of a stroke, and just after it.
  void whatIsPaintedHereAndElsewhereIsAllThere() {
    QFETCH(unsigned, seed);
    std::mt19937 random(seed);
    const auto upTo = [&random](int most) { return int(random() % unsigned(most)); };
    Model model;
    edit::PictureEditing editing(std::make_shared<work::Workers>());
    map::GridReference place;
    place.width = Model::kWidth;
    place.height = Model::kHeight;
    place.resolution_m = 1;
    editing.open(Model::pyramidOf(model.saved), place, true);
    editing.setAcross(1);
    const auto at = [](int column, int row) {
      return Eigen::Vector2d(column + 0.5, Model::kHeight - row - 0.5);
    };
    const auto somewhere = [&] {
      const int left = 200 + upTo(120), top = 200 + upTo(120);  // where four tiles meet
      return CellRect{left, top, left + 1 + upTo(60), top + 1 + upTo(12)};
    };
    std::vector<Model::Cells> coming;
    const auto othersPaint = [&] {
      Model::Cells theirs = coming.empty() ? model.saved : coming.back();
      Model::paint(theirs, somewhere(), std::array{kFree, kOccupied, kUnknown}[std::size_t(upTo(3))]);
      editing.mergeTheirs(Model::pyramidOf(theirs), "theirs");
      coming.push_back(std::move(theirs));
    };
    for (int step = 0; step < 60; ++step) {
      if (upTo(3) == 0) othersPaint();
      const int what = upTo(10);
      if (what < 5) {
        const Kind kind = upTo(2) ? Kind::Occupied : Kind::Unknown;
        const CellRect stroke = somewhere();
        editing.setKind(kind);
        editing.beginStroke(false);
        editing.strokeTo(at(stroke.left, stroke.top));
        editing.strokeTo(at((stroke.left + stroke.right) / 2, stroke.top));
        if (upTo(2)) othersPaint();
        if (upTo(2)) QTest::qWait(2);  // it comes while the hand is down, or later
        QVERIFY(editing.stroking());
        editing.strokeTo(at(stroke.right - 1, stroke.top));
        editing.endStroke();
        model.paint({stroke.left, stroke.top, stroke.right, stroke.top + 1},
                    kind == Kind::Occupied ? kOccupied : kUnknown);
      } else if (what < 7) {
        editing.undoStack().undo();
        if (model.now > 0) --model.now;
      } else if (what < 8) {
        editing.undoStack().redo();
        if (model.now + 1 < model.states.size()) ++model.now;
      }
      if (!coming.empty()) QVERIFY(QTest::qWaitFor([&] { return !editing.merging(); }, 30'000));
      for (const Model::Cells& theirs : std::exchange(coming, {})) model.mergeTheirs(theirs);
      QCOMPARE(int(editing.changedCells()), model.differing(false));
      QCOMPARE(int(editing.conflicts()), model.differing(true));
      if (what == 8) {
        const bool take_theirs = upTo(2);
        if (editing.conflicts() > 0) {
          editing.decide(take_theirs);
          model.decide(take_theirs);
        }
        QCOMPARE(int(editing.conflicts()), 0);
        editing.markSaved(editing.snapshot());
        model.saved = model.states[model.now];
        model.met.assign(model.saved.size(), false);
      }
      QCOMPARE(editing.undoStack().index(), int(model.now));
      QVERIFY(looksLike(*editing.grid(), model.states[model.now]));
    }
    while (editing.undoStack().canUndo()) editing.undoStack().undo();
    QVERIFY(looksLike(*editing.grid(), model.states.front()));
    while (editing.undoStack().canRedo()) editing.undoStack().redo();
    QVERIFY(looksLike(*editing.grid(), model.states.back()));
  }

  void whatWouldBeTidiedUpStaysToBeLookedAt() {
    Desk desk;
    QSignalSpy merged(&desk.editing, &edit::PictureEditing::mergeDone);
    desk.editing.setKind(Kind::Occupied);
    desk.editing.drawRectangle({30, 30, 31, 31});
    desk.editing.drawRectangle({60, 60, 61, 61});
    desk.editing.lookFor(edit::Tidying::Specks, 4);
    QTRY_VERIFY(desk.editing.preview());
    QCOMPARE(desk.editing.preview()->found.cells, std::int64_t(2));
    picture::EditedGrid theirs(hall());
    picture::Canvas canvas(theirs);
    picture::drawRectangle(canvas, {40, 40, 50, 50}, {kOccupied, {}});
    theirs.apply(canvas.take());
    desk.editing.mergeTheirs(theirs.snapshot(), "theirs");
    QTRY_COMPARE(merged.size(), 1);
    QVERIFY(desk.editing.preview());
    QCOMPARE(int(desk.editing.preview()->cells->at(45, 45)), kOccupied);
    QCOMPARE(int(desk.editing.preview()->cells->at(30, 30)), kFree);
    desk.editing.applyPreview();
    QCOMPARE(desk.cell(30, 30), kFree);
    QCOMPARE(desk.cell(45, 45), kOccupied);
    QCOMPARE(desk.editing.changedCells(), std::int64_t(0));
    desk.editing.undoStack().undo();
    QCOMPARE(desk.cell(60, 60), kOccupied);
    QCOMPARE(desk.editing.changedCells(), std::int64_t(2));
  }
};

}  // namespace test_picture_editing

MAPWRIGHT_TEST(test_picture_editing, TestPictureEditing, Widgets)
#include "test_picture_editing.moc"
