// The layers that every robot has, one graphics item each, painted through the camera. Items never own the
// state that they show.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "map/submap.h"
#include "render/tile_renderer.h"
#include "scene/layer_item.h"
#include "scene/line_sheet.h"

namespace mapwright::scene {

struct Measurement;

/// The composited submaps.
class TileLayer : public DeviceLayer {
 public:
  TileLayer(const LayerContext& context, render::TileRenderer& renderer);

 protected:
  void takeView(const geometry::ViewTransform& device_view) override { renderer_.setView(device_view); }
  void paintPixels(QPainter& painter, const QRectF& exposed) override;

 private:
  render::TileRenderer& renderer_;
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

/// Outlines of the submaps, or their ids, or only those of the highlighted ones.
class OutlineLayer : public LayerItem {
 public:
  enum class What { Outlines, Ids, Highlight };
  OutlineLayer(const LayerContext& context, const Outlines& outlines,
               const std::set<map::SubmapId>& highlighted, What what);
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintOutlines(QPainter& painter);
  void paintIds(QPainter& painter) const;
  void paintHighlight(QPainter& painter) const;
  const Outlines& outlines_;
  const std::set<map::SubmapId>& highlighted_;
  What what_;
  LineSheet sheet_;
};

/// The robot's recent path.
class TrailLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
};

/// The robot: a mark of constant size with its heading.
class RobotLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  /// The viewport rectangle of the robot and its footprints, to limit repaints.
  QRectF robotRect() const;
};

/// The footprint of the robot, or the wider one with its safety margin, if it reports them.
class FootprintLayer : public LayerItem {
 public:
  FootprintLayer(const LayerContext& context, bool expanded);
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  bool expanded_;
};

/// A veil over everything that is no longer live.
class StaleLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
};

/// The measured polyline with the length of each leg and the total.
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
