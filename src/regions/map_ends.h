// Where a map ends, for dispatchers that answer a region partly beyond their map with nothing
// (docs/protocols/rep130-map-dispatcher.md, "Regions"). Pure value.
#pragma once

#include <array>
#include <optional>

#include "regions/region_sides.h"

namespace mapwright::regions {

/// A map is a rectangle along the axes. Where a robot does not tell how large it is, each end is found by
/// small questions, by halves, from a place that is known to be on it.
class MapEnds {
 public:
  /// What the robot says; nullopt: nothing, or the map is turned.
  void tell(std::optional<geometry::WorldRect> extent) { told_ = extent; }
  /// What was found is old.
  void forget();

  /// `rect` without what is known to be beyond the map; may be empty.
  geometry::WorldRect within(const geometry::WorldRect& rect, double cell_m) const;
  /// A side of `rect` to which nobody knows whether the map reaches. `place`: a rectangle that is on it.
  std::optional<Side> openSide(const geometry::WorldRect& rect, const geometry::WorldRect& place,
                               double cell_m) const;

  /// The map goes on where `answer`, for all of `rect`, ends.
  bool goesOnBeyond(const geometry::WorldRect& answer, const geometry::WorldRect& rect, double cell_m) const;

  /// Searches from `place` as far as `rect` goes.
  void search(Side side, const geometry::WorldRect& place, const geometry::WorldRect& rect, double cell_m);
  void stop() { search_.reset(); }
  bool searching() const { return search_.has_value(); }
  /// What to ask for. While searching.
  geometry::WorldRect asking() const;
  /// `known`: where cells came; empty = nowhere.
  void answered(const geometry::WorldRect& known);

 private:
  struct Search {
    Side side;
    geometry::WorldRect place;
    double cell_m;
    int most;            // cells from the place to the far edge
    int there = 0;       // so many are on the map
    int not_there;       // so many are not; most + 1: that is not known
    int asking() const;  // whether so many are
  };
  struct End {
    std::optional<double> reach;  // the map goes as far as this at least
    std::optional<double> end;
  };

  std::optional<geometry::WorldRect> told_;
  std::array<End, kSides.size()> found_;  // by Side
  std::optional<Search> search_;
};

}  // namespace mapwright::regions
