// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::overlays::fault {

using namespace mapwright::fault;  // what all rooms share

/// line, column
inline constexpr FaultCode NotJson{"overlays", QT_TRANSLATE_NOOP("overlays", "line %1, column %2")};
inline constexpr FaultCode TextEnds{"overlays", QT_TRANSLATE_NOOP("overlays", "the text ends too early")};
inline constexpr FaultCode TextGoesOn{"overlays",
                                      QT_TRANSLATE_NOOP("overlays", "something follows the end of the JSON")};
inline constexpr FaultCode NoValue{"overlays", QT_TRANSLATE_NOOP("overlays", "a value is expected here")};
inline constexpr FaultCode NoName{
    "overlays", QT_TRANSLATE_NOOP("overlays", "the name of a member is expected here, in quotes")};
/// what is expected: ":"
inline constexpr FaultCode NoSign{"overlays", QT_TRANSLATE_NOOP("overlays", "%1 is expected here")};
inline constexpr FaultCode BadNumber{"overlays", QT_TRANSLATE_NOOP("overlays", "this is not a number")};
inline constexpr FaultCode BadString{
    "overlays", QT_TRANSLATE_NOOP("overlays", "this string has a control character or an unknown escape")};
inline constexpr FaultCode TooDeep{"overlays",
                                   QT_TRANSLATE_NOOP("overlays", "objects and lists are nested too deeply")};
inline constexpr FaultCode TooLong{"overlays", QT_TRANSLATE_NOOP("overlays", "the text is too long")};
inline constexpr FaultCode NotUtf8{"overlays", QT_TRANSLATE_NOOP("overlays", "the text is not UTF-8")};
inline constexpr FaultCode NoCollection{
    "overlays", QT_TRANSLATE_NOOP("overlays", "it is not a GeoJSON FeatureCollection")};

}  // namespace mapwright::overlays::fault
