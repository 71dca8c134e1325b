// Requests that tell an Autoxing robot where it is. Lives on the link's thread. Source:
// docs/protocols/autoxing.md, "What changes a robot".
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include <QStringList>

#include "robot/axbot/robot_urls.h"
#include "robot/localization.h"
#include "robot/wire/task.h"

namespace mapwright::robot::axbot {

class PoseRequests {
 public:
  using Task = wire::TaskPtr;
  struct Patience {
    std::chrono::milliseconds pose{2'000};     // of the pose that was set
    std::chrono::milliseconds search{90'000};  // of the result of a search
    std::chrono::milliseconds held{1'000};     // of what the robot sends to whoever subscribes
  };
  /// `hold`: subscribes to these topics besides those that are wanted; none = no longer.
  PoseRequests(RobotServer server, std::function<void(const QStringList&)> hold, Patience patience)
      : server_(std::move(server)), hold_(std::move(hold)), patience_(patience) {}

  /// Sent once; then the pose that the robot reports is waited for, also if the answer is lost.
  void setPose(const Task& task, const PoseOrder& order, OutcomeTo<geometry::Pose2> reply);
  void findItself(const Task& task, OutcomeTo<map::GlobalPositioning> reply);
  /// Every message of the robot.
  void hear(const map::TopicMessage& message);

 private:
  void sendPose(const Task& task, const PoseOrder& order, OutcomeTo<geometry::Pose2> reply);
  void awaitPose(const Task& task, const PoseOrder& order, std::optional<geometry::Pose2> before,
                 std::optional<map::Failure> doubt, OutcomeTo<geometry::Pose2> reply);
  void awaitResult(const Task& task, std::chrono::milliseconds patience, std::optional<map::Failure> doubt,
                   OutcomeTo<map::GlobalPositioning> reply);
  void begin();
  void end();

  const RobotServer server_;
  const std::function<void(const QStringList&)> hold_;
  const Patience patience_;
  wire::WaitList waits_;
  int in_progress_ = 0;
  std::optional<geometry::Pose2> pose_;           // the last one since a request began, or was answered
  std::optional<map::GlobalPositioning> result_;  // the last one, whatever it is of
  bool searching_ = false;                        // it reported that since a request was sent
};

}  // namespace mapwright::robot::axbot
