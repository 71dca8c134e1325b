// A map loaded by the visible regions: what to request, what arrived, what to keep. Pure state; time and
// answers are passed in.
#pragma once

#include <optional>
#include <vector>

#include "regions/region_cells.h"
#include "regions/region_plan.h"
#include "robot/call.h"

namespace mapwright::regions {

/// One region for drawing and tooltips.
struct RegionView {
  RegionKey key;
  geometry::WorldRect rect;
  RegionState state = RegionState::NotAsked;
  bool refreshing = false;
  RegionTrouble trouble = {};  // of the last attempt
};

/// The states of the visible regions.
struct RegionCounts {
  int in_view = 0, answered = 0, nothing = 0, fetching = 0, failed = 0;  // nothing: of the answered ones
  int smaller = 0;  // answered with less than requested, although the map continues: something is missing
  bool operator==(const RegionCounts&) const = default;
};

/// An answer lies elsewhere if it does not overlap `asked` at all, or has the same size but is displaced.
/// Clipped, padded or larger answers do not.
bool liesElsewhere(const map::GridReference& answer, const geometry::WorldRect& asked);
/// The overlap; empty for a rotated answer.
geometry::WorldRect commonGround(const map::GridReference& answer, const geometry::WorldRect& asked);

class MapRegions {
 public:
  struct Options {
    std::size_t budget_bytes = std::size_t(128) << 20;  // for cells; visible ones are kept in any case
    PlanOptions plan = {};
  };
  explicit MapRegions(Options options);

  void setView(std::optional<geometry::WorldRect> rect, const Eigen::Vector2d& centre_m);
  /// The size of the map as reported by the robot.
  void setExtent(const std::optional<map::GridReference>& extent);
  void refresh() { plan_.refresh(); }
  void retryNow() { plan_.retryNow(); }
  std::vector<RegionRequest> take(Millis now) { return plan_.take(now); }
  std::vector<std::uint64_t> unwanted() { return plan_.unwanted(); }
  std::optional<Millis> nextDue(Millis now) const { return plan_.nextDue(now); }

  /// What an answer changes on screen: the cells in `cells` (empty = none).
  struct Change {
    geometry::WorldRect cells;
    bool sheets = false;  // sheets were added, removed or reordered
  };
  Change answered(std::uint64_t id, robot::Outcome<map::GridPart> outcome, Millis now);

  const RegionPlan& plan() const { return plan_; }
  const std::vector<std::shared_ptr<RegionSheet>>& sheets() const { return cells_.sheets(); }
  const std::string& frame() const { return cells_.frame(); }
  std::size_t bytes() const { return cells_.bytes(); }
  RegionCounts counts() const;
  /// Nearest to the centre first.
  std::vector<RegionView> inView() const;
  /// All answered regions that touch `rect`, visible or not.
  std::vector<RegionView> answeredIn(const geometry::WorldRect& rect) const;
  /// The region at a point, while regions are shown; nullopt if there is none.
  std::optional<RegionView> at(const Eigen::Vector2d& world_m) const;
  /// How many cells a map of `rect` would have; nullopt while the cell size is unknown.
  std::optional<double> cellsOf(const geometry::WorldRect& rect) const;
  /// Cells of its answers outside the range -1 to 100, as counted by the adapter.
  std::int64_t oddCells() const { return odd_cells_; }
  /// At least one received cell is in `rect`.
  bool holdsAnyOf(const geometry::WorldRect& rect) const;
  /// The bounds of the known part of the map; empty = nothing is known.
  const geometry::WorldRect& reach() const { return cells_.reach(); }

 private:
  RegionView viewOf(const RegionKey& key) const;
  void place(const RegionRequest& request, const map::GridPart& part, Millis now, Change& change);
  /// If the map has become smaller, nothing of the old one must stay.
  void forgetOld(const RegionRequest& request, Change& change);
  void markCovered(const RegionRequest& request, const map::GridReference& grid);
  void keepToBudget(Change& change);

  Options options_;
  RegionPlan plan_;
  RegionCells cells_;
  std::int64_t odd_cells_ = 0;
};

}  // namespace mapwright::regions
