// Selects the points of a tree: by height, and without those replaced by a newer cloud. Private to this room.
#pragma once

#include <array>
#include <limits>
#include <span>

#include "clouds/cloud_tree.h"
#include "clouds/newest_clouds.h"

namespace mapwright::clouds {

enum class Visit {
  Skip,   // none of it
  Whole,  // all of it
  Into,   // look closer
};

inline bool contains(const Covered& covered, const Eigen::Vector3d& at) {
  if (!((at.array() >= covered.box.min.array()).all() && (at.array() <= covered.box.max.array()).all()))
    return false;
  return covered.radius_m <= 0 ||
         (at - covered.centre_m).squaredNorm() <= covered.radius_m * covered.radius_m;
}

/// How much of a box is covered, never overestimated: Into may turn out to be nothing.
inline Visit coverage(const Covered& covered, const Box& box) {
  if ((box.max.array() < covered.box.min.array()).any() ||
      (box.min.array() > covered.box.max.array()).any()) {
    return Visit::Skip;
  }
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d at(corner & 1 ? box.max.x() : box.min.x(), corner & 2 ? box.max.y() : box.min.y(),
                             corner & 4 ? box.max.z() : box.min.z());
    if (!contains(covered, at)) return Visit::Into;
  }
  return Visit::Whole;
}

/// Which points of a cloud are shown.
class Meant {
 public:
  Meant(const CloudTree& tree, std::span<const Covered> hidden, const HeightRange& heights)
      : tree_(tree), hidden_(hidden), heights_(heights) {}

  Visit of(const CloudNode& node) const {
    const double low = tree_.origin().z() + double(node.min[2]),
                 high = tree_.origin().z() + double(node.max[2]);
    if (high < heights_.low_m || low > heights_.high_m) return Visit::Skip;
    Visit visit = low >= heights_.low_m && high <= heights_.high_m ? Visit::Whole : Visit::Into;
    if (hidden_.empty()) return visit;
    const Box box = tree_.boundsOf(node);
    for (const Covered& covered : hidden_) {
      const Visit hides = coverage(covered, box);
      if (hides == Visit::Whole) return Visit::Skip;
      if (hides == Visit::Into) visit = Visit::Into;
    }
    return visit;
  }

  bool has(const Eigen::Vector3f& point) const {
    const double z = tree_.origin().z() + double(point.z());
    if (z < heights_.low_m || z > heights_.high_m) return false;
    for (const Covered& covered : hidden_) {
      if (contains(covered, tree_.origin() + point.cast<double>())) return false;
    }
    return true;
  }

 private:
  const CloudTree& tree_;
  std::span<const Covered> hidden_;
  const HeightRange& heights_;
};

/// Walks the tree: `judge` decides about each node, `whole` gets nodes taken as a whole, `one` the index of
/// each point in leaves that are inspected.
template <class Judge, class Whole, class One>
void walk(const CloudTree& tree, Judge judge, Whole whole, One one) {
  const auto nodes = tree.nodes();
  if (nodes.empty()) return;
  std::array<std::uint32_t, 96> waiting;  // enough for the depth of the tree, which halves at each step
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const std::uint32_t at = waiting[--count];
    const CloudNode& node = nodes[at];
    const Visit visit = judge(node);
    if (visit == Visit::Skip) continue;
    if (visit == Visit::Whole) {
      whole(node);
    } else if (node.second == 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) one(i);
    } else {
      waiting[count++] = node.second;
      waiting[count++] = at + 1;
    }
  }
}

}  // namespace mapwright::clouds
