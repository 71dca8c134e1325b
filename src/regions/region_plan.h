// Which regions of the view to ask for next. Pure state with the time handed in.
// Source: rep130.md ("ROI requests are the way to see a large map").
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "map/failure.h"
#include "regions/region_cells.h"
#include "regions/region_lattice.h"

namespace mapwright::regions {

/// Time on any monotonic clock.
using Millis = std::chrono::milliseconds;

struct PlanOptions {
  int most_under_way = 2;
  int most_in_view = 32;  // regions; with more in view nothing is asked for
  int region_cells = RegionSheet::kStep;
  Millis cooldown{2'000};  // after a failure, doubling up to
  Millis cooldown_limit{60'000};
  double probe_m = 5;                  // edge of the first region, before the size of a cell is known
  double assumed_resolution_m = 0.05;  // of a robot that does not tell it
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
  bool answered = false, nothing = false;
  std::uint64_t asked_for = 0;  // the round of its answer
  std::uint64_t ask = 0;        // under way; 0 = none is
  int failures = 0;             // in a row
  Millis retry_at{0};
  RegionTrouble trouble;   // of the last try; none = it went well
  std::uint64_t seen = 0;  // when it was in view last, counted in views
  bool may_hold = false;   // cells of it may have come

  RegionState state() const;
  /// It is asked for once more; what came before is shown until then.
  bool refreshing() const { return answered && ask != 0; }
};

/// One request. Without a key it is to find out how large the cells are.
struct RegionAsk {
  std::uint64_t id = 0;     // never 0
  std::uint64_t round = 0;  // counts refresh()
  std::optional<RegionKey> key;
  geometry::WorldRect rect;  // whose cells are wanted
  geometry::WorldRect
      asking;  // what the dispatcher is asked for: rounding must not lose the cells at the rim
};

/// Each region of a lattice is asked for once while it is in view, nearest to the middle first, a few at a
/// time; what failed waits and is asked for again; after refresh() all in view once more. What has left the
/// view is to be cancelled.
class RegionPlan {
 public:
  explicit RegionPlan(PlanOptions options = {});

  /// What is looked at: along the axes of the map, finite; nullopt = nothing.
  void setView(std::optional<geometry::WorldRect> rect, const Eigen::Vector2d& centre_m);
  /// How large the cells are that come, and where their lattice begins. The first word counts, and one that
  /// is very different, a few times: regions are cut anew then, and all is asked for again. True when they
  /// were.
  bool setCells(double resolution_m, const Eigen::Vector2d& anchor_m);
  /// All that has been answered is old from now on; failures need not wait any longer.
  void refresh();

  /// What failed need not wait any longer.
  void retryNow();

  /// What to send now; it counts as under way until ended().
  std::vector<RegionAsk> take(Millis now);
  /// Requests under way that nobody wants any more: each is told once.
  std::vector<std::uint64_t> unwanted();
  /// When take() may have something new without any other event.
  std::optional<Millis> nextDue(Millis now) const;

  const RegionAsk* find(std::uint64_t id) const;  // under way
  /// How a request ended: it brought something for its region (`nothing`: that there is none), it went wrong,
  /// or it was cancelled.
  void answered(std::uint64_t id, bool nothing);
  void failed(std::uint64_t id, RegionTrouble trouble, Millis now);
  void cancelled(std::uint64_t id);
  /// Cells came for this region with the answer for another; all of it, or a part. `round`: of that request.
  void came(const RegionKey& key, bool all, std::uint64_t round);
  /// The cells of this region are not held any more.
  void forget(const RegionKey& key);

  const RegionLattice& lattice() const { return lattice_; }
  std::optional<double> resolution() const { return resolution_m_; }
  const std::map<RegionKey, RegionRow>& rows() const { return rows_; }
  const RegionRow& row(const RegionKey& key) const;  // one of nothing where none is
  /// Nearest to the middle first; empty while tooFar().
  const std::vector<RegionKey>& inView() const { return in_view_; }
  bool isInView(const RegionKey& key) const { return in_view_set_.contains(key); }
  /// More regions would be in view than are asked for.
  bool tooFar() const { return too_far_; }
  int underWay() const { return int(under_way_.size()); }
  /// Why the first region could not be had, while nothing is known of the map.
  const RegionTrouble& probeTrouble() const { return probe_.trouble; }
  /// Everything in view is there, as far as it is to be had: what failed has been tried so often.
  bool settled(int tries) const;

 private:
  static constexpr int kMostCuts = 4;  // after refresh(); a map may be gridded anew, but not all the time

  bool wanted(const RegionRow& row) const;
  void listInView();
  void cut(double edge_m, const Eigen::Vector2d& anchor_m);
  RegionRow* rowOf(const RegionAsk& ask);
  void wait(RegionRow& row, Millis now) const;

  PlanOptions options_;
  RegionLattice lattice_;
  std::optional<double> resolution_m_;
  bool cut_ = false;  // the lattice may be used
  int cuts_left_ = kMostCuts;
  std::optional<geometry::WorldRect> view_;
  Eigen::Vector2d centre_m_{0, 0};
  std::vector<RegionKey> in_view_;
  std::set<RegionKey> in_view_set_;
  bool too_far_ = false;
  std::map<RegionKey, RegionRow> rows_;
  RegionRow probe_;
  struct UnderWay {
    RegionAsk ask;
    std::uint64_t cut = 0;  // of which lattice
    bool told = false;      // that it is unwanted
  };
  std::map<std::uint64_t, UnderWay> under_way_;
  std::uint64_t last_id_ = 0, round_ = 1, views_ = 0, cuts_ = 0;
};

}  // namespace mapwright::regions
