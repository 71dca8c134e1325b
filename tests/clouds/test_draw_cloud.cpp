// Clouds from above, pixel by pixel: against looking at every point.
#include <QtTest>

#include "clouds/draw_cloud.h"
#include "made_clouds.h"
#include "test_program.h"

namespace test_draw_cloud {

using namespace mapwright;
using namespace mapwright::clouds;

namespace {

Raster raster(double scale, double rotation, int size, std::int64_t column = 0, std::int64_t row = 0) {
  Raster made;
  made.scale_m_per_px = scale;
  made.rotation_rad = rotation;
  made.width_px = made.height_px = size;
  made.first_column = column;
  made.first_row = row;
  return made;
}

/// The pixel of a point, as the header says.
std::pair<std::int64_t, std::int64_t> pixelOf(const Raster& in, const Eigen::Vector3d& at) {
  const double c = std::cos(in.rotation_rad), s = std::sin(in.rotation_rad), per_m = 1 / in.scale_m_per_px;
  return {std::int64_t(std::floor((c * at.x() - s * at.y()) * per_m)) - in.first_column,
          std::int64_t(std::floor(-(s * at.x() + c * at.y()) * per_m)) - in.first_row};
}

CloudLook byHeight(double low, double high) {
  CloudLook look;
  look.low_z_m = low;
  look.high_z_m = high;
  return look;
}

/// Counts and mean heights of all pixels, from every point alone.
std::vector<std::uint32_t> lookedAtOneByOne(const Raster& in, const CloudSet& set, const CloudLook& look) {
  std::vector<std::int64_t> count(std::size_t(in.width_px * in.height_px)), sum(count.size());
  for (const ShownCloud& cloud : set.clouds) {
    for (std::size_t i = 0; i < cloud.tree->size(); ++i) {
      const Eigen::Vector3d at = cloud.tree->world(i);
      if (at.z() < look.heights.low_m || at.z() > look.heights.high_m) continue;
      const auto [column, row] = pixelOf(in, at);
      if (column < 0 || row < 0 || column >= in.width_px || row >= in.height_px) continue;
      ++count[std::size_t(row * in.width_px + column)];
      sum[std::size_t(row * in.width_px + column)] +=
          inParts(double(cloud.tree->points()[i].z())) + inParts(cloud.tree->origin().z());
    }
  }
  std::vector<std::uint32_t> colors;
  for (std::size_t i = 0; i < count.size(); ++i) {
    if (count[i] == 0) {
      colors.push_back(0);
      continue;
    }
    const double mean = double(sum[i]) / double(count[i]) / kParts;
    const double part = std::clamp((mean - look.low_z_m) / (look.high_z_m - look.low_z_m), 0.0, 1.0);
    colors.push_back(shades()[std::size_t(std::lround(part * 255))]);
  }
  return colors;
}

/// Of one point a pixel at least: opaque ones only, whose colour is the mean's.
void compareOpaque(const CloudPixels& drawn, const std::vector<std::uint32_t>& expected) {
  QCOMPARE(drawn.argb.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    QCOMPARE(drawn.argb[i] != 0, expected[i] != 0);
    if (drawn.argb[i] >> 24 == 255) QCOMPARE(drawn.argb[i] & 0xffffff, expected[i]);
  }
}

}  // namespace

class TestDrawCloud : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aPixelIsTheMeanOfItsPointsHoweverFarOneLooksFrom() {
    const CloudSet set = test::setOf(test::scattered(30'000, 10, 4, 1));
    for (const double scale : {0.01, 0.07, 0.31, 1.3}) {
      for (const double rotation : {0.0, 0.4, -2.1}) {
        CloudLook look = byHeight(0, 4);
        const Raster in = raster(scale, rotation, 90, -20, -70);
        const CloudPixels drawn = drawClouds(in, set, look);
        compareOpaque(drawn, lookedAtOneByOne(in, set, look));
        if (QTest::currentTestFailed()) return;
      }
    }
  }

  void onlyTheChosenHeightsAreDrawn() {
    const CloudSet set = test::setOf(test::scattered(30'000, 10, 4, 1));
    CloudLook look = byHeight(1, 2);
    look.heights = {1, 2};
    const Raster in = raster(0.3, 0, 60, -5, -50);
    compareOpaque(drawClouds(in, set, look), lookedAtOneByOne(in, set, look));
    look.heights = {10, 20};
    QVERIFY(drawClouds(in, set, look).argb.empty());
  }

  void tilesOfAPictureAreThePicture() {
    const CloudSet set = test::setOf(test::scattered(20'000, 10, 4, 7, {437'112.5, 5'411'002.25, 120}));
    for (const int size : {1, 2, 3, 8}) {
      CloudLook look = byHeight(120, 124);
      look.size_px = size;
      Raster whole = raster(0.004, 0.3, 64, 10, -40);
      whole.origin_m = {437'117, 5'411'007};
      const CloudPixels all = drawClouds(whole, set, look);
      QVERIFY(!all.argb.empty());
      for (int row = 0; row < 64; row += 16) {
        for (int column = 0; column < 64; column += 16) {
          Raster tile = whole;
          tile.first_column += column;
          tile.first_row += row;
          tile.width_px = tile.height_px = 16;
          const CloudPixels part = drawClouds(tile, set, look);
          for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 16; ++x) {
              const std::uint32_t expected = all.argb[std::size_t((row + y) * 64 + column + x)];
              QCOMPARE(part.argb.empty() ? 0U : part.argb[std::size_t(y * 16 + x)], expected);
            }
          }
        }
      }
    }
  }

  void itDoesNotMatterInWhichOrderPointsCame() {
    map::SpatialCloud cloud = test::scattered(5'000, 3, 2, 5);
    const Raster in = raster(0.1, 0, 40, -2, -35);
    CloudLook look;
    look.color = CloudColor::Rgb;
    const CloudPixels before = drawClouds(in, test::setOf(cloud), look);
    std::reverse(cloud.points.begin(), cloud.points.end());
    std::reverse(cloud.rgb.begin(), cloud.rgb.end());
    std::reverse(cloud.intensity.begin(), cloud.intensity.end());
    QVERIFY(drawClouds(in, test::setOf(cloud), look) == before);
  }

  void morePointsAreMoreOpaqueAndNoneLiesOverAnother() {
    map::SpatialCloud cloud;
    // A field of points, one of them with nine more of another height above it.
    for (int x = 0; x < 100; ++x) {
      for (int y = 0; y < 100; ++y)
        cloud.points.emplace_back(float(x) * 0.1F + 0.05F, float(y) * 0.1F + 0.05F, 0.0F);
    }
    for (int i = 0; i < 300; ++i) cloud.points.emplace_back(5.5F, 5.5F, 1.0F);
    const CloudSet set = test::setOf(cloud);
    // A pixel is a square metre: a hundred points each.
    const Raster in = raster(1, 0, 10, 0, -10);
    const CloudPixels drawn = drawClouds(in, set, byHeight(0, 1));
    const std::uint32_t usual = drawn.argb[0], crowded = drawn.argb[45];
    QVERIFY2(crowded >> 24 > usual >> 24, qPrintable(QString::number(usual, 16)));
    // 100 points at 0 and 300 at 1: three quarters.
    QCOMPARE(crowded & 0xffffff, shades()[191]);
  }

  void aPointIsNoLargerThanTheGroundBetweenPoints() {
    QCOMPARE(pointSize(4, 0.01, 0.05), 4);
    QCOMPARE(pointSize(4, 0.02, 0.05), 2);
    QCOMPARE(pointSize(4, 0.1, 0.05), 1);
    QCOMPARE(pointSize(4, 0.1, 0), 4);
    QCOMPARE(pointSize(400, 1e-4, 50), kLargestPoint);
  }

  void cellsCoverTheirGroundWithoutSeamsHoweverTheViewIsTurned() {
    map::SpatialCloud cloud;
    for (int x = 0; x < 20; ++x) {
      for (int y = 0; y < 20; ++y)
        cloud.points.emplace_back((float(x) + 0.5F) * 0.05F, (float(y) + 0.5F) * 0.05F, 1.0F);
    }
    NewestClouds store;
    auto came = test::came(cloud, {}, PointKind::Voxel);
    came.voxel_m = 0.05;
    store.add(came);
    for (const double rotation : {0.0, 0.5}) {
      const Raster in = raster(0.007, rotation, 200, -100, -200);
      const CloudPixels drawn = drawClouds(in, store.set(), byHeight(0, 2));
      int inside = 0;
      for (int row = 0; row < 200; ++row) {
        for (int column = 0; column < 200; ++column) {
          const double u = column + 0.5 - 100, v = row + 0.5 - 200;
          const double x = (std::cos(rotation) * u - std::sin(rotation) * v) * 0.007;
          const double y = (-std::sin(rotation) * u - std::cos(rotation) * v) * 0.007;
          // Not at the very edge, where rounding tells.
          const bool well_in = x > 0.001 && x < 0.999 && y > 0.001 && y < 0.999;
          if (!well_in) continue;
          ++inside;
          QCOMPARE(drawn.argb[std::size_t(row * 200 + column)] >> 24, 255U);
        }
      }
      QVERIFY(inside > 5'000);
    }
  }

  void pointsLieOverCells() {
    map::SpatialCloud cell, point;
    cell.points.emplace_back(0.5F, 0.5F, 0.0F);
    point.points.emplace_back(0.55F, 0.55F, 2.0F);
    NewestClouds store;
    auto came = test::came(cell, {}, PointKind::Voxel);
    came.voxel_m = 1;
    store.add(test::came(point));
    store.add(came);
    const CloudPixels drawn = drawClouds(raster(0.1, 0, 10, 0, -10), store.set(), byHeight(0, 2));
    QCOMPARE(drawn.argb[0], 0xff000000 | shades()[0]);
    QCOMPARE(drawn.argb[45], 0xff000000 | shades()[255]);
  }

  void whatHasNoColourOfItsOwnHasTheOneThatIsChosen() {
    map::SpatialCloud cloud;
    cloud.points.emplace_back(0.5F, 0.5F, 0.0F);
    CloudLook look;
    look.color = CloudColor::Rgb;
    look.one = 0x123456;
    QCOMPARE(drawClouds(raster(1, 0, 1, 0, -1), test::setOf(cloud), look).argb[0] & 0xffffff, 0x123456U);
    look.color = CloudColor::Intensity;
    QCOMPARE(drawClouds(raster(1, 0, 1, 0, -1), test::setOf(cloud), look).argb[0] & 0xffffff, shades()[0]);
  }

  void rastersThatAreNoneGiveNothing() {
    const CloudSet set = test::setOf(test::scattered(100, 3, 2, 5));
    for (const double scale : {0.0, -1.0, std::nan(""), double(INFINITY), 1e-300}) {
      QVERIFY(drawClouds(raster(scale, 0, 10), set, {}).argb.empty());
    }
    QVERIFY(drawClouds(raster(1, std::nan(""), 10), set, {}).argb.empty());
    QVERIFY(drawClouds(raster(1, 0, 0), set, {}).argb.empty());
    QVERIFY(drawClouds(raster(1, 0, 1'000'000), set, {}).argb.empty());
    const std::atomic<bool> cancelled = true;
    QVERIFY(drawClouds(raster(1, 0, 10, 0, -10), set, {}, &cancelled).argb.empty());
  }
};

}  // namespace test_draw_cloud

MAPWRIGHT_TEST(test_draw_cloud, TestDrawCloud, Nothing)
#include "test_draw_cloud.moc"
