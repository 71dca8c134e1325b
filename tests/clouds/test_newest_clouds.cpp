// Clouds that came region by region: the newest for each.
#include <numeric>

#include <QtTest>

#include "clouds/heights.h"
#include "made_clouds.h"
#include "test_program.h"

namespace test_newest_clouds {

using namespace mapwright;
using namespace mapwright::clouds;

namespace {

/// A lattice of points over [0, width) x [0, width) at one height.
map::SpatialCloud lattice(double width_m, float z, double step_m = 0.5) {
  map::SpatialCloud cloud;
  for (double x = step_m / 2; x < width_m; x += step_m) {
    for (double y = step_m / 2; y < width_m; y += step_m) cloud.points.emplace_back(float(x), float(y), z);
  }
  return cloud;
}

std::uint64_t shown(const NewestClouds& clouds) { return countShown(clouds.set(), {}); }

}  // namespace

class TestNewestClouds : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theNewestIsRightAboutItsRegion() {
    NewestClouds clouds;
    clouds.add(test::came(lattice(10, 0)));
    QCOMPARE(shown(clouds), 400U);
    // A quarter of it anew, and half as dense.
    clouds.add(test::came(lattice(5, 1, 1.0), test::box({2.5, 2.5, 0}, {5, 5, 10})));
    // What of the old lies beyond the points that came is not known to have gone.
    QVERIFY(shown(clouds) < 400);
    const CloudSet set = clouds.set();
    QCOMPARE(set.clouds.size(), std::size_t(2));
    QCOMPARE(set.clouds[0].hidden.size(), std::size_t(1));
    QCOMPARE(shown(clouds), 400U - 64U + 25U);
  }

  void theSameRegionAgainTakesTheOldOnesPlace() {
    NewestClouds clouds;
    const auto region = test::box({2.5, 2.5, 0}, {5, 5, 10});
    for (int i = 0; i < 300; ++i) clouds.add(test::came(lattice(5, 0), region));
    QCOMPARE(clouds.totals().clouds, std::size_t(1));
    QCOMPARE(shown(clouds), 100U);
  }

  void theWholeMapTakesThePlaceOfAllRegionsOfItsKind() {
    NewestClouds clouds;
    clouds.add(test::came(lattice(5, 0), test::box({2.5, 2.5, 0}, {5, 5, 10})));
    clouds.add(test::came(lattice(5, 0), test::box({2.5, 2.5, 0}, {5, 5, 10}), PointKind::Voxel));
    clouds.add(test::came(lattice(10, 0)));
    QCOMPARE(clouds.totals().clouds, std::size_t(2));
    QVERIFY(clouds.totals().voxels);
  }

  void anAnswerWithoutPointsSaysThatThereIsNothing() {
    NewestClouds clouds;
    clouds.add(test::came(lattice(10, 0)));
    clouds.add(test::came({}, test::box({2.5, 2.5, 0}, {5, 5, 10})));
    QCOMPARE(shown(clouds), 300U);
  }

  void aSphereHidesWhatLiesInIt() {
    NewestClouds clouds;
    clouds.add(test::came(lattice(10, 0)));
    map::CloudRegion sphere;
    sphere.centre_m = {5, 5, 0};
    sphere.radius_m = 2;
    clouds.add(test::came({}, sphere));
    std::uint64_t in = 0;
    for (const auto& point : lattice(10, 0).points)
      in += (point.cast<double>() - sphere.centre_m).norm() <= 2 ? 1 : 0;
    QVERIFY(in > 30);
    QCOMPARE(shown(clouds), 400U - in);
  }

  void memoryIsBoundedAndWhatWasThinnedIsCounted() {
    QCOMPARE(NewestClouds::oneOf(5'000'000), std::uint64_t(1));
    QVERIFY(50'000'000 / NewestClouds::oneOf(50'000'000) <= NewestClouds::kMostPoints / 2);
    QCOMPARE(NewestClouds::oneOf(0), std::uint64_t(1));
    NewestClouds clouds;
    const map::SpatialCloud cloud = test::scattered(1'000, 5, 2, 1);
    NewestClouds::Came came;
    came.tree = CloudTree::make(cloud, 4);
    came.points = 1'000;
    came.left_out = 17;
    came.one_of = 4;
    clouds.add(came);
    QCOMPARE(clouds.totals().thinned, std::uint64_t(750));
    QCOMPARE(clouds.totals().left_out, std::uint64_t(17));
    for (int i = 0; i < 200; ++i) {
      clouds.add(test::came(lattice(1, 0), test::box({i * 2.0, 0, 0}, {1, 1, 1})));
    }
    QCOMPARE(clouds.totals().clouds, NewestClouds::kMostClouds);
    QVERIFY(clouds.totals().forgotten > 0);
  }

  void heightsAreCountedWithoutTheOutermost() {
    map::SpatialCloud cloud = lattice(100, 1);
    const std::size_t flat = cloud.points.size();
    for (int i = 0; i < 1'000; ++i) cloud.points.emplace_back(1, 1, float(i) * 0.003F);
    cloud.points.emplace_back(1, 1, 900);
    const Heights heights = heightsOf(test::setOf(cloud));
    QCOMPARE(heights.points, std::uint64_t(flat + 1'001));
    QCOMPARE(heights.high_m, 900.0);
    QVERIFY(heights.usual_high_m < 3.1);
    QCOMPARE(std::accumulate(heights.bins.begin(), heights.bins.end(), std::uint64_t(0)), heights.points);
    QCOMPARE(heightsOf({}).points, std::uint64_t(0));
  }

  void framesThatDifferAreNamed() {
    NewestClouds clouds;
    map::SpatialCloud cloud = lattice(2, 0);
    cloud.frame = "map";
    clouds.add(test::came(cloud, test::box({0, 0, 0}, {9, 9, 9})));
    cloud.frame = "odom";
    clouds.add(test::came(cloud, test::box({50, 0, 0}, {9, 9, 9})));
    QCOMPARE(clouds.totals().frames.size(), std::size_t(2));
  }
};

}  // namespace test_newest_clouds

MAPWRIGHT_TEST(test_newest_clouds, TestNewestClouds, Nothing)
#include "test_newest_clouds.moc"
