#include "scene/raster_stack.h"

#include <algorithm>
#include <array>

#include <QCoreApplication>

#include "render/grid_palettes.h"
#include "robot/robot.h"
#include "scene/legend.h"
#include "sentences/absence_sentence.h"

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

class RasterLegendText {
  Q_DECLARE_TR_FUNCTIONS(RasterLegend)
};

/// The colours of some bytes of a palette.
std::vector<QColor> cellColors(const render::GridPalette& palette, std::size_t from, std::size_t to) {
  std::vector<QColor> colors;
  for (std::size_t byte = from; byte <= to; ++byte) colors.push_back(cellColor(palette[byte]));
  return colors;
}

void incrementalLegend(Legend& legend) {
  legend.addCell(RasterLegendText::tr("Free"), QColor(legend.theme().map.incremental_free));
  legend.addCell(RasterLegendText::tr("Occupied"), QColor(legend.theme().map.incremental_occupied));
}

void matchLegend(Legend& legend) {
  legend.addScale(RasterLegendText::tr("differs"), RasterLegendText::tr("matches"),
                  cellColors(render::matchPalette(0), 1, 255));
}

/// The colours depend on how this robot sends its costs: nothing is said before the first have come.
template <GridKind kind>
void costmapLegend(Legend& legend) {
  const session::LayerGrid* const grid =
      legend.session() ? legend.session()->layerGrids().find(kind) : nullptr;
  if (!grid) return;
  const QString low = RasterLegendText::tr("low"), high = RasterLegendText::tr("high cost");
  const QString obstacle = RasterLegendText::tr("Obstacle");
  if (!grid->picture.palette.empty()) {
    const render::GridPalette own = render::ownPalette(grid->picture.palette);
    legend.addScale({}, {}, cellColors(own, 0, std::min<std::size_t>(grid->picture.palette.size(), 256) - 1),
                    RasterLegendText::tr("Colours of the robot"));
  } else if (grid->picture.indices->code() == grids::CellCode::Occupancy) {
    const render::GridPalette palette = render::occupancyCostPalette();
    legend.addScale(low, high, cellColors(palette, 1, 98));
    legend.addCell(RasterLegendText::tr("Too close for the robot's centre"), cellColor(palette[99]));
    legend.addCell(obstacle, cellColor(palette[100]));
  } else {
    const render::GridPalette palette = render::costmapPalette(0);
    legend.addScale(low, high, cellColors(palette, 1, 246));
    legend.addCell(obstacle, cellColor(palette[255]));
  }
}

LayerSpec costmapSpec(const char* name, const char* title, map::Stream stream, void (*legend)(Legend&)) {
  return {.name = name,
          .title = title,
          .group = LayerGroup::Environment,
          .shown = false,
          .streams = {stream},
          .topic_chosen = true,
          .legend = legend};
}

LayerSpec gridSpec(const char* name, const char* title, map::Stream stream, void (*legend)(Legend&)) {
  return {.name = name, .title = title, .shown = false, .streams = {stream}, .legend = legend};
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
  for (const auto& [layer, kind] : kGridLayers) grids_[kind] = new RasterLayer(context);
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
  for (const auto& [raster, kind] : kGridLayers) {
    if (raster == layer) return {grids_.at(kind)};
  }
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
    });
    connect(&slot, &MapSlot::rowsArrived, this, [this, &raster] {
      raster.renderer().rowsArrived();
      difference_->renderer().rowsArrived();
    });
    syncSlot(slot, raster);
  };
  follow(session_->wholeMap(), *whole_);
  follow(session_->overview(), *overview_);
  follow(session_->comparedMap(), *compared_);
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

void RasterStack::setReference(std::optional<render::PlacedGrid> placed) {
  if (placed)
    reference_->renderer().setPalette(render::wholeMapPalette(context_.theme.map, placed->cells->code()));
  reference_->renderer().setGrid(std::move(placed));
}

void RasterStack::setEdited(const map::MapKey& map, std::shared_ptr<const grids::GridPyramid> cells) {
  edited_map_ = map;
  edited_ = std::move(cells);
  if (!session_) return;
  syncSlot(session_->wholeMap(), *whole_);
  syncDifference();
}

void RasterStack::editedChanged(const geometry::WorldRect& where) {
  whole_->renderer().cellsChanged(where);
  difference_->renderer().cellsChanged(where);
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
  renderer.setPalette(paletteOf(kind, *grid, context_.theme));
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
  setReference(reference_->grid());
  if (!session_) return;
  syncSlot(session_->wholeMap(), *whole_);
  syncSlot(session_->overview(), *overview_);
  syncSlot(session_->comparedMap(), *compared_);
  syncDifference();
  for (const auto& [layer, kind] : kGridLayers) syncGrid(kind);
}

bool RasterStack::read() const {
  if (!session_) return true;
  if (whole_->isVisible() && !session_->wholeMap().settled()) return false;
  return !(compared_->isVisible() || difference_->isVisible()) || session_->comparedMap().settled();
}

template <>
LayerSpec layerSpec<Layer::Reference>() {
  return {.name = "reference",
          .title = QT_TRANSLATE_NOOP("scene", "Reference map"),
          .follows_robot = false,
          .in_all = false,  // it lies in the window alone
          .why_empty = neverEmpty};
}

template <>
LayerSpec layerSpec<Layer::WholeMap>() {
  return {.name = "whole",
          .title = QT_TRANSLATE_NOOP("scene", "Whole map"),
          .shown = false,
          .streams = {map::Stream::WholeMap},
          .follows_robot = false,
          .topic_chosen = true,
          .in_all = false,  // --mode decides about it
          .traits =
              [] {
                return LayerTraits{.choice_title = QCoreApplication::translate("scene", "Zoomed out"),
                                   .choices = {QCoreApplication::translate("scene", "Occupied wins"),
                                               QCoreApplication::translate("scene", "Average")}};
              },
          .why_empty =
              [](robot::Robot& robot) {
                return robot.wholeMapSource() || robot.liveTopics()
                           ? QString()
                           : sentences::absenceReason(robot::Capability::WholeMaps,
                                                      robot.unavailableReason(robot::Capability::WholeMaps));
              },
          .legend = [](Legend& legend) { addCells(legend, legend.theme().map); }};
}

template <>
LayerSpec layerSpec<Layer::Incremental>() {
  return gridSpec("incremental", QT_TRANSLATE_NOOP("scene", "Incremental"), map::Stream::Incremental,
                  incrementalLegend);
}

template <>
LayerSpec layerSpec<Layer::EnvMatch>() {
  return gridSpec("match", QT_TRANSLATE_NOOP("scene", "Match map"), map::Stream::EnvMatch, matchLegend);
}

template <>
LayerSpec layerSpec<Layer::EnvSymmetry>() {
  return gridSpec("symmetry", QT_TRANSLATE_NOOP("scene", "Symmetry map"), map::Stream::EnvSymmetry,
                  matchLegend);
}

template <>
LayerSpec layerSpec<Layer::CostmapLow>() {
  return costmapSpec("costmap", QT_TRANSLATE_NOOP("scene", "Costmap, global or coarse"),
                     map::Stream::CostmapLow, costmapLegend<GridKind::CostmapLow>);
}

template <>
LayerSpec layerSpec<Layer::CostmapHigh>() {
  return costmapSpec("costmap-high", QT_TRANSLATE_NOOP("scene", "Costmap, local or fine"),
                     map::Stream::CostmapHigh, costmapLegend<GridKind::CostmapHigh>);
}

}  // namespace mapwright::scene

#include "moc_raster_stack.cpp"
