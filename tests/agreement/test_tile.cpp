// One tile against a plain reading of every cell, and what a cell of a texture says.
#include <cmath>

#include <QtTest>

#include "agreement/tile.h"
#include "submaps.h"
#include "test_program.h"

namespace test_tile {

using namespace mapwright;
using namespace mapwright::testing;
using agreement::Reading;
using agreement::Tile;
using agreement::TileKey;
using agreement::TileTask;

namespace {

Tile made(const std::vector<PlacedTexture>& submaps, const Rules& rules, TileKey key = {0, 0}) {
  render::DenseCache cache;
  return *agreement::makeTile(TileTask{key, rules, submaps, 1}, cache);
}

/// As Cartographer writes a probability.
CellPair cellOf(double p) {
  const auto logit = [](double of) { return std::log(of / (1 - of)); };
  const int k = int(std::lround((logit(p) - logit(0.1)) * 254 / (logit(0.9) - logit(0.1)))) + 1;
  const int delta = 128 - k;
  if (delta == 0) return {0, 1};
  return delta > 0 ? CellPair{std::uint8_t(delta), 0} : CellPair{0, std::uint8_t(-delta)};
}

}  // namespace

class TestTile : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void readsProbabilitiesAsCartographerWroteThem();
  void readsOpaqueGraysAsOccupancy();
  void findsWhatAPlainReadingFinds();
  void aWallWithinTheToleranceIsTheSameWall();
  void aSubmapNeverContradictsItself();
  void aWallBeyondTheTileCounts();
  void countsUpToManySubmaps();
  void canBeCancelled();
};

void TestTile::readsProbabilitiesAsCartographerWroteThem() {
  for (int v = 1; v <= 32'767; ++v) {
    const double p = 0.1 + (v - 1) * 0.8 / 32'766;
    const Reading reading = agreement::readingOf(cellOf(p));
    QVERIFY(reading != Reading::Unseen);
    if (p > 0.6015) QCOMPARE(reading, Reading::Occupied);
    if (p < 0.3985) QCOMPARE(reading, Reading::Free);
    if (p > 0.4 && p < 0.6) QCOMPARE(reading, Reading::Undecided);
  }
  QCOMPARE(agreement::readingOf({0, 24}), Reading::Occupied);  // k = 152
  QCOMPARE(agreement::readingOf({0, 23}), Reading::Undecided);
  QCOMPARE(agreement::readingOf({24, 0}), Reading::Free);
  QCOMPARE(agreement::readingOf({23, 0}), Reading::Undecided);
  QCOMPARE(agreement::readingOf({0, 0}), Reading::Unseen);
}

void TestTile::readsOpaqueGraysAsOccupancy() {
  QCOMPARE(agreement::readingOf({0, 255}), Reading::Occupied);
  QCOMPARE(agreement::readingOf({255, 255}), Reading::Free);
  QCOMPARE(agreement::readingOf({128, 255}), Reading::Undecided);
  QCOMPARE(agreement::readingOf({100, 255}), Reading::Occupied);
  QCOMPARE(agreement::readingOf({160, 255}), Reading::Free);
}

void TestTile::findsWhatAPlainReadingFinds() {
  std::uint64_t all_contradicted = 0;
  for (unsigned seed = 1; seed <= 24; ++seed) {
    const Rules rules{seed % 3 == 0 ? 0.08 : 0.05, std::vector{0, 1, 4, 7}[seed % 4]};
    // Over the corner where four tiles meet.
    const auto submaps = someSubmaps(seed, 0, 0, 6);
    const PlainReading expected = plainReading(submaps, rules);
    std::uint64_t seen = 0, occupied = 0, contradicted = 0;
    PlainReading found;
    for (const TileKey key : {TileKey{0, 0}, TileKey{-1, 0}, TileKey{0, -1}, TileKey{-1, -1}}) {
      const Tile tile = made(submaps, rules, key);
      for (int row = 0; row < agreement::kTileCells; ++row) {
        for (int column = 0; column < agreement::kTileCells; ++column) {
          const Cell cell{key.column * agreement::kTileCells + column, key.row * agreement::kTileCells + row};
          if (tile.seenBy(column, row) > 0) found.seen_by[cell] = tile.seenBy(column, row);
          if (tile.isOccupied(column, row)) found.occupied.insert(cell);
          if (tile.isContradicted(column, row)) found.contradicted.insert(cell);
        }
      }
      seen += tile.seen_cells, occupied += tile.occupied_cells, contradicted += tile.contradicted_cells;
      for (const auto& [square, findings] : tile.squares) {
        auto& [cells, ids] = found.squares[{square.x, square.y}];
        cells += int(findings.cells);
        for (const agreement::Part& part : findings.submaps) {
          ids[part.id].first += part.occupied;
          ids[part.id].second += part.free;
        }
        QVERIFY(std::is_sorted(findings.submaps.begin(), findings.submaps.end(),
                               [](const auto& a, const auto& b) { return a.id < b.id; }));
      }
    }
    QCOMPARE(seen, expected.seen_by.size());
    QCOMPARE(occupied, expected.occupied.size());
    QCOMPARE(contradicted, expected.contradicted.size());
    all_contradicted += contradicted;
    QVERIFY(found.seen_by == expected.seen_by);
    QVERIFY(found.occupied == expected.occupied);
    QVERIFY(found.contradicted == expected.contradicted);
    QVERIFY(found.squares == expected.squares);
  }
  QVERIFY2(all_contradicted > 500, qPrintable(QString::number(all_contradicted)));
}

void TestTile::aWallWithinTheToleranceIsTheSameWall() {
  const auto sees = [](int wall_at) {  // a wall of one cell on free ground, at this column
    std::vector<CellPair> cells(20 * 20, kFree);
    cells[std::size_t(10 * 20 + wall_at)] = kWall;
    return cells;
  };
  for (const int away : {1, 4, 5}) {
    const std::vector<PlacedTexture> two{submap(1, 1, 1, 20, 20, sees(5)),
                                         submap(2, 1, 1, 20, 20, sees(5 + away))};
    QCOMPARE(made(two, {0.05, 4}).contradicted_cells, std::uint64_t(away > 4 ? 2 : 0));
    QCOMPARE(made(two, {0.05, 1}).contradicted_cells, std::uint64_t(away > 1 ? 2 : 0));
    QCOMPARE(made(two, {0.05, 0}).contradicted_cells, std::uint64_t(2));
  }
}

void TestTile::aSubmapNeverContradictsItself() {
  const auto submaps = someSubmaps(3, 3, 3, 1);
  const Tile tile = made(submaps, {0.05, 0});
  QVERIFY(tile.occupied_cells > 0);
  QCOMPARE(tile.contradicted_cells, std::uint64_t(0));
}

void TestTile::aWallBeyondTheTileCounts() {
  // The second submap saw the first one's wall 3 cells farther left, in the next tile.
  const double edge = agreement::kTileCells * 0.05;
  std::vector<CellPair> cells(10, kFree);
  cells[0] = kWall;
  const std::vector<PlacedTexture> two{plain(1, edge + 2 * 0.05, 1, 1, 1, kWall),
                                       submap(2, edge - 0.05, 1, 10, 1, cells)};
  QCOMPARE(made(two, {0.05, 4}, {1, 0}).contradicted_cells, std::uint64_t(0));
  QCOMPARE(made(two, {0.05, 2}, {1, 0}).contradicted_cells, std::uint64_t(1));
}

void TestTile::countsUpToManySubmaps() {
  std::vector<PlacedTexture> many;
  for (int index = 0; index < 300; ++index) many.push_back(plain(index, 1, 1, index < 7 ? 2 : 1, 1, kMaybe));
  const Tile tile = made(many, {});
  QCOMPARE(int(tile.seenBy(20, 20)), 255);
  QCOMPARE(int(tile.seenBy(21, 20)), 7);
  QCOMPARE(tile.seen_cells, std::uint64_t(2));
}

void TestTile::canBeCancelled() {
  render::DenseCache cache;
  const std::atomic<bool> cancelled = true;
  QVERIFY(!agreement::makeTile(TileTask{{0, 0}, {}, {plain(1, 1, 1, 2, 2, kWall)}, 1}, cache, &cancelled));
}

}  // namespace test_tile

MAPWRIGHT_TEST(test_tile, TestTile, Core)
#include "test_tile.moc"
