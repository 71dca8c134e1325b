// What people near a robot, and whoever watches it, must know at once: a pressed emergency stop, a lost
// position, an error that the robot reports. Told by its state alone, so that every place that shows it
// shows the same.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "map/problem.h"

namespace mapwright::map {

struct LiveState;

/// The order of their weight among equals in severity.
enum class SafetyKind {
  EmergencyStop,
  PositionLost,
  Alert,  // what the robot itself reports
  WheelsReleased,
  ManualControl,
  PositionUncertain,
  WheelsSlipping,
};

struct SafetyCondition {
  SafetyKind kind = SafetyKind::Alert;
  Severity severity = Severity::Error;  // never Info
  std::int64_t code = 0;                // of an alert; 0 = none
  std::string text;                     // of an alert; untrusted
  double since_s = 0;             // seconds since the epoch: when it began, pauses that are short left out
  int times = 1;                  // how often it began since then
  std::optional<double> ended_s;  // it is over, at least for now
  bool operator==(const SafetyCondition&) const = default;
};

/// One that comes back within this time never went: it is on and off.
constexpr double kSafetyPauseS = 10;
/// One that is on and off stays on show this long after its last end: else it would only flicker.
constexpr double kSafetyHoldS = 5;
/// From so many beginnings on it is on and off.
constexpr int kSafetyFlaps = 3;

/// `before` carried on to what `live` says at `at_s`: beginnings, ends, and short pauses. For the reducer.
std::vector<SafetyCondition> continuedSafety(std::vector<SafetyCondition> before, const LiveState& live,
                                             double at_s);

/// What holds at `now_s`, and what is on and off; the gravest first, then the oldest.
std::vector<SafetyCondition> safetyOf(const LiveState& live, double now_s);

/// Until when safetyOf() stays what it is, if no message comes; nullopt = for ever.
std::optional<double> safetyChangesAt(const LiveState& live, double now_s);

/// The same condition, whatever its numbers and times are now.
std::string safetyIdentity(const SafetyCondition& condition);

/// For the list of problems.
Problem problemOf(const SafetyCondition& condition);

}  // namespace mapwright::map
