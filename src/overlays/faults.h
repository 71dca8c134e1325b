// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::overlays::fault {

using namespace mapwright::fault;  // what all rooms share

inline constexpr FaultCode NoCollection{
    "overlays", QT_TRANSLATE_NOOP("overlays", "it is not a GeoJSON FeatureCollection")};
inline constexpr FaultCode SeveralLists{
    "overlays", QT_TRANSLATE_NOOP("overlays", "it has more than one list of features")};

// What somebody hands in; number of the feature first.
inline constexpr FaultCode PastedNothing{"overlays",
                                         QT_TRANSLATE_NOOP("overlays", "it contains no overlays")};
inline constexpr FaultCode PastedWithoutPlace{"overlays",
                                              QT_TRANSLATE_NOOP("overlays", "feature %1 has no place")};

// Flaws of features; each is a sentence.
/// as written
inline constexpr FaultCode BadCoordinate{
    "overlays", QT_TRANSLATE_NOOP("overlays", "This is not a usable coordinate: %1")};
inline constexpr FaultCode NoPoints{"overlays", QT_TRANSLATE_NOOP("overlays", "Its geometry has no points.")};
/// the type
inline constexpr FaultCode GeometryUnknown{
    "overlays", QT_TRANSLATE_NOOP("overlays", "Its geometry is of an unknown type: %1")};
inline constexpr FaultCode NoFeature{
    "overlays", QT_TRANSLATE_NOOP("overlays", "This is no GeoJSON Feature, so it is not shown.")};
/// name
inline constexpr FaultCode MemberTwice{
    "overlays", QT_TRANSLATE_NOOP("overlays", "Its \"%1\" is written twice. The last one counts.")};
inline constexpr FaultCode NoArea{"overlays", QT_TRANSLATE_NOOP("overlays", "Its outline encloses no area.")};

}  // namespace mapwright::overlays::fault
