#include <algorithm>
#include <cmath>

#include <QPainter>
#include <QPainterPath>
#include <QStyleOptionGraphicsItem>

#include "map/live_state.h"
#include "scene/map_layers.h"

namespace mapwright::scene {
namespace {

constexpr double kMarkPx = 11;  // half the length of the mark

}  // namespace

void TrailLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  const auto& trail = context_.live->trail;
  if (trail.size() < 2) return;
  const double width = sizeOr(2);
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setBrush(Qt::NoBrush);
  painter->setPen(QPen(colorOr(context_.theme.trail), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  std::vector<Eigen::Vector2d> points;
  points.reserve(trail.size());
  const auto drawPiece = [&] {
    for (const QPolygonF& line : visibleLines(context_.view, points, width)) {
      const QRectF stroke = line.boundingRect().adjusted(-width, -width, width, width);
      if (stroke.intersects(option->exposedRect)) painter->drawPolyline(line);
    }
    points.clear();
  };
  for (std::size_t i = 0; i < trail.size(); ++i) {
    // If the path is unknown there is no line.
    if (i > 0 && !map::isWayKnown(trail[i - 1], trail[i])) drawPiece();
    points.push_back(trail[i].position_m);
  }
  drawPiece();
}

QRectF RobotLayer::robotRect() const {
  const map::LiveState& live = *context_.live;
  const auto pose = context_.robotPose();
  if (!pose) return {};
  double reach_m = 0;
  for (const auto* outline : {&live.model.footprint, &live.model.expanded_footprint}) {
    for (const Eigen::Vector2d& corner : *outline) reach_m = std::max(reach_m, corner.norm());
  }
  const double reach = std::max(kMarkPx, reach_m / context_.view.scale_m_per_px) + 8;
  const QPointF center = toPoint(context_.view.pixelFromWorld({pose->x_m, pose->y_m}));
  return {center.x() - reach, center.y() - reach, 2 * reach, 2 * reach};
}

FootprintLayer::FootprintLayer(const LayerContext& context, bool expanded)
    : LayerItem(context), expanded_(expanded) {}

void FootprintLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const map::LiveState& live = *context_.live;
  const auto& corners = expanded_ ? live.model.expanded_footprint : live.model.footprint;
  const auto pose = context_.robotPose();
  if (!pose || corners.size() < 3) return;
  QPolygonF outline;
  for (const Eigen::Vector2d& corner : corners) {
    outline << toPoint(context_.view.pixelFromWorld(pose->apply(corner)));
  }
  const QColor color = colorOr(context_.theme.robot);
  QColor fill = color;
  fill.setAlpha(expanded_ ? 24 : 70);
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setBrush(fill);
  painter->setPen(QPen(color, sizeOr(1.5), expanded_ ? Qt::DashLine : Qt::SolidLine));
  painter->drawPolygon(outline);
}

void RobotLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const auto drawn = context_.robotPose();
  if (!drawn) return;
  const geometry::Pose2& pose = *drawn;
  painter->setRenderHint(QPainter::Antialiasing);
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
