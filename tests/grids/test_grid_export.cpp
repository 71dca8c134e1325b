// What is exported reads back to the same cells.
#include <cmath>

#include <QtTest>

#include "grids/export_grid.h"
#include "grids/grid_pyramid.h"
#include "picture_samples.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_grid_export {

using namespace mapwright;
using namespace mapwright::grids;
using map::CellReading;

namespace {

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

std::shared_ptr<const GridPyramid> readBack(const QString& path, CellReading::Mode mode) {
  GridOptions options;
  options.reading.mode = mode;
  auto opened = openGridFile(path.toStdString(), options);
  if (!opened) return nullptr;
  const std::atomic<bool> cancelled{false};
  if ((*opened)->read(cancelled, {})) return nullptr;
  return (*opened)->pyramid();
}

bool same(const GridPyramid& a, const GridPyramid& b) {
  if (a.width() != b.width() || a.height() != b.height() || a.code() != b.code()) return false;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      if (a.at(x, y) != b.at(x, y)) return false;
    }
  }
  return true;
}

std::uint8_t trinaryCell(int x, int y) {
  const std::uint32_t dice = test::noise(std::uint32_t(y * 1000 + x)) % 3;
  return dice == 0 ? 0 : dice == 1 ? 100 : kUnknownOccupancy;
}
std::uint8_t percentCell(int x, int y) {
  const std::uint32_t dice = test::noise(std::uint32_t(y * 1000 + x)) % 102;
  return dice == 101 ? kUnknownOccupancy : std::uint8_t(dice);
}

QString textOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

map::GridReference somewhere() {
  map::GridReference reference;
  reference.width = 300;
  reference.height = 200;
  reference.resolution_m = 0.05;
  reference.origin = {-12.3, 1.0 / 3, 0.1};
  return reference;
}

}  // namespace

class TestGridExport : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }
  void cleanup() { folder_.reset(); }

  void grayPngsReadBackWithTheSameMeaning_data() {
    QTest::addColumn<CellCode>("code");
    QTest::newRow("three shades") << CellCode::Gray;
    QTest::newRow("many shades and unknown ground") << CellCode::ShadedGray;
    QTest::newRow("all shades") << CellCode::FullGray;
    QTest::newRow("all shades and transparent ground") << CellCode::ClearGray;
  }
  void grayPngsReadBackWithTheSameMeaning() {
    QFETCH(CellCode, code);
    const auto grid = gridOf(700, 601, code, [code](int x, int y) {
      const std::uint32_t dice = test::noise(std::uint32_t(x * 997 + y));
      if (x < 200 && code != CellCode::FullGray) return std::uint8_t(code == CellCode::Gray ? 205 : 128);
      return code == CellCode::Gray ? std::uint8_t(dice % 9 == 0 ? 0 : 254) : std::uint8_t(dice);
    });
    const QString path = folder_->filePath(QStringLiteral("gray.png"));
    double last = -1;
    const auto problem = writeGridPng(*grid, path.toStdString(), [&](double done) {
      const bool forward = done >= last;
      last = done;
      return forward;
    });
    QVERIFY2(!problem, problem ? qPrintable(sentences::sentenceOf(*problem)) : "");
    QCOMPARE(last, 1.0);
    const auto back = readBack(path, CellReading::Mode::Picture);
    QVERIFY(back && same(*grid, *back));
  }

  void trinaryPngsReadBackWithMapSaversShades() {
    const auto grid = gridOf(300, 200, CellCode::Occupancy, trinaryCell);
    const QString path = folder_->filePath(QStringLiteral("map.png"));
    QVERIFY(!writeGridPng(*grid, path.toStdString()));
    const auto back = readBack(path, CellReading::Mode::Trinary);
    QVERIFY(back && same(*grid, *back));
  }

  void percentPngsShowUnknownAsTransparent() {
    const auto grid = gridOf(300, 200, CellCode::Occupancy, percentCell);
    const QString path = folder_->filePath(QStringLiteral("map.png"));
    QVERIFY(!writeGridPng(*grid, path.toStdString()));
    const auto back = readBack(path, CellReading::Mode::Picture);
    QVERIFY(back);
    const CellMeaning& meaning = meaningOf(CellCode::Occupancy);
    for (int x = 0; x < 300; ++x) {
      const std::uint8_t cell = grid->at(x, 100);
      QCOMPARE(int(back->at(x, 100)),
               cell == kUnknownOccupancy ? int(kTransparentGray) : int(meaning.intensity[cell]));
    }
  }

  void mapServerReadsTrinaryBack() {
    const auto grid = gridOf(300, 200, CellCode::Occupancy, trinaryCell);
    for (const char* name : {"a", "b.pgm", "c.yaml", "d.e"}) {
      const QString path = folder_->filePath(QString::fromUtf8(name));
      QVERIFY(writeMapServer(*grid, somewhere(), path.toStdString()));
    }
    const QStringList written{QStringLiteral("a.pgm"),   QStringLiteral("a.yaml"),  QStringLiteral("b.pgm"),
                              QStringLiteral("b.yaml"),  QStringLiteral("c.pgm"),   QStringLiteral("c.yaml"),
                              QStringLiteral("d.e.pgm"), QStringLiteral("d.e.yaml")};
    QCOMPARE(QDir(folder_->path()).entryList(QDir::Files, QDir::Name), written);
    const auto back = readBack(folder_->filePath(QStringLiteral("a.pgm")), CellReading::Mode::Trinary);
    QVERIFY(back && same(*grid, *back));
    const QString yaml = textOf(folder_->filePath(QStringLiteral("c.yaml")));
    QVERIFY(yaml.contains(QStringLiteral("image: \"c.pgm\"\nmode: trinary\n")));
  }

  void stoppingLeavesNothingBehind() {
    const auto grid = gridOf(300, 900, CellCode::Occupancy, percentCell);
    int calls = 0;
    const auto stop = [&calls](double) { return ++calls < 3; };
    QVERIFY(writeGridPng(*grid, folder_->filePath(QStringLiteral("x.png")).toStdString(), stop));
    calls = 0;
    QVERIFY(
        !writeMapServer(*grid, somewhere(), folder_->filePath(QStringLiteral("x")).toStdString(), {}, stop));
    QVERIFY(QDir(folder_->path()).entryList(QDir::Files).isEmpty());
  }

  void whatCannotBeWrittenIsASentence() {
    const auto grid = gridOf(3, 3, CellCode::Gray, [](int, int) { return std::uint8_t(0); });
    const auto png = writeGridPng(*grid, "/nowhere/at/all.png");
    QVERIFY(png &&
            sentences::sentenceOf(*png).startsWith(QLatin1String("/nowhere/at/all.png cannot be written: ")));
    QVERIFY(!writeMapServer(*grid, somewhere(), "/nowhere/at/all.yaml"));
  }

  void numbersSurviveYaml() {
    map::GridReference reference = somewhere();
    const std::string text = mapYamlText(reference, "a \"map\".pgm", {CellReading::Mode::Trinary});
    QCOMPARE(text, std::string("image: \"a \\\"map\\\".pgm\"\nmode: trinary\nresolution: 0.05\n"
                               "origin: [-12.3, 0.3333333333333333, 0.1]\nnegate: 0\n"
                               "occupied_thresh: 0.65\nfree_thresh: 0.196\n"));
    reference.resolution_m = 1e-4 / 3;
    reference.origin = {1e7, -0.0, 1e-7};
    const std::string odd = mapYamlText(reference, "m", {CellReading::Mode::Raw});
    QVERIFY2(odd.find("resolution: 0.000033333333333333335\n") != std::string::npos, odd.c_str());
    QVERIFY2(odd.find("origin: [10000000.0, -0.0, 1.0e-07]") != std::string::npos, odd.c_str());
  }

  void aWorldFileHasTheCentreOfTheTopLeftPixel() {
    const map::GridReference reference = somewhere();
    const QStringList lines = QString::fromStdString(worldFileText(reference)).split(QLatin1Char('\n'));
    QCOMPARE(lines.size(), 7);
    const double a = lines[0].toDouble(), d = lines[1].toDouble(), b = lines[2].toDouble(),
                 e = lines[3].toDouble();
    const double c = lines[4].toDouble(), f = lines[5].toDouble();
    for (const auto& [column, row] : {std::pair{0, 0}, {299, 0}, {0, 199}, {123, 45}}) {
      const Eigen::Vector2d expected = reference.worldFromCell({column + 0.5, row + 0.5});
      QVERIFY(std::abs(a * column + b * row + c - expected.x()) < 1e-9);
      QVERIFY(std::abs(d * column + e * row + f - expected.y()) < 1e-9);
    }
  }

 private:
  std::unique_ptr<QTemporaryDir> folder_;
};

}  // namespace test_grid_export

MAPWRIGHT_TEST(test_grid_export, TestGridExport, Core)
#include "test_grid_export.moc"
