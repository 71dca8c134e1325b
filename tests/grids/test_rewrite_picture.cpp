// A picture is written anew so that whoever reads it by its map.yaml gets the wanted cells, and no pixel
// becomes another without need.
#include <QtTest>

#include "grids/faults.h"
#include "grids/grid_cells.h"
#include "grids/rewrite_picture.h"
#include "picture_samples.h"
#include "test_program.h"

namespace test_rewrite_picture {

using namespace mapwright;
using namespace mapwright::grids;
using map::CellReading;
using Mode = CellReading::Mode;

namespace {

constexpr std::uint8_t kFree = 0, kOccupied = 100, kUnknown = kUnknownOccupancy;

std::shared_ptr<const GridPyramid> gridOf(int width, int height, CellCode code,
                                          const std::function<std::uint8_t(int, int)>& cell) {
  const auto builder = buildGrid(width, height, code, Reduction::OccupiedWins);
  std::vector<std::uint8_t> row(static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) row[std::size_t(x)] = cell(x, y);
    builder->pushRow(row);
  }
  builder->finish();
  return builder->pyramid();
}

std::shared_ptr<const GridPyramid> read(const QString& path, const CellReading& reading) {
  GridOptions options;
  options.reading = reading;
  auto opened = openGridFile(path.toStdString(), options);
  if (!opened) return nullptr;
  const std::atomic<bool> cancelled{false};
  if ((*opened)->read(cancelled, {})) return nullptr;
  return (*opened)->pyramid();
}

CellReading readingOf(Mode mode, bool negate = false) {
  CellReading reading;
  reading.mode = mode;
  reading.negate = negate;
  return reading;
}

std::vector<int> cellsOf(const GridPyramid& grid) {
  std::vector<int> cells;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) cells.push_back(grid.at(x, y));
  }
  return cells;
}

}  // namespace

class TestRewritePicture : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<QTemporaryDir> folder_;
  QString path(const char* name) const { return folder_->filePath(QLatin1String(name)); }
  QString written(const char* name, const std::string& bytes) const {
    QFile file(path(name));
    if (!file.open(QIODevice::WriteOnly)) return {};
    file.write(bytes.data(), qint64(bytes.size()));
    return file.fileName();
  }
  static QByteArray content(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

 private Q_SLOTS:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void pixelsThatReadRightStayAsTheyAre() {
    // 250 and 230 are free, 10 is occupied, 150 unknown by the usual thresholds.
    const QString file = written("map.pgm", "P5\n# by hand\n3 2\n255\n\xfa\xe6\x0a\x96\xfa\xfa");
    const CellReading reading = readingOf(Mode::Trinary);
    const auto wanted = gridOf(3, 2, CellCode::Occupancy, [](int x, int y) {
      return y == 1 && x == 1   ? kOccupied
             : y == 1 && x == 2 ? kUnknown
             : x == 2           ? kOccupied
             : y == 1           ? kUnknown
                                : kFree;
    });
    QCOMPARE(rewritePicture(*wanted, file.toStdString(), reading), std::nullopt);
    QCOMPARE(content(file).right(6), QByteArray("\xfa\xe6\x0a\x96\x00\xcd", 6));
    QCOMPARE(cellsOf(*read(file, reading)), cellsOf(*wanted));
  }

  void everyReadingComesBack_data() {
    QTest::addColumn<int>("mode");
    QTest::addColumn<bool>("negate");
    QTest::addColumn<double>("free_thresh");
    QTest::newRow("trinary") << int(Mode::Trinary) << false << 0.196;
    QTest::newRow("trinary, wide") << int(Mode::Trinary) << false << 0.25;
    QTest::newRow("trinary, negated") << int(Mode::Trinary) << true << 0.196;
    QTest::newRow("raw") << int(Mode::Raw) << false << 0.196;
  }
  void everyReadingComesBack() {
    QFETCH(int, mode);
    QFETCH(bool, negate);
    QFETCH(double, free_thresh);
    CellReading reading = readingOf(Mode(mode), negate);
    reading.free_thresh = free_thresh;
    const auto wanted = gridOf(300, 270, CellCode::Occupancy, [](int x, int y) {
      const std::uint32_t dice = test::noise(std::uint32_t(y * 1'000 + x)) % 3;
      return dice == 0 ? kFree : dice == 1 ? kOccupied : kUnknown;
    });
    const std::string blank(300 * 270, char(254));
    const QString pgm = written("a.pgm", "P5\n300 270\n255\n" + blank);
    QCOMPARE(rewritePicture(*wanted, pgm.toStdString(), reading), std::nullopt);
    QCOMPARE(cellsOf(*read(pgm, reading)), cellsOf(*wanted));
    const QString png = written("a.png", test::png({300, 270}, test::Samples(300 * 270, 254)));
    QCOMPARE(rewritePicture(*wanted, png.toStdString(), reading), std::nullopt);
    QCOMPARE(cellsOf(*read(png, reading)), cellsOf(*wanted));
  }

  void unknownIsTransparentWhereNoShadeIs() {
    const CellReading scale = readingOf(Mode::Scale);
    const auto wanted =
        gridOf(2, 1, CellCode::Occupancy, [](int x, int) { return x == 0 ? kUnknown : kFree; });
    QVERIFY(holdsUnknown(scale, CellCode::Occupancy, "map.png"));
    QVERIFY(!holdsUnknown(scale, CellCode::Occupancy, "map.pgm"));
    QVERIFY(holdsUnknown(readingOf(Mode::Trinary), CellCode::Occupancy, "map.pgm"));
    const QString png = written("s.png", test::png({2, 1}, {254, 254}));
    QCOMPARE(rewritePicture(*wanted, png.toStdString(), scale), std::nullopt);
    QCOMPARE(cellsOf(*read(png, scale)), cellsOf(*wanted));
    const QString pgm = written("s.pgm", "P5\n2 1\n255\n\xfe\xfe");
    const QByteArray before = content(pgm);
    QVERIFY(rewritePicture(*wanted, pgm.toStdString(), scale));
    QCOMPARE(content(pgm), before);
  }

  void grayPicturesKeepTheirGrays() {
    const CellReading picture = readingOf(Mode::Picture);
    const auto wanted =
        gridOf(4, 1, CellCode::Gray, [](int x, int) { return std::uint8_t(x == 0 ? 0 : 60 * x); });
    const QString file = written("g.pgm", "P5\n4 1\n255\n\xff\x3c\x78\xb4");
    QCOMPARE(rewritePicture(*wanted, file.toStdString(), picture), std::nullopt);
    QCOMPARE(content(file).right(4), QByteArray("\x00\x3c\x78\xb4", 4));
  }

  void transparentGroundStaysTransparent() {
    const CellReading picture = readingOf(Mode::Picture);
    const auto wanted = gridOf(2, 1, CellCode::ClearGray,
                               [](int x, int) { return x == 0 ? kTransparentGray : std::uint8_t(9); });
    test::PngRecipe recipe{2, 1};
    recipe.colour_type = 4;
    const QString file = written("t.png", test::png(recipe, {7, 0, 255, 255}));
    QCOMPARE(rewritePicture(*wanted, file.toStdString(), picture), std::nullopt);
    const QImage image(file);
    QVERIFY(image.hasAlphaChannel());
    QCOMPARE(qAlpha(image.pixel(0, 0)), 0);
    QCOMPARE(qGray(image.pixel(1, 0)), 9);
  }

  void whatCannotBeWrittenIsLeftAsItIs() {
    const auto wanted = gridOf(2, 1, CellCode::Occupancy, [](int, int) { return kFree; });
    const CellReading reading = readingOf(Mode::Trinary);
    const QString bmp = written("m.bmp", "BM not really");
    QVERIFY(rewritePicture(*wanted, bmp.toStdString(), reading));
    QCOMPARE(content(bmp), QByteArray("BM not really"));
    const QString other = written("o.pgm", "P5\n3 1\n255\n\xfe\xfe\xfe");
    QCOMPARE(rewritePicture(*wanted, other.toStdString(), reading)->code, grids::fault::PictureOfOtherSize);
    QVERIFY(rewritePicture(*wanted, path("gone.pgm").toStdString(), reading));
    QVERIFY(!QFileInfo::exists(path("gone.pgm")));
    QVERIFY(canRewrite("a/MAP.PGM") && canRewrite("x.png") && !canRewrite("x.bmp") && !canRewrite("png"));
  }
};

}  // namespace test_rewrite_picture

MAPWRIGHT_TEST(test_rewrite_picture, TestRewritePicture, Core)
#include "test_rewrite_picture.moc"
