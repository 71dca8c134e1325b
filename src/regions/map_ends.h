// Finds the edges of a map, for dispatchers whose answer is empty if a region extends beyond their map
// (docs/protocols/rep130-map-dispatcher.md, "Regions"). Pure value.
#pragma once

#include <array>
#include <optional>

#include "regions/region_sides.h"

namespace mapwright::regions {

/// A map is an axis-aligned rectangle. If the robot does not report its size, each edge is found by bisection
/// with small requests, from a place that is known to be on the map.
class MapEnds {
 public:
  /// The reported extent; nullopt: none, or the map is rotated.
  void tell(std::optional<geometry::WorldRect> extent) { told_ = extent; }
  /// What was found is old.
  void forget();

  /// `rect` without the parts known to be beyond the map; may be empty.
  geometry::WorldRect within(const geometry::WorldRect& rect, double cell_m) const;
  /// A side of `rect` of which it is unknown whether the map reaches it. `place`: a rectangle on the map.
  std::optional<Side> openSide(const geometry::WorldRect& rect, const geometry::WorldRect& place,
                               double cell_m) const;

  /// The map continues where `answer`, for all of `rect`, ends.
  bool goesOnBeyond(const geometry::WorldRect& answer, const geometry::WorldRect& rect, double cell_m) const;

  /// Searches from `place` up to the edge of `rect`.
  void search(Side side, const geometry::WorldRect& place, const geometry::WorldRect& rect, double cell_m);
  void stop() { search_.reset(); }
  bool searching() const { return search_.has_value(); }
  /// The next request. While searching.
  geometry::WorldRect asking() const;
  /// `known`: where cells arrived; empty = nowhere.
  void answered(const geometry::WorldRect& known);

 private:
  struct Search {
    Side side;
    geometry::WorldRect place;
    double cell_m;
    int most;            // cells from the place to the far edge
    int there = 0;       // this many are on the map
    int not_there;       // this many are not; most + 1: unknown
    int asking() const;  // whether so many are
  };
  struct End {
    std::optional<double> reach;  // the map reaches at least this far
    std::optional<double> end;
  };

  std::optional<geometry::WorldRect> told_;
  std::array<End, kSides.size()> found_;  // by Side
  std::optional<Search> search_;
};

}  // namespace mapwright::regions
