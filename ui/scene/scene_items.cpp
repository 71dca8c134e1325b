#include "scene/scene_items.h"

#include <algorithm>
#include <cmath>

#include <QGraphicsScene>

namespace mapwright::scene {
namespace {

render::GridRenderer::Options rasterOptions(const render::TileRenderer::Options& options) {
  render::GridRenderer::Options raster_options;
  raster_options.previews = options.previews;
  raster_options.threads = options.threads;
  return raster_options;
}

}  // namespace

template <typename Item>
Item* SceneItems::add(QGraphicsScene& scene, Item* item) {
  scene.addItem(item);
  all.push_back(item);
  return item;
}
template <typename Item>
Item* SceneItems::add(QGraphicsScene& scene, Layer layer, Item* item) {
  items[layer] = item;
  return add(scene, item);
}

SceneItems::SceneItems(QGraphicsScene& scene, render::TileRenderer& renderer,
                       const render::TileRenderer::Options& options)
    : order(allLayers()), raster(context, rasterOptions(options), nullptr) {
  context.live = &nothing_live;
  context.labels = &labels;
  tiles = add(scene, Layer::Submaps, new TileLayer(context, renderer));
  for (const Layer layer : allLayers()) {
    if (RasterLayer* item = raster.item(layer)) add(scene, layer, item);
  }
  for (RasterLayer* item : {raster.overview(), raster.compared(), raster.difference()}) add(scene, item);
  add(scene, Layer::Grid, new GridLayer(context));
  add(scene, Layer::Outlines, new OutlineLayer(context, outlines, highlighted, OutlineLayer::What::Outlines));
  add(scene, Layer::Ids, new OutlineLayer(context, outlines, highlighted, OutlineLayer::What::Ids));
  highlight = add(scene, new OutlineLayer(context, outlines, highlighted, OutlineLayer::What::Highlight));
  add(scene, Layer::Overlays, new OverlaysLayer(context, overlays));
  add(scene, Layer::Waypoints, new WaypointsLayer(context, waypoints));
  add(scene, Layer::Landmarks, new LandmarksLayer(context, landmarks));
  add(scene, Layer::Doors, new DoorsLayer(context));
  add(scene, Layer::Boxes, new BoxesLayer(context));
  add(scene, Layer::Constraints, new ConstraintsLayer(context));
  add(scene, Layer::Trajectory,
      new LinesLayer(
          context,
          [this](const auto& each) {
            each(context.live->trajectory);
            for (const auto& line : trajectories) each(line);
          },
          &MapTheme::trajectory, 2));
  add(scene, Layer::Path,
      new LinesLayer(
          context, [this](const auto& each) { each(context.live->path); }, &MapTheme::path, 3));
  add(scene, Layer::LocalPath, new LocalPathLayer(context));
  add(scene, Layer::Target, new TargetLayer(context));
  cloud = add(scene, Layer::Cloud, new CloudLayer(context));
  add(scene, Layer::NearbyRobots, new NearbyRobotsLayer(context));
  add(scene, Layer::Trail, new TrailLayer(context));
  add(scene, Layer::ExpandedFootprint, new FootprintLayer(context, true));
  add(scene, Layer::Footprint, new FootprintLayer(context, false));
  robot = add(scene, Layer::Robot, new RobotLayer(context));
  stale = add(scene, new StaleLayer(context));
  measure = add(scene, new MeasureLayer(context, measured));
  swipe = add(scene, new SwipeLayer(context));
  add(scene, Layer::ScaleBar, new ScaleBarLayer(context));
  for (const Layer layer : allLayers()) shown[layer] = shownByDefault(layer);
  stale->setVisible(false);
  stack();
  applyVisibility();
}

void SceneItems::stack() {
  int z = 10;
  for (const Layer layer : order) items.at(layer)->setZValue(z += 10);
  raster.overview()->setZValue(items.at(Layer::Submaps)->zValue() - 1);
  raster.compared()->setZValue(
      std::max(items.at(Layer::Submaps)->zValue(), items.at(Layer::WholeMap)->zValue()) + 1);
  raster.difference()->setZValue(raster.compared()->zValue() + 1);
  highlight->setZValue(items.at(Layer::Ids)->zValue() + 1);
  for (LayerItem* item :
       std::initializer_list<LayerItem*>{stale, measure, swipe, items.at(Layer::ScaleBar)}) {
    item->setZValue(z += 10);
  }
}

void SceneItems::applyVisibility() {
  const bool second = has_compared;
  const bool swiping = compare == CompareMode::Swipe;
  const bool difference = compare == CompareMode::Difference && second;
  for (const auto& [layer, item] : items) item->setVisible(shown.at(layer));
  if (swiping) items.at(Layer::WholeMap)->setVisible(true);
  if (swiping && !second) items.at(Layer::Submaps)->setVisible(true);
  if (difference) {
    items.at(Layer::WholeMap)->setVisible(false);
    items.at(Layer::Submaps)->setVisible(false);
  }
  raster.compared()->setVisible(swiping && second);
  raster.difference()->setVisible(difference);
  raster.overview()->setVisible(items.at(Layer::Submaps)->isVisible());
  raster.overview()->setOpacity(items.at(Layer::Submaps)->opacity());
  swipe->setVisible(swiping);
  swipe->setAt(swipe_at);
  const double x = std::round(swipe_at * context.view.width_px);
  const QRectF left(0, 0, x, context.view.height_px);
  const QRectF right(x, 0, context.view.width_px - x, context.view.height_px);
  const auto part = [&](const QRectF& rect) { return swiping ? std::optional(rect) : std::nullopt; };
  tiles->setPart(part(left));
  raster.overview()->setPart(part(left));
  items.at(Layer::WholeMap)->setPart(part(second ? left : right));
  raster.compared()->setPart(part(right));
  raster.syncActive();
}

void SceneItems::takeFeatures(const session::Session* session) {
  overlays.clear();
  trajectories.clear();
  landmarks.clear();
  waypoints = {};
  if (!session) return;
  const session::MapSlot& whole = session->wholeMap();
  const bool opened = whole.cells() && whole.shown().key.kind != map::MapKind::Live;
  if (opened && items.at(Layer::WholeMap)->isVisible()) {
    overlays = whole.shown().overlays;
    trajectories = whole.shown().trajectories;
    for (const auto& landmark : whole.shown().landmarks) {
      landmarks.push_back({landmark.id, landmark.position_m, std::nullopt});
    }
    waypoints = whole.waypoints();
  } else if (context.live->map_info) {
    overlays = context.live->map_info->overlays;
  }
}

}  // namespace mapwright::scene
