// Whether a request that failed is worth asking again. Pure.
#pragma once

#include "map/failure.h"

namespace mapwright::map {

/// The server had trouble of its own (HTTP 500 to 599), and said nothing about the request: asked again it
/// may answer.
inline bool mayPass(const Failure& failure) {
  return failure.kind == FailureKind::RejectedByRobot && failure.robot_code.size() == 3 &&
         failure.robot_code.front() == '5';
}

}  // namespace mapwright::map
