// How requests come to nothing in the same way with all robots.
#pragma once

#include <utility>

#include "map/failure.h"

namespace mapwright::robot::wire {

/// Nobody here has that.
inline map::Failure notThere(map::Subject subject) {
  return {.kind = map::FailureKind::RejectedByRobot,
          .subject = std::move(subject),
          .reason = map::FailureReason::NotThere};
}

/// Robots of this kind, or this one, do nothing of the sort.
inline map::Failure notOffered(map::Subject subject, map::AskedFor asked_for = map::AskedFor::All) {
  return {.kind = map::FailureKind::Unsupported,
          .subject = std::move(subject),
          .asked_for = asked_for,
          .reason = map::FailureReason::NotOffered};
}

/// It came, and cannot be used.
inline map::Failure unfit(map::Subject subject, Fault cause) {
  return {.kind = map::FailureKind::MalformedAnswer,
          .subject = std::move(subject),
          .reason = map::FailureReason::Unfit,
          .cause = std::move(cause)};
}

}  // namespace mapwright::robot::wire
