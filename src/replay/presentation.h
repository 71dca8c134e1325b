// For display only: where the robot was between two messages, and where the next message is. Not part of the
// world (replay/world_at.h). Pure.
#pragma once

#include <optional>

#include "geometry/pose.h"
#include "replay/chunk.h"
#include "replay/prefix_index.h"

namespace mapwright::replay {

/// The robot's pose interpolated between the last sample at or before `at_s` and the next one, turning the
/// shorter way. Never across a jump, into another map or session, or over more than a second without samples:
/// then it is the sample before. nullopt: there is none before.
std::optional<geometry::Pose2> poseBetween(const PrefixIndex& index, double at_s);

/// The stamp of the first message after `at_s`, or the last before it, in a chunk; nullopt = there is none in
/// this one.
std::optional<double> stampAfter(const Chunk& chunk, double at_s);
std::optional<double> stampBefore(const Chunk& chunk, double at_s);

}  // namespace mapwright::replay
