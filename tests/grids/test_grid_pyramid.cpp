// The levels of a whole map are those of a plain reference, whatever its size, also while it grows.
#include <atomic>
#include <thread>

#include <QtTest>

#include "grids/grid_pyramid.h"
#include "grids/tile_cache.h"
#include "picture_samples.h"
#include "test_program.h"

namespace test_grid_pyramid {

using namespace mapwright;
using namespace mapwright::grids;

namespace {

struct Plain {
  int width, height;
  std::vector<std::uint8_t> cells;
  std::uint8_t at(int x, int y) const {
    return cells[std::size_t(std::min(y, height - 1)) * std::size_t(width) +
                 std::size_t(std::min(x, width - 1))];
  }
};

std::uint8_t unknownOf(CellCode code) {
  return code == CellCode::Occupancy ? kUnknownOccupancy : kTransparentGray;
}

std::uint8_t winner(CellCode code, const CellMeaning& meaning, const std::uint8_t (&four)[4]) {
  if (code == CellCode::FullGray) return *std::min_element(std::begin(four), std::end(four));
  std::uint8_t best = four[0];
  for (const std::uint8_t cell : four) {
    const bool higher = meaning.rank[cell] > meaning.rank[best];
    if (higher || (meaning.rank[cell] == meaning.rank[best] && cell > best)) best = cell;
  }
  return best;
}

std::uint8_t mean(CellCode code, const CellMeaning& meaning, const std::uint8_t (&four)[4]) {
  int sum = 0, known = 0;
  for (const std::uint8_t cell : four) {
    if (!meaning.known[cell]) continue;
    sum += code == CellCode::Occupancy ? meaning.occupancy[cell] : cell;
    ++known;
  }
  if (known < 2) return unknownOf(code);
  const int rounded = (2 * sum + known) / (2 * known);
  if (code == CellCode::Occupancy || meaning.known[std::size_t(rounded)]) return std::uint8_t(rounded);
  if (code == CellCode::ClearGray) return 127;
  return rounded == 205 ? 204 : rounded < 128 ? 111 : 144;
}

Plain reduced(const Plain& fine, CellCode code, Reduction reduction) {
  const CellMeaning& meaning = meaningOf(code);
  Plain coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x) {
      const std::uint8_t four[4] = {fine.at(2 * x, 2 * y), fine.at(2 * x + 1, 2 * y),
                                    fine.at(2 * x, 2 * y + 1), fine.at(2 * x + 1, 2 * y + 1)};
      coarse.cells.push_back(reduction == Reduction::OccupiedWins ? winner(code, meaning, four)
                                                                  : mean(code, meaning, four));
    }
  }
  return coarse;
}

Plain randomCells(int width, int height, CellCode code) {
  Plain plain{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint32_t dice = test::noise(std::uint32_t(y * 65537 + x));
      const bool calm = (x / 80 + y / 80) % 3 == 0;  // some ground of one value
      plain.cells.push_back(calm ? unknownOf(code) : std::uint8_t(dice));
    }
  }
  return plain;
}

void pushAll(GridBuilder& builder, const Plain& plain, int rows) {
  for (int y = 0; y < rows; ++y) {
    builder.pushRow(
        {plain.cells.data() + std::size_t(y) * std::size_t(plain.width), std::size_t(plain.width)});
  }
}

/// The first cell that differs, as text; empty when none does.
QString difference(const GridPyramid& pyramid, const Plain& level_0) {
  constexpr int kEdge = GridPyramid::kTileEdge;
  Plain plain = level_0;
  for (int level = 0; level < pyramid.levels(); ++level) {
    if (pyramid.levelWidth(level) != plain.width || pyramid.levelHeight(level) != plain.height) {
      return QStringLiteral("size of level %1").arg(level);
    }
    for (int ty = 0; ty * kEdge < plain.height; ++ty) {
      for (int tx = 0; tx * kEdge < plain.width; ++tx) {
        const auto tile = pyramid.tile(level, tx, ty);
        if (!tile) return QStringLiteral("no tile %1 %2 %3").arg(level).arg(tx).arg(ty);
        for (int y = 0; y < kEdge; ++y) {
          for (int x = 0; x < kEdge; ++x) {
            const int column = tx * kEdge + x, row = ty * kEdge + y;
            const bool inside = column < plain.width && row < plain.height;
            const std::uint8_t expected = inside ? plain.at(column, row) : unknownOf(pyramid.code());
            if (tile->cells.get()[y * kEdge + x] != expected) {
              return QStringLiteral("level %1 column %2 row %3: %4 for %5")
                  .arg(level)
                  .arg(column)
                  .arg(row)
                  .arg(tile->cells.get()[y * kEdge + x])
                  .arg(expected);
            }
          }
        }
      }
    }
    plain = reduced(plain, pyramid.code(), pyramid.reduction());
  }
  return {};
}

}  // namespace

class TestGridPyramid : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyLevelIsTheReducedOneBelow_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::newRow("one cell") << 1 << 1;
    QTest::newRow("three rows") << 257 << 3;
    QTest::newRow("one row") << 1300 << 1;
    QTest::newRow("one column") << 1 << 1025;
    QTest::newRow("whole tiles") << 512 << 512;
    QTest::newRow("odd") << 1000 << 999;
    QTest::newRow("a cell more than tiles") << 513 << 769;
  }
  void everyLevelIsTheReducedOneBelow() {
    QFETCH(int, width);
    QFETCH(int, height);
    for (const CellCode code : {CellCode::Gray, CellCode::Occupancy, CellCode::ShadedGray,
                                CellCode::ClearGray, CellCode::FullGray}) {
      const Plain plain = randomCells(width, height, code);
      for (const Reduction reduction : {Reduction::OccupiedWins, Reduction::Average}) {
        const auto builder = buildGrid(width, height, code, reduction);
        pushAll(*builder, plain, height);
        builder->finish();
        QVERIFY(builder->pyramid()->complete());
        QCOMPARE(difference(*builder->pyramid(), plain), QString());
      }
    }
  }

  void rowsThatNeverCameAreUnknownOnEveryLevel_data() {
    QTest::addColumn<int>("came");
    for (const int came : {0, 1, 16, 255, 256, 257, 301, 600, 998}) QTest::addRow("%d", came) << came;
  }
  void rowsThatNeverCameAreUnknownOnEveryLevel() {
    QFETCH(int, came);
    for (const Reduction reduction : {Reduction::OccupiedWins, Reduction::Average}) {
      Plain plain = randomCells(700, 999, CellCode::Gray);
      const auto builder = buildGrid(700, 999, CellCode::Gray, reduction);
      pushAll(*builder, plain, came);
      builder->finish();
      std::fill(plain.cells.begin() + 700 * came, plain.cells.end(), kTransparentGray);
      QVERIFY(builder->pyramid()->complete());
      QCOMPARE(difference(*builder->pyramid(), plain), QString());
    }
  }

  void aWallOfOneCellSurvivesEveryLevel() {
    const auto builder = buildGrid(4000, 3000, CellCode::Gray, Reduction::OccupiedWins);
    std::vector<std::uint8_t> row(4000, 255);
    row[1777] = 0;
    for (int y = 0; y < 3000; ++y) builder->pushRow(row);
    builder->finish();
    const auto pyramid = builder->pyramid();
    for (int level = 0; level < pyramid->levels(); ++level) {
      const int column = 1777 >> level, last_row = pyramid->levelHeight(level) - 1;
      const auto tile = pyramid->tile(level, column / 256, last_row / 256);
      QVERIFY(tile);
      QCOMPARE(int(tile->cells.get()[(last_row % 256) * 256 + column % 256]), 0);
    }
  }

  void rowsShowWhileThePictureGrows() {
    const Plain plain = randomCells(900, 2000, CellCode::Gray);
    const auto builder = buildGrid(900, 2000, CellCode::Gray, Reduction::OccupiedWins);
    const auto pyramid = builder->pyramid();
    QCOMPARE(pyramid->rowsReady(), 0);
    QVERIFY(!pyramid->tile(0, 0, 0));
    std::atomic<bool> wrong{false}, seen_part{false};
    std::thread looker([&] {
      while (!pyramid->complete()) {
        const int rows = pyramid->rowsReady();
        if (rows == 0) continue;
        seen_part = seen_part || rows < 2000;
        const int row = rows - 1;
        for (int column = 0; column < 900; column += 37) {
          if (pyramid->at(column, row) != plain.at(column, row)) wrong = true;
        }
        // A coarser level has the rows that follow from these.
        const int coarse = (rows >> 3) - 1;
        if (coarse >= 0 && !pyramid->tile(3, 0, coarse / 256)) wrong = true;
      }
    });
    pushAll(*builder, plain, 100);
    QTRY_COMPARE(pyramid->rowsReady(), 64);  // what is not a whole strip waits
    QVERIFY(!pyramid->complete());
    QVERIFY(pyramid->tile(0, 3, 0));
    QVERIFY(!pyramid->tile(0, 0, 1));
    for (int y = 100; y < 2000; ++y) {
      builder->pushRow({plain.cells.data() + std::size_t(y) * 900, 900});
    }
    builder->finish();
    looker.join();
    QVERIFY(!wrong);
    QVERIFY(seen_part);
    QCOMPARE(difference(*pyramid, plain), QString());
  }

  void aBuilderMayBeGivenUp() {
    auto builder = buildGrid(5000, 5000, CellCode::Gray, Reduction::OccupiedWins);
    const auto pyramid = builder->pyramid();
    const std::vector<std::uint8_t> row(5000, 200);
    for (int y = 0; y < 700; ++y) builder->pushRow(row);
    builder.reset();
    QVERIFY(!pyramid->complete());
    QVERIFY(pyramid->rowsReady() > 0 && pyramid->rowsReady() <= 700);
  }

  void emptyGroundCostsNextToNothing() {
    const auto builder = buildGrid(20'000, 20'000, CellCode::Occupancy, Reduction::OccupiedWins);
    const std::vector<std::uint8_t> row(20'000, kUnknownOccupancy);
    for (int y = 0; y < 20'000; ++y) builder->pushRow(row);
    builder->finish();
    QVERIFY2(builder->pyramid()->bytes() < 1'000'000,
             qPrintable(QString::number(builder->pyramid()->bytes())));
    const auto a = builder->pyramid()->tile(0, 3, 3), b = builder->pyramid()->tile(2, 7, 1);
    QVERIFY(a && b && a->uniform && b->uniform);
    QCOMPARE(a->cells.get(), b->cells.get());
  }

  void placesOutsideAreNoTiles() {
    const auto builder = buildGrid(300, 300, CellCode::Gray, Reduction::OccupiedWins);
    builder->finish();
    const auto pyramid = builder->pyramid();
    QCOMPARE(pyramid->levels(), 2);
    QVERIFY(!pyramid->tile(-1, 0, 0));
    QVERIFY(!pyramid->tile(2, 0, 0));
    QVERIFY(!pyramid->tile(0, 2, 0));
    QVERIFY(!pyramid->tile(0, 0, -1));
    QCOMPARE(int(pyramid->at(-1, 0)), int(kTransparentGray));
    QCOMPARE(int(pyramid->at(0, 300)), int(kTransparentGray));
  }

  void pyramidsShareWhatIsKeptUnpacked() {
    const auto unpacked = std::make_shared<TileCache>(16 * TileCache::kTileBytes);
    QCOMPARE(unpacked->budget(), 16 * TileCache::kTileBytes);
    const auto pyramidOf = [&](int salt) {
      const auto builder =
          buildGrid(1500, 1500, CellCode::Gray, Reduction::OccupiedWins, {nullptr, unpacked});
      std::vector<std::uint8_t> row(1500);
      for (int y = 0; y < 1500; ++y) {
        for (int x = 0; x < 1500; ++x) row[std::size_t(x)] = std::uint8_t((x * 7 + y * 13 + salt) / 5);
        builder->pushRow(row);
      }
      builder->finish();
      return builder->pyramid();
    };
    const auto lookAtAll = [](const GridPyramid& pyramid) {
      for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 6; ++x) QVERIFY(pyramid.tile(0, x, y));
      }
    };
    auto first = pyramidOf(0), second = pyramidOf(1);
    const std::size_t before = first->bytes();
    lookAtAll(*first);
    QCOMPARE(unpacked->bytes(), unpacked->budget());
    QCOMPARE(first->bytes() - before, unpacked->budget());
    lookAtAll(*second);
    QCOMPARE(unpacked->bytes(), unpacked->budget());  // at the cost of the first
    QCOMPARE(first->bytes(), before);
    QCOMPARE(int(*(*first->tile(0, 0, 0)).cells), 0);  // each has its own cells
    QCOMPARE(int((*second->tile(0, 0, 0)).cells.get()[4]), (4 * 7 + 1) / 5);
    second.reset();
    QCOMPARE(unpacked->bytes(), TileCache::kTileBytes);  // what is left is the first's
    first.reset();
    QCOMPARE(unpacked->bytes(), std::size_t(0));
  }
};

}  // namespace test_grid_pyramid

MAPWRIGHT_TEST(test_grid_pyramid, TestGridPyramid, Core)
#include "test_grid_pyramid.moc"
