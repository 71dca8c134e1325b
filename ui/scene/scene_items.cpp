#include "scene/scene_items.h"

#include <algorithm>
#include <cmath>

#include <QGraphicsScene>

#include "session/lacks_picture.h"

namespace mapwright::scene {
namespace {

render::RasterTiles::Options rasterOptions(const render::TileRenderer::Options& options) {
  render::RasterTiles::Options raster_options;
  raster_options.previews = options.previews;
  raster_options.workers = options.workers;
  raster_options.budget = std::make_shared<render::TileBudget>();
  raster_options.budget->bytes = options.budgets.grid_tiles;
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
  items.emplace(layer, item);
  by_layer[layer].push_back(item);
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
  region_ground = add(scene, Layer::Regions, new RegionGround(context));
  for (RasterLayer* item : raster.regionItems()) add(scene, Layer::Regions, item);
  for (RasterLayer* item : {raster.overview(), raster.compared(), raster.difference()}) add(scene, item);
  dispatched = add(scene, Layer::DispatchedCloud, new DispatchedCloudLayer(context, raster.options()));
  add(scene, Layer::Grid, new GridLayer(context));
  add(scene, Layer::Outlines, new OutlineLayer(context, outlines, highlighted, OutlineLayer::What::Outlines));
  add(scene, Layer::Ids, new OutlineLayer(context, outlines, highlighted, OutlineLayer::What::Ids));
  highlight = add(scene, new OutlineLayer(context, outlines, highlighted, OutlineLayer::What::Highlight));
  for (MapFeatures* features : {&of_whole, &of_compared, &of_robot}) addFeatures(scene, *features);
  of_robot.items.push_back(add(scene, Layer::Landmarks,
                               new LandmarksLayer(
                                   context, [this]() -> const auto& { return context.live->landmarks; })));
  of_robot.items.push_back(add(
      scene, Layer::Trajectory,
      new LinesLayer(
          context, [this](const auto& each) { each(context.live->trajectory); }, &MapTheme::trajectory, 2)));
  add(scene, Layer::Doors, new DoorsLayer(context));
  add(scene, Layer::Boxes, new BoxesLayer(context));
  add(scene, Layer::Constraints, new ConstraintsLayer(context));
  add(scene, Layer::Path,
      new LinesLayer(
          context, [this](const auto& each) { each(context.live->path); }, &MapTheme::path, 3));
  add(scene, Layer::LocalPath, new LocalPathLayer(context));
  add(scene, Layer::Target, new TargetLayer(context));
  cloud = add(scene, Layer::Cloud, new CloudLayer(context));
  add(scene, Layer::NearbyRobots, new NearbyRobotsLayer(context));
  add(scene, Layer::Track, new TrackLayer(context, track));
  add(scene, Layer::Trail, new TrailLayer(context));
  add(scene, Layer::ExpandedFootprint, new FootprintLayer(context, true));
  add(scene, Layer::Footprint, new FootprintLayer(context, false));
  robot = add(scene, Layer::Robot, new RobotLayer(context));
  stale = add(scene, new StaleLayer(context));
  measure = add(scene, new MeasureLayer(context, measured));
  swipe = add(scene, new SwipeLayer(context));
  add(scene, Layer::ScaleBar, new ScaleBarLayer(context));
  for (const Layer layer : allLayers()) {
    // Submaps are on their own side of a swipe; landmarks and trajectories may belong to an opened map.
    const bool apart = layer == Layer::Submaps || layer == Layer::Landmarks || layer == Layer::Trajectory;
    if (followsRobot(layer) && !apart) robots_own.push_back(items.at(layer));
  }
  robots_own.insert(robots_own.end(), of_robot.items.begin(), of_robot.items.end());
  for (const Layer layer : allLayers()) shown[layer] = shownByDefault(layer);
  stale->setVisible(false);
  stack();
  applyVisibility();
}

void SceneItems::stack() {
  int z = 10;
  for (const Layer layer : order) {
    z += 10;
    for (LayerItem* item : itemsOf(layer)) item->setZValue(z);
  }
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

void SceneItems::addFeatures(QGraphicsScene& scene, MapFeatures& features) {
  features.items = {add(scene, Layer::Overlays, new OverlaysLayer(context, features.overlays)),
                    add(scene, Layer::Waypoints, new WaypointsLayer(context, features.waypoints)),
                    add(scene, Layer::Landmarks,
                        new LandmarksLayer(
                            context, [&features]() -> const auto& { return features.landmarks; })),
                    add(scene, Layer::Trajectory,
                        new LinesLayer(
                            context,
                            [&features](const auto& each) {
                              for (const auto& line : features.trajectories) each(line);
                            },
                            &MapTheme::trajectory, 2))};
}

MapsOnScreen SceneItems::onScreen() const {
  return {shown.at(Layer::WholeMap) || compare != CompareMode::Off,
          has_compared && compare != CompareMode::Off, compare,
          compare == CompareMode::Swipe && halves().left == HalfContent::Submaps};
}

void SceneItems::takeCompared(session::Session* session) {
  has_submaps = session && session->robot().submapSource();
  wants_second = session && session->comparedMap().phase() != session::MapSlot::Phase::Empty;
  has_compared = session && session->comparedMap().cells() != nullptr;
}

Halves SceneItems::halves() const {
  if (wants_second) return {HalfContent::WholeMap, HalfContent::ComparedMap};
  if (has_submaps) return {HalfContent::Submaps, HalfContent::WholeMap};
  return {HalfContent::WholeMap, HalfContent::Nothing};
}

std::optional<QRectF> SceneItems::rectOf(ScreenPart part) const {
  const double x = std::round(swipe_at * context.view.width_px);
  if (part == ScreenPart::Left) return QRectF(0, 0, x, context.view.height_px);
  if (part == ScreenPart::Right) return QRectF(x, 0, context.view.width_px - x, context.view.height_px);
  return std::nullopt;
}

void SceneItems::applyVisibility() {
  const bool second = has_compared;
  const bool swiping = compare == CompareMode::Swipe;
  const bool difference = compare == CompareMode::Difference && second;
  for (const auto& [layer, of_layer] : by_layer) {
    for (LayerItem* item : of_layer) item->setVisible(shown.at(layer));
  }
  const bool submaps_left = halves().left == HalfContent::Submaps;
  if (compare != CompareMode::Off) {
    // Each half is one map, regardless of what was on screen before.
    items.at(Layer::WholeMap)->setVisible(!difference);
    items.at(Layer::Submaps)->setVisible(swiping && submaps_left);
  }
  // Regions are on neither side of a comparison.
  if (compare != CompareMode::Off) {
    for (LayerItem* item : by_layer.at(Layer::Regions)) item->setVisible(false);
  }
  raster.compared()->setVisible(swiping && second);
  raster.difference()->setVisible(difference);
  const auto part = [&](ScreenPart which) { return swiping ? rectOf(which) : std::nullopt; };
  tiles->setPart(part(ScreenPart::Left));
  const ScreenPart of_the_whole = submaps_left ? ScreenPart::Right : ScreenPart::Left;
  items.at(Layer::WholeMap)->setPart(part(of_the_whole));
  raster.compared()->setPart(part(ScreenPart::Right));
  for (LayerItem* item : of_whole.items) item->setPart(part(of_the_whole));
  for (LayerItem* item : of_compared.items) {
    item->setPart(part(ScreenPart::Right));
    item->setVisible(item->isVisible() && second && swiping);
  }
  // Data of the robot is shown where the robot is.
  for (LayerItem* item : robots_own) item->setPart(rectOf(place.drawn));
  if (place.drawn == ScreenPart::None) {
    for (LayerItem* item : robots_own) item->setVisible(false);
    items.at(Layer::Submaps)->setVisible(false);
  }
  raster.overview()->setPart(tiles->part());
  raster.overview()->setVisible(tiles->isVisible());
  raster.overview()->setOpacity(tiles->opacity());
  highlight->setVisible(place.drawn != ScreenPart::None);
  swipe->setVisible(swiping);
  swipe->setAt(swipe_at);
  raster.syncActive();
  dispatched->tiles().setActive(dispatched->isVisible());
}

bool SceneItems::placeRobot(session::Session* session) {
  takeCompared(session);
  const RobotPlace before = place;
  place = {};
  if (!session) {
    robot_wanted.reset();
  } else {
    // A choice applies to one map.
    const session::MapSlot& whole = session->wholeMap();
    const std::optional<map::MapKey> shown_key =
        whole.cells() ? std::optional(whole.shown().key) : std::nullopt;
    if (wanted_on != shown_key) robot_wanted.reset();
    wanted_on = shown_key;
    place = robotPlace(*session, onScreen(), robot_wanted);
  }
  return !(place == before);
}

void SceneItems::takeWaypoints(const session::Session* session) {
  const auto take = [this, session](const session::MapSlot& slot, bool on_screen, MapFeatures& features) {
    features.waypoints.clear();
    if (!on_screen) return;
    // Edited ones need no picture below them.
    if (edited && edited->map == session->placesOf(slot)) {
      features.waypoints = edited->points;
      return;
    }
    if (!slot.cells() && !session::lacksPicture(slot)) return;
    for (const map::Waypoint& point : slot.waypoints().points) {
      DrawnWaypoint drawn;
      drawn.name = point.name.empty() ? point.id : point.name;
      drawn.position_m = point.position_m;
      drawn.yaw_rad = point.yaw_rad;
      features.waypoints.push_back(std::move(drawn));
    }
  };
  of_whole.waypoints.clear();
  of_compared.waypoints.clear();
  if (!session) return;
  take(session->wholeMap(), onScreen().whole, of_whole);
  take(session->comparedMap(), onScreen().compared, of_compared);
}

void SceneItems::takeFeatures(const session::Session* session) {
  for (MapFeatures* features : {&of_whole, &of_compared, &of_robot}) {
    features->overlays.clear();
    features->trajectories.clear();
    features->landmarks.clear();
  }
  takeWaypoints(session);
  if (!session) return;
  const MapsOnScreen on_screen = onScreen();
  const auto take = [](const session::MapSlot& slot, MapFeatures& features) {
    if (!slot.cells() || slot.shown().key.kind == map::MapKind::Live) return false;
    features.overlays = slot.shown().overlays;
    features.trajectories = slot.shown().trajectories;
    for (const auto& landmark : slot.shown().landmarks)
      features.landmarks.push_back({landmark.id, landmark.position_m, std::nullopt});
    return true;
  };
  const bool opened = on_screen.whole && take(session->wholeMap(), of_whole);
  if (on_screen.compared) take(session->comparedMap(), of_compared);
  // Next to an opened map the robot's own overlays only belong on the half of the submaps.
  const bool beside = on_screen.submaps_left && place.drawn == ScreenPart::Left;
  if (place.overlays_fit && context.live->map_info && (!opened || beside))
    of_robot.overlays = context.live->map_info->overlays;
}

}  // namespace mapwright::scene
