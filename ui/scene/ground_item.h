// The lower layers, which seldom change, drawn by one item. For a window it keeps a picture of them while the
// camera stands still: what moves above them (the robot, its points) repaints none of them. Private to this
// room.
#pragma once

#include <optional>
#include <vector>

#include <QGraphicsItem>
#include <QImage>
#include <QRegion>

#include "geometry/view_transform.h"

namespace mapwright::ui::scene {

class LayerItem;
struct LayerContext;

class GroundItem : public QGraphicsItem {
 public:
  explicit GroundItem(const LayerContext& context);

  /// The layers that it draws, bottom first; all others draw themselves.
  void setLayers(std::vector<LayerItem*> layers);
  bool holds(const LayerItem* layer) const;
  /// They look different in this part of the viewport.
  void changed(const QRectF& rect);
  void viewportResized() { prepareGeometryChange(); }

  QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintLayers(QPainter& painter, const QRectF& exposed, QWidget* widget) const;

  const LayerContext& context_;
  std::vector<LayerItem*> layers_;
  std::optional<geometry::ViewTransform> painted_view_;  // of the last painting for a window
  QImage picture_;
  std::optional<QRegion> outdated_;  // of the picture; nullopt: there is none
};

}  // namespace mapwright::ui::scene
