// Tells a robot where it is: what is checked before, and what is said of where it says it is afterwards.
// Pure.
#pragma once

#include <QString>

#include "robot/localization.h"

namespace mapwright::jobs {

/// What happens when a map or a pose is set, to be said before.
QString poseWarning();
/// Why this pose is not sent at all; empty if it is valid.
QString noPoseReason(const geometry::Pose2& pose);

/// How the pose that the robot reports differs from the one that it was given.
struct PoseDeviation {
  double metres = 0, radians = 0;
  /// It holds it, as far as a robot that moves on, or that adjusts it, can.
  bool as_asked = false;
};
PoseDeviation deviation(const robot::PoseOrder& order, const geometry::Pose2& now);
/// "The robot says that it is at x 1.20 m, y 3.00 m, 90.0°: 0.03 m and 0.4° from the pose that was set."
QString poseReport(const robot::PoseOrder& order, const geometry::Pose2& now);
/// "x 1.20 m, y 3.00 m, 90.0°".
QString poseWords(const geometry::Pose2& pose);
/// The result of a search: "It found itself at …", "It proposes …", "It did not find itself: …".
QString searchReport(const map::GlobalPositioning& found);
/// It is where it says.
bool foundItself(const map::GlobalPositioning& found);

}  // namespace mapwright::jobs
