#include "carry/rehearsal.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>

#include "align/plan_of.h"
#include "carry/areas.h"
#include "carry/carried.h"
#include "map/live_state.h"
#include "placing/ground.h"

namespace mapwright::carry {
namespace {

/// What is free for less between two stretches of one kind belongs to them.
constexpr double kJoin_m = 0.2;
/// Walls beyond the radius are looked for this far, which saves looking again at every step.
constexpr double kLookAhead_m = 0.5;

/// Of a long way so many are looked at together, which bounds the memory: 12 km in cells of 5 cm.
constexpr std::size_t kMostSamples = 1'000'000;

struct Sample {
  Eigen::Vector2d at{0, 0};  // on the new map
  Eigen::Vector2d old_at{0, 0};
  double along_m = 0, stamp_s = 0;
  bool recorded = false;  // rather than between two points
  Crossing what = Crossing::Free;
};

double stepOn(const render::PlacedGrid& map) {
  const double quarter = map.reference.resolution_m / 4;
  return std::isfinite(quarter) ? std::clamp(quarter, 0.005, 0.05) : 0.05;
}

bool isWay(const WayPoint& from, const WayPoint& to) {
  return from.piece == to.piece &&
         map::isWayKnown({from.position_m, from.stamp_s}, {to.position_m, to.stamp_s});
}

bool isUsable(const WayPoint& point) { return point.position_m.allFinite() && std::isfinite(point.stamp_s); }

/// A map that got another name on the way is still the same.
std::vector<WayPoint> renumbered(std::vector<WayPoint> way, const std::vector<map::MapIdentity>& maps) {
  std::map<std::string, std::size_t> first;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (!maps[i].uid.empty()) first.try_emplace(maps[i].uid, i);
  }
  for (WayPoint& point : way) {
    if (point.map < maps.size() && !maps[point.map].uid.empty()) point.map = first[maps[point.map].uid];
  }
  return way;
}

/// Of `parts`, the one whose way lies on free ground of `driven_on`.
std::size_t byGround(const std::vector<WayPoint>& way, const std::set<std::size_t>& parts,
                     const render::PlacedGrid& driven_on) {
  struct Share {
    std::size_t points = 0, free = 0;
    double free_share() const { return double(free) / double(points); }
  };
  std::map<std::size_t, Share> shares;
  placing::Ground ground = groundOf(driven_on);
  for (const WayPoint& point : way) {
    if (!parts.contains(point.map) || !isUsable(point)) continue;
    Share& share = shares[point.map];
    ++share.points;
    share.free += ground.at(point.position_m) == placing::Cell::Free;
  }
  const auto best = std::max_element(shares.begin(), shares.end(), [](const auto& a, const auto& b) {
    return a.second.free_share() < b.second.free_share();
  });
  return best == shares.end() ? *parts.begin() : best->first;
}

struct ChosenPart {
  std::size_t map = 0;
  Rehearsed::Part how = Rehearsed::Part::Only;
  bool of_another = false;
};

/// Which of the maps that the robot was on counts.
ChosenPart choosePart(const std::vector<WayPoint>& way, const std::vector<map::MapIdentity>& maps,
                      const RehearsalOptions& options, const render::PlacedGrid& driven_on) {
  std::set<std::size_t> parts;
  for (const WayPoint& point : way) parts.insert(point.map);
  if (parts.empty()) return {};
  const auto called = [&](std::size_t part) { return part < maps.size() ? maps[part] : map::MapIdentity(); };
  std::set<std::size_t> same;
  for (const std::size_t part : parts) {
    if (called(part).isSame(options.driven_on)) same.insert(part);
  }
  // By its name alone it may be several: that is not known then.
  const bool one = same.size() == 1;
  const bool of_another = same.empty() && std::all_of(parts.begin(), parts.end(), [&](std::size_t part) {
                            return called(part).comparable(options.driven_on);
                          });
  if (parts.size() == 1) return {*parts.begin(), Rehearsed::Part::Only, of_another};
  return {one ? *same.begin() : byGround(way, same.empty() ? parts : same, driven_on),
          one ? Rehearsed::Part::Recorded : Rehearsed::Part::ByGround, of_another};
}

/// Walks along a piece and says what is there.
class Feet {
 public:
  Feet(const render::PlacedGrid& new_map, const RehearsalOptions& options)
      : ground_(groundOf(new_map)), radius_m_(std::max(options.radius_m, 0.0)) {
    if (options.old_map) old_ground_.emplace(groundOf(*options.old_map));
  }
  void look(std::vector<Sample>& piece) {
    double clear_until_m = -1;
    for (Sample& sample : piece) {
      const placing::Cell cell = ground_.at(sample.at);
      if (cell == placing::Cell::Occupied) {
        sample.what = Crossing::Obstacle;
      } else if (cell != placing::Cell::Free) {
        sample.what = cell == placing::Cell::Unknown ? Crossing::Unknown : Crossing::Outside;
      } else if (radius_m_ > 0 && sample.along_m >= clear_until_m) {
        const double wall_m = wallFrom(ground_, sample.at);
        if (wall_m < radius_m_) {
          if (isCloser(wall_m, sample)) sample.what = Crossing::TooClose;
        } else {
          clear_until_m = sample.along_m + wall_m - radius_m_;
        }
      }
    }
  }

 private:
  double wallFrom(placing::Ground& ground, const Eigen::Vector2d& at) const {
    const double reach = radius_m_ + kLookAhead_m;
    const auto wall = ground.nearestWall(at, reach);
    return wall ? wall->distance_m : reach;
  }
  bool isCloser(double wall_m, const Sample& sample) {
    return !old_ground_ || wall_m < wallFrom(*old_ground_, sample.old_at) - kCloser_m;
  }

  placing::Ground ground_;
  std::optional<placing::Ground> old_ground_;
  double radius_m_;
};

/// Where the robot is too close just before and after an obstacle: that is one crossing with it.
void widenObstacles(std::vector<Sample>& piece, double reach_m) {
  std::vector<double> obstacles_m;
  for (const Sample& sample : piece) {
    if (sample.what == Crossing::Obstacle) obstacles_m.push_back(sample.along_m);
  }
  auto next = obstacles_m.begin();
  for (Sample& sample : piece) {
    while (next != obstacles_m.end() && *next < sample.along_m) ++next;
    const bool before = next != obstacles_m.end() && *next - sample.along_m <= reach_m;
    const bool after = next != obstacles_m.begin() && sample.along_m - *std::prev(next) <= reach_m;
    if (sample.what == Crossing::TooClose && (before || after)) sample.what = Crossing::Obstacle;
  }
}

/// Samples from `begin` to `end` that meet the same.
struct Run {
  std::size_t begin = 0, end = 0;
};
std::vector<Run> runsOf(const std::vector<Sample>& piece) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    if (i == 0 || piece[i].what != piece[i - 1].what) runs.push_back({i, i});
    runs.back().end = i + 1;
  }
  return runs;
}

void join(std::vector<Sample>& piece) {
  const std::vector<Run> runs = runsOf(piece);
  for (std::size_t i = 1; i + 1 < runs.size(); ++i) {
    const Crossing what = piece[runs[i - 1].begin].what;
    const double length_m = piece[runs[i + 1].begin].along_m - piece[runs[i].begin].along_m;
    if (piece[runs[i].begin].what != Crossing::Free || piece[runs[i + 1].begin].what != what) continue;
    if (length_m >= kJoin_m) continue;
    for (std::size_t at = runs[i].begin; at < runs[i].end; ++at) piece[at].what = what;
  }
}

Sample between(const Sample& from, const Sample& to, double share) {
  const auto mixed = [&](auto a, auto b) -> decltype(a) { return a + share * (b - a); };
  return {mixed(from.at, to.at), mixed(from.old_at, to.old_at), mixed(from.along_m, to.along_m),
          mixed(from.stamp_s, to.stamp_s)};
}

/// A stretch begins and ends half way between two samples.
Stretch stretchOf(const std::vector<Sample>& piece, const Run& run) {
  std::vector<Sample> corners;
  if (run.begin > 0) corners.push_back(between(piece[run.begin - 1], piece[run.begin], 0.5));
  for (std::size_t i = run.begin; i < run.end; ++i) {
    if (piece[i].recorded) corners.push_back(piece[i]);
  }
  if (run.end < piece.size()) corners.push_back(between(piece[run.end - 1], piece[run.end], 0.5));
  const Sample &first = corners.front(), &last = corners.back();
  Stretch stretch{piece[run.begin].what, first.stamp_s, last.stamp_s, last.along_m - first.along_m};
  const double half_m = (first.along_m + last.along_m) / 2;
  stretch.middle_m = first.at;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i == 0 || corners[i].at != stretch.line.back()) stretch.line.push_back(corners[i].at);
    if (i == 0 || corners[i - 1].along_m > half_m || corners[i].along_m < half_m) continue;
    const double side_m = corners[i].along_m - corners[i - 1].along_m;
    if (side_m > 0)
      stretch.middle_m = between(corners[i - 1], corners[i], (half_m - corners[i - 1].along_m) / side_m).at;
  }
  return stretch;
}

/// What follows it at once.
void append(Stretch& stretch, const Stretch& next) {
  if (next.length_m > stretch.length_m) stretch.middle_m = next.middle_m;
  stretch.length_m += next.length_m;
  stretch.to_s = next.to_s;
  stretch.line.insert(stretch.line.end(), next.line.begin() + 1, next.line.end());
}

}  // namespace

const char* nameOf(Crossing crossing) {
  constexpr std::array<const char*, kCrossings> names{"free", "outside", "unknown", "too_close", "obstacle"};
  return names[std::size_t(crossing)];
}

std::vector<Stretch> Rehearsed::crossed() const {
  std::vector<Stretch> some;
  std::copy_if(stretches.begin(), stretches.end(), std::back_inserter(some),
               [](const Stretch& stretch) { return stretch.what != Crossing::Free; });
  std::stable_sort(some.begin(), some.end(),
                   [](const Stretch& a, const Stretch& b) { return a.length_m > b.length_m; });
  return some;
}

bool Rehearsed::free() const {
  return points > 0 && reach == Reach::Reached &&
         std::all_of(stretches.begin(), stretches.end(),
                     [](const Stretch& stretch) { return stretch.what == Crossing::Free; });
}

struct Rehearsal::Parts {
  render::PlacedGrid new_map;
  RehearsalOptions options;
  Areas areas;
};

Rehearsal::Rehearsal(const render::PlacedGrid& new_map, const RehearsalOptions& options)
    : parts_(std::make_unique<const Parts>(
          Parts{new_map, options,
                Areas(*align::planOf(new_map, align::cellsFor(new_map, new_map)), options.radius_m)})) {}
Rehearsal::~Rehearsal() = default;

Rehearsed Rehearsal::of(const std::vector<WayPoint>& recorded,
                        const std::vector<map::MapIdentity>& maps) const {
  Rehearsed out;
  Feet feet(parts_->new_map, parts_->options);
  const geometry::Pose2& transform = parts_->options.transform;
  const double step_m = stepOn(parts_->new_map);
  std::vector<Sample> piece;
  bool goes_on = false;  // from what was looked at before
  const auto finish = [&] {
    if (piece.empty()) return;
    feet.look(piece);
    // At an angle the robot is too close for longer; and the edge is between two samples.
    widenObstacles(piece, 2 * parts_->options.radius_m + step_m);
    join(piece);
    for (const Run& run : runsOf(piece)) {
      Stretch stretch = stretchOf(piece, run);
      out.lengths_m[std::size_t(stretch.what)] += stretch.length_m;
      if (run.begin == 0 && goes_on && out.stretches.back().what == stretch.what) {
        append(out.stretches.back(), stretch);
      } else {
        out.stretches.push_back(std::move(stretch));
      }
    }
    goes_on = false;
    out.length_m += piece.back().along_m;
    piece.clear();
  };
  const std::vector<WayPoint> way = renumbered(recorded, maps);
  const ChosenPart chosen =
      choosePart(way, maps, parts_->options, parts_->options.old_map.value_or(parts_->new_map));
  out.part = chosen.how;
  out.of_another = chosen.of_another;
  std::optional<WayPoint> before, elsewhere;
  for (const WayPoint& point : way) {
    if (!isUsable(point)) {
      ++out.unusable;
      continue;
    }
    if (point.map != chosen.map) {
      if (elsewhere && isWay(*elsewhere, point))
        out.elsewhere_m += (point.position_m - elsewhere->position_m).norm();
      elsewhere = point;
      continue;
    }
    const Sample sample{transform.apply(point.position_m), point.position_m, 0, point.stamp_s, true};
    if (before && !isWay(*before, point)) {
      finish();
      ++out.jumps;
    }
    if (piece.empty()) {
      piece.push_back(sample);
    } else {
      const Sample from = piece.back();
      Sample to = sample;
      to.along_m = from.along_m + (sample.at - from.at).norm();
      const int steps = std::max(1, int(std::ceil((to.along_m - from.along_m) / step_m)));
      for (int i = 1; i < steps; ++i) piece.push_back(between(from, to, double(i) / steps));
      piece.push_back(to);
    }
    if (piece.size() > kMostSamples) {
      finish();
      goes_on = true;
      piece.push_back(sample);
    }
    out.from_s = out.points == 0 ? point.stamp_s : std::min(out.from_s, point.stamp_s);
    out.to_s = out.points == 0 ? point.stamp_s : std::max(out.to_s, point.stamp_s);
    ++out.points;
    before = point;
  }
  finish();
  if (out.points == 0) return out;
  const int start = parts_->areas.at(out.stretches.front().line.front());
  const int end = parts_->areas.at(out.stretches.back().line.back());
  out.reach = start == 0     ? Rehearsed::Reach::NoStart
              : end == 0     ? Rehearsed::Reach::NoEnd
              : start != end ? Rehearsed::Reach::CutOff
                             : Rehearsed::Reach::Reached;
  return out;
}

}  // namespace mapwright::carry
