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
  using Kind = map::FailureKind;
  constexpr Kind kKinds[] = {Kind::MalformedAnswer, Kind::RejectedByRobot, Kind::TimedOut,
                             Kind::Unreachable,     Kind::Cancelled,       Kind::MalformedAnswer};
  map::Failure failure;
  failure.kind = kKinds[int(answer.kind)];
  failure.subject = std::move(subject);
  failure.asked_for = asked_for;
  failure.detail = answer.words;
  const bool change = map::changes(asked_for);
  if (change) failure.applied = answer.sent ? map::Applied::Maybe : map::Applied::No;
  if (failure.detail.empty() && failure.kind == Kind::TimedOut) failure.cause = fault::NoAnswerInTime;
  if (failure.detail.empty() && failure.kind == Kind::Unreachable) failure.cause = fault::LinkBrokeOff;
  return failure;
}

map::Failure failed(wire::WaitList::End how, map::Subject subject, FaultCode late, FaultCode dropped) {
  using End = wire::WaitList::End;
  map::Failure failure{.kind = map::FailureKind::Cancelled, .subject = std::move(subject)};
  if (how == End::TooLate) {
    failure.kind = map::FailureKind::TimedOut;
    failure.cause = late;
  } else if (how == End::Dropped) {
    failure.kind = map::FailureKind::Unreachable;
    failure.cause = dropped;
  }
  return failure;
}

bool isFinal(const map::Failure& of_change) {
  return of_change.applied == map::Applied::No || of_change.kind == map::FailureKind::Cancelled ||
         of_change.kind == map::FailureKind::Unreachable;
}

map::Failure unsupported(map::Subject subject, Fault cause) {
  const bool told = cause.any();
  return {.kind = map::FailureKind::Unsupported,
          .subject = std::move(subject),
          .reason = told ? map::FailureReason::Unfit : map::FailureReason::NotOffered,
          .cause = std::move(cause)};
}

map::Failure unconfirmed(map::Subject subject, std::chrono::milliseconds within) {
  return {.kind = map::FailureKind::TimedOut,
          .subject = std::move(subject),
          .applied = map::Applied::Maybe,
          .asked_for = map::AskedFor::Change,
          .cause = {fault::NotConfirmed, {std::int64_t((within.count() + 999) / 1000)}}};
}

map::Failure cancelled(map::Subject subject) {
  return {.kind = map::FailureKind::Cancelled,
          .subject = std::move(subject),
          .applied = map::Applied::Maybe,
          .asked_for = map::AskedFor::Change};
}

}  // namespace mapwright::robot::ros
