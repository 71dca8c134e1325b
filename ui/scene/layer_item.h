// What all layers of the map have in common: what they paint with, and their base. Private to this room.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include <QGraphicsItem>
#include <QImage>
#include <QPointer>
#include <QStyleOptionGraphicsItem>

#include "clouds/cloud_store.h"
#include "geometry/view_transform.h"
#include "map/grid_reference.h"
#include "map/live_state.h"
#include "map/overlay.h"
#include "map/submap.h"
#include "regions/region_map.h"
#include "render/raster_tiles.h"
#include "scene/drawing.h"
#include "scene/drawn_waypoint.h"
#include "scene/layer.h"
#include "scene/map_object.h"
#include "scene/map_theme.h"
#include "scene/track.h"

namespace mapwright::scene {

/// Places the labels of one frame without overlaps, in viewport pixels.
class LabelSpace {
 public:
  /// Starts a new frame.
  void clear() { bands_.clear(); }
  /// Takes the first of `spots` that overlaps no label of this frame; nullopt = there is no room.
  std::optional<QRectF> take(std::span<const QRectF> spots);

 private:
  bool free(const QRectF& spot) const;

  std::map<int, std::vector<QRectF>> bands_;  // by the horizontal stripes that a label touches
};

/// Draws many thin lines quickly, on a transparent sheet of the viewport's size. Lines drawn directly onto a
/// view go through the rasteriser one by one (0.2 ms and a round of thread hand-overs each, measured with
/// Qt 6.4); on a separate sheet a thin, opaque, aliased line is a plain loop, and the sheet is blended over
/// the map in one step.
class LineSheet {
 public:
  /// Calls `draw` with a painter in the coordinates of `painter`, then blends the sheet with `opacity`.
  void paint(QPainter& painter, const QSizeF& viewport, double opacity,
             const std::function<void(QPainter&)>& draw);

 private:
  QImage sheet_;
};

/// Where one submap's slice lies, for outlines, ids and picking.
struct Outline {
  std::array<Eigen::Vector2d, 4> corners;
  Eigen::Vector2d center{0, 0};
  bool frozen = false;
  bool visible = true;
  bool contains(const Eigen::Vector2d& p) const;
};
using Outlines = std::map<map::SubmapId, Outline>;

/// The features that belong to a map.
struct MapFeatures {
  std::vector<map::OverlayFeature> overlays;
  std::vector<std::vector<Eigen::Vector2d>> trajectories;
  std::vector<map::Landmark> landmarks;
  std::vector<DrawnWaypoint> waypoints;
};

/// Everything that layers paint with. Owned by the scene, outlives its items.
struct LayerContext {
  geometry::ViewTransform view;  // logical pixels
  MapTheme theme;
  double covered_top_px = 0;               // height of the strips on top of the map
  double swipe_at = 0.5;                   // 0 (left edge) .. 1
  QString left_name, right_name;           // of the halves of a swipe
  std::optional<geometry::Pose2> between;  // where to draw the robot instead, if it is drawn
  const map::LiveState* live = nullptr;    // never null while items exist; of the session, or an empty one
  std::array<MapFeatures, 3> features;     // by FeaturesOf
  Outlines outlines;
  std::set<map::SubmapId> highlighted;
  std::vector<Eigen::Vector2d> measured;
  bool measured_ring = false;
  std::optional<MapObject> marked;               // framed: what the user has chosen
  std::optional<Eigen::Vector2d> marker;         // a place that the user went to
  std::shared_ptr<const Track> track;            // null = none
  std::shared_ptr<clouds::CloudStore> clouds;    // never null
  QPointer<regions::RegionMap> regions;          // null = none
  std::optional<map::GridReference> regions_of;  // the whole map, if its robot reports its extent
  render::TileRenderer* submaps = nullptr;       // never null while items exist
  render::RasterTiles::Options rasters;          // of all rasters: they have one budget
  std::function<void()> settled_changed;         // an item calls it when settled() has changed
  mutable LabelSpace labels;                     // empty at the start of a frame

  /// Where the robot is drawn.
  std::optional<geometry::Pose2> robotPose() const {
    return live->robot_pose && between ? between : live->robot_pose;
  }
  MapFeatures& of(FeaturesOf which) { return features[std::size_t(which)]; }
  const MapFeatures& of(FeaturesOf which) const { return features[std::size_t(which)]; }
};

/// A label next to its object: right, otherwise left, below or above, or not at all if there is no room.
/// `mark` is the object's area in viewport pixels.
void drawName(QPainter& painter, const LayerContext& context, const QRectF& mark, const QString& name,
              const QColor& color);
/// Names appear when a pixel is no larger than this.
inline constexpr double kNameFromMPerPx = 0.12;
/// A name as one line, no markup, not too long.
QString shortName(const std::string& name, qsizetype longest = 40);

/// The tick of a heading, starting at a position in viewport pixels.
void drawHeading(QPainter& painter, const LayerContext& context, const QPointF& at, double yaw_rad,
                 const QColor& color);
/// A place: a dot with a tick along its heading, and its name if there is room.
void drawPlace(QPainter& painter, const LayerContext& context, const Eigen::Vector2d& world_m,
               std::optional<double> yaw_rad, const QColor& color, const QString& name);

/// An item as large as the viewport that draws itself in viewport pixels.
class LayerItem : public QGraphicsItem {
 public:
  explicit LayerItem(const LayerContext& context, std::optional<FeaturesOf> of = {});
  QRectF boundingRect() const override;
  QPainterPath shape() const override;  // the area that it paints, for clipping
  void viewportResized() { prepareGeometryChange(); }

  const LayerStyle& style() const { return style_; }
  void setStyle(const LayerStyle& style);
  /// Draws only inside this part of the viewport; nullopt = everywhere.
  void setPart(std::optional<QRectF> part);
  const std::optional<QRectF>& part() const { return part_; }
  /// nullopt: it shows no features of a map.
  std::optional<FeaturesOf> of() const { return of_; }

  virtual void viewMoved() {}                    // the camera
  virtual void lookChanged() { update(); }       // the style or the theme
  virtual void liveChanged() { update(); }       // a message of the layer's topics has arrived
  virtual void setActive(bool /*active*/) {}     // makes pictures in the background: only while it is visible
  virtual bool settled() const { return true; }  // shows everything that is known
  virtual std::size_t cacheBytes() const { return 0; }
  /// What belongs into the view besides maps.
  virtual geometry::WorldRect contentBounds() const { return {}; }

 protected:
  /// The style's colour, or `otherwise`; the same for the size.
  QColor colorOr(const QColor& otherwise) const { return style_.color.isValid() ? style_.color : otherwise; }
  double sizeOr(double otherwise) const { return style_.size > 0 ? style_.size : otherwise; }

  const LayerContext& context_;

 private:
  std::optional<FeaturesOf> of_;
  LayerStyle style_;
  std::optional<QRectF> part_;
};

/// For LayerSpec::items: one item.
template <class Item>
std::vector<LayerItem*> oneItem(const LayerContext& context) {
  return {new Item(context)};
}
/// One for the features of each map.
template <class Item>
std::vector<LayerItem*> itemForEachMap(const LayerContext& context) {
  return {new Item(context, FeaturesOf::WholeMap), new Item(context, FeaturesOf::ComparedMap),
          new Item(context, FeaturesOf::Robot)};
}

/// A layer made of finished pixels of the device.
class DeviceLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  void viewMoved() override;

 protected:
  /// The camera in device pixels.
  virtual void takeView(const geometry::ViewTransform& device_view) = 0;
  /// `painter` and `exposed` are in device pixels.
  virtual void paintPixels(QPainter& painter, const QRectF& exposed) = 0;

 private:
  qreal pixel_ratio_ = 1;
};

/// Frames the highlighted submaps.
class HighlightItem : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
};

/// Frames the chosen object, and marks the place that the user went to.
class MarkItem : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  /// What paint() covers at present.
  QRectF covers() const;
};

/// The colour of a place, line or region of an overlay.
QColor overlayColor(const MapTheme& theme, const map::OverlayFeature& feature);
QColor waypointColor(const MapTheme& theme, WaypointMark mark);

/// The viewport rectangle of the robot and its footprints, to limit repaints.
QRectF robotRect(const LayerContext& context);

}  // namespace mapwright::scene
