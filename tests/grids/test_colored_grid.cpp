// Small pictures in colours keep their colours, and their obstacles when zoomed out.
#include <QtTest>

#include "grids/grid_pyramid.h"
#include "picture_samples.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_colored_grid {

using namespace mapwright;
using namespace mapwright::grids;
using test::PngRecipe;
using test::Samples;

namespace {

std::uint32_t colourAt(const ColoredGrid& grid, int level, int x, int y) {
  const auto tile = grid.indices->tile(level, x / 256, y / 256);
  return grid.palette.at(tile->cells.get()[(y % 256) * 256 + x % 256]);
}

}  // namespace

class TestColoredGrid : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void upTo256ColoursAreExact() {
    Samples samples;
    std::vector<std::uint32_t> expected;
    for (std::uint32_t n = 0; n < 256; ++n) {
      const std::uint32_t colour = (n % 16 * 16 + 15) << 24 | (test::noise(n) & 0xffffff);
      expected.push_back(colour);
      for (const int shift : {16, 8, 0, 24}) samples.push_back(std::uint16_t(colour >> shift & 0xff));
    }
    const auto grid = decodeColors(test::shared(test::png(PngRecipe{16, 16, 8, 6}, samples)), 1000);
    QVERIFY(grid);
    for (int n = 0; n < 256; ++n) QCOMPARE(colourAt(*grid, 0, n % 16, n / 16), expected[std::size_t(n)]);
  }

  void palettesAreKept() {
    PngRecipe recipe{3, 1, 2, 3};
    recipe.palette = std::string("\x01\x02\x03\xff\x00\x00\x00\x00\xff", 9);
    recipe.transparency = std::string("\xff\x80", 2);
    const auto grid = decodeColors(test::shared(test::png(recipe, {2, 1, 0})), 3);
    QVERIFY(grid);
    QCOMPARE(colourAt(*grid, 0, 0, 0), 0xff0000ffu);
    QCOMPARE(colourAt(*grid, 0, 1, 0), 0x80ff0000u);
    QCOMPARE(colourAt(*grid, 0, 2, 0), 0xff010203u);
  }

  void itsOrderIsThatOfItsColoursAndNotOfItsIndices() {
    // Clear, light and dark come in an order that says nothing; whoever reduces it further has to know.
    PngRecipe recipe{3, 1, 2, 3};
    recipe.palette = std::string("\xff\xe0\xe0\x80\x00\x00\x00\x00\x00", 9);
    recipe.transparency = std::string("\xff\xff\x00", 3);
    for (const Samples& samples : {Samples{0, 1, 2}, Samples{1, 2, 0}, Samples{2, 0, 1}}) {
      const auto grid = decodeColors(test::shared(test::png(recipe, samples)), 3);
      QVERIFY(grid);
      std::array<int, 3> rank{};
      for (int x = 0; x < 3; ++x) {
        rank[samples[std::size_t(x)]] = grid->indices->order()[grid->indices->at(x, 0)];
      }
      QVERIFY(rank[1] > rank[0] && rank[0] > rank[2]);
    }
  }

  void moreColoursAreNear() {
    Samples samples;
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x) {
        for (const int sample : {x * 2, y * 2, (x + y) % 256, x < 5 ? 0 : 255})
          samples.push_back(std::uint16_t(sample));
      }
    }
    const auto grid = decodeColors(test::shared(test::png(PngRecipe{100, 100, 8, 6}, samples)), 10'000);
    QVERIFY(grid);
    QVERIFY(grid->palette.size() <= 256);
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x) {
        const std::uint32_t colour = colourAt(*grid, 0, x, y);
        if (x < 5) {
          QCOMPARE(colour, 0u);
          continue;
        }
        QCOMPARE(colour >> 24, 255u);
        for (const auto& [shift, sample] : {std::pair{16, x * 2}, {8, y * 2}, {0, (x + y) % 256}}) {
          QVERIFY(std::abs(int(colour >> shift & 0xff) - sample) <= 40);
        }
      }
    }
  }

  void grayPicturesHaveNoPalette() {
    const auto grid = decodeColors(test::shared(test::png(PngRecipe{4, 1, 4, 0}, {0, 5, 10, 15})), 4);
    QVERIFY(grid);
    QVERIFY(grid->palette.empty());
    for (int x = 0; x < 4; ++x) QCOMPARE(int(grid->indices->at(x, 0)), x * 85);
  }

  void grayOf16BitsHasNoPaletteEither() {
    const auto grid = decodeColors(test::shared(test::png(PngRecipe{3, 1, 16, 0}, {0, 0x8080, 65535})), 3);
    QVERIFY(grid && grid->palette.empty());
    QCOMPARE(int(grid->indices->at(1, 0)), 128);
    QCOMPARE(int(grid->indices->at(2, 0)), 255);
  }

  void anObstacleSurvivesEveryLevel() {
    constexpr int kSize = 1100;
    Samples samples;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const bool obstacle = x == 777, inflated = std::abs(x - 777) < 4;
        const int colour[4] = {obstacle ? 120 : 255, obstacle ? 0 : 200, 0, obstacle || inflated ? 255 : 0};
        for (const int sample : colour) samples.push_back(std::uint16_t(sample));
      }
    }
    const auto grid =
        decodeColors(test::shared(test::png(PngRecipe{kSize, kSize, 8, 6}, samples)), kSize * kSize);
    QVERIFY(grid);
    QVERIFY(grid->indices->levels() > 2);
    for (int level = 0; level < grid->indices->levels(); ++level) {
      QCOMPARE(colourAt(*grid, level, 777 >> level, 500 >> level), 0xff780000u);
      QCOMPARE(colourAt(*grid, level, 0, 0), 0u);
    }
  }

  void costsThatComeAsOccupancyStayWhatTheyAre() {
    std::string pgm = "P5\n51 2\n255\n";
    for (int cost = 0; cost <= 100; ++cost) pgm.push_back(char(cost));
    pgm.push_back(char(255));
    const map::CellReading raw{map::CellReading::Mode::Raw, false, 0.65, 0.196};
    const auto grid = decodeOccupancy(test::shared(pgm), raw, 102);
    QVERIFY(grid && grid->palette.empty());
    QCOMPARE(grid->indices->code(), CellCode::Occupancy);
    for (int n = 0; n < 102; ++n) QCOMPARE(int(grid->indices->at(n % 51, n / 51)), n <= 100 ? n : 255);
    QVERIFY(grid->indices->order()[100] > grid->indices->order()[99]);
    QVERIFY(!decodeOccupancy(test::shared(pgm), raw, 101));
    QVERIFY(!decodeOccupancy(test::shared(pgm.substr(0, 40)), raw, 102));
    QVERIFY(!decodeOccupancy(test::shared("nonsense"), raw, 102));
    QVERIFY(!decodeOccupancy(nullptr, raw, 102));
  }

  void theHighestCostSurvivesEveryLevel() {
    constexpr std::size_t kSize = 1100;
    std::string pgm = "P5\n1100 1100\n255\n" + std::string(kSize * kSize, '\x00');
    for (std::size_t row = 0; row < kSize; ++row) pgm[pgm.size() - (row + 1) * kSize + 777] = char(99);
    pgm[pgm.size() - 500 * kSize + 777] = char(100);
    const auto grid = decodeOccupancy(test::shared(pgm), {map::CellReading::Mode::Raw, false, 0.65, 0.196},
                                      std::int64_t(kSize * kSize));
    QVERIFY(grid);
    for (int level = 0; level < grid->indices->levels(); ++level) {
      const auto byteAt = [&](int x, int y) {
        const auto tile = grid->indices->tile(level, (x >> level) / 256, (y >> level) / 256);
        return int(tile->cells.get()[((y >> level) % 256) * 256 + (x >> level) % 256]);
      };
      QCOMPARE(byteAt(777, 600), 100);
      QCOMPARE(byteAt(777, 10), 99);
      QCOMPARE(byteAt(0, 0), 0);
    }
  }

  void whatIsTooLargeOrBrokenIsASentence() {
    const std::string bytes = test::png(PngRecipe{40, 40}, test::roomGrays(40, 40));
    const auto large = decodeColors(test::shared(bytes), 1599);
    QVERIFY(!large);
    QCOMPARE(sentences::wordsOf(large.error()),
             QStringLiteral("It is 40 x 40 pixels, but at most 1,599 can be read."));
    QVERIFY(decodeColors(test::shared(bytes), 1600));
    QVERIFY(!decodeColors(test::shared(bytes.substr(0, bytes.size() / 2)), 1600));
    QVERIFY(!decodeColors(test::shared("nonsense"), 1600));
    QVERIFY(!decodeColors(nullptr, 1600));
  }
};

}  // namespace test_colored_grid

MAPWRIGHT_TEST(test_colored_grid, TestColoredGrid, Core)
#include "test_colored_grid.moc"
