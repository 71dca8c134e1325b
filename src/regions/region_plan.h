// Which regions of the view to ask for next. Pure state with the time handed in.
// Source: docs/protocols/rep130-map-dispatcher.md, "Regions".
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "map/failure.h"
#include "regions/map_ends.h"
#include "regions/region_cells.h"
#include "regions/squares_in_view.h"

namespace mapwright::regions {

/// Time on any monotonic clock.
using Millis = std::chrono::milliseconds;

struct PlanOptions {
  int most_under_way = 2;
  // Regions of so many cells; with more in view nothing is asked for. Where a dispatcher gives less at once
  // there are more of smaller ones, up to kMostPieces for each.
  int most_in_view = 32;
  int region_cells = RegionSheet::kStep;
  Millis cooldown{2'000};  // after a failure, doubling up to
  Millis cooldown_limit{60'000};
  double probe_m = 5;                  // edge of the first region, before the size of a cell is known
  double assumed_resolution_m = 0.05;  // of a robot that does not tell it
  /// Only what lies in it is wanted: a dispatcher may answer what is partly beyond its map with nothing.
  std::optional<geometry::WorldRect> only = {};
};

enum class RegionState {
  NotAsked,
  Fetching,  // for the first time
  Held,
  Nothing,  // was answered: there is nothing
  Failed,   // will be tried again while it is in view
};

/// What was wrong with an answer, or with getting one.
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
  bool whole_is_nothing = false;  // asked for as a whole it was answered with nothing
  std::uint64_t asked_for = 0;    // the round of its answer
  std::uint64_t request = 0;      // under way; 0 = none is
  int failures = 0;               // in a row
  Millis retry_at{0};
  RegionTrouble trouble;                  // of the last try; none = it went well
  std::uint64_t seen = 0;                 // when it was in view last, counted in views
  bool may_hold = false;                  // cells of it may have come
  std::uint64_t came_in = 0;              // the round that `came` is of
  std::vector<geometry::WorldRect> came;  // where cells came; not of a turned map
  // Cells of all of this came in answer to what was asked for. Empty = of none did, or the map is turned.
  geometry::WorldRect known = {};
  geometry::WorldRect part = {};  // which part of it was asked for by itself

  RegionState state() const;
  bool nothing() const { return answered && whole_is_nothing && !may_hold; }
  /// It is asked for once more; what came before is shown until then.
  bool refreshing() const { return answered && request != 0; }
};

struct RegionRequest {
  enum class Kind {
    First,   // how large are the cells?
    Square,  // all of a region
    Part,    // of a region that as a whole was answered with nothing
    End,     // does the map go as far as this?
    Look,    // nothing came of all that is in view: is there anything?
  };
  Kind kind = Kind::First;
  std::uint64_t id = 0;       // never 0
  std::uint64_t round = 0;    // counts refresh()
  RegionKey key = {};         // not of First
  Eigen::Vector2d aim{0, 0};  // so many of its lengths beside it is asked for
  /// What is asked for: rounding must not lose the cells at the rim.
  geometry::WorldRect rect = {};

  bool isOfSquare() const { return kind != Kind::First; }
};

/// What the dispatcher is asked for.
map::GridRegion questionOf(const RegionRequest& request);

/// Each region of a lattice is asked for once while it is in view, nearest to the middle first, a few at a
/// time; what failed waits and is asked for again; after refresh() all in view once more. What has left the
/// view is to be cancelled. What is too much for one answer (the robot refuses it, leaves some of it out, or
/// says nothing of it though it is on the map) is asked for in regions of half the edge.
class RegionPlan {
 public:
  /// Regions are not made smaller than this, cells along their edge.
  static constexpr int kLeastCells = 64;

  explicit RegionPlan(PlanOptions options = {});

  /// What is looked at: along the axes of the map, finite; nullopt = nothing.
  void setView(std::optional<geometry::WorldRect> rect, const Eigen::Vector2d& centre_m);
  /// How large the map is, as the robot tells; nullopt: it does not, or the map is turned.
  void setExtent(std::optional<geometry::WorldRect> extent) { ends_.tell(extent); }
  /// How large the cells are that come, and where their lattice begins. The first word counts, and one that
  /// is very different, a few times: regions are cut anew then, and all is asked for again. True when they
  /// were.
  bool setCells(double resolution_m, const Eigen::Vector2d& anchor_m);
  /// All that has been answered is old from now on; failures need not wait any longer.
  void refresh();
  /// What failed need not wait any longer.
  void retryNow();
  /// Everything is asked for so many of its own lengths beside where it lies, from now on.
  void aim(const Eigen::Vector2d& aim) { aim_ = aim; }

  /// What to send now; it counts as under way until it has ended.
  std::vector<RegionRequest> take(Millis now);
  /// Requests under way that nobody wants any more: each is told once.
  std::vector<std::uint64_t> unwanted();
  /// When take() may have something new without any other event.
  std::optional<Millis> nextDue(Millis now) const;
  /// Everything in view is there, as far as it is to be had: what failed has been tried so often.
  bool settled(int tries) const;

  const RegionRequest* find(std::uint64_t id) const;  // under way
  /// Squares have not been cut anew since it was asked for.
  bool isOfThisCut(std::uint64_t id) const;
  /// An answer came with so many cells, for whatever. Before answered().
  void gave(int width, int height);
  /// How a request ended: it brought something for its region (`known`: where; empty = that is not known), or
  /// that there is nothing; it went wrong, or it was cancelled.
  void answered(std::uint64_t id, bool nothing, const geometry::WorldRect& known = {});
  void failed(std::uint64_t id, RegionTrouble trouble, Millis now);
  void cancelled(std::uint64_t id);
  /// Cells came for this region, with its own answer or that for another; all of it, or a part: `where`,
  /// empty if the map is turned. `round`: of that request.
  void came(const RegionKey& key, const geometry::WorldRect& where, bool all, std::uint64_t round);
  /// The cells of this region are not held any more.
  void forget(const RegionKey& key);

  const RegionLattice& lattice() const { return squares_.lattice(); }
  std::optional<double> resolution() const { return resolution_m_; }
  const std::map<RegionKey, RegionRow>& rows() const { return rows_; }
  const RegionRow& row(const RegionKey& key) const;  // one of nothing where none is
  /// What is looked at; while more regions would be in view than are asked for, none.
  const SquaresInView& inView() const { return squares_; }
  bool tooFar() const { return squares_.tooMany(); }
  int underWay() const { return int(under_way_.size()); }
  /// Why the first region could not be had, while nothing is known of the map.
  const RegionTrouble& probeTrouble() const { return probe_.trouble; }
  /// What came of it ends before it does, though the map goes on: the answer was smaller than it should be.
  bool leftOut(const RegionKey& key) const;

 private:
  static constexpr int kMostCuts = 4;  // after refresh(); a map may be gridded anew, but not all the time
  static constexpr int kMostPieces = 64, kMostLooks = 64;

  double mostInView() const;
  void cut(double edge_m, const Eigen::Vector2d& anchor_m);
  RegionRow* rowOf(const RegionRequest& request);
  /// All that may be asked for now or later, in order.
  std::vector<RegionRequest> wanted() const;
  geometry::WorldRect firstRect() const;
  /// What of a region is wanted, and that with a margin, as far as it lies on the map.
  geometry::WorldRect squareOf(const RegionKey& key) const;
  geometry::WorldRect questionFor(const RegionKey& key) const;
  geometry::WorldRect partOf(const RegionKey& key) const;
  bool isCurrent(const RegionRow& row) const;
  /// It is to be asked for in part, as all of it was answered with nothing.
  bool asksInPart(const RegionKey& key) const;
  /// A place in a region, or right beside it, that is on the map.
  std::optional<geometry::WorldRect> groundAt(const RegionKey& key) const;
  std::optional<RegionRequest> lookForAnything() const;
  bool hasMoved() const;  // the view, since anything was looked for
  /// Searches for an end of the map, or halves the regions, where answers give reason to.
  void learn();
  bool halve(const geometry::WorldRect& asked);

  PlanOptions options_;
  SquaresInView squares_;
  int edge_cells_;
  std::int64_t most_given_ = 0;  // cells of the largest answer
  std::optional<double> resolution_m_;
  int cuts_left_ = kMostCuts;
  std::map<RegionKey, RegionRow> rows_;
  RegionRow probe_;
  Eigen::Vector2d aim_{0, 0};
  MapEnds ends_;
  RegionKey end_of_ = {};                       // where an end is searched for
  std::optional<Eigen::Vector2d> looked_from_;  // the middle of the view while anything was looked for
  int looks_ = 0, looks_left_ = kMostLooks;     // so many places since
  struct UnderWay {
    RegionRequest request;
    std::uint64_t cut = 0;  // of which lattice
    bool told = false;      // that it is unwanted
  };
  std::map<std::uint64_t, UnderWay> under_way_;
  std::uint64_t last_id_ = 0, round_ = 1, views_ = 0, cuts_ = 0;
};

}  // namespace mapwright::regions
