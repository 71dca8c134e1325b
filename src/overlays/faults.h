// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::overlays::fault {

using namespace mapwright::fault;  // what all rooms share

inline constexpr FaultCode NoCollection{
    "overlays", QT_TRANSLATE_NOOP("overlays", "it is not a GeoJSON FeatureCollection")};

// What somebody hands in; number of the feature first.
inline constexpr FaultCode PastedNothing{"overlays",
                                         QT_TRANSLATE_NOOP("overlays", "it contains no overlays")};
inline constexpr FaultCode PastedWithoutPlace{"overlays",
                                              QT_TRANSLATE_NOOP("overlays", "feature %1 has no place")};

// Flaws of features; each is a sentence.
inline constexpr FaultCode NoArea{"overlays", QT_TRANSLATE_NOOP("overlays", "Its outline encloses no area.")};

}  // namespace mapwright::overlays::fault
