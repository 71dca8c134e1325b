#include "robot/ros/kabam_failures.h"

#include <utility>

#include "robot/ros/faults.h"

namespace mapwright::robot::ros {

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
