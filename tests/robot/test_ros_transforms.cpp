// Where frames lie to each other, in time.
#include <cmath>
#include <limits>
#include <numbers>

#include <QTest>

#include "robot/ros/faults.h"
#include "robot/ros/transforms.h"
#include "test_program.h"

namespace test_ros_transforms {

using namespace mapwright;
using robot::ros::frameName;
using robot::ros::Transform3;
using robot::ros::Transforms;
using Kind = Transforms::Missing::Kind;
using Missing = Transforms::Missing;
using Taken = Transforms::Taken;

namespace {

constexpr double kPi = std::numbers::pi;

Eigen::Quaterniond turned(double yaw_rad) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
}

Transform3 at(double x_m, double y_m = 0, double yaw_rad = 0) { return {{x_m, y_m, 0}, turned(yaw_rad)}; }

/// A pair that is only ever moved along x.
Taken move(Transforms& transforms, const std::string& parent, const std::string& child, double x_m,
           double stamp_s) {
  return transforms.setTransform(parent, child, at(x_m), stamp_s, false);
}

bool isAbout(const tl::expected<Transform3, Missing>& found, double x_m, double y_m, double yaw_rad) {
  if (!found) return false;
  const geometry::Pose2 pose = found->flat();
  return std::abs(pose.x_m - x_m) < 1e-9 && std::abs(pose.y_m - y_m) < 1e-9 &&
         std::abs(geometry::normalizeAngle(pose.yaw_rad - yaw_rad)) < 1e-9;
}

}  // namespace

class RosTransformsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void betweenTwoStampsItIsInterpolated() {
    Transforms transforms;
    transforms.setTransform("odom", "base", at(1, 10, 0), 100, false);
    transforms.setTransform("odom", "base", at(3, 20, kPi / 2), 102, false);
    QVERIFY(isAbout(transforms.find("odom", "base", 100.5), 1.5, 12.5, kPi / 8));
    QVERIFY(isAbout(transforms.find("odom", "base", 100.0), 1, 10, 0));
    QVERIFY(isAbout(transforms.find("odom", "base", 102.0), 3, 20, kPi / 2));
  }

  void aTurnTakesTheShortWay() {
    Transforms transforms;
    Transform3 second = at(0, 0, radians(-170));
    second.q.coeffs() *= -1;  // the same turn, written the other way
    transforms.setTransform("odom", "base", at(0, 0, radians(170)), 1, false);
    transforms.setTransform("odom", "base", second, 2, false);
    QVERIFY(isAbout(transforms.find("odom", "base", 1.5), 0, 0, kPi));
  }

  void beforeTheFirstAndAfterTheLastStampNothingIsKnown() {
    Transforms transforms;
    move(transforms, "map", "odom", 5, 100);
    transforms.setTransform("odom", "base", at(1), 99, false);
    transforms.setTransform("odom", "base", at(2), 101, false);
    const auto old = transforms.find("map", "base", 98.9), late = transforms.find("map", "base", 101.5);
    QVERIFY(!old && !late);
    QVERIFY(old.error() == (Missing{Kind::TooOld, "odom", "base"}));
    QVERIFY(late.error() == (Missing{Kind::TooNew, "odom", "base"}));
    const auto only_map = transforms.find("map", "base", 100.5);
    QVERIFY(!only_map);
    QVERIFY(only_map.error() == (Missing{Kind::TooNew, "map", "odom"}));
  }

  void aStaticPairCountsAtAllTimes() {
    Transforms transforms;
    QCOMPARE(transforms.setTransform("base", "laser", at(0.5), std::nan(""), true), Taken::Kept);
    for (const std::optional<double> when : {std::optional(0.0), std::optional(1e9), std::optional<double>()})
      QVERIFY(isAbout(transforms.find("base", "laser", when), 0.5, 0, 0));
    transforms.setTransform("base", "laser", at(0.7), 3, true);
    QVERIFY(isAbout(transforms.find("base", "laser", 1), 0.7, 0, 0));
    QCOMPARE(transforms.latestCommon("base", "laser").value(), std::nullopt);
  }

  void framesAreFoundThroughWhatIsAboveBoth() {
    Transforms transforms;
    transforms.setTransform("map", "odom", at(10, 0, kPi / 2), 50, false);
    transforms.setTransform("odom", "base", at(2, 0, 0), 50, false);
    transforms.setTransform("base", "laser", at(0.5, 0, kPi), 0, true);
    transforms.setTransform("base", "camera", at(0, 1, 0), 0, true);
    QVERIFY(isAbout(transforms.find("map", "laser", {}), 10, 2.5, -kPi / 2));
    QVERIFY(isAbout(transforms.find("laser", "camera", {}), 0.5, -1, -kPi));
    QVERIFY(isAbout(transforms.find("camera", "laser", 50), 0.5, -1, kPi));
    QVERIFY(isAbout(transforms.find("laser", "map", {}), 2.5, -10, kPi / 2));
    // Pairs above what both have in common are not asked.
    QVERIFY(transforms.find("laser", "camera", 1'000));
  }

  void withoutATimeItIsTheLatestThatAllHave() {
    Transforms transforms;
    for (int tick = 0; tick <= 10; ++tick) move(transforms, "odom", "base", tick, tick);
    move(transforms, "map", "odom", 100, 3);
    move(transforms, "map", "odom", 100, 7.5);
    QVERIFY(isAbout(transforms.find("map", "base", {}), 107.5, 0, 0));
    QCOMPARE(transforms.latestCommon("base", "map").value(), std::optional(7.5));
  }

  void tenSecondsAreKept() {
    Transforms transforms;
    for (int tick = 0; tick <= 3'000; ++tick) move(transforms, "odom", "base", tick, tick * 0.01);
    QVERIFY(transforms.find("odom", "base", 20));
    QVERIFY(transforms.find("odom", "base", 30));
    QVERIFY(transforms.find("odom", "base", 19.98).error() == (Missing{Kind::TooOld, "odom", "base"}));
  }

  void aFloodOfStampsIsBounded() {
    Transforms transforms;
    constexpr int kMost = int(Transforms::kMostStamps);
    for (int tick = 0; tick < 2 * kMost; ++tick) move(transforms, "odom", "base", tick, tick * 1e-4);
    QVERIFY(transforms.find("odom", "base", (kMost + 1) * 1e-4));
    QVERIFY(!transforms.find("odom", "base", (kMost - 1) * 1e-4));
  }

  void theSameStampAgainReplaces() {
    Transforms transforms;
    for (const double x_m : {1.0, 2.0}) move(transforms, "odom", "base", x_m, 7);
    QVERIFY(isAbout(transforms.find("odom", "base", 7), 2, 0, 0));
    move(transforms, "odom", "base", 4, 8);
    move(transforms, "odom", "base", 3, 7);
    QVERIFY(isAbout(transforms.find("odom", "base", 7.5), 3.5, 0, 0));
  }

  void whatComesLateIsFiledWhereItBelongs() {
    Transforms transforms;
    move(transforms, "odom", "base", 0, 10);
    move(transforms, "odom", "base", 2, 11);
    move(transforms, "odom", "base", 10, 10.5);
    QVERIFY(isAbout(transforms.find("odom", "base", 10.25), 5, 0, 0));
    QVERIFY(isAbout(transforms.find("odom", "base", {}), 2, 0, 0));
  }

  void aClockThatIsSetBackBeginsAnew() {
    Transforms transforms;
    for (int tick = 0; tick <= 8; ++tick) move(transforms, "odom", "base", tick, 100 + tick);
    move(transforms, "odom", "base", 50, 103.5);
    QVERIFY(isAbout(transforms.find("odom", "base", {}), 50, 0, 0));
    QVERIFY(isAbout(transforms.find("odom", "base", 102), 2, 0, 0));
    QVERIFY(!transforms.find("odom", "base", 104));
    move(transforms, "odom", "base", 60, 0.5);
    QVERIFY(isAbout(transforms.find("odom", "base", {}), 60, 0, 0));
    QVERIFY(!transforms.find("odom", "base", 102));
  }

  void aChildThatChangesItsParentHasTheNewOne() {
    Transforms transforms;
    move(transforms, "map", "base", 1, 10);
    move(transforms, "map", "base", 1, 11);
    move(transforms, "map", "odom", 5, 11);
    move(transforms, "odom", "base", 2, 11);
    QVERIFY(isAbout(transforms.find("map", "base", {}), 7, 0, 0));
    QVERIFY(transforms.find("map", "base", 10).error().kind == Kind::TooOld);
    // Static ones as well, and back.
    transforms.setTransform("map", "base", at(9), 0, true);
    QVERIFY(isAbout(transforms.find("map", "base", 1), 9, 0, 0));
    move(transforms, "map", "base", 3, 20);
    QVERIFY(transforms.find("map", "base", 1).error().kind == Kind::TooOld);
  }

  void loopsAreRefusedByName() {
    Transforms transforms;
    move(transforms, "map", "odom", 1, 10);
    move(transforms, "odom", "base", 1, 10);
    QCOMPARE(move(transforms, "base", "map", 1, 10), Taken::Loop);
    QCOMPARE(move(transforms, "base", "map", 1, 10.1), Taken::Loop);
    QCOMPARE(move(transforms, "base", "base", 1, 10), Taken::NoFrames);
    QCOMPARE(transforms.loops().size(), std::size_t(1));
    QVERIFY(transforms.loops()[0] == (Missing{Kind::Loop, "base", "map"}));
    QCOMPARE(transforms.refused(), std::size_t(3));
    QVERIFY(isAbout(transforms.find("map", "base", {}), 2, 0, 0));
    QCOMPARE(transforms.roots(), std::vector<std::string>{"map"});
  }

  void aPairThatNobodyRenewsMakesWay() {
    Transforms transforms;
    move(transforms, "base", "odom", 1, 10);
    QCOMPARE(move(transforms, "odom", "base", -1, 15), Taken::Loop);
    QCOMPARE(move(transforms, "odom", "base", -1, 21), Taken::Kept);
    QVERIFY(transforms.loops().empty());
    QCOMPARE(transforms.roots(), std::vector<std::string>{"odom"});
    QVERIFY(isAbout(transforms.find("odom", "base", 21), -1, 0, 0));
    // A static one stays.
    transforms.setTransform("base", "laser", at(0), 0, true);
    QCOMPARE(move(transforms, "laser", "base", 0, 1'000), Taken::Loop);
  }

  void slashesBeforeNamesMeanNothing() {
    Transforms transforms;
    move(transforms, "/map", "odom", 1, 10);
    move(transforms, "map", "/odom", 2, 11);
    QVERIFY(isAbout(transforms.find("map", "/odom", {}), 2, 0, 0));
    QCOMPARE(transforms.frames(), (std::vector<std::string>{"map", "odom"}));
    QCOMPARE(frameName("//robot/base"), std::string("robot/base"));
    QCOMPARE(frameName("/"), std::string());
    QCOMPARE(move(transforms, "/", "odom", 2, 11), Taken::NoFrames);
  }

  void aFrameInItselfIsTheIdentity() { QVERIFY(isAbout(Transforms().find("map", "/map", 5), 0, 0, 0)); }

  void whatIsNotKnownIsNamed() {
    Transforms transforms;
    move(transforms, "map", "odom", 1, 10);
    move(transforms, "world", "camera", 1, 10);
    QVERIFY(transforms.find("map", "laser", {}).error() == (Missing{Kind::UnknownFrame, "map", "laser"}));
    QVERIFY(transforms.find("earth", "odom", {}).error() == (Missing{Kind::UnknownFrame, "odom", "earth"}));
    QVERIFY(transforms.find("map", "camera", {}).error() == (Missing{Kind::NotConnected, "map", "camera"}));
    QCOMPARE(transforms.roots(), (std::vector<std::string>{"map", "world"}));
  }

  void transformsThatAreNoneAreRefusedAndCounted() {
    Transforms transforms;
    const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
    Transform3 zero = at(1), odd = at(1), far = at(infinite);
    zero.q = Eigen::Quaterniond(0, 0, 0, 0);
    odd.q = Eigen::Quaterniond(nan, 0, 0, 1);
    for (const Transform3& none : {zero, odd, far})
      QCOMPARE(transforms.setTransform("map", "odom", none, 1, false), Taken::NoNumbers);
    QCOMPARE(transforms.setTransform("map", "odom", at(1), nan, false), Taken::NoNumbers);
    QCOMPARE(transforms.refused(), std::size_t(4));
    QVERIFY(transforms.frames().empty());
  }

  void quaternionsOfAnyLengthAreTurns() {
    Transforms transforms;
    Transform3 longer = at(1, 0, 1);
    longer.q.coeffs() *= 3;
    transforms.setTransform("map", "odom", longer, 1, false);
    QVERIFY(isAbout(transforms.find("map", "odom", {}), 1, 0, 1));
    QVERIFY(std::abs(transforms.find("map", "odom", {})->q.norm() - 1) < 1e-12);
  }

  void aFloodOfNamesIsBounded() {
    Transforms transforms;
    for (std::size_t n = 1; n < Transforms::kMostFrames; ++n)
      QCOMPARE(move(transforms, "map", "frame" + std::to_string(n), 0, 1), Taken::Kept);
    QCOMPARE(move(transforms, "map", "one more", 0, 1), Taken::NoFrames);
    QCOMPARE(move(transforms, "map", "frame5", 0, 2), Taken::Kept);
    QCOMPARE(transforms.frames().size(), Transforms::kMostFrames);
  }

  void aHundredFramesAHundredTimesASecondAreKept() {
    Transforms transforms;
    for (int tick = 0; tick < 1'000; ++tick) {
      std::string parent = "frame0";
      for (int n = 1; n <= 100; ++n) {
        const std::string child = "frame" + std::to_string(n);
        move(transforms, parent, child, 0.01 * tick, tick * 0.01);
        parent = child;
      }
      QVERIFY(isAbout(transforms.find("frame0", "frame100", {}), tick, 0, 0));
    }
  }

  void everyLackHasAReasonThatNamesTheFrames() {
    const auto reason = [](Kind kind) { return reasonOf(Missing{kind, "map", "base"}); };
    QCOMPARE(reason(Kind::UnknownFrame), Fault(robot::ros::fault::RosFrameUnknown, {"base"}));
    QCOMPARE(reason(Kind::NotConnected), Fault(robot::ros::fault::RosFramesApart, {"base", "map"}));
    QCOMPARE(reason(Kind::TooOld), Fault(robot::ros::fault::RosTransformTooOld, {"base", "map"}));
    QCOMPARE(reason(Kind::TooNew), Fault(robot::ros::fault::RosTransformTooNew, {"base", "map"}));
    QCOMPARE(reason(Kind::Loop), Fault(robot::ros::fault::RosTransformLoop, {"base", "map"}));
  }

 private:
  static double radians(double deg) { return geometry::radiansFromDegrees(deg); }
};

}  // namespace test_ros_transforms

MAPWRIGHT_TEST(test_ros_transforms, RosTransformsTest, Core)
#include "test_ros_transforms.moc"
