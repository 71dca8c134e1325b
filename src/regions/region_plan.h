// Which visible regions to request next. Pure state; time is passed in. Source:
// docs/protocols/rep130-map-dispatcher.md, "Regions".
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "map/failure.h"
#include "regions/region_cells.h"
#include "regions/region_lattice.h"

namespace mapwright::regions {

/// Time on any monotonic clock.
using Millis = std::chrono::milliseconds;

struct PlanOptions {
  int most_in_progress = 2;
  // In regions of normal size; if more are visible nothing is requested. If a dispatcher sends less at once
  // there are more, smaller ones, up to kMostPieces for each.
  int most_in_view = 32;
  int region_cells = 1024;  // RegionSheet::kStep
  Millis cooldown{2'000};   // after a failure, doubled up to
  Millis cooldown_limit{60'000};
  double probe_m = 5;                  // edge of the first region, before the cell size is known
  double assumed_resolution_m = 0.05;  // for a robot that does not report it
  /// Only this area is wanted.
  std::optional<geometry::WorldRect> only = {};
};

enum class RegionState {
  NotAsked,
  Fetching,  // for the first time
  Held,
  Nothing,  // was answered: there is nothing
  Failed,   // is retried while visible
};

/// What was wrong with an answer, or why there was none.
struct RegionTrouble {
  enum class Kind {
    None,
    Failed,     // `failure`
    Elsewhere,  // it answered with another region
    Misplaced,  // `misfit`
  };
  Kind kind = Kind::None;
  map::Failure failure = {};
  Misfit misfit = Misfit::None;
};

struct RegionRow {
  bool answered = false;
  bool came_empty = false;      // requested, it was answered with nothing
  std::uint64_t asked_for = 0;  // the round of its answer
  std::uint64_t request = 0;    // in progress; 0 = none
  int failures = 0;             // in a row
  Millis retry_at{0};
  RegionTrouble trouble;   // of the last attempt; none = success
  std::uint64_t seen = 0;  // when it was last visible, counted in views
  bool may_hold = false;   // cells of it may have arrived
  /// All of this area arrived in answer to a request. Empty = nothing did, or the map is rotated.
  geometry::WorldRect known = {};

  RegionState state() const;
  bool nothing() const { return answered && came_empty && !may_hold; }
  /// It was requested again; the old cells are shown until then.
  bool refreshing() const { return answered && request != 0; }
};

struct RegionRequest {
  bool is_first = true;     // not of a square: how large are the cells?
  std::uint64_t id = 0;     // never 0
  std::uint64_t round = 0;  // counts refresh()
  RegionKey key = {};       // of a square
  /// The requested area, with a margin so that rounding does not lose cells at the edge.
  geometry::WorldRect rect = {};
};

/// Requests each region of a lattice once while it is visible, nearest to the centre first, a few at a time;
/// failed ones wait and are retried; refresh() requests all visible ones again. Requests for regions that are
/// no longer visible are cancelled. If a region is too much for one answer (the robot refuses it, or leaves
/// out what is known to be on the map) regions are halved in edge length.
class RegionPlan {
 public:
  /// The minimum edge of a region in cells.
  static constexpr int kLeastCells = 64;

  explicit RegionPlan(PlanOptions options = {});

  /// The visible area: axis-aligned, finite; nullopt = nothing.
  void setView(std::optional<geometry::WorldRect> rect, const Eigen::Vector2d& centre_m);
  /// The size of the map as reported: only that is requested of the squares at its edge, since a dispatcher
  /// may answer with nothing if a region extends beyond its map. nullopt: not reported, or the map is
  /// rotated.
  void setExtent(std::optional<geometry::WorldRect> extent) { extent_ = extent; }
  /// The cell size and the origin of the cell lattice. The first call counts; later ones only if very
  /// different, and only a few times: then regions are laid out anew and everything is requested again. True
  /// if so.
  bool setCells(double resolution_m, const Eigen::Vector2d& anchor_m);
  /// Marks all answers as old; failures need not wait any longer.
  void refresh();
  /// Failed regions are retried at once.
  void retryNow();

  /// The requests to send now; they count as in progress until they end.
  std::vector<RegionRequest> take(Millis now);
  /// Requests in progress that are no longer needed: each is returned once.
  std::vector<std::uint64_t> unwanted();
  /// When take() may return something new without any other event.
  std::optional<Millis> nextDue(Millis now) const;
  /// Everything visible is loaded as far as possible: failed ones were tried this often.
  bool settled(int tries) const;

  const RegionRequest* find(std::uint64_t id) const;  // in progress
  /// The lattice has not changed since it was requested.
  bool isOfThisCut(std::uint64_t id) const;
  /// An answer arrived with cells. Call before answered().
  void gave(const map::GridReference& grid);
  /// A request ended: cells for its region (`known`: where; empty = unknown), or nothing there; or it failed,
  /// or was cancelled.
  void answered(std::uint64_t id, bool nothing, const geometry::WorldRect& known = {});
  void failed(std::uint64_t id, RegionTrouble trouble, Millis now);
  void cancelled(std::uint64_t id);
  /// Cells arrived for this region, with its own answer or another one: all or a part of it: `where`, empty
  /// if the map is rotated. `round`: of that request.
  void came(const RegionKey& key, const geometry::WorldRect& where, bool all, std::uint64_t round);
  /// The cells of this region were dropped.
  void forget(const RegionKey& key);

  const RegionLattice& lattice() const { return squares_.lattice(); }
  std::optional<double> resolution() const { return resolution_m_; }
  const std::map<RegionKey, RegionRow>& rows() const { return rows_; }
  const RegionRow& row(const RegionKey& key) const;  // an empty one if there is none
  /// The visible squares; none if there are too many to request.
  const SquaresInView& inView() const { return squares_; }
  bool tooFar() const { return squares_.tooMany(); }
  int inProgress() const { return int(in_progress_.size()); }
  /// Why the first region could not be loaded, while nothing is known of the map.
  const RegionTrouble& probeTrouble() const { return probe_.trouble; }
  /// The wanted part of a region.
  geometry::WorldRect squareOf(const RegionKey& key) const;
  /// Its answer lacks a part that is known to be on the map.
  bool leftOut(const RegionKey& key) const;

 private:
  static constexpr int kMostCuts = 4;  // after refresh(); the lattice may change, but not all the time
  static constexpr int kMostPieces = 64;

  double mostInView() const;
  void cut(double edge_m, const Eigen::Vector2d& anchor_m);
  RegionRow* rowOf(const RegionRequest& request);
  /// Everything to request now or later, in order.
  std::vector<RegionRequest> wanted() const;
  geometry::WorldRect firstRect() const;
  /// What is requested of a region: the wanted part that is on the map, with a margin.
  geometry::WorldRect questionFor(const RegionKey& key) const;
  /// Halves the regions if that is not more than what was delivered before.
  bool halve(const geometry::WorldRect& asked);

  PlanOptions options_;
  SquaresInView squares_;
  int edge_cells_;
  std::int64_t most_given_ = 0;  // cells of the largest answer
  std::optional<double> resolution_m_;
  int cuts_left_ = kMostCuts;
  std::map<RegionKey, RegionRow> rows_;
  RegionRow probe_;
  std::optional<geometry::WorldRect> extent_;
  geometry::WorldRect reach_;  // of the cells that came since refresh(); not for a rotated map
  struct RequestInProgress {
    RegionRequest request;
    std::uint64_t cut = 0;  // of which lattice
    bool told = false;      // reported as unwanted
  };
  std::map<std::uint64_t, RequestInProgress> in_progress_;
  std::uint64_t last_id_ = 0, round_ = 1, views_ = 0, cuts_ = 0;
};

}  // namespace mapwright::regions
