// Which regions of the view to ask for next. Pure state with the time handed in.
// Source: docs/protocols/rep130-map-dispatcher.md, "Regions".
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "map/failure.h"
#include "regions/answer_limit.h"
#include "regions/region_cells.h"
#include "regions/region_lattice.h"
#include "regions/region_rim.h"

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
  bool answered = false, nothing = false;
  std::uint64_t asked_for = 0;  // the round of its answer
  std::uint64_t ask = 0;        // under way; 0 = none is
  int failures = 0;             // in a row
  Millis retry_at{0};
  RegionTrouble trouble;                  // of the last try; none = it went well
  std::uint64_t seen = 0;                 // when it was in view last, counted in views
  bool may_hold = false;                  // cells of it may have come
  std::uint64_t came_in = 0;              // the round that `came` is of
  std::vector<geometry::WorldRect> came;  // where cells came
  // Cells of all of this came in answer to what was asked for. Empty = of none did, or the map is turned.
  geometry::WorldRect known = {};
  // Asked for as a whole it was answered with nothing; what came since came in parts.
  bool all_is_nothing = false;
  bool only_tried = false;                    // no more of it than is wanted has been asked for
  std::optional<Eigen::Vector2d> looked_for;  // the middle of a view around which it was asked for by itself
  int looks = 0;                              // so many of its own places likewise
  std::optional<RimSearch> rim;               // the rim of the map in it, while that is searched
  std::array<bool, 4> beside{}, within{};     // from where it has been searched; by Side
  std::array<int, 4> cells_to{};              // how far the search got
  std::array<bool, 4> looked_beyond{};        // whether the map goes on where its answer ends; by Side
  int lost_looks = 0;                         // questions for that which failed
  std::optional<QuarterSearch> quarters;      // whether it was too much to be answered, while that is asked

  RegionState state() const;
  /// It is asked for once more; what came before is shown until then.
  bool refreshing() const { return answered && ask != 0; }
};

/// One request. Without a key it is to find out how large the cells are.
struct RegionAsk {
  std::uint64_t id = 0;     // never 0
  std::uint64_t round = 0;  // counts refresh()
  std::optional<RegionKey> key = {};
  bool part = false;                // of the square: as a whole it was answered with nothing
  bool quarter = false;             // to find out whether the square is too much to be answered
  std::optional<Side> beyond = {};  // to find out whether the map goes on where the answer ended
  Eigen::Vector2d aim{0, 0};        // so many of its lengths beside it is asked for
  geometry::WorldRect rect = {};    // whose cells are wanted
  geometry::WorldRect asking =
      {};  // what the dispatcher is asked for: rounding must not lose the cells at the rim
};

/// What the dispatcher is asked for.
map::GridRegion questionOf(const RegionAsk& ask);

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

  /// Everything is asked for so many of its own lengths beside where it lies, from now on.
  void aim(const Eigen::Vector2d& aim) { aim_ = aim; }

  /// What to send now; it counts as under way until ended().
  std::vector<RegionAsk> take(Millis now);
  /// Requests under way that nobody wants any more: each is told once.
  std::vector<std::uint64_t> unwanted();
  /// When take() may have something new without any other event.
  std::optional<Millis> nextDue(Millis now) const;

  const RegionAsk* find(std::uint64_t id) const;  // under way
  /// Squares have not been cut anew since it was asked for.
  bool isOfThisCut(std::uint64_t id) const;
  /// An answer came with so many cells, for whatever. Before answered().
  void gave(int width, int height) { limit_.gave(width, height); }
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
  /// What came of it ends before it does, though there is map beside it: the answer was smaller than it
  /// should be.
  bool hasSeam(const RegionKey& key) const;
  /// It gives less at once than it would be asked for: squares are smaller.
  bool isLimited() const { return limit_.pieces() > 1; }
  /// Everything in view is there, as far as it is to be had: what failed has been tried so often.
  bool settled(int tries) const;

 private:
  static constexpr int kMostCuts = 4;  // after refresh(); a map may be gridded anew, but not all the time
  static constexpr int kMostPieces = 64, kMostSearches = 3, kMostEnds = 16, kMostLostLooks = 3,
                       kMostFineLooks = 64;

  bool wanted(const RegionRow& row) const;
  double mostInView() const;
  RegionAsk send(RegionAsk ask, RegionRow& row);
  void listInView();
  void cut(double edge_m, const Eigen::Vector2d& anchor_m);
  RegionRow* rowOf(const RegionAsk& ask);
  void wait(RegionRow& row, Millis now) const;
  /// What of a square is wanted.
  geometry::WorldRect squareOf(const RegionKey& key) const;
  /// Whether it is current that the whole of it was answered with nothing, and nothing is under way.
  bool canBeSearched(const RegionRow& row) const;
  /// Begins to search for the rim of the map in a square, or in that and those beside it, if there is reason
  /// to.
  void searchIn(const RegionKey& key);
  void searchAround(const RegionKey& key);
  bool beginRim(const RegionKey& key, RegionRow& row, const geometry::WorldRect& known, Side towards);
  int hintFor(const RegionKey& key, Side towards) const;
  void partAnswered(const RegionAsk& ask, RegionRow& row, bool nothing, const geometry::WorldRect& known);
  /// What of a square that was answered with nothing is to be asked for by itself. `middle`: emptyMiddle().
  std::optional<geometry::WorldRect> partOf(const RegionKey& key,
                                            const std::optional<RegionKey>& middle) const;

  /// The quarters of a square in view are asked for. Of one that has left the view that waits.
  bool searching() const;
  /// What finds out how much is given at once: before anything else is asked for.
  std::optional<RegionAsk> askAboutLimit() const;
  /// The side of a square where its answer ends and may end with the map, or not.
  std::optional<Side> openSide(const RegionKey& key) const;
  bool endsHere(const geometry::WorldRect& known, Side side) const;
  void lookedBeyond(const RegionAsk& ask, RegionRow& row, bool nothing, const geometry::WorldRect& known);
  /// It may have been too much: begins to search. False: there is no reason to think so.
  bool beginQuarters(const RegionAsk& ask, RegionRow& row, const std::optional<Eigen::Vector2d>& place);
  void quarterAnswered(const RegionAsk& ask, RegionRow& row, bool nothing, const geometry::WorldRect& known);
  /// Somewhere in the square where the map is.
  std::optional<Eigen::Vector2d> placeIn(const RegionKey& key) const;
  void takeLimit();

  /// The square in the middle of the view, where nothing at all has been found in view.
  std::optional<RegionKey> emptyMiddle() const;
  struct Look {
    Eigen::Vector2d place;
    bool middle_of_view = false;
  };
  /// Where the map is to be looked for in a square: the middle of an empty view, and where nothing of the map
  /// is known, those of its squares, of their quarters and so on.
  std::optional<Look> lookFor(const RegionKey& key, const std::optional<RegionKey>& middle) const;
  void noteLook(RegionRow& row, const Look& look);

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
  Eigen::Vector2d aim_{0, 0};
  AnswerLimit limit_;
  std::optional<RegionKey> searched_;  // the square whose quarters are asked for
  int searches_left_ = kMostSearches, fine_looks_left_ = kMostFineLooks;
  bool cuts_ends_ = false;  // what is partly beyond the map is cut, not answered with nothing
  std::array<std::vector<double>, 4> ends_;  // where nothing came from beyond; by Side
  struct UnderWay {
    RegionAsk ask;
    std::uint64_t cut = 0;  // of which lattice
    bool told = false;      // that it is unwanted
  };
  std::map<std::uint64_t, UnderWay> under_way_;
  std::uint64_t last_id_ = 0, round_ = 1, views_ = 0, cuts_ = 0;
};

}  // namespace mapwright::regions
