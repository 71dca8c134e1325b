// Parts of large maps, as they were asked for by region. Source: docs/protocols/rep130-map-dispatcher.md.
//
// Metres; the frame is that of the map, whose name comes with each part. What came is placed by itself, never
// by the region that was asked for: an answer may be larger, smaller, empty, padded or turned.
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

/// A sphere where `radius_m` is more than 0, else a box along the axes. Never less than 0: that means nothing
/// (docs/protocols/rep130-map-dispatcher.md).
struct CloudRegion {
  Eigen::Vector3d centre_m{0, 0, 0};
  double radius_m = 0;
  Eigen::Vector3d size_m{0, 0, 0};
  bool operator==(const CloudRegion&) const = default;
};

/// Cells of a map. 0 x 0 is an answer, too: there is nothing in that region.
struct GridPart {
  std::string frame;  // without a leading slash; empty = it did not say
  GridReference grid;
  std::shared_ptr<const std::vector<std::int8_t>>
      cells;                 // row 0 = bottom; -1 unknown, 0 free .. 100 occupied
  std::vector<Fault> notes;  // what is odd about it
};

/// Points of a map. Immutable once made.
struct SpatialCloud {
  std::string frame;
  Eigen::Vector3d origin_m{0, 0, 0};    // added to each point: what is far from 0 keeps its millimetres
  std::vector<Eigen::Vector3f> points;  // finite
  std::vector<float> intensity;         // as many as points, or none; finite
  std::vector<std::uint32_t> rgb;       // 0x00RRGGBB; as many as points, or none
  bool has_z = true;                    // false: it came without z, which is 0 then
  std::uint64_t left_out = 0;           // points that are no numbers, or absurdly far
  std::uint64_t missing = 0;            // points that it says it has, and that did not come
  std::vector<Fault> notes;
};

/// What of a map in space is laid on the plane. Source: docs/protocols/rep130-map-dispatcher.md,
/// "Projections".
struct Projection {
  std::string frame;               // empty = that of the map
  Eigen::Vector2d corner_m{0, 0};  // lower left
  Eigen::Vector2d size_m{0, 0};
  double min_z_m = 0, max_z_m = 0;
  bool operator==(const Projection&) const = default;
};

}  // namespace mapwright::map
