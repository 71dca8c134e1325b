// The clouds of one map that came region by region, and which of their points are shown: the newest for every
// region. Pure; one thread, but what set() hands out may be read by any.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "clouds/cloud_tree.h"
#include "map/map_part.h"

namespace mapwright::clouds {

/// What a point stands for.
enum class PointKind {
  Point,  // where something was seen
  Voxel,  // the middle of an occupied cell
};

/// Metres; both ends belong to it.
struct HeightRange {
  double low_m = -std::numeric_limits<double>::infinity();
  double high_m = std::numeric_limits<double>::infinity();
  bool operator==(const HeightRange&) const = default;
};

/// Space that a newer cloud stands for: a box, and of it what lies in the sphere where there is one.
struct Covered {
  Box box;
  Eigen::Vector3d centre_m{0, 0, 0};
  double radius_m = 0;
};

/// One cloud as it is drawn.
struct ShownCloud {
  std::shared_ptr<const CloudTree> tree;  // never null
  PointKind kind = PointKind::Point;
  double voxel_m = 0;           // of voxels, more than 0
  std::vector<Covered> hidden;  // what newer ones stand for
};

/// All that is shown, as of one moment.
struct CloudSet {
  std::vector<ShownCloud> clouds;  // oldest first
  double spacing_m = 0;            // of the points in the plane, as a rule; 0 = not known
  std::array<float, 2> usual_intensity{0, 1};
  bool has_intensity = false, has_rgb = false;
  Box bounds;
};

class CloudBook {
 public:
  /// More than that many points are not held together: what comes on top is thinned, and the oldest goes.
  static constexpr std::uint64_t kMostPoints = 24'000'000;
  static constexpr std::size_t kMostClouds = 64;

  /// What came in one answer.
  struct Came {
    PointKind kind = PointKind::Point;
    std::optional<map::CloudRegion> region = {};  // as it was asked for; nullopt = the whole map
    std::shared_ptr<const CloudTree> tree = {};   // never null
    std::uint64_t points = 0;                     // in the answer
    std::uint64_t left_out = 0;                   // those of it that are no numbers, or absurdly far
    std::uint64_t one_of = 1;                     // of how many one is held
    double voxel_m = 0;                           // of voxels, as found; 0 = not found
  };
  /// Of how many points one is to be held when so many come.
  static std::uint64_t oneOf(std::uint64_t points);

  /// The newest is right about its region: older points of its kind there are not shown any more. An answer
  /// that covers less of the region than was asked for is right about as much of the plane as its points
  /// reach; one without a point says that there is nothing.
  void add(Came came);
  void clear();
  bool empty() const { return held_.empty(); }
  /// The size of all voxels, as somebody says; nullopt = as found.
  void setVoxel(std::optional<double> metres);

  CloudSet set() const;

  /// What is to be said about it.
  struct Totals {
    std::size_t clouds = 0;
    std::uint64_t came = 0;       // in the answers of those that are held
    std::uint64_t held = 0;       // points in memory
    std::uint64_t left_out = 0;   // no numbers, or absurdly far
    std::uint64_t thinned = 0;    // for want of memory
    std::uint64_t forgotten = 0;  // clouds that went for newer ones, for want of memory
    std::size_t bytes = 0;
    std::optional<double> voxel_m = {};  // found, of the newest
    bool voxels = false;                 // some are
    std::set<std::string> frames = {};
    bool without_z = false;  // some came without heights
  };
  Totals totals() const;

 private:
  struct Held {
    Came came;
    std::optional<Covered> covered;  // nullopt = the whole map
  };
  std::vector<Held> held_;
  std::optional<double> voxel_m_;
  std::uint64_t forgotten_ = 0;
};

}  // namespace mapwright::clouds
