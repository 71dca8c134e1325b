#include "robot/ros/kabam_failures.h"

#include <utility>

#include "robot/ros/faults.h"

namespace mapwright::robot::ros {

map::Failure notThere(map::Subject subject) {
  return {.kind = map::FailureKind::RejectedByRobot,
          .subject = std::move(subject),
          .reason = map::FailureReason::NotThere};
}

map::Failure unsupported(map::Subject subject, Fault cause) {
  map::Failure failure;
  failure.kind = map::FailureKind::Unsupported;
  failure.subject = std::move(subject);
  failure.reason = cause.any() ? map::FailureReason::Unfit : map::FailureReason::NotOffered;
  failure.cause = std::move(cause);
  return failure;
}

map::Failure unconfirmed(map::Subject subject, std::chrono::milliseconds within) {
  map::Failure failure;
  failure.kind = map::FailureKind::TimedOut;
  failure.subject = std::move(subject);
  failure.applied = map::Applied::Maybe;
  failure.asked_for = map::AskedFor::Change;
  failure.cause = {fault::NotConfirmed, {std::int64_t((within.count() + 999) / 1000)}};
  return failure;
}

map::Failure cancelled(map::Subject subject) {
  map::Failure failure;
  failure.kind = map::FailureKind::Cancelled;
  failure.subject = std::move(subject);
  failure.applied = map::Applied::Maybe;
  failure.asked_for = map::AskedFor::Change;
  return failure;
}

}  // namespace mapwright::robot::ros
