// Robots that read a map that we wrote see the walls that we show.
#include <random>
#include <set>

#include <QtTest>

#include "grids/export_grid.h"
#include "grids/grid_pyramid.h"
#include "served_map.h"
#include "test_program.h"

namespace test_map_server_export {

using namespace mapwright;
using namespace mapwright::grids;
using Mode = MapServerForm::Mode;
using test::AmclCell;
using test::CostmapCell;
using test::MapServer;

namespace {

constexpr MapServer kServers[] = {MapServer::Nav2, MapServer::Nav2Later, MapServer::Ros1};

struct RandomMap {
  CellCode code = CellCode::Occupancy;
  int width = 0, height = 0;
  std::vector<std::uint8_t> cells;
  std::shared_ptr<const GridPyramid> grid;

  int percent(std::size_t n) const { return meaningOf(code).occupancy[cells[n]]; }
};

/// Of three values, of a few, or of all that the code has.
RandomMap randomMap(std::mt19937& dice, CellCode code) {
  RandomMap map;
  map.code = code;
  map.width = int(1 + dice() % 60);
  map.height = int(1 + dice() % 60);
  std::vector<std::uint8_t> values;
  const auto kind = dice() % 4;
  if (kind == 0) {
    const bool gray = isGray(code);
    values = {std::uint8_t(gray ? 0 : 100), std::uint8_t(gray ? 255 : 0), unknownByte(code)};
  } else {
    const std::size_t count = kind == 1 ? 3 + dice() % 8 : 300;
    for (std::size_t n = 0; n < count; ++n) values.push_back(std::uint8_t(dice()));
  }
  const auto builder = buildGrid(map.width, map.height, code, Reduction::OccupiedWins);
  for (int y = 0; y < map.height; ++y) {
    std::vector<std::uint8_t> row;
    for (int x = 0; x < map.width; ++x) row.push_back(values[dice() % values.size()]);
    builder->pushRow(row);
    map.cells.insert(map.cells.end(), row.begin(), row.end());
  }
  builder->finish();
  map.grid = builder->pyramid();
  return map;
}

map::GridReference placeOf(const RandomMap& map) { return {map.width, map.height, 0.05, {-1, 2, 0}}; }

}  // namespace

class TestMapServerExport : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void robotsSeeWhatIsShown() {
    std::mt19937 dice(32);
    for (int round = 0; round < 100; ++round) {
      const auto code = CellCode(round % kCellCodes);
      const RandomMap map = randomMap(dice, code);
      const QString yaml = folder_->filePath(QStringLiteral("map.yaml"));
      const auto seen = writeMapServer(*map.grid, placeOf(map), yaml.toStdString());
      QVERIFY(seen && seen->whole());
      for (const MapServer server : kServers) {
        const auto served = test::servedMap(yaml, server);
        QVERIFY(served && served->width == map.width && served->height == map.height);
        QCOMPARE(served->mode, QStringLiteral("trinary"));
        QCOMPARE(served->occupied_thresh, 0.65);
        QCOMPARE(served->free_thresh, 0.196);
        for (std::size_t n = 0; n < map.cells.size(); ++n) {
          const int percent = map.percent(n), cell = served->cells[n];
          QCOMPARE(test::amclCell(cell), percent < 0     ? AmclCell::Unknown
                                         : percent >= 50 ? AmclCell::Occupied
                                                         : AmclCell::Free);
          QCOMPARE(test::costmapCell(cell), percent < 0     ? CostmapCell::NoInformation
                                            : percent >= 50 ? CostmapCell::Lethal
                                                            : CostmapCell::Free);
        }
      }
    }
  }

  void thePictureKeepsItsShades() {
    std::mt19937 dice(33);
    for (int round = 0; round < 50; ++round) {
      const auto code = CellCode(round % kCellCodes);
      const RandomMap map = randomMap(dice, code);
      const QString yaml = folder_->filePath(QStringLiteral("map.yaml"));
      QVERIFY(writeMapServer(*map.grid, placeOf(map), yaml.toStdString()));
      const auto served = test::servedMap(yaml, MapServer::Nav2);
      std::map<int, std::set<int>> shades;  // by percent
      for (std::size_t n = 0; n < map.cells.size(); ++n) shades[map.percent(n)].insert(served->grays[n]);
      int lightest = 256;
      for (const auto& [percent, grays] : shades) {
        if (percent < 0) continue;
        QVERIFY2(*grays.rbegin() < lightest || isGray(code),
                 qPrintable(QStringLiteral("%1 % is as light as less").arg(percent)));
        QVERIFY(*grays.rbegin() <= lightest);
        lightest = *grays.begin();
      }
    }
  }

  void scaleAndRawGivePercentages() {
    std::mt19937 dice(34);
    for (int round = 0; round < 60; ++round) {
      const RandomMap map = randomMap(dice, CellCode(round % kCellCodes));
      const Mode mode = round % 2 == 0 ? Mode::Scale : Mode::Raw;
      const QString yaml = folder_->filePath(QStringLiteral("map.yaml"));
      const auto seen = writeMapServer(*map.grid, placeOf(map), yaml.toStdString(), {.mode = mode});
      QVERIFY(seen);
      for (const MapServer server : {MapServer::Nav2, MapServer::Nav2Later}) {
        const auto served = test::servedMap(yaml, server);
        QVERIFY(served);
        std::int64_t walls = 0, seen_walls = 0;
        for (std::size_t n = 0; n < map.cells.size(); ++n) {
          QCOMPARE(served->cells[n], map.percent(n));
          walls += map.percent(n) >= 50;
          seen_walls += test::amclCell(served->cells[n]) == AmclCell::Occupied;
        }
        QCOMPARE(seen->shown.occupied, walls);
        QCOMPARE(seen->walls, seen_walls);
      }
    }
  }

  void wallsThatThresholdsLoseAreCounted() {
    std::mt19937 dice(35);
    std::uniform_real_distribution<double> any(0, 1);
    for (int round = 0; round < 200; ++round) {
      const RandomMap map = randomMap(dice, CellCode(round % kCellCodes));
      const double one = any(dice), two = any(dice);
      const MapServerForm form{.mode = round % 3 == 0 ? Mode::Scale : Mode::Trinary,
                               .occupied_thresh = std::max(one, two),
                               .free_thresh = std::min(one, two)};
      if (flawOf(form)) continue;
      const QString yaml = folder_->filePath(QStringLiteral("map.yaml"));
      const auto seen = writeMapServer(*map.grid, placeOf(map), yaml.toStdString(), form);
      QVERIFY(seen);
      const auto served = test::servedMap(yaml, MapServer::Nav2);
      QVERIFY(served);
      QCOMPARE(served->occupied_thresh, *form.occupied_thresh);
      QCOMPARE(served->free_thresh, *form.free_thresh);
      SeenByRobots counted;
      for (std::size_t n = 0; n < map.cells.size(); ++n) {
        const int percent = map.percent(n);
        const AmclCell cell = test::amclCell(served->cells[n]);
        if (percent < 0) {
          QCOMPARE(served->cells[n], -1);
          ++counted.shown.unknown;
        } else if (percent >= 50) {
          ++counted.shown.occupied;
          counted.walls += cell == AmclCell::Occupied;
          counted.walls_as_free += cell == AmclCell::Free;
        } else {
          ++counted.shown.free;
          counted.free += cell == AmclCell::Free;
        }
        if (percent >= 0)  // the shade is the probability
          QVERIFY(std::abs((255 - served->grays[n]) / 2.55 - percent) < 1.01);
      }
      QVERIFY(seen->shown == counted.shown);
      QCOMPARE(seen->walls, counted.walls);
      QCOMPARE(seen->free, counted.free);
      QCOMPARE(seen->walls_as_free, counted.walls_as_free);
    }
  }

  void twoFilesStayAPairIfOneOfTheirNamesIsTaken() {
    std::mt19937 dice(36);
    const RandomMap map = randomMap(dice, CellCode::Occupancy);
    for (const char* taken : {"map.pgm", "map.yaml"}) {
      init();
      const QString other = folder_->filePath(QLatin1String(taken));
      const auto appears = [&](double done) {
        QFile file(other);
        return done < 1 || (file.open(QIODevice::WriteOnly) && file.write("another's") == 9);
      };
      const auto written =
          writeMapServer(*map.grid, placeOf(map), folder_->filePath(QStringLiteral("map.yaml")).toStdString(),
                         {}, appears, disk::Existing::Refuse);
      QVERIFY2(!written, taken);
      QFile kept(other);
      QVERIFY(kept.open(QIODevice::ReadOnly) && kept.readAll() == "another's");
      const bool picture = other.endsWith(QLatin1String("pgm"));
      const auto served = test::servedMap(
          folder_->filePath(QLatin1String(picture ? "map.yaml" : "map-1.yaml")), MapServer::Nav2);
      QVERIFY2(served && served->width == map.width && served->height == map.height, taken);
    }
  }

  void thresholdsWithoutRoomForUnknownAreRefused() {
    const auto refused = [](double occupied, double free) {
      return flawOf({.occupied_thresh = occupied, .free_thresh = free}).has_value();
    };
    QVERIFY(!flawOf({}));
    QVERIFY(!refused(0.65, 0.196));
    QVERIFY(!refused(1, 0));
    QVERIFY(refused(0.5, 0.5));
    QVERIFY(refused(0.2, 0.8));
    QVERIFY(refused(0.501, 0.499));  // no gray level lies between them
    QVERIFY(refused(1.5, 0.2));
    QVERIFY(refused(0.5, -0.1));
    QVERIFY(refused(std::nan(""), 0.1));
    QVERIFY(!flawOf({.mode = Mode::Raw}));
  }

 private:
  std::unique_ptr<QTemporaryDir> folder_;
};

}  // namespace test_map_server_export

MAPWRIGHT_TEST(test_map_server_export, TestMapServerExport, Core)
#include "test_map_server_export.moc"
