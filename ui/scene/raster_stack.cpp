#include "ui/scene/raster_stack.h"

#include <algorithm>

#include "grids/grid_pyramid.h"
#include "regions/region_sheet.h"
#include "render/grid_palettes.h"
#include "render/tile_renderer.h"
#include "session/layer_grids.h"

namespace mapwright::ui::scene {
namespace {

/// Like a whole map, but unknown cells are opaque: they must differ from what was not fetched.
render::GridPalette regionsPalette(const render::MapColors& colors) {
  render::GridPalette palette = render::wholeMapPalette(colors, grids::CellCode::Occupancy);
  const grids::CellMeaning& meaning = grids::meaningOf(grids::CellCode::Occupancy);
  for (std::size_t byte = 0; byte < palette.size(); ++byte) {
    if (!meaning.known[byte]) palette[byte] = byte == regions::kNotFetched ? 0 : colors.unknown;
  }
  return palette;
}

}  // namespace

RasterLayer::RasterLayer(const LayerContext& context) : DeviceLayer(context), renderer_(context.rasters) {
  QObject::connect(&renderer_, &render::GridRenderer::tilesChanged, &renderer_, [this] { update(); });
  QObject::connect(&renderer_, &render::GridRenderer::settledChanged, &renderer_, context.settled_changed);
}

geometry::WorldRect RasterLayer::gridBounds() const {
  return grid() ? grid()->reference.bounds() : geometry::WorldRect{};
}

void RasterLayer::paintPixels(QPainter& painter, const QRectF& exposed) {
  if (faint_) painter.setOpacity(painter.opacity() / 2);
  drawRaster(painter, exposed, renderer_.drawing());
}

RasterStack::RasterStack(const LayerContext& context)
    : context_(context),
      reference_(new RasterLayer(context)),
      whole_(new RasterLayer(context)),
      overview_(new RasterLayer(context)),
      compared_(new RasterLayer(context)),
      difference_(new RasterLayer(context)) {
  for (const Layer layer : allLayers()) {
    if (const auto kind = specOf(layer).grid) grids_[*kind] = new RasterLayer(context);
  }
  for (RasterLayer*& sheet : region_sheets_) {
    sheet = new RasterLayer(context);
    sheet->renderer().setPalette(regionsPalette(context.theme.map));
  }
  for (RasterLayer* item : {compared_, difference_}) item->setVisible(false);
}

std::vector<RasterLayer*> RasterStack::itemsOf(Layer layer) const {
  if (layer == Layer::Reference) return {reference_};
  if (layer == Layer::WholeMap) return {whole_};
  if (layer == Layer::Regions) return {region_sheets_.begin(), region_sheets_.end()};
  if (const auto kind = specOf(layer).grid) return {grids_.at(*kind)};
  return {};
}

void RasterStack::setSession(session::Session* session) {
  if (session_) {
    for (const QObject* source : {static_cast<const QObject*>(&session_->wholeMap()),
                                  static_cast<const QObject*>(&session_->overview()),
                                  static_cast<const QObject*>(&session_->comparedMap()),
                                  static_cast<const QObject*>(&session_->layerGrids())}) {
      disconnect(source, nullptr, this, nullptr);
    }
  }
  session_ = session;
  syncReference();
  for (RasterLayer* raster : {whole_, overview_, compared_, difference_})
    raster->renderer().setGrid(std::nullopt);
  for (const auto& [kind, raster] : grids_) raster->renderer().setGrid(std::nullopt);
  for (RasterLayer* sheet : region_sheets_) sheet->renderer().setGrid(std::nullopt);
  if (!session_) return;
  using session::MapSlot;
  const auto follow = [this](const MapSlot& slot, RasterLayer& raster) {
    connect(&slot, &MapSlot::changed, this, [this, &slot, &raster] {
      syncSlot(slot, raster);
      syncDifference();
      if (reference_differences_) syncReference();
    });
    connect(&slot, &MapSlot::rowsArrived, this, [this, &raster] {
      raster.renderer().rowsArrived();
      difference_->renderer().rowsArrived();
      if (reference_differences_) reference_->renderer().rowsArrived();
    });
    syncSlot(slot, raster);
  };
  follow(session_->wholeMap(), *whole_);
  follow(session_->overview(), *overview_);
  follow(session_->comparedMap(), *compared_);
  connect(&session_->layerGrids(), &session::LayerGrids::changed, this, &RasterStack::syncGrid);
  for (const auto& [kind, raster] : grids_) syncGrid(kind);
  syncDifference();
}

std::optional<render::PlacedGrid> RasterStack::placedOf(const session::MapSlot& slot) const {
  if (!slot.cells()) return std::nullopt;
  const grids::GridPyramid& cells = *slot.cells();
  const bool edited = edited_ && &slot == &session_->wholeMap() && slot.shown().key == edited_map_ &&
                      edited_->width() == cells.width() && edited_->height() == cells.height() &&
                      edited_->code() == cells.code();
  return render::PlacedGrid{edited ? edited_ : slot.cells(), slot.reference()};
}

void RasterStack::setReference(std::optional<render::PlacedGrid> placed) {
  laid_ = std::move(placed);
  syncReference();
}

void RasterStack::setReferenceAbove(bool above) {
  reference_above_ = above;
  syncReference();
}

void RasterStack::setReferenceDifferences(bool shown) {
  reference_differences_ = shown;
  syncReference();
}

void RasterStack::syncReference() {
  render::GridRenderer& renderer = reference_->renderer();
  const auto whole =
      reference_differences_ && laid_ && session_ ? placedOf(session_->wholeMap()) : std::nullopt;
  // The colours of differences say nothing when the map shines through.
  reference_->setFaint(reference_above_ && !whole);
  if (whole) {
    renderer.setPalette(render::differencePalette(context_.theme.dark));
  } else if (laid_) {
    renderer.setPalette(render::wholeMapPalette(context_.theme.map, laid_->cells->code()));
  }
  renderer.setGrid(laid_, whole);
}

void RasterStack::setEdited(const map::MapKey& map, std::shared_ptr<const grids::GridPyramid> cells) {
  edited_map_ = map;
  edited_ = std::move(cells);
  if (!session_) return;
  syncSlot(session_->wholeMap(), *whole_);
  syncDifference();
  if (reference_differences_) syncReference();
}

void RasterStack::editedChanged(const geometry::WorldRect& where) {
  whole_->renderer().cellsChanged(where);
  difference_->renderer().cellsChanged(where);
  if (reference_differences_) reference_->renderer().cellsChanged(where);
}

void RasterStack::syncSlot(const session::MapSlot& slot, RasterLayer& raster) {
  const auto placed = placedOf(slot);
  const bool other = !(raster.grid() == placed);
  if (placed)
    raster.renderer().setPalette(render::wholeMapPalette(context_.theme.map, placed->cells->code()));
  raster.renderer().setGrid(placed);
  if (other) Q_EMIT contentChanged();
}

void RasterStack::syncDifference() {
  auto first = session_ ? placedOf(session_->wholeMap()) : std::nullopt;
  auto second = session_ ? placedOf(session_->comparedMap()) : std::nullopt;
  // What is new or gone is so against the state before.
  if (session_ && session_->comparedMap().showsEarlierState()) std::swap(first, second);
  difference_->renderer().setPalette(render::differencePalette(context_.theme.dark));
  if (first && second) {
    difference_->renderer().setGrid(first, second);
  } else {
    difference_->renderer().setGrid(std::nullopt);
  }
}

void RasterStack::syncGrid(map::GridKind kind) {
  const auto raster = grids_.find(kind);
  if (raster == grids_.end()) return;
  render::GridRenderer& renderer = raster->second->renderer();
  const session::LayerGrid* const grid = session_ ? session_->layerGrids().find(kind) : nullptr;
  if (!grid) return renderer.setGrid(std::nullopt);
  renderer.setPalette(gridPalette(kind, *grid, context_.theme));
  renderer.setGrid(render::PlacedGrid{grid->picture.indices, grid->reference});
}

void RasterStack::regionSheetsChanged() {
  std::vector<render::PlacedGrid> placed;
  if (context_.regions) {
    for (const auto& sheet : context_.regions->regions().sheets())
      placed.push_back({sheet, sheet->reference()});
  }
  // Sheets do not overlap: those already drawn stay in their place.
  std::vector<RasterLayer*> free;
  for (RasterLayer* sheet : region_sheets_) {
    const auto& shown = sheet->grid();
    const auto found = shown ? std::find(placed.begin(), placed.end(), *shown) : placed.end();
    if (found == placed.end()) {
      free.push_back(sheet);
    } else {
      placed.erase(found);
    }
  }
  for (RasterLayer* sheet : free) {
    if (placed.empty()) {
      sheet->renderer().setGrid(std::nullopt);
      continue;
    }
    sheet->renderer().setGrid(std::move(placed.back()));
    placed.pop_back();
  }
}

void RasterStack::regionCellsChanged(const geometry::WorldRect& where) {
  for (RasterLayer* sheet : region_sheets_) {
    if (sheet->grid()) sheet->renderer().cellsChanged(where);
  }
}

geometry::WorldRect RasterStack::regionBounds() const {
  return context_.regions ? context_.regions->regions().reach() : geometry::WorldRect{};
}

std::optional<int> RasterStack::regionOccupancyAt(const Eigen::Vector2d& world_m) const {
  if (!context_.regions) return std::nullopt;
  const grids::CellMeaning& meaning = grids::meaningOf(grids::CellCode::Occupancy);
  for (const auto& sheet : context_.regions->regions().sheets()) {
    const Eigen::Vector2d cell = sheet->reference().cellFromWorld(world_m);
    if (!(cell.x() >= 0 && cell.y() >= 0 && cell.x() < sheet->width() && cell.y() < sheet->height()))
      continue;
    const std::uint8_t byte = sheet->at(int(cell.x()), int(cell.y()));
    if (meaning.known[byte]) return meaning.occupancy[byte];
  }
  return std::nullopt;
}

void RasterStack::themeChanged() {
  for (RasterLayer* sheet : region_sheets_) sheet->renderer().setPalette(regionsPalette(context_.theme.map));
  syncReference();
  if (!session_) return;
  syncSlot(session_->wholeMap(), *whole_);
  syncSlot(session_->overview(), *overview_);
  syncSlot(session_->comparedMap(), *compared_);
  syncDifference();
  for (const auto& [kind, raster] : grids_) syncGrid(kind);
}

bool RasterStack::read() const {
  if (!session_) return true;
  if (whole_->isVisible() && !session_->wholeMap().settled()) return false;
  return !(compared_->isVisible() || difference_->isVisible()) || session_->comparedMap().settled();
}

}  // namespace mapwright::ui::scene

#include "moc_raster_stack.cpp"
