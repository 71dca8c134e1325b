#include "regions/region_lattice.h"

#include <algorithm>
#include <cmath>

namespace mapwright::regions {
namespace {

// Of a square: smaller overlaps with the next one are rounding.
constexpr double kTouch = 1e-6;
constexpr double kFarthest = 1e15;  // squares: exact as doubles, and in 64 bits

double clamped(double square) { return std::clamp(square, -kFarthest, kFarthest); }

bool isFinite(const geometry::WorldRect& rect) {
  return std::isfinite(rect.min_x) && std::isfinite(rect.min_y) && std::isfinite(rect.max_x) &&
         std::isfinite(rect.max_y);
}

}  // namespace

geometry::WorldRect RegionLattice::rectOf(const RegionKey& key) const {
  return {anchor_m.x() + double(key.x) * edge_m, anchor_m.y() + double(key.y) * edge_m,
          anchor_m.x() + double(key.x + 1) * edge_m, anchor_m.y() + double(key.y + 1) * edge_m};
}

RegionLattice::Range RegionLattice::rangeOf(const geometry::WorldRect& rect) const {
  const auto first = [&](double at, double anchor) {
    return clamped(std::floor((at - anchor) / edge_m + kTouch));
  };
  const auto last = [&](double at, double anchor) {
    return clamped(std::ceil((at - anchor) / edge_m - kTouch) - 1);
  };
  Range range{first(rect.min_x, anchor_m.x()), first(rect.min_y, anchor_m.y()),
              last(rect.max_x, anchor_m.x()), last(rect.max_y, anchor_m.y())};
  // Even one without width is in a square.
  range.x1 = std::max(range.x1, range.x0);
  range.y1 = std::max(range.y1, range.y0);
  return range;
}

double RegionLattice::countIn(const geometry::WorldRect& rect) const {
  if (rect.empty()) return 0;
  const Range range = rangeOf(rect);
  return (range.x1 - range.x0 + 1) * (range.y1 - range.y0 + 1);
}

void RegionLattice::eachIn(const geometry::WorldRect& rect,
                           const std::function<void(const RegionKey&)>& each) const {
  if (rect.empty()) return;
  const Range range = rangeOf(rect);
  for (auto y = std::int64_t(range.y0); y <= std::int64_t(range.y1); ++y) {
    for (auto x = std::int64_t(range.x0); x <= std::int64_t(range.x1); ++x) each({x, y});
  }
}

map::GridRegion askedFor(const geometry::WorldRect& rect) {
  return {rect.center(), {rect.width(), rect.height()}};
}

geometry::WorldRect common(const geometry::WorldRect& a, const geometry::WorldRect& b) {
  return {std::max(a.min_x, b.min_x), std::max(a.min_y, b.min_y), std::min(a.max_x, b.max_x),
          std::min(a.max_y, b.max_y)};
}

const RegionLattice SquaresInView::kUsual;

void SquaresInView::look(std::optional<geometry::WorldRect> rect, const Eigen::Vector2d& centre_m,
                         double most) {
  if (rect && (rect->empty() || !isFinite(*rect) || !centre_m.allFinite())) rect.reset();
  rect_ = rect;
  centre_m_ = centre_m;
  list(most);
}

void SquaresInView::cut(const RegionLattice& lattice, double most) {
  lattice_ = lattice;
  list(most);
}

void SquaresInView::list(double most) {
  keys_.clear();
  set_.clear();
  too_many_ = lattice_ && rect_ && lattice_->countIn(*rect_) > most;
  if (!lattice_ || !rect_ || too_many_) return;
  lattice_->eachIn(*rect_, [this](const RegionKey& key) { keys_.push_back(key); });
  const auto distance = [this](const RegionKey& key) {
    return (lattice_->rectOf(key).center() - centre_m_).squaredNorm();
  };
  std::stable_sort(keys_.begin(), keys_.end(),
                   [&](const RegionKey& a, const RegionKey& b) { return distance(a) < distance(b); });
  set_.insert(keys_.begin(), keys_.end());
}

std::optional<RegionKey> SquaresInView::at(const Eigen::Vector2d& place) const {
  std::optional<RegionKey> found;
  if (keys_.empty() || !place.allFinite()) return found;
  lattice_->eachIn({place.x(), place.y(), place.x(), place.y()}, [&](const RegionKey& key) {
    if (contains(key)) found = key;
  });
  return found;
}

}  // namespace mapwright::regions
