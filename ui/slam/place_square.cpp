#include "ui/slam/place_square.h"

#include <limits>

#include <QPainter>

#include "ui/scene/map_scene.h"
#include "ui/scene/map_theme.h"

namespace mapwright::ui {
namespace {

constexpr double kLinePx = 2, kHaloPx = 5;

}  // namespace

PlaceSquare::PlaceSquare(scene::MapScene& scene) : scene_(scene) {
  setZValue(std::numeric_limits<int>::max());
  setAcceptedMouseButtons(Qt::NoButton);
  hide();
  scene.addItem(this);
  QObject::connect(&scene, &scene::MapScene::viewChanged, &scene, [this] { place(); });
}

void PlaceSquare::show(const geometry::WorldRect& world) {
  world_ = world;
  place();
  QGraphicsItem::show();
}

void PlaceSquare::place() {
  if (world_.empty()) return;
  prepareGeometryChange();
  polygon_.clear();
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(world_.min_x, world_.min_y), Eigen::Vector2d(world_.max_x, world_.min_y),
        Eigen::Vector2d(world_.max_x, world_.max_y), Eigen::Vector2d(world_.min_x, world_.max_y)}) {
    const Eigen::Vector2d px = scene_.view().pixelFromWorld(corner);
    polygon_ << QPointF(px.x(), px.y());
  }
}

QRectF PlaceSquare::boundingRect() const {
  return polygon_.boundingRect().adjusted(-kHaloPx, -kHaloPx, kHaloPx, kHaloPx);
}

void PlaceSquare::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setBrush(Qt::NoBrush);
  painter->setPen(QPen(scene_.theme().text_halo, kHaloPx, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter->drawPolygon(polygon_);
  painter->setPen(QPen(scene_.theme().accent, kLinePx, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter->drawPolygon(polygon_);
}

}  // namespace mapwright::ui
