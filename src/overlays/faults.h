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
inline constexpr FaultCode PastedNoFeature{
    "overlays", QT_TRANSLATE_NOOP("overlays", "number %1 in the list is no feature")};
inline constexpr FaultCode PastedWithoutPlace{"overlays",
                                              QT_TRANSLATE_NOOP("overlays", "feature %1 has no place")};
/// its type
inline constexpr FaultCode PastedGeometryUnknown{
    "overlays", QT_TRANSLATE_NOOP("overlays", "the geometry of feature %1 is of an unknown type, \"%2\"")};
/// as written
inline constexpr FaultCode PastedCoordinateUnusable{
    "overlays", QT_TRANSLATE_NOOP("overlays", "feature %1 has a coordinate that cannot be used: %2")};
inline constexpr FaultCode PastedTooFewPoints{"overlays",
                                              QT_TRANSLATE_NOOP("overlays", "feature %1 has too few points")};
/// how many may be
inline constexpr FaultCode PastedTooMany{"overlays",
                                         QT_TRANSLATE_NOOP("overlays", "it contains more than %1 features")};

// Flaws of features; each is a sentence.
/// the id
inline constexpr FaultCode IdTwice{"overlays",
                                   QT_TRANSLATE_NOOP("overlays", "Another feature has the same id, %1.")};
/// the name
inline constexpr FaultCode NameTwice{
    "overlays", QT_TRANSLATE_NOOP("overlays", "Another feature of this kind has the same name, \"%1\".")};
inline constexpr FaultCode OutlineCrossesItself{"overlays",
                                                QT_TRANSLATE_NOOP("overlays", "Its outline crosses itself.")};
inline constexpr FaultCode NoArea{"overlays", QT_TRANSLATE_NOOP("overlays", "Its outline encloses no area.")};
inline constexpr FaultCode LineTooShort{
    "overlays", QT_TRANSLATE_NOOP("overlays", "A line needs at least two different points.")};
inline constexpr FaultCode OutlineTooShort{
    "overlays", QT_TRANSLATE_NOOP("overlays", "An outline needs at least three different points.")};
inline constexpr FaultCode BeyondMap{"overlays", QT_TRANSLATE_NOOP("overlays", "It lies outside the map.")};
inline constexpr FaultCode InWall{"overlays", QT_TRANSLATE_NOOP("overlays", "It lies in a wall.")};
inline constexpr FaultCode NoDock{"overlays",
                                  QT_TRANSLATE_NOOP("overlays", "This charger names no docking point.")};
/// the id of the docking point
inline constexpr FaultCode DockMissing{
    "overlays",
    QT_TRANSLATE_NOOP("overlays", "The docking point of this charger, %1, does not exist, or is none.")};
inline constexpr FaultCode NoMac{"overlays", QT_TRANSLATE_NOOP("overlays", "This door has no MAC address.")};
/// as written
inline constexpr FaultCode CoordinateUnusable{
    "overlays", QT_TRANSLATE_NOOP("overlays", "This is not a usable coordinate: %1")};
/// as written
inline constexpr FaultCode YawUnusable{"overlays",
                                       QT_TRANSLATE_NOOP("overlays", "This is not a usable yaw: %1")};
inline constexpr FaultCode NotReached{
    "overlays", QT_TRANSLATE_NOOP("overlays", "The robot cannot get here from its charger.")};

}  // namespace mapwright::overlays::fault
