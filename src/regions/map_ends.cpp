#include "regions/map_ends.h"

#include <algorithm>
#include <cmath>

namespace mapwright::regions {
namespace {

// In cells. A request ends this much before the map, so that rounding does not extend it beyond.
constexpr double kInside = 0.02;
// And begins this much before the tested cell, so that truncation does not make it empty.
constexpr double kOverlap = 0.5;
constexpr double kSpotCells = 4;  // the width of a request
constexpr int kMostCells = 1 << 24;

bool isAlongX(Side side) { return side == Side::Left || side == Side::Right; }
constexpr double kAboutCells = 0.75, kLackCells = 1.5;  // less is rounding
double outwards(Side side) { return side == Side::Right || side == Side::Top ? 1 : -1; }

/// `place` is farther out than `end`, by more than `slack`.
bool isBeyond(double place, double end, Side side, double slack) {
  return (place - end) * outwards(side) > slack;
}

double& endIn(geometry::WorldRect& rect, Side side) {
  switch (side) {
    case Side::Left:
      return rect.min_x;
    case Side::Right:
      return rect.max_x;
    case Side::Bottom:
      return rect.min_y;
    case Side::Top:
      break;
  }
  return rect.max_y;
}

}  // namespace

void MapEnds::forget() {
  found_ = {};
  search_.reset();
}

geometry::WorldRect MapEnds::within(const geometry::WorldRect& rect, double cell_m) const {
  geometry::WorldRect part = rect;
  for (const Side side : kSides) {
    // Observations take precedence over reported sizes.
    const End& found = found_[at(side)];
    std::optional<double> end = found.end;
    if (!end && told_ &&
        !(found.reach && isBeyond(*found.reach, endOf(*told_, side), side, kAboutCells * cell_m)))
      end = endOf(*told_, side);
    if (end && isBeyond(endOf(rect, side), *end, side, 0))
      endIn(part, side) = *end - outwards(side) * kInside * cell_m;
  }
  return part;
}

std::optional<Side> MapEnds::openSide(const geometry::WorldRect& rect, const geometry::WorldRect& place,
                                      double cell_m) const {
  for (const Side side : kSides) {
    const End& found = found_[at(side)];
    const auto fallsShort = [&](double reach) {
      return isBeyond(endOf(rect, side), reach, side, kAboutCells * cell_m);
    };
    if (!found.end && fallsShort(endOf(place, side)) && !(found.reach && !fallsShort(*found.reach)))
      return side;
  }
  return std::nullopt;
}

bool MapEnds::goesOnBeyond(const geometry::WorldRect& answer, const geometry::WorldRect& rect,
                           double cell_m) const {
  return std::any_of(kSides.begin(), kSides.end(), [&](Side side) {
    const End& found = found_[at(side)];
    const double end = endOf(answer, side), slack = kLackCells * cell_m;
    const bool is_less = isBeyond(endOf(rect, side), end, side, slack);
    const std::optional<double>& map = found.end ? found.end : found.reach;
    return is_less && map && isBeyond(*map, end, side, slack);
  });
}

void MapEnds::search(Side side, const geometry::WorldRect& place, const geometry::WorldRect& rect,
                     double cell_m) {
  const double way = (endOf(rect, side) - endOf(place, side)) * outwards(side);
  const int most = int(std::clamp(std::ceil(way / cell_m - kOverlap), 1.0, double(kMostCells)));
  search_ = Search{side, place, cell_m, most, 0, most + 1};
}

int MapEnds::Search::asking() const {
  // First anything at all, then everything, then bisection.
  if (not_there == most + 1) return there == 0 ? 1 : most;
  return there + (not_there - there) / 2;
}

geometry::WorldRect MapEnds::asking() const {
  const Search& search = *search_;
  const double out = outwards(search.side);
  const double end = endOf(search.place, search.side) + out * search.asking() * search.cell_m;
  const double near = end - out * (1 + kOverlap) * search.cell_m, far = end - out * kInside * search.cell_m;
  const bool along_x = isAlongX(search.side);
  const Eigen::Vector2d middle = search.place.center();
  const double across = along_x ? search.place.height() : search.place.width();
  const double half = std::min(kSpotCells / 2 * search.cell_m, across / 2 - kInside * search.cell_m);
  const double low = std::min(near, far), high = std::max(near, far);
  return along_x ? geometry::WorldRect{low, middle.y() - half, high, middle.y() + half}
                 : geometry::WorldRect{middle.x() - half, low, middle.x() + half, high};
}

void MapEnds::answered(const geometry::WorldRect& known) {
  Search& search = *search_;
  const bool is_there = reaches(known, asking(), search.side, kOverlap * search.cell_m);
  (is_there ? search.there : search.not_there) = search.asking();
  const bool reaches_all = search.there == search.most;
  if (!reaches_all && search.not_there - search.there > 1) return;
  End& found = found_[at(search.side)];
  const double end = endOf(search.place, search.side) + outwards(search.side) * search.there * search.cell_m;
  (reaches_all ? found.reach : found.end) = end;
  search_.reset();
}

}  // namespace mapwright::regions
