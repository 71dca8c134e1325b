#include "incident/on_the_way.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "geometry/polyline.h"
#include "geometry/rect.h"
#include "overlays/overlay_types.h"

namespace mapwright::incident {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double kStepM = 0.05;    // how exactly the distance along the path is known
constexpr double kLongestM = 500;  // of the path that is looked at
constexpr double kSamePlaceM = 0.1;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

bool segmentsCross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                   const Eigen::Vector2d& d) {
  return cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0;
}

double distanceOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                  const Eigen::Vector2d& d) {
  if (segmentsCross(a, b, c, d)) return 0;
  return std::min({geometry::distanceToSegment(a, c, d), geometry::distanceToSegment(b, c, d),
                   geometry::distanceToSegment(c, a, b), geometry::distanceToSegment(d, a, b)});
}

/// Rings may be left open. Even-odd: holes are outside.
bool isInside(const Eigen::Vector2d& at, const std::vector<Points>& rings) {
  bool inside = false;
  for (const Points& ring : rings) {
    for (std::size_t i = 0, before = ring.size() - 1; i < ring.size(); before = i++) {
      const Eigen::Vector2d &a = ring[i], &b = ring[before];
      if ((a.y() > at.y()) != (b.y() > at.y()) &&
          at.x() < (b.x() - a.x()) * (at.y() - a.y()) / (b.y() - a.y()) + a.x())
        inside = !inside;
    }
  }
  return inside;
}

struct Shape {
  std::vector<Points> parts;
  bool area = false;

  double distanceTo(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
    if (area && isInside(from, parts)) return 0;
    double least = std::numeric_limits<double>::infinity();
    for (const Points& part : parts) {
      if (part.size() == 1) least = std::min(least, geometry::distanceToSegment(part.front(), from, to));
      for (std::size_t i = 1; i < part.size(); ++i)
        least = std::min(least, distanceOf(from, to, part[i - 1], part[i]));
      if (area && part.size() > 2) least = std::min(least, distanceOf(from, to, part.back(), part.front()));
    }
    return least;
  }
  geometry::WorldRect bounds() const {
    geometry::WorldRect all;
    for (const Points& part : parts) {
      for (const Eigen::Vector2d& point : part) all.extend(point);
    }
    return all;
  }
};

/// The path in steps that are short enough.
Points inSteps(const Points& way) {
  Points fine;
  double length_m = 0;
  for (std::size_t i = 0; i < way.size() && length_m < kLongestM; ++i) {
    if (i > 0) {
      const Eigen::Vector2d step = way[i] - way[i - 1];
      const double part_m = std::min(step.norm(), kLongestM);
      const int count = std::max(1, int(std::ceil(part_m / kStepM)));
      for (int n = 1; n < count; ++n) fine.push_back(way[i - 1] + step * n / count);
      length_m += part_m;
    }
    fine.push_back(way[i]);
  }
  return fine;
}

/// Where the path comes within `radius_m`; nullopt: nowhere.
std::optional<OnTheWay> meet(const Points& fine, double radius_m, const Shape& shape) {
  const geometry::WorldRect near = shape.bounds().grown(radius_m + kStepM);
  double along_m = 0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const Eigen::Vector2d& to = fine[std::min(i + 1, fine.size() - 1)];
    if (near.contains(fine[i]) || near.contains(to)) {
      const double away_m = shape.distanceTo(fine[i], to);
      if (away_m <= radius_m) {
        OnTheWay met;
        met.along_m = along_m;
        met.here = i == 0 && shape.distanceTo(fine[i], fine[i]) <= radius_m;
        // It may come closer than where it is first too close.
        met.away_m = away_m;
        for (std::size_t next = i; next + 1 < fine.size() && met.away_m > 0; ++next) {
          const double then_m = shape.distanceTo(fine[next], fine[next + 1]);
          if (then_m > met.away_m) break;
          met.away_m = then_m;
        }
        return met;
      }
    }
    along_m += (to - fine[i]).norm();
  }
  return std::nullopt;
}

bool isObstacle(const map::OverlayFeature& feature) {
  if (feature.shape == map::OverlayShape::Line) return feature.type == overlays::kVirtualWall;
  return feature.shape == map::OverlayShape::Polygon && feature.type != overlays::kFreeRegion;
}

}  // namespace

Way remainingWay(const map::LiveState& live) {
  Way way;
  way.local = live.path.size() < 2;
  const map::Polyline& path = way.local ? live.local_path.points : live.path;
  if (path.size() < 2 || !live.robot_pose) return way;
  const Eigen::Vector2d robot(live.robot_pose->x_m, live.robot_pose->y_m);
  way.off_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < path.size(); ++i)
    way.off_m = std::min(way.off_m, geometry::distanceToSegment(robot, path[i - 1], path[i]));
  // A path may pass the same place more than once: what the robot says it has still to go tells which time it
  // is.
  std::size_t chosen = 0;
  double to_go_m = 0, least = std::numeric_limits<double>::infinity();
  const double told_m = live.planning ? live.planning->remaining_distance_m.value_or(-1) : -1;
  for (std::size_t i = path.size() - 1; i > 0; --i) {
    if (geometry::distanceToSegment(robot, path[i - 1], path[i]) <= way.off_m + kSamePlaceM) {
      const double differs = told_m >= 0 ? std::abs(to_go_m - told_m) : double(i);
      if (differs <= least) {
        least = differs;
        chosen = i;
      }
    }
    to_go_m += (path[i] - path[i - 1]).norm();
  }
  const Eigen::Vector2d step = path[chosen] - path[chosen - 1];
  const double share = step.squaredNorm() > 0
                           ? std::clamp((robot - path[chosen - 1]).dot(step) / step.squaredNorm(), 0.0, 1.0)
                           : 0;
  way.points.push_back(path[chosen - 1] + share * step);
  way.points.insert(way.points.end(), path.begin() + std::ptrdiff_t(chosen), path.end());
  return way;
}

double radiusOf(const map::RobotModel& model) {
  double half_m = 0;
  for (const Eigen::Vector2d& corner : model.footprint) half_m = std::max(half_m, std::abs(corner.y()));
  return half_m > 0 ? half_m : model.width_m / 2;
}

std::vector<OnTheWay> onTheWay(const Way& way, double radius_m,
                               const std::vector<map::OverlayFeature>& overlays,
                               const std::vector<map::AutoDoor>& doors) {
  std::vector<OnTheWay> all;
  const Points fine = inSteps(way.points);
  for (const map::OverlayFeature& feature : overlays) {
    if (!isObstacle(feature)) continue;
    auto met = meet(fine, radius_m, {feature.parts, feature.shape == map::OverlayShape::Polygon});
    if (!met) continue;
    met->shape = feature.shape;
    met->type = feature.type;
    met->name = feature.name;
    all.push_back(std::move(*met));
  }
  for (const map::AutoDoor& door : doors) {
    auto met = meet(fine, radius_m, {{door.polygon}, true});
    if (!met) continue;
    met->shape = map::OverlayShape::Polygon;
    met->seen_door = true;
    met->name = door.name.empty() ? door.mac : door.name;
    met->state = door.state;
    all.push_back(std::move(*met));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const OnTheWay& a, const OnTheWay& b) { return a.along_m < b.along_m; });
  return all;
}

}  // namespace mapwright::incident
