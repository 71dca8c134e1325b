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

double NearestFirst::rank(const Candidate& candidate) const {
  const double distance = (candidate.at - center_).norm();
  if (candidate.hidden) return distance + 2 * kOutOfView;
  return view_.empty() || view_.grown(kReachM).contains(candidate.at) ? distance : distance + kOutOfView;
}

void NearestFirst::put(map::SubmapId id, const Eigen::Vector2d& at, bool hidden) {
  const auto [found, added] = candidates_.try_emplace(id);
  Candidate& candidate = found->second;
  if (!added && candidate.at == at && candidate.hidden == hidden) return;
  candidate = {at, hidden};
  if (rank(candidate) <= plan_reach_) plan_.clear();
}

void NearestFirst::clear() {
  candidates_.clear();
  plan_.clear();
}

void NearestFirst::setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m) {
  view_ = visible_world;
  center_ = center_m;
  plan_.clear();
}

void NearestFirst::makePlan() {
  std::vector<std::pair<double, map::SubmapId>> ranked;
  ranked.reserve(candidates_.size());
  for (auto& [id, candidate] : candidates_) {
    candidate.planned = false;
    ranked.emplace_back(rank(candidate), id);
  }
  if (ranked.size() > kPlanned) {
    std::nth_element(ranked.begin(), ranked.begin() + kPlanned, ranked.end());
    ranked.resize(kPlanned);
  }
  std::sort(ranked.begin(), ranked.end(), std::greater<>());
  plan_reach_ = ranked.front().first;
  for (const auto& [value, id] : ranked) {
    candidates_.at(id).planned = true;
    plan_.push_back(id);
  }
}

std::optional<map::SubmapId> NearestFirst::take() {
  while (!candidates_.empty()) {
    if (plan_.empty()) makePlan();
    const auto found = candidates_.find(plan_.back());
    plan_.pop_back();
    if (found == candidates_.end() || !found->second.planned) continue;
    const map::SubmapId id = found->first;
    candidates_.erase(found);
    return id;
  }
  return std::nullopt;
}

}  // namespace mapwright::submap
