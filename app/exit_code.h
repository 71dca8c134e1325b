// Exit codes of every subcommand (docs/troubleshooting.md).
#pragma once

#include "map/failure.h"
#include "map/problem.h"

namespace mapwright::app {

enum ExitCode : int {
  kDone = 0,
  kIncomplete = 1,   // done, but incomplete or unconfirmed
  kUsage = 2,        // wrong usage or bad input file
  kUnreachable = 3,  // the robot cannot be reached or refused
  kRobotError = 4,   // the robot answered with an error for this request
};

/// The exit code for a failed request; `otherwise` if its kind is unknown.
constexpr ExitCode exitCodeOf(map::FailureKind failure, ExitCode otherwise = kRobotError) {
  switch (failure) {
    case map::FailureKind::Unreachable:
    case map::FailureKind::TimedOut:
    case map::FailureKind::Refused:
    case map::FailureKind::NotARobot:
    case map::FailureKind::Certificate:
      return kUnreachable;
    case map::FailureKind::RejectedByRobot:
    case map::FailureKind::MalformedAnswer:
    case map::FailureKind::Conflict:
    case map::FailureKind::Unsupported:
      return kRobotError;
    case map::FailureKind::None:
    case map::FailureKind::Cancelled:
      break;
  }
  return otherwise;
}

/// An id that is none was typed. A change that may have taken effect, whatever became of its answer, is
/// incomplete: neither refused nor unreachable.
inline ExitCode exitCodeOf(const map::Failure& failure) {
  // Nothing was requested.
  if (failure.reason == map::FailureReason::NoSuchId) return kUsage;
  const ExitCode code = exitCodeOf(failure.kind);
  return map::changes(failure.asked_for) && failure.applied != map::Applied::No ? kIncomplete : code;
}

}  // namespace mapwright::app
