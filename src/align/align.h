// Where the same site lies in two maps of it: candidates, how well each agrees, and whether one of them is
// right beyond doubt. World metres, radians counter-clockwise. Why these rules:
// docs/tasks/new-map.md.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "align/plan.h"
#include "geometry/pose.h"
#include "placing/align.h"
#include "work/workers.h"

namespace mapwright::align {

/// How far the walls of one map lie from walls of the other. Only walls where the other map knows something.
struct WallDistances {
  double within_10cm = 0;  // share of them with a wall within 10 cm, 0..1
  double median_m = 0, p95_m = 0, max_m = 0;
  double seen_share = 0;  // of all walls of the first map: how much of them the other one can answer for
  bool operator==(const WallDistances&) const = default;
};

/// `transform` carries a point of the old map to the new one: p' = R(yaw) p + (x, y).
struct Candidate {
  geometry::Pose2 transform;
  double score = 0;  // 0..1: agreement of the walls, both ways, times how much of them could be compared
  bool operator==(const Candidate&) const = default;
};

/// A square of kSquare_m of the new map where walls of the old one are off: something was moved there, or one
/// of the maps is bent.
struct OffSquare {
  Eigen::Vector2d middle_m{0, 0};
  std::size_t walls = 0;  // cells of the old map's walls
  double off_m = 0;       // how far: the median to the nearest wall, or what the best fit there moves
  bool operator==(const OffSquare&) const = default;
};
inline constexpr double kSquare_m = 3.0;
/// Squares whose walls are off by less agree.
inline constexpr double kOff_m = 0.10;

struct Agreement {
  double overlap = 0;     // known cells that both know, as a share of those of the smaller map
  WallDistances forward;  // walls of the old map
  WallDistances backward;
  std::size_t squares = 0;     // with walls of the old map that can be compared
  std::vector<OffSquare> off;  // those of them that are off by more than kOff_m, the worst first
  std::size_t shifted = 0;     // those whose walls fit elsewhere nearby: a bent map has many
  /// The worst of neighbours that are shifted alike: a part of the building lies beside.
  std::optional<OffSquare> part;
  bool operator==(const Agreement&) const = default;
};

/// Why nothing is chosen.
enum class Doubt {
  None,
  NoWalls,            // a map without walls
  NoOverlap,          // nothing fits at all
  Poor,               // the best one agrees badly
  Bent,               // in many places the walls fit a little beside
  LittleSeen,         // too little of the maps lies in both
  Ambiguous,          // another one is about as good
  Loose,              // what both maps show does not hold it to 5 cm and 0.3 degrees
  OtherFloor,         // the walls agree, and as good as no piece of furniture
  Slides,             // it can be moved along a corridor and fits as well
  Mirrored,           // it fits better when one map is mirrored
  PairsDisagree,      // points by hand that no rigid transform brings together
  PairsTooClose,      // they do not fix the turn
  PairsAgainstWalls,  // with them the walls agree no better than by chance
};

/// Pieces that stand free, of both maps, where the other one saw the place; `again`: those that are there,
/// too.
struct Furniture {
  std::size_t pieces = 0, again = 0;
  /// There are many, and as good as none is there again.
  bool allDiffers() const;
  /// Some can be compared, and most are not there again.
  bool mostDiffers() const;
  bool operator==(const Furniture&) const = default;
};

struct Alignment {
  std::optional<Candidate> best, second;
  Agreement agreement;  // of the best
  Furniture furniture;  // at the best; none where a pair by hand decides
  Doubt doubt = Doubt::NoOverlap;
  /// Of each pair by hand, metres: for three and more what is left when the others decide.
  std::vector<double> pair_residuals_m;
  bool sure() const { return doubt == Doubt::None; }
  bool operator==(const Alignment&) const = default;
};

struct Options {
  /// None: by the walls alone. One decides between candidates. Two or more decide alone.
  std::vector<placing::PointPair> pairs = {};
  std::shared_ptr<work::Workers> workers = {};    // null: a pool of its own
  std::function<bool(double done)> proceed = {};  // 0..1, on the caller's thread; false cancels
};

/// Blocks; not on a thread of the pool. nullopt: cancelled. Takes about 40 bytes for each cell of both plans.
std::optional<Alignment> alignPlans(const Plan& old_map, const Plan& new_map, const Options& options = {});

/// How well a transform agrees.
Agreement agreementOf(const Plan& old_map, const Plan& new_map, const geometry::Pose2& transform);

}  // namespace mapwright::align
