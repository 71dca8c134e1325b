// Chooses the nearest of many positions. Pure state.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "geometry/rect.h"
#include "map/submap.h"

namespace mapwright::submap {

/// A queue of submaps: those in view first, then the others, then hidden ones, each by distance from the
/// centre of the view. The order is made when the next one is taken, for many at a time.
class NearestFirst {
 public:
  /// Adds or moves. Positions in metres, in the world.
  void put(map::SubmapId id, const Eigen::Vector2d& at, bool hidden);
  void remove(map::SubmapId id) { candidates_.erase(id); }
  void clear();
  void setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m);

  /// Takes the next one out.
  std::optional<map::SubmapId> take();
  std::size_t size() const { return candidates_.size(); }

 private:
  struct Candidate {
    Eigen::Vector2d at{0, 0};
    bool hidden = false;
    bool planned = false;  // in the plan, at its position in the order
  };
  double rank(const Candidate& candidate) const;
  void makePlan();

  std::unordered_map<map::SubmapId, Candidate> candidates_;
  geometry::WorldRect view_;
  Eigen::Vector2d center_{0, 0};
  std::vector<map::SubmapId> plan_;  // the next ones, best last; some may be gone or have moved since
  double plan_reach_ = 0;            // anything nearer than this belongs into the plan
};

}  // namespace mapwright::submap
