// Specks go, gaps in walls close, the edge of free ground becomes smooth.
#include <QtTest>

#include "cells.h"
#include "picture/tidy.h"
#include "test_program.h"

namespace test_picture_tidying {

using namespace mapwright;
using namespace mapwright::picture;
using test::byteOf;
using test::gridOf;
using test::pyramidOf;
using test::textOf;
using Text = std::vector<std::string>;

namespace {

template <typename Tidy>
Text after(EditedGrid& grid, Tidy tidy) {
  Canvas canvas(grid);
  tidy(canvas);
  grid.apply(canvas.take());
  return textOf(grid);
}

}  // namespace

class TestPictureTidying : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void specksBecomeWhatIsAroundThem() {
    EditedGrid grid = gridOf({"#......   ",  //
                              "....##....",  //
                              "....#... #",  //
                              "###.......",  //
                              "###....   ",  //
                              "###.... # "});
    Tidied tidied;
    QCOMPARE(after(grid, [&](Canvas& c) { tidied = removeSpecks(c, c.all(), 3); }),
             (Text{".......   ",  //
                   "..........",  //
                   "........ .",  //
                   "###.......",  //
                   "###....   ",  //
                   "###....   "}));
    QCOMPARE(tidied.pieces, 4);
    QCOMPARE(tidied.cells, 6);
  }

  void whatIsLargerStays() {
    const Text text{"#####", ".....", "....."};
    EditedGrid grid = gridOf(text);
    QCOMPARE(after(grid, [](Canvas& c) { removeSpecks(c, c.all(), 4); }), text);
    QCOMPARE(after(grid, [](Canvas& c) { removeSpecks(c, c.all(), 5); }), Text(3, "....."));
  }

  void onlyTheRectangleIsTidied() {
    EditedGrid grid = gridOf({"#...#", ".....", "#...#"});
    QCOMPARE(after(grid,
                   [](Canvas& c) {
                     removeSpecks(c, {0, 0, 3, 3}, 2);
                   }),
             (Text{"....#", ".....", "....#"}));
  }

  void blocksLeaveNoSeams() {
    // Pieces of two cells on the seams between blocks, and a wall across them.
    const auto map = [](int x, int y) {
      const bool speck = y == 100 && (x == 2'047 || x == 2'048);
      const bool wall = y == 200;
      return byteOf(speck || wall ? '#' : '.');
    };
    EditedGrid grid(pyramidOf(2'300, 300, map));
    Canvas canvas(grid);
    const Tidied tidied = removeSpecks(canvas, canvas.all(), 500);
    grid.apply(canvas.take());
    QCOMPARE(tidied.pieces, 1);
    QCOMPARE(tidied.cells, 2);
    QCOMPARE(int(grid.at(2'047, 100)), int(byteOf('.')));
    QCOMPARE(int(grid.at(2'048, 200)), int(byteOf('#')));
  }

  void gapsInWallsClose() {
    EditedGrid grid = gridOf({".........", "##..###..", "........#", "........."});
    const Text closed = after(grid, [](Canvas& c) { closeGaps(c, c.all(), 2); });
    QCOMPARE(closed[0], std::string("........."));
    QCOMPARE(closed[1].substr(0, 7), std::string("#######"));
    QCOMPARE(closed[3], std::string("........."));
    EditedGrid wide = gridOf({".........", "##...####", "........."});
    QCOMPARE(after(wide, [](Canvas& c) { closeGaps(c, c.all(), 2); }), textOf(wide));
  }

  void standingWallsCloseToo() {
    EditedGrid grid = gridOf({".#.", ".#.", "...", ".#.", ".#."});
    QCOMPARE(after(grid, [](Canvas& c) { closeGaps(c, c.all(), 1); }), Text(5, ".#."));
  }

  void theEdgeOfThePictureIsNoWall() {
    const Text text{".#...", "#....", ".....", "...#."};
    EditedGrid grid = gridOf(text);
    QCOMPARE(after(grid, [](Canvas& c) { closeGaps(c, {0, 2, 5, 4}, 3); }), text);
    QCOMPARE(after(grid, [](Canvas& c) { closeGaps(c, {4, 0, 5, 4}, 1); }), text);
  }

  void theEdgeOfFreeGroundBecomesSmoothAndWallsStay() {
    EditedGrid grid = gridOf({"            ",  //
                              "      .     ",  //
                              " .......... ",  //
                              " .......... ",  //
                              " .......... ",  //
                              " ......#### ",  //
                              " .......... ",  //
                              "            "});
    QCOMPARE(after(grid, [](Canvas& c) { smoothFree(c, c.all(), 1); }),
             (Text{"            ",  //
                   "            ",  //
                   " .......... ",  //
                   " .......... ",  //
                   " .......... ",  //
                   " ......#### ",  //
                   " .......... ",  //
                   "            "}));
  }

  void whatIsCancelledChangesNothing() {
    EditedGrid grid = gridOf({"#....", "....."});
    const std::atomic<bool> cancelled{true};
    QCOMPARE(after(grid, [&](Canvas& c) { removeSpecks(c, c.all(), 5, &cancelled); }),
             (Text{"#....", "....."}));
  }
};

}  // namespace test_picture_tidying

MAPWRIGHT_TEST(test_picture_tidying, TestPictureTidying, Core)
#include "test_picture_tidying.moc"
