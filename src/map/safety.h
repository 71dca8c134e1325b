// Conditions that anyone near or watching a robot must know at once: a pressed emergency stop, lost
// localization, a reported error. Derived from the state alone, so that every place shows the same.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "map/problem.h"

namespace mapwright::map {

struct LiveState;

/// In order of importance within the same severity.
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
  double since_s = 0;                   // seconds since the epoch: when it began, ignoring short pauses
  int times = 1;                        // how often it has begun since then
  std::optional<double> ended_s;        // it has ended, at least for now
  bool operator==(const SafetyCondition&) const = default;
};

/// If it comes back within this time it did not end: it is intermittent.
constexpr double kSafetyPauseS = 10;
/// An intermittent condition stays visible this long after its last end, so that it does not flicker.
constexpr double kSafetyHoldS = 5;
/// From this many starts on it is intermittent.
constexpr int kSafetyFlaps = 3;

/// Updates `before` with what `live` says at `at_s`: starts, ends, and short pauses. For the reducer.
std::vector<SafetyCondition> continuedSafety(std::vector<SafetyCondition> before, const LiveState& live,
                                             double at_s);

/// What is active or intermittent at `now_s`; most severe first, then oldest.
std::vector<SafetyCondition> safetyOf(const LiveState& live, double now_s);

/// How long the result of safetyOf() stays valid if no message arrives; nullopt = forever.
std::optional<double> safetyChangesAt(const LiveState& live, double now_s);

/// The same for the same condition, regardless of its numbers and times.
std::string safetyIdentity(const SafetyCondition& condition);

/// For the list of problems.
Problem problemOf(const SafetyCondition& condition);

}  // namespace mapwright::map
