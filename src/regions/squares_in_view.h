// The visible squares of a lattice. Pure value.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "regions/region_lattice.h"

namespace mapwright::regions {

class SquaresInView {
 public:
  /// Axis-aligned, finite; nullopt = nothing visible. More than `most` squares are too many.
  void look(std::optional<geometry::WorldRect> rect, const Eigen::Vector2d& centre_m, double most);
  void cut(const RegionLattice& lattice, double most);

  /// There is a lattice.
  bool isCut() const { return lattice_.has_value(); }
  const RegionLattice& lattice() const { return lattice_ ? *lattice_ : kUsual; }
  const std::optional<geometry::WorldRect>& rect() const { return rect_; }
  const Eigen::Vector2d& centre() const { return centre_m_; }
  /// Nearest to the centre first; empty while tooMany().
  const std::vector<RegionKey>& keys() const { return keys_; }
  bool contains(const RegionKey& key) const { return set_.contains(key); }
  bool tooMany() const { return too_many_; }
  /// The visible square at a position.
  std::optional<RegionKey> at(const Eigen::Vector2d& place) const;

 private:
  void list(double most);

  static const RegionLattice kUsual;
  std::optional<RegionLattice> lattice_;
  std::optional<geometry::WorldRect> rect_;
  Eigen::Vector2d centre_m_{0, 0};
  std::vector<RegionKey> keys_;
  std::set<RegionKey> set_;
  bool too_many_ = false;
};

}  // namespace mapwright::regions
