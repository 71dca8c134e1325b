// Chooses the nearest of many positions. Pure state.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "geometry/rect.h"
#include "map/submap.h"

namespace mapwright::submap {

/// A queue of submaps: visible ones first, then the others, each by distance from the centre of the view, and
/// hidden ones last. Indexed by position, so that neither a change nor another view visits all of them: a
/// view is only evaluated when the next one is taken, square by square.
class NearestFirst {
 public:
  /// Adds or moves. Positions in metres, in the world.
  void put(map::SubmapId id, const Eigen::Vector2d& at, bool hidden);
  void remove(map::SubmapId id);
  void clear();
  void setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m);

  /// Takes the next one out.
  std::optional<map::SubmapId> take();
  std::size_t size() const { return places_.size(); }

 private:
  struct Square {
    std::int64_t x = 0, y = 0;
    bool operator==(const Square&) const = default;
  };
  struct SquareHash {
    std::size_t operator()(const Square& square) const noexcept;
  };
  struct Place {
    Eigen::Vector2d at{0, 0};
    bool hidden = false;
    std::size_t slot = 0;  // in its square, or among the hidden ones
  };
  static Square squareOf(const Eigen::Vector2d& at);
  std::vector<map::SubmapId>& filedIn(const Place& place);
  void unfile(map::SubmapId id, const Place& place);
  void planVisible();

  std::unordered_map<map::SubmapId, Place> places_;
  std::unordered_map<Square, std::vector<map::SubmapId>, SquareHash> squares_;
  std::vector<map::SubmapId> hidden_;
  geometry::WorldRect view_;
  Eigen::Vector2d center_{0, 0};
  std::vector<map::SubmapId> plan_;  // the next ones, best last; some may be gone
  double plan_reach_ = 0;            // anything nearer than this belongs into the plan
};

}  // namespace mapwright::submap
