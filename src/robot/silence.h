// A robot whose link notices that it has gone silent, long before it is given up.
#pragma once

#include <optional>

#include <QDateTime>

#include "robot/robot.h"

namespace mapwright::robot {

/// Called on the thread that made the robot.
class MeasuresSilence {
 public:
  virtual ~MeasuresSilence() = default;
  /// When the robot was heard last, once that is longer ago than is usual with it, be it Online, and while
  /// the link is lost; invalid: nothing is amiss, or it has never been heard. Another one is told by
  /// Robot::connectionChanged(), before the loss itself.
  virtual QDateTime silentSince() const = 0;
};

/// nullopt as above, or nobody measures it.
inline std::optional<QDateTime> silentSince(const Robot& robot) {
  const auto* const measured = dynamic_cast<const MeasuresSilence*>(&robot);
  const QDateTime since = measured ? measured->silentSince() : QDateTime();
  return since.isValid() ? std::optional(since) : std::nullopt;
}

}  // namespace mapwright::robot
