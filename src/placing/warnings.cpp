#include "placing/warnings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "grids/grid_pyramid.h"
#include "map/live_topics.h"
#include "map/waypoint.h"

namespace mapwright::placing {
namespace {

Warnings warningsAt(Ground& ground, const Eigen::Vector2d& place_m, double radius_m, bool known,
                    bool is_part) {
  Warnings warnings;
  const Cell cell = ground.at(place_m);
  if (cell == Cell::Occupied) {
    warnings.push_back({WarningKind::InWall});
    return warnings;
  }
  if (cell == Cell::Outside && !is_part) warnings.push_back({WarningKind::OutsideMap});
  if (radius_m > 0 && known) {
    if (const auto wall = ground.nearestWall(place_m, radius_m))
      warnings.push_back({WarningKind::NearWall, wall->distance_m, radius_m});
  }
  if (cell == Cell::Unknown && known) warnings.push_back({WarningKind::OnUnknown});
  return warnings;
}

/// Interleaves the bits of both numbers: neighbours in this order are close together.
std::uint64_t interleaved(std::uint32_t x, std::uint32_t y) {
  const auto spread = [](std::uint64_t bits) {
    bits = (bits | bits << 16) & 0x0000ffff0000ffff;
    bits = (bits | bits << 8) & 0x00ff00ff00ff00ff;
    bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0f;
    bits = (bits | bits << 2) & 0x3333333333333333;
    return (bits | bits << 1) & 0x5555555555555555;
  };
  return spread(x) | spread(y) << 1;
}

/// Tile by tile, those of a coarser level together: each is unpacked once, in whatever order the positions
/// come.
std::vector<std::size_t> inOrder(const std::vector<Eigen::Vector2d>& places_m,
                                 const map::GridReference& reference) {
  const auto tileOf = [&](const Eigen::Vector2d& place_m) -> std::uint64_t {
    if (!place_m.allFinite()) return 0;
    const Eigen::Vector2d cell = reference.cellFromWorld(place_m);
    const auto tile = [](double at) {
      return std::uint32_t(std::clamp(at / grids::GridPyramid::kTileEdge, 0.0, 1e7));
    };
    return interleaved(tile(cell.x()), tile(cell.y()));
  };
  std::vector<std::pair<std::uint64_t, std::size_t>> tiles;
  tiles.reserve(places_m.size());
  for (std::size_t i = 0; i < places_m.size(); ++i) tiles.push_back({tileOf(places_m[i]), i});
  std::sort(tiles.begin(), tiles.end());
  std::vector<std::size_t> order;
  order.reserve(tiles.size());
  for (const auto& [tile, i] : tiles) order.push_back(i);
  return order;
}

}  // namespace

std::vector<std::vector<std::size_t>> groupsOf(const std::vector<Eigen::Vector2d>& places_m,
                                               const map::GridReference& reference, std::size_t most) {
  std::vector<std::vector<std::size_t>> groups;
  const bool usable = !map::unusableReason(reference);
  std::vector<std::size_t> order;
  if (usable) {
    order = inOrder(places_m, reference);
  } else {
    order.resize(places_m.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
  }
  for (std::size_t from = 0; from < order.size(); from += most) {
    const std::size_t to = std::min(order.size(), from + most);
    groups.emplace_back(order.begin() + std::ptrdiff_t(from), order.begin() + std::ptrdiff_t(to));
  }
  return groups;
}

double radiusOf(const map::RobotModel& model) {
  double radius = model.width_m > 0 && model.footprint.empty() ? model.width_m / 2 : 0;
  for (const Eigen::Vector2d& corner : model.footprint) {
    if (corner.allFinite()) radius = std::max(radius, corner.norm());
  }
  return std::isfinite(radius) && radius <= kMostRadiusM ? radius : 0;
}

GroundWarnings groundWarnings(const std::vector<Eigen::Vector2d>& places_m, const PlacedMap& map,
                              double radius_m, const std::atomic<bool>* cancelled) {
  GroundWarnings found;
  found.of.resize(places_m.size());
  Ground ground(map, Ground::Access::Wait);
  if (!ground.there()) return found;
  const bool known = !ground.allUnknown();
  found.state = known ? GroundState::Known : GroundState::Unknown;
  for (const std::size_t i : inOrder(places_m, map.reference)) {
    if (cancelled && *cancelled) break;
    found.of[i] = warningsAt(ground, places_m[i], radius_m, known, map.is_part);
  }
  return found;
}

std::set<std::string> namesTwice(const std::vector<std::string>& names) {
  std::unordered_set<std::string_view> once;
  std::set<std::string> twice;
  for (const std::string& name : names) {
    if (!name.empty() && !once.insert(name).second) twice.insert(name);
  }
  return twice;
}

Warnings together(const Warnings& of_ground, const std::string& name, bool name_twice, bool zero_turn) {
  Warnings all = of_ground;
  if (name_twice) all.push_back({WarningKind::NameTwice});
  if (zero_turn) all.push_back({WarningKind::ZeroTurn});
  if (!map::permanentName(name).empty()) all.push_back({WarningKind::TemporaryName});
  return all;
}

}  // namespace mapwright::placing
