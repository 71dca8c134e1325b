// Brush, line, rectangle, polygon, flood fill, copies: which cells they paint.
#include <limits>

#include <QtTest>

#include "cells.h"
#include "picture/draw.h"
#include "test_program.h"

namespace test_picture_drawing {

using namespace mapwright;
using namespace mapwright::picture;
using test::byteOf;
using test::gridOf;
using test::pyramidOf;
using test::textOf;
using Text = std::vector<std::string>;

namespace {

Ink ink(char letter) { return {byteOf(letter), {}}; }

template <typename Paint>
Text after(const Text& rows, Paint paint) {
  EditedGrid grid = gridOf(rows);
  Canvas canvas(grid);
  paint(canvas);
  grid.apply(canvas.take());
  return textOf(grid);
}

/// Filled cell by cell, as slowly as anybody would.
Text filledSlowly(Text rows, int x, int y, char letter) {
  const char kind = rows[std::size_t(y)][std::size_t(x)];
  std::vector<std::pair<int, int>> waiting{{x, y}};
  std::vector<std::vector<bool>> seen(rows.size(), std::vector<bool>(rows[0].size()));
  while (!waiting.empty()) {
    const auto [u, v] = waiting.back();
    waiting.pop_back();
    if (u < 0 || v < 0 || v >= int(rows.size()) || u >= int(rows[0].size())) continue;
    const std::size_t r = std::size_t(v), c = std::size_t(u);
    if (seen[r][c] || rows[r][c] != kind) continue;
    seen[r][c] = true;
    for (const auto& [du, dv] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
      waiting.emplace_back(u + du, v + dv);
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < rows[0].size(); ++c) {
      if (seen[r][c]) rows[r][c] = letter;
    }
  }
  return rows;
}

}  // namespace

class TestPictureDrawing : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aBrushOfOneCellIsOneCell() {
    const Text empty(5, ".....");
    QCOMPARE(after(empty,
                   [](Canvas& c) {
                     drawLine(c, {2.9, 1.05}, {2.9, 1.05}, {1, ink('#')});
                   }),
             (Text{".....", "..#..", ".....", ".....", "....."}));
  }

  void brushesAreRoundAndAsWideAsTheySay() {
    const Text empty(6, "......");
    QCOMPARE(after(empty,
                   [](Canvas& c) {
                     drawLine(c, {3, 3}, {3, 3}, {2, ink('#')});
                   }),
             (Text{"......", "......", "..##..", "..##..", "......", "......"}));
    QCOMPARE(after(empty,
                   [](Canvas& c) {
                     drawLine(c, {2.5, 2.5}, {2.5, 2.5}, {5, ink('#')});
                   }),
             (Text{".###..", "#####.", "#####.", "#####.", ".###..", "......"}));
  }

  void linesHaveNoHoles_data() {
    QTest::addColumn<int>("x");
    QTest::addColumn<int>("y");
    for (const auto& [x, y] : {std::pair{30, 30}, {30, 7}, {3, 30}, {30, 0}, {0, 30}, {29, 30}}) {
      QTest::addRow("%d %d", x, y) << x << y;
    }
  }
  void linesHaveNoHoles() {
    QFETCH(int, x);
    QFETCH(int, y);
    const Text drawn = after(Text(32, std::string(32, '.')), [&](Canvas& c) {
      drawLine(c, {0.5, 0.5}, {x + 0.5, y + 0.5}, {1, ink('#')});
    });
    // A cell in each row or column of the longer side, and never a step of more than one.
    int count = 0, last_u = 0, last_v = 0;
    for (int step = 0; step <= std::max(x, y); ++step) {
      bool found = false;
      for (int other = 0; other < 32; ++other) {
        const int u = x >= y ? step : other, v = x >= y ? other : step;
        if (drawn[std::size_t(v)][std::size_t(u)] != '#') continue;
        QVERIFY(found || (std::abs(u - last_u) <= 1 && std::abs(v - last_v) <= 1));
        found = true;
        ++count;
        last_u = u;
        last_v = v;
      }
      QVERIFY(found);
    }
    QCOMPARE(last_u, x);
    QCOMPARE(last_v, y);
    QVERIFY(count <= 2 * (std::max(x, y) + 1));
  }

  void whatIsBesideThePictureIsNothing() {
    const Text empty(4, "....");
    static constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(after(empty,
                   [](Canvas& c) {
                     drawLine(c, {-50, -50}, {-10, 300}, {7, ink('#')});
                     drawLine(c, {kNowhere, 0}, {1e300, kNowhere}, {7, ink('#')});
                     drawRectangle(c, {-10, -10, -1, 90}, ink('#'));
                     drawRectangle(c, {2, 2, 1, 1}, ink('#'));
                     (void)floodFill(c, 4, 0, ink('#'));
                     (void)floodFill(c, -1, 0, ink('#'));
                   }),
             empty);
    QCOMPARE(after(empty,
                   [](Canvas& c) {
                     drawRectangle(c, {-9, 3, 1'000'000, 70}, ink('#'));
                   }),
             (Text{"....", "....", "....", "####"}));
  }

  void rectanglesAndPolygonsAreFilled() {
    const Text empty(5, ".....");
    QCOMPARE(after(empty,
                   [](Canvas& c) {
                     drawRectangle(c, rectangleOf({3.2, 3.9}, {1.5, 2.1}), ink('#'));
                   }),
             (Text{".....", ".....", ".###.", ".###.", "....."}));
    const std::vector<Eigen::Vector2d> triangle{{0, 0}, {5, 0}, {0, 5}};
    QCOMPARE(after(empty, [&](Canvas& c) { drawPolygon(c, triangle, ink('#')); }),
             (Text{"#####", "####.", "###..", "##...", "#...."}));
  }

  void aStrokeIsInTheGridAtOnceAndOneChangeInTheEnd() {
    EditedGrid grid(pyramidOf(600, 600, test::speckled));
    const auto before = textOf(grid);
    Stroke stroke(grid, {9, ink('#')});
    QCOMPARE(stroke.to({250, 250}), (CellRect{246, 246, 255, 255}));
    QCOMPARE(int(grid.at(250, 250)), int(byteOf('#')));
    stroke.to({270, 270});
    stroke.to({300, 250});
    const auto after = textOf(grid);
    const Patch patch = stroke.finish();
    grid.revert(patch);
    QCOMPARE(textOf(grid), before);
    grid.apply(patch);
    QCOMPARE(textOf(grid), after);
  }

  void theEraserTakesBackToWhatWasThere() {
    const auto base = pyramidOf(300, 300, test::speckled);
    EditedGrid grid(base);
    Canvas canvas(grid);
    drawRectangle(canvas, {0, 0, 300, 300}, ink('#'));
    grid.apply(canvas.take());
    Stroke eraser(grid, {20, {0, base}});
    eraser.to({256, 256});
    eraser.to({270, 256});
    for (int x = 250; x < 275; ++x) QCOMPARE(grid.at(x, 256), base->at(x, 256));
    QCOMPARE(int(grid.at(100, 100)), int(byteOf('#')));
  }

  void aFillStopsAtOtherKinds() {
    QCOMPARE(
        after({"..#..", "..#..", "##...", ".#..."}, [](Canvas& c) { (void)floodFill(c, 4, 0, ink(' ')); }),
        (Text{"..#  ", "..#  ", "##   ", ".#   "}));
    // Corners do not join, and a fill with its own kind ends, too.
    QCOMPARE(after({".#", "#."}, [](Canvas& c) { (void)floodFill(c, 0, 0, ink('#')); }), (Text{"##", "#."}));
    QCOMPARE(after({"..", ".."}, [](Canvas& c) { (void)floodFill(c, 0, 0, ink('.')); }), (Text{"..", ".."}));
  }

  void aFillIsRightAcrossTilesAndThroughMazes() {
    for (const int part : {2, 5, 9}) {
      const auto maze = pyramidOf(613, 301, [&](int x, int y) {
        const bool wall =
            test::noise(std::uint32_t(x * 7'919 + y * 31 + part)) % 10 < std::uint32_t(part) / 2;
        const bool snake = part == 9 && y % 4 == 0 && (y % 8 == 0 ? x > 0 : x < 612);
        return byteOf((part == 9 ? snake : wall) ? '#' : '.');
      });
      EditedGrid grid(maze);
      const Text wanted = filledSlowly(textOf(grid), 300, 150, ' ');
      Canvas canvas(grid);
      QVERIFY(floodFill(canvas, 300, 150, ink(' ')));
      grid.apply(canvas.take());
      QVERIFY(textOf(grid) == wanted);
    }
  }

  void aFillThatIsStoppedChangesNothing() {
    const EditedGrid grid(pyramidOf(600, 600, [](int, int) { return byteOf('.'); }));
    Canvas canvas(grid);
    const std::atomic<bool> cancelled{true};
    QVERIFY(!floodFill(canvas, 0, 0, ink('#'), &cancelled));
    QVERIFY(canvas.take().empty());
  }

  void copiesGoElsewhere() {
    EditedGrid grid = gridOf({"#. ..", ".#...", "....."});
    Canvas canvas(grid);
    const auto clip = copyCells(canvas, {-4, 0, 3, 2});
    QVERIFY(clip);
    QCOMPARE(clip->width, 3);
    putClip(canvas, *clip, 3, 1);
    putClip(canvas, *clip, -2, 2);
    grid.apply(canvas.take());
    QCOMPARE(textOf(grid), (Text{"#. ..", ".#.#.", " ...#"}));
    QVERIFY(!copyCells(canvas, {7, 7, 9, 9}));
  }

  void aCopyOfAnotherCodeIsTranslated() {
    EditedGrid gray(pyramidOf(
        2, 1, [](int x, int) { return std::uint8_t(x == 0 ? 3 : 205); }, grids::CellCode::Gray));
    Canvas from(gray);
    const auto clip = copyCells(from, {0, 0, 2, 1});
    EditedGrid grid = gridOf({"...."});
    Canvas canvas(grid);
    putClip(canvas, *clip, 1, 0);
    grid.apply(canvas.take());
    QCOMPARE(textOf(grid), (Text{".# ."}));
  }
};

}  // namespace test_picture_drawing

MAPWRIGHT_TEST(test_picture_drawing, TestPictureDrawing, Core)
#include "test_picture_drawing.moc"
