// Submaps whose version the robot does not say.
#pragma once

#include <cstdint>

namespace mapwright::map {

/// Of a SubmapEntry: no version is listed, or none that is one (negative, not a number). Of a SubmapKey:
/// asked for without one.
inline constexpr std::int32_t kNoVersion = -1;

}  // namespace mapwright::map
