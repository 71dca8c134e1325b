// Everything that a robot has reported about its world, as one value; and the one reducer that builds it from
// messages, live or recorded (docs/decisions/0012-one-reducer-makes-the-world.md).
#pragma once

#include <optional>

#include "map/live_state.h"
#include "map/live_topics.h"
#include "map/submap.h"

namespace mapwright::map {

/// The state after a sequence of messages. It depends only on the messages and their stamps, not on a clock,
/// so the same recording always gives equal worlds. Two worlds are equal if everything visible in them is
/// equal (LiveState says what that leaves out). Large parts are shared and immutable: copies are cheap,
/// except for the list.
struct World {
  LiveState live;
  std::optional<SubmapList> submaps;  // the newest list; nullopt before the first
  double at_s = 0;                    // of the newest message; 0 before the first
  bool operator==(const World&) const = default;
};

/// The world after `message`. Stamps may go backwards (clocks are set back, recordings are merged): parts
/// that would then be newer than the world itself, such as the end of the trail, are removed.
World reduce(World world, const StampedMessage& message);

/// The same in place, for many messages. `message` arrived at `at_s` (seconds since the epoch).
void reduceInto(World& world, const TopicMessage& message, double at_s);

/// The same for messages other than submap lists.
void reduceInto(LiveState& state, const TopicMessage& message, double at_s);

}  // namespace mapwright::map
