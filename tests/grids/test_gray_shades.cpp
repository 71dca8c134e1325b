// Which grays of a bare picture mean unknown ground: its own shades tell.
#include <functional>

#include <QtTest>

#include "grids/grid_pyramid.h"
#include "picture_samples.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_gray_shades {

using namespace mapwright;
using namespace mapwright::grids;

namespace {

using Shade = std::function<int(int x, int y)>;

std::uint32_t dice(int x, int y) { return test::noise(std::uint32_t(y) * 65599u + std::uint32_t(x)); }

constexpr int kWidth = 400, kHeight = 300;

std::string pictureOf(const Shade& shade, test::PngRecipe recipe = {kWidth, kHeight}) {
  test::Samples samples;
  for (int y = 0; y < recipe.height; ++y) {
    for (int x = 0; x < recipe.width; ++x) {
      samples.push_back(std::uint16_t(shade(x, y)));
      if (recipe.colour_type == 4) samples.push_back(x < recipe.width / 4 ? 0 : 255);
    }
  }
  return test::png(recipe, samples);
}

std::shared_ptr<const GridPyramid> readOf(const std::string& bytes, std::string* problem = nullptr) {
  GridOptions options;
  for (;;) {
    auto opened = openGrid(test::shared(bytes), options);
    if (!opened) return nullptr;
    const std::atomic<bool> cancelled{false};
    const auto error = (*opened)->read(cancelled, {});
    if (error && problem) *problem = sentences::wordsOf(*error).toStdString();
    if (options.code && (*opened)->otherCode()) return nullptr;  // once is enough
    options.code = (*opened)->otherCode();
    if (!options.code) return (*opened)->pyramid();
  }
}

bool knows(const GridPyramid& cells, int gray) { return meaningOf(cells.code()).known[std::size_t(gray)]; }

int saverShade(int x, int y) { return x < 90 ? 205 : (x % 40 == 0 || y % 50 == 0) ? 0 : 254; }
int robotShade(int x, int y) { return x < 90 ? 128 : (x % 40 == 0 || y % 50 == 0) ? 0 : 255; }
int manyShades(int x, int y) { return int(dice(x, y) % 256); }

}  // namespace

class TestGrayShades : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void thePictureTellsWhatIsUnknown_data() {
    QTest::addColumn<Shade>("shade");
    QTest::addColumn<bool>("saver");   // 205 is known
    QTest::addColumn<bool>("middle");  // 128 is known
    const auto add = [](const char* name, const Shade& shade, bool saver, bool middle) {
      QTest::newRow(name) << shade << saver << middle;
    };
    add("map_saver", saverShade, false, false);
    add(
        "map_saver, a few cells drawn by hand",
        [](int x, int y) { return dice(x, y) % 150 == 0 ? int(dice(y, x) % 256) : saverShade(x, y); }, false,
        false);
    add("a robot's three shades", robotShade, false, false);
    add(
        "four bits", [](int x, int y) { return robotShade(x, y) == 128 ? 119 : robotShade(x, y); }, false,
        false);
    add(
        "only unknown", [](int, int) { return 205; }, false, false);
    add(
        "a robot's many shades",
        [](int x, int y) { return x > 90 && dice(x, y) % 8 == 0 ? manyShades(x, y) : robotShade(x, y); },
        true, false);
    add(
        "a robot's map that is mostly walls of two more shades",
        [](int x, int y) { return x > 90 && dice(x, y) % 9 == 0 ? (x % 2 ? 60 : 205) : robotShade(x, y); },
        true, false);
    add("every shade alike", manyShades, true, true);
    add(
        "a slope", [](int x, int) { return x * 255 / kWidth; }, true, true);
    add(
        "sixteen shades", [](int x, int y) { return int(dice(x, y) % 16) * 17; }, true, true);
    add(
        "a soft picture around the middle",
        [](int x, int y) { return int(dice(x, y) % 40 + dice(y, x) % 40 + dice(x + y, x) % 40) + 70; }, true,
        true);
    add(
        "a slope with map_saver's gray among others",
        [](int x, int y) { return y < 60 ? 205 : 20 + x * 230 / kWidth; }, true, true);
    add(
        "one light shade", [](int, int) { return 180; }, true, true);
  }
  void thePictureTellsWhatIsUnknown() {
    QFETCH(Shade, shade);
    QFETCH(bool, saver);
    QFETCH(bool, middle);
    for (const bool interlaced : {false, true}) {
      const auto cells = readOf(pictureOf(shade, {kWidth, kHeight, 8, 0, interlaced}));
      QVERIFY(cells);
      QVERIFY(isGray(cells->code()));
      QCOMPARE(knows(*cells, 205), saver);
      QCOMPARE(knows(*cells, 128), middle);
      QCOMPARE(knows(*cells, 112), middle);
      QVERIFY(knows(*cells, 0) && knows(*cells, 254) && knows(*cells, 255) && knows(*cells, 204));
      // Whatever they mean, the bytes are the grays of the picture.
      for (int y = 0; y < kHeight; y += 7) {
        for (int x = 0; x < kWidth; ++x) QCOMPARE(int(cells->at(x, y)), shade(x, y));
      }
    }
  }

  void oneReadingForAllRowsWhateverComesFirst() {
    // The upper half alone would be a map_saver's.
    const Shade late = [](int x, int y) { return y < kHeight / 2 ? saverShade(x, y) : manyShades(x, y); };
    const Shade early = [late](int x, int y) { return late(x, kHeight - 1 - y); };
    const auto one = readOf(pictureOf(late)), other = readOf(pictureOf(early));
    QVERIFY(one->code() == CellCode::FullGray);
    QVERIFY(other->code() == CellCode::FullGray);
  }

  void theFirstRowsAreShownAtOnceAndTheWholePictureHasTheLastWord() {
    // More rows of a map_saver's picture than are glimpsed at, then many shades.
    constexpr int kWide = 2048, kHigh = 800, kLate = 700;
    const std::string bytes = pictureOf(
        [](int x, int y) { return y < kLate ? saverShade(x % kWidth, y % kHeight) : manyShades(x, y); },
        {kWide, kHigh});
    auto opened = openGrid(test::shared(bytes), {});
    QVERIFY((*opened)->pyramid()->code() == CellCode::Gray);
    int rows_seen = 0;
    const std::atomic<bool> cancelled{false};
    const auto error = (*opened)->read(
        cancelled, [&] { rows_seen = std::max(rows_seen, (*opened)->pyramid()->rowsReady()); });
    QVERIFY(!error);
    QVERIFY(rows_seen > 0 && rows_seen < kHigh);
    QVERIFY((*opened)->otherCode() == CellCode::FullGray);
    QVERIFY(readOf(bytes)->code() == CellCode::FullGray);
  }

  void transparentPixelsAreUnknownWhateverTheGraysAre() {
    const auto cells = readOf(pictureOf(manyShades, {kWidth, kHeight, 8, 4}));
    QVERIFY(cells->code() == CellCode::ClearGray);
    QVERIFY(!knows(*cells, cells->at(3, 3)));
    QVERIFY(knows(*cells, 205) && knows(*cells, 127) && knows(*cells, 129));
  }

  void rowsThatNeverCameAreUnknown() {
    std::string bytes = pictureOf(manyShades), problem;
    bytes.resize(bytes.size() / 2);
    const auto cells = readOf(bytes, &problem);
    QVERIFY(!problem.empty());
    QVERIFY(!knows(*cells, cells->at(5, kHeight - 1)));
    QVERIFY(knows(*cells, 205));
  }

  void coarserLevelsAreMadeWithTheSameMeaning() {
    // One dark spot of the middle in a light picture: a gray like any other, so it is not lost.
    const auto cells =
        readOf(pictureOf([](int x, int y) { return x == 101 && y == 77 ? 120 : 150 + (x * 3 + y) % 105; }));
    QVERIFY(cells->code() == CellCode::FullGray);
    const auto tile = cells->tile(1, 0, 0);
    QCOMPARE(int(tile->cells.get()[38 * 256 + 50]), 120);
  }

  void aSidecarKeepsTheReading() {
    QTemporaryDir folder;
    GridOptions options;
    options.sidecar_folder = folder.path().toStdString();
    options.fingerprint = std::string("content");
    for (const bool at_once : {false, true}) {
      auto opened = openGrid(test::shared(pictureOf(manyShades)), options);
      QCOMPARE((*opened)->complete(), at_once);
      const std::atomic<bool> cancelled{false};
      QVERIFY(!(*opened)->read(cancelled, {}));
      QVERIFY((*opened)->pyramid()->code() == CellCode::FullGray);
      QVERIFY(!(*opened)->otherCode());
    }
  }

  void aYamlDecidesForItself() {
    GridOptions options;
    options.reading.mode = map::CellReading::Mode::Trinary;
    auto opened = openGrid(test::shared(pictureOf(manyShades)), options);
    QVERIFY((*opened)->pyramid()->code() == CellCode::Occupancy);
  }
};

}  // namespace test_gray_shades

MAPWRIGHT_TEST(test_gray_shades, TestGrayShades, Core)
#include "test_gray_shades.moc"
