// What map dispatchers are asked and what they answer, as values. Source:
// docs/protocols/rep130-map-dispatcher.md; map_msgs, nav_msgs.
//
// Pure; any thread. Nothing of a message is trusted, and nothing is placed by what was asked for. Memory is
// bounded before it is taken.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QByteArray>

#include "map/map_part.h"
#include "robot/map_dispatch.h"
#include "robot/ros/read_messages.h"

namespace mapwright::robot::ros {

inline constexpr std::int64_t kMostPartCells = 200'000'000;
inline constexpr std::size_t kMostPartPoints = 50'000'000;  // of more, each n-th is read, with a note
inline constexpr std::size_t kMostProjections = 1000;

/// Whether it can be asked for: numbers that are finite, and something inside.
bool isSound(const map::GridRegion& region);
bool isSound(const map::CloudRegion& region);
bool isSound(const map::Projection& projection);

/// map_msgs/GetMapROI, GetPointMapROI, SaveMap, ProjectedMapsInfo.
QByteArray regionArgs(const map::GridRegion& region);
QByteArray regionArgs(const map::CloudRegion& region);
QByteArray saveArgs(const std::string& filename);
QByteArray projectionArgs(const std::vector<map::Projection>& projections);

/// nav_msgs/OccupancyGrid. One without cells is an answer, wherever it says that it lies. Cells above 100 are
/// read as 100.
Read<map::GridPart> readGridPart(const Field& msg);
/// nav_msgs/MapMetaData; nullopt where it is no size of a map: no cells, no place, wider than 1,000 km.
std::optional<map::GridReference> readMapExtent(const Field& msg);
/// What an answer with so many cells is long, as JSON (nav_msgs/GetMap): about, and at least.
std::int64_t aboutBytesOfCells(std::int64_t cells);
std::int64_t leastBytesOfCells(std::int64_t cells);
/// sensor_msgs/PointCloud2. Of one that is cut short, what came whole, with a note.
Read<std::shared_ptr<const map::SpatialCloud>> readSpatialCloud(const Field& msg);
/// map_msgs/ProjectedMap.
Read<ProjectedPart> readProjectedPart(const Field& msg, int index);
/// map_msgs/ProjectedMapInfo[] of an answer, whichever of its two names the member has.
Read<std::vector<map::Projection>> readProjections(const Field& values);
/// What a projected map says of how it was made.
map::Projection projectionOf(const ProjectedPart& part);

}  // namespace mapwright::robot::ros
