// Recordings on this computer as operands of the command line.
#pragma once

#include <memory>
#include <string>

#include <QString>

#include "robot/robot.h"

namespace mapwright::app {

/// `bag` is the bag or file as typed, `robot` the address given with it, `otherwise` the default address
/// (MAPWRIGHT_ROBOT, or given before the subcommand). If no robot is given and the file exists, it means the
/// file; with only a default robot, whose bags may have the same name, only if it is written as a path or
/// ends in .mcap. Then `robot` becomes the address of the file and `bag` its name there; otherwise an empty
/// `robot` becomes `otherwise`.
void takeRecording(std::string& robot, std::string& bag, const std::string& otherwise);

/// True if it is an existing file, or written like a path or a recording's name.
bool isFileName(const QString& typed);

/// A recording to replay: only its bag is used. `name`: that of its bag.
struct OpenedRecording {
  std::unique_ptr<robot::Robot> robot;
  std::string name;
};
OpenedRecording openRecording(const QString& path);

}  // namespace mapwright::app
