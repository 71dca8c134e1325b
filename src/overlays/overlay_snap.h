// Snapping while overlays are drawn and dragged: what is close enough, and what it is. Pure; world metres.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>

#include "overlays/editing_document.h"
#include "overlays/overlay_shapes.h"
#include "placing/ground.h"

namespace mapwright::overlays {

/// What to snap to.
struct SnapKinds {
  bool vertices = true, edges = true;  // of other features
  bool grid = false;                   // lines at multiples of `grid_m`
  bool angles = true;                  // from the last point, or from the neighbours
  bool walls = false;                  // the edges of occupied cells
  double grid_m = 0.5;                 // above 0
  bool operator==(const SnapKinds&) const = default;
};

enum class SnapTo { Nothing, Vertex, Edge, Wall, Angle, Grid };

struct Snapped {
  Eigen::Vector2d at_m{0, 0};
  SnapTo to = SnapTo::Nothing;
  Eigen::Vector2d from_m{0, 0}, to_m{0, 0};  // Edge, Angle: the line that it lies on
};

/// The points and sides of all features, found by their place. A query looks at what is near it, however many
/// there are.
class SnapIndex {
 public:
  SnapIndex() = default;
  void add(FeatureKey key, const std::vector<Path>& paths);
  /// After the last add(), before the first query.
  void finish();

  using Ignored = std::function<bool(FeatureKey)>;
  std::optional<Eigen::Vector2d> nearestVertex(const Eigen::Vector2d& at_m, double reach_m,
                                               const Ignored& ignored) const;
  struct Side {
    Eigen::Vector2d from_m{0, 0}, to_m{0, 0};
    FeatureKey key = 0;
  };
  std::optional<Side> nearestSide(const Eigen::Vector2d& at_m, double reach_m, const Ignored& ignored) const;

 private:
  using Cell = std::int64_t;
  std::int32_t columnOf(double metres) const;
  template <class Visit>
  void around(const Eigen::Vector2d& at_m, double reach_m, Visit visit) const;

  double cell_m_ = 1;
  std::vector<Side> sides_;                                       // a point is one without length
  std::unordered_map<Cell, std::vector<std::uint32_t>> by_cell_;  // sides by the cells that they cross
};

struct SnapScene {
  const SnapIndex* index = nullptr;          // null: there are no others
  SnapIndex::Ignored ignored = {};           // empty: none
  placing::Ground* ground = nullptr;         // null: there are no walls
  std::vector<Eigen::Vector2d> arms_m = {};  // points from which angles are counted
  double angle_step_deg = 15;
};

/// A vertex comes before a side, that before a wall, an angle and the grid; of each the nearest.
Snapped snapped(const Eigen::Vector2d& free_m, double reach_m, const SnapKinds& kinds,
                const SnapScene& scene);

}  // namespace mapwright::overlays
