// A robot without a session, for commands that follow it until they are stopped.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QEventLoop>
#include <QObject>
#include <QSocketNotifier>

#include "app/commands.h"
#include "robot/robot.h"

namespace mapwright::app {

/// Sets up such a command, runs `work` and prints why it failed. Returns the exit code.
int runLive(int& argc, char** argv, const std::function<CommandResult<int>()>& work);

/// SIGINT and SIGTERM end its loop; use it within runLive().
class LiveRobot {
 public:
  /// The robot of `args`, not yet connected.
  static CommandResult<std::unique_ptr<LiveRobot>> make(const RobotArguments& args);
  ~LiveRobot();

  robot::Robot& robot() const { return *robot_; }
  /// Waits until it is online, refuses, or --timeout is over. nullopt: it is online, or the command was
  /// stopped.
  std::optional<CommandFailure> connectToRobot();
  /// Until quit(), a signal or the end of `seconds`; returns at once if a signal has come already.
  void follow(std::optional<double> seconds);
  void quit() { loop_.quit(); }
  bool stopped() const { return stopped_; }

 private:
  LiveRobot(std::unique_ptr<robot::Robot> robot, double timeout_s);

  std::unique_ptr<robot::Robot> robot_;
  double timeout_s_;
  QEventLoop loop_;
  bool stopped_ = false;
  int signals_;
  std::unique_ptr<QSocketNotifier> notifier_;
};

}  // namespace mapwright::app
