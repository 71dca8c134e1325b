#include "align/align.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <opencv2/core.hpp>

#include "align/bend.h"
#include "align/disputed.h"
#include "align/each.h"
#include "align/fit.h"
#include "align/furniture.h"
#include "align/held.h"
#include "align/sheet.h"
#include "align/turn_search.h"

namespace mapwright::align {
namespace {

using geometry::Pose2;

constexpr std::size_t kMiddlePlaces = 12;
constexpr Thoroughness kUsual{160, 80}, kMirrored{120, 40};
constexpr std::size_t kMiddlePoints = 800, kCandidatePoints = 2'500, kFinePoints = 8'000;
constexpr double kClose = 0.7;  // of the best score: another place agrees nearly as well

struct Ranked {
  Pose2 pose;
  Quality quality;
};

bool closeTo(const Eigen::Vector2d& at, const Pose2& a, const Pose2& b, double metres, double radians) {
  return (a.apply(at) - b.apply(at)).norm() < metres &&
         std::abs(geometry::normalizeAngle(a.yaw_rad - b.yaw_rad)) < radians;
}

/// Best first; what is close to a better one goes.
std::vector<Ranked> ranked(const Eigen::Vector2d& at, std::vector<Ranked> all, std::size_t most,
                           double metres, double radians) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Ranked& a, const Ranked& b) { return a.quality.score() > b.quality.score(); });
  std::vector<Ranked> out;
  for (const Ranked& one : all) {
    if (out.size() == most) break;
    if (std::none_of(out.begin(), out.end(), [&](const Ranked& better) {
          return closeTo(at, better.pose, one.pose, metres, radians);
        })) {
      out.push_back(one);
    }
  }
  return out;
}

WallDistances distancesOf(const Sheet& from, const Sheet& to, const Pose2& transform) {
  WallDistances out;
  std::vector<double> found;
  std::size_t within = 0;
  const Mover move(transform);
  for (const Eigen::Vector2d& p : from.walls()) {
    const auto distance = to.distanceAt(move(p));
    if (!distance) continue;
    found.push_back(distance->metres);
    within += distance->metres <= 0.10;
  }
  if (found.empty()) return out;
  std::sort(found.begin(), found.end());
  out.within_10cm = double(within) / double(found.size());
  out.median_m = found[found.size() / 2];
  out.p95_m = found[std::min(found.size() - 1, found.size() * 95 / 100)];
  out.max_m = found.back();
  out.seen_share = double(found.size()) / double(from.walls().size());
  return out;
}

double overlapOf(const Plan& old_map, const Plan& new_map, const Sheets& sheets, const Pose2& transform) {
  std::size_t known_old = 0, known_new = 0, both = 0;
  const Mover move(transform);
  for (const Ground cell : new_map.cells) known_new += cell != Ground::Unknown;
  for (int row = 0; row < old_map.height; ++row) {
    for (int column = 0; column < old_map.width; ++column) {
      if (old_map.at(column, row) == Ground::Unknown) continue;
      ++known_old;
      both += sheets.of_new.knownAt(move(old_map.centreOf(column, row)));
    }
  }
  const double old_area = double(known_old) * old_map.resolution_m * old_map.resolution_m;
  const double new_area = double(known_new) * new_map.resolution_m * new_map.resolution_m;
  const double smaller = std::min(old_area, new_area);
  return smaller > 0 ? std::min(1.0, double(both) * old_map.resolution_m * old_map.resolution_m / smaller)
                     : 0;
}

/// What brings the walls of a square to those of the other map.
struct Shift {
  Eigen::Vector2d by_m{0, 0};
  OffSquare square;
};

/// The worst of those that have a neighbour which is shifted alike; furniture that was moved has none.
std::optional<OffSquare> partOf(const std::map<std::pair<int, int>, Shift>& shifts) {
  constexpr double kAlike_m = 0.06;
  std::optional<OffSquare> worst;
  for (const auto& [at, one] : shifts) {
    const bool joined = std::any_of(shifts.begin(), shifts.end(), [&](const auto& entry) {
      const auto& [other_at, other] = entry;
      const int apart = std::max(std::abs(at.first - other_at.first), std::abs(at.second - other_at.second));
      return apart == 1 && (one.by_m - other.by_m).norm() < kAlike_m;
    });
    if (joined && (!worst || one.square.off_m > worst->off_m)) worst = one.square;
  }
  return worst;
}

void addSquares(const Sheets& sheets, const Pose2& transform, Agreement& agreement) {
  constexpr std::size_t kFewest = 10;  // cells of walls; fewer are a speck
  struct Square {
    std::size_t walls = 0;
    std::vector<double> distances;
  };
  std::map<std::pair<int, int>, Square> squares;
  const Mover move(transform);
  for (const Eigen::Vector2d& p : sheets.of_old.walls()) {
    const Eigen::Vector2d at = move(p);
    Square& square = squares[{int(std::floor(at.x() / kSquare_m)), int(std::floor(at.y() / kSquare_m))}];
    ++square.walls;
    if (const auto distance = sheets.of_new.distanceAt(at)) square.distances.push_back(distance->metres);
  }
  const Points alike = facedAlike(sheets, sheets.of_old.walls(), sheets.of_new.walls(), transform);
  const WallIndex old_walls(alike.of_old), new_walls(alike.of_new);
  const Pose2 back = transform.inverse();
  std::map<std::pair<int, int>, Shift> shifts;
  for (auto& [square, held] : squares) {
    std::vector<double>& distances = held.distances;
    // Of the others too little is known to tell.
    if (distances.size() < kFewest || 2 * distances.size() < held.walls) continue;
    ++agreement.squares;
    const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    const Eigen::Vector2d at = kSquare_m * Eigen::Vector2d(square.first + 0.5, square.second + 0.5);
    const Eigen::Vector2d old_m = back.apply(at);
    const auto fitted_there = fittedAround(sheets, old_walls, new_walls, transform, old_m);
    const Eigen::Vector2d shift =
        fitted_there ? Eigen::Vector2d(fitted_there->apply(old_m) - at) : Eigen::Vector2d(0, 0);
    const double shift_m = shift.norm();
    if (shift_m > kOff_m) shifts[square] = {shift, {at, distances.size(), shift_m}};
    if (const double off_m = std::max(*middle, shift_m); off_m > kOff_m)
      agreement.off.push_back({at, distances.size(), off_m});
  }
  std::stable_sort(agreement.off.begin(), agreement.off.end(),
                   [](const OffSquare& a, const OffSquare& b) { return a.off_m > b.off_m; });
  agreement.shifted = shifts.size();
  agreement.part = partOf(shifts);
}

Agreement agreementOn(const Plan& old_map, const Plan& new_map, const Sheets& sheets,
                      const Pose2& transform) {
  Agreement out;
  out.overlap = overlapOf(old_map, new_map, sheets, transform);
  out.forward = distancesOf(sheets.of_old, sheets.of_new, transform);
  out.backward = distancesOf(sheets.of_new, sheets.of_old, transform.inverse());
  addSquares(sheets, transform, out);
  return out;
}

/// The old map moved 0.5 to 4 m to any side, or along the motion that the walls hold least, a turn too: along
/// a corridor, or between round walls.
std::vector<Pose2> slid(const Sheets& sheets, const Points& points, const Pose2& pose) {
  std::vector<Pose2> out;
  const Motion weakest = weakestMotion(sheets, points, pose);
  for (const double by : {0.5, 1.0, 2.0, 4.0}) {
    for (int side = 0; side < 16; ++side) {
      const double towards = side * std::numbers::pi / 8;
      out.push_back(movedBy(pose, points, {{std::cos(towards), std::sin(towards)}, 0}, by));
    }
    for (const double way : {by, -by}) out.push_back(movedBy(pose, points, weakest, way));
  }
  return out;
}

/// Whether it fits about as well when it is slid along.
bool slides(const Sheets& sheets, const Points& points, const Ranked& best) {
  const Points fewer = pointsOf(sheets, kFinePoints / 4);
  const std::vector<Pose2> others = slid(sheets, fewer, best.pose);
  return std::any_of(others.begin(), others.end(), [&](const Pose2& other) {
    return qualityOf(sheets, fewer, other).score() > kClose * best.quality.score() &&
           !refutesSecond(disputedBetween(sheets, points, laid(best.pose), laid(other)));
  });
}

Plan mirroredPlan(const Plan& plan) {
  Plan out = plan;
  for (int row = 0; row < plan.height; ++row) {
    std::reverse(out.cells.begin() + std::ptrdiff_t(row) * plan.width,
                 out.cells.begin() + std::ptrdiff_t(row + 1) * plan.width);
  }
  return out;
}

/// From rough places to the best few at the resolution of the sheets.
std::vector<Ranked> searched(const Plan& old_map, const Plan& new_map, const Sheets& fine,
                             const Thoroughness& how, work::Tasks& tasks,
                             const std::function<bool(double)>& proceed) {
  const RoughSearch rough = roughPlaces(old_map, new_map, how, tasks, proceed);
  if (rough.places.empty()) return {};
  const double resolution = std::max(old_map.resolution_m, new_map.resolution_m);
  const int times = std::clamp(int(std::lround(rough.cell_m / 4 / resolution)), 1, 6);
  const Sheets middle{Sheet(coarser(old_map, times)), Sheet(coarser(new_map, times))};
  const Points points = pointsOf(middle, kMiddlePoints);
  std::vector<Ranked> found(rough.places.size());
  each(tasks, int(found.size()), [&](int i) {
    const double cell = rough.cell_m;
    const Pose2 pose = fitted(middle, points, rough.places[std::size_t(i)].transform,
                              {std::max(1.0, 2 * cell), std::max(0.5, cell), std::max(0.4, cell / 2)});
    found[std::size_t(i)] = {pose, qualityOf(middle, points, pose)};
  });
  found = ranked(points.middle, std::move(found), kMiddlePlaces, 0.3, 0.05);
  const Points exact = pointsOf(fine, kCandidatePoints);
  each(tasks, int(found.size()), [&](int i) {
    Ranked& one = found[std::size_t(i)];
    one.pose = fitted(fine, exact, one.pose, {1.0, 0.5, 0.25});
    one.quality = qualityOf(fine, exact, one.pose);
  });
  found = ranked(exact.middle, std::move(found), kMiddlePlaces, 0.3, 0.05);
  const Points all = pointsOf(fine, kFinePoints);
  each(tasks, std::min(2, int(found.size())), [&](int i) {
    Ranked& one = found[std::size_t(i)];
    one.pose = fitted(fine, all, one.pose, {0.25});
    one.quality = qualityOf(fine, all, one.pose);
  });
  return ranked(all.middle, std::move(found), kMiddlePlaces, 0.3, 0.05);
}

/// The candidates, and others with their headings that bring the pair together exactly: those that do so
/// within kPair_m, best first.
std::vector<Ranked> throughPair(const Sheets& fine, std::vector<Ranked> found,
                                const placing::PointPair& pair) {
  constexpr double kPair_m = 0.5;
  const Points points = pointsOf(fine, kFinePoints);
  const std::size_t candidates = found.size();
  for (std::size_t i = 0; i < candidates; ++i) {
    const Pose2 pose = fitted(fine, points, placing::alignedBy({pair}, found[i].pose), {0.5, 0.25});
    found.push_back({pose, qualityOf(fine, points, pose)});
  }
  std::erase_if(found, [&](const Ranked& one) {
    return (one.pose.apply(pair.on_map_m) - pair.in_world_m).norm() > kPair_m;
  });
  return ranked(points.middle, std::move(found), kMiddlePlaces, 0.3, 0.05);
}

/// What is left at each pair; of three and more when the others decide.
std::vector<double> leftAt(const std::vector<placing::PointPair>& pairs, const Pose2& transform) {
  if (pairs.size() < 3) return placing::residualsOf(pairs, transform);
  std::vector<double> left;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::vector<placing::PointPair> others = pairs;
    others.erase(others.begin() + std::ptrdiff_t(i));
    left.push_back(placing::residualsOf({pairs[i]}, placing::alignedBy(others, transform)).front());
  }
  return left;
}

/// The largest distance between two of the points, on the map where it is smaller.
double spreadOf(const std::vector<placing::PointPair>& pairs) {
  double on_map = 0, in_world = 0;
  for (const placing::PointPair& a : pairs) {
    for (const placing::PointPair& b : pairs) {
      on_map = std::max(on_map, (a.on_map_m - b.on_map_m).norm());
      in_world = std::max(in_world, (a.in_world_m - b.in_world_m).norm());
    }
  }
  return std::min(on_map, in_world);
}

Alignment alignedByPairs(const Plan& old_map, const Plan& new_map,
                         const std::vector<placing::PointPair>& pairs) {
  constexpr double kDisagree_m = 0.25, kSpread_m = 2, kAgainst = 0.15, kComparable = 0.1;
  Alignment out;
  const Sheets sheets{Sheet(old_map), Sheet(new_map)};
  const Pose2 transform = placing::alignedBy(pairs, {});
  const Quality quality = qualityOf(sheets, pointsOf(sheets, kFinePoints), transform);
  out.best = Candidate{transform, quality.score()};
  out.agreement = agreementOn(old_map, new_map, sheets, transform);
  out.pair_residuals_m = leftAt(pairs, transform);
  const std::vector<double> plain = placing::residualsOf(pairs, transform);
  out.doubt = spreadOf(pairs) < kSpread_m                                   ? Doubt::PairsTooClose
              : *std::max_element(plain.begin(), plain.end()) > kDisagree_m ? Doubt::PairsDisagree
              : out.agreement.overlap >= kComparable && quality.agreement < kAgainst
                  ? Doubt::PairsAgainstWalls
                  : Doubt::None;
  return out;
}

Plan prepared(const Plan& plan) { return trimmed(seenOnly(plan, Sheet::kReach_m)); }

bool hasWalls(const Plan& plan) {
  return std::find(plan.cells.begin(), plan.cells.end(), Ground::Wall) != plan.cells.end();
}

/// Another place that agrees as well, unless it is refuted by walls that only the best one explains.
bool ambiguous(const Sheets& sheets, const Points& points, const std::vector<Ranked>& found) {
  constexpr double kLess = 0.6;  // where the maps overlap less, but what they share fits better
  const Ranked& best = found.front();
  const double score = best.quality.score();
  return std::any_of(found.begin() + 1, found.end(), [&](const Ranked& other) {
    const double others = other.quality.score();
    const bool as_good = others > kClose * score ||
                         (others > kLess * score && other.quality.agreement > best.quality.agreement);
    return as_good && !refutesSecond(disputedBetween(sheets, points, laid(best.pose), laid(other.pose)));
  });
}

/// Much better when the new map is mirrored; or in a building that is nearly its own mirror image, better
/// where the two differ.
bool mirroredFitsBetter(const Plan& new_map, const Sheets& sheets, const Points& points, const Ranked& best,
                        const std::optional<Ranked>& mirrored) {
  constexpr double kBetter = 0.05, kAsGood = 0.85, kDisputed_m = 2;
  if (!mirrored) return false;
  const double score = best.quality.score(), other = mirrored->quality.score();
  if (other > score + kBetter) return true;
  if (other <= kAsGood * score) return false;
  const double twice_axis_m = 2 * new_map.corner_m.x() + new_map.width * new_map.resolution_m;
  const Disputed disputed =
      disputedBetween(sheets, points, laid(best.pose), laidMirrored(mirrored->pose, twice_axis_m));
  return disputed.for_second_m > std::max(kDisputed_m, disputed.for_first_m);
}

bool bent(const Agreement& agreement, const Bend& bend, double cell_m) {
  constexpr double kShifted = 0.15;
  const double shifted = double(agreement.shifted) / double(std::max<std::size_t>(agreement.squares, 1));
  // Coarse cells, fewer too, are bent a little by furniture alone.
  const double coarse = std::max(1.0, cell_m / 0.05), least_m = 0.035 * coarse,
               gain = 0.007 * coarse * coarse;
  // Two places alone are furniture unless they belong together.
  const bool several = agreement.shifted > 2 || agreement.part.has_value();
  return (several && shifted > kShifted) || (bend.off_m > least_m && bend.gain > gain);
}

/// The best and the second best of `found`, and what speaks against the best.
void judge(Alignment& out, const Plan& old_map, const Plan& new_map, const Sheets& fine,
           std::vector<Ranked> found, const std::optional<Ranked>& mirrored, bool by_pair) {
  constexpr double kGood = 0.4, kOverlap = 0.2, kSeen = 0.25;
  if (found.empty() || !(found[0].quality.score() > 0)) return;
  const Points points = pointsOf(fine, kFinePoints);
  Ranked& best = found.front();
  best.pose = sharpened(fine, points, best.pose);
  const double score = best.quality.score();
  out.best = Candidate{best.pose, score};
  if (found.size() > 1) out.second = Candidate{found[1].pose, found[1].quality.score()};
  out.agreement = agreementOn(old_map, new_map, fine, best.pose);
  if (!by_pair) out.furniture = furnitureOf(old_map, new_map, best.pose);
  const double cell_m = std::max(old_map.resolution_m, new_map.resolution_m);
  out.doubt = out.agreement.overlap < kOverlap || best.quality.seen < kSeen           ? Doubt::LittleSeen
              : !by_pair && mirroredFitsBetter(new_map, fine, points, best, mirrored) ? Doubt::Mirrored
              : score < kGood                                                         ? Doubt::Poor
              : ambiguous(fine, points, found)                                        ? Doubt::Ambiguous
              : !by_pair && slides(fine, points, best)                                ? Doubt::Slides
              : bent(out.agreement, bendOf(fine, points, best.pose), cell_m)          ? Doubt::Bent
              : !heldByWalls(fine, points, best.pose)                                 ? Doubt::Loose
              : out.furniture.allDiffers()                                            ? Doubt::OtherFloor
                                                                                      : Doubt::None;
}

}  // namespace

std::optional<Alignment> alignPlans(const Plan& old_full, const Plan& new_full, const Options& options) {
  cv::setNumThreads(1);  // the program's own pool keeps the processors busy
  bool cancelled = false;
  const auto step = [&](double from, double to) {
    return [&, from, to](double done) {
      if (options.proceed && !options.proceed(from + (to - from) * done)) cancelled = true;
      return !cancelled;
    };
  };
  const Plan old_map = prepared(old_full), new_map = prepared(new_full);
  if (options.pairs.size() > 1) return alignedByPairs(old_map, new_map, options.pairs);
  Alignment out;
  if (!hasWalls(old_map) || !hasWalls(new_map)) {
    out.doubt = Doubt::NoWalls;
    return out;
  }
  work::Tasks tasks(work::orOwn(options.workers));
  const Sheets fine{Sheet(old_map), Sheet(new_map)};
  std::vector<Ranked> found = searched(old_map, new_map, fine, kUsual, tasks, step(0, 0.6));
  if (cancelled) return std::nullopt;
  const bool by_pair = options.pairs.size() == 1;
  if (by_pair) found = throughPair(fine, std::move(found), options.pairs.front());
  std::optional<Ranked> mirrored;
  if (!found.empty()) {
    const Plan mirror = mirroredPlan(new_map);
    const std::vector<Ranked> others =
        searched(old_map, mirror, Sheets{Sheet(old_map), Sheet(mirror)}, kMirrored, tasks, step(0.6, 0.95));
    if (cancelled) return std::nullopt;
    if (!others.empty()) mirrored = others.front();
  }
  judge(out, old_map, new_map, fine, std::move(found), mirrored, by_pair);
  if (by_pair && out.best) out.pair_residuals_m = leftAt(options.pairs, out.best->transform);
  if (!step(0.95, 1)(1.0)) return std::nullopt;
  return out;
}

Agreement agreementOf(const Plan& old_full, const Plan& new_full, const Pose2& transform) {
  const Plan old_map = prepared(old_full), new_map = prepared(new_full);
  return agreementOn(old_map, new_map, Sheets{Sheet(old_map), Sheet(new_map)}, transform);
}

}  // namespace mapwright::align
