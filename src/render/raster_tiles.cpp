#include "render/raster_tiles.h"

#include <algorithm>

namespace mapwright::render {

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
      stand_ins_.push(tiles_.pictures(stand_ins_out_of_view_), tiles_.view(), 0);
    }
  }
  tiles_.setView(view);
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
  for (const TilePlace& place : tiles_.visible()) {
    ViewTile* const tile = tiles_.find(place);
    if (!tile || !tile->known) continue;
    const QPointF offset = tiles_.offsetOf(place);
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
  return std::all_of(tiles_.visible().begin(), tiles_.visible().end(), [this](const TilePlace& place) {
    const ViewTile* const tile = tiles_.find(place);
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

TileWorkers::Ticket RasterTiles::start(const TilePlace& place, const ViewTile& tile, TileWorkers::Work work,
                                       bool exact, std::uint64_t colors) {
  const TileWorkers::Ticket ticket = workers_.start(tile.urgency(), std::move(work));
  under_way_[ticket] = {place, raster_, generation_, colors, exact};
  return ticket;
}

void RasterTiles::cancelAll() {
  cancelExact();
  tiles_.forEach([this](ViewTile& tile) {
    if (tile.preview_work != 0) workers_.cancel(tile.preview_work);
    tile.preview_work = 0;
  });
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
  keepWithin(paints ? budget_->bytes : 0);
}

/// What is in view stays all the same.
void RasterTiles::keepWithin(std::size_t budget) {
  budget_->held -= held_;
  tiles_.trim(budget > budget_->held ? budget - budget_->held : 0);
  held_ = tiles_.bytes();
  budget_->held += held_;
}

void RasterTiles::receive(std::vector<TileWorkers::Outcome> outcomes) {
  for (TileWorkers::Outcome& outcome : outcomes) {
    const auto found = under_way_.find(outcome.ticket);
    if (found == under_way_.end()) continue;
    const UnderWay work = found->second;
    under_way_.erase(found);
    ViewTile* const tile = work.raster == raster_ ? tiles_.find(work.place) : nullptr;
    if (!tile || outcome.cancelled) continue;
    if (tile->exact_work != outcome.ticket && tile->preview_work != outcome.ticket) continue;
    (tile->exact_work == outcome.ticket ? tile->exact_work : tile->preview_work) = 0;
    tiles_.setPicture(*tile, std::move(outcome.result.pixels), std::move(outcome.result.image), work.colors);
    tile->known = true;
    tile->exact = work.exact;
    tile->shown = work.generation;
  }
  proceed();
  dropStandInsWhenCovered();
  changed();
}

void RasterTiles::dropStandInsWhenCovered() {
  if (stand_ins_.empty()) return;
  if (std::all_of(tiles_.visible().begin(), tiles_.visible().end(), [this](const TilePlace& place) {
        const ViewTile* const tile = tiles_.find(place);
        return tile && tile->known;
      })) {
    stand_ins_.clear();
  }
}

}  // namespace mapwright::render

#include "moc_raster_tiles.cpp"
