// The graphics items of a map scene: made once, stacked in the user's order, visible by the user's choice and
// as a comparison requires. Private to this room.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "ui/scene/drawn_overlays.h"
#include "ui/scene/ground_item.h"
#include "ui/scene/labels.h"
#include "ui/scene/layer_item.h"
#include "ui/scene/raster_stack.h"
#include "ui/scene/robot_place.h"

class QGraphicsScene;

namespace mapwright::render {
class TileRenderer;
struct TileRendererOptions;
}  // namespace mapwright::render

namespace mapwright::ui::scene {

class SceneItems {
 public:
  /// The scene owns the items; this must outlive them.
  /// `labels_due` is called when labels must be placed anew.
  SceneItems(QGraphicsScene& scene, render::TileRenderer& renderer,
             const render::TileRendererOptions& options, std::shared_ptr<clouds::CloudStore> clouds,
             std::function<void()> settled_changed, std::function<void()> labels_due);

  /// Gives every item its position in `order`.
  void stack();
  Halves halves() const;
  /// The user's choice (`shown`), modified by the needs of a comparison.
  void applyVisibility();
  /// The features of the maps shown, from what is known of them and from the robot's messages.
  void setFeatures(const session::Session* session);
  /// The waypoints: the edited ones, otherwise the robot's.
  void updateWaypoints(const session::Session* session);
  /// The edited overlays, where their map is shown.
  void updateOverlays(const session::Session* session);
  /// Updates where the robot is drawn; true if that has changed.
  bool placeRobot(session::Session* session);
  /// All items of a layer: some layers show several maps.
  const std::vector<LayerItem*>& itemsOf(Layer layer) const { return by_layer.at(layer); }
  /// The first of them.
  LayerItem& first(Layer layer) const { return *by_layer.at(layer).front(); }
  void update(Layer layer) const;
  /// Everything looks different.
  void allChanged();
  void viewportResized();
  /// Places the labels that are due. Repaints those that have moved.
  void placeLabels();

  map::LiveState nothing_live;
  LayerContext context;
  RobotPlace place;
  std::optional<DrawnWaypoints> edited;  // shown instead of the robot's waypoints
  std::optional<DrawnOverlays> edited_overlays;
  std::set<FeaturesOf> overlays_edited;  // whose are the edited ones
  std::optional<bool> robot_wanted;      // the user's choice for the map on screen
  std::optional<map::MapKey> wanted_on;
  QRectF robot_rect;
  std::optional<geometry::Pose2> robot_pose;  // of the robot as drawn
  std::map<std::int32_t, int> age_shifts;     // as drawn, by trajectory
  std::map<Layer, bool> shown;
  std::vector<Layer> order;
  CompareMode compare = CompareMode::Off;
  const bool asks;            // tells the session what its layers and its view need: a window does
  bool has_submaps = false;   // the robot has some
  bool wants_second = false;  // a second map is compared, or loading
  bool has_compared = false;  // it is there
  Labels labels;
  RasterStack raster;
  std::map<Layer, std::vector<LayerItem*>> by_layer;
  std::vector<LayerItem*> all;
  std::vector<LayerItem*> robots_own;  // all that only make sense where the robot is; not the submaps
  LayerItem *highlight, *measure, *stale, *swipe;
  MarkItem* mark;

 private:
  void layGround();
  void onItemChanged(const LayerItem& item, const QRectF& rect);

  GroundItem* ground_;
  LabelsItem *labels_below_, *labels_above_;  // the veil
  std::function<void()> labels_due_;

  MapsOnScreen onScreen() const;
  /// An opened map with features of its own is on screen.
  bool opened(const session::Session& session) const;
  /// The robot's own overlays belong on the screen.
  bool showsRobotsOverlays(const session::Session& session) const;
  std::optional<QRectF> rectOf(ScreenPart part) const;
};

}  // namespace mapwright::ui::scene
