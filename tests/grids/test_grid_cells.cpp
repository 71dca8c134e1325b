// What map_server and nav2 make of a pixel, and what the bytes of a cell mean.
#include <cmath>

#include <QtTest>

#include "grids/grid_cells.h"
#include "test_program.h"

namespace test_grid_cells {

using namespace mapwright;
using namespace mapwright::grids;
using map::CellReading;

namespace {

CellReading readingOf(CellReading::Mode mode, bool negate = false) {
  CellReading reading;
  reading.mode = mode;
  reading.negate = negate;
  return reading;
}

int gray(const CellReading& reading, int shade) {
  return cellFromPixel(reading, shade / 255.0, 1, 1.0, false);
}

}  // namespace

class TestGridCells : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyByteHasOneMeaning() {
    for (const CellCode code : {CellCode::Gray, CellCode::Occupancy, CellCode::ShadedGray,
                                CellCode::ClearGray, CellCode::FullGray}) {
      const CellMeaning& meaning = meaningOf(code);
      for (std::size_t byte = 0; byte < 256; ++byte) {
        QCOMPARE(meaning.known[byte], meaning.occupancy[byte] >= 0);
        QCOMPARE(meaning.known[byte], meaning.rank[byte] > 0);
        if (!meaning.known[byte]) QCOMPARE(int(meaning.intensity[byte]), 128);
      }
    }
  }

  void grayIsFreeWhenLight() {
    const CellMeaning& gray_meaning = meaningOf(CellCode::Gray);
    QCOMPARE(int(gray_meaning.occupancy[0]), 100);
    QCOMPARE(int(gray_meaning.occupancy[255]), 0);
    QCOMPARE(int(gray_meaning.rank[0]), 255);
    QCOMPARE(int(gray_meaning.rank[255]), 1);
    for (const std::size_t unknown : {112u, 128u, 143u, 205u}) QVERIFY(!gray_meaning.known[unknown]);
    for (const std::size_t known : {111u, 144u, 204u, 206u}) QVERIFY(gray_meaning.known[known]);
    int last = 256;
    for (std::size_t level = 0; level < 256; ++level) {
      if (!gray_meaning.known[level]) continue;
      QVERIFY(gray_meaning.rank[level] < last);
      last = gray_meaning.rank[level];
    }
  }

  void whichGraysAreUnknownIsTheCodes() {
    const auto unknown = [](CellCode code) {
      int count = 0;
      for (const bool known : meaningOf(code).known) count += !known;
      return count;
    };
    QCOMPARE(unknown(CellCode::Gray), 33);
    QCOMPARE(unknown(CellCode::ShadedGray), 32);
    QVERIFY(meaningOf(CellCode::ShadedGray).known[205]);
    QCOMPARE(unknown(CellCode::ClearGray), 1);
    QVERIFY(!meaningOf(CellCode::ClearGray).known[kTransparentGray]);
    QCOMPARE(unknown(CellCode::FullGray), 0);
  }

  void occupancyIsPercent() {
    const CellMeaning& meaning = meaningOf(CellCode::Occupancy);
    QCOMPARE(int(meaning.occupancy[37]), 37);
    QCOMPARE(int(meaning.occupancy[127]), 100);
    QCOMPARE(int(meaning.occupancy[255]), -1);
    QCOMPARE(int(meaning.occupancy[200]), -1);
    QCOMPARE(int(meaning.intensity[0]), 255);
    QCOMPARE(int(meaning.intensity[100]), 0);
    QCOMPARE(int(meaning.rank[0]), 1);
    QCOMPARE(int(meaning.rank[100]), 255);
  }

  void pictureKeepsGrays() {
    for (int shade = 0; shade < 256; ++shade) QCOMPARE(gray({}, shade), shade);
    QCOMPARE(int(cellFromPixel({}, 0.0, 1, 0.49, true)), int(kTransparentGray));
    QCOMPARE(int(cellFromPixel({}, 0.0, 1, 0.5, true)), 0);
    QVERIFY(codeOf({}) == CellCode::Gray);
    QVERIFY(codeOf(readingOf(CellReading::Mode::Raw)) == CellCode::Occupancy);
  }

  void trinaryComparesStrictlyWithTheThresholds() {
    const CellReading trinary = readingOf(CellReading::Mode::Trinary);
    QCOMPARE(gray(trinary, 0), 100);
    QCOMPARE(gray(trinary, 254), 0);
    QCOMPARE(gray(trinary, 255), 0);
    QCOMPARE(gray(trinary, 205), 255);  // 50/255 = 0.19608 is not below 0.196
    QCOMPARE(gray(trinary, 206), 0);
    QCOMPARE(gray(trinary, 89), 100);  // 166/255 = 0.65098
    QCOMPARE(gray(trinary, 90), 255);
    CellReading exact = trinary;
    exact.occupied_thresh = 1.0;
    exact.free_thresh = 0.0;
    QCOMPARE(gray(exact, 0), 255);
    QCOMPARE(gray(exact, 255), 255);
  }

  void negateTurnsShadesRound() {
    const CellReading negated = readingOf(CellReading::Mode::Trinary, true);
    QCOMPARE(gray(negated, 255), 100);
    QCOMPARE(gray(negated, 0), 0);
    QCOMPARE(gray(negated, 128), 255);
  }

  void trinaryAveragesAlphaIn() {
    const CellReading trinary = readingOf(CellReading::Mode::Trinary);
    QCOMPARE(int(cellFromPixel(trinary, 0.0, 3, 1.0, true)), 100);  // shade 0.25
    QCOMPARE(int(cellFromPixel(trinary, 3.0, 3, 0.0, true)), 255);  // shade 0.75: occupied 0.25
    QCOMPARE(int(cellFromPixel(trinary, 3.0, 3, 1.0, true)), 0);
    QCOMPARE(int(cellFromPixel(trinary, 3.0, 3, 0.0, false)), 0);
  }

  void scaleInterpolatesBetweenTheThresholds() {
    const CellReading scale = readingOf(CellReading::Mode::Scale);
    QCOMPARE(gray(scale, 0), 100);
    QCOMPARE(gray(scale, 255), 0);
    for (int shade = 90; shade <= 205; ++shade) {
      const double occupied = (255 - shade) / 255.0;
      QCOMPARE(gray(scale, shade), int(std::rint((occupied - 0.196) / (0.65 - 0.196) * 100)));
    }
    QCOMPARE(int(cellFromPixel(scale, 0.0, 1, 0.99, true)), int(kUnknownOccupancy));
    QCOMPARE(int(cellFromPixel(scale, 0.0, 1, 1.0, true)), 100);
    CellReading together = scale;
    together.free_thresh = together.occupied_thresh = 0.5;
    QCOMPARE(int(cellFromPixel(together, 0.5, 1, 1.0, false)), int(kUnknownOccupancy));
  }

  void rawKeepsPercents() {
    const CellReading raw = readingOf(CellReading::Mode::Raw, true);
    for (int shade = 0; shade < 256; ++shade) QCOMPARE(gray(raw, shade), shade <= 100 ? shade : 255);
    QCOMPARE(int(cellFromPixel(raw, 42 / 255.0, 1, 0.0, true)), 42);
  }
};

}  // namespace test_grid_cells

MAPWRIGHT_TEST(test_grid_cells, TestGridCells, Core)
#include "test_grid_cells.moc"
