// All that a robot has said of its world, as one value; and the one reducer that makes it, whether the
// messages come from a robot or out of a recording (docs/decisions/0012-one-reducer-makes-the-world.md).
#pragma once

#include <optional>

#include "map/live_state.h"
#include "map/stamped_message.h"
#include "map/submap.h"

namespace mapwright::map {

/// The state after a sequence of messages. It is a function of the messages and their stamps alone: no clock
/// is asked, so the same recording gives equal worlds whenever and however often it is played. Two worlds are
/// equal when all that can be seen in them is (LiveState says what that leaves out). Large parts are shared
/// and immutable: copies are cheap, but for the list.
struct World {
  LiveState live;
  std::optional<SubmapList> submaps;  // the newest list; nullopt while none has come
  double at_s = 0;                    // of the newest message; 0 before the first
  bool operator==(const World&) const = default;
};

/// The world after `message`. Messages may bear earlier stamps than the ones before (clocks are set back,
/// recordings are joined): what then would be younger than the world itself, the end of the trail, is taken
/// back.
World reduce(World world, const StampedMessage& message);

}  // namespace mapwright::map
