// The outline of a square of the map that the user went to.
#pragma once

#include <QGraphicsItem>

#include "geometry/rect.h"

namespace mapwright::ui::scene {
class MapScene;
}

namespace mapwright::ui {

class PlaceSquare : public QGraphicsItem {
 public:
  enum { Type = UserType + 1 };
  /// Owned by `scene`; hidden.
  explicit PlaceSquare(scene::MapScene& scene);

  /// World metres.
  void show(const geometry::WorldRect& world);
  /// In the viewport, without the width of its lines.
  QRectF seen() const { return polygon_.boundingRect(); }

  int type() const override { return Type; }
  QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void place();

  scene::MapScene& scene_;
  geometry::WorldRect world_;
  QPolygonF polygon_;
};

}  // namespace mapwright::ui
