// From messages of ROS to values of the map, placed in the frame that the map is drawn in. Pure; any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "map/live_topics.h"
#include "robot/ros/read_messages.h"
#include "robot/ros/transforms.h"

namespace mapwright::robot::ros {

/// How bytes of pgmOf() are read.
inline constexpr map::CellReading kPgmReading{map::CellReading::Mode::Raw, false, 0.65, 0.196};

/// The grid as a binary PGM (row 0 on top) that CellReading::Mode::Raw reads to the same cells: 0..100 as
/// they are, -1 and all else as 255. Empty when there are fewer cells than width * height.
std::string pgmOf(const Grid& grid);

/// `in_map`: the pose of the grid's frame in the frame of the map.
map::GridMessage gridMessage(const Grid& grid, const std::string& topic, map::GridKind kind,
                             const Transform3& in_map);

/// `in_map`: the pose of the frame of the message in the frame of the map.
geometry::Pose2 placedIn(const Placed& placed, const Transform3& in_map);
std::vector<geometry::Pose2> placedIn(const Poses& poses, const Transform3& in_map);
map::Polyline placedIn(const Outline& outline, const Transform3& in_map);
map::PointCloudMessage placedIn(const Points& points, const std::string& topic, const Transform3& in_map);
/// Each point as the frame lay when it was taken: `along` are its poses during the sweep, evenly in time,
/// from its beginning to its end; at least one.
map::PointCloudMessage placedAlong(const Points& points, const std::string& topic,
                                   const std::vector<Transform3>& along);

/// A cube, cylinder or sphere as the box on the ground that it stands on, called by its text or by its
/// namespace and number; nullopt for all else.
std::optional<map::GroundBox> boxOf(const Marker& marker, const Transform3& in_map);
/// Every other marker with something to be seen, as it lies on the ground; nullopt for a box and for a mesh.
/// A colour that cannot be seen is none.
std::optional<map::GroundDrawing> drawingOf(const Marker& marker, const Transform3& in_map);

}  // namespace mapwright::robot::ros
