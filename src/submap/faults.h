// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::submap::fault {

using namespace mapwright::fault;  // what all rooms share

// The place of a submap.
inline constexpr FaultCode TurnIsZero{"submap",
                                      QT_TRANSLATE_NOOP("submap", "its orientation is a zero quaternion")};
/// because: why
inline constexpr FaultCode CannotBePlaced{"submap", QT_TRANSLATE_NOOP("submap", "Its position is unknown")};
/// version; because: why
inline constexpr FaultCode VersionCannotBePlaced{
    "submap", QT_TRANSLATE_NOOP("submap", "The position of version %1 is unknown")};

// The list of submaps.
/// how many
inline constexpr FaultCode ListedWithoutVersion{
    "submap",
    QT_TRANSLATE_N_NOOP("submap",
                        "%1 submaps are listed without a valid version. They are asked for from time "
                        "to time.")};

// The pictures of submaps.
inline constexpr FaultCode SlicePoseUnusable{
    "submap",
    QT_TRANSLATE_NOOP("submap",
                      "its slice pose is not valid (a number that is not finite, or a zero quaternion)")};
/// slice; because: what is wrong with it
inline constexpr FaultCode OneSlice{"submap", QT_TRANSLATE_NOOP("submap", "slice %1"),
                                    FaultCode::Causes::Continued};
/// version; because: what is wrong with its slices
inline constexpr FaultCode VersionBroken{"submap", QT_TRANSLATE_NOOP("submap", "Version %1 is broken")};

}  // namespace mapwright::submap::fault
