#include "render/grid_renderer.h"

#include <algorithm>

#include "render/stand_ins.h"
#include "render/tile_workers.h"
#include "render/view_tiles.h"

namespace mapwright::render {
namespace {

constexpr std::size_t kStandInsOutOfView = 32;

/// The colour of a mean without one of its own: between those of the known bytes on both sides.
std::uint32_t between(const GridPalette& palette, std::size_t byte) {
  std::size_t below = byte, above = byte;
  while (below > 0 && palette[below] >> 24 == 0) --below;
  while (above < 255 && palette[above] >> 24 == 0) ++above;
  std::uint32_t color = 0;
  for (const int shift : {0, 8, 16, 24}) {
    const double from = palette[below] >> shift & 255, to = palette[above] >> shift & 255;
    const double part = above > below ? double(byte - below) / double(above - below) : 0;
    color |= std::uint32_t(from + (to - from) * part + 0.5) << shift;
  }
  return color;
}

/// RGB32 if everything is opaque: that is drawn several times faster.
QImage paint(const Composition& pixels, const GridPalette& palette) {
  QImage image(pixels.width_px, pixels.height_px, QImage::Format_ARGB32_Premultiplied);
  std::uint32_t all = 0xff000000, any = 0;
  std::size_t at = 0;
  for (int row = 0; row < pixels.height_px; ++row) {
    auto* line = reinterpret_cast<std::uint32_t*>(image.scanLine(row));
    for (int column = 0; column < pixels.width_px; ++column, ++at) {
      const std::uint8_t flags = pixels.flags[at], byte = pixels.intensity[at];
      const std::uint32_t color = !flags ? 0 : (flags & kKnownMean) ? between(palette, byte) : palette[byte];
      line[column] = color;
      all &= color;
      any |= color;
    }
  }
  if (any == 0) return {};
  if (all >> 24 == 0xff) image.reinterpretAsFormat(QImage::Format_RGB32);
  return image;
}

}  // namespace

class GridRenderer::Impl {
 public:
  Impl(GridRenderer& owner, const Options& options)
      : owner_(owner),
        options_(options),
        budget_(options.budget ? options.budget : std::make_shared<TileBudget>()),
        tiles_(!options.previews),
        workers_(work::orOwn(options.workers),
                 [this](std::vector<TileWorkers::Outcome> outcomes) { receive(std::move(outcomes)); }) {
    palette_.fill(0);
  }
  ~Impl() { budget_->held -= held_; }

  void setGrid(std::optional<PlacedGrid> placed, std::optional<PlacedGrid> compared) {
    if (placed == placed_ && compared == compared_) return;
    rows_seen_ = placed && placed->cells ? placed->cells->rowsReady() : 0;
    const bool had = placed_.has_value();
    placed_ = std::move(placed);
    compared_ = std::move(compared);
    ++generation_;
    cancelAll();
    if (!placed_) {
      tiles_.clear();
      tiles_.setView(tiles_.view());
      stand_ins_.clear();
    } else if (had) {
      tiles_.forEach([this](ViewTile& tile) { tile.touched = generation_; });
    }
    changed();
  }

  void rowsArrived() {
    if (!placed_ || !placed_->cells) return;
    const int ready = placed_->cells->rowsReady();
    // One band more above: coarse levels are a band late, and reduced pixels extend over the edge.
    const int from = std::max(0, rows_seen_ - 2 * grids::GridPyramid::kTileEdge);
    rows_seen_ = ready;
    geometry::WorldRect rect;
    for (const double x : {0.0, double(placed_->reference.width)}) {
      for (const double y : {double(from), double(placed_->reference.height)}) {
        rect.extend(placed_->reference.worldFromCell({x, y}));
      }
    }
    ++generation_;
    // Work in progress continues: its tile is better than none, and will be remade.
    tiles_.touch({rect}, generation_, [](ViewTile&) {});
    changed();
  }

  void cellsChanged(const geometry::WorldRect& where) {
    if (!placed_ || where.empty()) return;
    ++generation_;
    // A pixel depends on the cells around it, so it extends over the edge.
    const double margin_m = tiles_.view().scale_m_per_px + placed_->reference.resolution_m;
    tiles_.touch({where.grown(margin_m)}, generation_, [](ViewTile&) {});
    changed();
  }

  void setPalette(const GridPalette& palette) {
    if (palette == palette_) return;
    palette_ = palette;
    ++colors_;
    stand_ins_.clear();
    changed();
  }

  void setView(const geometry::ViewTransform& view) {
    if (tiles_.rasterChanges(view)) {
      ++raster_;
      cancelAll();
      if (options_.previews && placed_ && active_) {
        repaintTiles();
        stand_ins_.push(tiles_.pictures(kStandInsOutOfView), tiles_.view(), 0);
      }
    }
    tiles_.setView(view);
    dropStandInsWhenCovered();
    changed();
  }

  void setActive(bool active) {
    if (active == active_) return;
    active_ = active;
    if (!active_) cancelAll();
    changed();
  }

  Drawing drawing() {
    Drawing drawing;
    if (!placed_) return drawing;
    if (!stand_ins_.empty()) stand_ins_.draw(tiles_.view(), drawing.stand_ins);
    for (const TilePlace& place : tiles_.visible()) {
      ViewTile* const tile = tiles_.find(place);
      if (!tile || !tile->known) continue;
      const QPointF offset = tiles_.offsetOf(place);
      if (!drawing.stand_ins.empty()) {
        drawing.covered += QRect(int(offset.x()), int(offset.y()), kTileEdge, kTileEdge);
      }
      repaintTile(*tile);
      if (tile->picture.image.isNull()) continue;
      drawing.tiles.push_back(
          {tile->picture.image, QTransform::fromTranslate(offset.x(), offset.y()), false});
    }
    return drawing;
  }

  bool settled() const {
    if (!placed_ || !placed_->cells || !active_) return true;
    return std::all_of(tiles_.visible().begin(), tiles_.visible().end(), [this](const TilePlace& place) {
      const ViewTile* const tile = tiles_.find(place);
      return tile && (finishable() ? tile->settled() : tile->current());
    });
  }

  std::size_t cacheBytes() const { return tiles_.bytes() + stand_ins_.bytes(); }
  const std::optional<PlacedGrid>& placed() const { return placed_; }

 private:
  struct Work {
    TilePlace place;
    std::uint64_t raster = 0, generation = 0, colors = 0;
    bool exact = false;
  };

  void changed() {
    if (announced_) return;
    announced_ = true;
    QMetaObject::invokeMethod(
        &owner_,
        [this] {
          announced_ = false;
          proceed();
          const bool settled_now = settled();
          const bool flipped = settled_now != was_settled_;
          was_settled_ = settled_now;
          Q_EMIT owner_.tilesChanged();
          if (flipped) Q_EMIT owner_.settledChanged();
        },
        Qt::QueuedConnection);
  }

  /// First a preview of every tile, then the exact ones.
  void proceed() {
    if (!placed_ || !placed_->cells || !active_) {
      keepWithin(0);
      return;
    }
    bool all_seen = true;
    if (options_.previews) {
      for (const TilePlace& place : tiles_.visible()) {
        ViewTile& tile = tiles_.at(place);
        if (tile.current() || tile.preview_work != 0) continue;
        all_seen = false;
        if (!workers_.hasRoom()) {
          makeRoom();
          break;
        }
        tile.preview_work = start(place, tile, Sampling::Quick);
      }
    }
    if (all_seen && finishable()) {
      for (const TilePlace& place : tiles_.visible()) {
        if (!workers_.hasRoom()) break;
        ViewTile& tile = tiles_.at(place);
        if (!tile.settled() && tile.exact_work == 0 && tile.preview_work == 0) {
          tile.exact_work = start(place, tile, Sampling::Exact);
        }
      }
    }
    keepWithin(budget_->bytes);
  }

  /// Visible tiles stay in any case.
  void keepWithin(std::size_t budget) {
    budget_->held -= held_;
    tiles_.trim(budget > budget_->held ? budget - budget_->held : 0);
    held_ = tiles_.bytes();
    budget_->held += held_;
  }

  /// While a window's map is still being read, every tile would be made exact several times.
  bool finishable() const {
    return !options_.previews ||
           (placed_->cells->complete() && (!compared_ || !compared_->cells || compared_->cells->complete()));
  }

  /// Missing tiles come before improvements.
  void makeRoom() {
    tiles_.forEach([this](ViewTile& tile) {
      if (tile.exact_work != 0) workers_.cancel(tile.exact_work);
      tile.exact_work = 0;
    });
  }

  TileWorkers::Ticket start(const TilePlace& place, const ViewTile& tile, Sampling sampling) {
    const PixelGrid grid = tiles_.gridOf(place);
    const bool exact = sampling == Sampling::Exact || (finishable() && quickIsExact(grid, *placed_) &&
                                                       (!compared_ || quickIsExact(grid, *compared_)));
    const auto ticket = workers_.start(
        tile.urgency(),
        [grid, sampling, first = *placed_, second = compared_,
         palette = palette_](const std::atomic<bool>& cancelled) -> TileResult {
          Composition pixels = second ? compareGrids(grid, first, *second, &cancelled, sampling)
                                      : sampleGrid(grid, first, &cancelled, sampling);
          if (pixels.width_px == 0) return {};
          QImage image = paint(pixels, palette);
          return {std::make_shared<const Composition>(std::move(pixels)), std::move(image), nullptr};
        });
    under_way_[ticket] = {place, raster_, generation_, colors_, exact};
    return ticket;
  }

  void receive(std::vector<TileWorkers::Outcome> outcomes) {
    for (TileWorkers::Outcome& outcome : outcomes) {
      const auto found = under_way_.find(outcome.ticket);
      if (found == under_way_.end()) continue;
      const Work work = found->second;
      under_way_.erase(found);
      ViewTile* const tile = work.raster == raster_ ? tiles_.find(work.place) : nullptr;
      if (!tile || outcome.cancelled) continue;
      if (tile->exact_work != outcome.ticket && tile->preview_work != outcome.ticket) continue;
      (tile->exact_work == outcome.ticket ? tile->exact_work : tile->preview_work) = 0;
      tiles_.setPicture(*tile, std::move(outcome.result.pixels), std::move(outcome.result.image),
                        work.colors);
      tile->known = true;
      tile->exact = work.exact;
      tile->shown = work.generation;
    }
    proceed();
    dropStandInsWhenCovered();
    changed();
  }

  void repaintTile(ViewTile& tile) {
    if (tile.colors == colors_ || !tile.picture.pixels) return;
    tiles_.setPicture(tile, tile.picture.pixels, paint(*tile.picture.pixels, palette_), colors_);
  }
  void repaintTiles() {
    tiles_.forEach([this](ViewTile& tile) { repaintTile(tile); });
  }

  void cancelAll() {
    tiles_.forEach([this](ViewTile& tile) {
      for (TileWorkers::Ticket* const work : {&tile.exact_work, &tile.preview_work}) {
        if (*work != 0) workers_.cancel(*work);
        *work = 0;
      }
    });
  }

  void dropStandInsWhenCovered() {
    if (stand_ins_.empty()) return;
    if (std::all_of(tiles_.visible().begin(), tiles_.visible().end(), [this](const TilePlace& place) {
          const ViewTile* const tile = tiles_.find(place);
          return tile && tile->known;
        })) {
      stand_ins_.clear();
    }
  }

  GridRenderer& owner_;
  Options options_;
  std::shared_ptr<TileBudget> budget_;
  std::size_t held_ = 0;  // of it
  std::optional<PlacedGrid> placed_, compared_;
  GridPalette palette_;
  ViewTiles tiles_;
  StandIns stand_ins_;
  bool active_ = true, announced_ = false, was_settled_ = true;
  int rows_seen_ = 0;
  std::uint64_t raster_ = 0, generation_ = 1, colors_ = 1;
  std::unordered_map<TileWorkers::Ticket, Work> under_way_;
  TileWorkers workers_;  // last member: its destructor waits for its work
};

GridRenderer::GridRenderer(Options options, QObject* parent)
    : QObject(parent), impl_(std::make_unique<Impl>(*this, options)) {}

GridRenderer::~GridRenderer() = default;

void GridRenderer::setGrid(std::optional<PlacedGrid> placed, std::optional<PlacedGrid> compared) {
  impl_->setGrid(std::move(placed), std::move(compared));
}
const std::optional<PlacedGrid>& GridRenderer::grid() const { return impl_->placed(); }
void GridRenderer::rowsArrived() { impl_->rowsArrived(); }
void GridRenderer::cellsChanged(const geometry::WorldRect& where) { impl_->cellsChanged(where); }
void GridRenderer::setPalette(const GridPalette& palette) { impl_->setPalette(palette); }
void GridRenderer::setView(const geometry::ViewTransform& view) { impl_->setView(view); }
void GridRenderer::setActive(bool active) { impl_->setActive(active); }
GridRenderer::Drawing GridRenderer::drawing() { return impl_->drawing(); }
bool GridRenderer::settled() const { return impl_->settled(); }
std::size_t GridRenderer::cacheBytes() const { return impl_->cacheBytes(); }

}  // namespace mapwright::render

#include "moc_grid_renderer.cpp"
