// Converts protobuf to submap values. Pure functions, any thread. Source:
// docs/protocols/cartographer-submaps.md, "Messages".
#pragma once

#include <string_view>

#include "map/submap.h"
#include "ros_messages/slam.pb.h"

namespace mapwright::robot::axbot {

/// Reads a SubmapQueryV2Response. Never throws: garbage becomes Outcome::Failed with a reason.
map::SubmapAnswer parseSubmapResponse(const map::SubmapKey& key, std::string_view body);

/// A binary /submap_list as values.
map::SubmapList toSubmapList(const ros_messages::slam::SubmapList& message);

}  // namespace mapwright::robot::axbot
