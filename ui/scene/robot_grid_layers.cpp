// The grids that a robot sends: what it adds to its map, how well that matches, its costmaps. RasterStack
// draws them.
#include <algorithm>
#include <vector>

#include "grids/grid_pyramid.h"
#include "map/live_topics.h"
#include "render/grid_palettes.h"
#include "session/layer_grids.h"
#include "ui/scene/legend.h"
#include "ui/scene/raster_stack.h"

namespace mapwright::ui::scene {
namespace {

using map::GridKind;

/// The colours of some bytes of a palette.
std::vector<QColor> cellColors(const render::GridPalette& palette, std::size_t from, std::size_t to) {
  std::vector<QColor> colors;
  for (std::size_t byte = from; byte <= to; ++byte) colors.push_back(cellColor(palette[byte]));
  return colors;
}

void incrementalLegend(Legend& legend) {
  legend.addCell(LegendText::tr("Free"), QColor(legend.theme().map.incremental_free));
  legend.addCell(LegendText::tr("Occupied"), QColor(legend.theme().map.incremental_occupied));
}

void matchLegend(Legend& legend) {
  legend.addScale(LegendText::tr("differs"), LegendText::tr("matches"),
                  cellColors(render::matchPalette(0), 1, 255));
}

/// The colours depend on how this robot sends its costs: nothing is said before the first have come.
template <GridKind kind>
void costmapLegend(Legend& legend) {
  const session::LayerGrid* const grid =
      legend.session() ? legend.session()->layerGrids().find(kind) : nullptr;
  if (!grid) return;
  const QString low = LegendText::tr("low"), high = LegendText::tr("high cost");
  const QString obstacle = LegendText::tr("Obstacle");
  if (!grid->picture.palette.empty()) {
    const render::GridPalette own = render::ownPalette(grid->picture.palette);
    legend.addScale({}, {}, cellColors(own, 0, std::min<std::size_t>(grid->picture.palette.size(), 256) - 1),
                    LegendText::tr("Colours of the robot"));
  } else if (grid->picture.indices->code() == grids::CellCode::Occupancy) {
    const render::GridPalette palette = render::occupancyCostPalette();
    legend.addScale(low, high, cellColors(palette, 1, 98));
    legend.addCell(LegendText::tr("Too close for the robot's centre"), cellColor(palette[99]));
    legend.addCell(obstacle, cellColor(palette[100]));
  } else {
    const render::GridPalette palette = render::costmapPalette(0);
    legend.addScale(low, high, cellColors(palette, 1, 246));
    legend.addCell(obstacle, cellColor(palette[255]));
  }
}

LayerSpec gridSpec(GridKind grid, const char* name, const char* title, map::Stream stream,
                   void (*legend)(Legend&)) {
  return {.name = name, .title = title, .shown = false, .streams = {stream}, .grid = grid, .legend = legend};
}

template <GridKind kind>
LayerSpec costmapSpec(const char* name, const char* title, map::Stream stream, LayerSets sets) {
  LayerSpec spec = gridSpec(kind, name, title, stream, costmapLegend<kind>);
  spec.group = LayerGroup::Environment;
  spec.sets = sets;
  spec.topic_chosen = true;
  return spec;
}

}  // namespace

render::GridPalette gridPalette(map::GridKind kind, const session::LayerGrid& grid, const MapTheme& theme) {
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

template <>
LayerSpec layerSpec<Layer::Incremental>() {
  LayerSpec spec = gridSpec(GridKind::Incremental, "incremental", QT_TRANSLATE_NOOP("scene", "Incremental"),
                            map::Stream::Incremental, incrementalLegend);
  spec.sets = LayerSet::Mapping;
  return spec;
}

template <>
LayerSpec layerSpec<Layer::EnvMatch>() {
  return gridSpec(GridKind::EnvMatch, "match", QT_TRANSLATE_NOOP("scene", "Match map"), map::Stream::EnvMatch,
                  matchLegend);
}

template <>
LayerSpec layerSpec<Layer::EnvSymmetry>() {
  return gridSpec(GridKind::EnvSymmetry, "symmetry", QT_TRANSLATE_NOOP("scene", "Symmetry map"),
                  map::Stream::EnvSymmetry, matchLegend);
}

template <>
LayerSpec layerSpec<Layer::CostmapLow>() {
  return costmapSpec<GridKind::CostmapLow>("costmap", QT_TRANSLATE_NOOP("scene", "Costmap, global or coarse"),
                                           map::Stream::CostmapLow, LayerSet::Navigation);
}

template <>
LayerSpec layerSpec<Layer::CostmapHigh>() {
  return costmapSpec<GridKind::CostmapHigh>(
      "costmap-high", QT_TRANSLATE_NOOP("scene", "Costmap, local or fine"), map::Stream::CostmapHigh, {});
}

}  // namespace mapwright::ui::scene
