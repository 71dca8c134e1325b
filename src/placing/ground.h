// The map under waypoints: what is at a position, and how far the next wall is. Pure; the cost of a query
// does not depend on the size of the map.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "map/grid_reference.h"

namespace mapwright::grids {
class GridPyramid;
}

namespace mapwright::placing {

/// A whole map at its position. `cells` null: there is none.
struct PlacedMap {
  std::shared_ptr<const grids::GridPyramid> cells;
  map::GridReference reference;  // with the size of `cells`
  bool is_part = false;          // the map may continue beyond its edge
  bool operator==(const PlacedMap&) const = default;
};

enum class Cell : std::uint8_t { Outside, Unknown, Free, Occupied };

/// A cell counts as a wall if it is known and at least this many percent occupied.
inline constexpr int kOccupiedPercent = 50;

struct Wall {
  double distance_m = 0;  // from the position to the edge of the nearest occupied cell; 0 inside one
  Eigen::Vector2d at_m{0, 0};
};

/// Reads the cells of one map. Do not share it between threads; the cells may be shared.
class Ground {
 public:
  enum class Access {
    AtHand,  // fast, for the GUI thread. Anything slow to get counts as unknown.
    Wait,    // exact: reads whatever is needed
  };
  Ground(PlacedMap map, Access access);

  /// There are cells, and their position is valid.
  bool there() const { return usable_; }
  const PlacedMap& map() const { return map_; }
  Cell at(const Eigen::Vector2d& world_m);
  /// The nearest wall within `reach_m`; nullopt = none. AtHand searches at most kMostCellsAtHand cells.
  std::optional<Wall> nearestWall(const Eigen::Vector2d& world_m, double reach_m);
  /// No cell of it is known. Costs one tile.
  bool allUnknown();

  static constexpr int kMostCellsAtHand = 100;

 private:
  struct Held {
    int level = -1, x = 0, y = 0;
    std::shared_ptr<const std::uint8_t> cells;  // null: not available
  };
  struct Search {
    Eigen::Vector2d from;  // in cells
    double best;           // in cells
    std::optional<Eigen::Vector2d> nearest;
  };
  std::uint8_t byteAt(int level, int column, int row);
  const std::uint8_t* tileAt(int level, int x, int y);  // null: not available
  void lookNear(Search& search);
  void look(Search& search, int level, int column, int row);
  void lookAround(Search& search);

  PlacedMap map_;
  Access access_;
  bool usable_ = false, coarse_tells_ = false;
  std::uint8_t unknown_ = 0;
  std::array<bool, 256> known_{}, occupied_{};
  std::vector<Held> held_;
};

}  // namespace mapwright::placing
