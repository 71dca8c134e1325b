// The graphics items of a map scene: made once, stacked in the user's order, shown as he wants and as a
// comparison needs. Private to this room.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "scene/live_layers.h"
#include "scene/map_layers.h"
#include "scene/raster_stack.h"

class QGraphicsScene;

namespace mapwright::scene {

class SceneItems {
 public:
  /// The scene owns the items; this must outlive them.
  SceneItems(QGraphicsScene& scene, render::TileRenderer& renderer,
             const render::TileRenderer::Options& options);

  /// Gives every item its place in `order`.
  void stack();
  /// What the user wants to see (`shown`), changed by what a comparison needs.
  void applyVisibility();
  /// What lies on the map by the map that is shown, not by what the robot sends.
  void takeFeatures(const session::Session* session);

  LayerContext context;
  LabelSpace labels;
  map::LiveState nothing_live;
  Outlines outlines;
  std::set<map::SubmapId> highlighted;
  std::vector<Eigen::Vector2d> measured;
  std::vector<map::OverlayFeature> overlays;
  std::vector<std::vector<Eigen::Vector2d>> trajectories;
  std::vector<map::Landmark> landmarks;
  map::WaypointList waypoints;
  QRectF robot_rect;
  std::size_t trail_length = 0;
  std::map<Layer, bool> shown;
  std::vector<Layer> order;
  CompareMode compare = CompareMode::Off;
  bool has_compared = false;
  double swipe_at = 0.5;
  RasterStack raster;
  std::map<Layer, LayerItem*> items;
  std::vector<LayerItem*> all;
  TileLayer* tiles = nullptr;
  OutlineLayer* highlight = nullptr;
  CloudLayer* cloud = nullptr;
  RobotLayer* robot = nullptr;
  MeasureLayer* measure = nullptr;
  StaleLayer* stale = nullptr;
  SwipeLayer* swipe = nullptr;

 private:
  template <typename Item>
  Item* add(QGraphicsScene& scene, Item* item);
  template <typename Item>
  Item* add(QGraphicsScene& scene, Layer layer, Item* item);
};

}  // namespace mapwright::scene
