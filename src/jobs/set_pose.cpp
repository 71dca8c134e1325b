#include "jobs/set_pose.h"

#include <cmath>

#include <QCoreApplication>

#include "words/fixed.h"
#include "words/plain.h"
#include "words/qt_plain.h"
#include "words/shortened.h"

namespace mapwright::jobs {
namespace {

class SetPoseText {
  Q_DECLARE_TR_FUNCTIONS(SetPose)
};

constexpr double kFarthestM = 1e7;  // maps may lie in UTM coordinates
constexpr double kSetM = 0.5, kSetRad = 0.35;
constexpr double kAdjustedM = 2, kAdjustedRad = 1;  // how far an adjustment may move a pose

QString metres(double value) { return words::fixed(value, 2); }
QString degrees(double rad) { return words::fixed(geometry::degreesFromRadians(rad), 1); }

}  // namespace

QString poseWarning() {
  return SetPoseText::tr(
      "Setting a map or a pose tells the robot where it is. If it is wrong, the robot drives into things.");
}

QString noPoseReason(const geometry::Pose2& pose) {
  if (!std::isfinite(pose.x_m) || !std::isfinite(pose.y_m) || !std::isfinite(pose.yaw_rad))
    return SetPoseText::tr("A pose is three numbers: x and y in metres, and the heading.");
  if (std::abs(pose.x_m) >= kFarthestM || std::abs(pose.y_m) >= kFarthestM)
    return SetPoseText::tr("The pose is more than 10,000 km away from the origin of the map.");
  return {};
}

PoseDeviation deviation(const robot::PoseOrder& order, const geometry::Pose2& now) {
  PoseDeviation off;
  off.metres = std::hypot(now.x_m - order.pose.x_m, now.y_m - order.pose.y_m);
  off.radians = std::abs(geometry::normalizeAngle(now.yaw_rad - order.pose.yaw_rad));
  off.as_asked = off.metres <= (order.adjust ? kAdjustedM : kSetM) &&
                 off.radians <= (order.adjust ? kAdjustedRad : kSetRad);
  return off;
}

QString poseWords(const geometry::Pose2& pose) {
  return SetPoseText::tr("x %1 m, y %2 m, %3°")
      .arg(metres(pose.x_m), metres(pose.y_m), degrees(pose.yaw_rad));
}

QString poseReport(const robot::PoseOrder& order, const geometry::Pose2& now) {
  const PoseDeviation off = deviation(order, now);
  const QString where = poseWords(now), away = metres(off.metres), turned = degrees(off.radians);
  if (!off.as_asked)
    return SetPoseText::tr(
               "The robot accepted the pose, but says that it is at %1: %2 m and %3° from the pose "
               "that was set.")
        .arg(where, away, turned);
  if (order.adjust)
    return SetPoseText::tr("The robot says that it is at %1: it adjusted the pose by %2 m and %3°.")
        .arg(where, away, turned);
  return SetPoseText::tr("The robot says that it is at %1: %2 m and %3° from the pose that was set.")
      .arg(where, away, turned);
}

bool foundItself(const map::GlobalPositioning& found) {
  return found.pose && found.state != "failed" && !found.needs_confirmation.value_or(false);
}

QString searchReport(const map::GlobalPositioning& found) {
  const QString score = found.score && std::isfinite(*found.score)
                            ? SetPoseText::tr(" (score %1)").arg(QString::number(*found.score, 'f', 2))
                            : QString();
  const QString said = words::shortened(words::plainName(found.message), 200);
  if (foundItself(found))
    return SetPoseText::tr("The robot found itself at %1%2.").arg(poseWords(*found.pose), score);
  if (found.pose && found.needs_confirmation.value_or(false))
    return SetPoseText::tr("The robot may be at %1%2. It does not use this pose yet: confirm it.")
        .arg(poseWords(*found.pose), score);
  return said.isEmpty() ? SetPoseText::tr("The robot did not find itself.")
                        : SetPoseText::tr("The robot did not find itself: %1").arg(said);
}

}  // namespace mapwright::jobs
