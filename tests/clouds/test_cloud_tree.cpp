// Clouds put in order.
#include <QtTest>

#include "clouds/cloud_tree.h"
#include "made_clouds.h"
#include "test_program.h"

namespace test_cloud_tree {

using namespace mapwright;
using namespace mapwright::clouds;

class TestCloudTree : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void everyPointIsThereOnceWithWhatBelongsToIt() {
    const map::SpatialCloud cloud = test::scattered(5'000, 20, 3, 1);
    const auto tree = test::treeOf(cloud);
    QCOMPARE(tree->size(), cloud.points.size());
    const auto sorted = [](auto rows) {
      std::sort(rows.begin(), rows.end());
      return rows;
    };
    using Row = std::tuple<float, float, float, float, std::uint32_t>;
    std::vector<Row> before, after;
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
      const auto& a = cloud.points[i];
      const auto& b = tree->points()[i];
      before.emplace_back(a.x(), a.y(), a.z(), cloud.intensity[i], cloud.rgb[i]);
      after.emplace_back(b.x(), b.y(), b.z(), tree->intensity()[i], tree->rgb()[i]);
    }
    QVERIFY(sorted(before) == sorted(after));
  }

  void aNodeKnowsWhatLiesInIt() {
    const auto tree = test::treeOf(test::scattered(3'000, 20, 3, 2));
    for (const CloudNode& node : tree->nodes()) {
      std::int64_t sum = 0;
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const Eigen::Vector3f& point = tree->points()[i];
        for (std::size_t axis = 0; axis < 3; ++axis) {
          QVERIFY(point[int(axis)] >= node.min[axis] && point[int(axis)] <= node.max[axis]);
        }
        sum += inParts(double(point.z()));
      }
      QCOMPARE(node.sum_z, sum);
      if (node.second == 0) QVERIFY(node.count <= CloudTree::kLeafPoints);
    }
    QCOMPARE(tree->nodes()[0].count, 3'000U);
  }

  void aCloudWithoutPointsHasNoBounds() {
    const auto tree = test::treeOf({});
    QCOMPARE(tree->size(), std::size_t(0));
    QVERIFY(tree->bounds().empty());
    QCOMPARE(voxelSize(*tree), 0.0);
  }

  void manyPointsInOnePlaceAreNoEndlessTree() {
    map::SpatialCloud cloud;
    cloud.points.assign(100'000, {1, 2, 3});
    const auto tree = test::treeOf(cloud);
    QCOMPARE(tree->nodes().size(), std::size_t(1));
    QCOMPARE(tree->size(), std::size_t(100'000));
  }

  void whatIsNoNumberIsNotTakenInWhateverItsMakerPromised() {
    map::SpatialCloud cloud = test::scattered(100, 5, 5, 3);
    cloud.points[7].x() = std::nanf("");
    cloud.points[8].z() = INFINITY;
    cloud.intensity[9] = std::nanf("");
    const auto tree = test::treeOf(cloud);
    QCOMPARE(tree->size(), std::size_t(98));
    QVERIFY(tree->bounds().max.allFinite());
  }

  void oneOfSoManyIsTaken() {
    const auto tree = CloudTree::make(test::scattered(1'000, 5, 5, 3), 10);
    QCOMPARE(tree->size(), std::size_t(100));
    QCOMPARE(tree->intensity().size(), std::size_t(100));
  }

  void aCloudThatNobodyWantsAnyMoreIsNotFinished() {
    const std::atomic<bool> cancelled = true;
    QVERIFY(!CloudTree::make(test::scattered(10'000, 5, 5, 3), 1, &cancelled));
  }

  void theSizeOfCellsIsToldByHowFarTheyLieApart() {
    for (const double edge : {0.05, 0.1, 0.025, 0.2}) {
      map::SpatialCloud cloud;
      cloud.origin_m = {437'112, 5'411'002, 120};
      for (int x = 0; x < 60; ++x) {
        for (int y = 0; y < 60; ++y) {
          if ((x * 7 + y * 13) % 5 < 3) continue;
          for (int z = 0; z < 4; ++z) {
            cloud.points.emplace_back(float((x + 0.5) * edge), float((y + 0.5) * edge),
                                      float((z + 0.5) * edge));
          }
        }
      }
      QVERIFY2(std::abs(voxelSize(*test::treeOf(cloud)) - edge) < 1e-4, qPrintable(QString::number(edge)));
    }
  }
};

}  // namespace test_cloud_tree

MAPWRIGHT_TEST(test_cloud_tree, TestCloudTree, Nothing)
#include "test_cloud_tree.moc"
