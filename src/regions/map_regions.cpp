#include "regions/map_regions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "grids/faults.h"
#include "grids/grid_pyramid.h"
#include "regions/region_sheet.h"

namespace mapwright::regions {
namespace {

constexpr double kMostCovered = 4096;    // regions that one answer may cover
constexpr std::size_t kMostRows = 8192;  // regions with any information
constexpr double kRoundingCells = 2;     // the effect of edge cells or a margin on a rectangle

RegionTrouble misplaced(Misfit misfit) { return {RegionTrouble::Kind::Misplaced, {}, misfit}; }

/// A reference with at least the size and position of its cells.
bool tellsCells(const map::GridReference& grid) {
  return !map::unusableReason(grid) && std::isfinite(grid.origin.yaw_rad);
}

/// The origin of the squares, aligned with whole tiles. Squares are axis-aligned: for a rotated grid it does
/// not matter.
Eigen::Vector2d anchorOf(const map::GridReference& grid) {
  return grid.origin.yaw_rad == 0 ? RegionSheet(grid).zero() : Eigen::Vector2d(0, 0);
}

}  // namespace

geometry::WorldRect commonGround(const map::GridReference& answer, const geometry::WorldRect& asked) {
  return answer.origin.yaw_rad == 0 ? common(answer.bounds(), asked) : geometry::WorldRect{};
}

bool liesElsewhere(const map::GridReference& answer, const geometry::WorldRect& asked) {
  // In the grid's axes: for a rotated grid, the surroundings of the region are a correct answer, too.
  const geometry::Pose2 to_grid = answer.origin.inverse();
  geometry::WorldRect around;
  for (const double x : {asked.min_x, asked.max_x}) {
    for (const double y : {asked.min_y, asked.max_y}) around.extend(to_grid.apply({x, y}));
  }
  const double wide = answer.width * answer.resolution_m, high = answer.height * answer.resolution_m;
  const double touch = answer.resolution_m * 0.01;
  if (common({0, 0, wide, high}, around).grown(-touch / 2).empty()) return true;
  const double rounding = kRoundingCells * answer.resolution_m;
  const bool as_large =
      std::abs(wide - around.width()) <= rounding && std::abs(high - around.height()) <= rounding;
  const Eigen::Vector2d beside = Eigen::Vector2d(wide / 2, high / 2) - around.center();
  return as_large && beside.cwiseAbs().maxCoeff() > rounding;
}

MapRegions::MapRegions(Options options) : options_(options), plan_(options.plan) {}

void MapRegions::setView(std::optional<geometry::WorldRect> rect, const Eigen::Vector2d& centre_m) {
  plan_.setView(rect, centre_m);
}

void MapRegions::setExtent(const std::optional<map::GridReference>& extent) {
  plan_.setExtent(extent && extent->origin.yaw_rad == 0 ? std::optional(extent->bounds()) : std::nullopt);
}

MapRegions::Change MapRegions::answered(std::uint64_t id, robot::Outcome<map::GridPart> outcome, Millis now) {
  Change change;
  const RegionRequest* const found = plan_.find(id);
  if (!found) return change;
  const RegionRequest request = *found;
  if (!outcome) {
    if (outcome.error().kind == map::FailureKind::Cancelled) {
      plan_.cancelled(id);
    } else {
      plan_.failed(id, {RegionTrouble::Kind::Failed, std::move(outcome.error()), Misfit::None}, now);
    }
    return change;
  }
  const std::size_t sheets_before = cells_.sheets().size();
  const RegionSheet* const last_before = sheets_before > 0 ? cells_.sheets().back().get() : nullptr;
  place(request, *outcome, now, change);
  keepToBudget(change);
  const auto& sheets = cells_.sheets();
  change.sheets = sheets.size() != sheets_before || (!sheets.empty() && sheets.back().get() != last_before);
  return change;
}

void MapRegions::place(const RegionRequest& request, const map::GridPart& part, Millis now, Change& change) {
  const map::GridReference& grid = part.grid;
  if (grid.width == 0 || grid.height == 0) {
    if (tellsCells(grid)) plan_.setCells(grid.resolution_m, anchorOf(grid));
    forgetOld(request, change);
    plan_.answered(request.id, true);
    return;
  }
  if (const Misfit misfit = cells_.misfitOf(part); misfit != Misfit::None) {
    plan_.failed(request.id, misplaced(misfit), now);
    return;
  }
  const geometry::WorldRect bounds = grid.bounds();
  const bool elsewhere = liesElsewhere(grid, request.rect);
  plan_.gave(grid);
  plan_.setCells(grid.resolution_m, anchorOf(grid));
  if (!elsewhere) forgetOld(request, change);
  cells_.put(part);
  for (const Fault& note : part.notes) {
    const auto* const count = note.code == grids::fault::RosCellsOutOfRange && !note.arguments.empty()
                                  ? std::get_if<std::int64_t>(&note.arguments.front())
                                  : nullptr;
    if (count) odd_cells_ += *count;
  }
  change.cells.extend(bounds);
  if (elsewhere && !request.is_first) {
    plan_.failed(request.id, {RegionTrouble::Kind::Elsewhere, {}, Misfit::None}, now);
  } else {
    plan_.answered(request.id, false, commonGround(grid, request.rect));
  }
  markCovered(request, grid);
}

bool MapRegions::holdsAnyOf(const geometry::WorldRect& rect) const {
  return std::any_of(cells_.sheets().begin(), cells_.sheets().end(),
                     [&](const auto& sheet) { return sheet->holdsAnyOf(rect); });
}

void MapRegions::forgetOld(const RegionRequest& request, Change& change) {
  if (request.is_first || !plan_.isOfThisCut(request.id)) return;
  // All of its square, though less was asked for: the map may have become smaller.
  const geometry::WorldRect own = plan_.squareOf(request.key);
  if (cells_.forget(own)) change.cells.extend(own);
}

void MapRegions::markCovered(const RegionRequest& request, const map::GridReference& grid) {
  const geometry::WorldRect bounds = grid.bounds();
  const RegionLattice& lattice = plan_.lattice();
  if (lattice.countIn(bounds) > kMostCovered) return;
  const geometry::Pose2 to_grid = grid.origin.inverse();
  const double slack = grid.resolution_m * 0.05;
  const double wide = grid.width * grid.resolution_m + slack, high = grid.height * grid.resolution_m + slack;
  lattice.eachIn(bounds, [&](const RegionKey& key) {
    const geometry::WorldRect rect = lattice.rectOf(key);
    bool all = true;
    for (const double x : {rect.min_x, rect.max_x}) {
      for (const double y : {rect.min_y, rect.max_y}) {
        const Eigen::Vector2d at = to_grid.apply({x, y});
        all = all && at.x() >= -slack && at.y() >= -slack && at.x() <= wide && at.y() <= high;
      }
    }
    plan_.came(key, commonGround(grid, rect), all, request.round);
  });
}

void MapRegions::keepToBudget(Change& change) {
  if (cells_.bytes() <= options_.budget_bytes && plan_.rows().size() <= kMostRows) return;
  struct Old {
    std::uint64_t seen;
    RegionKey key;
  };
  std::vector<Old> old;
  for (const auto& [key, row] : plan_.rows()) {
    if (row.request == 0 && !plan_.inView().contains(key)) old.push_back({row.seen, key});
  }
  std::sort(old.begin(), old.end(),
            [](const Old& a, const Old& b) { return a.seen != b.seen ? a.seen < b.seen : a.key < b.key; });
  for (const Old& each : old) {
    if (cells_.bytes() <= options_.budget_bytes && plan_.rows().size() <= kMostRows) return;
    const geometry::WorldRect rect = plan_.lattice().rectOf(each.key);
    if (plan_.row(each.key).may_hold && cells_.forget(rect)) change.cells.extend(rect);
    plan_.forget(each.key);
  }
}

RegionView MapRegions::viewOf(const RegionKey& key) const {
  const RegionRow& row = plan_.row(key);
  return {key, plan_.lattice().rectOf(key), row.state(), row.refreshing(), row.trouble};
}

RegionCounts MapRegions::counts() const {
  RegionCounts counts;
  for (const RegionKey& key : plan_.inView().keys()) {
    const RegionRow& row = plan_.row(key);
    ++counts.in_view;
    counts.answered += row.answered;
    counts.nothing += row.nothing();
    counts.fetching += row.request != 0;
    counts.failed += row.request == 0 && row.failures > 0;
    counts.smaller += plan_.leftOut(key);
  }
  return counts;
}

std::vector<RegionView> MapRegions::inView() const {
  std::vector<RegionView> views;
  for (const RegionKey& key : plan_.inView().keys()) views.push_back(viewOf(key));
  return views;
}

std::vector<RegionView> MapRegions::answeredIn(const geometry::WorldRect& rect) const {
  std::vector<RegionView> views;
  for (const auto& [key, row] : plan_.rows()) {
    if (row.answered && plan_.lattice().rectOf(key).intersects(rect)) views.push_back(viewOf(key));
  }
  return views;
}

std::optional<RegionView> MapRegions::at(const Eigen::Vector2d& world_m) const {
  const auto key = plan_.inView().at(world_m);
  return key ? std::optional(viewOf(*key)) : std::nullopt;
}

std::optional<double> MapRegions::cellsOf(const geometry::WorldRect& rect) const {
  const auto resolution = plan_.resolution();
  if (!resolution || rect.empty()) return std::nullopt;
  return std::ceil(rect.width() / *resolution) * std::ceil(rect.height() / *resolution);
}

}  // namespace mapwright::regions
