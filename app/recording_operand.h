// Recordings on this computer as words of the command line.
#pragma once

#include <memory>
#include <string>

#include <QString>

#include "robot/robot.h"

namespace mapwright::app {

/// `bag` is what was typed where a bag or a file may stand, `robot` the address that was named with it and
/// `otherwise` the one that counts where none was (MAPWRIGHT_ROBOT, or before the subcommand). A file is
/// meant where no robot was named and it is there; beside a robot of `otherwise`, whose bags may be called
/// the same, only where it is written as a path or ends in .mcap. Then `robot` becomes its address and `bag`
/// the name that it has there; else `robot` becomes `otherwise` where it is empty.
void takeRecording(std::string& robot, std::string& bag, const std::string& otherwise);

/// Whether it is a file that is there, or is written like a path or like the name of a recording.
bool isFileName(const QString& typed);

/// A recording, to be played: nothing but its bag is of use. `name`: that of its bag.
struct OpenedRecording {
  std::unique_ptr<robot::Robot> robot;
  std::string name;
};
OpenedRecording openRecording(const QString& path);

}  // namespace mapwright::app
