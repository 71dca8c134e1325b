// What a robot that stands says again and again.
#pragma once

#include "map/live_state.h"

namespace mapwright::map {

/// All that `message` says is what `state` holds: nobody who looks at the state sees a difference. Alerts
/// count without their times.
bool repeats(const LiveState& state, const TopicMessage& message);

}  // namespace mapwright::map
