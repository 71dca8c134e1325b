// A robot whose SLAM session is a file on this computer.
#pragma once

#include "robot/robot.h"

namespace mapwright::robot {

/// Called on the thread that made the robot.
class SlamFile {
 public:
  virtual ~SlamFile() = default;
  /// Absolute. Also of one that is not there or cannot be read.
  virtual QString slamFilePath() const = 0;
};

/// Empty: its session comes from somewhere else.
inline QString slamFileOf(Robot& robot) {
  const auto* const file = dynamic_cast<SlamFile*>(&robot);
  return file ? file->slamFilePath() : QString();
}

}  // namespace mapwright::robot
