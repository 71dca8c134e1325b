// What a pixel larger than a cell shows, at every zoom and turn, against a slow reference: the pixel's square
// is clipped by every cell around it.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <QTest>

#include "grids.h"
#include "grids/grid_pyramid.h"
#include "render/sample_grid.h"
#include "test_program.h"

namespace test_touched_cells {

using namespace mapwright;
using grids::CellCode;
using grids::Reduction;
using render::Composition;
using render::PixelGrid;
using test::gridOf;

namespace {

constexpr double kSurely = 1e-7, kSurelyNot = 1e-11;  // of a cell's area; between them rounding may decide

std::uint32_t dice(int u, int v) {
  std::uint32_t h = std::uint32_t(u) * 0x9e3779b1u ^ std::uint32_t(v) * 0x85ebca6bu;
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  return h ^ h >> 13;
}

/// Thin walls, speckle, unknown halls and large empty ones.
int roomGray(int u, int v) {
  if (u < 300 && v > 280 && v < 620) return 255;
  if (u > 560 && v < 300) return 128;
  if (u % 61 == 17 || v % 83 == 40) return int(dice(u, v) % 40);
  if ((u / 37 + v / 29) % 4 == 0) return dice(u, v) % 9 == 0 ? 205 : 128;
  return dice(u, v) % 23 == 0 ? int(dice(v, u) % 256) : 255;
}

int roomPercent(int u, int v) {
  const int gray = roomGray(u, v);
  if (gray == 128) return 255;
  if (gray == 205) return dice(u, v) % 5 == 0 ? 113 : 254;  // odd bytes of "raw" maps
  return (255 - gray) * 100 / 255;
}

/// What a cell says, written down again: nothing for unknown, else how high it ranks and what it counts.
struct Meaning {
  bool known = false;
  double height = 0, value = 0;
};
Meaning meaningOf(CellCode code, int byte) {
  if (code == CellCode::Occupancy) {
    if (byte >= 128) return {false, byte / 1000.0, 0};
    return {true, 1 + byte + (byte > 100 ? 0.001 * byte : 0), double(std::min(byte, 100))};
  }
  const bool band = byte >= 112 && byte <= 143;
  const bool known = code == CellCode::FullGray     ? true
                     : code == CellCode::ClearGray  ? byte != 128
                     : code == CellCode::ShadedGray ? !band
                                                    : !band && byte != 205;
  if (!known) return {false, byte / 1000.0, 0};
  return {true, 256.0 - byte, double(byte)};
}

/// A square, and what four straight cuts leave of it.
struct Polygon {
  std::array<Eigen::Vector2d, 8> corners;
  std::size_t count = 0;
  void push_back(const Eigen::Vector2d& corner) { corners[count++] = corner; }
  std::size_t size() const { return count; }
  const Eigen::Vector2d& operator[](std::size_t n) const { return corners[n]; }
};

/// What of a polygon is on the inner side of a line: `sign` * coordinate `axis` <= `sign` * `limit`.
Polygon cut(const Polygon& shape, int axis, double limit, double sign) {
  Polygon out;
  for (std::size_t n = 0; n < shape.size(); ++n) {
    const Eigen::Vector2d one = shape[n], other = shape[(n + 1) % shape.size()];
    const double a = sign * (limit - one[axis]), b = sign * (limit - other[axis]);
    if (a >= 0) out.push_back(one);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) out.push_back(one + (other - one) * (a / (a - b)));
  }
  return out;
}

double areaOf(const Polygon& shape) {
  double twice = 0;
  for (std::size_t n = 0; n < shape.size(); ++n) {
    const Eigen::Vector2d one = shape[n] - shape[0], other = shape[(n + 1) % shape.size()] - shape[0];
    twice += one.x() * other.y() - one.y() * other.x();
  }
  return std::abs(twice) / 2;
}

struct Expected {
  bool inside = false, unsure = false;
  int highest = 0;
  double known_part = 0, mean = 0;
};

Expected expectedAt(const PixelGrid& pixels, const render::PlacedGrid& placed, int (*cell)(int, int),
                    int column, int row) {
  Polygon square;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    square.push_back(placed.reference.cellFromWorld(pixels.worldFromPixel(column + x, row + y)));
  }
  Eigen::Vector2d least = square[0], most = square[0];
  for (std::size_t n = 1; n < square.size(); ++n) {
    least = least.cwiseMin(square[n]);
    most = most.cwiseMax(square[n]);
  }
  const CellCode code = placed.cells->code();
  Expected expected;
  double highest = -1, perhaps = -1, area_read = 0, area_known = 0, sum = 0;
  const int u1 = std::min(placed.reference.width - 1, int(std::floor(most.x())));
  const int v1 = std::min(placed.reference.height - 1, int(std::floor(most.y())));
  for (int v = std::max(0, int(std::floor(least.y()))); v <= v1; ++v) {
    const Polygon strip = cut(cut(square, 1, v, -1), 1, v + 1, 1);
    if (strip.size() < 3) continue;
    for (int u = std::max(0, int(std::floor(least.x()))); u <= u1; ++u) {
      const Polygon part = cut(cut(strip, 0, u, -1), 0, u + 1, 1);
      const double area = part.size() < 3 ? 0 : areaOf(part);
      if (area < kSurelyNot) continue;
      const int byte = cell(u, v);
      const Meaning meaning = meaningOf(code, byte);
      if (area < kSurely) {
        perhaps = std::max(perhaps, meaning.height);
        continue;
      }
      expected.inside = true;
      if (meaning.height > highest) {
        highest = meaning.height;
        expected.highest = byte;
      }
      area_read += area;
      if (!meaning.known) continue;
      area_known += area;
      sum += area * meaning.value;
    }
  }
  expected.unsure = perhaps > highest;
  if (area_read > 0) expected.known_part = area_known / area_read;
  if (area_known > 0) expected.mean = sum / area_known;
  return expected;
}

/// A window of `width` x `height` pixels around the middle of the map.
PixelGrid windowOn(const render::PlacedGrid& placed, double zoom, double rotation, int width, int height,
                   const Eigen::Vector2d& aside) {
  PixelGrid pixels;
  pixels.scale_m_per_px = placed.reference.resolution_m * zoom;
  pixels.rotation_rad = rotation;
  pixels.width_px = width;
  pixels.height_px = height;
  pixels.first_column = -width / 2;
  pixels.first_row = -height / 2;
  pixels.origin_m = placed.reference.worldFromCell(
      Eigen::Vector2d(placed.reference.width / 2, placed.reference.height / 2) + aside);
  return pixels;
}

}  // namespace

class TouchedCellsTest : public QObject {
  Q_OBJECT

  std::map<std::pair<CellCode, Reduction>, render::PlacedGrid> rooms_;  // each made once
  render::PlacedGrid room(CellCode code, Reduction reduction, double yaw) {
    render::PlacedGrid& made = rooms_[{code, reduction}];
    const auto cell = code == CellCode::Occupancy ? roomPercent : roomGray;
    if (!made.cells) made = gridOf(917, 641, 0.05, {}, cell, reduction, code);
    made.reference.origin = {10.02, -3.01, yaw};
    return made;
  }

 private Q_SLOTS:
  void aLargePixelShowsWhatItTouchesAndNothingElse_data() {
    QTest::addColumn<double>("zoom");
    QTest::addColumn<double>("rotation");
    QTest::addColumn<double>("yaw");
    for (const double zoom : {1.3, 2.0, 3.7, 4.0, 7.3, 16.0, 34.6, 100.0, 300.0}) {
      QTest::addRow("%g cells a pixel", zoom) << zoom << 0.0 << 0.0;
      QTest::addRow("%g cells a pixel, turned a quarter", zoom) << zoom << M_PI / 2 << 0.0;
      QTest::addRow("%g cells a pixel, turned a little", zoom) << zoom << 0.02 << 0.0;
      QTest::addRow("%g cells a pixel, turned", zoom) << zoom << 2.5 << 0.0;
      QTest::addRow("%g cells a pixel, on the corner", zoom) << zoom << M_PI / 4 << 0.0;
      QTest::addRow("%g cells a pixel, the map turned too", zoom) << zoom << -0.4 << 1.1;
    }
  }
  void aLargePixelShowsWhatItTouchesAndNothingElse() {
    QFETCH(double, zoom);
    QFETCH(double, rotation);
    QFETCH(double, yaw);
    // Every place with a code of its own, another one in every row.
    constexpr std::array kCodes{CellCode::Gray, CellCode::Occupancy, CellCode::ShadedGray,
                                CellCode::FullGray};
    const std::array<Eigen::Vector2d, 3> places{Eigen::Vector2d(0, 0), {-171.37, 90.81}, {290, -200.5}};
    static std::size_t round = 0;
    for (const Eigen::Vector2d& aside : places) {
      const CellCode code = kCodes[round++ % kCodes.size()];
      const auto cell = code == CellCode::Occupancy ? roomPercent : roomGray;
      const auto highest = room(code, Reduction::OccupiedWins, yaw);
      const auto averaged = room(code, Reduction::Average, yaw);
      const int edge = int(std::clamp(std::ceil(300 / zoom), 4.0, 24.0));
      const PixelGrid pixels = windowOn(highest, zoom, rotation, edge, edge, aside);
      const Composition shown = render::sampleGrid(pixels, highest, nullptr);
      const Composition mean = render::sampleGrid(pixels, averaged, nullptr);
      const grids::CellMeaning& meaning = grids::meaningOf(code);
      int unsure = 0, inside = 0;
      for (int row = 0; row < edge; ++row) {
        for (int column = 0; column < edge; ++column) {
          const Expected expected = expectedAt(pixels, highest, cell, column, row);
          const std::size_t at = std::size_t(row * edge + column);
          if (!expected.inside && expected.unsure) continue;
          QCOMPARE(shown.flags[at] != 0, expected.inside);
          QCOMPARE(mean.flags[at] != 0, expected.inside);
          if (!expected.inside) continue;
          ++inside;
          unsure += expected.unsure;
          if (!expected.unsure) QCOMPARE(int(shown.intensity[at]), expected.highest);
          const bool known = render::knownIn(mean, at, meaning);
          if (std::abs(expected.known_part - 0.5) > 1e-5) QCOMPARE(known, expected.known_part > 0.5);
          if (known) {
            const double off = std::abs(mean.intensity[at] - expected.mean);
            QVERIFY2(off <= 0.5 + 1e-3, qPrintable(QString::number(off)));
          }
        }
      }
      QVERIFY(inside > 0);
      QVERIFY2(unsure * 50 <= inside, qPrintable(QString::number(unsure)));
    }
  }

  void aMeanOfBlackAndWhiteIsKnown() {
    const auto placed = gridOf(
        64, 64, 0.05, {0, 0, 0}, [](int u, int) { return u % 2 == 0 ? 0 : 255; }, Reduction::Average);
    const PixelGrid pixels = windowOn(placed, 8, 0, 4, 4, {0, 0});
    const Composition made = render::sampleGrid(pixels, placed, nullptr);
    const grids::CellMeaning& meaning = grids::meaningOf(CellCode::Gray);
    QCOMPARE(int(made.intensity[5]), 128);
    QVERIFY(!meaning.known[128] && render::knownIn(made, 5, meaning));
    QCOMPARE(render::occupancyIn(made, 5, meaning), 50);
  }

  void whereAWindowIsCutDoesNotMatter() {
    for (const Reduction reduction : {Reduction::OccupiedWins, Reduction::Average}) {
      const auto placed = gridOf(917, 641, 0.05, {1, 2, 0.3}, roomGray, reduction);
      const PixelGrid whole = windowOn(placed, 9.7, 0.2, 60, 50, {3.3, 1.7});
      const Composition all = render::sampleGrid(whole, placed, nullptr);
      PixelGrid part = whole;
      part.first_column += 21;
      part.first_row += 13;
      part.width_px = part.height_px = 19;
      const Composition some = render::sampleGrid(part, placed, nullptr);
      int differ = 0;
      for (int row = 0; row < 19; ++row) {
        for (int column = 0; column < 19; ++column) {
          const std::size_t there = std::size_t((row + 13) * 60 + column + 21),
                            here = std::size_t(row * 19 + column);
          differ += all.intensity[there] != some.intensity[here] || all.flags[there] != some.flags[here];
        }
      }
      QCOMPARE(differ, 0);
    }
  }

  void aMapThatIsStillBeingReadShowsItsRowsExactly() {
    const auto builder = grids::buildGrid(600, 900, CellCode::Gray, Reduction::OccupiedWins);
    std::vector<std::uint8_t> row(600);
    for (int v = 0; v < 448; ++v) {
      for (int u = 0; u < 600; ++u) row[std::size_t(u)] = std::uint8_t(roomGray(u, v));
      builder->pushRow(row);
    }
    const auto cells = builder->pyramid();
    QTRY_COMPARE(cells->rowsReady(), 448);
    const render::PlacedGrid placed{cells, {600, 900, 0.05, {0, 0, 0}}};
    PixelGrid pixels = windowOn(placed, 16, 0, 38, 57, {0, 0});
    pixels.origin_m = placed.reference.worldFromCell({0, 0});
    pixels.first_column = pixels.first_row = 0;
    const Composition shown = render::sampleGrid(pixels, placed, nullptr);
    for (int y = 0; y < 57; ++y) {
      for (int x = 0; x < 37; ++x) {
        const std::size_t at = std::size_t(y * 38 + x);
        if (y * 16 < 448)
          QCOMPARE(int(shown.intensity[at]), expectedAt(pixels, placed, roomGray, x, y).highest);
        QCOMPARE(shown.flags[at] != 0, y * 16 < 448);
      }
    }
  }

  void aQuickLookIsExactWhereItSaysSo_data() {
    QTest::addColumn<Reduction>("reduction");
    QTest::addColumn<double>("rotation");
    QTest::addColumn<double>("exact_up_to");  // cells a pixel, excluded
    QTest::newRow("upright") << Reduction::OccupiedWins << 0.0 << 4.0;
    QTest::newRow("a quarter turn") << Reduction::OccupiedWins << M_PI / 2 << 4.0;
    QTest::newRow("turned") << Reduction::OccupiedWins << 0.3 << 1.1;
    QTest::newRow("turned, averaged") << Reduction::Average << 0.3 << 4.0;
  }
  void aQuickLookIsExactWhereItSaysSo() {
    QFETCH(Reduction, reduction);
    QFETCH(double, rotation);
    QFETCH(double, exact_up_to);
    const auto placed = room(CellCode::Gray, reduction, 0);
    for (const double zoom : {0.5, 1.0, 1.7, 3.9, 4.0, 20.0}) {
      const PixelGrid pixels = windowOn(placed, zoom, rotation, 40, 40, {0.3, 0.2});
      const Composition quick = render::sampleGrid(pixels, placed, nullptr, render::Sampling::Quick);
      const Composition exact = render::sampleGrid(pixels, placed, nullptr);
      const bool same = quick.intensity == exact.intensity && quick.flags == exact.flags;
      QCOMPARE(render::quickIsExact(pixels, placed), zoom < exact_up_to);
      QCOMPARE(same, zoom < exact_up_to);
    }
  }

  void aStripAcrossAHugeMapHasNoHoles() {
    // Compared maps are walked over in strips, which touch more tiles than a view does.
    constexpr int kEdge = 17'000;
    const auto builder = grids::buildGrid(kEdge, kEdge, CellCode::Gray, Reduction::OccupiedWins);
    const std::vector<std::uint8_t> row(kEdge, 255);
    for (int v = 0; v < kEdge; ++v) builder->pushRow(row);
    builder->finish();
    const render::PlacedGrid placed{builder->pyramid(), {kEdge, kEdge, 0.05, {0, 0, 0}}};
    for (const double zoom : {1.0, 1.5}) {
      PixelGrid pixels;
      pixels.scale_m_per_px = 0.05 * zoom;
      pixels.rotation_rad = -M_PI / 4;
      pixels.origin_m = placed.reference.worldFromCell({5, kEdge - 5});
      pixels.width_px = int(23'900 / zoom);
      pixels.height_px = 2;
      const Composition made = render::sampleGrid(pixels, placed, nullptr);
      QCOMPARE(int(std::count(made.flags.begin(), made.flags.end(), std::uint8_t(0))), 0);
    }
  }

  void cancelledWorkGivesNothing() {
    const auto placed = gridOf(917, 641, 0.05, {1, 2, 0}, roomGray);
    const std::atomic<bool> cancelled{true};
    for (const double zoom : {0.5, 3.0, 30.0}) {
      const PixelGrid pixels = windowOn(placed, zoom, 0, 40, 40, {0, 0});
      QCOMPARE(render::sampleGrid(pixels, placed, &cancelled).width_px, 0);
    }
  }
};

}  // namespace test_touched_cells

MAPWRIGHT_TEST(test_touched_cells, TouchedCellsTest, Core)
#include "test_touched_cells.moc"
