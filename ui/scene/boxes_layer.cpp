// Pallets, racks, detected objects, and the robot's other drawings.
#include <algorithm>
#include <array>
#include <cmath>

#include "map/live_topics.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
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

/// nullopt: it is placed by the robot, and that is not known.
std::optional<geometry::Pose2> placeOf(const LayerContext& context, const map::GroundBox& box) {
  if (!box.in_robot_frame) return box.pose;
  const auto robot = context.robotPose();
  return robot ? std::optional(*robot * box.pose) : std::nullopt;
}

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
  void robotMoved(const QRectF&, const QRectF&) override {
    for (const map::BoxGroup& group : map::boxGroups(*context_.live)) {
      for (const map::GroundBox& box : *group.boxes) {
        if (box.in_robot_frame) return liveChanged();
      }
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
      labels.add(LabelWish::Position::Beside, LabelRank::Thing, QRectF(at - QPointF(1, 1), QSizeF(2, 2)), id,
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
    std::vector<Box> boxes;
    for (const map::BoxGroup& group : map::boxGroups(*context_.live)) {
      for (const map::GroundBox& box : *group.boxes) {
        if (const auto pose = placeOf(context_, box)) boxes.push_back({&box, *pose});
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
    geometry::WorldRect bounds;
    for (const map::GroundDrawing& drawing : context_.live->drawings) bounds.extend(boundsOf(drawing.points));
    for (const Box& box : boxes()) extendBy(bounds, {box.pose.x_m, box.pose.y_m});
    return bounds;
  }
};

/// Counted in the order in which they are drawn; with the group that it belongs to.
std::pair<const map::GroundBox*, map::BoxGroup> boxInGroup(const map::LiveState& live, std::size_t number) {
  for (const map::BoxGroup& group : map::boxGroups(live)) {
    if (number < group.boxes->size()) return {&(*group.boxes)[number], group};
    number -= group.boxes->size();
  }
  return {};
}

QString kindOf(map::BoxKind kind) {
  switch (kind) {
    case map::BoxKind::Pallet:
      return ObjectText::tr("Pallet");
    case map::BoxKind::Rack:
      return ObjectText::tr("Rack");
    case map::BoxKind::Charger:
      return ObjectText::tr("Charger");
    case map::BoxKind::Object:
      break;
  }
  return ObjectText::tr("Seen object");
}

void seeBoxes(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  for (std::size_t i = 0;; ++i) {
    const map::GroundBox* const box = boxInGroup(*context.live, i).first;
    if (!box) return;
    const auto pose = placeOf(context, *box);
    if (!pose) continue;
    const double a = box->length_m / 2, b = box->width_m / 2;
    if (a > 0 && b > 0) {
      const std::array corners{pose->apply({a, b}), pose->apply({-a, b}), pose->apply({-a, -b}),
                               pose->apply({a, -b})};
      seePart(see, i, ObjectForm::Area, corners);
    } else {
      seePoint(see, i, {pose->x_m, pose->y_m});
    }
  }
}

std::string keyOfBox(const LayerContext& context, FeaturesOf, std::size_t number) {
  const map::GroundBox* const box = boxInGroup(*context.live, number).first;
  return box ? box->label : std::string();
}

MapObject describeBox(const LayerContext& context, FeaturesOf, std::size_t number) {
  const auto [at, group] = boxInGroup(*context.live, number);
  const map::GroundBox& box = *at;
  MapObject object;
  object.kind = kindOf(group.kind);
  object.topic = group.topic;
  object.name = shortName(box.label);
  object.look = box.rgba ? std::int64_t(*box.rgba) : -1;
  if (const auto pose = placeOf(context, box)) object.yaw_rad = pose->yaw_rad;
  if (box.length_m > 0 && box.width_m > 0)
    object.properties = Properties().add(
        ObjectText::tr("Size"), QStringLiteral("%1 × %2").arg(metres(box.length_m), metres(box.width_m)));
  return object;
}

constexpr LayerObjects kBoxes{seeBoxes, describeBox, keyOfBox};

void sampleBox(LegendSample& sample, ObjectForm form, std::int64_t look) {
  map::GroundBox box;
  if (look >= 0) box.rgba = std::uint32_t(look);
  if (form == ObjectForm::Area) {
    box.length_m = 2 * (sample.reachPx() - 1) * LegendSample::kMPerPx;
    box.width_m = 14 * LegendSample::kMPerPx;
  }
  sample.live.seen_objects = {box};
}

}  // namespace

template <>
LayerSpec layerSpec<Layer::Boxes>() {
  return {
      .name = "boxes",
      .title = QT_TRANSLATE_NOOP("scene", "Pallets, racks, markers"),
      .group = LayerGroup::Environment,
      .sets = LayerSet::Navigation | LayerSet::Report,
      .streams = {map::Stream::Pallets, map::Stream::Racks, map::Stream::SeenObjects},
      .always_on = {map::Stream::Pose},
      .topics = {map::topicIndex<map::PalletsMessage>(), map::topicIndex<map::RackMessage>(),
                 map::topicIndex<map::DetectedFeaturesMessage>(), map::topicIndex<map::SeenObjectsMessage>()},
      .traits = [] { return LayerTraits{.color = true}; },
      .items = oneItem<BoxesLayer>,
      .objects = &kBoxes,
      .sample = sampleBox,
      .legend =
          [](Legend& legend) {
            legend.addThing(LegendText::tr("Pallet, rack or object, with its heading"), ObjectForm::Area, -1);
          }};
}

}  // namespace mapwright::ui::scene
