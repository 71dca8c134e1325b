#include "simulator/vitals.h"

#include <cmath>

namespace mapwright::simulator {
namespace {

constexpr double kDayS = 3600;       // a day's work and a charge, in an hour
constexpr double kWorkShare = 0.85;  // of it at work
constexpr double kFull = 0.81, kSpent = 0.15;
constexpr double kWheelsS =
    120;  // the operator's round: remote from 80 s, by hand from 100 s, stopped from 110 s

}  // namespace

double phaseOf(double value, double period) { return value - period * std::floor(value / period); }

Vitals vitalsOf(const RobotState& state) {
  Vitals vitals;
  const double day = phaseOf(state.time(), kDayS) / kDayS;
  vitals.charging = day > kWorkShare;
  vitals.battery = vitals.charging ? kSpent + (kFull - kSpent) * (day - kWorkShare) / (1 - kWorkShare)
                                   : kFull - (kFull - kSpent) * day / kWorkShare;
  const double wheels = phaseOf(state.time(), kWheelsS);
  const Controls controls = state.controls();
  vitals.control_mode = controls.control_mode.value_or(wheels < 80    ? "auto"
                                                       : wheels < 100 ? "remote"
                                                                      : "manual");
  vitals.emergency_stop = controls.emergency_stop.value_or(wheels >= 110);
  vitals.positioned = state.isPositioned();
  return vitals;
}

}  // namespace mapwright::simulator
