#include "ui/clouds/projection_draft.h"

#include <algorithm>
#include <cmath>

namespace mapwright::ui {
namespace {

constexpr double kLeastSizeM = 0.1;

/// Moves one end of an interval; the ends stay in order and apart.
void pull(double& low, double& high, bool moves_low, double step) {
  (moves_low ? low : high) += step;
  if (low > high) std::swap(low, high);
  if (high - low < kLeastSizeM) (moves_low ? low : high) = moves_low ? high - kLeastSizeM : low + kLeastSizeM;
}

}  // namespace

bool ProjectionDraft::setAnswer(List told) {
  const bool edited = changed();
  told_ = std::move(told);
  if (edited) return false;
  revert();
  return true;
}

void ProjectionDraft::settle(List told) {
  told_ = std::move(told);
  revert();
}

void ProjectionDraft::forget() { *this = {}; }

void ProjectionDraft::revert() {
  wanted_ = told_.value_or(List{});
  select(selected_);
}

std::optional<int> ProjectionDraft::firstFlawed() const {
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    if (flawOf(wanted_[i]) != map::ProjectionFlaw::None) return int(i);
  }
  return std::nullopt;
}

void ProjectionDraft::select(std::optional<int> index) {
  selected_ = index && *index >= 0 && *index < int(wanted_.size()) ? index : std::nullopt;
}

void ProjectionDraft::add(const map::Projection& projection) {
  wanted_.push_back(projection);
  selected_ = int(wanted_.size()) - 1;
}

void ProjectionDraft::set(int index, const map::Projection& projection) {
  if (index >= 0 && index < int(wanted_.size())) wanted_[std::size_t(index)] = projection;
}

void ProjectionDraft::removeSelected() {
  if (!selected_) return;
  wanted_.erase(wanted_.begin() + *selected_);
  const int last = int(wanted_.size()) - 1;
  selected_ = last < 0 ? std::nullopt : std::optional(std::min(*selected_, last));
}

RectGrip gripAt(const map::Projection& projection, const Eigen::Vector2d& at_m, double reach_m) {
  const Eigen::Vector2d low = projection.corner_m, high = low + projection.size_m;
  const Eigen::Vector2d reach(reach_m, reach_m);
  if ((at_m.array() < (low - reach).array()).any() || (at_m.array() > (high + reach).array()).any()) {
    return RectGrip::None;
  }
  const bool left = std::abs(at_m.x() - low.x()) <= reach_m, right = std::abs(at_m.x() - high.x()) <= reach_m;
  const bool bottom = std::abs(at_m.y() - low.y()) <= reach_m, top = std::abs(at_m.y() - high.y()) <= reach_m;
  // If a rectangle is smaller than the reach the far corner wins, so that it can be enlarged.
  if (right && top) return RectGrip::TopRight;
  if (right && bottom) return RectGrip::BottomRight;
  if (left && top) return RectGrip::TopLeft;
  if (left && bottom) return RectGrip::BottomLeft;
  if (right) return RectGrip::Right;
  if (left) return RectGrip::Left;
  if (top) return RectGrip::Top;
  if (bottom) return RectGrip::Bottom;
  return RectGrip::Inside;
}

map::Projection moved(const map::Projection& before, RectGrip grip, const Eigen::Vector2d& step_m) {
  map::Projection after = before;
  if (grip == RectGrip::None) return after;
  if (grip == RectGrip::Inside) {
    after.corner_m += step_m;
    return after;
  }
  Eigen::Vector2d low = before.corner_m, high = low + before.size_m;
  const bool left = grip == RectGrip::Left || grip == RectGrip::TopLeft || grip == RectGrip::BottomLeft;
  const bool right = grip == RectGrip::Right || grip == RectGrip::TopRight || grip == RectGrip::BottomRight;
  const bool bottom =
      grip == RectGrip::Bottom || grip == RectGrip::BottomLeft || grip == RectGrip::BottomRight;
  const bool top = grip == RectGrip::Top || grip == RectGrip::TopLeft || grip == RectGrip::TopRight;
  if (left || right) pull(low.x(), high.x(), left, step_m.x());
  if (bottom || top) pull(low.y(), high.y(), bottom, step_m.y());
  after.corner_m = low;
  after.size_m = high - low;
  return after;
}

}  // namespace mapwright::ui
