#include "render/tile_renderer.h"

#include <algorithm>
#include <cmath>

namespace mapwright::render {
namespace {

// Up to so many native cells a pixel, view tiles are composed directly.
constexpr double kDirectViewCells = 2;
constexpr int kFewMissing = 8;  // pyramid tiles; with no more missing it is soon exact and needs no preview
constexpr double kFinestNativeM = 1e-3;  // a freak texture does not make the whole view slow
constexpr std::size_t kSubmapStandIns = 64;

RasterTiles::Options tileOptions(const TileRenderer::Options& options) {
  return {std::make_shared<TileBudget>(TileBudget{options.budgets.tiles}), options.workers, options.previews};
}

}  // namespace

TileRenderer::TileRenderer(Options options, QObject* parent)
    : RasterTiles(tileOptions(options), kSubmapStandIns, parent),
      dense_(std::make_shared<DenseCache>(options.budgets.dense)),
      color_table_(std::make_shared<const ColorTable>(colors_, ColorMode::Normal)),
      pyramid_(index_, workers(), dense_) {}

void TileRenderer::upsert(std::vector<PlacedTexture> placed) {
  std::vector<geometry::WorldRect> rects;
  for (PlacedTexture& texture : placed) {
    const auto change = index_.upsert(std::move(texture));
    if (!change) continue;
    if (!change->before.empty()) rects.push_back(change->before);
    if (!change->after.empty() && !(change->after == change->before)) rects.push_back(change->after);
  }
  contentChanged(rects);
}

void TileRenderer::remove(const std::vector<map::SubmapId>& ids) {
  std::vector<geometry::WorldRect> rects;
  for (const map::SubmapId id : ids) {
    if (const auto before = index_.remove(id)) rects.push_back(*before);
  }
  contentChanged(rects);
}

void TileRenderer::contentChanged(const std::vector<geometry::WorldRect>& rects) {
  if (rects.empty()) return;
  nextGeneration();
  if (const auto finest_m = index_.finest(); finest_m && pyramid_.base() == 0) {
    pyramid_.setBase(std::max(*finest_m, kFinestNativeM));
  }
  tiles().touch(rects, generation(), [this](ViewTile& tile) { cancel(tile); });
  pyramid_.invalidate(rects);
  viewChanged();
  changed();
}

void TileRenderer::clear() {
  if (textureCount() == 0) return;
  index_.clear();
  nextGeneration();
  forgetAll();
  pyramid_.clear();
  pyramid_.setBase(0);
  dense_->clear();
  viewChanged();
  changed();
}

void TileRenderer::setColors(const MapColors& colors, ColorMode mode) {
  colors_ = colors;
  color_table_ = std::make_shared<const ColorTable>(colors, mode);
  ++colors_revision_;
  standIns().repaint(*color_table_);
  changed();
}

void TileRenderer::refresh(ViewTile& tile) {
  if (tile.colors == colors_revision_ || !tile.picture.pixels) return;
  tiles().setPicture(tile, tile.picture.pixels, color_table_->paint(*tile.picture.pixels), colors_revision_);
}

bool TileRenderer::usesPyramid() const {
  const auto finest_m = index_.finest();
  return previews() && finest_m &&
         tiles().view().scale_m_per_px > kDirectViewCells * std::max(*finest_m, kFinestNativeM) * (1 + 1e-9);
}

// The level whose pixels are between a half and a quarter of the view's.
int TileRenderer::pyramidLevel() const {
  return int(std::floor(std::log2(tiles().view().scale_m_per_px / pyramid_.base()) + 1e-9)) - 1;
}

/// Empty ground is known without any work.
void TileRenderer::viewChanged() {
  for (const TileKey& key : tiles().visible()) {
    ViewTile& tile = tiles().at(key);
    if (tile.settled() || index_.anyWithin(tiles().gridOf(key).bounds())) continue;
    cancel(tile);
    tiles().setPicture(tile, nullptr, {}, colors_revision_);
    tile.known = tile.exact = true;
    tile.shown = generation();
  }
}

void TileRenderer::startMissing() {
  pyramid_.beginRound();
  const bool from_pyramid = usesPyramid();
  if (from_pyramid) startPreviews();
  for (const TileKey& key : tiles().visible()) {
    if (!workers().hasRoom()) return;
    ViewTile& tile = tiles().at(key);
    if (tile.settled() || tile.exact_work != 0) continue;
    if (!from_pyramid || !startFromPyramid(key, tile)) startComposing(key, tile, Quality::Exact);
  }
}

void TileRenderer::startPreviews() {
  for (const TileKey& key : tiles().visible()) {
    if (!workers().hasRoom()) return;
    ViewTile& tile = tiles().at(key);
    if (tile.current() || tile.preview_work != 0) continue;
    // Old content stays until the new is ready, unless that takes long.
    const bool soon_exact = tile.known && pyramid_.missing(patchFor(tiles().gridOf(key), pyramidLevel(),
                                                                    pyramid_.base())) <= kFewMissing;
    if (!soon_exact) startComposing(key, tile, Quality::Preview);
  }
}

// False if the pyramid cannot provide such a tile at all.
bool TileRenderer::startFromPyramid(const TileKey& key, ViewTile& tile) {
  const PixelGrid grid = tiles().gridOf(key);
  PyramidPatch patch = patchFor(grid, pyramidLevel(), pyramid_.base());
  if (patch.columns == 0) return false;
  if (!pyramid_.request(patch) || !workers().hasRoom()) return true;
  tile.exact_work =
      startWork(key, tile, true, [grid, patch = std::move(patch)](const std::atomic<bool>& cancelled) {
        return resampled(grid, patch, cancelled);
      });
  return true;
}

void TileRenderer::startComposing(const TileKey& key, ViewTile& tile, Quality quality) {
  const PixelGrid grid = tiles().gridOf(key);
  // Reduced levels extend slightly beyond the cells themselves.
  const double margin_m = quality == Quality::Preview ? 2 * grid.scale_m_per_px : 0;
  const bool exact = quality == Quality::Exact;
  (exact ? tile.exact_work : tile.preview_work) =
      startWork(key, tile, exact,
                [grid, quality, textures = index_.within(grid.bounds().grown(margin_m)),
                 dense = dense_](const std::atomic<bool>& cancelled) {
                  return compose(grid, textures, quality, *dense, Kernel::Best, &cancelled);
                });
}

TileWorkers::Ticket TileRenderer::startWork(const TileKey& key, const ViewTile& tile, bool exact,
                                            Compose compose) {
  return start(
      key, tile,
      [compose = std::move(compose),
       colors = color_table_](const std::atomic<bool>& cancelled) -> TileResult {
        auto pixels = std::make_shared<const Composition>(compose(cancelled));
        const bool anything = std::any_of(pixels->flags.begin(), pixels->flags.end(),
                                          [](std::uint16_t flags) { return flags != 0; });
        if (!anything) return {};
        QImage image = colors->paint(*pixels);
        return {std::move(pixels), std::move(image), nullptr};
      },
      exact, colors_revision_);
}

void TileRenderer::onOther(const TileWorkers::Outcome& outcome) {
  if (const auto of_use = pyramid_.onOutcome(outcome)) ++(*of_use ? pyramid_taken_ : pyramid_dropped_);
}

void TileRenderer::keepWithin(std::size_t budget) {
  const auto rest = [&](std::size_t used) { return budget > used ? budget - used : 0; };
  tiles().trim(rest(pyramid_.bytes()));
  pyramid_.trim(rest(tiles().bytes()));
}

std::vector<DrawnTile> TileRenderer::drawnTiles() {
  std::vector<DrawnTile> drawn;
  standIns().draw(tiles().view(), drawn);
  const bool over_stand_ins = !drawn.empty();
  QImage unknown;
  for (const TileKey& key : tiles().visible()) {
    ViewTile* const tile = tiles().find(key);
    if (tile == nullptr || !tile->known) continue;
    const QPointF offset = tiles().offsetOf(key);
    refresh(*tile);
    QImage image = tile->picture.image;
    if (image.isNull()) {
      // It is empty, and has to hide its stand-in.
      if (!over_stand_ins) continue;
      if (!colors_.clear_unknown && unknown.isNull()) {
        unknown = QImage(kTileEdge, kTileEdge, QImage::Format_RGB32);
        unknown.fill(colors_.unknown);
      }
      image = unknown;
    }
    drawn.push_back({std::move(image), QTransform::fromTranslate(offset.x(), offset.y()), false});
  }
  return drawn;
}

TileCounts TileRenderer::counts() const {
  TileCounts counts;
  counts.visible = int(tiles().visible().size());
  for (const TileKey& key : tiles().visible()) {
    const ViewTile* const tile = tiles().find(key);
    const bool settled = tile != nullptr && tile->settled();
    counts.exact += settled;
    counts.pending += !settled;
    counts.preview += tile != nullptr && tile->known && !settled;
  }
  counts.composed = taken() + pyramid_taken_;
  counts.dropped_stale = dropped() + pyramid_dropped_;
  counts.cache_bytes = cacheBytes() + pyramid_.bytes();
  counts.dense_bytes = dense_->bytes();
  return counts;
}

Composition TileRenderer::composition() const {
  const ViewTiles& tiles = this->tiles();
  Composition whole;
  if (tiles.visible().empty()) return whole;
  whole.width_px = tiles.view().width_px;
  whole.height_px = tiles.view().height_px;
  const std::size_t pixels = std::size_t(whole.width_px) * std::size_t(whole.height_px);
  whole.intensity.assign(pixels, 128);
  whole.flags.assign(pixels, 0);
  for (const TileKey& key : tiles.visible()) {
    const ViewTile* const tile = tiles.find(key);
    if (tile == nullptr || !tile->picture.pixels) continue;
    const Composition& part = *tile->picture.pixels;
    const QPointF offset = tiles.offsetOf(key);
    const int left = int(offset.x()), top = int(offset.y());
    const int first = std::max(0, -left), last = std::min(part.width_px, whole.width_px - left);
    for (int row = std::max(0, -top); row < std::min(part.height_px, whole.height_px - top); ++row) {
      const auto from = std::ptrdiff_t(row) * part.width_px + first;
      const auto to = std::ptrdiff_t(top + row) * whole.width_px + left + first;
      std::copy_n(part.intensity.begin() + from, last - first, whole.intensity.begin() + to);
      std::copy_n(part.flags.begin() + from, last - first, whole.flags.begin() + to);
    }
  }
  return whole;
}

std::optional<int> TileRenderer::intensityAt(const Eigen::Vector2d& world_m) const {
  const ViewTiles& tiles = this->tiles();
  const auto pixel = tiles.pixelAt(world_m);
  const ViewTile* const tile = pixel ? tiles.find(pixel->key) : nullptr;
  if (tile == nullptr || !tile->picture.pixels) return std::nullopt;
  const Composition& pixels = *tile->picture.pixels;
  if (pixel->column >= pixels.width_px || pixel->row >= pixels.height_px) return std::nullopt;
  const std::size_t at = std::size_t(pixel->row) * std::size_t(pixels.width_px) + std::size_t(pixel->column);
  if (pixels.flags[at] == 0) return std::nullopt;
  return pixels.intensity[at];
}

}  // namespace mapwright::render

#include "moc_tile_renderer.cpp"
