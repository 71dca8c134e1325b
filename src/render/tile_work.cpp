#include "render/tile_work.h"

#include <algorithm>
#include <cmath>

namespace mapwright::render {
namespace {

constexpr double kDirectViewCells =
    2;                          // up to so many native cells a pixel, view tiles are composed directly
constexpr int kFewMissing = 8;  // pyramid tiles; with no more missing it is soon exact and needs no preview
constexpr double kFinestNativeM = 1e-3;  // a freak texture does not make the whole view slow
constexpr std::size_t kSubmapStandIns = 64;

}  // namespace

TileWork::TileWork(const TileRenderer::Options& options, std::function<void()> changed)
    : options_(options),
      changed_(std::move(changed)),
      dense_(options.budgets.dense),
      tiles_(!options.previews),
      color_table_(std::make_shared<const ColorTable>(colors_, ColorMode::Normal)),
      workers_(work::orOwn(options.workers),
               [this](std::vector<TileWorkers::Outcome> outcomes) { receive(std::move(outcomes)); }),
      pyramid_(index_, workers_, dense_) {}

bool TileWork::usesPyramid() const {
  const auto finest_m = index_.finest();
  return options_.previews && finest_m &&
         tiles_.view().scale_m_per_px > kDirectViewCells * std::max(*finest_m, kFinestNativeM) * (1 + 1e-9);
}

// The level whose pixels are between a half and a quarter of the view's.
int TileWork::pyramidLevel() const {
  return int(std::floor(std::log2(tiles_.view().scale_m_per_px / pyramid_.base()) + 1e-9)) - 1;
}

void TileWork::cancelWork(ViewTile& tile) {
  for (TileWorkers::Ticket* const ticket : {&tile.exact_work, &tile.preview_work}) {
    if (*ticket != 0) workers_.cancel(*ticket);
    *ticket = 0;
  }
}

void TileWork::setView(const geometry::ViewTransform& view) {
  if (tiles_.rasterChanges(view)) {
    ++raster_;
    tiles_.forEach([this](ViewTile& tile) { cancelWork(tile); });
    if (options_.previews)
      stand_ins_.push(tiles_.pictures(kSubmapStandIns), tiles_.view(),
                      colors_.clear_unknown ? 0 : colors_.unknown);
  }
  tiles_.setView(view);
  markEmptyGround();
  dropStandInsWhenCovered();
}

void TileWork::setColors(const MapColors& colors, ColorMode mode) {
  colors_ = colors;
  color_table_ = std::make_shared<const ColorTable>(colors, mode);
  ++colors_revision_;
  stand_ins_.repaint(*color_table_);
}

void TileWork::contentChanged(const std::vector<geometry::WorldRect>& rects) {
  ++generation_;
  if (const auto finest_m = index_.finest(); finest_m && pyramid_.base() == 0) {
    pyramid_.setBase(std::max(*finest_m, kFinestNativeM));
  }
  tiles_.touch(rects, generation_, [this](ViewTile& tile) { cancelWork(tile); });
  pyramid_.invalidate(rects);
  markEmptyGround();
}

void TileWork::contentCleared() {
  ++generation_;
  tiles_.forEach([this](ViewTile& tile) { cancelWork(tile); });
  tiles_.clear();
  stand_ins_.clear();
  pyramid_.clear();
  pyramid_.setBase(0);
  dense_.clear();
  markEmptyGround();
}

void TileWork::proceed() {
  pyramid_.beginRound();
  if (usesPyramid()) startPreviews();
  startExact();
  dropStandInsWhenCovered();
  trim();
}

void TileWork::markEmptyGround() {
  for (const TilePlace& place : tiles_.visible()) {
    ViewTile& tile = tiles_.at(place);
    if (tile.settled() || index_.anyWithin(tiles_.gridOf(place).bounds())) continue;
    cancelWork(tile);
    tiles_.setPicture(tile, nullptr, {}, colors_revision_);
    tile.known = tile.exact = true;
    tile.shown = generation_;
  }
}

void TileWork::startPreviews() {
  for (const TilePlace& place : tiles_.visible()) {
    if (!workers_.hasRoom()) return;
    ViewTile& tile = tiles_.at(place);
    if (tile.current() || tile.preview_work != 0) continue;
    // Old content stays until the new is ready, unless that takes long.
    const bool soon_exact = tile.known && pyramid_.missing(patchFor(tiles_.gridOf(place), pyramidLevel(),
                                                                    pyramid_.base())) <= kFewMissing;
    if (!soon_exact) startComposing(place, tile, Quality::Preview);
  }
}

void TileWork::startExact() {
  const bool from_pyramid = usesPyramid();
  for (const TilePlace& place : tiles_.visible()) {
    if (!workers_.hasRoom()) return;
    ViewTile& tile = tiles_.at(place);
    if (tile.settled() || tile.exact_work != 0) continue;
    if (!from_pyramid || !startFromPyramid(place, tile)) startComposing(place, tile, Quality::Exact);
  }
}

// False if the pyramid cannot provide such a tile at all.
bool TileWork::startFromPyramid(const TilePlace& place, ViewTile& tile) {
  const PixelGrid grid = tiles_.gridOf(place);
  PyramidPatch patch = patchFor(grid, pyramidLevel(), pyramid_.base());
  if (patch.columns == 0) return false;
  if (!pyramid_.request(patch) || !workers_.hasRoom()) return true;
  tile.exact_work =
      startWork(place, tile, true, [grid, patch = std::move(patch)](const std::atomic<bool>& cancelled) {
        return resampled(grid, patch, cancelled);
      });
  return true;
}

void TileWork::startComposing(const TilePlace& place, ViewTile& tile, Quality quality) {
  const PixelGrid grid = tiles_.gridOf(place);
  // Reduced levels extend slightly beyond the cells themselves.
  const double margin_m = quality == Quality::Preview ? 2 * grid.scale_m_per_px : 0;
  const bool exact = quality == Quality::Exact;
  (exact ? tile.exact_work : tile.preview_work) =
      startWork(place, tile, exact,
                [grid, quality, textures = index_.within(grid.bounds().grown(margin_m)),
                 &dense = dense_](const std::atomic<bool>& cancelled) {
                  return compose(grid, textures, quality, dense, Kernel::Best, &cancelled);
                });
}

TileWorkers::Ticket TileWork::startWork(const TilePlace& place, const ViewTile& tile, bool exact,
                                        Compose compose) {
  const TileWorkers::Ticket ticket =
      workers_.start(tile.urgency(),
                     [compose = std::move(compose),
                      colors = color_table_](const std::atomic<bool>& cancelled) -> TileResult {
                       auto pixels = std::make_shared<const Composition>(compose(cancelled));
                       const bool anything = std::any_of(pixels->flags.begin(), pixels->flags.end(),
                                                         [](std::uint8_t flags) { return flags != 0; });
                       if (!anything) return {};
                       QImage image = colors->paint(*pixels);
                       return {std::move(pixels), std::move(image), nullptr};
                     });
  under_way_.emplace(ticket, ViewWork{place, raster_, generation_, colors_revision_, exact});
  return ticket;
}

void TileWork::receive(std::vector<TileWorkers::Outcome> outcomes) {
  for (TileWorkers::Outcome& outcome : outcomes) {
    const auto work = under_way_.find(outcome.ticket);
    if (work == under_way_.end()) {
      if (const auto of_use = pyramid_.take(outcome)) ++(*of_use ? composed_ : dropped_stale_);
      continue;
    }
    take(work->second, outcome);
    under_way_.erase(work);
  }
  proceed();
  changed_();
}

void TileWork::take(const ViewWork& work, TileWorkers::Outcome& outcome) {
  ViewTile* const tile = work.raster == raster_ ? tiles_.find(work.place) : nullptr;
  const bool awaited = tile != nullptr &&
                       (work.exact ? tile->exact_work : tile->preview_work) == outcome.ticket &&
                       !outcome.cancelled;
  if (!awaited) {
    ++dropped_stale_;
    return;
  }
  (work.exact ? tile->exact_work : tile->preview_work) = 0;
  if (work.exact && tile->preview_work != 0) {
    workers_.cancel(tile->preview_work);
    tile->preview_work = 0;
  }
  tiles_.setPicture(*tile, std::move(outcome.result.pixels), std::move(outcome.result.image), work.colors);
  tile->known = true;
  tile->exact = work.exact;
  tile->shown = work.generation;
  ++composed_;
}

QImage TileWork::imageOf(const TilePlace& place) {
  ViewTile* const tile = tiles_.find(place);
  if (tile == nullptr || !tile->picture.pixels) return {};
  if (tile->colors != colors_revision_) {
    tiles_.setPicture(*tile, tile->picture.pixels, color_table_->paint(*tile->picture.pixels),
                      colors_revision_);
  }
  return tile->picture.image;
}

void TileWork::dropStandInsWhenCovered() {
  if (stand_ins_.empty()) return;
  const auto known = [this](const TilePlace& place) {
    const ViewTile* const tile = tiles_.find(place);
    return tile != nullptr && tile->known;
  };
  if (std::all_of(tiles_.visible().begin(), tiles_.visible().end(), known)) stand_ins_.clear();
}

void TileWork::trim() {
  const std::size_t budget = options_.budgets.tiles;
  const auto rest = [&](std::size_t used) { return budget > used ? budget - used : 0; };
  tiles_.trim(rest(pyramid_.bytes()));
  pyramid_.trim(rest(tiles_.bytes()));
}

TileCounts TileWork::counts() const {
  TileCounts counts;
  counts.visible = int(tiles_.visible().size());
  for (const TilePlace& place : tiles_.visible()) {
    const ViewTile* const tile = tiles_.find(place);
    const bool settled = tile != nullptr && tile->settled();
    counts.exact += settled;
    counts.pending += !settled;
    counts.preview += tile != nullptr && tile->known && !settled;
  }
  counts.composed = composed_;
  counts.dropped_stale = dropped_stale_;
  counts.cache_bytes = tiles_.bytes() + pyramid_.bytes() + stand_ins_.bytes();
  counts.dense_bytes = dense_.bytes();
  return counts;
}

bool TileWork::settled() const {
  return std::all_of(tiles_.visible().begin(), tiles_.visible().end(), [this](const TilePlace& place) {
    const ViewTile* const tile = tiles_.find(place);
    return tile != nullptr && tile->settled();
  });
}

}  // namespace mapwright::render
