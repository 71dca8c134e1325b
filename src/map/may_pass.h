// Whether a failed request is worth repeating. Pure.
#pragma once

#include "map/failure.h"

namespace mapwright::map {

/// The server has a problem of its own (HTTP 500 to 599) that is unrelated to the request: a repetition may
/// succeed.
inline bool mayPass(const Failure& failure) {
  return failure.kind == FailureKind::RejectedByRobot && failure.robot_code.size() == 3 &&
         failure.robot_code.front() == '5';
}

}  // namespace mapwright::map
