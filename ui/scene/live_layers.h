// Layers of the robot's sensor data, plans and tasks, from its live topics and the open map.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include <QImage>

#include "map/overlay.h"
#include "render/grid_renderer.h"
#include "scene/drawn_waypoint.h"
#include "scene/layer_item.h"
#include "scene/line_sheet.h"

namespace mapwright::scene {

/// `alpha`: 0 … 255.
inline QColor translucent(QColor color, int alpha) {
  color.setAlpha(alpha);
  return color;
}

/// A picture of cells: a whole map, a costmap, a difference.
class RasterLayer : public DeviceLayer {
 public:
  RasterLayer(const LayerContext& context, render::GridRenderer& renderer);

 protected:
  void takeView(const geometry::ViewTransform& device_view) override { renderer_.setView(device_view); }
  void paintPixels(QPainter& painter, const QRectF& exposed) override;

 private:
  render::GridRenderer& renderer_;
};

/// Lidar points of all topics.
class CloudLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  /// Points have arrived: repaints their old and new areas.
  void pointsArrived();

 private:
  struct Key {
    geometry::ViewTransform view;
    std::map<std::string, std::shared_ptr<const std::vector<map::CloudPoint>>> clouds;
    LayerStyle style;
    bool dark = false;
    qreal ratio = 1;
    bool operator==(const Key&) const = default;
  };
  Key keyNow() const;
  void splat();

  Key key_;
  QImage image_;
  QRect painted_;  // area of image_ with points, in device pixels
  qreal ratio_ = 1;
};

/// Lines through the world: path, trajectories, constraints.
class LinesLayer : public LayerItem {
 public:
  using Lines = std::function<void(const std::function<void(std::span<const Eigen::Vector2d>)>&)>;
  /// `lines` calls back with every polyline. With the given default colour and width.
  LinesLayer(const LayerContext& context, Lines lines, QColor MapTheme::*color, double width_px);
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  Lines lines_;
  QColor MapTheme::*color_;
  double width_px_;
};

/// Many short, thin segments.
class ConstraintsLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  LineSheet sheet_;
};

/// The local path as a band of the robot's width.
class LocalPathLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
};

/// The robot's goal.
class TargetLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
};

/// Other robots, with their footprints and where they are headed.
class NearbyRobotsLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
};

/// Doors with their state, as shape and colour.
class DoorsLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
};

/// Pallets, racks, detected objects, and the robot's other drawings.
class BoxesLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
};

/// Landmarks seen by the robot, or those of an open mapping.
class LandmarksLayer : public LayerItem {
 public:
  using Source = std::function<const std::vector<map::Landmark>&()>;
  LandmarksLayer(const LayerContext& context, Source landmarks);
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  Source landmarks_;
};

/// Walls, regions and places, read-only.
class OverlaysLayer : public LayerItem {
 public:
  OverlaysLayer(const LayerContext& context, const std::vector<map::OverlayFeature>& features);
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintRegion(QPainter& painter, const map::OverlayFeature& feature) const;
  void paintLine(QPainter& painter, const map::OverlayFeature& feature) const;
  const std::vector<map::OverlayFeature>& features_;
};

/// Waypoints with their headings.
class WaypointsLayer : public LayerItem {
 public:
  WaypointsLayer(const LayerContext& context, const std::vector<DrawnWaypoint>& points);
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const std::vector<DrawnWaypoint>& points_;
};

/// The line between the two halves of a swipe.
class SwipeLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  void setAt(double fraction);
  void setNames(const QString& left, const QString& right);

 private:
  void paintName(QPainter& painter, const QString& name, double from_px, double to_px, bool at_end) const;

  double at_ = 0.5;
  QString left_, right_;
};

/// The tick of a heading, starting at a position in viewport pixels.
void drawHeading(QPainter& painter, const LayerContext& context, const QPointF& at, double yaw_rad,
                 const QColor& color);
/// A waypoint: a dot with a tick along its heading, and its name if there is room.
void drawPlace(QPainter& painter, const LayerContext& context, const Eigen::Vector2d& world_m,
               std::optional<double> yaw_rad, const QColor& color, const QString& name);

}  // namespace mapwright::scene
