#include "map/safety.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <tuple>

#include "map/faults.h"
#include "map/live_state.h"

namespace mapwright::map {
namespace {

constexpr int kLost = 1, kPoor = 3;  // SlamStatus::position_quality

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

std::optional<SafetyCondition> ofPosition(const SlamStatus& slam) {
  // While it maps, or is inactive, it has no position that could be lost.
  const std::string state = lower(slam.state);
  if (state == "inactive" || state == "slam") return std::nullopt;
  const int quality = slam.position_quality.value_or(0);
  SafetyCondition condition;
  const bool unreliable = slam.reliable == false;
  if (quality == kLost || (unreliable && quality == 0)) {
    condition.kind = SafetyKind::PositionLost;
  } else if (unreliable || (quality > kLost && quality <= kPoor)) {
    condition.kind = SafetyKind::PositionUncertain;
    condition.severity = Severity::Warning;
  } else {
    return std::nullopt;
  }
  return condition;
}

/// The conditions of the state, without times.
std::vector<SafetyCondition> conditionsOf(const LiveState& live) {
  std::vector<SafetyCondition> now;
  const auto add = [&](SafetyKind kind, Severity severity) {
    now.push_back({kind, severity, 0, {}, 0, 1, {}});
  };
  if (live.wheels) {
    if (live.wheels->emergency_stop == true) add(SafetyKind::EmergencyStop, Severity::Error);
    if (live.wheels->wheels_released == true) add(SafetyKind::WheelsReleased, Severity::Warning);
    if (lower(live.wheels->control_mode) == "manual") add(SafetyKind::ManualControl, Severity::Warning);
  }
  if (auto position = ofPosition(live.slam)) now.push_back(*std::move(position));
  if (live.slam.wheel_slipping == true) add(SafetyKind::WheelsSlipping, Severity::Warning);
  for (const Alert& alert : live.alerts) {
    if (alert.level == AlertLevel::None) continue;
    const bool error = alert.level == AlertLevel::Error;
    now.push_back(
        {SafetyKind::Alert, error ? Severity::Error : Severity::Warning, alert.code, alert.text, 0, 1, {}});
  }
  return now;
}

bool flaps(const SafetyCondition& condition) { return condition.times >= kSafetyFlaps; }

bool held(const SafetyCondition& condition, double now_s) {
  return flaps(condition) && now_s - *condition.ended_s < kSafetyHoldS;
}

}  // namespace

std::string safetyIdentity(const SafetyCondition& condition) {
  std::string identity = std::to_string(int(condition.kind)) + '/' + std::to_string(condition.code) + '/';
  // "82 degrees" is the same alert as "81 degrees".
  std::copy_if(condition.text.begin(), condition.text.end(), std::back_inserter(identity),
               [](unsigned char c) { return !std::isdigit(c); });
  return identity;
}

std::vector<SafetyCondition> continuedSafety(std::vector<SafetyCondition> before, const LiveState& live,
                                             double at_s) {
  // Several may differ only in their numbers ("Motor 1 is hot", "Motor 2 is hot"): each continues one.
  std::multimap<std::string, SafetyCondition*> known;
  for (SafetyCondition& condition : before) known.emplace(safetyIdentity(condition), &condition);
  std::vector<SafetyCondition> after;
  for (SafetyCondition& now : conditionsOf(live)) {
    now.since_s = at_s;
    const auto same = known.find(safetyIdentity(now));
    if (same != known.end()) {
      const SafetyCondition& then = *same->second;
      const bool over = then.ended_s && at_s - *then.ended_s > kSafetyPauseS;
      if (!over) {
        now.since_s = std::min(then.since_s, at_s);
        now.times = then.times + (then.ended_s ? 1 : 0);
      }
      known.erase(same);
    }
    after.push_back(std::move(now));
  }
  for (auto& [identity, gone] : known) {
    if (!gone->ended_s) gone->ended_s = at_s;
    if (at_s - *gone->ended_s <= kSafetyPauseS) after.push_back(std::move(*gone));
  }
  return after;
}

std::vector<SafetyCondition> safetyOf(const LiveState& live, double now_s) {
  std::vector<SafetyCondition> now;
  std::copy_if(live.safety.begin(), live.safety.end(), std::back_inserter(now),
               [&](const SafetyCondition& each) { return !each.ended_s || held(each, now_s); });
  std::stable_sort(now.begin(), now.end(), [](const SafetyCondition& a, const SafetyCondition& b) {
    return std::tuple(-int(a.severity), int(a.kind), a.since_s) <
           std::tuple(-int(b.severity), int(b.kind), b.since_s);
  });
  return now;
}

std::optional<double> safetyChangesAt(const LiveState& live, double now_s) {
  std::optional<double> next;
  for (const SafetyCondition& each : live.safety) {
    if (each.ended_s && held(each, now_s))
      next = std::min(next.value_or(1e300), *each.ended_s + kSafetyHoldS);
  }
  return next;
}

Problem problemOf(const SafetyCondition& condition) {
  const auto found = [&](const char* id, FaultCode code) {
    return Problem{condition.severity, Subject(SubjectKind::Condition, id), code};
  };
  switch (condition.kind) {
    case SafetyKind::EmergencyStop:
      return found("emergency-stop", fault::EmergencyStop);
    case SafetyKind::PositionLost:
      return found("position-lost", faultText("map", "The position of the robot on the map may be wrong."));
    case SafetyKind::WheelsReleased:
      return found(
          "wheels-released",
          faultText("map", "The wheels are released: the robot can be pushed and may roll on a slope."));
    case SafetyKind::ManualControl:
      return found("manual-control", faultText("map", "The robot does not drive on its own."));
    case SafetyKind::PositionUncertain:
      return found("position-uncertain", faultText("map", "The robot may be off its position on the map."));
    case SafetyKind::WheelsSlipping:
      return found("wheels-slipping", faultText("map", "The robot may not be where its odometry says."));
    case SafetyKind::Alert:
      break;
  }
  const std::string id = condition.code == 0 ? "alert" : "alert:" + std::to_string(condition.code);
  return {condition.severity, Subject(SubjectKind::Condition, id),
          condition.text.empty() ? Fault(faultText("map", "The robot gives no further text."))
                                 : fault::said(condition.text)};
}

}  // namespace mapwright::map
