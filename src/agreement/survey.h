// Where all submaps of a session contradict each other, and how many saw each cell: kept tile by tile, so
// that only what changed is looked at again.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>
#include <vector>

#include "agreement/tile.h"
#include "fault/fault.h"
#include "work/workers.h"

namespace mapwright::agreement {

/// Made tiles in which a submap saw anything.
using Tiles = std::map<TileKey, std::shared_ptr<const Tile>>;

/// Tiles side by side, the last ones included.
struct TileRange {
  TileKey first, last;
  double count() const {
    return (double(last.column) - first.column + 1) * (double(last.row) - first.row + 1);
  }
  template <typename Visit>
  void each(Visit visit) const {
    for (std::int32_t row = first.row; row <= last.row; ++row) {
      for (std::int32_t column = first.column; column <= last.column; ++column) visit(TileKey{column, row});
    }
  }
};

/// A square of 1 m where submaps contradict each other.
struct Place {
  double x = 0, y = 0;        // its centre, metres in the world
  std::uint64_t cells = 0;    // that contradict
  std::vector<Part> submaps;  // that disagree there: in most of those cells first, then by id
};
std::vector<map::SubmapId> idsOf(std::span<const Part> submaps);

struct Disagreement {
  double cell_m = 0;
  int tolerance_cells = 0;
  std::uint64_t occupied_cells = 0;      // lattice cells that some submap holds occupied
  std::uint64_t contradicted_cells = 0;  // those of them that another one contradicts
  std::vector<Place> places;             // the worst: most cells first, then by y, x
  std::size_t all_places = 0;            // with those that are left out of `places`
  Tiles tiles;

  /// contradicted / occupied, 0..1; 0 if nothing is occupied.
  double share() const {
    return occupied_cells == 0 ? 0 : double(contradicted_cells) / double(occupied_cells);
  }
};

inline constexpr std::size_t kAllPlaces = std::numeric_limits<std::size_t>::max();
/// What `tiles` say, made by `rules`: at most `most_places` places. Pure, any thread; besides the result it
/// takes 48 bytes for each square of a tile, 2.8 million at most.
Disagreement disagreementOf(Tiles tiles, const Rules& rules, std::size_t most_places = kAllPlaces);

struct Coverage {
  double cell_m = 0;
  std::uint64_t seen_cells = 0;  // by one submap or more
  /// [n] = cells that n submaps saw; [Tile::kManySubmaps] = that so many or more saw; [0] = 0.
  std::array<std::uint64_t, Tile::kManySubmaps + 1> cells_seen_by{};
  Tiles tiles;

  std::uint64_t seenOnce() const { return cells_seen_by[1]; }
  int most() const;  // submaps that saw one cell, at most kManySubmaps
};

/// A square of 1 m with a cell that a submap saw.
struct SeenPlace {
  double x = 0, y = 0;  // its centre, metres in the world
  std::uint64_t seen_cells = 0, seen_once = 0;
};
/// Most cells that were seen once first, then by y, x.
std::vector<SeenPlace> seenPlaces(const Coverage& coverage);

/// Pure state, one thread: take() gives out work for any thread, put() takes the result.
class Survey {
 public:
  /// More tiles than this are refused: all of them, seen everywhere, would take 1.3 GB.
  static constexpr std::size_t kMostTiles = 16'384;

  /// Preconditions: see Rules.
  explicit Survey(Rules rules = {});
  const Rules& rules() const { return rules_; }

  /// All submaps of now, each id once. The tiles under what differs from before (texture or pose; old and new
  /// place) have to be made again; the others stay. If it is refused, nothing has changed.
  std::optional<Fault> setSubmaps(std::span<const render::PlacedTexture> submaps);
  /// Submaps whose pose is not finite or farther than 10,000 km away: they are left out.
  const std::vector<map::SubmapId>& unplaceable() const { return unplaceable_; }

  /// Touched by a submap; those that are not made yet, or given out.
  std::size_t tiles() const { return near_.size(); }
  std::size_t stale() const { return stale_.size() + given_out_; }
  bool complete() const { return stale() == 0; }
  /// The next tile to make; nullopt = all are made or given out. Neighbours follow each other.
  std::optional<TileTask> take();
  /// The result of a task; null = it was cancelled, and the tile is stale again. Ignored if submaps there
  /// have changed since take(). True if the tile was taken over.
  bool put(const TileTask& task, std::shared_ptr<const Tile> tile);

  /// Makes all stale tiles on `workers` and waits. `proceed` gets the numbers of tiles made and of all that
  /// were stale, several times a second on this thread; false cancels, and false is returned. Not on a thread
  /// of the pool.
  bool makeAll(const std::shared_ptr<work::Workers>& workers, render::DenseCache& cache,
               const std::function<bool(std::size_t made, std::size_t all)>& proceed = {});

  /// What the tiles made so far say.
  Disagreement disagreement() const { return disagreementOf(made_, rules_); }
  Coverage coverage() const;
  const Tiles& made() const { return made_; }

 private:
  struct Known {
    render::PlacedTexture placed;
    TileRange touches;
  };
  /// Sorted so that neighbours follow each other.
  struct InStrips {
    bool operator()(TileKey a, TileKey b) const;
  };

  Rules rules_;
  std::unordered_map<map::SubmapId, Known> submaps_;
  std::vector<map::SubmapId> unplaceable_;
  std::map<TileKey, std::set<map::SubmapId>> near_;  // none of them empty
  double touched_ = 0;                               // how many ids near_ holds
  std::set<TileKey, InStrips> stale_;
  std::map<TileKey, std::uint64_t> generation_;  // of the tiles given out
  std::size_t given_out_ = 0;
  std::uint64_t next_generation_ = 1;
  Tiles made_;
};

}  // namespace mapwright::agreement
