// Whether a robot has a capability now, and whether it may still come.
#pragma once

#include "robot/robot.h"

namespace mapwright::robot {

inline bool has(Robot& robot, Capability capability) {
  switch (capability) {
    case Capability::Submaps:
      return robot.submapSource() != nullptr;
    case Capability::WholeMaps:
      return robot.wholeMapSource() != nullptr;
    case Capability::Waypoints:
      return robot.waypointSource() != nullptr;
    case Capability::WaypointEditing:
      return robot.waypointStore() != nullptr;
    case Capability::Live:
      return robot.liveTopics() != nullptr;
    case Capability::Administration:
      return robot.mapAdministration() != nullptr;
    case Capability::PictureEditing:
      return robot.pictureStore() != nullptr;
    case Capability::OverlayEditing:
      return robot.overlayStore() != nullptr;
    case Capability::Bags:
      return robot.bagLibrary() != nullptr;
    case Capability::Dispatch:
      return robot.mapDispatch() != nullptr;
    case Capability::Localization:
      return robot.localization() != nullptr;
    case Capability::MapTransfer:
      return robot.mapTransfer() != nullptr;
    case Capability::PoseGraph:
      return robot.poseGraphSource() != nullptr;
    case Capability::Catalogue:
      return robot.mapCatalogue() != nullptr;
    case Capability::Overview:
      return robot.overviewSource() != nullptr;
  }
  return false;
}

/// It has not got it, and nothing that it may still tell or start would bring it.
inline bool lacksForGood(Robot& robot, Capability capability) {
  if (has(robot, capability)) return false;
  const Absence::Reason reason = robot.unavailableReason(capability).reason;
  return reason != Absence::Reason::NotToldYet && reason != Absence::Reason::NoService;
}

}  // namespace mapwright::robot
