// One map laid over another by pairs of points.
#include <QtTest>

#include "placing/align.h"
#include "test_program.h"

namespace test_align {

using namespace mapwright;
using namespace mapwright::placing;

class TestAlign : public QObject {
  Q_OBJECT
 private:
  static bool near(const geometry::Pose2& a, const geometry::Pose2& b) {
    return std::abs(a.x_m - b.x_m) < 1e-9 && std::abs(a.y_m - b.y_m) < 1e-9 &&
           std::abs(geometry::normalizeAngle(a.yaw_rad - b.yaw_rad)) < 1e-9;
  }

 private Q_SLOTS:
  void findsThePoseThatPairsWereMadeWith() {
    const geometry::Pose2 pose{12, -3, 2.5};
    std::vector<PointPair> pairs;
    for (const Eigen::Vector2d& point :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 1), Eigen::Vector2d(3, 7)})
      pairs.push_back({point, pose.apply(point)});
    QVERIFY(near(alignedBy(pairs, {}), pose));
    pairs.resize(2);
    QVERIFY(near(alignedBy(pairs, {}), pose));
    QVERIFY(rootMeanSquare(residualsOf(pairs, pose)) < 1e-9);
  }

  void onePairMovesAndDoesNotTurn() {
    const geometry::Pose2 before{1, 1, 0.5};
    const geometry::Pose2 pose = alignedBy({{{2, 3}, {10, 20}}}, before);
    QCOMPARE(pose.yaw_rad, 0.5);
    QVERIFY((pose.apply({2, 3}) - Eigen::Vector2d(10, 20)).norm() < 1e-9);
    QVERIFY(near(alignedBy({}, before), before));
  }

  void pairsAtOnePlaceDoNotTurn() {
    const geometry::Pose2 pose = alignedBy({{{2, 3}, {10, 20}}, {{2, 3}, {10, 20}}}, {0, 0, 0.25});
    QCOMPARE(pose.yaw_rad, 0.25);
    QVERIFY((pose.apply({2, 3}) - Eigen::Vector2d(10, 20)).norm() < 1e-9);
  }

  void anErrorIsSharedAndNeverScaledAway() {
    const std::vector<PointPair> pairs{{{0, 0}, {0, 0}}, {{10, 0}, {10.2, 0}}};
    const geometry::Pose2 pose = alignedBy(pairs, {});
    const std::vector<double> residuals = residualsOf(pairs, pose);
    QVERIFY(std::abs(residuals[0] - 0.1) < 1e-9 && std::abs(residuals[1] - 0.1) < 1e-9);
    QVERIFY(std::abs(rootMeanSquare(residuals) - 0.1) < 1e-9);
  }

  void mirroredPointsAreTurnedNotMirrored() {
    const std::vector<PointPair> pairs{{{0, 0}, {0, 0}}, {{1, 0}, {1, 0}}, {{0, 5}, {0, -5}}};
    const geometry::Pose2 pose = alignedBy(pairs, {});
    QVERIFY(std::isfinite(pose.yaw_rad));
    QVERIFY(rootMeanSquare(residualsOf(pairs, pose)) > 0.1);
  }
};

}  // namespace test_align

MAPWRIGHT_TEST(test_align, TestAlign, Core)
#include "test_align.moc"
