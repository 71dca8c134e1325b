#include <algorithm>
#include <cstdlib>

#include <QtTest>

#include "cell_samples.h"
#include "cells/cell_texture.h"
#include "test_program.h"

namespace test_cell_texture {

using namespace mapwright::cells;

namespace {

CellPair denseCell(const DenseCells& dense, int u, int v) {
  const std::size_t at = (std::size_t(v + DenseCells::kBorder) * std::size_t(dense.stride) +
                          std::size_t(u + DenseCells::kBorder)) *
                         std::size_t(dense.bytes_per_cell);
  if (dense.layout == CellLayout::Pairs) {
    return {dense.data[at], dense.data[at + 1]};
  }
  const int d = std::int8_t(dense.data[at]);
  return d > 0 ? CellPair{std::uint8_t(d), 0} : CellPair{0, std::uint8_t(-d)};
}

bool observed(const CellPair& cell) { return cell.value != 0 || cell.alpha != 0; }

/// Cells with both value and alpha: they cannot be folded.
std::vector<CellPair> opaqueBlob(int width, int height) {
  auto cells = samples::blob(width, height, 3);
  for (CellPair& cell : cells) {
    if (observed(cell)) {
      cell = {std::uint8_t(cell.value + 100), 255};
    }
  }
  return cells;
}

int net(const CellPair& cell) { return int(cell.value) - int(cell.alpha); }

}  // namespace

class TestCellTexture : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void roundTripsExactly_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<bool>("folds");
    const std::pair<int, int> sizes[] = {{1, 1},   {1, 9},  {9, 1},    {7, 8},     {8, 8},     {9, 9},
                                         {16, 17}, {64, 3}, {100, 75}, {400, 400}, {515, 130}, {1, 1000}};
    for (const auto& [width, height] : sizes) {
      QTest::addRow("%dx%d folded", width, height) << width << height << true;
      QTest::addRow("%dx%d pairs", width, height) << width << height << false;
    }
  }
  void roundTripsExactly() {
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(bool, folds);
    const auto cells = folds ? samples::blob(width, height, 7, 0.6) : opaqueBlob(width, height);
    const auto texture = CellTexture::fromPairs(width, height, 0.05, cells);
    QCOMPARE(texture->width(), width);
    QCOMPARE(texture->height(), height);
    QCOMPARE(texture->resolutionM(), 0.05);
    QCOMPARE(texture->layout(), folds ? CellLayout::Folded : CellLayout::Pairs);
    QCOMPARE(texture->observedCells(), std::size_t(std::count_if(cells.begin(), cells.end(), observed)));

    const DenseCells dense = texture->expand(0);
    QCOMPARE(dense.width, width);
    QCOMPARE(dense.height, height);
    QCOMPARE(dense.stride, width + 2 * DenseCells::kBorder);
    QCOMPARE(dense.bytes_per_cell, folds ? 1 : 2);
    QVERIFY(dense.data.size() >= std::size_t(dense.stride) * std::size_t(height + 2 * DenseCells::kBorder) *
                                         std::size_t(dense.bytes_per_cell) +
                                     DenseCells::kSlack);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const CellPair& cell = cells[std::size_t(v) * std::size_t(width) + std::size_t(u)];
        if (!(texture->at(u, v) == cell) || !(denseCell(dense, u, v) == cell)) {
          QFAIL(qPrintable(QStringLiteral("cell %1, %2 differs").arg(u).arg(v)));
        }
      }
    }
  }

  void frameAroundTheCellsIsUnknownAtEveryLevel() {
    for (const bool folds : {true, false}) {
      std::vector<CellPair> full(std::size_t(83) * 61, folds ? CellPair{0, 127} : CellPair{200, 200});
      const auto texture = CellTexture::fromPairs(83, 61, 0.05, full);
      for (int level = 0; level < texture->levels(); ++level) {
        const DenseCells dense = texture->expand(level);
        std::size_t outside = 0;
        for (int v = -DenseCells::kBorder; v < dense.height + DenseCells::kBorder; ++v) {
          for (int u = -DenseCells::kBorder; u < dense.width + DenseCells::kBorder; ++u) {
            const bool inside = u >= 0 && v >= 0 && u < dense.width && v < dense.height;
            outside += !inside && observed(denseCell(dense, u, v));
            if (inside) {
              QVERIFY(observed(denseCell(dense, u, v)));
            }
          }
        }
        QCOMPARE(outside, std::size_t(0));
        const std::size_t end = std::size_t(dense.stride) *
                                std::size_t(dense.height + 2 * DenseCells::kBorder) *
                                std::size_t(dense.bytes_per_cell);
        QVERIFY(std::all_of(dense.data.begin() + std::ptrdiff_t(end), dense.data.end(),
                            [](std::uint8_t byte) { return byte == 0; }));
      }
    }
  }

  void cellsOutsideAreUnknown() {
    const auto texture = CellTexture::fromPairs(2, 2, 1, std::vector<CellPair>(4, CellPair{9, 0}));
    const std::pair<int, int> outside[] = {{-1, 0}, {0, -1}, {2, 0}, {0, 2}, {1 << 30, 0}, {0, -(1 << 30)}};
    for (const auto& [u, v] : outside) {
      QCOMPARE(texture->at(u, v), CellPair{});
    }
    QCOMPARE(texture->at(1, 1), (CellPair{9, 0}));
  }

  void foldsExactlyWhatHasOneSignedByte_data() {
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("alpha");
    QTest::addColumn<bool>("folds");
    QTest::addRow("unknown") << 0 << 0 << true;
    QTest::addRow("delta zero") << 0 << 1 << true;
    QTest::addRow("surely free") << 127 << 0 << true;
    QTest::addRow("surely occupied") << 0 << 127 << true;
    QTest::addRow("value 128") << 128 << 0 << false;
    QTest::addRow("alpha 128") << 0 << 128 << false;
    QTest::addRow("value 255") << 255 << 0 << false;
    QTest::addRow("both") << 1 << 1 << false;
    QTest::addRow("opposite, even") << 64 << 64 << false;
    QTest::addRow("opaque") << 40 << 255 << false;
  }
  void foldsExactlyWhatHasOneSignedByte() {
    QFETCH(int, value);
    QFETCH(int, alpha);
    QFETCH(bool, folds);
    std::vector<CellPair> cells(std::size_t(33) * 17, CellPair{5, 0});
    const CellPair odd{std::uint8_t(value), std::uint8_t(alpha)};
    cells[std::size_t(11) * 33 + 32] = odd;
    const auto texture = CellTexture::fromPairs(33, 17, 0.05, cells);
    QCOMPARE(texture->layout(), folds ? CellLayout::Folded : CellLayout::Pairs);
    QCOMPARE(texture->at(32, 11), odd);
    QCOMPARE(texture->at(31, 11), (CellPair{5, 0}));
  }

  void foldedCellsAreTakenAsTheyAre() {
    samples::Bytes folded;
    for (int d = -127; d <= 127; ++d) {
      folded.push_back(std::uint8_t(d));
    }
    const auto texture = CellTexture::fromFolded(255, 1, 0.05, folded);
    QCOMPARE(texture->layout(), CellLayout::Folded);
    QCOMPARE(texture->observedCells(), std::size_t(254));
    for (int d = -127; d <= 127; ++d) {
      const CellPair expected = d > 0 ? CellPair{std::uint8_t(d), 0} : CellPair{0, std::uint8_t(-d)};
      QCOMPARE(texture->at(d + 127, 0), expected);
    }
  }

  void levelsHalveUntilEightCells() {
    const auto texture = CellTexture::fromPairs(400, 130, 0.05, samples::blob(400, 130, 1));
    QCOMPARE(texture->levels(), 7);  // 400 200 100 50 25 13 7
    int width = 400;
    int height = 130;
    for (int level = 0; level < texture->levels(); ++level) {
      const DenseCells dense = texture->expand(level);
      QCOMPARE(dense.width, width);
      QCOMPARE(dense.height, height);
      width = (width + 1) / 2;
      height = (height + 1) / 2;
    }
    QCOMPARE(CellTexture::fromPairs(8, 8, 1, std::vector<CellPair>(64))->levels(), 1);
    QCOMPARE(CellTexture::fromPairs(9, 1, 1, std::vector<CellPair>(9))->levels(), 2);
  }

  void reducedCellsAverageTheirFourChildren_data() {
    QTest::addColumn<bool>("folds");
    QTest::addRow("folded") << true;
    QTest::addRow("pairs") << false;
  }
  void reducedCellsAverageTheirFourChildren() {
    QFETCH(bool, folds);
    const auto cells = folds ? samples::blob(203, 77, 5, 0.45) : opaqueBlob(203, 77);
    const auto texture = CellTexture::fromPairs(203, 77, 0.05, cells);
    DenseCells fine = texture->expand(0);
    for (int level = 1; level < texture->levels(); ++level) {
      const DenseCells coarse = texture->expand(level);
      for (int v = 0; v < coarse.height; ++v) {
        for (int u = 0; u < coarse.width; ++u) {
          int value = 0;
          int alpha = 0;
          int sum = 0;
          bool any = false;
          for (int child = 0; child < 4; ++child) {
            const CellPair cell = denseCell(fine, 2 * u + child % 2, 2 * v + child / 2);
            value += cell.value;
            alpha += cell.alpha;
            sum += net(cell);
            any = any || observed(cell);
          }
          const CellPair cell = denseCell(coarse, u, v);
          QCOMPARE(observed(cell), any);
          if (folds) {
            QVERIFY(std::abs(4 * net(cell) - sum) <= 2 || (std::abs(sum) <= 2 && cell == CellPair{0, 1}));
          } else {
            QVERIFY(std::abs(4 * int(cell.value) - value) <= 2);
            QVERIFY(std::abs(4 * int(cell.alpha) - alpha) <= 4);
          }
        }
      }
      fine = coarse;
    }
  }

  void whatCancelsOutStaysObserved() {
    // One free and one occupied cell of the same weight, and a lone faint cell: both average to nothing.
    std::vector<CellPair> cells(std::size_t(16) * 16);
    cells[0] = {50, 0};
    cells[1] = {0, 50};
    cells[15 * 16 + 15] = {1, 0};
    const auto texture = CellTexture::fromPairs(16, 16, 1, cells);
    const DenseCells half = texture->expand(1);
    QCOMPARE(denseCell(half, 0, 0), (CellPair{0, 1}));
    QCOMPARE(denseCell(half, 7, 7), (CellPair{0, 1}));
    QCOMPARE(denseCell(half, 3, 3), CellPair{});
  }

  void emptyGroundIsKnownByWholeBlocks() {
    std::minstd_rand random(42);
    for (const auto& [width, height] : {std::pair{61, 43}, std::pair{8, 8}, std::pair{5, 90}}) {
      std::vector<CellPair> cells(std::size_t(width) * std::size_t(height));
      for (int i = 0; i < 6; ++i) {
        cells[random() % cells.size()] = {3, 0};
      }
      const auto texture = CellTexture::fromPairs(width, height, 0.05, cells);
      for (int level = 0; level < texture->levels(); ++level) {
        const DenseCells dense = texture->expand(level);
        QCOMPARE(dense.occupied_sum.size(),
                 std::size_t(dense.blocks_x + 1) * std::size_t(dense.blocks_y + 1));
        for (int round = 0; round < 500; ++round) {
          const int u0 = int(random() % 80) - 10;
          const int v0 = int(random() % 110) - 10;
          const int u1 = u0 + int(random() % 30) - 2;
          const int v1 = v0 + int(random() % 30) - 2;
          QCOMPARE(dense.emptyWithin(u0, v0, u1, v1), bruteEmpty(dense, u0, v0, u1, v1));
        }
        QVERIFY(!dense.emptyWithin(-(1 << 30), -(1 << 30), 1 << 30, 1 << 30));
        QVERIFY(dense.emptyWithin(dense.width, 0, dense.width + 5, dense.height));
        QVERIFY(dense.emptyWithin(3, 3, 2, 3));
      }
    }
  }

  void unknownGroundCostsNextToNothing() {
    const std::size_t cells = std::size_t(2000) * 2000;
    const auto nothing = CellTexture::fromPairs(2000, 2000, 0.05, std::vector<CellPair>(cells));
    QCOMPARE(nothing->observedCells(), std::size_t(0));
    QVERIFY2(nothing->bytes() < cells / 200, qPrintable(QString::number(nothing->bytes())));
    QVERIFY(nothing->expand(0).emptyWithin(0, 0, 1999, 1999));
    QVERIFY(nothing->expand(1).emptyWithin(0, 0, 999, 999));
  }

  void aTypicalSubmapTakesHalfAByteACell() {
    const auto texture = CellTexture::fromPairs(400, 400, 0.05, samples::blob(400, 400, 9, 0.3613));
    const double known = double(texture->observedCells()) / 160000;
    QVERIFY(known > 0.405 && known < 0.415);
    QVERIFY2(texture->bytes() <= 80000, qPrintable(QString::number(texture->bytes())));
  }

 private:
  static bool bruteEmpty(const DenseCells& dense, int u0, int v0, int u1, int v1) {
    u0 = std::max(u0, 0);
    v0 = std::max(v0, 0);
    u1 = std::min(u1, dense.width - 1);
    v1 = std::min(v1, dense.height - 1);
    if (u0 > u1 || v0 > v1) {
      return true;
    }
    const int block = DenseCells::kBlock;
    for (int v = v0 / block * block; v < std::min((v1 / block + 1) * block, dense.height); ++v) {
      for (int u = u0 / block * block; u < std::min((u1 / block + 1) * block, dense.width); ++u) {
        if (observed(denseCell(dense, u, v))) {
          return false;
        }
      }
    }
    return true;
  }
};

}  // namespace test_cell_texture

MAPWRIGHT_TEST(test_cell_texture, TestCellTexture, Nothing)
#include "test_cell_texture.moc"
