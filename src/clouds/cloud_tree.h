// A cloud of points in a tree, so that any pixel, height range or region can be found without visiting all
// points. Pure; immutable once built, so any thread may read it.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "map/map_part.h"

namespace mapwright::clouds {

/// Heights and intensities are summed as integers in this fraction of a unit, so that the sum does not depend
/// on the order: a picture has the same bytes however it is split into tiles.
inline constexpr double kParts = 4096;
/// Heights and intensities beyond this are clamped in sums (colours); positions are not changed.
inline constexpr double kMostOfSum = 1e6;
std::int64_t inParts(double value);

/// Metres, in the frame of the cloud.
struct Box {
  Eigen::Vector3d min{0, 0, 0}, max{-1, -1, -1};  // min > max: empty
  bool empty() const { return min.x() > max.x(); }
};

/// A group of nearby points. The first child is the next node, the second is `second`; 0 = a leaf.
struct CloudNode {
  std::array<float, 3> min{}, max{};  // relative to the cloud's origin
  std::uint32_t first = 0, count = 0;
  std::uint32_t second = 0;
  std::int64_t sum_z = 0, sum_intensity = 0;  // in parts, without the origin
  std::array<std::uint64_t, 3> sum_rgb{};     // red, green, blue
};

/// A k-d tree over the points of one cloud, along x, y and (with less weight: it is seen from above) z.
class CloudTree {
 public:
  static constexpr std::uint32_t kLeafPoints = 48;

  /// Builds the tree from every `one_of`-th point of the cloud. Takes about a second for 5 million points
  /// and, during construction, 36 bytes per point in addition to the cloud. Returns null when `cancelled`
  /// (may be null) becomes true.
  static std::shared_ptr<const CloudTree> make(const map::SpatialCloud& cloud, std::uint64_t one_of = 1,
                                               const std::atomic<bool>* cancelled = nullptr);

  const std::string& frame() const { return frame_; }
  const Eigen::Vector3d& origin() const { return origin_m_; }
  bool hasZ() const { return has_z_; }
  bool hasIntensity() const { return !intensity_.empty(); }
  bool hasRgb() const { return !rgb_.empty(); }
  std::size_t size() const { return points_.size(); }

  /// In the order of the leaves; relative to origin().
  std::span<const Eigen::Vector3f> points() const { return points_; }
  std::span<const float> intensity() const { return intensity_; }  // as many as points, or none
  std::span<const std::uint32_t> rgb() const { return rgb_; }      // 0x00RRGGBB; as many as points, or none
  /// The first is the root; empty if there are no points.
  std::span<const CloudNode> nodes() const { return nodes_; }
  Eigen::Vector3d world(std::size_t at) const { return origin_m_ + points_[at].cast<double>(); }
  Box bounds() const;
  Box boundsOf(const CloudNode& node) const;
  /// Typical distance of points in the plane, metres; 0 = unknown (all at one point).
  double spacing() const { return spacing_m_; }
  /// The smallest and largest intensity without the outermost hundredth on each side; {0, 1} if there are
  /// none.
  std::array<float, 2> usualIntensity() const { return usual_intensity_; }
  std::size_t bytes() const;

 private:
  std::string frame_;
  Eigen::Vector3d origin_m_{0, 0, 0};
  bool has_z_ = true;
  std::vector<Eigen::Vector3f> points_;
  std::vector<float> intensity_;
  std::vector<std::uint32_t> rgb_;
  std::vector<CloudNode> nodes_;
  double spacing_m_ = 0;
  std::array<float, 2> usual_intensity_{0, 1};
};

/// The cell edge in metres; 0 = it does not look like cells of one size. With mixed sizes (an octree), the
/// smallest frequent one.
double voxelSize(const CloudTree& tree);

}  // namespace mapwright::clouds
