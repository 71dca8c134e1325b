// Disagreement and coverage as they are painted, against a reading of the tiles pixel by pixel.
#include <cmath>
#include <random>
#include <set>

#include <QImage>
#include <QPainter>
#include <QTest>

#include "agreement/survey.h"
#include "render/tile_renderer.h"
#include "test_program.h"
#include "ui/scene/map_scene.h"
#include "ui/scene/map_theme.h"

namespace test_agreement_layer {

using namespace mapwright;
using namespace mapwright::ui::scene;
using agreement::kTileCells;
using agreement::Tile;
using agreement::TileKey;

namespace {

constexpr double kCellM = 0.05;
constexpr int kWidth = 200, kHeight = 150;

/// Column and row in the lattice.
struct Cell {
  int column, row;
};

class Tiles {
 public:
  Tile& at(TileKey key) {
    auto& tile = tiles_[key];
    if (!tile) tile = std::make_shared<Tile>();
    return *tile;
  }
  void see(Cell cell, int by) {
    Tile& tile = at(keyOf(cell));
    tile.seen_by[std::size_t(within(cell.row) * kTileCells + within(cell.column))] = std::uint8_t(by);
    ++tile.seen_cells;
  }
  void contradict(Cell cell) {
    Tile& tile = at(keyOf(cell));
    const int column = within(cell.column);
    tile.contradicted[std::size_t(within(cell.row) * Tile::kWords + column / 64)] |= std::uint64_t(1)
                                                                                     << (column % 64);
    ++tile.contradicted_cells;
    tile.squares[{int(std::floor((cell.column + 0.5) * kCellM)), int(std::floor((cell.row + 0.5) * kCellM))}]
        .cells += 1;
  }
  std::shared_ptr<const agreement::Tiles> made() const {
    return std::make_shared<agreement::Tiles>(tiles_.begin(), tiles_.end());
  }

 private:
  static int within(int cell) { return cell & (kTileCells - 1); }
  static TileKey keyOf(Cell cell) { return {cell.column >> 8, cell.row >> 8}; }

  std::map<TileKey, std::shared_ptr<Tile>> tiles_;
};

class Desk {
 public:
  explicit Desk(Layer layer) : scene(exact()) {
    for (const Layer each : allLayers()) scene.setLayerVisible(each, each == layer);
    look({{0, 0}, kCellM / 4, 0, kWidth, kHeight});
  }
  static render::TileRenderer::Options exact() {
    render::TileRenderer::Options options;
    options.previews = false;
    return options;
  }
  void look(const geometry::ViewTransform& view) { scene.setView(view); }
  QImage painted(const QRect& part = {0, 0, kWidth, kHeight}) {
    QImage image(part.size(), QImage::Format_RGB32);
    QPainter painter(&image);
    scene.render(&painter, QRectF(QPointF(0, 0), part.size()), part);
    return image;
  }
  QRgb bad() const { return scene.theme().bad.rgb(); }
  QRgb ground() const { return scene.theme().map.unknown; }
  MapScene scene;
};

std::set<QRgb> colorsIn(const QImage& image) {
  std::set<QRgb> colors;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) colors.insert(image.pixel(x, y));
  }
  return colors;
}

}  // namespace

class AgreementLayerTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aPixelShowsTheCellBelowItsMiddle() {
    std::mt19937 dice(7);
    std::set<std::pair<int, int>> contradicted;
    Tiles tiles;
    // Around a corner of four tiles.
    for (int i = 0; i < 400; ++i) {
      const Cell cell{int(dice() % 60) - 30, int(dice() % 60) - 30};
      if (contradicted.emplace(cell.column, cell.row).second) tiles.contradict(cell);
    }
    Desk desk(Layer::Disagreement);
    desk.scene.setAgreement(tiles.made(), kCellM);
    for (const double rotation : {0.0, 0.3, 2.0, -1.2}) {
      const geometry::ViewTransform view{{0.013, -0.021}, kCellM / 3.3, rotation, kWidth, kHeight};
      desk.look(view);
      const QImage image = desk.painted();
      int red = 0;
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          const Eigen::Vector2d at = view.worldFromPixel({x + 0.5, y + 0.5}) / kCellM;
          const bool wanted = contradicted.contains({int(std::floor(at.x())), int(std::floor(at.y()))});
          QCOMPARE(image.pixel(x, y), wanted ? desk.bad() : desk.ground());
          red += wanted ? 1 : 0;
        }
      }
      QVERIFY(red > 500);
    }
  }

  void aSingleCellIsSeenHoweverFarAway() {
    std::mt19937 dice(11);
    std::uniform_real_distribution<double> share(0, 1);
    Desk desk(Layer::Disagreement);
    for (int i = 0; i < 300; ++i) {
      const Cell cell{int(dice() % 2000) - 1000, int(dice() % 2000) - 1000};
      Tiles tiles;
      tiles.contradict(cell);
      desk.scene.setAgreement(tiles.made(), kCellM);
      // From 4 pixels a cell to 100 tiles a pixel.
      const double scale = kCellM / 4 * std::pow(100'000, share(dice));
      const Eigen::Vector2d at(cell.column * kCellM, cell.row * kCellM);
      desk.look({at + Eigen::Vector2d(share(dice), share(dice)) * scale, scale, 6.3 * share(dice), kWidth,
                 kHeight});
      QVERIFY2(colorsIn(desk.painted()).contains(desk.bad()), qPrintable(QString::number(scale)));
    }
  }

  void aPartIsPaintedAsTheWhole() {
    Tiles tiles;
    std::mt19937 dice(3);
    for (int row = -300; row < 300; ++row) {
      for (int column = -300; column < 300; ++column) tiles.see({column, row}, int(dice() % 4));
    }
    Desk desk(Layer::Coverage);
    desk.scene.setAgreement(tiles.made(), kCellM);
    for (const double scale : {0.02, 0.11, 0.5}) {
      desk.look({{0.4, 0.3}, scale, 0.7, kWidth, kHeight});
      const QRect part(31, 17, 90, 70);
      QCOMPARE(desk.painted(part), desk.painted().copy(part));
    }
  }

  void whatWasSeenOnceIsHatched() {
    Tiles tiles;
    for (int row = 0; row < 20; ++row) {
      for (int column = -20; column < 20; ++column) tiles.see({column, row}, column < 0 ? 1 : 5);
    }
    Desk desk(Layer::Coverage);
    desk.scene.setAgreement(tiles.made(), kCellM);
    const QImage image = desk.painted();
    // A pixel is a quarter of a cell: 80 x 75 of both, below them nothing.
    const QImage once = image.copy(22, 2, 76, 70);
    const std::set<QRgb> hatched = colorsIn(once);
    QCOMPARE(hatched.size(), std::size_t(2));
    int darker = 0;
    const QRgb line =
        qGray(*hatched.begin()) < qGray(*hatched.rbegin()) ? *hatched.begin() : *hatched.rbegin();
    for (int y = 0; y < once.height(); ++y) {
      for (int x = 0; x < once.width(); ++x) darker += once.pixel(x, y) == line ? 1 : 0;
    }
    QVERIFY(std::abs(4 * darker - once.width() * once.height()) < 300);
    const std::set<QRgb> often = colorsIn(image.copy(102, 2, 76, 70));
    QCOMPARE(often.size(), std::size_t(1));
    QVERIFY(!hatched.contains(*often.begin()) && *often.begin() != desk.ground());
    QCOMPARE(colorsIn(image.copy(0, 80, kWidth, 60)), std::set<QRgb>{desk.ground()});
  }

  void zoomedOutTheMeanOfWhatWasSeenIsShown() {
    Tiles tiles, mean;
    for (int row = 0; row < 64; ++row) {
      for (int column = 0; column < 64; ++column) {
        if ((row + column) % 2 == 0) tiles.see({column, row}, column % 4 < 2 ? 2 : 14);
        mean.see({column, row}, 8);
      }
    }
    Desk desk(Layer::Coverage);
    desk.look({{1.6, 1.6}, 0.1, 0, kWidth, kHeight});
    desk.scene.setAgreement(tiles.made(), kCellM);
    const QImage image = desk.painted();
    desk.scene.setAgreement(mean.made(), kCellM);
    QCOMPARE(image, desk.painted());
    QVERIFY(image.pixel(kWidth / 2, kHeight / 2) != desk.ground());
  }

  void whatIsGoneIsNoLongerPainted() {
    Tiles tiles;
    tiles.contradict({0, 0});
    Desk desk(Layer::Disagreement);
    desk.scene.setAgreement(tiles.made(), kCellM);
    QVERIFY(colorsIn(desk.painted()).contains(desk.bad()));
    Tiles other;
    other.contradict({5, 0});
    desk.scene.setAgreement(other.made(), kCellM);
    const QImage image = desk.painted();
    QCOMPARE(image.pixel(kWidth / 2 + 1, kHeight / 2 - 2), desk.ground());
    QCOMPARE(image.pixel(kWidth / 2 + 21, kHeight / 2 - 2), desk.bad());
    desk.scene.setAgreement(nullptr, 0);
    QCOMPARE(colorsIn(desk.painted()), std::set<QRgb>{desk.ground()});
  }

  void theLayerReachesAsFarAsItsPlaces() {
    Tiles tiles;
    tiles.contradict({25, -1});
    tiles.see({25, -1}, 2);
    Desk desk(Layer::Disagreement);
    QVERIFY(desk.scene.layerBounds(Layer::Disagreement).empty());
    desk.scene.setAgreement(tiles.made(), kCellM);
    QCOMPARE(desk.scene.layerBounds(Layer::Disagreement), (geometry::WorldRect{1, -1, 2, 0}));
    QCOMPARE(desk.scene.layerBounds(Layer::Coverage), (geometry::WorldRect{0, -12.8, 12.8, 0}));
  }

  void aChosenColourIsUsed() {
    Tiles tiles;
    tiles.contradict({0, 0});
    Desk desk(Layer::Disagreement);
    desk.scene.setAgreement(tiles.made(), kCellM);
    desk.scene.setLayerStyle(Layer::Disagreement, {QColor(1, 2, 250), 0, 0});
    QVERIFY(colorsIn(desk.painted()).contains(qRgb(1, 2, 250)));
  }
};

}  // namespace test_agreement_layer

MAPWRIGHT_TEST(test_agreement_layer, AgreementLayerTest, Widgets)
#include "test_agreement_layer.moc"
