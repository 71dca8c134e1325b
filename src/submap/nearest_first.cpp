#include "submap/nearest_first.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace mapwright::submap {
namespace {

constexpr std::size_t kPlanned = 512;  // put in order at a time
constexpr double kReachM = 12;         // of a submap from its position
constexpr double kOutOfView = 1e9;     // farther than anything in view

}  // namespace

double NearestFirst::rank(const Place& place) const {
  const double distance = (place.at - center_).norm();
  if (place.hidden) return distance + 2 * kOutOfView;
  return view_.empty() || view_.grown(kReachM).contains(place.at) ? distance : distance + kOutOfView;
}

void NearestFirst::put(map::SubmapId id, const Eigen::Vector2d& at, bool hidden) {
  const auto [found, added] = places_.try_emplace(id);
  Place& place = found->second;
  if (!added && place.at == at && place.hidden == hidden) return;
  place = {at, hidden};
  if (rank(place) <= plan_reach_) plan_.clear();
}

void NearestFirst::clear() {
  places_.clear();
  plan_.clear();
}

void NearestFirst::setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m) {
  view_ = visible_world;
  center_ = center_m;
  plan_.clear();
}

void NearestFirst::makePlan() {
  std::vector<std::pair<double, map::SubmapId>> ranked;
  ranked.reserve(places_.size());
  for (auto& [id, place] : places_) {
    place.planned = false;
    ranked.emplace_back(rank(place), id);
  }
  if (ranked.size() > kPlanned) {
    std::nth_element(ranked.begin(), ranked.begin() + kPlanned, ranked.end());
    ranked.resize(kPlanned);
  }
  std::sort(ranked.begin(), ranked.end(), std::greater<>());
  plan_reach_ = ranked.front().first;
  for (const auto& [value, id] : ranked) {
    places_.at(id).planned = true;
    plan_.push_back(id);
  }
}

std::optional<map::SubmapId> NearestFirst::take() {
  while (!places_.empty()) {
    if (plan_.empty()) makePlan();
    const auto found = places_.find(plan_.back());
    plan_.pop_back();
    if (found == places_.end() || !found->second.planned) continue;
    const map::SubmapId id = found->first;
    places_.erase(found);
    return id;
  }
  return std::nullopt;
}

}  // namespace mapwright::submap
