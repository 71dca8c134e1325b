// How many cells of a map are free, occupied and unknown.
#include <QtTest>

#include "grids/cell_counts.h"
#include "grids/grid_cells.h"
#include "test_program.h"

namespace test_cell_counts {

using namespace mapwright::grids;

class TestCellCounts : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void countsEachCellOnceBeyondTheEdgesOfTiles() {
    constexpr int kWidth = 300, kHeight = 270;
    const auto builder = buildGrid(kWidth, kHeight, CellCode::Occupancy, Reduction::OccupiedWins, {});
    CellCounts expected;
    for (int y = 0; y < kHeight; ++y) {
      std::vector<std::uint8_t> row(kWidth);
      for (int x = 0; x < kWidth; ++x) {
        const int kind = (x * 7 + y * 3) % 5;
        row[std::size_t(x)] = kind == 0 ? 255 : kind == 1 ? 50 : kind == 2 ? 100 : kind == 3 ? 49 : 0;
        ++(kind == 0 ? expected.unknown : kind < 3 ? expected.occupied : expected.free);
      }
      builder->pushRow(row);
    }
    builder->finish();
    QCOMPARE(countCells(*builder->pyramid(), false), std::optional(expected));
    QCOMPARE(expected.all(), std::int64_t(kWidth) * kHeight);
  }

  void whatIsMissingIsUnknown() {
    const auto builder = buildGrid(10, 10, CellCode::Occupancy, Reduction::OccupiedWins, {});
    builder->pushRow(std::vector<std::uint8_t>(10, 0));
    builder->finish();
    const auto counts = countCells(*builder->pyramid(), false);
    QCOMPARE(counts->free, 10);
    QCOMPARE(counts->unknown, 90);
  }

  void endsWhenItIsCancelled() {
    const auto builder = buildGrid(10, 10, CellCode::Occupancy, Reduction::OccupiedWins, {});
    builder->finish();
    QVERIFY(!countCells(*builder->pyramid(), true));
  }
};

}  // namespace test_cell_counts

MAPWRIGHT_TEST(test_cell_counts, TestCellCounts, Core)
#include "test_cell_counts.moc"
