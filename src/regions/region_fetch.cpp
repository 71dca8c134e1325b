#include "regions/region_fetch.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

#include "grids/grid_pyramid.h"

namespace mapwright::regions {
namespace {

RegionMap::Options mapOptions(const RegionFetch::Options& options, const geometry::WorldRect& rect) {
  RegionMap::Options of_map;
  of_map.monotonic = options.monotonic;
  of_map.regions.budget_bytes = std::numeric_limits<std::size_t>::max();
  of_map.regions.plan.most_in_view = options.most_regions;
  of_map.regions.plan.cooldown = options.retry_after;
  of_map.regions.plan.only = rect;
  return of_map;
}

}  // namespace

Misfit flawOf(const map::GridPart& part) {
  const map::GridReference& grid = part.grid;
  if (grid.width <= 0 || grid.height <= 0 || map::unusableReason(grid)) return Misfit::Unusable;
  const bool all = part.cells && part.cells->size() / std::size_t(grid.width) >= std::size_t(grid.height);
  return all ? Misfit::None : Misfit::FewerCells;
}

map::OccupancyCells cellsOf(const grids::GridPyramid& grid) {
  auto cells = std::make_shared<std::vector<std::int8_t>>();
  const std::size_t width = std::size_t(grid.width());
  cells->resize(width * std::size_t(grid.height()));
  grids::GridRows rows(grid);
  for (int y = 0; y < grid.height(); ++y) {
    std::memcpy(cells->data() + std::size_t(grid.height() - 1 - y) * width, rows.row(y), width);
  }
  return cells;
}

RegionFetch::RegionFetch(robot::MapDispatch& dispatch, const geometry::WorldRect& rect, Options options,
                         QObject* parent)
    : QObject(parent), rect_(rect), tries_(options.tries), map_(dispatch, mapOptions(options, rect)) {
  // The requests are sent from within look(): whether it was the last is only known afterwards.
  connect(&map_, &RegionMap::changed, this, &RegionFetch::onChanged, Qt::QueuedConnection);
  without_offer_.setSingleShot(true);
  without_offer_.setInterval(int(options.offer_within.count()));
  connect(&without_offer_, &QTimer::timeout, this, &RegionFetch::end);
}

void RegionFetch::start() {
  if (std::exchange(started_, true)) return;
  map_.setView(rect_, rect_.center());
}

bool RegionFetch::complete() const {
  const RegionCounts now = counts();
  return over_ && !tooLarge() && now.in_view > 0 && now.answered == now.in_view && now.failed == 0 &&
         now.smaller == 0 && now.fetching == 0;
}

RegionTrouble RegionFetch::trouble() const {
  for (const RegionView& region : map_.regions().inView()) {
    if (region.trouble.kind != RegionTrouble::Kind::None) return region.trouble;
  }
  return map_.regions().plan().probeTrouble();
}

void RegionFetch::onChanged() {
  if (over_) return;
  Q_EMIT progressed();
  const RegionPlan& plan = map_.regions().plan();
  // A restarting dispatcher is back after a moment.
  const bool waits = !map_.offered() && plan.inProgress() == 0;
  if (!waits) without_offer_.stop();
  if (map_.gone() || tooLarge() || (!waits && plan.settled(tries_))) return end();
  if (waits && !without_offer_.isActive()) without_offer_.start();
}

void RegionFetch::end() {
  if (std::exchange(over_, true)) return;
  without_offer_.stop();
  Q_EMIT finished();
}

}  // namespace mapwright::regions

#include "moc_region_fetch.cpp"
