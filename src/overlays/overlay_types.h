// The numbers of kinds of features that mean something to the program. Source: docs/protocols/autoxing.md,
// "Overlays".
#pragma once

namespace mapwright::overlays {

// Points: properties.type.
inline constexpr int kCharger = 9;
inline constexpr int kGate = 7, kDoor = 8;
inline constexpr int kRackPoint = 34;
inline constexpr int kDockingPoint = 36;
inline constexpr int kBarcode = 37, kLandmark = 39;
// Lines: lineType.
inline constexpr int kVirtualWall = 2;
// Polygons: regionType.
inline constexpr int kForbiddenRegion = 1;
inline constexpr int kGateRegion = 4, kDoorRegion = 5;
inline constexpr int kFreeRegion = 12;

}  // namespace mapwright::overlays
