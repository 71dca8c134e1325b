// Waits for a connection, for commands without a session.
#pragma once

#include <optional>

#include <QEventLoop>

#include "app/command_failure.h"
#include "robot/robot.h"

namespace mapwright::app {

/// Connects and runs `loop` until the robot is online, refuses, or the time is over. If something else ends
/// the loop, the caller has to check why. nullopt: it is online, or the loop was ended.
std::optional<CommandFailure> connectWithin(robot::Robot& robot, double timeout_s, QEventLoop& loop);

}  // namespace mapwright::app
