// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::json::fault {

using namespace mapwright::fault;  // what all rooms share

/// line, column
inline constexpr FaultCode NotJson{"json", QT_TRANSLATE_NOOP("json", "line %1, column %2")};
inline constexpr FaultCode TextEnds{"json", QT_TRANSLATE_NOOP("json", "the text ends too early")};
inline constexpr FaultCode TextGoesOn{"json",
                                      QT_TRANSLATE_NOOP("json", "something follows the end of the JSON")};
inline constexpr FaultCode NoValue{"json", QT_TRANSLATE_NOOP("json", "a value is expected here")};
inline constexpr FaultCode NoName{
    "json", QT_TRANSLATE_NOOP("json", "the name of a member is expected here, in quotes")};
/// what is expected: ":"
inline constexpr FaultCode NoSign{"json", QT_TRANSLATE_NOOP("json", "%1 is expected here")};
inline constexpr FaultCode BadNumber{"json", QT_TRANSLATE_NOOP("json", "this is not a number")};
inline constexpr FaultCode BadString{
    "json", QT_TRANSLATE_NOOP("json", "this string has a control character or an unknown escape")};
inline constexpr FaultCode TooDeep{"json",
                                   QT_TRANSLATE_NOOP("json", "objects and lists are nested too deeply")};
inline constexpr FaultCode TooLong{"json", QT_TRANSLATE_NOOP("json", "the text is too long")};
inline constexpr FaultCode NotUtf8{"json", QT_TRANSLATE_NOOP("json", "the text is not UTF-8")};

}  // namespace mapwright::json::fault
