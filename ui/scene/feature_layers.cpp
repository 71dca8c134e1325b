// Features of the map: doors, boxes, landmarks, overlays, waypoints.
#include <algorithm>
#include <cmath>

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include "scene/ground_drawings.h"
#include "scene/live_layers.h"
#include "sentences/overlay_name.h"
#include "words/qt_plain.h"

namespace mapwright::scene {
namespace {

constexpr double kNameFromMPerPx = 0.12;  // names appear when a pixel is no larger than this
constexpr int kLongestName = 40;

QColor opaque(QColor color) { return translucent(color, 255); }

QPolygonF toPolygon(const geometry::ViewTransform& view, const std::vector<Eigen::Vector2d>& world) {
  QPolygonF polygon;
  for (const Eigen::Vector2d& corner : world) polygon << toPoint(view.pixelFromWorld(corner));
  return polygon;
}

bool inView(const geometry::ViewTransform& view, const QRectF& rect) {
  return rect.adjusted(-20, -20, 20, 20).intersects(QRectF(0, 0, view.width_px, view.height_px));
}

/// One line, no markup, not too long.
QString shortName(const std::string& name) {
  QString text = words::plainName(name);
  if (text.size() > kLongestName) text = text.left(kLongestName - 1) + QChar(0x2026);
  return text;
}

QColor regionColor(const MapTheme& theme, int type) {
  switch (type) {
    case 1:   // forbidden
    case 6:   // drop risk
    case 10:  // exclusive
      return theme.bad;
    case 2:  // slow
    case 7:  // slope
    case 8:  // deceitful
    case 9:  // narrow
    case 15:
      return theme.warn;
    case 12:  // free space
    case 13:  // charging
      return theme.good;
    default:
      return theme.region;
  }
}

QColor pointColor(const MapTheme& theme, int type) {
  switch (type) {
    case 9:
    case 36:
      return theme.good;
    case 37:
    case 39:
      return theme.constraint;
    default:
      return theme.place;
  }
}

}  // namespace

void drawHeading(QPainter& painter, const LayerContext& context, const QPointF& at, double yaw_rad,
                 const QColor& color) {
  const double heading = yaw_rad + context.view.rotation_rad;
  const QPointF tip = at + QPointF(std::cos(heading), -std::sin(heading)) * 13;
  painter.setPen(QPen(context.theme.text_halo, 5, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(at, tip);
  painter.setPen(QPen(color, 2.5, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(at, tip);
}

void drawPlace(QPainter& painter, const LayerContext& context, const Eigen::Vector2d& world_m,
               std::optional<double> yaw_rad, const QColor& color, const QString& name) {
  const QPointF at = toPoint(context.view.pixelFromWorld(world_m));
  if (!inView(context.view, QRectF(at, QSizeF(1, 1)).adjusted(-200, 0, 0, 0))) return;
  painter.setRenderHint(QPainter::Antialiasing);
  if (yaw_rad) drawHeading(painter, context, at, *yaw_rad, color);
  painter.setPen(QPen(context.theme.text_halo, 1.5));
  painter.setBrush(color);
  painter.drawEllipse(at, 5, 5);
  if (!name.isEmpty() && context.view.scale_m_per_px <= kNameFromMPerPx) {
    drawName(painter, context, QRectF(at - QPointF(5, 5), QSizeF(10, 10)), name, context.theme.text);
  }
}

void DoorsLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  for (const map::AutoDoor& door : context_.live->doors) {
    const QPolygonF polygon = toPolygon(context_.view, door.polygon);
    if (polygon.size() < 3 || !inView(context_.view, polygon.boundingRect())) continue;
    const bool open = door.state == "open", closed = door.state == "closed";
    const QColor color = open ? context_.theme.good : closed ? context_.theme.bad : context_.theme.warn;
    // Also by shape: a closed door is filled, an open one is an outline, a moving one dashed.
    painter->setBrush(closed ? QBrush(translucent(color, 110)) : QBrush(translucent(color, 30)));
    painter->setPen(QPen(color, 2, open || closed ? Qt::SolidLine : Qt::DashLine));
    painter->drawPolygon(polygon);
    const QString state = shortName(door.state.empty() ? "unknown" : door.state);
    if (context_.view.scale_m_per_px <= kNameFromMPerPx) {
      drawName(*painter, context_, polygon.boundingRect(),
               door.name.empty() ? state : shortName(door.name) + QStringLiteral(": ") + state,
               context_.theme.text);
    }
  }
}

void BoxesLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const map::LiveState& live = *context_.live;
  const QColor common = colorOr(context_.theme.place);
  drawGroundDrawings(*painter, context_, live.drawings, common);
  painter->setRenderHint(QPainter::Antialiasing);
  for (const auto* boxes : {&live.pallets, &live.racks, &live.seen_objects}) {
    for (const map::GroundBox& box : *boxes) {
      const auto robot = context_.robotPose();
      if (box.in_robot_frame && !robot) continue;
      const geometry::Pose2 pose = box.in_robot_frame ? *robot * box.pose : box.pose;
      // The user's choice takes precedence over the robot's.
      const QColor color = box.rgba && !style().color.isValid() ? opaque(colorFrom(*box.rgba)) : common;
      const double a = box.length_m / 2, b = box.width_m / 2;
      if (a > 0 && b > 0) {
        const QPolygonF polygon = toPolygon(context_.view, {pose.apply({a, b}), pose.apply({-a, b}),
                                                            pose.apply({-a, -b}), pose.apply({a, -b})});
        if (!inView(context_.view, polygon.boundingRect())) continue;
        painter->setBrush(translucent(color, 50));
        painter->setPen(QPen(color, 2));
        painter->drawPolygon(polygon);
      }
      drawPlace(*painter, context_, {pose.x_m, pose.y_m}, pose.yaw_rad, color, shortName(box.label));
    }
  }
}

LandmarksLayer::LandmarksLayer(const LayerContext& context, Source landmarks)
    : LayerItem(context), landmarks_(std::move(landmarks)) {}

void LandmarksLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const QColor color = colorOr(context_.theme.constraint);
  painter->setRenderHint(QPainter::Antialiasing);
  for (const map::Landmark& landmark : landmarks_()) {
    const QPointF at = toPoint(context_.view.pixelFromWorld(landmark.position_m));
    if (!inView(context_.view, QRectF(at, QSizeF(1, 1)))) continue;
    QPolygonF diamond{at + QPointF(0, -7), at + QPointF(7, 0), at + QPointF(0, 7), at + QPointF(-7, 0)};
    painter->setPen(QPen(context_.theme.text_halo, 1.5));
    // One that is not in use is hollow.
    painter->setBrush(landmark.in_use.value_or(true) ? QBrush(color) : QBrush(Qt::NoBrush));
    if (!landmark.in_use.value_or(true)) painter->setPen(QPen(color, 2));
    painter->drawPolygon(diamond);
    if (context_.view.scale_m_per_px <= kNameFromMPerPx) {
      drawName(*painter, context_, diamond.boundingRect(), shortName(landmark.id), context_.theme.text);
    }
  }
}

OverlaysLayer::OverlaysLayer(const LayerContext& context, const std::vector<map::OverlayFeature>& features)
    : LayerItem(context), features_(features) {}

void OverlaysLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  using map::OverlayShape;
  painter->setRenderHint(QPainter::Antialiasing);
  for (const OverlayShape shape : {OverlayShape::Polygon, OverlayShape::Line, OverlayShape::Point}) {
    for (const map::OverlayFeature& feature : features_) {
      if (feature.shape != shape) continue;
      if (shape == OverlayShape::Polygon) paintRegion(*painter, feature);
      if (shape == OverlayShape::Line) paintLine(*painter, feature);
      if (shape == OverlayShape::Point && !feature.parts.empty() && !feature.parts[0].empty()) {
        const QString name =
            feature.name.empty() ? sentences::nameOf(feature.shape, feature.type) : shortName(feature.name);
        drawPlace(*painter, context_, feature.parts[0][0], feature.yaw_rad,
                  pointColor(context_.theme, feature.type), name);
      }
    }
  }
}

void OverlaysLayer::paintRegion(QPainter& painter, const map::OverlayFeature& feature) const {
  QPainterPath path;
  for (const auto& ring : feature.parts) path.addPolygon(toPolygon(context_.view, ring));
  path.closeSubpath();
  const QRectF bounds = path.boundingRect();
  if (!inView(context_.view, bounds)) return;
  path.setFillRule(Qt::OddEvenFill);
  const QColor color = regionColor(context_.theme, feature.type);
  painter.setPen(QPen(color, 1.5));
  painter.setBrush(translucent(color, 34));
  painter.drawPath(path);
  if (feature.type == 1) {  // forbidden: hatched as well, not only coloured
    painter.setPen(Qt::NoPen);
    painter.setBrush(QBrush(translucent(color, 110), Qt::BDiagPattern));
    painter.drawPath(path);
  }
  const QString name =
      feature.name.empty() ? sentences::nameOf(feature.shape, feature.type) : shortName(feature.name);
  if (context_.view.scale_m_per_px <= kNameFromMPerPx && bounds.width() > 60) {
    const QFontMetricsF metrics(context_.theme.label_font);
    QRectF spot(0, 0, metrics.horizontalAdvance(name), metrics.height());
    spot.moveCenter(bounds.center());
    if (context_.labels->take({&spot, 1})) {
      drawLabel(painter, {spot.left(), spot.top() + metrics.ascent()}, name, context_.theme, color);
    }
  }
}

void OverlaysLayer::paintLine(QPainter& painter, const map::OverlayFeature& feature) const {
  const bool wall = feature.type == 2;
  const QColor color = wall                ? context_.theme.bad
                       : feature.type == 1 ? context_.theme.path
                                           : context_.theme.region;
  for (const auto& part : feature.parts) {
    for (const QPolygonF& line : visibleLines(context_.view, part, 6)) {
      painter.setBrush(Qt::NoBrush);
      painter.setPen(
          QPen(context_.theme.text_halo, wall ? 5 : 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.drawPolyline(line);
      painter.setPen(
          QPen(color, wall ? 3 : 2, wall ? Qt::SolidLine : Qt::DashLine, Qt::RoundCap, Qt::RoundJoin));
      painter.drawPolyline(line);
    }
  }
}

}  // namespace mapwright::scene
