// The layers of the map, one graphics item each, painted through the camera. Items never own the state they
// show.
#pragma once

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include <QGraphicsItem>

#include "geometry/view_transform.h"
#include "map/live_state.h"
#include "render/tile_renderer.h"
#include "scene/line_sheet.h"
#include "scene/map_theme.h"

namespace mapwright::scene {

struct Measurement;

/// What every layer paints with. Owned by the scene, outlives its items.
struct LayerContext {
  geometry::ViewTransform view;  // logical pixels
  MapTheme theme;
};

QPointF toPoint(const Eigen::Vector2d& v);

/// Text with a halo, readable on any map.
void drawLabel(QPainter& painter, const QPointF& baseline_left, const QString& text, const MapTheme& theme,
               const QColor& color, bool struck_through = false);

/// An item as large as the viewport that draws itself in viewport pixels.
class LayerItem : public QGraphicsItem {
 public:
  explicit LayerItem(const LayerContext& context);
  QRectF boundingRect() const override;
  void viewportResized() { prepareGeometryChange(); }

 protected:
  const LayerContext& context_;
};

/// The composited submaps.
class TileLayer : public LayerItem {
 public:
  TileLayer(const LayerContext& context, render::TileRenderer& renderer);
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  /// Tells the renderer the camera in device pixels.
  void sendView();

 private:
  render::TileRenderer& renderer_;
  qreal pixel_ratio_ = 1;
};

/// The adaptive metric grid: minor and major lines, the world's axes.
class GridLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  LineSheet sheet_;
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

/// Outlines of the submaps, or their ids, or only the highlighted one.
class OutlineLayer : public LayerItem {
 public:
  enum class What { Outlines, Ids, Highlight };
  OutlineLayer(const LayerContext& context, const Outlines& outlines,
               const std::optional<map::SubmapId>& highlighted, What what);
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintOutlines(QPainter& painter);
  void paintIds(QPainter& painter) const;
  void paintHighlight(QPainter& painter) const;
  const Outlines& outlines_;
  const std::optional<map::SubmapId>& highlighted_;
  What what_;
  LineSheet sheet_;
};

/// The way that the robot came.
class TrailLayer : public LayerItem {
 public:
  TrailLayer(const LayerContext& context, const map::LiveState& live);
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const map::LiveState& live_;
};

/// The robot: its footprint where it told one, and always a mark of constant size with its heading.
class RobotLayer : public LayerItem {
 public:
  RobotLayer(const LayerContext& context, const map::LiveState& live);
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  /// The viewport rectangle that the robot covers now, to repaint no more than that.
  QRectF robotRect() const;

 private:
  const map::LiveState& live_;
};

/// A veil over everything that is no longer live.
class StaleLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
};

/// The measured polyline with the length of each leg and of the whole.
class MeasureLayer : public LayerItem {
 public:
  MeasureLayer(const LayerContext& context, const std::vector<Eigen::Vector2d>& points);
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const std::vector<Eigen::Vector2d>& points_;
};

/// The scale bar, bottom left.
class ScaleBarLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
};

/// The largest of 1, 2 or 5 times a power of ten that is not above `value`.
double roundDown125(double value);
/// "250 mm", "5 m", "1.2 km".
QString lengthText(double metres);

}  // namespace mapwright::scene
