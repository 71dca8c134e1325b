// The rules of composition, pixel by pixel, with values worked out by hand.
#include <cmath>

#include <QtTest>

#include "reference.h"
#include "render/compositor.h"
#include "test_program.h"

namespace test_composition_rules {

using namespace mapwright;
using render::Composition;
using render::PixelGrid;
using testing::composeAll;
using testing::flagsAt;
using testing::gridAround;
using testing::pixelAt;
using testing::PlainTexture;
using testing::uniformTexture;

namespace {

constexpr double kPi = 3.14159265358979323846;

// A texture with one bright and one dark cell on unknown ground, 1 m cells, pose at the origin.
PlainTexture twoCells(geometry::Pose2 pose = {}) {
  std::vector<cells::CellPair> cells(std::size_t(4) * 3);
  cells[1 * 4 + 2] = {100, 0};  // column 2, row 1
  cells[2 * 4 + 0] = {0, 100};  // column 0, row 2
  return testing::plainTexture(4, 3, 1.0, cells, pose);
}

}  // namespace

class TestCompositionRules : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void columnsRunAlongMinusYAndRowsAlongMinusX();
  void aTurnedTextureTurnsAboutItsOrigin();
  void addingLightSaturates();
  void valueWithoutAlphaAddsUp();
  void paintsInTheOrderGiven();
  void bordersFadeToUnknown();
  void magnifiedCellsAreSquare();
  void bilinearUpToFourPixelsPerCell();
  void thinWallIsAveragedByArea_data();
  void thinWallIsAveragedByArea();
  void hugePixelsAverageEverythingInThem();
  void topmostObservedTextureGivesTheFlags();
  void reducedPixelsUniteFlags();
  void reducedPixelsHaveTheClassesOfTheLatest();
  void finerTexturesAreSampledFinely();
};

void TestCompositionRules::columnsRunAlongMinusYAndRowsAlongMinusX() {
  // Column 2, row 1 has its centre at world (-1.5, -2.5); column 0, row 2 at (-2.5, -0.5). One pixel a metre,
  // pixel centres on cell centres: pixel (0,0) has its corner at (-4, 1), so world (x, y) is pixel (x + 4, 1
  // - y).
  PixelGrid grid;
  grid.origin_m = {-4, 1};
  grid.scale_m_per_px = 1;
  grid.width_px = 6;
  grid.height_px = 6;
  const Composition picture = composeAll(grid, {twoCells()});
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      const bool bright = column == 2 && row == 3, dark = column == 1 && row == 1;
      QCOMPARE(pixelAt(picture, column, row), bright ? 228 : dark ? 78 : 128);  // 128 * 155 / 255 = 77.8
      QCOMPARE(flagsAt(picture, column, row), bright || dark ? int(render::kObserved) : 0);
    }
  }
}

void TestCompositionRules::aTurnedTextureTurnsAboutItsOrigin() {
  // A quarter turn to the left about (10, 20): the bright cell's centre (-1.5, -2.5) goes to (10 + 2.5, 20
  // - 1.5).
  PixelGrid grid;
  grid.origin_m = {9, 22};
  grid.scale_m_per_px = 1;
  grid.width_px = 6;
  grid.height_px = 6;
  const Composition picture = composeAll(grid, {twoCells({10, 20, kPi / 2})});
  QCOMPARE(pixelAt(picture, 3, 3), 228);
  QCOMPARE(pixelAt(picture, 1, 4), 78);  // (-2.5, -0.5) goes to (10.5, 17.5)
  QCOMPARE(int(std::count(picture.flags.begin(), picture.flags.end(), 0)), 34);
}

void TestCompositionRules::addingLightSaturates() {
  const PixelGrid grid = gridAround({0, 0}, 1.0, 0.3, 5, 5);
  const std::vector<PlainTexture> textures{uniformTexture({200, 10}, 0), uniformTexture({200, 10}, 1)};
  const Composition picture = composeAll(grid, textures);
  QCOMPARE(picture.intensity.size(), std::size_t(25));
  for (const auto intensity : picture.intensity) QCOMPARE(int(intensity), 255);
  // Saturation happens per layer: a dark layer on top starts from 255, not from what the sum would have been.
  const Composition dimmed = composeAll(
      grid, {uniformTexture({200, 0}, 0), uniformTexture({200, 0}, 1), uniformTexture({0, 51}, 2)});
  QCOMPARE(dimmed.intensity.size(), std::size_t(25));
  for (const auto intensity : dimmed.intensity) QCOMPARE(int(intensity), 204);
}

void TestCompositionRules::valueWithoutAlphaAddsUp() {
  const PixelGrid grid = gridAround({0, 0}, 1.0, 0, 4, 4);
  const Composition picture = composeAll(grid, {uniformTexture({30, 0}, 0), uniformTexture({41, 0}, 1)});
  QCOMPARE(picture.intensity.size(), std::size_t(16));
  for (const auto intensity : picture.intensity) QCOMPARE(int(intensity), 128 + 30 + 41);
}

void TestCompositionRules::paintsInTheOrderGiven() {
  const PixelGrid grid = gridAround({0, 0}, 1.0, 0, 4, 4);
  const PlainTexture light = uniformTexture({100, 0}, 0), dark = uniformTexture({0, 127}, 1);
  QCOMPARE(pixelAt(composeAll(grid, {light, dark}), 1, 1), 114);  // (128 + 100) * 128 / 255 = 114.4
  QCOMPARE(pixelAt(composeAll(grid, {dark, light}), 1, 1), 164);  // 128 * 128 / 255 + 100 = 164.3
}

void TestCompositionRules::bordersFadeToUnknown() {
  // Cells of 1 m, pixels of 0.5 m: across the edge of the texture the weights are 0.75, 0.25, then nothing.
  PixelGrid grid;
  grid.origin_m = {9, 1};  // the texture's edge is at x = 10: pixels 0, 1 inside, 2, 3 outside
  grid.scale_m_per_px = 0.5;
  grid.width_px = 6;
  grid.height_px = 1;
  const Composition picture = composeAll(grid, {uniformTexture({100, 0})});
  QCOMPARE(pixelAt(picture, 0, 0), 228);
  QCOMPARE(pixelAt(picture, 1, 0), 128 + 75);
  QCOMPARE(pixelAt(picture, 2, 0), 128 + 25);
  QCOMPARE(pixelAt(picture, 3, 0), 128);
  QCOMPARE(flagsAt(picture, 2, 0), int(render::kObserved));
  QCOMPARE(flagsAt(picture, 3, 0), 0);
}

void TestCompositionRules::magnifiedCellsAreSquare() {
  // 8 pixels a cell: every pixel is one of the cells themselves.
  PixelGrid grid;
  grid.origin_m = {0, 0};
  grid.scale_m_per_px = 0.125;
  grid.width_px = 8 * 6;
  grid.height_px = 8 * 6;
  grid.first_column = -8 * 4;
  const Composition picture = composeAll(grid, {twoCells()});
  for (int row = 0; row < grid.height_px; ++row) {
    for (int column = 0; column < grid.width_px; ++column) {
      // World x of the pixel is (column - 32 + 0.5) / 8, world y is -(row + 0.5) / 8.
      const bool bright = column / 8 == 2 && row / 8 == 2, dark = column / 8 == 1 && row / 8 == 0;
      QCOMPARE(pixelAt(picture, column, row), bright ? 228 : dark ? 78 : 128);
    }
  }
}

void TestCompositionRules::bilinearUpToFourPixelsPerCell() {
  const auto levels = [](double scale) {
    PixelGrid grid = gridAround({-1.5, -2.5}, scale, 0, 40, 1);
    const Composition picture = composeAll(grid, {twoCells()});
    std::vector<std::uint8_t> seen = picture.intensity;
    std::sort(seen.begin(), seen.end());
    return std::unique(seen.begin(), seen.end()) - seen.begin();
  };
  QVERIFY(levels(0.26) > 4);
  QCOMPARE(int(levels(0.24)), 2);
}

void TestCompositionRules::thinWallIsAveragedByArea_data() {
  QTest::addColumn<int>("k");
  for (const int k : {2, 3, 4, 5, 8, 10, 16, 40, 64, 100, 200}) QTest::addRow("%d x %d", k, k) << k;
}

void TestCompositionRules::thinWallIsAveragedByArea() {
  QFETCH(int, k);
  // 400 x 400 cells of 1 m: bright ground, one column of darkest cells. Unturned and aligned, a pixel of k x
  // k cells that the wall crosses has exactly k dark cells.
  std::vector<cells::CellPair> cells(400 * 400, cells::CellPair{100, 0});
  for (std::size_t row = 0; row < 400; ++row) cells[row * 400 + 200] = {0, 127};
  const PlainTexture wall = testing::plainTexture(400, 400, 1.0, cells, {400, 400, 0});
  PixelGrid grid;
  grid.origin_m = {0, 400};
  grid.scale_m_per_px = k;
  grid.width_px = 400 / k;
  grid.height_px = 400 / k;
  const Composition picture = composeAll(grid, {wall});
  const double dark = 128.0 * 128 / 255, bright = 228;
  // Columns run along -y from world y = 400: the wall lies in the row of pixels that holds column 200.
  const int wall_row = 200 / k;
  for (int row = 0; row < grid.height_px; ++row) {
    const int expected = int(std::lround(row == wall_row ? ((k - 1) * bright + dark) / k : bright));
    // k above 64 may be sampled more finely than the cells, which smears the wall a little over the pixel's
    // edge.
    const int tolerance = k > 64 ? 1 : 0;
    QVERIFY(std::abs(pixelAt(picture, grid.width_px / 2, row) - expected) <= tolerance);
  }
}

void TestCompositionRules::hugePixelsAverageEverythingInThem() {
  // One pixel of 1000 x 1000 m over 20 x 20 m of known ground: 0.04 % of it is bright, all else counts as
  // 128.
  const PlainTexture small = uniformTexture({127, 0}, 0, render::kActive, 0.05);  // 1 m x 1 m
  for (const double scale : {4.0, 20.0, 1000.0, 1e5}) {
    const PixelGrid grid = gridAround({0, 0}, scale, 0, 1, 1);
    const Composition picture = composeAll(grid, {small});
    const double expected = 128 + 127 / (scale * scale);
    QVERIFY(std::abs(pixelAt(picture, 0, 0) - expected) <= 0.6);
    QCOMPARE(flagsAt(picture, 0, 0), int(render::kObserved | render::kActive));
  }
}

void TestCompositionRules::topmostObservedTextureGivesTheFlags() {
  std::vector<cells::CellPair> holed(400, cells::CellPair{50, 0});
  for (std::size_t row = 0; row < 20; ++row) {
    for (std::size_t column = 0; column < 10; ++column) holed[row * 20 + column] = {};
  }
  const PlainTexture below = uniformTexture({0, 20}, 0, render::kIncremental);
  const PlainTexture above = testing::plainTexture(20, 20, 1.0, holed, {10, 10, 0}, 1, render::kActive);
  const PixelGrid grid = gridAround({0, 0}, 1.0, 0, 20, 20);
  const Composition picture = composeAll(grid, {below, above});
  // The texture's columns 0..9 are world y 10..0: the upper half, where only the lower texture is seen.
  QCOMPARE(flagsAt(picture, 5, 3), int(render::kObserved | render::kIncremental));
  QCOMPARE(flagsAt(picture, 5, 15), int(render::kObserved | render::kActive));
}

void TestCompositionRules::reducedPixelsUniteFlags() {
  const PlainTexture left = testing::plainTexture(10, 10, 1.0, std::vector<cells::CellPair>(100, {10, 0}),
                                                  {0, 5, 0}, 0, render::kIncremental);
  const PlainTexture right = testing::plainTexture(10, 10, 1.0, std::vector<cells::CellPair>(100, {10, 0}),
                                                   {10, 5, 0}, 1, render::kNearby);
  const PixelGrid grid = gridAround({0, 0}, 8.0, 0, 1, 1);
  const Composition picture = composeAll(grid, {left, right});
  QCOMPARE(flagsAt(picture, 0, 0), int(render::kObserved | render::kIncremental | render::kNearby));
}

void TestCompositionRules::reducedPixelsHaveTheClassesOfTheLatest() {
  const auto half = [](double x, int index, const render::PixelClasses& classes) {
    return testing::plainTexture(10, 10, 1.0, std::vector<cells::CellPair>(100, {10, 0}), {x, 5, 0}, index,
                                 std::uint16_t(render::flagsOf(classes) | render::kActive));
  };
  const render::PixelClasses earlier{1, 7, 8}, later{2, 0, 3};
  for (const double scale : {1.0, 8.0, 300.0}) {
    const PixelGrid grid = gridAround({0, 0}, scale, 0, 1, 1);
    const int expected = render::kObserved | render::kActive | render::flagsOf(later);
    QCOMPARE(flagsAt(composeAll(grid, {half(0, 0, earlier), half(10, 1, later)}), 0, 0), expected);
    QCOMPARE(flagsAt(composeAll(grid, {half(10, 0, earlier), half(0, 1, later)}), 0, 0), expected);
  }
}

void TestCompositionRules::finerTexturesAreSampledFinely() {
  // A coarse floor with a fine, thin wall on it: 1 of 8 fine columns is dark. The pixel is as large as a
  // coarse cell.
  std::vector<cells::CellPair> cells(64 * 64);
  for (std::size_t row = 0; row < 64; ++row) {
    for (std::size_t column = 4; column < 64; column += 8) cells[row * 64 + column] = {0, 127};
  }
  const PlainTexture floor = uniformTexture({100, 0}, 0);
  const PlainTexture fine = testing::plainTexture(64, 64, 0.125, cells, {4, 4, 0}, 1);
  PixelGrid grid;
  grid.origin_m = {-2, 2};
  grid.width_px = grid.height_px = 4;
  grid.scale_m_per_px = 1.0;
  const Composition picture = composeAll(grid, {floor, fine});
  const int expected = int(std::lround((7 * 228 + 228.0 * 128 / 255) / 8));
  for (const auto intensity : picture.intensity) QCOMPARE(int(intensity), expected);
}

}  // namespace test_composition_rules

MAPWRIGHT_TEST(test_composition_rules, TestCompositionRules, Core)
#include "test_composition_rules.moc"
