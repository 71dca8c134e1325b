// The composition against an independent double-precision reference, and against pixels worked out by hand.
#include <cmath>

#include <QtTest>

#include "cells/cell_texture.h"
#include "grids/grid_pyramid.h"
#include "reference.h"
#include "render/compositor.h"
#include "render/dense_cache.h"
#include "render/tap_cells.h"
#include "test_program.h"

namespace test_compositor {

using namespace mapwright;
using render::Composition;
using render::DenseCache;
using render::Kernel;
using render::PixelGrid;
using render::Quality;
using testing::composeAll;
using testing::Content;
using testing::flagsAt;
using testing::gridAround;
using testing::pixelAt;
using testing::PlainTexture;
using testing::uniformTexture;

namespace {

constexpr double kPi = 3.14159265358979323846;

// Textures of one resolution scattered around a point, at any angle.
std::vector<PlainTexture> scattered(int count, Content content, const Eigen::Vector2d& around,
                                    std::mt19937& random, double resolution_m = 0.05) {
  std::uniform_real_distribution<double> offset(-1.5, 1.5), angle(-kPi, kPi);
  std::vector<PlainTexture> textures;
  for (int i = 0; i < count; ++i) {
    const int width = 30 + int(random() % 90), height = 30 + int(random() % 90);
    // The middle of the texture comes to lie near `around`.
    const double yaw = angle(random);
    const geometry::Pose2 turn{0, 0, yaw};
    const Eigen::Vector2d middle = turn.apply({-height * resolution_m / 2, -width * resolution_m / 2});
    const geometry::Pose2 pose{around.x() + offset(random) - middle.x(),
                               around.y() + offset(random) - middle.y(), yaw};
    textures.push_back(testing::plainTexture(width, height, resolution_m,
                                             testing::randomCells(width, height, content, random), pose, i,
                                             std::uint16_t(random() & 0x3ffe)));
  }
  return textures;
}

struct Difference {
  double worst = 0, mean = 0;
  int flags = 0, observed = 0;
};

Difference differenceOf(const Composition& actual, const std::vector<testing::ReferencePixel>& expected) {
  Difference d;
  int counted = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i].intensity_certain) {
      const double off = std::abs(actual.intensity[i] - expected[i].intensity);
      d.worst = std::max(d.worst, off);
      d.mean += off;
      ++counted;
    }
    if (expected[i].flags_certain && expected[i].intensity_certain && actual.flags[i] != expected[i].flags)
      ++d.flags;
    if (actual.flags[i] != 0) ++d.observed;
  }
  d.mean /= std::max(1, counted);
  return d;
}

}  // namespace

class TestCompositor : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void agreesWithTheReference_data();
  void agreesWithTheReference();
  void kernelsGiveTheSameBytes_data() { agreesWithTheReference_data(); }
  void kernelsGiveTheSameBytes();
  void cutsGiveTheSameBytes();
  void previewResemblesTheExactPicture();
  void survivesAbsurdNumbers_data();
  void survivesAbsurdNumbers();
  void farFromTheOriginStaysExact();
  void emptyInputsGiveUnknown();
  void cancellingGivesNothing();
  void boundsHoldEverythingDrawn();
  void cacheKeepsItsBudgetAndKnowsTexturesApart();
};

void TestCompositor::agreesWithTheReference_data() {
  QTest::addColumn<int>("content");
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("tolerance");
  const std::pair<const char*, Content> contents[] = {
      {"folded", Content::Folding}, {"pairs", Content::Pairs}, {"saturating", Content::Saturating}};
  for (const auto& [name, content] : contents) {
    for (const double scale : {0.004, 0.0124, 0.0126, 0.03, 0.05, 0.051, 0.07, 0.1, 0.13, 0.31, 0.8, 1.63}) {
      QTest::addRow("%s at %g", name, scale) << int(content) << scale << 0.75;
    }
  }
}

void TestCompositor::agreesWithTheReference() {
  QFETCH(int, content);
  QFETCH(double, scale);
  QFETCH(double, tolerance);
  std::mt19937 random(1234);
  for (int round = 0; round < 2; ++round) {
    const Eigen::Vector2d centre(round * 17.3, -round * 5.1);
    const auto textures = scattered(5, Content(content), centre, random);
    const int edge = scale > 1 ? 11 : scale > 0.2 ? 21 : 61;
    const PixelGrid grid = gridAround(centre, scale, round * 0.7, edge + 6, edge);
    const Difference d =
        differenceOf(composeAll(grid, textures), testing::referenceComposition(grid, textures));
    QVERIFY2(d.worst <= tolerance, qPrintable(QStringLiteral("off by %1").arg(d.worst)));
    QVERIFY2(d.mean <= 0.3, qPrintable(QStringLiteral("off by %1 on average").arg(d.mean)));
    QCOMPARE(d.flags, 0);
    QVERIFY(d.observed > 2);
  }
}

void TestCompositor::kernelsGiveTheSameBytes() {
  if (!render::kernelAvailable(Kernel::Avx2)) QSKIP("this processor has no AVX2");
  QFETCH(int, content);
  QFETCH(double, scale);
  std::mt19937 random(99);
  for (int round = 0; round < 2; ++round) {
    const auto textures = scattered(6, Content(content), {0, 0}, random);
    const PixelGrid grid =
        gridAround({0, 0}, scale, 0.3 + round * 0.37, scale > 0.2 ? 43 : 123, scale > 0.2 ? 37 : 117);
    const Composition portable = composeAll(grid, textures, Quality::Exact, Kernel::Portable);
    const Composition avx2 = composeAll(grid, textures, Quality::Exact, Kernel::Avx2);
    QVERIFY(portable.intensity == avx2.intensity);
    QVERIFY(portable.flags == avx2.flags);
  }
}

void TestCompositor::cutsGiveTheSameBytes() {
  std::mt19937 random(5);
  for (const double scale : {0.01, 0.05, 0.12, 0.9, 5.0}) {
    auto textures = scattered(6, Content::Folding, {0, 0}, random);
    const auto finer = scattered(2, Content::Pairs, {0.5, 0.5}, random, 0.021);
    textures.insert(textures.end(), finer.begin(), finer.end());
    PixelGrid whole = gridAround({0, 0}, scale, 0.4, 130, 110);
    whole.first_column = -41;
    whole.first_row = 1000 * 1000;
    whole.origin_m -= whole.worldFromPixel(65, 55);
    const Composition picture = composeAll(whole, textures);
    QVERIFY(std::count(picture.flags.begin(), picture.flags.end(), 0) < std::ptrdiff_t(picture.flags.size()));
    for (int cut = 0; cut < 12; ++cut) {
      PixelGrid part = whole;
      const int x = int(random() % 100), y = int(random() % 80);
      part.first_column += x;
      part.first_row += y;
      part.width_px = 1 + int(random() % unsigned(130 - x));
      part.height_px = 1 + int(random() % unsigned(110 - y));
      const Composition piece = composeAll(part, textures);
      for (int row = 0; row < part.height_px; ++row) {
        for (int column = 0; column < part.width_px; ++column) {
          QCOMPARE(pixelAt(piece, column, row), pixelAt(picture, x + column, y + row));
          QCOMPARE(flagsAt(piece, column, row), flagsAt(picture, x + column, y + row));
        }
      }
    }
  }
}

void TestCompositor::previewResemblesTheExactPicture() {
  std::mt19937 random(8);
  const auto textures = scattered(6, Content::Folding, {0, 0}, random);
  for (const double scale : {0.05, 0.2, 0.4}) {
    const PixelGrid grid = gridAround({0, 0}, scale, 0.2, 60, 60);
    const Composition exact = composeAll(grid, textures);
    const Composition preview = composeAll(grid, textures, Quality::Preview);
    double difference = 0;
    int observed_differs = 0;
    for (std::size_t i = 0; i < exact.intensity.size(); ++i) {
      difference += std::abs(int(exact.intensity[i]) - int(preview.intensity[i]));
      observed_differs += (exact.flags[i] == 0) != (preview.flags[i] == 0);
    }
    QVERIFY(difference / double(exact.intensity.size()) < 12);
    QVERIFY(observed_differs < int(exact.intensity.size()) / 8);
    if (scale == 0.05) QVERIFY(exact.intensity == preview.intensity);
  }
}

void TestCompositor::survivesAbsurdNumbers_data() {
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("resolution");
  for (const double scale : {1e-300, 1e-4, 0.05, 1e5, 1e300}) {
    for (const double x : {0.0, 1e6, 1e18, 1e300}) {
      for (const double resolution : {1e-300, 1e-6, 0.05, 100.0}) {
        QTest::addRow("scale %g at %g, cells of %g", scale, x, resolution) << scale << x << resolution;
      }
    }
  }
}

void TestCompositor::survivesAbsurdNumbers() {
  QFETCH(double, scale);
  QFETCH(double, x);
  QFETCH(double, resolution);
  std::vector<PlainTexture> textures;
  textures.push_back(testing::plainTexture(1, 1, resolution, {{50, 0}}, {x, -x, 1e6}, 0));
  textures.push_back(
      testing::plainTexture(3, 70, resolution, std::vector<cells::CellPair>(210, {0, 255}), {x, 0, 0.5}));
  textures.push_back(
      testing::plainTexture(9, 9, 0.05, std::vector<cells::CellPair>(81, {0, 100}), {-x, 0, 0.5}));
  textures.push_back(textures.back());
  textures.back().placed.world_from_texture.yaw_rad = std::nan("");
  textures.back().placed.texture.reset();
  for (const Quality quality : {Quality::Exact, Quality::Preview}) {
    for (const double at : {x, 0.0}) {
      const PixelGrid grid = gridAround({at, 0}, scale, 1.0, 33, 5);
      const Composition picture = composeAll(grid, textures, quality);
      QVERIFY(picture.width_px == 33 || picture.width_px == 0);
      QCOMPARE(picture.intensity.size(), std::size_t(picture.width_px) * std::size_t(picture.height_px));
    }
  }
}

void TestCompositor::farFromTheOriginStaysExact() {
  // A map a million metres from the origin, seen from there: the same picture as at home but for the
  // precision of doubles.
  std::mt19937 random(3), again(3);
  const auto home = scattered(4, Content::Folding, {0, 0}, random);
  const Eigen::Vector2d far(1 << 20, -(1 << 20));
  const auto away = scattered(4, Content::Folding, far, again);
  const Composition here = composeAll(gridAround({0, 0}, 0.04, 0.3, 90, 90), home);
  const Composition there = composeAll(gridAround(far, 0.04, 0.3, 90, 90), away);
  int worst = 0;
  for (std::size_t i = 0; i < here.intensity.size(); ++i) {
    worst = std::max(worst, std::abs(int(here.intensity[i]) - int(there.intensity[i])));
  }
  QVERIFY(worst <= 1);
}

void TestCompositor::emptyInputsGiveUnknown() {
  const Composition picture = composeAll(gridAround({0, 0}, 1, 0, 3, 2), {});
  QCOMPARE(picture.width_px, 3);
  QCOMPARE(picture.intensity, std::vector<std::uint8_t>(6, 128));
  QCOMPARE(picture.flags, std::vector<std::uint16_t>(6, 0));
  QCOMPARE(composeAll(gridAround({0, 0}, 1, 0, 0, 5), {}).width_px, 0);
}

void TestCompositor::cancellingGivesNothing() {
  DenseCache cache;
  const auto placed = testing::placedOf({uniformTexture({100, 0})});
  const PixelGrid grid = gridAround({0, 0}, 0.1, 0, 100, 100);
  std::atomic<bool> cancelled{true};
  QCOMPARE(render::compose(grid, placed, Quality::Exact, cache, Kernel::Best, &cancelled).width_px, 0);
  cancelled = false;
  QCOMPARE(render::compose(grid, placed, Quality::Exact, cache, Kernel::Best, &cancelled).width_px, 100);
}

void TestCompositor::boundsHoldEverythingDrawn() {
  std::mt19937 random(17);
  for (const PlainTexture& texture : scattered(10, Content::Saturating, {3, 4}, random)) {
    const PixelGrid grid = gridAround({3, 4}, 0.05, 0.1, 300, 300);
    const Composition picture = composeAll(grid, {texture});
    const geometry::WorldRect bounds = render::boundsOf(texture.placed);
    for (int row = 0; row < 300; ++row) {
      for (int column = 0; column < 300; ++column) {
        if (flagsAt(picture, column, row) == 0) continue;
        QVERIFY(bounds.contains(grid.worldFromPixel(column + 0.5, row + 0.5)));
      }
    }
  }
}

void TestCompositor::cacheKeepsItsBudgetAndKnowsTexturesApart() {
  DenseCache cache(20'000);
  const PlainTexture first = uniformTexture({1, 0}), second = uniformTexture({2, 0});
  const auto cells = cache.get(first.placed.texture, 0);
  QCOMPARE(cache.get(first.placed.texture, 0).get(), cells.get());
  QVERIFY(cache.get(second.placed.texture, 0).get() != cells.get());
  QVERIFY(cache.bytes() >= 2 * cells->bytes());
  std::vector<PlainTexture> many;
  for (int i = 0; i < 100; ++i) {
    many.push_back(uniformTexture({std::uint8_t(i + 1), 0}));
    const auto dense = cache.get(many.back().placed.texture, 0);
    QCOMPARE(int(dense->taps[std::size_t((2 * dense->level.stride + 2) * 2)]), i + 1);
    QVERIFY(cache.bytes() <= 20'000);
  }
  cache.clear();
  QCOMPARE(cache.bytes(), std::size_t(0));
  QCOMPARE(cells->level.width, 20);  // still alive in our hands
}

}  // namespace test_compositor

MAPWRIGHT_TEST(test_compositor, TestCompositor, Core)
#include "test_compositor.moc"
