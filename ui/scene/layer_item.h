// What all layers of the map have in common: what they paint with, and their base. Private to this room.
#pragma once

#include <array>
#include <cstdint>
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

#include "agreement/survey.h"
#include "clouds/cloud_store.h"
#include "geometry/rect.h"
#include "geometry/view_transform.h"
#include "map/closures.h"
#include "map/grid_reference.h"
#include "map/live_state.h"
#include "map/overlay.h"
#include "map/submap.h"
#include "regions/region_map.h"
#include "render/raster_tiles.h"
#include "ui/scene/drawing.h"
#include "ui/scene/drawn_waypoint.h"
#include "ui/scene/kept_picture.h"
#include "ui/scene/labels.h"
#include "ui/scene/layer.h"
#include "ui/scene/map_object.h"
#include "ui/scene/map_theme.h"
#include "ui/scene/problem_marks.h"
#include "ui/scene/track.h"
#include "ui/scene/walls_off.h"

namespace mapwright::render {
class TileRenderer;
}

namespace mapwright::ui::scene {

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
  std::vector<map::BrokenOverlay> broken_overlays;
  std::optional<MapTrouble> trouble;
  bool operator==(const MapFeatures&) const = default;
};

/// Everything that layers paint with. Owned by the scene, outlives its items.
struct LayerContext {
  geometry::ViewTransform view;  // logical pixels
  MapTheme theme;
  double covered_top_px = 0;               // height of the strips on top of the map
  std::vector<QRectF> covered;             // by buttons
  double swipe_at = 0.5;                   // 0 (left edge) .. 1
  QString left_name, right_name;           // of the halves of a swipe
  std::optional<geometry::Pose2> between;  // where to draw the robot instead, if it is drawn
  const map::LiveState* live = nullptr;    // never null while items exist; of the session, or an empty one
  std::array<MapFeatures, 3> features;     // by FeaturesOf
  Outlines outlines;
  std::set<map::SubmapId> highlighted;
  std::optional<std::set<map::SubmapId>> outlined;  // nullopt = all
  std::unique_ptr<SubmapMarks> submap_marks = std::make_unique<SubmapMarks>();
  bool overlays_shown = true;
  std::optional<MapTrouble> reference_trouble;
  std::vector<Eigen::Vector2d> measured;
  bool measured_ring = false;
  std::optional<MapObject> marked;                    // framed: what the user has chosen
  std::optional<Eigen::Vector2d> marker;              // a place that the user went to
  std::shared_ptr<const Track> track;                 // null = none
  std::shared_ptr<const WallsOff> walls_off;          // null = none
  std::shared_ptr<const map::Closures> closures;      // null = none
  bool closures_chosen = false;                       // by a list: all of them are drawn
  std::shared_ptr<const agreement::Tiles> agreement;  // null = none
  double agreement_cell_m = 0;                        // edge of its cells
  std::shared_ptr<clouds::CloudStore> clouds;         // never null
  QPointer<regions::RegionMap> regions;               // null = none
  std::optional<map::GridReference> regions_of;       // the whole map, if its robot reports its extent
  render::TileRenderer* submaps = nullptr;            // never null while items exist
  render::RasterTiles::Options rasters;               // of all rasters: they have one budget
  std::function<void()> settled_changed;              // an item calls it when settled() has changed
  LabelInk* ink = nullptr;                            // never null while items exist
  /// An item looks different in this part of the viewport.
  std::function<void(const LayerItem&, const QRectF&)> changed;

  /// Where the robot is drawn.
  std::optional<geometry::Pose2> robotPose() const {
    return live->robot_pose && between ? between : live->robot_pose;
  }
  MapFeatures& of(FeaturesOf which) { return features[std::size_t(which)]; }
  const MapFeatures& of(FeaturesOf which) const { return features[std::size_t(which)]; }
};

/// When a pixel is larger than this, there are fewer names.
inline constexpr double kNameFromMPerPx = 0.12;
/// A name as one line, no markup, not too long.
QString shortName(const std::string& name, qsizetype longest = 40);

/// The tick of a heading, starting at a position in viewport pixels.
void drawHeading(QPainter& painter, const LayerContext& context, const QPointF& at, double yaw_rad,
                 const QColor& color);
/// A place: a dot with a tick along its heading.
void drawPlace(QPainter& painter, const LayerContext& context, const Eigen::Vector2d& world_m,
               std::optional<double> yaw_rad, const QColor& color);
/// A line through the world with a halo. `exposed`: see visibleLines().
void drawHaloedLine(QPainter& painter, const LayerContext& context, const QColor& color, double width_px,
                    std::span<const Eigen::Vector2d> world_m, const QRectF& exposed);
/// A small area is a symbol; a large one is ground on which something lies.
void keepSmallClear(LabelCollector& labels, const QRectF& area, double largest_px = 120);
/// The area of a round symbol, and of its tick, if it has one.
void keepClear(LabelCollector& labels, const LayerContext& context, const QRectF& mark,
               std::optional<double> yaw_rad);
/// The name of such a place; empty = none.
void labelPlace(LabelCollector& labels, const LayerContext& context, const Eigen::Vector2d& world_m,
                std::optional<double> yaw_rad, LabelRank rank, std::uint64_t id, const QString& name);

/// What a layer means to the labels.
enum class LabelUse {
  None,
  Symbols,  // it has symbols that no label may cover
  Names,    // it has labels, too
};

/// An item as large as the viewport that draws itself in viewport pixels.
class LayerItem : public QGraphicsItem {
 public:
  explicit LayerItem(const LayerContext& context, std::optional<FeaturesOf> of = {});
  QRectF boundingRect() const override;
  QPainterPath shape() const override;  // the area that it paints, for clipping
  void viewportResized() { prepareGeometryChange(); }
  /// Hides that of QGraphicsItem: lower layers are drawn by the GroundItem, which keeps a picture of them.
  void update(const QRectF& rect = {});

  const LayerStyle& style() const { return style_; }
  void setStyle(const LayerStyle& style);
  /// Draws only inside this part of the viewport; nullopt = everywhere.
  void setPart(std::optional<QRectF> part);
  const std::optional<QRectF>& part() const { return part_; }
  /// nullopt: it shows no features of a map.
  std::optional<FeaturesOf> of() const { return of_; }

  virtual void viewMoved() {}               // the camera
  virtual void lookChanged() { update(); }  // the style or the theme
  virtual void liveChanged() { update(); }  // a message of the layer's topics has arrived
  /// The robot's pose or its model has changed: where it was drawn, and where it is to be drawn.
  virtual void robotMoved(const QRectF& /*from*/, const QRectF& /*to*/) {}
  virtual void setActive(bool /*active*/) {}     // makes pictures in the background: only while it is visible
  virtual bool settled() const { return true; }  // shows everything that is known
  virtual std::size_t cacheBytes() const { return 0; }
  /// What belongs into the view besides maps.
  virtual geometry::WorldRect contentBounds() const { return {}; }
  virtual LabelUse labelUse() const { return LabelUse::None; }
  /// Called when it has changed, or the view.
  virtual void collectLabels(LabelCollector& /*labels*/) const {}

 protected:
  QVariant itemChange(GraphicsItemChange change, const QVariant& value) override;

  /// The style's colour, or `otherwise`; the same for the size.
  QColor colorOr(const QColor& otherwise) const { return style_.color.isValid() ? style_.color : otherwise; }
  double sizeOr(double otherwise) const { return style_.size > 0 ? style_.size : otherwise; }

  /// Another one if it looks different.
  std::uint64_t revision() const { return revision_; }

  const LayerContext& context_;

 private:
  std::uint64_t revision_ = 0;
  std::optional<FeaturesOf> of_;
  LayerStyle style_;
  std::optional<QRectF> part_;
};

/// One whose messages change a small part of the picture.
class SmallLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void liveChanged() override;

 protected:
  /// The part of the viewport that it paints now; empty = nothing.
  virtual QRectF reach() const = 0;
  /// To be called by paint().
  void markPainted() { painted_ = reach(); }
  /// The part of these points in view, with a margin.
  QRectF reachOf(std::span<const Eigen::Vector2d> world_m, double margin_px) const;

 private:
  QRectF painted_;
};

/// One of things that may be thousands: these are not drawn again for what changes elsewhere.
class CrowdLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  std::size_t cacheBytes() const override { return kept_.bytes(); }

 protected:
  /// How many there are.
  virtual std::size_t count() const = 0;
  /// At least what lies in `exposed`.
  virtual void paintThings(QPainter& painter, const QRectF& exposed) const = 0;

 private:
  KeptPicture kept_;
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
  virtual void onViewChanged(const geometry::ViewTransform& device_view) = 0;
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
  LabelUse labelUse() const override { return LabelUse::Names; }
  void collectLabels(LabelCollector& labels) const override;
};

/// Frames the chosen object, and marks the place that the user went to.
class MarkItem : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  /// What paint() covers at present.
  QRectF covers() const;
  LabelUse labelUse() const override { return LabelUse::Symbols; }
  void collectLabels(LabelCollector& labels) const override;

 private:
  void paintCasing(QPainter& painter, const MapObject& object) const;

  mutable LineSheet sheet_;
};

/// The colour of a place, line or region of an overlay.
QColor overlayColor(const MapTheme& theme, const map::OverlayFeature& feature);
QColor waypointColor(const MapTheme& theme, WaypointMark mark);

/// The viewport rectangle of the robot and its footprints, to limit repaints.
QRectF robotRect(const LayerContext& context);

/// A point that is not finite adds nothing.
inline void extendBy(geometry::WorldRect& bounds, const Eigen::Vector2d& point) {
  if (point.allFinite()) bounds.extend(point);
}

template <class Points>
geometry::WorldRect boundsOf(const Points& points) {
  geometry::WorldRect bounds;
  for (const Eigen::Vector2d& point : points) extendBy(bounds, point);
  return bounds;
}

/// Of the submaps that are shown.
inline geometry::WorldRect boundsOf(const Outlines& outlines) {
  geometry::WorldRect bounds;
  for (const auto& [id, outline] : outlines) {
    if (!outline.visible) continue;
    for (const Eigen::Vector2d& corner : outline.corners) extendBy(bounds, corner);
  }
  return bounds;
}

}  // namespace mapwright::ui::scene
