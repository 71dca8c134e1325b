// A state file as the messages that a robot would send about it. Pure.
#pragma once

#include <vector>

#include "map/live_topics.h"
#include "pbstream/state_file.h"

namespace mapwright::robot::pbstream {

// The topics on which Cartographer's node sends the same.
inline constexpr const char* kTrajectoryTopic = "/trajectory";
inline constexpr const char* kConstraintsTopic = "/constraint_list";
inline constexpr const char* kLandmarksTopic = "/landmarks";

/// The list of submaps, its trajectories one behind the other, its constraints under the names that
/// cartographer_ros gives them, and its landmarks.
std::vector<map::StampedMessage> messagesOf(const mapwright::pbstream::StateFile& file, double received_s);

}  // namespace mapwright::robot::pbstream
