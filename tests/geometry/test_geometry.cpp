#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <QTest>

#include "geometry/polyline.h"
#include "geometry/pose.h"
#include "geometry/view_transform.h"
#include "test_program.h"

namespace test_geometry {

using namespace mapwright::geometry;

class GeometryTest : public QObject {
  Q_OBJECT
 private:
  static bool near(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return (a - b).norm() < 1e-9; }

 private Q_SLOTS:
  void posesThatMeanNothingAreRefused() {
    QVERIFY(!toIsometry({0, 0, 0, 0, 0, 0, 0}));
    QVERIFY(!toIsometry({std::nan(""), 0, 0, 0, 0, 0, 1}));
    QVERIFY(!toIsometry({0, 0, 0, 0, 0, std::numeric_limits<double>::infinity(), 1}));
    QVERIFY(!toIsometry({0, 0, 0, 1e200, 0, 0, 1e200}));
  }

  void quaternionsAreNormalised() {
    const auto transform = toIsometry({1, 2, 3, 0, 0, 2 * std::sin(0.35), 2 * std::cos(0.35)});
    QVERIFY(transform.has_value());
    const Pose2 pose = projectToPlane(*transform);
    QCOMPARE(pose.x_m, 1.0);
    QCOMPARE(pose.y_m, 2.0);
    QVERIFY(std::abs(pose.yaw_rad - 0.7) < 1e-12);
  }

  void rollAndPitchThatCancelLeaveTheYaw() {
    // 3D SLAM: the submap is tilted, the slice undoes it. Projecting before multiplying would be wrong.
    const Eigen::Isometry3d tilt(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()) *
                                 Eigen::AngleAxisd(-0.3, Eigen::Vector3d::UnitY()));
    const Eigen::Isometry3d yaw(Eigen::Translation3d(5, -2, 1) *
                                Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitZ()));
    const Pose2 pose = projectToPlane((yaw * tilt) * tilt.inverse());
    QVERIFY(std::abs(pose.yaw_rad - 1.1) < 1e-12);
    QVERIFY(near({pose.x_m, pose.y_m}, {5, -2}));
  }

  void posesComposeAndInvert() {
    const Pose2 a{1, 2, 0.5}, b{-3, 0.25, 2.9};
    const Eigen::Vector2d p(0.7, -1.3);
    QVERIFY(near((a * b).apply(p), a.apply(b.apply(p))));
    QVERIFY(near(a.inverse().apply(a.apply(p)), p));
  }

  void anglesFoldIntoHalfOpenTurn() {
    QCOMPARE(normalizeAngle(std::numbers::pi), std::numbers::pi);
    QCOMPARE(normalizeAngle(-std::numbers::pi), std::numbers::pi);
    QVERIFY(std::abs(normalizeAngle(7) - (7 - 2 * std::numbers::pi)) < 1e-12);
  }

  void firstPixelsCornerIsWhereTheCommandLineSays() {
    const ViewTransform view{{10, 20}, 0.05, 0, 800, 600};
    QVERIFY(near(view.worldFromPixel({0, 0}), {10 - 400 * 0.05, 20 + 300 * 0.05}));
  }

  void pixelsAndWorldAreInverse() {
    const ViewTransform view{{-3, 8}, 0.013, 0.7, 801, 600};
    const Eigen::Vector2d world(1.5, 9.25);
    QVERIFY(near(view.worldFromPixel(view.pixelFromWorld(world)), world));
  }

  void positiveRotationTurnsThePictureCounterClockwise() {
    const ViewTransform view{{0, 0}, 1, std::numbers::pi / 2, 100, 100};
    // What lay to the right (east) now lies at the top.
    QVERIFY(near(view.pixelFromWorld({10, 0}), {50, 40}));
  }

  void zoomAndTurnKeepThePointUnderTheCursor() {
    const ViewTransform view{{5, -7}, 0.05, 0.3, 640, 480};
    const Eigen::Vector2d cursor(100, 400), world = view.worldFromPixel(cursor);
    QVERIFY(near(view.zoomedAt(cursor, 1.25).worldFromPixel(cursor), world));
    QVERIFY(near(view.rotatedAt(cursor, 0.4).worldFromPixel(cursor), world));
  }

  void zoomStopsAtItsLimits() {
    ViewTransform view;
    for (int i = 0; i < 400; ++i) view = view.zoomedAt({0, 0}, 1.25);
    QCOMPARE(view.scale_m_per_px, kMinScaleMPerPx);
    for (int i = 0; i < 400; ++i) view = view.zoomedAt({0, 0}, 0.8);
    QCOMPARE(view.scale_m_per_px, kMaxScaleMPerPx);
  }

  void dragMovesThePictureWithTheHand() {
    const ViewTransform view{{0, 0}, 0.1, 0.9, 200, 200};
    const Eigen::Vector2d world = view.worldFromPixel({50, 60});
    QVERIFY(near(view.pannedBy({12, -7}).pixelFromWorld(world), {62, 53}));
  }

  void fitShowsEverythingAtAnyRotation() {
    WorldRect world;
    world.extend(Eigen::Vector2d(-10, 5));
    world.extend(Eigen::Vector2d(30, 12));
    for (const double rotation : {0.0, 0.5, 2.2}) {
      ViewTransform view{{0, 0}, 1, rotation, 300, 200};
      view = view.fitted(world, 10);
      for (const Eigen::Vector2d& corner : {Eigen::Vector2d(-10, 5), Eigen::Vector2d(30, 5),
                                            Eigen::Vector2d(30, 12), Eigen::Vector2d(-10, 12)}) {
        const Eigen::Vector2d pixel = view.pixelFromWorld(corner);
        QVERIFY(pixel.x() > 9.9 && pixel.x() < 290.1 && pixel.y() > 9.9 && pixel.y() < 190.1);
      }
    }
    const ViewTransform view{{1, 2}, 0.3, 0, 300, 200};
    QCOMPARE(view.fitted(WorldRect{}, 10), view);
  }

  void polylinesHaveLengthsAreasAndAngles() {
    const std::vector<Eigen::Vector2d> ring{{1e6, 1e6}, {1e6 + 3, 1e6}, {1e6 + 3, 1e6 + 4}};
    QCOMPARE(lengthOf(ring), 7.0);
    QCOMPARE(signedAreaOf(ring), 6.0);
    QCOMPARE(signedAreaOf(std::vector<Eigen::Vector2d>(ring.rbegin(), ring.rend())), -6.0);
    QCOMPARE(signedAreaOf({}), 0.0);
    QCOMPARE(degreesFromRadians(angleAt({0, 0}, {1, 0}, {0, 5})), 90.0);
    QCOMPARE(degreesFromRadians(angleAt({0, 0}, {1, 0}, {-2, 0})), 180.0);
    QCOMPARE(angleAt({0, 0}, {0, 0}, {1, 0}), 0.0);
    QCOMPARE(distanceToSegment({0, 1}, {-1, 0}, {1, 0}), 1.0);
    QCOMPARE(distanceToSegment({4, 4}, {1, 0}, {1, 0}), 5.0);
  }
};

}  // namespace test_geometry

MAPWRIGHT_TEST(test_geometry, GeometryTest, Core)
#include "test_geometry.moc"
