// A robot whose connection detects silence long before it is given up.
#pragma once

#include <optional>

#include <QDateTime>

#include "robot/robot.h"

namespace mapwright::robot {

/// Called on the thread that made the robot.
class MeasuresSilence {
 public:
  virtual ~MeasuresSilence() = default;
  /// When the robot was last heard, if that is unusually long ago, even while Online, or while the connection
  /// is lost; invalid: all is well, or it was never heard. Robot::connectionChanged() reports changes, before
  /// the loss itself.
  virtual QDateTime silentSince() const = 0;
};

/// nullopt as above, or if silence is not measured.
inline std::optional<QDateTime> silentSince(const Robot& robot) {
  const auto* const measured = dynamic_cast<const MeasuresSilence*>(&robot);
  const QDateTime since = measured ? measured->silentSince() : QDateTime();
  return since.isValid() ? std::optional(since) : std::nullopt;
}

}  // namespace mapwright::robot
