#include "scene/raster_stack.h"

#include <algorithm>
#include <array>

#include "render/grid_palettes.h"

namespace mapwright::scene {
namespace {

using map::GridKind;

constexpr std::array<std::pair<Layer, GridKind>, 5> kGridLayers{
    {{Layer::Incremental, GridKind::Incremental},
     {Layer::EnvMatch, GridKind::EnvMatch},
     {Layer::EnvSymmetry, GridKind::EnvSymmetry},
     {Layer::CostmapLow, GridKind::CostmapLow},
     {Layer::CostmapHigh, GridKind::CostmapHigh}}};

render::GridPalette paletteOf(GridKind kind, const session::LayerGrid& grid, const MapTheme& theme) {
  if (!grid.picture.palette.empty()) return render::ownPalette(grid.picture.palette);
  const grids::GridPyramid& cells = *grid.picture.indices;
  const bool occupancy = cells.code() == grids::CellCode::Occupancy;
  switch (kind) {
    case GridKind::Incremental:
      return render::incrementalPalette(theme.map, cells.code());
    case GridKind::EnvMatch:
    case GridKind::EnvSymmetry:
      return render::matchPalette(render::commonestByte(cells));
    default:
      return occupancy ? render::occupancyCostPalette()
                       : render::costmapPalette(render::commonestByte(cells));
  }
}

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

RasterStack::RasterStack(const LayerContext& context, render::RasterTiles::Options options, QObject* parent)
    : QObject(parent), context_(context), options_(options), theme_(context.theme) {
  whole_ = makeSheet();
  overview_ = makeSheet();
  compared_ = makeSheet();
  difference_ = makeSheet();
  for (const auto& [layer, kind] : kGridLayers) grids_[kind] = makeSheet();
  for (Sheet& sheet : region_sheets_) {
    sheet = makeSheet();
    sheet.renderer->setPalette(regionsPalette(theme_.map));
  }
  for (RasterLayer* item : {compared_.item, difference_.item}) item->setVisible(false);
}

RasterStack::~RasterStack() = default;

RasterStack::Sheet RasterStack::makeSheet() {
  Sheet sheet;
  sheet.renderer = std::make_unique<render::GridRenderer>(options_);
  sheet.item = new RasterLayer(context_, *sheet.renderer);
  connect(sheet.renderer.get(), &render::GridRenderer::tilesChanged, this,
          [item = sheet.item] { item->update(); });
  connect(sheet.renderer.get(), &render::GridRenderer::settledChanged, this, &RasterStack::settledChanged);
  return sheet;
}

std::vector<const RasterStack::Sheet*> RasterStack::sheets() const {
  std::vector<const Sheet*> all{&whole_, &overview_, &compared_, &difference_};
  for (const auto& [kind, sheet] : grids_) all.push_back(&sheet);
  for (const Sheet& sheet : region_sheets_) all.push_back(&sheet);
  return all;
}

std::size_t RasterStack::cacheBytes() const {
  std::size_t bytes = 0;
  for (const Sheet* sheet : sheets()) bytes += sheet->renderer->cacheBytes();
  return bytes;
}

std::vector<RasterLayer*> RasterStack::items() const {
  std::vector<RasterLayer*> all;
  for (const Sheet* sheet : sheets()) all.push_back(sheet->item);
  return all;
}

RasterLayer* RasterStack::item(Layer layer) const {
  if (layer == Layer::WholeMap) return whole_.item;
  for (const auto& [raster, kind] : kGridLayers) {
    if (raster == layer) return grids_.at(kind).item;
  }
  return nullptr;
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
  for (const Sheet* sheet : sheets()) sheet->renderer->setGrid(std::nullopt);
  if (!session_) return;
  using session::MapSlot;
  const auto follow = [this](const MapSlot& slot, Sheet& sheet) {
    connect(&slot, &MapSlot::changed, this, [this, &slot, &sheet] {
      syncSlot(slot, sheet);
      syncDifference();
    });
    connect(&slot, &MapSlot::rowsArrived, this, [this, &sheet] {
      sheet.renderer->rowsArrived();
      difference_.renderer->rowsArrived();
    });
    syncSlot(slot, sheet);
  };
  follow(session_->wholeMap(), whole_);
  follow(session_->overview(), overview_);
  follow(session_->comparedMap(), compared_);
  connect(&session_->layerGrids(), &session::LayerGrids::changed, this, &RasterStack::syncGrid);
  for (const auto& [layer, kind] : kGridLayers) syncGrid(kind);
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

void RasterStack::setEdited(const map::MapKey& map, std::shared_ptr<const grids::GridPyramid> cells) {
  edited_map_ = map;
  edited_ = std::move(cells);
  if (!session_) return;
  syncSlot(session_->wholeMap(), whole_);
  syncDifference();
}

void RasterStack::editedChanged(const geometry::WorldRect& where) {
  whole_.renderer->cellsChanged(where);
  difference_.renderer->cellsChanged(where);
}

void RasterStack::syncSlot(const session::MapSlot& slot, Sheet& sheet) {
  const auto placed = placedOf(slot);
  const bool other = !(sheet.renderer->grid() == placed);
  if (placed) sheet.renderer->setPalette(render::wholeMapPalette(theme_.map, placed->cells->code()));
  sheet.renderer->setGrid(placed);
  if (other) Q_EMIT contentChanged();
}

void RasterStack::syncDifference() {
  const auto first = session_ ? placedOf(session_->wholeMap()) : std::nullopt;
  const auto second = session_ ? placedOf(session_->comparedMap()) : std::nullopt;
  difference_.renderer->setPalette(render::differencePalette(theme_.dark));
  if (first && second) {
    difference_.renderer->setGrid(first, second);
  } else {
    difference_.renderer->setGrid(std::nullopt);
  }
}

void RasterStack::syncGrid(map::GridKind kind) {
  const auto sheet = grids_.find(kind);
  if (sheet == grids_.end()) return;
  const session::LayerGrid* const grid = session_ ? session_->layerGrids().find(kind) : nullptr;
  if (!grid) {
    sheet->second.renderer->setGrid(std::nullopt);
    return;
  }
  sheet->second.renderer->setPalette(paletteOf(kind, *grid, theme_));
  sheet->second.renderer->setGrid(render::PlacedGrid{grid->picture.indices, grid->reference});
}

std::vector<RasterLayer*> RasterStack::regionItems() const {
  std::vector<RasterLayer*> items;
  for (const Sheet& sheet : region_sheets_) items.push_back(sheet.item);
  return items;
}

void RasterStack::setRegions(const regions::RegionMap* map) {
  regions_ = map;
  regionSheetsChanged();
}

void RasterStack::regionSheetsChanged() {
  std::vector<render::PlacedGrid> placed;
  if (regions_) {
    for (const auto& sheet : regions_->regions().sheets()) placed.push_back({sheet, sheet->reference()});
  }
  // Sheets do not overlap: those already drawn stay in their place.
  std::vector<Sheet*> free;
  for (Sheet& sheet : region_sheets_) {
    const auto& shown = sheet.renderer->grid();
    const auto found = shown ? std::find(placed.begin(), placed.end(), *shown) : placed.end();
    if (found == placed.end()) {
      free.push_back(&sheet);
    } else {
      placed.erase(found);
    }
  }
  for (Sheet* sheet : free) {
    if (placed.empty()) {
      sheet->renderer->setGrid(std::nullopt);
      continue;
    }
    sheet->renderer->setGrid(std::move(placed.back()));
    placed.pop_back();
  }
}

void RasterStack::regionCellsChanged(const geometry::WorldRect& where) {
  for (Sheet& sheet : region_sheets_) {
    if (sheet.renderer->grid()) sheet.renderer->cellsChanged(where);
  }
}

geometry::WorldRect RasterStack::regionBounds() const {
  return regions_ ? regions_->regions().reach() : geometry::WorldRect{};
}

std::optional<int> RasterStack::regionOccupancyAt(const Eigen::Vector2d& world_m) const {
  if (!regions_) return std::nullopt;
  const grids::CellMeaning& meaning = grids::meaningOf(grids::CellCode::Occupancy);
  for (const auto& sheet : regions_->regions().sheets()) {
    const Eigen::Vector2d cell = sheet->reference().cellFromWorld(world_m);
    if (!(cell.x() >= 0 && cell.y() >= 0 && cell.x() < sheet->width() && cell.y() < sheet->height()))
      continue;
    const std::uint8_t byte = sheet->at(int(cell.x()), int(cell.y()));
    if (meaning.known[byte]) return meaning.occupancy[byte];
  }
  return std::nullopt;
}

void RasterStack::setTheme(const MapTheme& theme) {
  theme_ = theme;
  for (Sheet& sheet : region_sheets_) sheet.renderer->setPalette(regionsPalette(theme.map));
  if (!session_) return;
  syncSlot(session_->wholeMap(), whole_);
  syncSlot(session_->overview(), overview_);
  syncSlot(session_->comparedMap(), compared_);
  syncDifference();
  for (const auto& [layer, kind] : kGridLayers) syncGrid(kind);
}

void RasterStack::sendView() {
  for (const Sheet* sheet : sheets()) sheet->item->sendView();
}

void RasterStack::syncActive() {
  for (const Sheet* sheet : sheets()) sheet->renderer->setActive(sheet->item->isVisible());
}

bool RasterStack::drawn() const {
  for (const Sheet* sheet : sheets()) {
    if (sheet->item->isVisible() && !sheet->renderer->settled()) return false;
  }
  return true;
}

bool RasterStack::settled() const {
  if (!drawn()) return false;
  if (!session_) return true;
  if (whole_.item->isVisible() && !session_->wholeMap().settled()) return false;
  return !(compared_.item->isVisible() || difference_.item->isVisible()) || session_->comparedMap().settled();
}

geometry::WorldRect RasterStack::wholeBounds() const {
  const auto& placed = whole_.renderer->grid();
  return placed ? placed->reference.bounds() : geometry::WorldRect{};
}

geometry::WorldRect RasterStack::comparedBounds() const {
  const auto& placed = compared_.renderer->grid();
  return placed ? placed->reference.bounds() : geometry::WorldRect{};
}

bool RasterStack::overviewShown() const { return overview_.renderer->grid().has_value(); }

std::optional<render::PlacedGrid> RasterStack::wholeMap() const { return whole_.renderer->grid(); }

std::optional<render::PlacedGrid> RasterStack::comparedMap() const { return compared_.renderer->grid(); }

}  // namespace mapwright::scene

#include "moc_raster_stack.cpp"
