// Features of the map: overlays, landmarks, doors, boxes.
#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QPainterPath>

#include "map/live_topics.h"
#include "scene/layer_bounds.h"
#include "scene/layer_item.h"
#include "scene/legend.h"
#include "sentences/overlay_name.h"

namespace mapwright::scene {
namespace {

using Kind = map::GroundDrawing::Kind;

constexpr double kThinnestPx = 1.5, kWidestPx = 400;
constexpr double kLeastPointPx = 2;
constexpr qsizetype kLongestText = 80;

double pixelsOf(const LayerContext& context, double metres, double least) {
  return std::clamp(metres / context.view.scale_m_per_px, least, kWidestPx);
}

/// Things that a robot draws on the ground.
class Brush {
 public:
  Brush(QPainter& painter, const LayerContext& context, const map::GroundDrawing& drawing,
        const QColor& color)
      : painter_(painter),
        context_(context),
        drawing_(drawing),
        own_(drawing.rgba ? colorFrom(*drawing.rgba) : color),
        coloured_(drawing.colors.size() == drawing.points.size()) {}

  void draw() {
    switch (drawing_.kind) {
      case Kind::Line:
        coloured_ ? drawPairs(1) : drawLine();
        break;
      case Kind::Segments:
        drawPairs(2);
        break;
      case Kind::Triangles:
        drawTriangles();
        break;
      case Kind::Points:
        drawPoints();
        break;
      case Kind::Text:
        break;  // a label
    }
  }

 private:
  QPointF at(std::size_t i) const { return toPoint(context_.view.pixelFromWorld(drawing_.points[i])); }
  QColor colorOf(std::size_t i) const { return coloured_ ? colorFrom(drawing_.colors[i]) : own_; }
  QPen pen(const QColor& color) const {
    const double width = pixelsOf(context_, drawing_.size_m, kThinnestPx);
    return QPen(color, width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
  }

  void drawLine() {
    const QPen own = pen(own_);
    painter_.setPen(own);
    painter_.setBrush(Qt::NoBrush);
    for (const QPolygonF& line : visibleLines(context_.view, drawing_.points, own.widthF() + 2))
      painter_.drawPolyline(line);
  }

  /// From each `step`-th point to the next.
  void drawPairs(std::size_t step) {
    for (std::size_t i = 0; i + 1 < drawing_.points.size(); i += step) {
      const QPen own = pen(colorOf(i));
      const QLineF line(at(i), at(i + 1));
      const double margin = own.widthF() + 1;
      if (!inView(context_.view, QRectF(line.p1(), line.p2()).normalized(), margin)) continue;
      painter_.setPen(own);
      painter_.drawLine(line);
    }
  }

  void drawTriangles() {
    painter_.setPen(Qt::NoPen);
    for (std::size_t i = 0; i + 2 < drawing_.points.size(); i += 3) {
      const QPolygonF triangle{at(i), at(i + 1), at(i + 2)};
      if (!inView(context_.view, triangle.boundingRect(), 1)) continue;
      painter_.setBrush(colorOf(i));
      painter_.drawPolygon(triangle);
    }
  }

  void drawPoints() {
    const double edge = pixelsOf(context_, drawing_.size_m, kLeastPointPx);
    for (std::size_t i = 0; i < drawing_.points.size(); ++i) {
      const QRectF square(at(i) - QPointF(edge / 2, edge / 2), QSizeF(edge, edge));
      if (inView(context_.view, square, 0)) painter_.fillRect(square, colorOf(i));
    }
  }

  QPainter& painter_;
  const LayerContext& context_;
  const map::GroundDrawing& drawing_;
  QColor own_;
  bool coloured_;
};

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

QColor lineColor(const MapTheme& theme, int type) {
  return type == 2 ? theme.bad : type == 1 ? theme.path : theme.region;
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

/// A small area is a symbol; a large one is ground on which something lies.
void keepSmallClear(LabelCollector& labels, const QRectF& area, double largest_px = 120) {
  if (std::max(area.width(), area.height()) <= largest_px) labels.symbol(area);
}

/// Doors with their state, as shape and colour.
class DoorsLayer : public SmallLayer {
 public:
  using SmallLayer::SmallLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    markPainted();
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
    }
  }
  LabelUse labelUse() const override { return LabelUse::Names; }
  void collectLabels(LabelCollector& labels) const override {
    for (std::size_t i = 0; i < context_.live->doors.size(); ++i) {
      const map::AutoDoor& door = context_.live->doors[i];
      const QRectF mark = toPolygon(context_.view, door.polygon).boundingRect();
      keepSmallClear(labels, mark);
      if (door.polygon.size() < 3 || !labels.named(mark)) continue;
      const QString state = shortName(door.state.empty() ? "unknown" : door.state);
      labels.add(LabelWish::Place::Beside, LabelRank::Door, mark, i,
                 door.name.empty() ? state : shortName(door.name) + QStringLiteral(": ") + state,
                 context_.theme.text);
    }
  }
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    for (const map::AutoDoor& door : context_.live->doors) bounds.extend(boundsOf(door.polygon));
    return bounds;
  }

 protected:
  QRectF reach() const override {
    std::vector<Eigen::Vector2d> points;
    for (const map::AutoDoor& door : context_.live->doors)
      points.insert(points.end(), door.polygon.begin(), door.polygon.end());
    return reachOf(points, 3);
  }
};

/// Pallets, racks, detected objects, and the robot's other drawings.
class BoxesLayer : public SmallLayer {
 public:
  using SmallLayer::SmallLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    markPainted();
    const QColor common = colorOr(context_.theme.place);
    painter->setRenderHint(QPainter::Antialiasing);
    for (const map::GroundDrawing& drawing : context_.live->drawings)
      Brush(*painter, context_, drawing, common).draw();
    for (const Box& box : boxes()) {
      // The user's choice takes precedence over the robot's.
      const QColor color =
          box.of->rgba && !style().color.isValid() ? translucent(colorFrom(*box.of->rgba), 255) : common;
      if (const QPolygonF polygon = outlineOf(box); !polygon.isEmpty()) {
        if (!inView(context_.view, polygon.boundingRect())) continue;
        painter->setBrush(translucent(color, 50));
        painter->setPen(QPen(color, 2));
        painter->drawPolygon(polygon);
      }
      drawPlace(*painter, context_, {box.pose.x_m, box.pose.y_m}, box.pose.yaw_rad, color);
    }
  }
  LabelUse labelUse() const override { return LabelUse::Names; }
  void collectLabels(LabelCollector& labels) const override {
    std::uint64_t id = 0;
    for (const Box& box : boxes()) {
      labelPlace(labels, context_, {box.pose.x_m, box.pose.y_m}, box.pose.yaw_rad, LabelRank::Thing, ++id,
                 shortName(box.of->label));
      keepSmallClear(labels, outlineOf(box).boundingRect());
    }
    for (const map::GroundDrawing& drawing : context_.live->drawings) {
      ++id;
      if (drawing.kind != Kind::Text || drawing.points.empty()) continue;
      const QColor color = drawing.rgba ? colorFrom(*drawing.rgba) : colorOr(context_.theme.place);
      const QPointF at = toPoint(context_.view.pixelFromWorld(drawing.points[0]));
      // Readable like any other label.
      labels.add(LabelWish::Place::Beside, LabelRank::Thing, QRectF(at - QPointF(1, 1), QSizeF(2, 2)), id,
                 shortName(drawing.text, kLongestText), readable(color, context_.theme));
    }
  }

 protected:
  QRectF reach() const override {
    std::vector<Eigen::Vector2d> points;
    double widest_m = 0;
    for (const map::GroundDrawing& drawing : context_.live->drawings) {
      points.insert(points.end(), drawing.points.begin(), drawing.points.end());
      widest_m = std::max(widest_m, drawing.size_m);
    }
    for (const Box& box : boxes()) {
      const double half_m = std::hypot(box.of->length_m, box.of->width_m) / 2;
      for (const double x : {-half_m, half_m}) {
        for (const double y : {-half_m, half_m}) points.emplace_back(box.pose.x_m + x, box.pose.y_m + y);
      }
    }
    return reachOf(points, 20 + pixelsOf(context_, widest_m, kThinnestPx));
  }

 private:
  struct Box {
    const map::GroundBox* of;
    geometry::Pose2 pose;
  };
  std::vector<Box> boxes() const {
    const map::LiveState& live = *context_.live;
    const auto robot = context_.robotPose();
    std::vector<Box> boxes;
    for (const map::BoxGroup& group : map::boxGroups(live)) {
      for (const map::GroundBox& box : *group.boxes) {
        if (box.in_robot_frame && !robot) continue;
        boxes.push_back({&box, box.in_robot_frame ? *robot * box.pose : box.pose});
      }
    }
    return boxes;
  }
  /// Empty: it has no size.
  QPolygonF outlineOf(const Box& box) const {
    const double a = box.of->length_m / 2, b = box.of->width_m / 2;
    if (!(a > 0 && b > 0)) return {};
    const geometry::Pose2& pose = box.pose;
    return toPolygon(context_.view,
                     {pose.apply({a, b}), pose.apply({-a, b}), pose.apply({-a, -b}), pose.apply({a, -b})});
  }
  geometry::WorldRect contentBounds() const override {
    const map::LiveState& live = *context_.live;
    geometry::WorldRect bounds;
    for (const map::GroundDrawing& drawing : live.drawings) bounds.extend(boundsOf(drawing.points));
    for (const map::BoxGroup& group : map::boxGroups(live)) {
      for (const map::GroundBox& box : *group.boxes) {
        const auto robot = context_.robotPose();
        if (box.in_robot_frame && !robot) continue;
        const geometry::Pose2 pose = box.in_robot_frame ? *robot * box.pose : box.pose;
        extendBy(bounds, {pose.x_m, pose.y_m});
      }
    }
    return bounds;
  }
};

/// Landmarks seen by the robot, or those of an opened map.
class LandmarksLayer : public SmallLayer {
 public:
  using SmallLayer::SmallLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    markPainted();
    const QColor color = colorOr(context_.theme.constraint);
    painter->setRenderHint(QPainter::Antialiasing);
    for (const map::Landmark& landmark : landmarks()) {
      const QPolygonF diamond = diamondOf(landmark);
      if (!inView(context_.view, diamond.boundingRect())) continue;
      painter->setPen(QPen(context_.theme.text_halo, 1.5));
      // One that is not in use is hollow.
      painter->setBrush(landmark.in_use.value_or(true) ? QBrush(color) : QBrush(Qt::NoBrush));
      if (!landmark.in_use.value_or(true)) painter->setPen(QPen(color, 2));
      painter->drawPolygon(diamond);
    }
  }
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    const bool robots = of() == FeaturesOf::Robot;
    for (const map::Landmark& landmark : robots ? context_.live->landmarks : context_.of(*of()).landmarks)
      extendBy(bounds, landmark.position_m);
    return bounds;
  }
  LabelUse labelUse() const override { return LabelUse::Names; }
  void collectLabels(LabelCollector& labels) const override {
    for (const map::Landmark& landmark : landmarks()) {
      const QRectF mark = diamondOf(landmark).boundingRect();
      labels.symbol(mark);
      if (!labels.named(mark)) continue;
      labels.add(LabelWish::Place::Beside, LabelRank::Landmark, mark, qHash(QByteArrayView(landmark.id)),
                 shortName(landmark.id), context_.theme.text);
    }
  }

 protected:
  QRectF reach() const override {
    std::vector<Eigen::Vector2d> points;
    for (const map::Landmark& landmark : landmarks()) points.push_back(landmark.position_m);
    return reachOf(points, 10);
  }

 private:
  const std::vector<map::Landmark>& landmarks() const {
    return of() == FeaturesOf::Robot ? context_.live->landmarks : context_.of(*of()).landmarks;
  }
  QPolygonF diamondOf(const map::Landmark& landmark) const {
    const QPointF at = toPoint(context_.view.pixelFromWorld(landmark.position_m));
    return {at + QPointF(0, -7), at + QPointF(7, 0), at + QPointF(0, 7), at + QPointF(-7, 0)};
  }
};

/// Walls, regions and places, read-only.
class OverlaysLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    using map::OverlayShape;
    painter->setRenderHint(QPainter::Antialiasing);
    for (const OverlayShape shape : {OverlayShape::Polygon, OverlayShape::Line, OverlayShape::Point}) {
      for (const map::OverlayFeature& feature : context_.of(*of()).overlays) {
        if (feature.shape != shape) continue;
        if (shape == OverlayShape::Polygon) paintRegion(*painter, feature);
        if (shape == OverlayShape::Line) paintLine(*painter, feature);
        if (shape == OverlayShape::Point && !feature.parts.empty() && !feature.parts[0].empty()) {
          drawPlace(*painter, context_, feature.parts[0][0], feature.yaw_rad,
                    overlayColor(context_.theme, feature));
        }
      }
    }
  }
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    for (const map::OverlayFeature& feature : context_.of(*of()).overlays) {
      for (const auto& part : feature.parts) bounds.extend(boundsOf(part));
    }
    return bounds;
  }
  LabelUse labelUse() const override { return LabelUse::Names; }
  void collectLabels(LabelCollector& labels) const override {
    using map::OverlayShape;
    std::uint64_t index = 0;
    for (const map::OverlayFeature& feature : context_.of(*of()).overlays) {
      ++index;
      const std::uint64_t id = feature.id.empty() ? index : qHash(QByteArrayView(feature.id));
      if (feature.shape == OverlayShape::Line || feature.parts.empty() || feature.parts[0].empty()) continue;
      if (feature.shape == OverlayShape::Point) {
        labelPlace(labels, context_, feature.parts[0][0], feature.yaw_rad, LabelRank::Waypoint, id,
                   nameOf(feature));
        continue;
      }
      // The first ring is the outer one.
      const QRectF bounds = toPolygon(context_.view, feature.parts[0]).boundingRect();
      // What lies in it still finds room around it.
      constexpr double kRegionSymbolPx = 40;
      if (!labels.fits(nameOf(feature), bounds)) keepSmallClear(labels, bounds, kRegionSymbolPx);
      if (!labels.named(bounds)) continue;
      labels.add(LabelWish::Place::Within, LabelRank::Region, bounds, id, nameOf(feature),
                 regionColor(context_.theme, feature.type));
    }
  }

 private:
  static QString nameOf(const map::OverlayFeature& feature) {
    return feature.name.empty() ? sentences::nameOf(feature.shape, feature.type) : shortName(feature.name);
  }

  void paintRegion(QPainter& painter, const map::OverlayFeature& feature) const {
    QPainterPath path;
    for (const auto& ring : feature.parts) path.addPolygon(toPolygon(context_.view, ring));
    path.closeSubpath();
    const QRectF bounds = path.boundingRect();
    if (!inView(context_.view, bounds)) return;
    path.setFillRule(Qt::OddEvenFill);
    const QColor color = overlayColor(context_.theme, feature);
    painter.setPen(QPen(color, 1.5));
    painter.setBrush(translucent(color, 34));
    painter.drawPath(path);
    if (feature.type == 1) {  // forbidden: hatched as well, not only coloured
      painter.setPen(Qt::NoPen);
      painter.setBrush(QBrush(translucent(color, 110), Qt::BDiagPattern));
      painter.drawPath(path);
    }
  }

  void paintLine(QPainter& painter, const map::OverlayFeature& feature) const {
    const bool wall = feature.type == 2;
    const QColor color = overlayColor(context_.theme, feature);
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
};

}  // namespace

QColor overlayColor(const MapTheme& theme, const map::OverlayFeature& feature) {
  switch (feature.shape) {
    case map::OverlayShape::Point:
      return pointColor(theme, feature.type);
    case map::OverlayShape::Line:
      return lineColor(theme, feature.type);
    case map::OverlayShape::Polygon:
      return regionColor(theme, feature.type);
  }
  return {};
}

template <>
LayerSpec layerSpec<Layer::Overlays>() {
  return {.name = "overlays",
          .title = QT_TRANSLATE_NOOP("scene", "Overlays"),
          .group = LayerGroup::Annotations,
          .streams = {map::Stream::MapInfo},
          .follows_robot = false,
          .why_empty = noMapFeaturesReason,
          .items = itemForEachMap<OverlaysLayer>,
          .legend = overlaysLegend};
}

template <>
LayerSpec layerSpec<Layer::Landmarks>() {
  return {.name = "landmarks",
          .title = QT_TRANSLATE_NOOP("scene", "Landmarks"),
          .group = LayerGroup::Environment,
          .streams = {map::Stream::Landmarks},
          .topics = {map::topicIndex<map::LandmarksMessage>()},
          .traits = [] { return LayerTraits{.color = true}; },
          .why_empty = noMapFeaturesReason,
          .items = itemForEachMap<LandmarksLayer>,
          .legend = landmarksLegend};
}

template <>
LayerSpec layerSpec<Layer::Doors>() {
  return {.name = "doors",
          .title = QT_TRANSLATE_NOOP("scene", "Auto doors"),
          .group = LayerGroup::Environment,
          .streams = {map::Stream::Doors},
          .topics = {map::topicIndex<map::AutoDoorsMessage>()},
          .items = oneItem<DoorsLayer>,
          .legend = doorsLegend};
}

template <>
LayerSpec layerSpec<Layer::Boxes>() {
  return {
      .name = "boxes",
      .title = QT_TRANSLATE_NOOP("scene", "Pallets, racks, markers"),
      .group = LayerGroup::Environment,
      .streams = {map::Stream::Pallets, map::Stream::Racks, map::Stream::SeenObjects},
      .topics = {map::topicIndex<map::PalletsMessage>(), map::topicIndex<map::RackMessage>(),
                 map::topicIndex<map::DetectedFeaturesMessage>(), map::topicIndex<map::SeenObjectsMessage>()},
      .traits = [] { return LayerTraits{.color = true}; },
      .items = oneItem<BoxesLayer>,
      .legend = boxesLegend};
}

}  // namespace mapwright::scene
