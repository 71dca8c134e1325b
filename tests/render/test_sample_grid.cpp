// Occupancy grids in the pixels of a view.
#include <cmath>

#include <QTest>

#include "cells/cell_texture.h"
#include "grids.h"
#include "grids/grid_pyramid.h"
#include "render/compose_grid.h"
#include "render/dense_cache.h"
#include "render/faults.h"
#include "render/sample_grid.h"
#include "test_program.h"

namespace test_sample_grid {

using namespace mapwright;
using render::Composition;
using render::Difference;
using render::PixelGrid;
using test::gridOf;

namespace {

constexpr int kFree = 255, kOccupied = 0, kUnknown = 128;

PixelGrid windowAt(const Eigen::Vector2d& top_left, double scale, double rotation, int width, int height) {
  PixelGrid grid;
  grid.origin_m = top_left;
  grid.scale_m_per_px = scale;
  grid.rotation_rad = rotation;
  grid.width_px = width;
  grid.height_px = height;
  return grid;
}

int noise(int u, int v) { return (u * 7919 + v * 104729 + u * v * 31) & 255; }

/// The byte that a pixel no larger than a cell has to show; -1 outside.
int nearest(const PixelGrid& pixels, const render::PlacedGrid& placed, int column, int row) {
  const Eigen::Vector2d cell = placed.reference.cellFromWorld(pixels.worldFromPixel(column + 0.5, row + 0.5));
  const double u = std::floor(cell.x()), v = std::floor(cell.y());
  if (u < 0 || v < 0 || u >= placed.reference.width || v >= placed.reference.height) return -1;
  return placed.cells->at(int(u), int(v));
}

int shown(const Composition& pixels, int column, int row) {
  const std::size_t at = std::size_t(row) * std::size_t(pixels.width_px) + std::size_t(column);
  return pixels.flags[at] ? pixels.intensity[at] : -1;
}

}  // namespace

class SampleGridTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void oneCellAPixelShowsEveryCellAsItIs() {
    const auto placed = gridOf(300, 270, 0.05, {-3.2, 7.45, 0}, noise);
    const PixelGrid pixels = windowAt(placed.reference.worldFromCell({0, 0}), 0.05, 0, 300, 270);
    const Composition made = render::sampleGrid(pixels, placed, nullptr);
    for (int row = 0; row < 270; ++row) {
      for (int column = 0; column < 300; ++column) QCOMPARE(shown(made, column, row), noise(column, row));
    }
  }

  void turnedOriginsAndTurnedViewsShowTheCellUnderThePixel_data() {
    QTest::addColumn<double>("yaw");
    QTest::addColumn<double>("rotation");
    QTest::addColumn<double>("scale");
    QTest::newRow("origin turned") << 0.3 << 0.0 << 0.05;
    QTest::newRow("origin a quarter turn") << M_PI / 2 << 0.0 << 0.05;
    QTest::newRow("both turned, magnified") << -1.1 << 0.7 << 0.013;
    QTest::newRow("view turned") << 0.0 << 2.5 << 0.05;
  }
  void turnedOriginsAndTurnedViewsShowTheCellUnderThePixel() {
    QFETCH(double, yaw);
    QFETCH(double, rotation);
    QFETCH(double, scale);
    const auto placed = gridOf(280, 260, 0.05, {100.02, -50.03, yaw}, noise);
    PixelGrid pixels = windowAt(placed.reference.worldFromCell({140, 130}), scale, rotation, 320, 300);
    pixels.first_column = -150;
    pixels.first_row = -150;
    const Composition made = render::sampleGrid(pixels, placed, nullptr);
    int inside = 0;
    for (int row = 0; row < 300; ++row) {
      for (int column = 0; column < 320; ++column) {
        const int expected = nearest(pixels, placed, column, row);
        inside += expected >= 0;
        QCOMPARE(shown(made, column, row), expected);
      }
    }
    QVERIFY(inside > 1000);
  }

  void aWallOfOneCellStaysVisibleHoweverFarOut_data() {
    QTest::addColumn<double>("zoom");
    for (const double zoom : {1.5, 2.0, 3.0, 7.3, 16.0, 100.0})
      QTest::addRow("%g cells a pixel", zoom) << zoom;
  }
  void aWallOfOneCellStaysVisibleHoweverFarOut() {
    QFETCH(double, zoom);
    const auto placed =
        gridOf(1000, 900, 0.05, {0, 0, 0}, [](int u, int) { return u == 517 ? kOccupied : kFree; });
    const int width = int(std::ceil(1000 / zoom)), height = int(std::ceil(900 / zoom));
    const PixelGrid pixels = windowAt(placed.reference.worldFromCell({0, 0}), 0.05 * zoom, 0, width, height);
    const Composition made = render::sampleGrid(pixels, placed, nullptr);
    for (int row = 0; row + 1 < height; ++row) {
      int occupied = 0;
      for (int column = 0; column < width; ++column) occupied += shown(made, column, row) == kOccupied;
      QVERIFY2(occupied >= 1 && occupied <= 3, qPrintable(QString::number(occupied)));
    }
  }

  void everyPixelThatTouchesAWallShowsItWhereverThePixelsLie_data() {
    QTest::addColumn<double>("zoom");
    QTest::addColumn<double>("offset");
    for (const double zoom : {2.0, 3.0, 4.0, 7.9}) {
      for (const double offset : {0.0, 0.003, 0.02, 0.049}) {
        QTest::addRow("%g cells a pixel, %g m aside", zoom, offset) << zoom << offset;
      }
    }
  }
  void everyPixelThatTouchesAWallShowsItWhereverThePixelsLie() {
    QFETCH(double, zoom);
    QFETCH(double, offset);
    const auto placed = gridOf(200, 200, 0.05, {0, 0, 0},
                               [](int u, int v) { return u % 23 == 5 || v % 31 == 8 ? kOccupied : kFree; });
    const PixelGrid pixels = windowAt(
        placed.reference.worldFromCell({0, 0}) + Eigen::Vector2d(offset, -offset), 0.05 * zoom, 0, 24, 24);
    const Composition made = render::sampleGrid(pixels, placed, nullptr);
    for (int row = 0; row < 24; ++row) {
      for (int column = 0; column < 24; ++column) {
        const Eigen::Vector2d from = placed.reference.cellFromWorld(pixels.worldFromPixel(column, row));
        const Eigen::Vector2d to = placed.reference.cellFromWorld(pixels.worldFromPixel(column + 1, row + 1));
        bool touched = false, near = false;
        for (int v = int(std::floor(from.y())) - int(zoom); v <= int(std::ceil(to.y())) + int(zoom); ++v) {
          for (int u = int(std::floor(from.x())) - int(zoom); u <= int(std::ceil(to.x())) + int(zoom); ++u) {
            if (u < 0 || v < 0 || u >= 200 || v >= 200 || placed.cells->at(u, v) != kOccupied) continue;
            near = true;
            touched |=
                u + 1 > from.x() + 1e-6 && u < to.x() - 1e-6 && v + 1 > from.y() + 1e-6 && v < to.y() - 1e-6;
          }
        }
        const int cell = shown(made, column, row);
        if (touched) QCOMPARE(cell, kOccupied);
        if (!near && cell >= 0) QCOMPARE(cell, kFree);
      }
    }
  }

  void exactSamplingKnowsNoLevels() {
    const auto coarse =
        gridOf(40, 30, 0.05, {1, 2, 0}, [](int u, int v) { return noise(u, v) < 90 ? 0 : 255; });
    const auto fine =
        gridOf(200, 150, 0.01, {1, 2, 0}, [](int u, int v) { return noise(u / 5, v / 5) < 90 ? 0 : 255; });
    const PixelGrid pixels = windowAt(coarse.reference.worldFromCell({0, 0}), 0.05, 0, 40, 30);
    const Composition a = render::sampleGrid(pixels, coarse, nullptr);
    const Composition b = render::sampleGrid(pixels, fine, nullptr);
    QVERIFY(a.intensity == b.intensity);
    QVERIFY(a.flags == b.flags);
  }

  void averagingIsAnOption() {
    const auto placed = gridOf(
        64, 64, 0.05, {0, 0, 0}, [](int u, int) { return u % 4 == 0 ? kOccupied : kFree; },
        grids::Reduction::Average);
    const PixelGrid pixels = windowAt(placed.reference.worldFromCell({0, 0}), 0.2, 0, 16, 16);
    const Composition made = render::sampleGrid(pixels, placed, nullptr);
    QVERIFY(std::abs(shown(made, 5, 5) - 191) <= 1);
  }

  void whatIsOutsideOrUnusableShowsNothing() {
    auto placed = gridOf(10, 10, 0.05, {0, 0, 0}, noise);
    const PixelGrid away = windowAt({50, 50}, 0.05, 0, 8, 8);
    QCOMPARE(shown(render::sampleGrid(away, placed, nullptr), 3, 3), -1);
    placed.reference.resolution_m = 0;
    QCOMPARE(shown(render::sampleGrid(windowAt({0, 0.5}, 0.05, 0, 8, 8), placed, nullptr), 3, 3), -1);
  }

  void differencesSayWhatCameAndWhatWent() {
    const auto cells = [](std::vector<int> row) {
      return [row = std::move(row)](int u, int) { return row[std::size_t(u)]; };
    };
    const auto first =
        gridOf(7, 1, 1, {0, 0, 0}, cells({kFree, kOccupied, kFree, kOccupied, kFree, kUnknown, kUnknown}));
    const auto second =
        gridOf(7, 1, 1, {0, 0, 0}, cells({kFree, kOccupied, kOccupied, kFree, kUnknown, kFree, kUnknown}));
    const Composition made = render::compareGrids(windowAt({0, 1}, 1, 0, 7, 1), first, second, nullptr);
    const std::vector<Difference> expected{
        Difference::SameFree,  Difference::SameOccupied, Difference::Appeared, Difference::Vanished,
        Difference::OnlyFirst, Difference::OnlySecond,   Difference::None};
    for (int i = 0; i < 7; ++i) QCOMPARE(shown(made, i, 0), int(expected[std::size_t(i)]));
  }

  void differencesOfMapsWithOtherOriginsLieWhereTheyBelong() {
    const auto first = gridOf(20, 20, 0.1, {0, 0, 0}, [](int, int) { return kFree; });
    // The same ground, described from another corner at twice the resolution, with one obstacle at (1.5,
    // 0.5).
    const auto second = gridOf(40, 40, 0.05, {2, 0, M_PI / 2}, [](int u, int v) {
      return u >= 10 && u < 12 && v >= 30 && v < 32 ? kOccupied : kFree;
    });
    const Composition made = render::compareGrids(windowAt({0, 2}, 0.1, 0, 20, 20), first, second, nullptr);
    int appeared = 0;
    for (int row = 0; row < 20; ++row) {
      for (int column = 0; column < 20; ++column) {
        if (shown(made, column, row) == int(Difference::Appeared)) {
          ++appeared;
          const Eigen::Vector2d world(column * 0.1 + 0.05, 2 - row * 0.1 - 0.05);
          const Eigen::Vector2d cell = second.reference.cellFromWorld(world);
          QVERIFY(second.cells->at(int(cell.x()), int(cell.y())) == kOccupied);
        }
      }
    }
    QCOMPARE(appeared, 1);
  }

  void submapsComposeIntoOneGrid() {
    // 40 x 40 cells of 5 cm, all free but one row of walls, at x -2..0, y -2..0 of the pose (3, 4).
    std::vector<cells::CellPair> pairs(1600, {200, 0});
    for (int u = 0; u < 40; ++u) pairs[std::size_t(u)] = {0, 200};
    const render::PlacedTexture texture{
        {0, 0}, cells::CellTexture::fromPairs(40, 40, 0.05, pairs), {3, 4, 0}, 0};
    render::DenseCache cache(1 << 20);
    const auto made = render::composeGrid(std::vector{texture}, 0.05, cache);
    QVERIFY(made.has_value());
    const Eigen::Vector2d free = made->reference.cellFromWorld({2, 3});
    QVERIFY(made->cells->at(int(free.x()), int(free.y())) < 30);
    const grids::CellMeaning& meaning = grids::meaningOf(made->cells->code());
    const Eigen::Vector2d outside = made->reference.cellFromWorld({3.04, 4.04});
    QVERIFY(!meaning.known[made->cells->at(int(outside.x()), int(outside.y()))]);
    const auto nothing = render::composeGrid({}, 0.05, cache);
    QCOMPARE(nothing.error().code, render::fault::NoSubmapToExport);
  }
};

}  // namespace test_sample_grid

MAPWRIGHT_TEST(test_sample_grid, SampleGridTest, Core)
#include "test_sample_grid.moc"
