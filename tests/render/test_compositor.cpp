// The composition against an independent double-precision reference, and against pixels worked out by hand.
#include <cmath>

#include <QtTest>

#include "reference.h"
#include "render/compositor.h"

using namespace mapwright;
using render::Composition;
using render::DenseCache;
using render::Kernel;
using render::PixelGrid;
using render::Quality;
using testing::Content;
using testing::PlainTexture;

namespace {

constexpr double kPi = 3.14159265358979323846;

// Textures of one resolution scattered around a point, at any angle.
std::vector<PlainTexture> scattered(int count, Content content, const Eigen::Vector2d& around,
                                    std::mt19937& random, double resolution_m = 0.05) {
  std::uniform_real_distribution<double> offset(-1.5, 1.5), angle(-kPi, kPi);
  std::vector<PlainTexture> textures;
  for (int i = 0; i < count; ++i) {
    const int width = 30 + int(random() % 90), height = 30 + int(random() % 90);
    // The middle of the texture comes to lie near `around`.
    const double yaw = angle(random);
    const geometry::Pose2 turn{0, 0, yaw};
    const Eigen::Vector2d middle = turn.apply({-height * resolution_m / 2, -width * resolution_m / 2});
    const geometry::Pose2 pose{around.x() + offset(random) - middle.x(),
                               around.y() + offset(random) - middle.y(), yaw};
    textures.push_back(testing::plainTexture(width, height, resolution_m,
                                             testing::randomCells(width, height, content, random), pose, i,
                                             std::uint8_t((random() % 8) << 1)));
  }
  return textures;
}

PixelGrid gridAround(const Eigen::Vector2d& centre, double scale, double rotation, int width, int height) {
  PixelGrid grid;
  grid.scale_m_per_px = scale;
  grid.rotation_rad = rotation;
  grid.width_px = width;
  grid.height_px = height;
  grid.origin_m = centre - grid.worldFromPixel(width / 2.0, height / 2.0);
  return grid;
}

struct Difference {
  double worst = 0, mean = 0;
  int flags = 0, observed = 0;
};

Difference differenceOf(const Composition& actual, const std::vector<testing::ReferencePixel>& expected) {
  Difference d;
  int counted = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i].intensity_certain) {
      const double off = std::abs(actual.intensity[i] - expected[i].intensity);
      d.worst = std::max(d.worst, off);
      d.mean += off;
      ++counted;
    }
    if (expected[i].flags_certain && expected[i].intensity_certain && actual.flags[i] != expected[i].flags)
      ++d.flags;
    if (actual.flags[i] != 0) ++d.observed;
  }
  d.mean /= std::max(1, counted);
  return d;
}

Composition composeAll(const PixelGrid& grid, const std::vector<PlainTexture>& textures,
                       Quality quality = Quality::Exact, Kernel kernel = Kernel::Best) {
  DenseCache cache;
  const auto placed = testing::placedOf(textures);
  return render::compose(grid, placed, quality, cache, kernel);
}

// A texture with one bright and one dark cell on unknown ground, 1 m cells, pose at the origin.
PlainTexture twoCells(geometry::Pose2 pose = {}) {
  std::vector<raster::CellPair> cells(std::size_t(4) * 3);
  cells[1 * 4 + 2] = {100, 0};  // column 2, row 1
  cells[2 * 4 + 0] = {0, 100};  // column 0, row 2
  return testing::plainTexture(4, 3, 1.0, cells, pose);
}

int pixelAt(const Composition& picture, int column, int row) {
  return picture.intensity[std::size_t(row) * std::size_t(picture.width_px) + std::size_t(column)];
}
int flagsAt(const Composition& picture, int column, int row) {
  return picture.flags[std::size_t(row) * std::size_t(picture.width_px) + std::size_t(column)];
}

PlainTexture uniformTexture(raster::CellPair cell, int index = 0, std::uint8_t flags = 0,
                            double resolution_m = 1.0) {
  return testing::plainTexture(20, 20, resolution_m, std::vector<raster::CellPair>(400, cell),
                               {10 * resolution_m, 10 * resolution_m, 0}, index, flags);
}

}  // namespace

class TestCompositor : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void agreesWithTheReference_data();
  void agreesWithTheReference();
  void kernelsGiveTheSameBytes_data() { agreesWithTheReference_data(); }
  void kernelsGiveTheSameBytes();
  void cutsGiveTheSameBytes();
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
  void finerTexturesAreSampledFinely();
  void previewResemblesTheExactPicture();
  void survivesAbsurdNumbers_data();
  void survivesAbsurdNumbers();
  void farFromTheOriginStaysExact();
  void emptyInputsGiveUnknown();
  void cancellingGivesNothing();
  void boundsHoldEverythingDrawn();
  void cacheKeepsItsBudgetAndKnowsTexturesApart();
};

void TestCompositor::agreesWithTheReference_data() {
  QTest::addColumn<int>("content");
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("tolerance");
  const std::pair<const char*, Content> contents[] = {
      {"folded", Content::Folding}, {"pairs", Content::Pairs}, {"saturating", Content::Saturating}};
  for (const auto& [name, content] : contents) {
    for (const double scale : {0.004, 0.0124, 0.0126, 0.03, 0.05, 0.051, 0.07, 0.1, 0.13, 0.31, 0.8, 1.63}) {
      QTest::addRow("%s at %g", name, scale) << int(content) << scale << 0.75;
    }
  }
}

void TestCompositor::agreesWithTheReference() {
  QFETCH(int, content);
  QFETCH(double, scale);
  QFETCH(double, tolerance);
  std::mt19937 random(1234);
  for (int round = 0; round < 3; ++round) {
    const Eigen::Vector2d centre(round * 17.3, -round * 5.1);
    const auto textures = scattered(5, Content(content), centre, random);
    const int edge = scale > 0.2 ? 21 : 75;
    const PixelGrid grid = gridAround(centre, scale, round * 0.7, edge + 6, edge);
    const Difference d =
        differenceOf(composeAll(grid, textures), testing::referenceComposition(grid, textures));
    QVERIFY2(d.worst <= tolerance, qPrintable(QStringLiteral("off by %1").arg(d.worst)));
    QVERIFY2(d.mean <= 0.3, qPrintable(QStringLiteral("off by %1 on average").arg(d.mean)));
    QCOMPARE(d.flags, 0);
    QVERIFY(d.observed > 5);
  }
}

void TestCompositor::kernelsGiveTheSameBytes() {
  if (!render::kernelAvailable(Kernel::Avx2)) QSKIP("this processor has no AVX2");
  QFETCH(int, content);
  QFETCH(double, scale);
  std::mt19937 random(99);
  for (int round = 0; round < 6; ++round) {
    const auto textures = scattered(6, Content(content), {0, 0}, random);
    const PixelGrid grid = gridAround({0, 0}, scale, round * 0.37, 203, 187);
    const Composition portable = composeAll(grid, textures, Quality::Exact, Kernel::Portable);
    const Composition avx2 = composeAll(grid, textures, Quality::Exact, Kernel::Avx2);
    QVERIFY(portable.intensity == avx2.intensity);
    QVERIFY(portable.flags == avx2.flags);
  }
}

void TestCompositor::cutsGiveTheSameBytes() {
  std::mt19937 random(5);
  for (const double scale : {0.01, 0.05, 0.12, 0.9, 5.0}) {
    auto textures = scattered(6, Content::Folding, {0, 0}, random);
    const auto finer = scattered(2, Content::Pairs, {0.5, 0.5}, random, 0.021);
    textures.insert(textures.end(), finer.begin(), finer.end());
    PixelGrid whole = gridAround({0, 0}, scale, 0.4, 130, 110);
    whole.first_column = -41;
    whole.first_row = 1000 * 1000;
    whole.origin_m -= whole.worldFromPixel(65, 55);
    const Composition picture = composeAll(whole, textures);
    QVERIFY(std::count(picture.flags.begin(), picture.flags.end(), 0) < std::ptrdiff_t(picture.flags.size()));
    for (int cut = 0; cut < 12; ++cut) {
      PixelGrid part = whole;
      const int x = int(random() % 100), y = int(random() % 80);
      part.first_column += x;
      part.first_row += y;
      part.width_px = 1 + int(random() % unsigned(130 - x));
      part.height_px = 1 + int(random() % unsigned(110 - y));
      const Composition piece = composeAll(part, textures);
      for (int row = 0; row < part.height_px; ++row) {
        for (int column = 0; column < part.width_px; ++column) {
          QCOMPARE(pixelAt(piece, column, row), pixelAt(picture, x + column, y + row));
          QCOMPARE(flagsAt(piece, column, row), flagsAt(picture, x + column, y + row));
        }
      }
    }
  }
}

void TestCompositor::columnsRunAlongMinusYAndRowsAlongMinusX() {
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

void TestCompositor::aTurnedTextureTurnsAboutItsOrigin() {
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

void TestCompositor::addingLightSaturates() {
  const PixelGrid grid = gridAround({0, 0}, 1.0, 0.3, 5, 5);
  const std::vector<PlainTexture> textures{uniformTexture({200, 10}, 0), uniformTexture({200, 10}, 1)};
  const Composition picture = composeAll(grid, textures);
  for (const auto intensity : picture.intensity) QCOMPARE(int(intensity), 255);
  // Saturation happens per layer: a dark layer on top starts from 255, not from what the sum would have been.
  const Composition dimmed = composeAll(
      grid, {uniformTexture({200, 0}, 0), uniformTexture({200, 0}, 1), uniformTexture({0, 51}, 2)});
  for (const auto intensity : dimmed.intensity) QCOMPARE(int(intensity), 204);
}

void TestCompositor::valueWithoutAlphaAddsUp() {
  const PixelGrid grid = gridAround({0, 0}, 1.0, 0, 4, 4);
  const Composition picture = composeAll(grid, {uniformTexture({30, 0}, 0), uniformTexture({41, 0}, 1)});
  for (const auto intensity : picture.intensity) QCOMPARE(int(intensity), 128 + 30 + 41);
}

void TestCompositor::paintsInTheOrderGiven() {
  const PixelGrid grid = gridAround({0, 0}, 1.0, 0, 4, 4);
  const PlainTexture light = uniformTexture({100, 0}, 0), dark = uniformTexture({0, 127}, 1);
  QCOMPARE(pixelAt(composeAll(grid, {light, dark}), 1, 1), 114);  // (128 + 100) * 128 / 255 = 114.4
  QCOMPARE(pixelAt(composeAll(grid, {dark, light}), 1, 1), 164);  // 128 * 128 / 255 + 100 = 164.3
}

void TestCompositor::bordersFadeToUnknown() {
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

void TestCompositor::magnifiedCellsAreSquare() {
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

void TestCompositor::bilinearUpToFourPixelsPerCell() {
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

void TestCompositor::thinWallIsAveragedByArea_data() {
  QTest::addColumn<int>("k");
  for (const int k : {2, 3, 4, 5, 8, 10, 16, 40, 64, 100, 200}) QTest::addRow("%d x %d", k, k) << k;
}

void TestCompositor::thinWallIsAveragedByArea() {
  QFETCH(int, k);
  // 400 x 400 cells of 1 m: bright ground, one column of darkest cells. Unturned and aligned, a pixel of k x
  // k cells that the wall crosses has exactly k dark cells.
  std::vector<raster::CellPair> cells(400 * 400, raster::CellPair{100, 0});
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

void TestCompositor::hugePixelsAverageEverythingInThem() {
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

void TestCompositor::topmostObservedTextureGivesTheFlags() {
  std::vector<raster::CellPair> holed(400, raster::CellPair{50, 0});
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

void TestCompositor::reducedPixelsUniteFlags() {
  const PlainTexture left = testing::plainTexture(10, 10, 1.0, std::vector<raster::CellPair>(100, {10, 0}),
                                                  {0, 5, 0}, 0, render::kIncremental);
  const PlainTexture right = testing::plainTexture(10, 10, 1.0, std::vector<raster::CellPair>(100, {10, 0}),
                                                   {10, 5, 0}, 1, render::kNearby);
  const PixelGrid grid = gridAround({0, 0}, 8.0, 0, 1, 1);
  const Composition picture = composeAll(grid, {left, right});
  QCOMPARE(flagsAt(picture, 0, 0), int(render::kObserved | render::kIncremental | render::kNearby));
}

void TestCompositor::finerTexturesAreSampledFinely() {
  // A coarse floor with a fine, thin wall on it: 1 of 8 fine columns is dark. The pixel is as large as a
  // coarse cell.
  std::vector<raster::CellPair> cells(64 * 64);
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

void TestCompositor::previewResemblesTheExactPicture() {
  std::mt19937 random(8);
  const auto textures = scattered(6, Content::Folding, {0, 0}, random);
  for (const double scale : {0.05, 0.2, 0.4}) {
    const PixelGrid grid = gridAround({0, 0}, scale, 0.2, 60, 60);
    const Composition exact = composeAll(grid, textures);
    const Composition preview = composeAll(grid, textures, Quality::Preview);
    double difference = 0;
    int observed_differs = 0;
    for (std::size_t i = 0; i < exact.intensity.size(); ++i) {
      difference += std::abs(int(exact.intensity[i]) - int(preview.intensity[i]));
      observed_differs += (exact.flags[i] == 0) != (preview.flags[i] == 0);
    }
    QVERIFY(difference / double(exact.intensity.size()) < 12);
    QVERIFY(observed_differs < int(exact.intensity.size()) / 8);
    if (scale == 0.05) QVERIFY(exact.intensity == preview.intensity);
  }
}

void TestCompositor::survivesAbsurdNumbers_data() {
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("resolution");
  for (const double scale : {1e-300, 1e-4, 0.05, 1e5, 1e300}) {
    for (const double x : {0.0, 1e6, 1e18, 1e300}) {
      for (const double resolution : {1e-300, 1e-6, 0.05, 100.0}) {
        QTest::addRow("scale %g at %g, cells of %g", scale, x, resolution) << scale << x << resolution;
      }
    }
  }
}

void TestCompositor::survivesAbsurdNumbers() {
  QFETCH(double, scale);
  QFETCH(double, x);
  QFETCH(double, resolution);
  std::vector<PlainTexture> textures;
  textures.push_back(testing::plainTexture(1, 1, resolution, {{50, 0}}, {x, -x, 1e6}, 0));
  textures.push_back(
      testing::plainTexture(3, 70, resolution, std::vector<raster::CellPair>(210, {0, 255}), {x, 0, 0.5}));
  textures.push_back(
      testing::plainTexture(9, 9, 0.05, std::vector<raster::CellPair>(81, {0, 100}), {-x, 0, 0.5}));
  textures.push_back(textures.back());
  textures.back().placed.world_from_texture.yaw_rad = std::nan("");
  textures.back().placed.texture.reset();
  for (const Quality quality : {Quality::Exact, Quality::Preview}) {
    for (const double at : {x, 0.0}) {
      const PixelGrid grid = gridAround({at, 0}, scale, 1.0, 33, 5);
      const Composition picture = composeAll(grid, textures, quality);
      QVERIFY(picture.width_px == 33 || picture.width_px == 0);
      QCOMPARE(picture.intensity.size(), std::size_t(picture.width_px) * std::size_t(picture.height_px));
    }
  }
}

void TestCompositor::farFromTheOriginStaysExact() {
  // A map a million metres from the origin, seen from there: the same picture as at home but for the
  // precision of doubles.
  std::mt19937 random(3), again(3);
  const auto home = scattered(4, Content::Folding, {0, 0}, random);
  const Eigen::Vector2d far(1 << 20, -(1 << 20));
  const auto away = scattered(4, Content::Folding, far, again);
  const Composition here = composeAll(gridAround({0, 0}, 0.04, 0.3, 90, 90), home);
  const Composition there = composeAll(gridAround(far, 0.04, 0.3, 90, 90), away);
  int worst = 0;
  for (std::size_t i = 0; i < here.intensity.size(); ++i) {
    worst = std::max(worst, std::abs(int(here.intensity[i]) - int(there.intensity[i])));
  }
  QVERIFY(worst <= 1);
}

void TestCompositor::emptyInputsGiveUnknown() {
  const Composition picture = composeAll(gridAround({0, 0}, 1, 0, 3, 2), {});
  QCOMPARE(picture.width_px, 3);
  QCOMPARE(picture.intensity, std::vector<std::uint8_t>(6, 128));
  QCOMPARE(picture.flags, std::vector<std::uint8_t>(6, 0));
  QCOMPARE(composeAll(gridAround({0, 0}, 1, 0, 0, 5), {}).width_px, 0);
}

void TestCompositor::cancellingGivesNothing() {
  DenseCache cache;
  const auto placed = testing::placedOf({uniformTexture({100, 0})});
  const PixelGrid grid = gridAround({0, 0}, 0.1, 0, 100, 100);
  std::atomic<bool> cancelled{true};
  QCOMPARE(render::compose(grid, placed, Quality::Exact, cache, Kernel::Best, &cancelled).width_px, 0);
  cancelled = false;
  QCOMPARE(render::compose(grid, placed, Quality::Exact, cache, Kernel::Best, &cancelled).width_px, 100);
}

void TestCompositor::boundsHoldEverythingDrawn() {
  std::mt19937 random(17);
  for (const PlainTexture& texture : scattered(10, Content::Saturating, {3, 4}, random)) {
    const PixelGrid grid = gridAround({3, 4}, 0.05, 0.1, 300, 300);
    const Composition picture = composeAll(grid, {texture});
    const geometry::WorldRect bounds = render::boundsOf(texture.placed);
    for (int row = 0; row < 300; ++row) {
      for (int column = 0; column < 300; ++column) {
        if (flagsAt(picture, column, row) == 0) continue;
        QVERIFY(bounds.contains(grid.worldFromPixel(column + 0.5, row + 0.5)));
      }
    }
  }
}

void TestCompositor::cacheKeepsItsBudgetAndKnowsTexturesApart() {
  DenseCache cache(20'000);
  const PlainTexture first = uniformTexture({1, 0}), second = uniformTexture({2, 0});
  const auto cells = cache.get(first.placed.texture, 0);
  QCOMPARE(cache.get(first.placed.texture, 0).get(), cells.get());
  QVERIFY(cache.get(second.placed.texture, 0).get() != cells.get());
  QVERIFY(cache.bytes() >= 2 * cells->bytes());
  std::vector<PlainTexture> many;
  for (int i = 0; i < 100; ++i) {
    many.push_back(uniformTexture({std::uint8_t(i + 1), 0}));
    const auto dense = cache.get(many.back().placed.texture, 0);
    QCOMPARE(int(dense->taps[std::size_t((2 * dense->level.stride + 2) * 2)]), i + 1);
    QVERIFY(cache.bytes() <= 20'000);
  }
  cache.clear();
  QCOMPARE(cache.bytes(), std::size_t(0));
  QCOMPARE(cells->level.width, 20);  // still alive in our hands
}

QTEST_GUILESS_MAIN(TestCompositor)
#include "test_compositor.moc"
