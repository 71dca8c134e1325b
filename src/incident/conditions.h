// What the robot itself says of its safety at a moment, and since when, message by message. Unlike
// map::safetyOf(), which keeps a window from flickering, nothing is held and no pause is bridged. Pure.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "map/safety.h"
#include "replay/digest.h"

namespace mapwright::incident {

struct Condition {
  /// `since_s`: the first message that said so, with none since then that did not. An alert with other words
  /// is another one, also where only a number in them differs.
  map::SafetyCondition said;
  /// Of an alert: since when the robot has reported one of this code, whatever the words. Never after
  /// since_s.
  double code_since_s = 0;
  bool operator==(const Condition&) const = default;
};

struct Conditions {
  std::vector<Condition> all;  // most severe first, then oldest
  /// Since when localization has been lost or uncertain without a break; nullopt: it is neither.
  std::optional<double> poor_since_s;
  bool operator==(const Conditions&) const = default;
};

/// From the messages with a stamp of at most `at_s`.
Conditions conditionsAt(const std::map<replay::Tick, replay::Digest>& digests, double at_s);

}  // namespace mapwright::incident
