#include "regions/region_fetch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

std::string pgmHead(int width, int height) {
  return "P5\n" + std::to_string(width) + ' ' + std::to_string(height) + "\n255\n";
}
char pgmByte(std::uint8_t cell) { return char(cell <= 100 ? cell : grids::kUnknownOccupancy); }

}  // namespace

Misfit flawOf(const map::GridPart& part) {
  const map::GridReference& grid = part.grid;
  if (grid.width <= 0 || grid.height <= 0 || map::whyUnusable(grid)) return Misfit::Unusable;
  const bool all = part.cells && part.cells->size() / std::size_t(grid.width) >= std::size_t(grid.height);
  return all ? Misfit::None : Misfit::FewerCells;
}

std::string pgmOf(const map::GridPart& part) {
  const std::size_t width = std::size_t(part.grid.width), height = std::size_t(part.grid.height);
  std::string pgm = pgmHead(part.grid.width, part.grid.height);
  pgm.reserve(pgm.size() + width * height);
  for (std::size_t row = height; row-- > 0;) {
    const std::int8_t* const cells = part.cells->data() + row * width;
    for (std::size_t column = 0; column < width; ++column)
      pgm.push_back(pgmByte(std::uint8_t(cells[column])));
  }
  return pgm;
}

std::string pgmOf(const grids::GridPyramid& cells) {
  std::string pgm = pgmHead(cells.width(), cells.height());
  const std::size_t head = pgm.size(), width = std::size_t(cells.width());
  pgm.resize(head + width * std::size_t(cells.height()), char(grids::kUnknownOccupancy));
  for (int y = 0; y * kTile < cells.height(); ++y) {
    for (int x = 0; x * kTile < cells.width(); ++x) {
      const auto tile = cells.tile(0, x, y);
      if (!tile) continue;
      for (int row = 0; row < std::min(kTile, cells.height() - y * kTile); ++row) {
        const std::size_t to = head + std::size_t(y * kTile + row) * width + std::size_t(x) * kTile;
        for (int column = 0; column < std::min(kTile, cells.width() - x * kTile); ++column)
          pgm[to + std::size_t(column)] =
              pgmByte(tile->cells.get()[std::size_t(row) * kTile + std::size_t(column)]);
      }
    }
  }
  return pgm;
}

RegionFetch::RegionFetch(robot::MapDispatch& dispatch, const geometry::WorldRect& rect, Options options,
                         QObject* parent)
    : QObject(parent), rect_(rect), tries_(options.tries), map_(dispatch, mapOptions(options, rect)) {
  // The requests are sent from within look(): whether it was the last is only known afterwards.
  connect(&map_, &RegionMap::changed, this, &RegionFetch::note, Qt::QueuedConnection);
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

void RegionFetch::note() {
  if (over_) return;
  Q_EMIT progressed();
  const RegionPlan& plan = map_.regions().plan();
  // A restarting dispatcher is back after a moment.
  const bool waits = !map_.offered() && plan.underWay() == 0;
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
