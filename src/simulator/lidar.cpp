#include "simulator/lidar.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "simulator/noise.h"

namespace mapwright::simulator {
namespace {

using Eigen::Vector2d;

// A cell of the canvas is one word, so that a ray touches one spot in memory per step.
constexpr std::uint32_t kSolid = 0x8000'0000;
constexpr std::uint32_t kHits = 0x7F00'0000, kOneHit = 0x0100'0000;
constexpr std::uint32_t kMisses = 0x00FF'FFFF, kOneMiss = 1;
constexpr int kHitWeight = 34, kMissWeight = 8;
constexpr int kFree = -96, kOccupied = 112;  // where probabilities saturate, as Cartographer clamps them

/// The area that the scans can reach, in texture order. Cell (u, v): u = (top.y - y) / res, v = (top.x - x) /
/// res in the slice's axes around the anchor.
struct Canvas {
  int width = 0, height = 0;
  Vector2d top{0, 0};
  double c = 1, s = 0;  // of the yaw
  Vector2d anchor{0, 0};
  double resolution = 0.05;
  std::vector<std::uint32_t> cells;  // solid flag, hits, misses

  Vector2d local(const Vector2d& world) const {
    const Vector2d d = world - anchor;
    return {c * d.x() + s * d.y(), -s * d.x() + c * d.y()};
  }
  /// World point to cell coordinates (u, v).
  Vector2d cell(const Vector2d& world) const {
    const Vector2d p = local(world);
    return {(top.y() - p.y()) / resolution, (top.x() - p.x()) / resolution};
  }
  std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
  }
};

Canvas makeCanvas(const std::vector<ScanPlace>& scans, const Vector2d& anchor, double yaw,
                  const ScanSettings& settings) {
  Canvas canvas;
  canvas.c = std::cos(yaw);
  canvas.s = std::sin(yaw);
  canvas.anchor = anchor;
  canvas.resolution = settings.resolution_m;
  Eigen::AlignedBox2d bounds;
  if (scans.empty()) bounds.extend(Vector2d(0, 0));
  for (const ScanPlace& scan : scans) bounds.extend(canvas.local({scan.pose.x_m, scan.pose.y_m}));
  const Vector2d low = bounds.min(), high = bounds.max();
  const double res = settings.resolution_m, margin = settings.range_m + 4 * res;
  canvas.top = {std::ceil((high.x() + margin) / res) * res, std::ceil((high.y() + margin) / res) * res};
  canvas.width = static_cast<int>(std::ceil((canvas.top.y() - (low.y() - margin)) / res));
  canvas.height = static_cast<int>(std::ceil((canvas.top.x() - (low.x() - margin)) / res));
  const auto cells = static_cast<std::size_t>(canvas.width) * static_cast<std::size_t>(canvas.height);
  canvas.cells.assign(cells, 0);
  return canvas;
}

/// Narrows [from, to] to where |slope * u + offset| <= half.
void narrow(double slope, double offset, double half, double& from, double& to) {
  if (std::abs(slope) < 1e-12) {
    if (std::abs(offset) > half) to = from - 1;
    return;
  }
  const double a = (-half - offset) / slope, b = (half - offset) / slope;
  from = std::max(from, std::min(a, b));
  to = std::min(to, std::max(a, b));
}

/// Flags the cells whose centres the solid covers, grown a little so that the thinnest legs cover at least
/// one.
void drawSolid(Canvas& canvas, const Solid& solid) {
  const Vector2d centre = canvas.cell(solid.centre);
  const double reach = solid.reach() / canvas.resolution + 1;
  const int v0 = std::max(0, static_cast<int>(std::floor(centre.y() - reach)));
  const int v1 = std::min(canvas.height - 1, static_cast<int>(std::ceil(centre.y() + reach)));
  const double hx = solid.half.x() / canvas.resolution + 0.35, hy = solid.half.y() / canvas.resolution + 0.35;
  const double yaw = solid.yaw_rad - std::atan2(canvas.s, canvas.c);
  // The box's axes in (u, v): local x is -v, local y is -u.
  const double ax = -std::sin(yaw), ay = -std::cos(yaw), bx = -std::cos(yaw), by = std::sin(yaw);
  for (int v = v0; v <= v1; ++v) {
    const double dv = v + 0.5 - centre.y();
    double from = -reach, to = reach;
    if (solid.round) {
      const double rest = hx * hx - dv * dv;
      if (rest < 0) continue;
      from = -std::sqrt(rest);
      to = -from;
    } else {
      narrow(ax, ay * dv, hx, from, to);
      narrow(bx, by * dv, hy, from, to);
    }
    const int u0 = std::max(0, static_cast<int>(std::ceil(centre.x() + from - 0.5)));
    const int u1 = std::min(canvas.width - 1, static_cast<int>(std::floor(centre.x() + to - 0.5)));
    for (int u = u0; u <= u1; ++u) canvas.cells[canvas.index(u, v)] |= kSolid;
  }
}

void addHit(std::uint32_t& cell) {
  if ((cell & kHits) < kHits) cell += kOneHit;
}

/// One turn of the lidar: every ray marks free cells until it meets a solid.
void castScan(Canvas& canvas, const ScanPlace& scan, double yaw, const ScanSettings& settings) {
  constexpr double kOne = 65536;
  const Vector2d start = canvas.cell({scan.pose.x_m, scan.pose.y_m});
  const double turn = 2 * std::numbers::pi / settings.rays;
  Dice dice(hashOf(settings.seed, scan.number));
  const double first = scan.pose.yaw_rad - yaw + turn * unitFrom(dice.next());
  for (int ray = 0; ray < settings.rays; ++ray) {
    const double angle = first + turn * ray;
    double du = -std::sin(angle), dv = -std::cos(angle);
    const double major = std::max(std::abs(du), std::abs(dv));
    const std::uint64_t noise = dice.next();
    // Weak returns get lost: the far end of a ray's reach differs from ray to ray.
    const double range = settings.range_m * (0.72 + 0.28 * unitFrom(noise));
    const int steps = static_cast<int>(range / canvas.resolution * major);
    const auto step_u = static_cast<std::int32_t>(du / major * kOne),
               step_v = static_cast<std::int32_t>(dv / major * kOne);
    auto u = static_cast<std::int32_t>(start.x() * kOne), v = static_cast<std::int32_t>(start.y() * kOne);
    std::size_t before = canvas.index(u >> 16, v >> 16);
    for (int i = 0; i < steps; ++i) {
      const std::size_t here = canvas.index(u >> 16, v >> 16);
      if (canvas.cells[here] & kSolid) {
        const auto grain = static_cast<unsigned>(noise & 0xFF);
        if (grain < 10) {  // a return that comes a little short
          addHit(canvas.cells[before]);
        } else {
          addHit(canvas.cells[here]);
          if (grain < 60) {  // or a little deep
            const std::size_t next = canvas.index((u + step_u) >> 16, (v + step_v) >> 16);
            if (canvas.cells[next] & kSolid) addHit(canvas.cells[next]);
          }
        }
        break;
      }
      canvas.cells[here] += kOneMiss;
      before = here;
      u += step_u;
      v += step_v;
    }
  }
}

/// Counts to a seen cell's value, with the grain that real grids have.
std::uint8_t cellValue(std::uint32_t cell, std::uint64_t grain) {
  const auto hits = static_cast<int>((cell & kHits) / kOneHit), misses = static_cast<int>(cell & kMisses);
  // What was seen often is saturated and without grain, as in a real grid: that also packs well.
  const int noise = static_cast<int>(grain % 17) - 8;
  const int score = kHitWeight * hits - kMissWeight * misses + noise;
  return static_cast<std::uint8_t>(128 + std::clamp(score, kFree, kOccupied));
}

constexpr int kMostRays = 1440;
constexpr double kNoiseM = 0.012;
constexpr double kFirstHeightM = 0.04, kLayerM = 0.08;
constexpr int kLayers = 16;
constexpr double kTurn = 2 * std::numbers::pi;

/// Metres along the ray to the solid; infinity when it misses.
double hit(const Solid& solid, const Vector2d& start, const Vector2d& direction) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const Vector2d offset = solid.centre - start;
  if (solid.round) {
    const double along = offset.dot(direction);
    const double past = offset.squaredNorm() - along * along;
    const double radius = solid.half.x();
    if (along <= 0 || past > radius * radius) return kNever;
    return along - std::sqrt(radius * radius - past);
  }
  const double c = std::cos(solid.yaw_rad), s = std::sin(solid.yaw_rad);
  const double p[2] = {-(c * offset.x() + s * offset.y()), s * offset.x() - c * offset.y()};
  const double d[2] = {c * direction.x() + s * direction.y(), -s * direction.x() + c * direction.y()};
  double from = 0, to = kNever;
  for (int axis = 0; axis < 2; ++axis) narrow(d[axis], p[axis], solid.half[axis], from, to);
  return from <= to ? from : kNever;
}

/// The nearest solid on every ray; infinity where there is none.
std::vector<double> cast(const FloorPlan& plan, const geometry::Pose2& pose, int rays) {
  std::vector<double> ranges(static_cast<std::size_t>(rays), std::numeric_limits<double>::infinity());
  const Vector2d start(pose.x_m, pose.y_m), reach(kLidarRangeM, kLidarRangeM);
  const double step = kTurn / rays;
  // Made once: a ray passes many solids.
  std::vector<Vector2d> directions(ranges.size());
  for (std::size_t ray = 0; ray < directions.size(); ++ray) {
    const double angle = pose.yaw_rad + step * static_cast<double>(ray);
    directions[ray] = {std::cos(angle), std::sin(angle)};
  }
  for (const std::uint32_t index : plan.near(start - reach, start + reach)) {
    const Solid& solid = plan.solids()[index];
    const Vector2d offset = solid.centre - start;
    const double distance = offset.norm();
    // Only the rays within the solid's circle can meet it.
    const double half =
        distance <= solid.reach() ? std::numbers::pi : std::asin(solid.reach() / distance) + step;
    const double middle = std::atan2(offset.y(), offset.x()) - pose.yaw_rad;
    const int count = std::min(rays, static_cast<int>(std::ceil(2 * half / step)) + 1);
    const auto first = static_cast<long>(std::floor((middle - half) / step));
    for (int i = 0; i < count; ++i) {
      const auto ray = static_cast<std::size_t>(((first + i) % rays + rays) % rays);
      ranges[ray] = std::min(ranges[ray], hit(solid, start, directions[ray]));
    }
  }
  return ranges;
}

}  // namespace

Eigen::AlignedBox2d boundsOf(const std::vector<ScanPlace>& scans) {
  Eigen::AlignedBox2d bounds;
  for (const ScanPlace& scan : scans) bounds.extend(Vector2d(scan.pose.x_m, scan.pose.y_m));
  return bounds;
}

ScanGrid scanGrid(const FloorPlan& plan, const std::vector<Solid>& extra, const std::vector<ScanPlace>& scans,
                  const Vector2d& anchor, double yaw_rad, const ScanSettings& settings) {
  Canvas canvas = makeCanvas(scans, anchor, yaw_rad, settings);
  if (!scans.empty()) {
    const Eigen::AlignedBox2d bounds = boundsOf(scans);
    const Vector2d range(settings.range_m, settings.range_m);
    for (const std::uint32_t index : plan.near(bounds.min() - range, bounds.max() + range))
      drawSolid(canvas, plan.solids()[index]);
    for (const Solid& solid : extra) drawSolid(canvas, solid);
    for (const ScanPlace& scan : scans) castScan(canvas, scan, yaw_rad, settings);
  }

  int u0 = canvas.width, u1 = -1, v0 = canvas.height, v1 = -1;
  for (int v = 0; v < canvas.height; ++v) {
    const std::uint32_t* row = canvas.cells.data() + canvas.index(0, v);
    const auto seen = [&](int u) { return (row[u] & ~kSolid) != 0; };
    int left = 0;
    while (left < canvas.width && !seen(left)) ++left;
    if (left == canvas.width) continue;
    int right = canvas.width - 1;
    while (!seen(right)) --right;
    u0 = std::min(u0, left);
    u1 = std::max(u1, right);
    v0 = std::min(v0, v);
    v1 = v;
  }
  if (u1 < 0) u0 = u1 = v0 = v1 = 0;

  ScanGrid grid;
  grid.width = u1 - u0 + 1;
  grid.height = v1 - v0 + 1;
  grid.resolution_m = settings.resolution_m;
  const Vector2d corner = canvas.top - settings.resolution_m * Vector2d(v0, u0);
  grid.world_from_slice =
      geometry::Pose2{anchor.x(), anchor.y(), yaw_rad} * geometry::Pose2{corner.x(), corner.y(), 0};
  grid.cells.resize(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
  // The grain belongs to the place on the lattice, so that it stays when a new version has grown.
  const auto top_row = std::llround(canvas.top.x() / settings.resolution_m);
  const auto top_column = std::llround(canvas.top.y() / settings.resolution_m);
  std::size_t out = 0;
  for (int v = v0; v <= v1; ++v) {
    const std::uint64_t row = hashOf(settings.seed, top_row - v);
    std::uint64_t bits = 0, octet = ~std::uint64_t{0};
    const std::uint32_t* counts = canvas.cells.data() + canvas.index(0, v);
    for (int u = u0; u <= u1; ++u, ++out) {
      if ((counts[u] & ~kSolid) == 0) continue;
      const auto column = static_cast<std::uint64_t>(top_column - u);
      if (column >> 3 != octet) {
        octet = column >> 3;
        bits = mix(row ^ octet);
      }
      grid.cells[out] = cellValue(counts[u], (bits >> (8 * (column & 7))) & 0xFF);
    }
  }
  return grid;
}

std::vector<LidarPoint> scanFrom(const FloorPlan& plan, const geometry::Pose2& pose, int points,
                                 std::uint64_t seed) {
  std::vector<LidarPoint> found;
  if (points <= 0) return found;
  const int rays = std::clamp(points, 180, kMostRays);
  const std::vector<double> ranges = cast(plan, pose, rays);
  std::vector<std::size_t> hits;
  for (std::size_t ray = 0; ray < ranges.size(); ++ray) {
    if (ranges[ray] <= kLidarRangeM) hits.push_back(ray);
  }
  if (hits.empty()) return found;

  found.reserve(static_cast<std::size_t>(points));
  Dice dice(seed);
  for (std::size_t i = 0; found.size() < static_cast<std::size_t>(points); ++i) {
    const std::size_t ray = hits[i % hits.size()], layer = i / hits.size();
    const double angle = pose.yaw_rad + kTurn / rays * (static_cast<double>(ray) + dice.uniform(-0.4, 0.4));
    const double range = ranges[ray] + dice.uniform(-kNoiseM, kNoiseM);
    LidarPoint point;
    point.at_m = {pose.x_m + range * std::cos(angle), pose.y_m + range * std::sin(angle)};
    point.z_m = static_cast<float>(kFirstHeightM + kLayerM * static_cast<double>(layer % kLayers));
    point.intensity = static_cast<std::uint8_t>(40 + 200 * std::exp(-range / 8) * dice.uniform(0.6, 1));
    found.push_back(point);
  }
  return found;
}

std::vector<double> rangesFrom(const FloorPlan& plan, const geometry::Pose2& pose, int rays,
                               std::uint64_t seed) {
  std::vector<double> ranges = cast(plan, pose, rays);
  Dice dice(seed);
  for (double& range : ranges) {
    range = range <= kLidarRangeM ? range + dice.uniform(-kNoiseM, kNoiseM)
                                  : std::numeric_limits<double>::infinity();
  }
  return ranges;
}

}  // namespace mapwright::simulator
