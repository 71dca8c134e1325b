// What happened in a bag, for marks on a time line. Pure.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "replay/chunks.h"
#include "replay/digest.h"

namespace mapwright::replay {

enum class EventKind {
  AlertBegan,      // code, text
  AlertEnded,      // code, text
  MoveState,       // text: the planner's state from now on
  PositionJump,    // metres
  MapChanged,      // text: its name
  SessionChanged,  // text: its uuid; SLAM began anew
  QualityLow,      // the position is lost or poor from now on; code: the quality
  QualityGood,     // and no more
  EmergencyStopOn,
  EmergencyStopOff,
};

struct Event {
  double at_s = 0;
  EventKind kind = EventKind::MoveState;
  std::int64_t code = 0;
  std::string text;  // untrusted
  double metres = 0;
  bool operator==(const Event&) const = default;
};

/// Kinds that people want to see together, or not.
enum class EventGroup { Alerts, Planner, Position, Maps, Stops };
inline constexpr EventGroup kEventGroups[] = {EventGroup::Alerts, EventGroup::Planner, EventGroup::Position,
                                              EventGroup::Maps, EventGroup::Stops};
EventGroup groupOf(EventKind kind);
/// For settings and options, the same for ever: "alerts".
std::string wordOf(EventGroup group);

/// In the order of time. Of ranges that are missing nothing is told: what began or ended there shows where
/// the next one begins. What a bag begins with is an event, but for a move state and the first map.
std::vector<Event> eventsOf(const std::map<Tick, Digest>& digests);

}  // namespace mapwright::replay
