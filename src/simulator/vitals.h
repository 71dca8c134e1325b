// How the robot is: what its battery, its wheels and its alerts tell, so that they agree.
#pragma once

#include <string>

#include "simulator/robot_state.h"

namespace mapwright::simulator {

struct Vitals {
  double battery = 1;  // 0..1
  bool charging = false;
  std::string control_mode;  // auto, remote, manual
  bool emergency_stop = false;
  bool positioned = true;
};

/// Below this, the robot warns about its battery.
constexpr double kLowBattery = 0.2;

Vitals vitalsOf(const RobotState& state);

/// The remainder that is never negative: recordings reach back before the robot's world began.
double phaseOf(double value, double period);

}  // namespace mapwright::simulator
