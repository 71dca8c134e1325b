// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::compare::fault {

using namespace mapwright::fault;  // what all rooms share

/// path; because: why
inline constexpr FaultCode PictureNotRead{"compare", QT_TRANSLATE_NOOP("compare", "%1 cannot be read")};
/// size, the most
inline constexpr FaultCode PictureTooLarge{
    "compare", QT_TRANSLATE_NOOP("compare", "it has %1 pixels, but at most %2 can be compared")};
inline constexpr FaultCode PictureAnimated{
    "compare", QT_TRANSLATE_NOOP("compare", "it is an animation, and only single pictures can be compared")};
/// rows that came, size; because: what ends it
inline constexpr FaultCode PictureEndsEarly{
    "compare", QT_TRANSLATE_NOOP("compare", "it is %2 pixels, but only %1 rows of it can be read")};
/// path, its size, that of the expected picture
inline constexpr FaultCode MaskOfOtherSize{
    "compare", QT_TRANSLATE_NOOP("compare", "The mask %1 is %2 pixels, but the expected picture is %3.")};

}  // namespace mapwright::compare::fault
