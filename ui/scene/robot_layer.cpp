#include <cmath>

#include <QPainter>
#include <QPainterPath>

#include "scene/map_layers.h"

namespace mapwright::scene {
namespace {

constexpr double kMarkPx = 11;  // half the length of the mark

}  // namespace

TrailLayer::TrailLayer(const LayerContext& context, const map::LiveState& live)
    : LayerItem(context), live_(live) {}

void TrailLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (live_.trail.size() < 2) return;
  QPolygonF line;
  for (const Eigen::Vector2d& point : live_.trail) {
    const QPointF pixel = toPoint(context_.view.pixelFromWorld(point));
    // Points within two pixels of the one before change nothing that can be seen.
    if (line.isEmpty() ||
        std::abs(pixel.x() - line.last().x()) + std::abs(pixel.y() - line.last().y()) >= 2) {
      line << pixel;
    }
  }
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setBrush(Qt::NoBrush);
  painter->setPen(QPen(context_.theme.trail, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter->drawPolyline(line);
}

RobotLayer::RobotLayer(const LayerContext& context, const map::LiveState& live)
    : LayerItem(context), live_(live) {}

QRectF RobotLayer::robotRect() const {
  if (!live_.robot_pose) return {};
  double reach_m = 0;
  for (const Eigen::Vector2d& corner : live_.model.footprint) reach_m = std::max(reach_m, corner.norm());
  const double reach = std::max(kMarkPx, reach_m / context_.view.scale_m_per_px) + 4;
  const QPointF center =
      toPoint(context_.view.pixelFromWorld({live_.robot_pose->x_m, live_.robot_pose->y_m}));
  return {center.x() - reach, center.y() - reach, 2 * reach, 2 * reach};
}

void RobotLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (!live_.robot_pose) return;
  const geometry::Pose2& pose = *live_.robot_pose;
  painter->setRenderHint(QPainter::Antialiasing);
  if (live_.model.footprint.size() >= 3) {
    QPolygonF outline;
    for (const Eigen::Vector2d& corner : live_.model.footprint) {
      outline << toPoint(context_.view.pixelFromWorld(pose.apply(corner)));
    }
    QColor fill = context_.theme.robot;
    fill.setAlpha(70);
    painter->setBrush(fill);
    painter->setPen(QPen(context_.theme.robot, 1.5));
    painter->drawPolygon(outline);
  }
  const QPointF center = toPoint(context_.view.pixelFromWorld({pose.x_m, pose.y_m}));
  const double heading = pose.yaw_rad + context_.view.rotation_rad;
  const auto at = [&](double along, double across) {
    const double c = std::cos(heading), s = std::sin(heading);
    return center + QPointF(along * c - across * s, -(along * s + across * c));
  };
  QPainterPath mark(at(kMarkPx, 0));
  mark.lineTo(at(-0.8 * kMarkPx, 0.75 * kMarkPx));
  mark.lineTo(at(-0.4 * kMarkPx, 0));
  mark.lineTo(at(-0.8 * kMarkPx, -0.75 * kMarkPx));
  mark.closeSubpath();
  painter->setPen(QPen(context_.theme.robot_outline, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter->setBrush(context_.theme.robot);
  painter->drawPath(mark);
}

}  // namespace mapwright::scene
