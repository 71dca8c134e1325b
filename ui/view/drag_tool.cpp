#include "ui/view/drag_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/pose.h"

namespace mapwright::ui {

DragTool::DragTool(const scene::MapScene* scene, QObject* parent) : MapTool(parent), scene_(scene) {}

QPointF DragTool::px(const Eigen::Vector2d& world_m) const {
  return scene::toPoint(scene_->view().pixelFromWorld(world_m));
}

QRectF DragTool::frame() const {
  return dragging() ? QRectF(hold_->from.px, hold_->to.px).normalized() : QRectF();
}

bool DragTool::pressed(const MapPoint& at) {
  hold_ = Hold{at, at};
  const bool takes = grab(at);
  if (!takes) hold_.reset();
  return takes;
}

void DragTool::dragged(const MapPoint& at) {
  if (!hold_) return;
  hold_->to = at;
  hold_->moved = true;
  update(at);
  notifyChanged();
}

void DragTool::released(const MapPoint& at) {
  if (!hold_) return;
  dragged(at);
  if (hold_) finish(at);  // unless the last move ended it
  hold_.reset();
  notifyChanged();
}

void DragTool::dragCancelled() {
  if (std::exchange(hold_, std::nullopt)) cancel();
  notifyChanged();
}

void DragTool::clicked(const MapPoint& at) {
  click(at);
  hold_.reset();
  notifyChanged();
}

bool DragTool::keyPressed(const MapKeyPress& press) {
  if (press.key != Qt::Key_Escape) return false;
  if (hold_) {
    dragCancelled();
  } else if (stepBack()) {
    notifyChanged();
  } else {
    leave();
  }
  return true;
}

geometry::WorldRect DragShapeTool::Span::rect() const {
  geometry::WorldRect rect;
  rect.extend(from_m);
  rect.extend(to_m);
  return rect;
}

std::optional<DragShapeTool::Span> DragShapeTool::span() const {
  if (!dragging()) return std::nullopt;
  return Span{hold()->from.world_m, hold()->to.world_m};
}

void DragShapeTool::finish(const MapPoint&) {
  const Span drawn = *span();
  const geometry::WorldRect rect = drawn.rect();
  if (circle() ? drawn.length() > 0 : rect.width() > 0 && rect.height() > 0) draw(drawn);
}

void DragShapeTool::paint(QPainter& painter) {
  const auto drawn = span();
  if (!drawn) return;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(scene::translucent(theme().accent, 40));
  const geometry::WorldRect rect = drawn->rect();
  const std::array corners{px({rect.min_x, rect.min_y}), px({rect.max_x, rect.min_y}),
                           px({rect.max_x, rect.max_y}), px({rect.min_x, rect.max_y})};
  const double radius = drawn->length() / scene().view().scale_m_per_px;
  strokeWithHalo(painter, theme(), 2, [&] {
    circle() ? painter.drawEllipse(px(drawn->from_m), radius, radius)
             : painter.drawPolygon(corners.data(), int(corners.size()));
    painter.setBrush(Qt::NoBrush);
  });
}

void lineWithHalo(QPainter& painter, const scene::MapTheme& theme, const QPointF& from, const QPointF& to,
                  Qt::PenStyle style) {
  strokeWithHalo(
      painter, theme, 1.5, [&] { painter.drawLine(from, to); }, style);
}

void paintGrip(QPainter& painter, const scene::MapTheme& theme, const QPointF& at, double radius_px) {
  painter.setPen(QPen(theme.accent, 2));
  painter.setBrush(theme.text_halo);
  painter.drawEllipse(at, radius_px, radius_px);
}

void paintFrame(QPainter& painter, const scene::MapTheme& theme, const QRectF& frame_px) {
  painter.setBrush(scene::translucent(theme.accent, 30));
  painter.setPen(QPen(theme.accent, 1.5));
  painter.drawRect(frame_px);
}

QPointF turnHandle(const geometry::ViewTransform& view, const geometry::WorldRect& bounds,
                   const Eigen::Vector2d& pivot_m, double above_px) {
  constexpr double kInsidePx = 48;  // from the upper edge of the map
  double top = 1e9;
  for (const double x : {bounds.min_x, bounds.max_x}) {
    for (const double y : {bounds.min_y, bounds.max_y}) top = std::min(top, view.pixelFromWorld({x, y}).y());
  }
  const QPointF pivot = scene::toPoint(view.pixelFromWorld(pivot_m));
  return {pivot.x(), std::max(top - above_px, std::min(kInsidePx, pivot.y() - above_px))};
}

double turnAround(const Eigen::Vector2d& pivot_m, const Eigen::Vector2d& from_m,
                  const Eigen::Vector2d& to_m) {
  const Eigen::Vector2d from = from_m - pivot_m, to = to_m - pivot_m;
  return geometry::normalizeAngle(std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x()));
}

Eigen::Vector2d arrowStep(const geometry::ViewTransform& view, int key) {
  const Eigen::Vector2d screen(key == Qt::Key_Left    ? -1
                               : key == Qt::Key_Right ? 1
                                                      : 0,
                               key == Qt::Key_Up     ? 1
                               : key == Qt::Key_Down ? -1
                                                     : 0);
  const double turned = -view.rotation_rad;
  const Eigen::Vector2d world(std::cos(turned) * screen.x() - std::sin(turned) * screen.y(),
                              std::sin(turned) * screen.x() + std::cos(turned) * screen.y());
  return std::abs(world.x()) >= std::abs(world.y()) ? Eigen::Vector2d(std::copysign(1.0, world.x()), 0)
                                                    : Eigen::Vector2d(0, std::copysign(1.0, world.y()));
}

}  // namespace mapwright::ui

#include "moc_drag_tool.cpp"
