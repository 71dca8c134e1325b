// The events and the pauses of a bag, for marks on a timeline. Pure.
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
  MoveState,       // text: the new state of the planner
  PositionJump,    // metres
  MapChanged,      // text: its name
  SessionChanged,  // text: its uuid; SLAM began anew
  QualityLow,      // localization is lost or poor from now on; code: the quality
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

/// Kinds that are shown or hidden together.
enum class EventGroup { Alerts, Planner, Position, Maps, Stops };
inline constexpr EventGroup kEventGroups[] = {EventGroup::Alerts, EventGroup::Planner, EventGroup::Position,
                                              EventGroup::Maps, EventGroup::Stops};
EventGroup groupOf(EventKind kind);
/// For settings and options, never changes: "alerts".
std::string wordOf(EventGroup group);

/// In order of time. Missing ranges give no events: changes inside them appear at the start of the next
/// range. The initial state of a bag counts as events, except a move state and the first map.
std::vector<Event> eventsOf(const std::map<Tick, Digest>& digests);

/// From one message to the next; at the ends of a bag, and next to unread parts, from or to there.
struct Silence {
  double from_s = 0, until_s = 0;
  bool operator==(const Silence&) const = default;
};

/// By time, those of at least kSilenceS within the bag's stated times that are much longer than usual in it.
/// Unread ranges count as unknown.
std::vector<Silence> silencesIn(const Chunks& chunks, const std::map<Tick, Digest>& digests);

}  // namespace mapwright::replay
