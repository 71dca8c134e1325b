// A map by the regions in view: what is asked for, what came, what is kept. Pure state; time and answers are
// handed in.
#pragma once

#include <optional>
#include <vector>

#include "regions/region_cells.h"
#include "regions/region_plan.h"
#include "robot/call.h"

namespace mapwright::regions {

/// One region as it is to be drawn and told of.
struct RegionView {
  RegionKey key;
  geometry::WorldRect rect;
  RegionState state = RegionState::NotAsked;
  bool refreshing = false;
  RegionTrouble trouble = {};  // of the last try
};

/// How the regions in view stand.
struct RegionCounts {
  int in_view = 0, answered = 0, nothing = 0, fetching = 0, failed = 0;  // nothing: of those answered
  int smaller = 0;  // answered with less than was asked for, though there is map beyond: something is missing
  bool operator==(const RegionCounts&) const = default;
};

class MapRegions {
 public:
  struct Options {
    std::size_t budget_bytes = std::size_t(128) << 20;  // of cells; what is in view is held all the same
    PlanOptions plan = {};
  };
  explicit MapRegions(Options options);

  void setView(std::optional<geometry::WorldRect> rect, const Eigen::Vector2d& centre_m);
  /// How large the map is, as the robot tells.
  void setExtent(const std::optional<map::GridReference>& extent);
  void refresh() { plan_.refresh(); }
  void retryNow() { plan_.retryNow(); }
  std::vector<RegionRequest> take(Millis now) { return plan_.take(now); }
  std::vector<std::uint64_t> unwanted() { return plan_.unwanted(); }
  std::optional<Millis> nextDue(Millis now) const { return plan_.nextDue(now); }

  /// What of the screen an answer changes: cells in `cells` are others (empty = none are).
  struct Change {
    geometry::WorldRect cells;
    bool sheets = false;  // there are others than before, or in another order
  };
  Change answered(std::uint64_t id, robot::Outcome<map::GridPart> outcome, Millis now);

  const RegionPlan& plan() const { return plan_; }
  const std::vector<std::shared_ptr<RegionSheet>>& sheets() const { return cells_.sheets(); }
  const std::string& frame() const { return cells_.frame(); }
  std::size_t bytes() const { return cells_.bytes(); }
  RegionCounts counts() const;
  /// Nearest to the middle first.
  std::vector<RegionView> inView() const;
  /// All that has an answer and touches `rect`, in view or not.
  std::vector<RegionView> answeredIn(const geometry::WorldRect& rect) const;
  /// The region at a point, while regions are in view; nullopt where none is cut.
  std::optional<RegionView> at(const Eigen::Vector2d& world_m) const;
  /// What a map of `rect` would be in cells; nullopt while it is not known how large they are.
  std::optional<double> cellsOf(const geometry::WorldRect& rect) const;
  /// The robot takes what it is asked for as a corner of the region, not as its middle, and is asked
  /// accordingly.
  bool asksForCorners() const { return reading_ == Reading::Corner; }
  /// Cells of its answers that were neither -1 nor 0 to 100, as the adapter has counted them.
  std::int64_t oddCells() const { return odd_cells_; }
  /// Some cell came that lies in `rect`.
  bool holdsAnyOf(const geometry::WorldRect& rect) const;
  /// Where the known part of the map ends; empty = nothing is known of it.
  const geometry::WorldRect& reach() const { return cells_.reach(); }

 private:
  RegionView viewOf(const RegionKey& key) const;
  void place(const RegionRequest& request, const map::GridPart& part, Millis now, Change& change);
  /// The cells of what was asked for, but those that came since all was asked for anew.
  void forgetOld(const RegionRequest& request, Change& change);
  void noteCovered(const RegionRequest& request, const map::GridReference& grid);
  void keepToBudget(Change& change);
  /// Learns how the robot reads places, where answers lie elsewhere in a way that can be met.
  void noteAim(const RegionRequest& request, const map::GridReference& grid, bool elsewhere);

  Options options_;
  RegionPlan plan_;
  RegionCells cells_;
  enum class Reading { NotKnown, Suspected, Corner, Given };  // Given: no corner, or nothing helps
  Reading reading_ = Reading::NotKnown;
  std::int64_t odd_cells_ = 0;
};

}  // namespace mapwright::regions
