// Pieces of a grid on one lattice of cells.
#include <atomic>
#include <thread>

#include <QtTest>

#include "grids/reduce_grid.h"
#include "regions/region_cells.h"
#include "regions/region_sheet.h"
#include "test_program.h"

namespace test_region_sheet {

using namespace mapwright;
using regions::kNotFetched;
using regions::RegionCells;
using regions::RegionSheet;

namespace {

map::GridPart piece(int width, int height, double x, double y, std::int8_t value, double yaw = 0,
                    double resolution = 0.05) {
  map::GridPart part;
  part.grid = {width, height, resolution, {x, y, yaw}};
  part.cells = std::make_shared<std::vector<std::int8_t>>(std::size_t(width) * std::size_t(height), value);
  return part;
}

std::uint8_t cellAt(const RegionSheet& sheet, const Eigen::Vector2d& world) {
  const Eigen::Vector2d cell = sheet.reference().cellFromWorld(world);
  const auto tile = sheet.tile(0, int(cell.x()) / 256, int(cell.y()) / 256);
  if (!tile) return kNotFetched;
  return tile->cells.get()[std::size_t(int(cell.y()) % 256) * 256 + std::size_t(int(cell.x()) % 256)];
}

/// Every coarser cell is the highest of its four, in all tiles that are there.
void verifyLevels(const RegionSheet& sheet, const geometry::WorldRect& around) {
  for (int level = 1; level < sheet.levels(); ++level) {
    for (double x = around.min_x; x <= around.max_x; x += 3.21) {
      for (double y = around.min_y; y <= around.max_y; y += 3.21) {
        const Eigen::Vector2d cell = sheet.reference().cellFromWorld({x, y});
        const int u = int(cell.x()) >> level, v = int(cell.y()) >> level;
        const auto at = [&](int of_level, int column, int row) {
          const auto tile = sheet.tile(of_level, column / 256, row / 256);
          return tile ? tile->cells.get()[std::size_t(row % 256) * 256 + std::size_t(column % 256)]
                      : kNotFetched;
        };
        std::uint8_t highest = at(level - 1, 2 * u, 2 * v);
        for (const auto& [du, dv] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
          const std::uint8_t other = at(level - 1, 2 * u + du, 2 * v + dv);
          if (sheet.order()[other] > sheet.order()[highest]) highest = other;
        }
        QCOMPARE(int(at(level, u, v)), int(highest));
      }
    }
  }
}

}  // namespace

class TestRegionSheet : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cellsLieWhereThePieceSays() {
    RegionCells cells;
    map::GridPart part = piece(3, 2, 10, -4, 0);
    part.cells = std::make_shared<std::vector<std::int8_t>>(std::vector<std::int8_t>{0, 50, 100, -1, 7, 120});
    QVERIFY(cells.put(part));
    const RegionSheet& sheet = *cells.sheets().front();
    QCOMPARE(int(cellAt(sheet, {10.02, -3.98})), 0);
    QCOMPARE(int(cellAt(sheet, {10.07, -3.98})), 50);
    QCOMPARE(int(cellAt(sheet, {10.12, -3.98})), 100);
    QCOMPARE(int(cellAt(sheet, {10.02, -3.93})), 255);
    QCOMPARE(int(cellAt(sheet, {10.07, -3.93})), 7);
    QCOMPARE(int(cellAt(sheet, {10.12, -3.93})), 120);
    QCOMPARE(int(cellAt(sheet, {10.17, -3.93})), int(kNotFetched));
  }
  void whatIsNotFetchedIsToldFromWhatIsUnknown() {
    RegionCells cells;
    QVERIFY(cells.put(piece(2, 2, 0, 0, std::int8_t(-128))));  // a byte that some send for "unknown"
    QCOMPARE(int(cellAt(*cells.sheets().front(), {0.01, 0.01})), int(grids::kUnknownOccupancy));
  }
  void coarserLevelsFollow() {
    RegionCells cells;
    cells.put(piece(700, 500, -3, 8, 0));
    cells.put(piece(40, 900, 5, 5, 100));
    cells.put(piece(300, 100, 4, 20, -1));
    QCOMPARE(cells.sheets().size(), std::size_t(1));
    verifyLevels(*cells.sheets().front(), {-6, 3, 40, 60});
    cells.forget({0, 0, 10, 30});
    verifyLevels(*cells.sheets().front(), {-6, 3, 40, 60});
  }
  void forgettingAllLeavesNothing() {
    RegionCells cells;
    cells.put(piece(1500, 1500, -30, -30, 0));
    QVERIFY(cells.bytes() > 0);
    QVERIFY(cells.forget({-100, -100, 100, 100}));
    QCOMPARE(cells.bytes(), std::size_t(0));
    QVERIFY(cells.sheets().empty());
    QVERIFY(!cells.forget({-100, -100, 100, 100}));
  }
  void turnedPiecesOfOneGridShareASheet() {
    RegionCells cells;
    const geometry::Pose2 grid{3, 4, 0.3};
    const Eigen::Vector2d second = grid.apply({20 * 0.05, 7 * 0.05});
    cells.put(piece(20, 20, 3, 4, 0, 0.3));
    cells.put(piece(20, 20, second.x(), second.y(), 100, 0.3));
    QCOMPARE(cells.sheets().size(), std::size_t(1));
    const Eigen::Vector2d inside = grid.apply({20.5 * 0.05, 7.5 * 0.05});
    QCOMPARE(int(cellAt(*cells.sheets().front(), inside)), 100);
  }
  void otherLatticesHaveSheetsOfTheirOwnAndTheNewestIsSeen() {
    RegionCells cells;
    const std::vector<map::GridPart> pieces{piece(100, 100, 0, 0, 0), piece(100, 100, 1, 1, 100, 0.4),
                                            piece(100, 100, 2, 2, 50, 0, 0.02)};
    for (const map::GridPart& one : pieces) QVERIFY(cells.put(one));
    QCOMPARE(cells.sheets().size(), pieces.size());
    // Wherever a piece lies, no older sheet has anything; at its rim an older cell may reach in.
    for (double x = 0.01; x < 6; x += 0.173) {
      for (double y = 0.01; y < 6; y += 0.173) {
        for (std::size_t newer = 1; newer < pieces.size(); ++newer) {
          const map::GridReference& grid = pieces[newer].grid;
          const Eigen::Vector2d at = grid.origin.inverse().apply({x, y});
          const double most = grid.width * grid.resolution_m - 0.06;
          if (at.minCoeff() < 0.06 || at.maxCoeff() > most) continue;
          for (std::size_t older = 0; older < newer; ++older)
            QCOMPARE(int(cellAt(*cells.sheets()[older], {x, y})), int(kNotFetched));
        }
      }
    }
    QCOMPARE(int(cellAt(*cells.sheets().back(), {2.5, 2.5})), 50);
    cells.put(piece(100, 100, 0, 0, 7));
    QCOMPARE(int(cellAt(*cells.sheets().back(), {2.5, 2.5})), 7);
  }
  void aMapOfManyLatticesKeepsTheNewest() {
    RegionCells cells;
    for (int i = 0; i < 50; ++i) cells.put(piece(10, 10, i * 10.0, 0, 0, i * 0.01));
    QCOMPARE(cells.sheets().size(), RegionCells::kMostSheets);
    QCOMPARE(int(cellAt(*cells.sheets().back(), geometry::Pose2{490, 0, 0.49}.apply({0.1, 0.1}))), 0);
  }
  void whatCannotBePlacedIsNotTaken() {
    RegionCells cells;
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();
    QVERIFY(!cells.put(piece(2, 2, nan, 0, 0)));
    QVERIFY(!cells.put(piece(2, 2, 0, infinity, 0)));
    QVERIFY(!cells.put(piece(2, 2, 0, 0, 0, nan)));
    QVERIFY(!cells.put(piece(2, 2, 0, 0, 0, 0, 0)));
    QVERIFY(!cells.put(piece(2, 2, 0, 0, 0, 0, -1)));
    QVERIFY(!cells.put(piece(2, 2, 0, 0, 0, 0, nan)));
    QVERIFY(!cells.put(piece(2, 2, 1e9, 0, 0)));
    map::GridPart lies = piece(2, 2, 0, 0, 0);
    lies.grid.width = 3;
    QCOMPARE(cells.misfitOf(lies), regions::Misfit::FewerCells);
    lies.grid.width = lies.grid.height = 2'000'000'000;
    QCOMPARE(cells.misfitOf(lies), regions::Misfit::TooLarge);
    lies.grid.width = -5;
    QCOMPARE(cells.misfitOf(lies), regions::Misfit::Unusable);
    lies = piece(2, 2, 0, 0, 0);
    lies.cells.reset();
    QCOMPARE(cells.misfitOf(lies), regions::Misfit::FewerCells);
    QCOMPARE(cells.bytes(), std::size_t(0));
  }
  void anotherFrameIsNotMixedIn() {
    RegionCells cells;
    map::GridPart first = piece(2, 2, 0, 0, 0), second = piece(2, 2, 0, 0, 100);
    first.frame = "map";
    second.frame = "odom";
    QVERIFY(cells.put(first));
    QVERIFY(!cells.put(second));
    second.frame.clear();  // it does not say
    QVERIFY(cells.put(second));
  }
  void extremesArePlaced() {
    RegionCells cells;
    for (const double resolution : {1e-4, 0.05, 999.0}) {
      for (const double far : {-9e6, 0.0, 3.4e6}) {
        map::GridPart part = piece(5, 5, far, -far / 2, 42, 0, resolution);
        const bool placed = cells.put(part);
        // At the very end of the world a sheet has no room.
        QVERIFY(placed || std::abs(far) > 5e6);
        if (!placed) continue;
        const Eigen::Vector2d middle(far + 2.5 * resolution, -far / 2 + 2.5 * resolution);
        if (resolution > 1e-3) QCOMPARE(int(cellAt(*cells.sheets().back(), middle)), 42);
      }
    }
  }

  // Coarser levels are made by who looks, while pieces come.
  void coarserLevelsAreRightWhoeverMakesThem() {
    const auto piece = [](int x, int y, int round) {
      map::GridReference grid{300, 300, 0.05, {x * 15.0, y * 15.0, 0}};
      std::vector<std::int8_t> cells(90'000);
      for (std::size_t i = 0; i < cells.size(); ++i)
        cells[i] = std::int8_t((i / 7 + std::size_t(round * 13)) % 101);
      return std::pair(grid, cells);
    };
    const auto first = piece(0, 0, 0);
    RegionSheet sheet(first.first), other(first.first);
    const int middle = sheet.width() / 2 / 256;
    std::atomic<bool> over = false;
    std::vector<std::thread> readers;
    for (int reader = 0; reader < 3; ++reader) {
      readers.emplace_back([&] {
        while (!over) {
          for (int level = 0; level < sheet.levels(); ++level) {
            for (int at = -2; at < 5; ++at) sheet.tile(level, (middle + at) >> level, (middle - at) >> level);
          }
        }
      });
    }
    for (int round = 0; round < 8; ++round) {
      for (int x = 0; x < 4; ++x) {
        for (int y = 0; y < 4; ++y) {
          const auto [grid, cells] = piece(x, y, round);
          sheet.put(grid, cells);
          if (round == 7) other.put(grid, cells);
        }
      }
    }
    over = true;
    for (std::thread& reader : readers) reader.join();
    QCOMPARE(sheet.bytes(), other.bytes());
    int compared = 0;
    for (int level = 0; level < sheet.levels(); ++level) {
      for (int x = (middle - 8) >> level; x <= (middle + 8) >> level; ++x) {
        for (int y = (middle - 8) >> level; y <= (middle + 8) >> level; ++y) {
          const auto one = sheet.tile(level, x, y), same = other.tile(level, x, y);
          QCOMPARE(one.has_value(), same.has_value());
          compared += one.has_value();
          if (one) QVERIFY(std::equal(one->cells.get(), one->cells.get() + 65'536, same->cells.get()));
        }
      }
    }
    QVERIFY(compared > 20);
  }
};

}  // namespace test_region_sheet

MAPWRIGHT_TEST(test_region_sheet, TestRegionSheet, Nothing)
#include "test_region_sheet.moc"
