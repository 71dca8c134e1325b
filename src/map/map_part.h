// Parts of large maps, as fetched by region. Source: docs/protocols/rep130-map-dispatcher.md.
// Metres, in the frame of the map, whose name comes with each part. A part is placed by its own data, never
// by the requested region: an answer may be larger, smaller, empty, padded or rotated.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fault/fault.h"
#include "map/grid_reference.h"

namespace mapwright::map {

/// A rectangle along the axes of the map's frame.
struct GridRegion {
  Eigen::Vector2d centre_m{0, 0};
  Eigen::Vector2d size_m{0, 0};  // finite, more than 0
  bool operator==(const GridRegion&) const = default;
};

/// A sphere if `radius_m` is greater than 0, otherwise an axis-aligned box. Never negative: that is undefined
/// (docs/protocols/rep130-map-dispatcher.md).
struct CloudRegion {
  Eigen::Vector3d centre_m{0, 0, 0};
  double radius_m = 0;
  Eigen::Vector3d size_m{0, 0, 0};
  bool operator==(const CloudRegion&) const = default;
};

/// Cells of a map. 0 x 0 is valid: the map is empty in this region.
struct GridPart {
  std::string frame;  // without leading slash; empty = not given
  GridReference grid;
  OccupancyCells cells;
  std::vector<Fault> notes;  // what is odd about it
};

/// Points of a map. Immutable.
struct SpatialCloud {
  std::string frame;
  Eigen::Vector3d origin_m{0, 0,
                           0};  // added to each point, so that points far from 0 keep millimetre precision
  std::vector<Eigen::Vector3f> points;  // finite
  std::vector<float> intensity;         // one per point, or none; finite
  std::vector<std::uint32_t> rgb;       // 0x00RRGGBB; one per point, or none
  bool has_z = true;                    // false: no z was sent; it is 0 then
  std::uint64_t left_out = 0;           // points with invalid or absurdly large coordinates
  std::uint64_t missing = 0;            // points that were announced but did not arrive
  std::vector<Fault> notes;
};

/// A region of a 3D map that is projected onto the plane. Source: docs/protocols/rep130-map-dispatcher.md,
/// "Projections".
struct Projection {
  std::string frame;               // empty = that of the map
  Eigen::Vector2d corner_m{0, 0};  // lower left
  Eigen::Vector2d size_m{0, 0};
  double min_z_m = 0, max_z_m = 0;
  bool operator==(const Projection&) const = default;
};

/// Why a projection would not be sent to a robot.
enum class ProjectionFlaw { None, NotFinite, TooFar, WithoutSize, HeightsCrossed };
ProjectionFlaw flawOf(const Projection& projection);

/// How many of `told` differ from `wanted` by more than rounding to grid cells; missing and extra ones count
/// as well.
int differing(const std::vector<Projection>& wanted, const std::vector<Projection>& told);

}  // namespace mapwright::map
