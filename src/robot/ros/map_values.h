// Converts ROS messages to values placed in the frame of the displayed map. Pure; any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "map/live_topics.h"
#include "robot/ros/read_messages.h"
#include "robot/ros/transforms.h"

namespace mapwright::robot::ros {

/// How to read the bytes of pgmOf().
inline constexpr map::CellReading kPgmReading{map::CellReading::Mode::Raw, false, 0.65, 0.196};

/// The grid as a binary PGM (top row first) that CellReading::Mode::Raw reads as the same cells: 0..100
/// unchanged, -1 and everything else as 255. Empty if there are fewer cells than width * height.
std::string pgmOf(const Grid& grid);

/// `in_map`: the pose of the grid's frame in the frame of the map.
map::GridMessage gridMessage(const Grid& grid, const std::string& topic, map::GridKind kind,
                             const Transform3& in_map);

/// `in_map`: the pose of the message's frame in the frame of the map.
geometry::Pose2 placedIn(const Placed& placed, const Transform3& in_map);
std::vector<geometry::Pose2> placedIn(const Poses& poses, const Transform3& in_map);
map::Polyline placedIn(const Outline& outline, const Transform3& in_map);
map::PointCloudMessage placedIn(const Points& points, const std::string& topic, const Transform3& in_map);
/// Each point with the pose of the frame at its time: `along` has the poses during the sweep, evenly spaced
/// in time, from its beginning to its end; at least one.
map::PointCloudMessage placedAlong(const Points& points, const std::string& topic,
                                   const std::vector<Transform3>& along);

/// A cube, cylinder or sphere as its box on the ground, named after its text or its namespace and number;
/// nullopt for anything else.
std::optional<map::GroundBox> boxOf(const Marker& marker, const Transform3& in_map);
/// Any other visible marker, flat on the ground; nullopt for a box. A mesh is a spot at its place. A
/// transparent colour counts as none.
std::optional<map::GroundDrawing> drawingOf(const Marker& marker, const Transform3& in_map);

}  // namespace mapwright::robot::ros
