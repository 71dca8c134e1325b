// What the rest of the robot's path crosses or comes near. Pure.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "map/live_state.h"

namespace mapwright::incident {

/// What the robot has still to drive.
struct Way {
  std::vector<Eigen::Vector2d> points;  // world metres, from the place nearest to the robot; empty: none
  double off_m = 0;                     // how far the robot is from it
  bool local = false;                   // only the local path is known
};
Way remainingWay(const map::LiveState& live);

/// Half the width that the robot needs: of its outline, else of its stated width; 0 = it states neither.
double radiusOf(const map::RobotModel& model);

struct OnTheWay {
  double along_m = 0;  // along the path, to where it comes closer than the radius
  double away_m = 0;   // from the path there; 0: it crosses it, or is inside
  bool here = false;   // the robot is that close already
  map::OverlayShape shape = map::OverlayShape::Line;
  int type = 0;             // of an overlay
  bool seen_door = false;   // one that the robot reports, no overlay
  std::string name, state;  // untrusted
};

/// Virtual walls, regions and doors within `radius_m` of the path; the nearest first.
std::vector<OnTheWay> onTheWay(const Way& way, double radius_m,
                               const std::vector<map::OverlayFeature>& overlays,
                               const std::vector<map::AutoDoor>& doors);

}  // namespace mapwright::incident
