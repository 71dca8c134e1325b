#include "robot/ros/ros_calls.h"

#include <memory>
#include <utility>

#include "robot/ros/faults.h"

namespace mapwright::robot::ros {

using net::rosbridge::CallAnswer;
using net::rosbridge::Client;

void call(const wire::TaskPtr& task, Client& client, net::rosbridge::CallRequest request,
          Client::Reply reply) {
  const auto number = std::make_shared<int>(0);
  const quint64 id = client.call(std::move(request), [task, number, reply](const CallAnswer& answer) {
    task->ended(*number);
    reply(answer);
  });
  *number = task->begun([&client, id] { client.cancel(id); });
}

map::Failure failed(const CallAnswer& answer, map::Subject subject, map::AskedFor asked_for) {
  using Kind = CallAnswer::Kind;
  map::Failure failure;
  failure.subject = std::move(subject);
  failure.asked_for = asked_for;
  failure.detail = answer.words;
  const bool change = asked_for == map::AskedFor::Change;
  if (change) failure.applied = answer.sent ? map::Applied::Maybe : map::Applied::No;
  switch (answer.kind) {
    case Kind::Answered:
    case Kind::Malformed:
      failure.kind = map::FailureKind::MalformedAnswer;
      break;
    case Kind::Refused:
      failure.kind = map::FailureKind::RejectedByRobot;
      break;
    case Kind::TimedOut:
      failure.kind = map::FailureKind::TimedOut;
      if (failure.detail.empty()) failure.cause = {fault::NoAnswerInTime};
      break;
    case Kind::LinkLost:
      failure.kind = map::FailureKind::Unreachable;
      if (failure.detail.empty()) failure.cause = {fault::LinkBrokeOff};
      break;
    case Kind::Cancelled:
      failure.kind = map::FailureKind::Cancelled;
      break;
  }
  return failure;
}

}  // namespace mapwright::robot::ros
