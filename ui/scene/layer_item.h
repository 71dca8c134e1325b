// The common base of all layers of the map.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <QGraphicsItem>
#include <QPolygonF>

#include "geometry/view_transform.h"
#include "map/live_state.h"
#include "render/raster_tiles.h"
#include "scene/label_space.h"
#include "scene/layer.h"
#include "scene/map_theme.h"

namespace mapwright::scene {

/// Everything that layers paint with. Owned by the scene, outlives its items.
struct LayerContext {
  geometry::ViewTransform view;  // logical pixels
  MapTheme theme;
  double covered_top_px = 0;               // height of the strips on top of the map
  std::optional<geometry::Pose2> between;  // where to draw the robot instead, if it is drawn
  const map::LiveState* live = nullptr;    // never null while items exist; of the session, or an empty one
  LabelSpace* labels = nullptr;            // never null while items exist; empty at the start of a frame

  /// Where the robot is drawn.
  std::optional<geometry::Pose2> robotPose() const {
    return live->robot_pose && between ? between : live->robot_pose;
  }
};

QPointF toPoint(const Eigen::Vector2d& v);

/// The colour, shifted towards the theme's text colour if letters would not stand out against their halo.
QColor readable(const QColor& color, const MapTheme& theme);
/// Text with a halo, readable on any map.
void drawLabel(QPainter& painter, const QPointF& baseline_left, const QString& text, const MapTheme& theme,
               const QColor& color, bool struck_through = false);

/// A label next to its object: right, otherwise left, below or above, or not at all if there is no room.
/// `mark` is the object's area in viewport pixels.
void drawName(QPainter& painter, const LayerContext& context, const QRectF& mark, const QString& name,
              const QColor& color);

/// The viewport polyline of world points without invisible parts: points within two pixels of the previous
/// one, and parts outside the viewport grown by `margin_px` (which gives several polylines).
std::vector<QPolygonF> visibleLines(const geometry::ViewTransform& view,
                                    std::span<const Eigen::Vector2d> world, double margin_px);

/// An item as large as the viewport that draws itself in viewport pixels.
class LayerItem : public QGraphicsItem {
 public:
  explicit LayerItem(const LayerContext& context);
  QRectF boundingRect() const override;
  QPainterPath shape() const override;  // the area that it paints, for clipping
  void viewportResized() { prepareGeometryChange(); }

  const LayerStyle& style() const { return style_; }
  void setStyle(const LayerStyle& style);
  /// Draws only inside this part of the viewport; nullopt = everywhere.
  void setPart(std::optional<QRectF> part);
  const std::optional<QRectF>& part() const { return part_; }

 protected:
  /// The style's colour, or `otherwise`; the same for the size.
  QColor colorOr(const QColor& otherwise) const { return style_.color.isValid() ? style_.color : otherwise; }
  double sizeOr(double otherwise) const { return style_.size > 0 ? style_.size : otherwise; }

  const LayerContext& context_;

 private:
  LayerStyle style_;
  std::optional<QRectF> part_;
};

/// Draws the tiles that touch `exposed`, both in device pixels.
void drawTiles(QPainter& painter, const QRectF& exposed, std::span<const render::DrawnTile> tiles);
/// The stand-ins where nothing finished covers them, and the tiles.
void drawRaster(QPainter& painter, const QRectF& exposed, const render::RasterTiles::Drawing& drawing);

/// A layer made of finished pixels of the device.
class DeviceLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  /// Passes on the camera in device pixels.
  void sendView();

 protected:
  virtual void takeView(const geometry::ViewTransform& device_view) = 0;
  /// `painter` and `exposed` are in device pixels.
  virtual void paintPixels(QPainter& painter, const QRectF& exposed) = 0;

 private:
  qreal pixel_ratio_ = 1;
};

}  // namespace mapwright::scene
