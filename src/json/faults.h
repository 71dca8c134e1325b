// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::json::fault {

using namespace mapwright::fault;  // what all rooms share

inline constexpr FaultCode TextEnds{"json", QT_TRANSLATE_NOOP("json", "the text ends too early")};
/// what is expected: ":"
inline constexpr FaultCode NoSign{"json", QT_TRANSLATE_NOOP("json", "%1 is expected here")};
inline constexpr FaultCode BadNumber{"json", QT_TRANSLATE_NOOP("json", "this is not a number")};
inline constexpr FaultCode BadString{
    "json", QT_TRANSLATE_NOOP("json", "this string has a control character or an unknown escape")};
inline constexpr FaultCode TooLong{"json", QT_TRANSLATE_NOOP("json", "the text is too long")};

}  // namespace mapwright::json::fault
