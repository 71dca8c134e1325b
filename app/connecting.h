// Waiting until a robot is there, for commands that have no session with it.
#pragma once

#include <optional>

#include <QEventLoop>

#include "app/command_failure.h"
#include "robot/robot.h"

namespace mapwright::app {

/// Connects, and runs `loop` until the robot is online, refuses, or the time is over; whoever ends the loop
/// earlier looks at why itself. nullopt: it is online, or the loop was ended.
std::optional<CommandFailure> connectWithin(robot::Robot& robot, double timeout_s, QEventLoop& loop);

}  // namespace mapwright::app
