// The robot: its mark, its footprints and its recent path.
#include <algorithm>
#include <cmath>

#include <QPainterPath>

#include "map/live_state.h"
#include "scene/layer_bounds.h"
#include "scene/layer_item.h"
#include "scene/legend.h"

namespace mapwright::scene {
namespace {

constexpr double kMarkPx = 11;  // half the length of the mark

/// The robot's recent path.
class TrailLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override {
    const auto& trail = context_.live->trail;
    if (trail.size() < 2) return;
    const double width = sizeOr(2);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(colorOr(context_.theme.trail), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    std::vector<Eigen::Vector2d> points;
    points.reserve(trail.size());
    const auto drawPiece = [&] {
      painter->drawPath(pathOf(visibleLines(context_.view, points, width, option->exposedRect)));
      points.clear();
    };
    for (std::size_t i = 0; i < trail.size(); ++i) {
      // If the path is unknown there is no line.
      if (i > 0 && !map::isWayKnown(trail[i - 1], trail[i])) drawPiece();
      points.push_back(trail[i].position_m);
    }
    drawPiece();
  }
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    for (const map::TrailPoint& point : context_.live->trail) extendBy(bounds, point.position_m);
    return bounds;
  }
};

/// The footprint of the robot, or the wider one with its safety margin, if it reports them.
template <bool expanded_>
class FootprintLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    const map::LiveState& live = *context_.live;
    const auto& corners = expanded_ ? live.model.expanded_footprint : live.model.footprint;
    const auto pose = context_.robotPose();
    if (!pose || corners.size() < 3) return;
    QPolygonF outline;
    for (const Eigen::Vector2d& corner : corners)
      outline << toPoint(context_.view.pixelFromWorld(pose->apply(corner)));
    const QColor color = colorOr(context_.theme.robot);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(translucent(color, expanded_ ? 24 : 70));
    painter->setPen(QPen(color, sizeOr(1.5), expanded_ ? Qt::DashLine : Qt::SolidLine));
    painter->drawPolygon(outline);
  }
  geometry::WorldRect contentBounds() const override {
    const auto& model = context_.live->model;
    const auto pose = context_.robotPose();
    geometry::WorldRect bounds;
    if (!pose) return bounds;
    for (const Eigen::Vector2d& corner : expanded_ ? model.expanded_footprint : model.footprint)
      extendBy(bounds, pose->apply(corner));
    return bounds;
  }
  LabelUse labelUse() const override { return LabelUse::Symbols; }
  void collectLabels(LabelCollector& labels) const override {
    constexpr double kLargestPx = 120;  // a larger one is not a symbol, but ground on which something lies
    const map::LiveState& live = *context_.live;
    const auto pose = context_.robotPose();
    if (!pose) return;
    QPolygonF outline;
    for (const Eigen::Vector2d& corner : expanded_ ? live.model.expanded_footprint : live.model.footprint)
      outline << toPoint(context_.view.pixelFromWorld(pose->apply(corner)));
    const QRectF area = outline.boundingRect();
    if (std::max(area.width(), area.height()) <= kLargestPx) labels.symbol(area);
  }
};

/// A mark of constant size with the robot's heading.
class RobotLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
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
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    if (const auto pose = context_.robotPose()) extendBy(bounds, {pose->x_m, pose->y_m});
    return bounds;
  }
  LabelUse labelUse() const override { return LabelUse::Symbols; }
  void collectLabels(LabelCollector& labels) const override {
    const auto pose = context_.robotPose();
    if (!pose) return;
    const QPointF center = toPoint(context_.view.pixelFromWorld({pose->x_m, pose->y_m}));
    labels.symbol(QRectF(center - QPointF(kMarkPx, kMarkPx), QSizeF(2 * kMarkPx, 2 * kMarkPx)));
  }
};

LayerTraits thinLines() { return lineTraits(2); }

}  // namespace

QRectF robotRect(const LayerContext& context) {
  const map::LiveState& live = *context.live;
  const auto pose = context.robotPose();
  if (!pose) return {};
  double reach_m = 0;
  for (const auto* outline : {&live.model.footprint, &live.model.expanded_footprint}) {
    for (const Eigen::Vector2d& corner : *outline) reach_m = std::max(reach_m, corner.norm());
  }
  const double reach = std::max(kMarkPx, reach_m / context.view.scale_m_per_px) + 8;
  const QPointF center = toPoint(context.view.pixelFromWorld({pose->x_m, pose->y_m}));
  return {center.x() - reach, center.y() - reach, 2 * reach, 2 * reach};
}

template <>
LayerSpec layerSpec<Layer::Trail>() {
  return {.name = "trail",
          .title = QT_TRANSLATE_NOOP("scene", "Trail"),
          .group = LayerGroup::Robot,
          .traits = thinLines,
          .items = oneItem<TrailLayer>,
          .legend = trailLegend};
}

template <>
LayerSpec layerSpec<Layer::ExpandedFootprint>() {
  return {.name = "expanded-footprint",
          .title = QT_TRANSLATE_NOOP("scene", "Wide footprint"),
          .group = LayerGroup::Robot,
          .shown = false,
          .traits = thinLines,
          .items = oneItem<FootprintLayer<true>>,
          .legend = expandedFootprintLegend};
}

template <>
LayerSpec layerSpec<Layer::Footprint>() {
  return {.name = "footprint",
          .title = QT_TRANSLATE_NOOP("scene", "Footprint"),
          .group = LayerGroup::Robot,
          .traits = thinLines,
          .items = oneItem<FootprintLayer<false>>,
          .legend = footprintLegend};
}

template <>
LayerSpec layerSpec<Layer::Robot>() {
  return {.name = "robot",
          .title = QT_TRANSLATE_NOOP("scene", "Robot"),
          .group = LayerGroup::Robot,
          .items = oneItem<RobotLayer>,
          .legend = robotLegend};
}

}  // namespace mapwright::scene
