#include "regions/region_fetch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mapwright::regions {
namespace {

constexpr int kEdge = grids::GridPyramid::kTileEdge;

RegionMap::Options mapOptions(const RegionFetch::Options& options, const geometry::WorldRect& rect) {
  RegionMap::Options of_map;
  of_map.monotonic = options.monotonic;
  of_map.regions.budget_bytes = std::numeric_limits<std::size_t>::max();
  of_map.regions.plan.most_in_view = options.most_regions;
  of_map.regions.plan.cooldown = options.retry_after;
  of_map.regions.plan.only = rect;
  return of_map;
}

struct CellBox {
  int left = 0, top = 0, right = -1, bottom = -1;  // inclusive
  int width() const { return right - left + 1; }
  int height() const { return bottom - top + 1; }
  bool empty() const { return width() <= 0 || height() <= 0; }
};

/// The cells of a sheet whose middle may lie in `rect`.
CellBox boxOf(const RegionSheet& sheet, const geometry::WorldRect& rect) {
  geometry::WorldRect box;
  for (const double x : {rect.min_x, rect.max_x}) {
    for (const double y : {rect.min_y, rect.max_y}) box.extend(sheet.reference().cellFromWorld({x, y}));
  }
  constexpr double kRounding = 1e-6;
  const auto first = [](double at) { return std::max(0.0, std::ceil(at - 0.5 - kRounding)); };
  const auto last = [](double at, int size) {
    return std::min(size - 1.0, std::ceil(at - 0.5 - kRounding) - 1);
  };
  const double left = first(box.min_x), top = first(box.min_y), right = last(box.max_x, sheet.width()),
               bottom = last(box.max_y, sheet.height());
  if (!(left <= right && top <= bottom)) return {};
  return {int(left), int(top), int(right), int(bottom)};
}

std::int64_t tilesIn(const RegionSheet& sheet, const CellBox& box) {
  std::int64_t count = 0;
  for (int y = box.top / kEdge; !box.empty() && y <= box.bottom / kEdge; ++y) {
    for (int x = box.left / kEdge; x <= box.right / kEdge; ++x) count += sheet.tile(0, x, y).has_value();
  }
  return count;
}

}  // namespace

FetchedGrid cutOut(const std::vector<std::shared_ptr<RegionSheet>>& sheets, const geometry::WorldRect& rect,
                   const grids::Means& means) {
  FetchedGrid fetched;
  const RegionSheet* best = nullptr;
  std::int64_t most = 0;
  int with_cells = 0;
  for (const auto& sheet : sheets) {
    const std::int64_t tiles = tilesIn(*sheet, boxOf(*sheet, rect));
    with_cells += tiles > 0;
    if (tiles > most) {
      most = tiles;
      best = sheet.get();
    }
  }
  if (!best) return fetched;
  fetched.other_lattices = with_cells - 1;
  const CellBox box = boxOf(*best, rect);
  const map::GridReference& of_sheet = best->reference();
  const Eigen::Vector2d corner = of_sheet.worldFromCell({double(box.left), double(box.bottom + 1)});
  fetched.reference = {
      box.width(), box.height(), of_sheet.resolution_m, {corner.x(), corner.y(), of_sheet.origin.yaw_rad}};
  const bool turned = of_sheet.origin.yaw_rad != 0;
  const auto builder = grids::buildGrid(box.width(), box.height(), grids::CellCode::Occupancy,
                                        grids::Reduction::OccupiedWins, means);
  std::vector<std::uint8_t> row(std::size_t(box.width()));
  std::vector<std::optional<grids::GridTile>> tiles;
  for (int v = box.top; v <= box.bottom; ++v) {
    if (v == box.top || v % kEdge == 0) {
      tiles.clear();
      for (int x = box.left / kEdge; x <= box.right / kEdge; ++x)
        tiles.push_back(best->tile(0, x, v / kEdge));
    }
    for (int u = box.left; u <= box.right; ++u) {
      std::uint8_t& cell = row[std::size_t(u - box.left)];
      cell = grids::kUnknownOccupancy;
      const auto& tile = tiles[std::size_t(u / kEdge - box.left / kEdge)];
      if (!tile || (turned && !rect.contains(of_sheet.worldFromCell({u + 0.5, v + 0.5})))) continue;
      const std::uint8_t byte = tile->cells.get()[std::size_t(v % kEdge) * kEdge + std::size_t(u % kEdge)];
      if (byte != kNotFetched) cell = byte;
    }
    builder->pushRow(row);
  }
  builder->finish();
  fetched.cells = builder->pyramid();
  return fetched;
}

namespace {

std::string pgmHead(int width, int height) {
  return "P5\n" + std::to_string(width) + ' ' + std::to_string(height) + "\n255\n";
}
char pgmByte(std::uint8_t cell) { return char(cell <= 100 ? cell : grids::kUnknownOccupancy); }

}  // namespace

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
  for (int y = 0; y * kEdge < cells.height(); ++y) {
    for (int x = 0; x * kEdge < cells.width(); ++x) {
      const auto tile = cells.tile(0, x, y);
      if (!tile) continue;
      for (int row = 0; row < std::min(kEdge, cells.height() - y * kEdge); ++row) {
        const std::size_t to = head + std::size_t(y * kEdge + row) * width + std::size_t(x) * kEdge;
        for (int column = 0; column < std::min(kEdge, cells.width() - x * kEdge); ++column)
          pgm[to + std::size_t(column)] =
              pgmByte(tile->cells.get()[std::size_t(row) * kEdge + std::size_t(column)]);
      }
    }
  }
  return pgm;
}

RegionFetch::RegionFetch(robot::MapDispatch& dispatch, const geometry::WorldRect& rect, Options options,
                         QObject* parent)
    : QObject(parent), rect_(rect), tries_(options.tries), map_(dispatch, mapOptions(options, rect)) {
  // The requests are sent from within look(): whether that was the last word is known afterwards.
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
  // One that restarts is back after a moment.
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
