// Counting what is changed, and putting my changes and theirs together.
#include <QtTest>

#include "cells.h"
#include "picture/draw.h"
#include "picture/merge.h"
#include "test_program.h"

namespace test_picture_merge {

using namespace mapwright;
using namespace mapwright::picture;
using test::byteOf;
using test::gridOf;
using test::pyramidOf;
using test::textOf;
using Text = std::vector<std::string>;

namespace {

Patch painted(EditedGrid& grid, const CellRect& rect, char letter) {
  Canvas canvas(grid);
  drawRectangle(canvas, rect, {byteOf(letter), {}});
  Patch patch = canvas.take();
  grid.apply(patch);
  return patch;
}

}  // namespace

class TestPictureMerge : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatPatchesHoldTogetherIsCountedOnce() {
    EditedGrid grid(pyramidOf(256, 256, [](int, int) { return byteOf('.'); }));
    const Patch first = painted(grid, {10, 10, 20, 20}, '#'), second = painted(grid, {30, 30, 40, 40}, '#');
    PatchMemory memory;
    memory.add(first);
    const std::size_t one = memory.bytes();
    QVERIFY(one >= 65'536);
    memory.add(second);
    QCOMPARE(memory.bytes(), 2 * one);  // what the first left is what the second found
    memory.remove(first);
    QCOMPARE(memory.bytes(), 2 * one);
    memory.remove(second);
    QCOMPARE(memory.bytes(), std::size_t(0));
  }

  void countsMayBeReckonedElsewhereAndSet() {
    EditedGrid grid(pyramidOf(600, 600, [](int, int) { return byteOf('.'); }));
    const auto saved = grid.snapshot();
    const auto elsewhere = grid.snapshot();
    const Patch patch = painted(*elsewhere, {250, 250, 260, 260}, '#');
    DifferenceCount count;
    QCOMPARE(count.of(patch).size(), std::size_t(4));
    const auto before = count.of(patch), after = DifferenceCount::counted(*elsewhere, *saved, patch);
    grid.apply(patch);
    count.set(after);
    QCOMPARE(count.cells, 100);
    count.set(before);
    QCOMPARE(count.cells, 0);
    QVERIFY(count.tiles.empty());
  }

  void changedCellsAreCountedAsTheyComeAndGo() {
    EditedGrid grid(pyramidOf(600, 600, [](int, int) { return byteOf('.'); }));
    const auto saved = grid.snapshot();
    DifferenceCount count;
    const Patch first = painted(grid, {250, 250, 260, 260}, '#');
    count.recount(grid, *saved, first);
    QCOMPARE(count.cells, 100);
    const Patch second = painted(grid, {255, 250, 265, 260}, ' ');
    count.recount(grid, *saved, second);
    QCOMPARE(count.cells, 150);
    count.recount(grid, *saved, painted(grid, {250, 250, 265, 260}, '.'));
    QCOMPARE(count.cells, 0);
    QVERIFY(count.tiles.empty());
  }

  void theDifferenceMakesOneOfTheOther() {
    EditedGrid grid(pyramidOf(613, 301, test::speckled));
    const auto other = pyramidOf(
        613, 301, [](int x, int y) { return y == 300 && x > 500 ? byteOf('#') : test::speckled(x, y); });
    const Patch patch = differenceTo(grid, *other);
    QVERIFY(patch.cells.top == 300 && patch.cells.left > 500);
    grid.apply(patch);
    QVERIFY(textOf(grid) == textOf(*other));
    QVERIFY(differenceTo(grid, *other).empty());
  }

  void whatDoesNotMeetIsPutTogether() {
    EditedGrid mine = gridOf({".....", "....."});
    const auto base = mine.snapshot();
    painted(mine, {0, 0, 2, 1}, '#');
    const Patch theirs = differenceTo(*base, *test::pyramidOf({".....", ".. #."}));
    const Merge merge = mergeCells(mine, theirs, *base);
    QVERIFY(merge.conflicts.tiles.empty());
    QCOMPARE(merge.taken, 2);
    mine.apply(merge.patch);
    QCOMPARE(textOf(mine), (Text{"##...", ".. #."}));
  }

  void theSameChangeTwiceIsNoConflict() {
    EditedGrid mine = gridOf({"....."});
    const auto base = mine.snapshot();
    painted(mine, {1, 0, 3, 1}, '#');
    const Merge merge = mergeCells(mine, differenceTo(*base, *test::pyramidOf({".##.."})), *base);
    QVERIFY(merge.conflicts.tiles.empty());
    QVERIFY(merge.patch.empty());
  }

  void whatMeetsIsToldAndDecidedEitherWay() {
    EditedGrid mine = gridOf({"....."});
    const auto base = mine.snapshot();
    painted(mine, {1, 0, 3, 1}, '#');
    const Patch theirs = differenceTo(*base, *test::pyramidOf({".. .#"}));
    const auto saved = base->snapshot();
    saved->apply(theirs);
    const Merge merge = mergeCells(mine, theirs, *base);
    mine.apply(merge.patch);
    QCOMPARE(textOf(mine), (Text{".##.#"}));
    const auto [cells, where] = merge.conflicts.differing(mine, *saved);
    QCOMPARE(cells, 1);
    QCOMPARE(where, (CellRect{2, 0, 3, 1}));
    mine.apply(copied(mine, *saved, merge.conflicts));
    QCOMPARE(textOf(mine), (Text{".# .#"}));
    QCOMPARE(merge.conflicts.differing(mine, *saved).first, 0);
  }
};

}  // namespace test_picture_merge

MAPWRIGHT_TEST(test_picture_merge, TestPictureMerge, Core)
#include "test_picture_merge.moc"
