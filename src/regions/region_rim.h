// How far a map reaches into a square that was answered with nothing. A dispatcher may answer a region that
// is partly beyond its map with 0 x 0 cells (docs/protocols/rep130-map-dispatcher.md): the rim of its map is
// found by asking for less. Pure value.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/rect.h"

namespace mapwright::regions {

enum class Side { Left, Right, Bottom, Top };
inline constexpr std::array kSides{Side::Left, Side::Right, Side::Bottom, Side::Top};
Side opposite(Side side);

/// Grows a rectangle whose cells are known towards one side, as far as there are cells: whole cells at a
/// time, by halves. A map of another shape than a rectangle is found as far as such a rectangle goes.
class RimSearch {
 public:
  struct Ground {
    geometry::WorldRect square;  // where to search
    geometry::WorldRect known;   // what to grow: beside `square`, or in it
    Side towards = Side::Right;
    double cell_m = 0.05;    // more than 0; cells begin at the square's edges
    int hint = 0;            // how far it got in the square beside this one; 0 = not known
    bool all_fails = false;  // it does not get to the far edge: that has been asked for
  };
  explicit RimSearch(const Ground& ground);

  bool over() const { return most_ - least_ <= 1; }
  /// While it is not over.
  geometry::WorldRect asking() const { return upTo(wanted()); }
  void answered(bool nothing);
  /// What has been found, grown from `known` where that lies in the square; empty = nothing.
  geometry::WorldRect found() const;
  int cells() const { return least_; }
  Side towards() const { return ground_.towards; }

 private:
  int wanted() const;
  geometry::WorldRect upTo(int cells) const;

  Ground ground_;
  double start_m_ = 0;  // where growing begins, along its axis
  int all_ = 0;         // cells to the far edge
  int least_ = 0;       // so many are there
  int most_;            // so many are not
};

}  // namespace mapwright::regions
