// Requests to map dispatchers and their answers, as values. Source: docs/protocols/rep130-map-dispatcher.md;
// map_msgs, nav_msgs.
// Pure; any thread. Messages are untrusted, and positions come from the answer, never from the request. Sizes
// are checked before memory is allocated.
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
inline constexpr std::size_t kMostPartPoints =
    50'000'000;  // of larger clouds only every n-th point is read, with a note
inline constexpr std::size_t kMostProjections = 1000;

/// Whether it can be requested: finite numbers and a size greater than 0.
bool isSound(const map::GridRegion& region);
bool isSound(const map::CloudRegion& region);
bool isSound(const map::Projection& projection);

/// map_msgs/GetMapROI, GetPointMapROI, SaveMap, ProjectedMapsInfo.
QByteArray regionArgs(const map::GridRegion& region);
QByteArray regionArgs(const map::CloudRegion& region);
QByteArray saveArgs(const std::string& filename);
QByteArray projectionArgs(const std::vector<map::Projection>& projections);

/// nav_msgs/OccupancyGrid. A grid without cells is valid, whatever its position. Cells above 100 count as
/// 100.
Read<map::GridPart> readGridPart(const Field& msg);
/// nav_msgs/MapMetaData; nullopt if it is not a valid map size: no cells, no position, wider than 1,000 km.
std::optional<map::GridReference> readMapExtent(const Field& msg);
/// The JSON size of an answer with this many cells (nav_msgs/GetMap): estimated, and at least.
std::int64_t aboutBytesOfCells(std::int64_t cells);
std::int64_t leastBytesOfCells(std::int64_t cells);
/// sensor_msgs/PointCloud2. If it is truncated, all complete points, with a note.
Read<std::shared_ptr<const map::SpatialCloud>> readSpatialCloud(const Field& msg);
/// map_msgs/ProjectedMap.
Read<ProjectedPart> readProjectedPart(const Field& msg, int index);
/// map_msgs/ProjectedMapInfo[] of an answer, under either name of the member.
Read<std::vector<map::Projection>> readProjections(const Field& values);
/// The projection that a projected map was made with.
map::Projection projectionOf(const ProjectedPart& part);

}  // namespace mapwright::robot::ros
