// The graphics items of a map scene: made once, stacked in the user's order, visible by the user's choice and
// as a comparison requires. Private to this room.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "scene/dispatched_cloud_layer.h"
#include "scene/live_layers.h"
#include "scene/map_layers.h"
#include "scene/raster_stack.h"
#include "scene/regions_layer.h"
#include "scene/robot_place.h"
#include "scene/track_layer.h"

class QGraphicsScene;

namespace mapwright::scene {

/// The features that belong to a map, with their items.
struct MapFeatures {
  std::vector<map::OverlayFeature> overlays;
  std::vector<std::vector<Eigen::Vector2d>> trajectories;
  std::vector<map::Landmark> landmarks;
  std::vector<DrawnWaypoint> waypoints;
  std::vector<LayerItem*> items;
};

class SceneItems {
 public:
  /// The scene owns the items; this must outlive them.
  SceneItems(QGraphicsScene& scene, render::TileRenderer& renderer,
             const render::TileRenderer::Options& options);

  /// Gives every item its place in `order`.
  void stack();
  Halves halves() const;
  /// The user's choice (`shown`), modified by the needs of a comparison.
  void applyVisibility();
  /// The features of the maps shown, from what is known of them and from the robot's messages.
  void takeFeatures(const session::Session* session);
  /// The waypoints: the edited ones, otherwise the robot's.
  void takeWaypoints(const session::Session* session);
  /// Updates where the robot is drawn; true if that has changed.
  bool placeRobot(session::Session* session);
  /// All items of a layer: some layers show several maps.
  const std::vector<LayerItem*>& itemsOf(Layer layer) const { return by_layer.at(layer); }

  LayerContext context;
  LabelSpace labels;
  map::LiveState nothing_live;
  Outlines outlines;
  std::set<map::SubmapId> highlighted;
  std::vector<Eigen::Vector2d> measured;
  std::shared_ptr<const Track> track;  // null = none
  MapFeatures of_whole, of_compared, of_robot;
  RobotPlace place;
  std::optional<DrawnWaypoints> edited;  // shown instead of the robot's waypoints
  std::optional<bool> robot_wanted;      // the user's choice for the map on screen
  std::optional<map::MapKey> wanted_on;
  QRectF robot_rect;
  std::optional<geometry::Pose2> robot_pose;  // of the robot as drawn
  std::size_t trail_length = 0;
  std::map<Layer, bool> shown;
  std::vector<Layer> order;
  CompareMode compare = CompareMode::Off;
  bool has_submaps = false;   // the robot has some
  bool wants_second = false;  // a second map is compared, or loading
  bool has_compared = false;  // it is there
  double swipe_at = 0.5;
  RasterStack raster;
  std::map<Layer, LayerItem*> items;  // the first of each layer
  std::map<Layer, std::vector<LayerItem*>> by_layer;
  std::vector<LayerItem*> all;
  std::vector<LayerItem*> robots_own;  // all that only make sense where the robot is; not the submaps
  TileLayer* tiles = nullptr;
  RegionGround* region_ground = nullptr;
  OutlineLayer* highlight = nullptr;
  CloudLayer* cloud = nullptr;
  DispatchedCloudLayer* dispatched = nullptr;
  RobotLayer* robot = nullptr;
  MeasureLayer* measure = nullptr;
  StaleLayer* stale = nullptr;
  SwipeLayer* swipe = nullptr;

 private:
  template <typename Item>
  Item* add(QGraphicsScene& scene, Item* item);
  template <typename Item>
  Item* add(QGraphicsScene& scene, Layer layer, Item* item);
  void addFeatures(QGraphicsScene& scene, MapFeatures& features);
  void takeCompared(session::Session* session);
  MapsOnScreen onScreen() const;
  std::optional<QRectF> rectOf(ScreenPart part) const;
};

}  // namespace mapwright::scene
