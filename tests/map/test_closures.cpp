// Constraints ranked by how far they are from the finished map.
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <QTest>

#include "map/closures.h"
#include "test_program.h"

namespace test_closures {

using namespace mapwright;
using namespace mapwright::map;

namespace {

using geometry::Pose2;
using geometry::poseFromYaw;

/// Submaps 0-0 and 0-1, nodes 0-0 and 1-5, all where they are told.
PoseGraph graphOf(const Pose2& submap, const Pose2& node) {
  PoseGraph graph;
  graph.submaps = {{{0, 0}, poseFromYaw(submap.x_m, submap.y_m, submap.yaw_rad)}, {{0, 1}, {}}};
  graph.trajectories = {
      {0, {{{0, 0}, 12.5, poseFromYaw(node.x_m, node.y_m, node.yaw_rad)}}},
      {1, {{{1, 5}, std::nullopt, {}}}},
  };
  return graph;
}

Constraint constraintOf(SubmapId submap, NodeId node, const Pose2& relative,
                        ConstraintKind kind = ConstraintKind::Inter) {
  return {submap, node, poseFromYaw(relative.x_m, relative.y_m, relative.yaw_rad), kind, 1, 1};
}

}  // namespace

class ClosuresTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aResidualIsWhatTheFormulaSays() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> metres(-50, 50), angle(-std::numbers::pi, std::numbers::pi);
    for (int round = 0; round < 500; ++round) {
      const Pose2 s{metres(random), metres(random), angle(random)};
      const Pose2 n{metres(random), metres(random), angle(random)};
      const Pose2 z{metres(random), metres(random), angle(random)};
      PoseGraph graph = graphOf(s, n);
      graph.constraints = {constraintOf({0, 0}, {0, 0}, z)};
      // e = Z.t - R_S^T (N.t - S.t), written out.
      const double dx = n.x_m - s.x_m, dy = n.y_m - s.y_m;
      const double ex = z.x_m - (std::cos(s.yaw_rad) * dx + std::sin(s.yaw_rad) * dy);
      const double ey = z.y_m - (-std::sin(s.yaw_rad) * dx + std::cos(s.yaw_rad) * dy);
      double turned = std::fmod(std::abs(z.yaw_rad - (n.yaw_rad - s.yaw_rad)), 2 * std::numbers::pi);
      turned = std::min(turned, 2 * std::numbers::pi - turned);
      const Closures closures = rankClosures(graph);
      QCOMPARE(closures.ranked.size(), std::size_t(1));
      const Closure& closure = closures.ranked.front();
      QVERIFY(std::abs(closure.residual_m - std::hypot(ex, ey)) < 1e-9);
      QVERIFY(std::abs(closure.residual_rad - turned) < 1e-9);
      QCOMPARE(closure.at, Eigen::Vector2d(n.x_m, n.y_m));
      QVERIFY(std::abs((closure.at - closure.expected).norm() - closure.residual_m) < 1e-9);
      QCOMPARE(closure.stamp_s, std::optional(12.5));
    }
  }

  void theLargestComesFirst() {
    PoseGraph graph = graphOf({}, {});
    graph.constraints = {
        constraintOf({0, 0}, {0, 0}, {1, 0, 0.1}),
        constraintOf({0, 1}, {1, 5}, {3, 0, 0}, ConstraintKind::Intra),
        constraintOf({0, 1}, {0, 0}, {1, 0, 0.2}),
        constraintOf({0, 0}, {1, 5}, {1, 0, 0.1}),
        constraintOf({0, 0}, {0, 0}, {0, 2, 0}),
    };
    std::vector<std::size_t> order;
    const Closures closures = rankClosures(graph);
    for (const Closure& closure : closures.ranked) order.push_back(closure.constraint);
    QCOMPARE(order, (std::vector<std::size_t>{1, 4, 2, 0, 3}));
    QCOMPARE(closures.inter, std::size_t(4));
    QCOMPARE(closures.intra, std::size_t(1));
    QCOMPARE(closures.inter_median_m, std::optional(1.0));
    QCOMPARE(closures.intra_median_m, std::optional(3.0));
  }

  void whatRefersToNothingIsCountedApart() {
    PoseGraph graph = graphOf({}, {});
    graph.constraints = {constraintOf({0, 7}, {0, 0}, {}), constraintOf({0, 0}, {3, 0}, {}),
                         constraintOf({0, 0}, {1, 5}, {}, ConstraintKind::Intra)};
    const Closures closures = rankClosures(graph);
    QCOMPARE(closures.dangling, std::size_t(2));
    QCOMPARE(closures.inter, std::size_t(0));
    QCOMPARE(closures.intra, std::size_t(1));
    QCOMPARE(closures.ranked.size(), std::size_t(1));
    QVERIFY(!closures.inter_median_m);
    QCOMPARE(closures.intra_median_m, std::optional(0.0));
  }

  void whatIsNoPoseIsCountedApart() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    PoseGraph graph = graphOf({}, {});
    graph.constraints = {constraintOf({0, 0}, {0, 0}, {nan, 0, 0}), constraintOf({0, 0}, {0, 0}, {}),
                         constraintOf({0, 1}, {0, 0}, {}),
                         constraintOf({0, 0}, {0, 0}, {1.7e308, 1.7e308, 0})};
    graph.constraints[1].relative_pose.qw = 0;
    graph.submaps[1].pose.qw = 0;
    const Closures closures = rankClosures(graph);
    QCOMPARE(closures.without_pose, std::size_t(4));
    QVERIFY(closures.ranked.empty());
    QVERIFY(!closures.inter_median_m);
  }

  void inThreeDimensionsTheHeightCounts() {
    PoseGraph graph = graphOf({}, {});
    graph.constraints = {constraintOf({0, 0}, {0, 0}, {3, 0, 0})};
    graph.constraints[0].relative_pose.z = 4;
    QVERIFY(std::abs(rankClosures(graph).ranked.front().residual_m - 5) < 1e-12);
  }
};

}  // namespace test_closures

MAPWRIGHT_TEST(test_closures, ClosuresTest, Nothing)
#include "test_closures.moc"
