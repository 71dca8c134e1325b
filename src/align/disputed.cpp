#include "align/disputed.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace mapwright::align {
namespace {

using geometry::Pose2;

/// Between the two nothing is said: walls are as thick as cells, and maps a little bent.
constexpr double kAgrees_m = 0.12, kContradicts_m = 0.25;
constexpr double kPatch_m = 1.0;  // side of the squares in which walls are counted
constexpr double kSpeck_m = 0.4;  // less wall in a square is one

enum class Verdict { Unclear, Agrees, Contradicts };

Verdict verdictAt(const Sheet& sheet, const Eigen::Vector2d& at) {
  const auto distance = sheet.distanceAt(at);
  if (!distance) return Verdict::Unclear;
  if (distance->metres <= std::max(kAgrees_m, sheet.resolution())) return Verdict::Agrees;
  return distance->metres >= kContradicts_m && sheet.knownAt(at) ? Verdict::Contradicts : Verdict::Unclear;
}

/// Metres of wall by squares.
class Patches {
 public:
  void add(const Eigen::Vector2d& at, double wall_m) {
    patches_[{int(std::floor(at.x() / kPatch_m)), int(std::floor(at.y() / kPatch_m))}] += wall_m;
  }
  double metres() const { return metresBeyond(-1); }
  /// Farther than that from the square with most of it.
  double metresBeyond(double reach_m) const {
    const auto most = std::max_element(patches_.begin(), patches_.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    double sum = 0;
    for (const auto& [square, wall_m] : patches_) {
      const double apart_m =
          kPatch_m * std::hypot(square.first - most->first.first, square.second - most->first.second);
      if (wall_m >= kSpeck_m && apart_m > reach_m) sum += wall_m;
    }
    return sum;
  }

 private:
  std::map<std::pair<int, int>, double> patches_;
};

/// What speaks for the first place less what speaks for the second, by things as large as a rack or a bed.
class Balance {
 public:
  void add(const Eigen::Vector2d& at, double wall_m) {
    things_[{int(std::floor(at.x() / kThing_m)), int(std::floor(at.y() / kThing_m))}] += wall_m;
  }
  /// The sum, in standard deviations of a sum of the same things with signs by chance.
  double sigmas() const {
    double sum = 0, square = 0;
    for (const auto& [at, wall_m] : things_) sum += wall_m, square += wall_m * wall_m;
    return square > 0 ? sum / std::sqrt(square) : 0;
  }

 private:
  static constexpr double kThing_m = 3.0;
  std::map<std::pair<int, int>, double> things_;
};

struct Counted {
  Patches for_first, for_second;
};

/// `balance` is kept in the new map.
Counted counted(const Sheet& from, const Sheet& to, const std::vector<Eigen::Vector2d>& walls,
                const Mover& first, const Mover& second, const Mover& to_new, Balance& balance) {
  Counted out;
  const double wall_m =
      from.resolution() * double(from.walls().size()) / double(std::max<std::size_t>(walls.size(), 1));
  for (const Eigen::Vector2d& wall : walls) {
    const Verdict one = verdictAt(to, first(wall)), other = verdictAt(to, second(wall));
    if (one == Verdict::Agrees && other == Verdict::Contradicts) {
      out.for_first.add(wall, wall_m);
      balance.add(to_new(wall), wall_m);
    }
    if (one == Verdict::Contradicts && other == Verdict::Agrees) {
      out.for_second.add(wall, wall_m);
      balance.add(to_new(wall), -wall_m);
    }
  }
  return out;
}

}  // namespace

Laid laid(const Pose2& pose) { return {Mover(pose), Mover(pose.inverse())}; }

Laid laidMirrored(const Pose2& pose, double twice_axis_m) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(pose.yaw_rad).toRotationMatrix();
  const Eigen::Matrix2d flip = Eigen::Vector2d(-1, 1).asDiagonal();
  const Eigen::Vector2d by(twice_axis_m - pose.x_m, pose.y_m);
  const Eigen::Matrix2d there = flip * turn, back = there.transpose();
  return {Mover(there, by), Mover(back, -(back * by))};
}

Disputed disputedBetween(const Sheets& sheets, const Points& points, const Laid& first, const Laid& second) {
  Balance balance;
  const Counted forward =
      counted(sheets.of_old, sheets.of_new, points.of_old, first.there, second.there, first.there, balance);
  const Counted backward = counted(sheets.of_new, sheets.of_old, points.of_new, first.back, second.back,
                                   Mover(geometry::Pose2{}), balance);
  // A wall of both maps is disputed on both: it counts once.
  const bool forwards = forward.for_first.metres() >= backward.for_first.metres();
  const Patches& for_first = forwards ? forward.for_first : backward.for_first;
  return {for_first.metres(), std::max(forward.for_second.metres(), backward.for_second.metres()),
          for_first.metresBeyond(2.5), balance.sigmas()};
}

bool refutesSecond(const Disputed& disputed) {
  constexpr double kEnough_m = 4, kElsewhere_m = 1, kAgainst = 0.25;
  // Goods that changed between racks or beds that are alike speak for some wrong place by chance. Long walls,
  // or many things in many places, outweigh them.
  constexpr double kLong_m = 20, kAgainstLong = 0.4, kSigmas = 2.5;
  const double against = disputed.for_first_m >= kLong_m ? kAgainstLong : kAgainst;
  return disputed.for_first_m >= kEnough_m && disputed.elsewhere_m >= kElsewhere_m &&
         (disputed.for_second_m <= against * disputed.for_first_m || disputed.ahead_sigmas >= kSigmas);
}

}  // namespace mapwright::align
