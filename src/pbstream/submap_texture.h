// The grids of stored submaps as textures, as Cartographer sends them. Source: docs/protocols/pbstream.md,
// "Textures". Pure functions but for readTextures(); any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <tl/expected.hpp>

#include "geometry/pose.h"
#include "map/submap.h"
#include "pbstream/state_file.h"

namespace mapwright::pbstream {

/// A grid of 2D SLAM. cells[size_x * y + x]; x runs along -y of the submap, y along -x.
struct Grid2D {
  double resolution_m = 0;
  double max_x_m = 0, max_y_m = 0;
  std::int32_t size_x = 0, size_y = 0;
  std::vector<std::uint16_t> cells;  // 0 = unknown, otherwise 1..32767
  struct Box {
    std::int32_t min_x = 0, min_y = 0, max_x = 0, max_y = 0;  // inclusive
  };
  std::optional<Box> known;  // nullopt: nothing is known
  float min_cost = 0, max_cost = 0;
  struct Tsdf {
    float truncation_m = 0, max_weight = 0;
    std::vector<std::uint16_t> weights;
  };
  std::optional<Tsdf> tsdf;  // nullopt: the cells are probabilities
};

/// A grid of 3D SLAM: its known cells.
struct HybridGrid {
  float resolution_m = 0;
  std::vector<std::int32_t> x, y, z;
  std::vector<std::uint16_t> values;
};

/// `local_pose`: of the submap, in the frame of local SLAM.
tl::expected<map::RawSlice, Fault> sliceOf(const Grid2D& grid, const geometry::Pose3& local_pose);
/// The X-ray from above, which depends on the submap's pose in the world. nullopt: the grid is empty.
tl::expected<std::optional<map::RawSlice>, Fault> sliceOf(const HybridGrid& grid,
                                                          const geometry::Pose3& pose);

struct Textures {
  std::int32_t version = 0;
  std::vector<map::RawSlice> slices;  // 2D: one; 3D: high and low resolution; none: nothing was seen
};

/// Reads the record of a submap once more. `pose`: in the world.
tl::expected<Textures, Fault> readTextures(const RecordFile& file, const StoredSubmap& submap,
                                           const geometry::Pose3& pose);

}  // namespace mapwright::pbstream
