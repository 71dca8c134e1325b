// Changes over a whole map: copied by the tile, right at every level of detail, undone by exchanging tiles.
#include <QtTest>

#include "cells.h"
#include "picture/canvas.h"
#include "picture/draw.h"
#include "picture/merge.h"
#include "test_program.h"

namespace test_edited_grid {

using namespace mapwright;
using namespace mapwright::picture;
using test::byteOf;
using test::pyramidOf;

namespace {

constexpr int kEdge = grids::GridPyramid::kTileEdge;

/// Every tile of every level is what a pyramid has that is made of the same cells anew.
bool likeNew(const grids::GridPyramid& grid) {
  const auto anew = pyramidOf(
      grid.width(), grid.height(), [&](int x, int y) { return grid.at(x, y); }, grid.code());
  for (int level = 0; level < grid.levels(); ++level) {
    for (int y = 0; y * kEdge < grid.levelHeight(level); ++y) {
      for (int x = 0; x * kEdge < grid.levelWidth(level); ++x) {
        const auto one = grid.tile(level, x, y), other = anew->tile(level, x, y);
        if (!one || !other || std::memcmp(one->cells.get(), other->cells.get(), kEdge * kEdge) != 0)
          return false;
        if (one->uniform && !std::all_of(one->cells.get(), one->cells.get() + kEdge * kEdge,
                                         [&](std::uint8_t cell) { return cell == *one->cells; }))
          return false;
      }
    }
  }
  return true;
}

Patch painted(EditedGrid& grid, const CellRect& rect, char letter) {
  Canvas canvas(grid);
  drawRectangle(canvas, rect, {byteOf(letter), {}});
  Patch patch = canvas.take();
  grid.apply(patch);
  return patch;
}

}  // namespace

class TestEditedGrid : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void looksLikeWhatItWasMadeOf() {
    const auto base = pyramidOf(700, 530, test::speckled);
    const EditedGrid grid(base);
    QCOMPARE(grid.width(), 700);
    QCOMPARE(grid.levels(), base->levels());
    QVERIFY(grid.complete());
    QCOMPARE(grid.tile(0, 1, 1)->cells, base->tile(0, 1, 1)->cells);
    QVERIFY(!grid.tile(0, 9, 9));
  }

  void everyLevelOfDetailFollowsAChange() {
    EditedGrid grid(pyramidOf(701, 533, test::speckled));
    // Across tiles, at odd places, at the odd last row and column, one cell, all.
    for (const CellRect& rect :
         {CellRect{250, 250, 263, 259}, CellRect{699, 531, 701, 533}, CellRect{13, 517, 14, 518},
          CellRect{511, 0, 513, 533}, CellRect{0, 0, 701, 533}}) {
      for (const char letter : {' ', '#', '.'}) {
        painted(grid, rect, letter);
        QVERIFY(likeNew(grid));
      }
    }
    QVERIFY(grid.tile(0, 0, 0)->uniform);
    QVERIFY(!grid.tile(0, 2, 2)->uniform);  // beyond the edge is unknown
  }

  void averagesFollowToo() {
    const auto builder = grids::buildGrid(300, 300, grids::CellCode::Gray, grids::Reduction::Average);
    const std::vector<std::uint8_t> row(300, 255);
    for (int y = 0; y < 300; ++y) builder->pushRow(row);
    builder->finish();
    EditedGrid grid(builder->pyramid());
    Canvas canvas(grid);
    drawRectangle(canvas, {0, 0, 1, 2}, {0, {}});
    grid.apply(canvas.take());
    // 128 would read as unknown: the nearest gray that does not.
    QCOMPARE(int(grid.tile(1, 0, 0)->cells.get()[0]), 144);
  }

  void marksThatAreLeftOutAreTold() {
    EditedGrid grid(pyramidOf(300, 300, test::speckled));
    Canvas canvas(grid);
    drawRectangle(canvas, {0, 0, 100, 100}, {byteOf('#'), {}});
    const Patch patch = canvas.take();
    const Changes whole = changesOf(grid, patch, 100'000), some = changesOf(grid, patch, 10);
    QVERIFY(whole.all && whole.runs.size() > 10);
    QVERIFY(!some.all);
    QCOMPARE(some.runs.size(), std::size_t(10));
    QCOMPARE(some.become, whole.become);
    QVERIFY(changesOf(grid, patch, whole.runs.size()).all);
  }

  void undoingAndRedoingGiveTheSameTiles() {
    EditedGrid grid(pyramidOf(600, 600, test::speckled));
    const auto before = grid.tile(0, 1, 1)->cells;
    const Patch first = painted(grid, {200, 200, 300, 300}, '#');
    const auto between = grid.tile(0, 1, 1)->cells;
    const Patch second = painted(grid, {250, 250, 400, 400}, ' ');
    const auto after = grid.tile(0, 1, 1)->cells;
    grid.revert(second);
    QCOMPARE(grid.tile(0, 1, 1)->cells, between);
    QVERIFY(likeNew(grid));
    grid.revert(first);
    QCOMPARE(grid.tile(0, 1, 1)->cells, before);
    QCOMPARE(grid.bytes(), grid.base()->bytes());
    grid.apply(first);
    grid.apply(second);
    QCOMPARE(grid.tile(0, 1, 1)->cells, after);
    QVERIFY(likeNew(grid));
  }

  void aChangeHoldsOnlyWhatItTouches() {
    EditedGrid grid(pyramidOf(2'000, 2'000, [](int, int) { return byteOf('.'); }));
    const Patch patch = painted(grid, {10, 10, 12, 12}, '#');
    QCOMPARE(patch.cells, (CellRect{10, 10, 12, 12}));
    QCOMPARE(int(patch.tiles.size()), grid.levels());
    QVERIFY(patch.bytes() <= std::size_t(grid.levels()) * kEdge * kEdge);
    QVERIFY(painted(grid, {10, 10, 12, 12}, '#').empty());  // it is so already
  }

  void severalChangesBecomeOne() {
    EditedGrid grid(pyramidOf(600, 600, test::speckled));
    const auto before = test::textOf(grid);
    Patch all = painted(grid, {0, 0, 20, 20}, '#');
    all.append(painted(grid, {10, 10, 300, 30}, ' '));
    const auto after = test::textOf(grid);
    grid.revert(all);
    QCOMPARE(test::textOf(grid), before);
    grid.apply(all);
    QCOMPARE(test::textOf(grid), after);
    QCOMPARE(all.cells, (CellRect{0, 0, 300, 30}));
  }

  void whatWasHandedOutStays() {
    EditedGrid grid(pyramidOf(300, 300, test::speckled));
    const auto snapshot = grid.snapshot();
    const auto text = test::textOf(*snapshot);
    const auto tile = grid.tile(0, 0, 0);
    const std::vector<std::uint8_t> cells(tile->cells.get(), tile->cells.get() + kEdge * kEdge);
    painted(grid, {0, 0, 300, 300}, '#');
    QCOMPARE(test::textOf(*snapshot), text);
    QVERIFY(std::equal(cells.begin(), cells.end(), tile->cells.get()));
    QVERIFY(test::textOf(grid) != text);
  }
};

}  // namespace test_edited_grid

MAPWRIGHT_TEST(test_edited_grid, TestEditedGrid, Core)
#include "test_edited_grid.moc"
