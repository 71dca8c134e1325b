#include "render/raster_tiles.h"

#include <algorithm>

namespace mapwright::render {
namespace {

constexpr std::size_t kPaintedStandIns = 32;

}  // namespace

RasterTiles::RasterTiles(Options options, std::size_t stand_ins_out_of_view, QObject* parent)
    : QObject(parent),
      options_(options),
      stand_ins_out_of_view_(stand_ins_out_of_view),
      budget_(options.budget ? options.budget : std::make_shared<TileBudget>()),
      tiles_(!options.previews),
      workers_(work::orOwn(options.workers),
               [this](std::vector<TileWorkers::Outcome> outcomes) { receive(std::move(outcomes)); }) {}

RasterTiles::~RasterTiles() { budget_->held -= held_; }

void RasterTiles::setView(const geometry::ViewTransform& view) {
  if (tiles_.rasterChanges(view)) {
    ++raster_;
    cancelAll();
    if (options_.previews && hasContent() && active_) {
      tiles_.forEach([this](ViewTile& tile) { refresh(tile); });
      stand_ins_.push(tiles_.pictures(stand_ins_out_of_view_), tiles_.view(), background());
    }
  }
  tiles_.setView(view);
  viewChanged();
  dropStandInsWhenCovered();
  changed();
}

void RasterTiles::setActive(bool active) {
  if (active == active_) return;
  active_ = active;
  if (!active_) cancelAll();
  changed();
}

RasterTiles::Drawing RasterTiles::drawing() {
  Drawing drawing;
  if (!hasContent()) return drawing;
  if (!stand_ins_.empty()) stand_ins_.draw(tiles_.view(), drawing.stand_ins);
  for (const TileKey& key : tiles_.visible()) {
    ViewTile* const tile = tiles_.find(key);
    if (!tile || !tile->known) continue;
    const QPointF offset = tiles_.offsetOf(key);
    if (!drawing.stand_ins.empty()) {
      drawing.covered += QRect(int(offset.x()), int(offset.y()), kTileEdge, kTileEdge);
    }
    refresh(*tile);
    if (tile->picture.image.isNull()) continue;
    drawing.tiles.push_back({tile->picture.image, QTransform::fromTranslate(offset.x(), offset.y()), false});
  }
  return drawing;
}

bool RasterTiles::settled() const {
  if (!paintable() || !active_) return true;
  return std::all_of(tiles_.visible().begin(), tiles_.visible().end(), [this](const TileKey& key) {
    const ViewTile* const tile = tiles_.find(key);
    return tile && settled(*tile);
  });
}

void RasterTiles::outdateAll() {
  tiles_.forEach([this](ViewTile& tile) { tile.touched = generation_; });
}

void RasterTiles::forgetAll() {
  cancelAll();
  tiles_.clear();
  tiles_.setView(tiles_.view());
  stand_ins_.clear();
}

void RasterTiles::changed() {
  if (announced_) return;
  announced_ = true;
  QMetaObject::invokeMethod(
      this,
      [this] {
        announced_ = false;
        proceed();
        const bool settled_now = settled();
        const bool flipped = settled_now != was_settled_;
        was_settled_ = settled_now;
        Q_EMIT tilesChanged();
        if (flipped) Q_EMIT settledChanged();
      },
      Qt::QueuedConnection);
}

TileWorkers::Ticket RasterTiles::start(const TileKey& key, const ViewTile& tile, TileWorkers::Work work,
                                       bool exact, std::uint64_t colors) {
  const TileWorkers::Ticket ticket = workers_.start(tile.urgency(), std::move(work));
  in_progress_[ticket] = {key, raster_, generation_, colors, exact};
  return ticket;
}

void RasterTiles::cancel(ViewTile& tile) {
  for (TileWorkers::Ticket* const ticket : {&tile.exact_work, &tile.preview_work}) {
    if (*ticket != 0) workers_.cancel(*ticket);
    *ticket = 0;
  }
}

void RasterTiles::cancelAll() {
  tiles_.forEach([this](ViewTile& tile) { cancel(tile); });
}

void RasterTiles::cancelExact() {
  tiles_.forEach([this](ViewTile& tile) {
    if (tile.exact_work != 0) workers_.cancel(tile.exact_work);
    tile.exact_work = 0;
  });
}

void RasterTiles::proceed() {
  const bool paints = paintable() && active_;
  if (paints) startMissing();
  dropStandInsWhenCovered();
  keepWithin(paints ? budget_->bytes : 0);
}

void RasterTiles::keepWithin(std::size_t budget) {
  budget_->held -= held_;
  tiles_.trim(budget > budget_->held ? budget - budget_->held : 0);
  held_ = tiles_.bytes();
  budget_->held += held_;
}

void RasterTiles::receive(std::vector<TileWorkers::Outcome> outcomes) {
  for (TileWorkers::Outcome& outcome : outcomes) {
    const auto found = in_progress_.find(outcome.ticket);
    if (found == in_progress_.end()) {
      onOther(outcome);
      continue;
    }
    const WorkInProgress work = found->second;
    in_progress_.erase(found);
    ViewTile* const tile = work.raster == raster_ ? tiles_.find(work.key) : nullptr;
    const bool awaited = tile && !outcome.cancelled &&
                         (tile->exact_work == outcome.ticket || tile->preview_work == outcome.ticket);
    ++(awaited ? taken_ : dropped_);
    if (!awaited) continue;
    (tile->exact_work == outcome.ticket ? tile->exact_work : tile->preview_work) = 0;
    if (work.exact && work.generation >= tile->touched) cancel(*tile);  // no preview is needed any more
    tiles_.setPicture(*tile, std::move(outcome.result.pixels), std::move(outcome.result.image), work.colors);
    tile->known = true;
    tile->exact = work.exact;
    tile->shown = work.generation;
  }
  proceed();
  changed();
}

void RasterTiles::dropStandInsWhenCovered() {
  if (stand_ins_.empty()) return;
  if (std::all_of(tiles_.visible().begin(), tiles_.visible().end(), [this](const TileKey& key) {
        const ViewTile* const tile = tiles_.find(key);
        return tile && tile->known;
      })) {
    stand_ins_.clear();
  }
}

PaintedTiles::PaintedTiles(Options options, QObject* parent)
    : RasterTiles(std::move(options), kPaintedStandIns, parent) {}

void PaintedTiles::setPainter(TilePainter painter) {
  if (!painter && !painter_) return;
  painter_ = painter ? std::make_shared<const TilePainter>(std::move(painter)) : nullptr;
  nextGeneration();
  if (!painter_) {
    forgetAll();
  } else {
    outdateAll();
  }
  changed();
}

void PaintedTiles::startMissing() {
  for (const TileKey& key : tiles().visible()) {
    if (!workers().hasRoom()) break;
    ViewTile& tile = tiles().at(key);
    if (tile.current() || tile.exact_work != 0) continue;
    const auto work = [grid = tiles().gridOf(key),
                       painter = painter_](const std::atomic<bool>& cancelled) -> TileResult {
      return {nullptr, (*painter)(grid, cancelled), nullptr};
    };
    tile.exact_work = start(key, tile, work, true);
  }
}

}  // namespace mapwright::render

#include "moc_raster_tiles.cpp"
