// Clouds cut along a line.
#include <QtTest>

#include "clouds/section.h"
#include "made_clouds.h"
#include "test_program.h"

namespace test_section {

using namespace mapwright;
using namespace mapwright::clouds;

class TestSection : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void holdsThePointsOfTheStripAlongTheLine() {
    const map::SpatialCloud cloud = test::scattered(20'000, 10, 3, 1, {437'112, 5'411'002, 120});
    Cut cut;
    cut.from_m = {437'113, 5'411'003};
    cut.to_m = {437'119, 5'411'008};
    cut.width_m = 0.8;
    const Section section = cutThrough(test::setOf(cloud), cut, {});
    const Eigen::Vector2d along = (cut.to_m - cut.from_m).normalized();
    std::uint64_t expected = 0;
    double sum = 0, got = 0;
    for (const auto& point : cloud.points) {
      const Eigen::Vector2d at = (cloud.origin_m + point.cast<double>()).head<2>() - cut.from_m;
      const double l = at.dot(along), b = at.x() * -along.y() + at.y() * along.x();
      if (l < 0 || l > cut.length() || std::abs(b) > 0.4) continue;
      ++expected;
      sum += l + cloud.origin_m.z() + double(point.z());
    }
    QVERIFY(expected > 500);
    QCOMPARE(section.points, expected);
    const CloudTree& side = *section.set.clouds.at(0).tree;
    for (std::size_t i = 0; i < side.size(); ++i) {
      const Eigen::Vector3d at = side.world(i);
      QCOMPARE(at.y(), at.z());
      got += at.x() + at.z();
    }
    QVERIFY(std::abs(got - sum) < 0.01);
    QVERIFY(section.low_m >= 120 && section.high_m <= 123 && section.high_m > 122);
  }

  void heightsThatAreNotShownAreNotInIt() {
    const map::SpatialCloud cloud = test::scattered(20'000, 10, 3, 1);
    Cut cut;
    cut.to_m = {10, 0};
    cut.width_m = 20;
    QCOMPARE(cutThrough(test::setOf(cloud), cut, {}).points, std::uint64_t(20'000));
    const Section low = cutThrough(test::setOf(cloud), cut, {0, 1});
    QVERIFY(low.points > 5'000 && low.points < 8'000 && low.high_m <= 1);
  }

  void linesThatAreNoneHaveNoPoints() {
    const CloudSet set = test::setOf(test::scattered(100, 10, 3, 1));
    Cut cut;
    cut.to_m = cut.from_m;
    QCOMPARE(cutThrough(set, cut, {}).points, std::uint64_t(0));
    cut.to_m = {std::nan(""), 1};
    QCOMPARE(cutThrough(set, cut, {}).points, std::uint64_t(0));
    cut.to_m = {5, 5};
    cut.width_m = -1;
    QVERIFY(cutThrough(set, cut, {}).set.clouds.empty());
    QVERIFY(!nearestIn(cutThrough(set, cut, {}), {0, 0}, 100));
  }

  void theNearestPointIsFound() {
    const map::SpatialCloud cloud = test::scattered(5'000, 10, 3, 1);
    Cut cut;
    cut.to_m = {10, 0};
    cut.width_m = 20;
    const Section section = cutThrough(test::setOf(cloud), cut, {});
    for (const Eigen::Vector2d& at : {Eigen::Vector2d(3, 1), Eigen::Vector2d(9.9, 2.9)}) {
      double best = 1e9;
      for (const auto& point : cloud.points)
        best = std::min(best, (Eigen::Vector2d(double(point.x()), double(point.z())) - at).norm());
      const auto nearest = nearestIn(section, at, 1);
      QVERIFY(nearest.has_value());
      QVERIFY(std::abs((*nearest - at).norm() - best) < 1e-5);
    }
    QVERIFY(!nearestIn(section, {50, 50}, 1));
  }
};

}  // namespace test_section

MAPWRIGHT_TEST(test_section, TestSection, Nothing)
#include "test_section.moc"
