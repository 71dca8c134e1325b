#include "regions/squares_in_view.h"

#include <algorithm>

namespace mapwright::regions {

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
