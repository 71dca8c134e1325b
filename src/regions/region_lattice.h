// Divides the plane into squares that are requested one after the other, and lists those in view. Pure
// values.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "geometry/rect.h"
#include "map/map_part.h"

namespace mapwright::regions {

/// A square of a lattice: x to the right, y upwards.
struct RegionKey {
  std::int64_t x = 0, y = 0;
  auto operator<=>(const RegionKey&) const = default;
};

/// Squares along the axes of the map's frame. Metres.
struct RegionLattice {
  Eigen::Vector2d anchor_m{0, 0};  // the lower left corner of square (0, 0)
  double edge_m = 51.2;            // finite, greater than 0
  bool operator==(const RegionLattice&) const = default;

  geometry::WorldRect rectOf(const RegionKey& key) const;
  /// The squares that overlap `rect` (finite) by more than an edge: their number, and each of them.
  double countIn(const geometry::WorldRect& rect) const;
  void eachIn(const geometry::WorldRect& rect, const std::function<void(const RegionKey&)>& each) const;

 private:
  struct Range {
    double x0, y0, x1, y1;  // integers, inclusive
  };
  Range rangeOf(const geometry::WorldRect& rect) const;
};

/// The visible squares of a lattice.
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

/// The request for a rectangle.
map::GridRegion askedFor(const geometry::WorldRect& rect);

/// The overlap of two rectangles; may be empty.
geometry::WorldRect common(const geometry::WorldRect& a, const geometry::WorldRect& b);

}  // namespace mapwright::regions
