// The tiles of one raster layer: kept up to date, drawn where they belong.
#include <QPainter>
#include <QTest>

#include "grids.h"
#include "grids/grid_pyramid.h"
#include "render/grid_palettes.h"
#include "render/grid_renderer.h"
#include "test_program.h"
#include "work/workers.h"

namespace test_grid_renderer {

using namespace mapwright;
using render::GridRenderer;
using test::gridOf;

namespace {

constexpr int kPatienceMs = 60'000;  // the threads that make tiles stand back on a machine that is busy

geometry::ViewTransform viewAt(double x, double y, double scale, int width = 400, int height = 300) {
  geometry::ViewTransform view;
  view.center_m = {x, y};
  view.scale_m_per_px = scale;
  view.width_px = width;
  view.height_px = height;
  return view;
}

QImage painted(GridRenderer& renderer, int width = 400, int height = 300) {
  QImage image(width, height, QImage::Format_ARGB32_Premultiplied);
  image.fill(0);
  QPainter painter(&image);
  const auto drawing = renderer.drawing();
  for (const auto* tiles : {&drawing.stand_ins, &drawing.tiles}) {
    for (const render::DrawnTile& tile : *tiles) {
      painter.setTransform(tile.to_viewport);
      painter.drawImage(0, 0, tile.image);
    }
  }
  return image;
}

}  // namespace

class GridRendererTest : public QObject {
  Q_OBJECT
  GridRenderer renderer_{
      GridRenderer::Options{.workers = std::make_shared<work::Workers>(2), .previews = false}};
  const render::GridPalette palette_ = render::wholeMapPalette(render::MapColors{}, grids::CellCode::Gray);

 private Q_SLOTS:
  void init() {
    renderer_.setPalette(palette_);
    renderer_.setGrid(std::nullopt);
  }

  void nothingIsShownWithoutAGrid() {
    renderer_.setView(viewAt(0, 0, 0.05));
    QVERIFY(renderer_.settled());
    QCOMPARE(painted(renderer_).pixel(200, 150), 0u);
  }

  void cellsAppearWhereTheyLie() {
    renderer_.setView(viewAt(5, 5, 0.05));
    renderer_.setGrid(gridOf(100, 100, 0.05, {2.5, 2.5, 0}, [](int u, int) { return u < 50 ? 255 : 0; }));
    QTRY_VERIFY(renderer_.settled());
    const QImage image = painted(renderer_);
    QCOMPARE(image.pixel(200 - 25, 150), 0xffffffff);
    QCOMPARE(image.pixel(200 + 25, 150), 0xff15181c);
    QCOMPARE(image.pixel(200 - 60, 150), 0u);  // outside the grid
  }

  void unknownCellsAreTransparent() {
    renderer_.setView(viewAt(2.5, 2.5, 0.05));
    renderer_.setGrid(gridOf(100, 100, 0.05, {0, 0, 0}, [](int, int) { return 128; }));
    QTRY_VERIFY(renderer_.settled());
    QCOMPARE(painted(renderer_).pixel(200, 150), 0u);
  }

  void aNewGridTakesThePlaceOfTheOld() {
    renderer_.setView(viewAt(2.5, 2.5, 0.05));
    renderer_.setGrid(gridOf(100, 100, 0.05, {0, 0, 0}, [](int, int) { return 255; }));
    QTRY_VERIFY(renderer_.settled());
    renderer_.setGrid(gridOf(100, 100, 0.05, {0, 0, 0}, [](int, int) { return 0; }));
    QVERIFY(!renderer_.settled());
    QCOMPARE(painted(renderer_).pixel(200, 150), 0xffffffff);  // the old one until the new is there
    QTRY_VERIFY(renderer_.settled());
    QCOMPARE(painted(renderer_).pixel(200, 150), 0xff15181c);
    renderer_.setGrid(std::nullopt);
    QCOMPARE(painted(renderer_).pixel(200, 150), 0u);
  }

  void renderersKeepNoMoreThanTheirBudgetTogether() {
    const auto budget = std::make_shared<render::TileBudget>();
    budget->bytes = 12 << 20;
    const auto placed = gridOf(600, 600, 0.5, {0, 0, 0}, [](int u, int v) { return (u + v) % 200; });
    {
      GridRenderer first({.budget = budget}), second({.budget = budget});
      for (GridRenderer* renderer : {&first, &second}) {
        renderer->setPalette(palette_);
        renderer->setGrid(placed);
      }
      for (int step = 0; step < 12; ++step) {
        for (GridRenderer* renderer : {&first, &second}) {
          renderer->setView(viewAt(20 + 20 * step, 150, 0.05));
          QTRY_VERIFY_WITH_TIMEOUT(renderer->settled(), kPatienceMs);
        }
      }
      constexpr std::size_t kInView = 4 << 20;  // at most, of one; that goes beyond it for a while
      QVERIFY(first.cacheBytes() > 0 && second.cacheBytes() > 0);
      QVERIFY(budget->held > 0 && budget->held <= budget->bytes + kInView);
      QVERIFY(first.cacheBytes() + second.cacheBytes() <= budget->bytes + 2 * kInView);
      // What is hidden keeps no more than it would need to be shown again.
      const std::size_t shown = first.cacheBytes();
      first.setActive(false);
      QTRY_VERIFY(first.cacheBytes() < shown);
    }
    QCOMPARE(budget->held, std::size_t(0));
  }

  void rowsAppearAsTheyAreRead() {
    const auto builder = grids::buildGrid(300, 600, grids::CellCode::Gray, grids::Reduction::OccupiedWins);
    renderer_.setView(viewAt(7.5, 15, 0.1, 400, 400));
    renderer_.setGrid(render::PlacedGrid{builder->pyramid(), {300, 600, 0.05, {0, 0, 0}}});
    QTRY_VERIFY(renderer_.settled());
    const std::vector<std::uint8_t> row(300, 255);
    for (int v = 0; v < 600; ++v) builder->pushRow(row);
    builder->finish();
    renderer_.rowsArrived();
    QVERIFY(!renderer_.settled());
    QTRY_VERIFY(renderer_.settled());
    QCOMPARE(painted(renderer_, 400, 400).pixel(200, 200), 0xffffffff);
    QCOMPARE(painted(renderer_, 400, 400).pixel(200, 349), 0xffffffff);
  }

  void aWindowLooksQuicklyAndThenExactly() {
    const auto placed = gridOf(1800, 1400, 0.05, {0, 0, 0}, [](int u, int v) {
      return (u * 7919 + v * 104729 + u * v * 31) % 97 == 0 ? 0 : 255;
    });
    for (const double rotation : {0.0, 0.4}) {
      geometry::ViewTransform view = viewAt(45, 35, 0.21);
      view.rotation_rad = rotation;
      GridRenderer window(GridRenderer::Options{.workers = std::make_shared<work::Workers>(1)});
      window.setPalette(palette_);
      window.setView(view);
      window.setGrid(placed);
      bool seen_before_settled = false;
      connect(&window, &GridRenderer::tilesChanged, &window, [&] {
        if (!window.settled() && window.drawing().tiles.size() >= 4) seen_before_settled = true;
      });
      QTRY_VERIFY_WITH_TIMEOUT(window.settled(), kPatienceMs);
      QVERIFY(seen_before_settled);
      // The raster of a window is anchored at the world's origin, so its picture is compared through it.
      const Eigen::Vector2d origin = view.pixelFromWorld({0, 0});
      render::PixelGrid pixels;
      pixels.scale_m_per_px = 0.21;
      pixels.rotation_rad = rotation;
      pixels.first_column = -std::int64_t(std::round(origin.x()));
      pixels.first_row = -std::int64_t(std::round(origin.y()));
      pixels.width_px = 400;
      pixels.height_px = 300;
      const render::Composition exact = render::sampleGrid(pixels, placed, nullptr);
      const QImage image = painted(window);
      int differ = 0;
      for (int row = 0; row < 300; ++row) {
        for (int column = 0; column < 400; ++column) {
          const std::size_t at = std::size_t(row * 400 + column);
          differ += image.pixel(column, row) != (exact.flags[at] ? palette_[exact.intensity[at]] : 0);
        }
      }
      QCOMPARE(differ, 0);
      const render::Composition quick = render::sampleGrid(pixels, placed, nullptr, render::Sampling::Quick);
      QVERIFY(quick.intensity != exact.intensity);
    }
  }

  void aWindowIsSettledWithWhatHasBeenReadAndExactWhenAllHas() {
    const auto builder = grids::buildGrid(900, 1200, grids::CellCode::Gray, grids::Reduction::OccupiedWins);
    GridRenderer window(GridRenderer::Options{.workers = std::make_shared<work::Workers>(2)});
    window.setPalette(palette_);
    window.setView(viewAt(22.5, 30, 0.4));
    window.setGrid(render::PlacedGrid{builder->pyramid(), {900, 1200, 0.05, {0, 0, 0}}});
    const std::vector<std::uint8_t> row(900, 255);
    for (int v = 0; v < 600; ++v) builder->pushRow(row);
    window.rowsArrived();
    QTRY_VERIFY_WITH_TIMEOUT(window.settled(), kPatienceMs);
    for (int v = 600; v < 1200; ++v) builder->pushRow(row);
    builder->finish();
    window.rowsArrived();
    QTRY_VERIFY_WITH_TIMEOUT(window.settled(), kPatienceMs);
    QCOMPARE(painted(window).pixel(200, 150 + 70), 0xffffffff);
  }

  void meansOfBlackAndWhiteHaveAColourBetweenThem() {
    renderer_.setView(viewAt(12.8, 12.8, 0.4));
    renderer_.setGrid(gridOf(
        512, 512, 0.05, {0, 0, 0}, [](int u, int) { return u % 2 == 0 ? 0 : 255; },
        grids::Reduction::Average));
    QTRY_VERIFY_WITH_TIMEOUT(renderer_.settled(), kPatienceMs);
    const QColor shown(painted(renderer_).pixelColor(200, 150));
    QCOMPARE(shown.alpha(), 255);
    QVERIFY2(std::abs(shown.red() - (0x15 + 0xff) / 2) <= 2, qPrintable(shown.name()));
  }

  void anotherPaletteRecoloursWhatIsThere() {
    renderer_.setView(viewAt(2.5, 2.5, 0.05));
    renderer_.setGrid(gridOf(100, 100, 0.05, {0, 0, 0}, [](int, int) { return 255; }));
    QTRY_VERIFY(renderer_.settled());
    render::MapColors dark;
    dark.free = 0xffd9dee4;
    renderer_.setPalette(render::wholeMapPalette(dark, grids::CellCode::Gray));
    QCOMPARE(painted(renderer_).pixel(200, 150), 0xffd9dee4);
  }

  void whatIsSwitchedOffMakesNothing() {
    renderer_.setActive(false);
    renderer_.setView(viewAt(2.5, 2.5, 0.05));
    renderer_.setGrid(gridOf(100, 100, 0.05, {0, 0, 0}, [](int, int) { return 255; }));
    QVERIFY(renderer_.settled());
    renderer_.setActive(true);
    QTRY_VERIFY(renderer_.settled() && painted(renderer_).pixel(200, 150) == 0xffffffff);
  }

  void costsOfEitherPolarityShowObstacles() {
    for (const int background : {0, 255}) {
      const render::GridPalette palette = render::costmapPalette(std::uint8_t(background));
      QCOMPARE(qAlpha(palette[std::size_t(background)]), 0);
      QVERIFY(qAlpha(palette[std::size_t(255 - background)]) > 150);
      QVERIFY(qRed(palette[std::size_t(255 - background)]) > qGreen(palette[std::size_t(255 - background)]));
      QVERIFY(qAlpha(palette[127]) > 0 &&
              qAlpha(palette[127]) < qAlpha(palette[std::size_t(255 - background)]));
    }
  }

  void costsOfOccupancyAreWarmerTheHigherTheyAre() {
    const render::GridPalette palette = render::occupancyCostPalette();
    for (const std::size_t clear : {0, 128, 255}) QCOMPARE(palette[clear], 0u);
    for (std::size_t cost = 1; cost <= 100; ++cost) {
      QVERIFY(qAlpha(palette[cost]) > 0 && qRed(palette[cost]) > qBlue(palette[cost]));
      if (cost > 1) QVERIFY(qAlpha(palette[cost]) >= qAlpha(palette[cost - 1]));
    }
    // What the robot must not touch, and where its centre must not be, stand out of all the others.
    const auto unlike = [&](std::size_t a, std::size_t b) {
      return std::abs(qRed(palette[a]) - qRed(palette[b])) + std::abs(qBlue(palette[a]) - qBlue(palette[b])) >
             40;
    };
    QVERIFY(unlike(99, 98) && unlike(100, 99) && unlike(100, 98));
  }
};

}  // namespace test_grid_renderer

MAPWRIGHT_TEST(test_grid_renderer, GridRendererTest, Widgets)
#include "test_grid_renderer.moc"
