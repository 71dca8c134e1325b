#include "ui/regions/rectangle_tool.h"

#include <utility>

#include <QPainter>
#include <QPolygonF>

namespace mapwright::window {

RectangleTool::RectangleTool(std::function<geometry::ViewTransform()> view,
                             std::function<QString(const geometry::WorldRect&)> describe, QObject* parent)
    : MapTool(parent), view_(std::move(view)), describe_(std::move(describe)) {}

geometry::WorldRect RectangleTool::rect() const {
  geometry::WorldRect rect;
  if (!from_ || !to_) return rect;
  rect.extend(*from_);
  rect.extend(*to_);
  return rect;
}

bool RectangleTool::pressed(const MapPoint& at) {
  from_ = at.world_m;
  to_.reset();
  return true;
}

void RectangleTool::dragged(const MapPoint& at) {
  if (!from_) return;
  to_ = at.world_m;
  tell();
}

void RectangleTool::released(const MapPoint& at) {
  if (!from_) return;
  to_ = at.world_m;
  const geometry::WorldRect rect = this->rect();
  dragCancelled();
  if (rect.width() > 0 && rect.height() > 0) Q_EMIT drawn(rect);
}

void RectangleTool::dragCancelled() {
  from_.reset();
  to_.reset();
  tell();
}

bool RectangleTool::keyPressed(const MapKeyPress& press) {
  if (press.key != Qt::Key_Escape) return false;
  if (to_) {
    dragCancelled();
  } else {
    Q_EMIT finished();
  }
  return true;
}

void RectangleTool::paint(QPainter& painter) {
  const geometry::WorldRect rect = this->rect();
  if (rect.empty()) return;
  const geometry::ViewTransform view = view_();
  QPolygonF shape;
  for (const auto& [x, y] : {std::pair(rect.min_x, rect.min_y), std::pair(rect.max_x, rect.min_y),
                             std::pair(rect.max_x, rect.max_y), std::pair(rect.min_x, rect.max_y)}) {
    const Eigen::Vector2d at = view.pixelFromWorld({x, y});
    shape << QPointF(at.x(), at.y());
  }
  // Visible on any background.
  painter.setBrush(QColor(255, 255, 255, 40));
  painter.setPen(QPen(QColor(255, 255, 255), 3));
  painter.drawPolygon(shape);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(20, 24, 28), 1, Qt::DashLine));
  painter.drawPolygon(shape);
}

QString RectangleTool::hint() const {
  const geometry::WorldRect rect = this->rect();
  if (rect.empty()) return tr("Drag a rectangle over the region to fetch. Esc: back");
  return describe_(rect);
}

}  // namespace mapwright::window

#include "moc_rectangle_tool.cpp"
