// Repeated messages of a robot that stands still.
#pragma once

#include "map/live_state.h"

namespace mapwright::map {

/// `message` adds nothing to `state`: nobody who looks at the state sees a difference. Times of alerts do not
/// count.
bool repeats(const LiveState& state, const TopicMessage& message);

}  // namespace mapwright::map
