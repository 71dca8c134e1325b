#include "submap/nearest_first.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

namespace mapwright::submap {
namespace {

constexpr double kSquareM = 32;
constexpr double kFarthest = 1e12;     // squares
constexpr std::size_t kSquares = 64;   // looked into at a time
constexpr std::size_t kPlanned = 512;  // ids put in order at a time
constexpr double kReachM = 12;         // of a submap from the place where it is filed
constexpr double kOutOfView = 1e9;     // farther than anything in view

/// What is in view comes first, however far from the middle.
double rank(const Eigen::Vector2d& at, const geometry::WorldRect& view, const Eigen::Vector2d& center) {
  const double distance = (at - center).norm();
  return view.empty() || view.grown(kReachM).contains(at) ? distance : distance + kOutOfView;
}

}  // namespace

std::size_t NearestFirst::SquareHash::operator()(const Square& square) const noexcept {
  std::uint64_t h = std::uint64_t(square.x) * 0x9e3779b97f4a7c15ULL;
  h = (h ^ (h >> 29) ^ std::uint64_t(square.y)) * 0xbf58476d1ce4e5b9ULL;
  return std::size_t(h ^ (h >> 32));
}

NearestFirst::Square NearestFirst::squareOf(const Eigen::Vector2d& at) {
  const auto along = [](double m) {
    return std::int64_t(std::clamp(std::floor(m / kSquareM), -kFarthest, kFarthest));
  };
  return {along(at.x()), along(at.y())};
}

std::vector<map::SubmapId>& NearestFirst::filedIn(const Place& place) {
  return place.hidden ? hidden_ : squares_[squareOf(place.at)];
}

void NearestFirst::unfile(map::SubmapId id, const Place& place) {
  std::vector<map::SubmapId>& filed = filedIn(place);
  const map::SubmapId last = filed.back();
  filed[place.slot] = last;
  filed.pop_back();
  if (last != id) places_.at(last).slot = place.slot;
  if (!place.hidden && filed.empty()) squares_.erase(squareOf(place.at));
}

void NearestFirst::put(map::SubmapId id, const Eigen::Vector2d& at, bool hidden) {
  const auto [found, added] = places_.try_emplace(id);
  Place& place = found->second;
  if (!added) {
    if (place.at == at && place.hidden == hidden) return;
    unfile(id, place);
  }
  place.at = at;
  place.hidden = hidden;
  std::vector<map::SubmapId>& filed = filedIn(place);
  place.slot = filed.size();
  filed.push_back(id);
  // One who comes in ahead of what is planned, or of all hidden ones, is not to wait until the plan is used
  // up.
  if (!hidden && rank(at, view_, center_) <= plan_reach_) plan_.clear();
}

void NearestFirst::remove(map::SubmapId id) {
  const auto found = places_.find(id);
  if (found == places_.end()) return;
  const Place place = found->second;
  unfile(id, place);
  places_.erase(id);
}

void NearestFirst::clear() {
  places_.clear();
  squares_.clear();
  hidden_.clear();
  plan_.clear();
}

void NearestFirst::setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m) {
  view_ = visible_world;
  center_ = center_m;
  plan_.clear();
}

void NearestFirst::planVisible() {
  using Ranked = std::pair<double, map::SubmapId>;
  // The best that anything in a square could have.
  std::vector<std::pair<double, const std::vector<map::SubmapId>*>> squares;
  squares.reserve(squares_.size());
  const geometry::WorldRect reached = view_.empty() ? view_ : view_.grown(kReachM);
  for (const auto& [square, ids] : squares_) {
    const geometry::WorldRect rect{double(square.x) * kSquareM, double(square.y) * kSquareM,
                                   double(square.x + 1) * kSquareM, double(square.y + 1) * kSquareM};
    const Eigen::Vector2d nearest(std::clamp(center_.x(), rect.min_x, rect.max_x),
                                  std::clamp(center_.y(), rect.min_y, rect.max_y));
    const bool in_view = view_.empty() || reached.intersects(rect);
    squares.emplace_back((nearest - center_).norm() + (in_view ? 0 : kOutOfView), &ids);
  }
  const auto nearer = [](const auto& a, const auto& b) { return a.first < b.first; };
  double beyond = std::numeric_limits<double>::infinity();  // what the squares that are left out begin at
  if (squares.size() > kSquares) {
    std::nth_element(squares.begin(), squares.begin() + kSquares, squares.end(), nearer);
    beyond = squares[kSquares].first;
    squares.resize(kSquares);
  }
  std::vector<Ranked> ranked;
  for (const auto& [best, ids] : squares) {
    for (const map::SubmapId id : *ids) ranked.emplace_back(rank(places_.at(id).at, view_, center_), id);
  }
  if (ranked.size() > kPlanned) {
    std::nth_element(ranked.begin(), ranked.begin() + kPlanned, ranked.end());
    beyond = std::min(beyond, ranked[kPlanned].first);
    ranked.resize(kPlanned);
  }
  std::sort(ranked.begin(), ranked.end(), std::greater<>());
  // In a square that was left out somebody may be nearer than the last of these: they wait for the next plan.
  // By less than a square's diagonal that does not matter: along the rim of what is fetched already all
  // squares are about equally far, and plans would be of one or two.
  const auto sure = std::find_if(ranked.begin(), ranked.end() - 1, [&](const Ranked& one) {
    return one.first <= beyond + kSquareM * std::numbers::sqrt2;
  });
  ranked.erase(ranked.begin(), sure);
  plan_reach_ = ranked.front().first;
  for (const auto& [value, id] : ranked) plan_.push_back(id);
}

std::optional<map::SubmapId> NearestFirst::take() {
  const auto waits = [this](map::SubmapId id) {
    const auto found = places_.find(id);
    return found != places_.end() && !found->second.hidden;
  };
  while (!plan_.empty() && !waits(plan_.back())) plan_.pop_back();
  if (plan_.empty() && !squares_.empty()) planVisible();
  if (plan_.empty()) {
    plan_reach_ = std::numeric_limits<double>::infinity();
    if (hidden_.empty()) return std::nullopt;
    const map::SubmapId id = hidden_.back();
    remove(id);
    return id;
  }
  const map::SubmapId id = plan_.back();
  plan_.pop_back();
  remove(id);
  return id;
}

}  // namespace mapwright::submap
