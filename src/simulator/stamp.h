// Simulated time as the robot's clock shows it.
#pragma once

namespace mapwright::simulator {

/// Seconds since the epoch of a simulated second: the robot's world begins on 3 June 2024, 09:00 UTC.
constexpr double stampOf(double time_s) { return 1717405200 + time_s; }

}  // namespace mapwright::simulator
