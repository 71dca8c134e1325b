// The clouds of one map, fetched region by region, and which of their points are shown: the newest for every
// region. Pure; one thread, but the result of set() can be read from any.
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

/// Metres; both ends inclusive.
struct HeightRange {
  double low_m = -std::numeric_limits<double>::infinity();
  double high_m = std::numeric_limits<double>::infinity();
  bool operator==(const HeightRange&) const = default;
};

/// The space replaced by a newer cloud: a box, or the part of it inside the sphere if there is one.
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

/// Everything that is shown, at one moment.
struct CloudSet {
  std::vector<ShownCloud> clouds;  // oldest first
  double spacing_m = 0;            // typical distance of points in the plane; 0 = unknown
  std::array<float, 2> usual_intensity{0, 1};
  bool has_intensity = false, has_rgb = false;
  Box bounds;
};

class NewestClouds {
 public:
  /// The maximum number of points kept in total: further clouds are thinned, and the oldest are dropped.
  static constexpr std::uint64_t kMostPoints = 24'000'000;
  static constexpr std::size_t kMostClouds = 64;

  /// The content of one answer.
  struct Came {
    PointKind kind = PointKind::Point;
    std::optional<map::CloudRegion> region = {};  // as requested; nullopt = the whole map
    std::shared_ptr<const CloudTree> tree = {};   // never null
    std::uint64_t points = 0;                     // in the answer
    std::uint64_t left_out = 0;                   // points with invalid or absurdly large coordinates
    std::uint64_t one_of = 1;                     // one in so many is kept
    double voxel_m = 0;                           // of voxels, as detected; 0 = not detected
  };
  /// One in how many points to keep if this many arrive.
  static std::uint64_t oneOf(std::uint64_t points);

  /// The newest cloud replaces older points of its kind in its region. If the answer covers less than the
  /// requested region, it only replaces the part of the plane that its points reach; an answer without points
  /// means that the region is empty.
  void add(Came came);
  void clear();
  bool empty() const { return held_.empty(); }
  /// Sets the size of all voxels; nullopt = as detected.
  void setVoxel(std::optional<double> metres);

  CloudSet set() const;

  /// Figures to display.
  struct Totals {
    std::size_t clouds = 0;
    std::uint64_t came = 0;       // received, of the clouds that are kept
    std::uint64_t held = 0;       // points in memory
    std::uint64_t left_out = 0;   // invalid or absurdly far away
    std::uint64_t thinned = 0;    // to save memory
    std::uint64_t forgotten = 0;  // clouds dropped for newer ones, to save memory
    std::size_t bytes = 0;
    std::optional<double> voxel_m = {};  // detected in the newest cloud
    bool voxels = false;                 // some are
    std::set<std::string> frames = {};
    bool without_z = false;  // some have no heights
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
