#include "align/align.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <opencv2/core.hpp>

#include "align/each.h"
#include "align/fit.h"
#include "align/sheet.h"
#include "align/turn_search.h"

namespace mapwright::align {
namespace {

using geometry::Pose2;

constexpr std::size_t kMiddlePlaces = 12;
constexpr Thoroughness kUsual{160, 80}, kMirrored{120, 40};
constexpr std::size_t kMiddlePoints = 800, kCandidatePoints = 2'500, kFinePoints = 8'000;
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
  const WallIndex old_walls(sheets.of_old.walls()), new_walls(sheets.of_new.walls());
  const Pose2 back = transform.inverse();
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
    const double shift_m = fitted_there ? (fitted_there->apply(old_m) - at).norm() : 0;
    agreement.shifted += shift_m > kOff_m;
    if (const double off_m = std::max(*middle, shift_m); off_m > kOff_m)
      agreement.off.push_back({at, distances.size(), off_m});
  }
  std::stable_sort(agreement.off.begin(), agreement.off.end(),
                   [](const OffSquare& a, const OffSquare& b) { return a.off_m > b.off_m; });
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

/// The best agreement with the old map moved 0.5 to 4 m to any side, or along the motion that the walls hold
/// least, a turn too: high along a corridor, and between round walls.
double slidScore(const Sheets& sheets, const Points& points, const Pose2& pose) {
  double best = 0;
  const Motion weakest = weakestMotion(sheets, points, pose);
  for (const double by : {0.5, 1.0, 2.0, 4.0}) {
    for (int side = 0; side < 16; ++side) {
      const double towards = side * std::numbers::pi / 8;
      const Motion motion{{std::cos(towards), std::sin(towards)}, 0};
      best = std::max(best, qualityOf(sheets, points, movedBy(pose, points, motion, by)).score());
    }
    for (const double way : {by, -by})
      best = std::max(best, qualityOf(sheets, points, movedBy(pose, points, weakest, way)).score());
  }
  return best;
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

/// The best and the second best of `found`, and what speaks against the best.
void judge(Alignment& out, const Plan& old_map, const Plan& new_map, const Sheets& fine,
           const std::vector<Ranked>& found, double mirrored, bool by_pair) {
  constexpr double kGood = 0.4, kClose = 0.7, kOverlap = 0.2, kSeen = 0.25, kMirrored = 0.05, kBent = 0.15;
  if (found.empty() || !(found[0].quality.score() > 0)) return;
  const double score = found[0].quality.score(), second = found.size() > 1 ? found[1].quality.score() : 0;
  out.best = Candidate{found[0].pose, score};
  if (found.size() > 1) out.second = Candidate{found[1].pose, second};
  out.agreement = agreementOn(old_map, new_map, fine, found[0].pose);
  const bool slides =
      !by_pair && slidScore(fine, pointsOf(fine, kFinePoints / 4), found[0].pose) > kClose * score;
  const double bent = double(out.agreement.shifted) / double(std::max<std::size_t>(out.agreement.squares, 1));
  out.doubt = out.agreement.overlap < kOverlap || found[0].quality.seen < kSeen ? Doubt::LittleSeen
              : !by_pair && mirrored > score + kMirrored                        ? Doubt::Mirrored
              : score < kGood                                                   ? Doubt::Poor
              : second > kClose * score                                         ? Doubt::Ambiguous
              : slides                                                          ? Doubt::Slides
              : out.agreement.shifted > 1 && bent > kBent                       ? Doubt::Bent
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
  double mirrored = 0;
  if (!found.empty()) {
    const Plan mirror = mirroredPlan(new_map);
    const std::vector<Ranked> others =
        searched(old_map, mirror, Sheets{Sheet(old_map), Sheet(mirror)}, kMirrored, tasks, step(0.6, 0.95));
    if (cancelled) return std::nullopt;
    if (!others.empty()) mirrored = others[0].quality.score();
  }
  judge(out, old_map, new_map, fine, found, mirrored, by_pair);
  if (by_pair && out.best) out.pair_residuals_m = leftAt(options.pairs, out.best->transform);
  if (!step(0.95, 1)(1.0)) return std::nullopt;
  return out;
}

Agreement agreementOf(const Plan& old_full, const Plan& new_full, const Pose2& transform) {
  const Plan old_map = prepared(old_full), new_map = prepared(new_full);
  return agreementOn(old_map, new_map, Sheets{Sheet(old_map), Sheet(new_map)}, transform);
}

}  // namespace mapwright::align
