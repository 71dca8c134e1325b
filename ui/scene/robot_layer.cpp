// The robot: its mark, its footprints and its recent path.
#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainterPath>

#include "map/live_state.h"
#include "map/live_topics.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
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
  void robotMoved(const QRectF&, const QRectF& to) override {
    if (context_.live->trail.size() != std::exchange(length_, context_.live->trail.size())) update(to);
  }
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    for (const map::TrailPoint& point : context_.live->trail) extendBy(bounds, point.position_m);
    return bounds;
  }

 private:
  std::size_t length_ = 0;
};

/// One that is drawn where the robot is.
class AtRobot : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void robotMoved(const QRectF& from, const QRectF& to) override {
    update(from);
    update(to);
  }
};

/// The footprint of the robot, or the wider one with its safety margin, if it reports them.
template <bool expanded_>
class FootprintLayer : public AtRobot {
 public:
  using AtRobot::AtRobot;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    const std::vector<Eigen::Vector2d> corners = this->corners();
    if (corners.size() < 3) return;
    const QColor color = colorOr(context_.theme.robot);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(translucent(color, expanded_ ? 24 : 70));
    painter->setPen(QPen(color, sizeOr(1.5), expanded_ ? Qt::DashLine : Qt::SolidLine));
    painter->drawPolygon(toPolygon(context_.view, corners));
  }
  geometry::WorldRect contentBounds() const override { return boundsOf(corners()); }
  LabelUse labelUse() const override { return LabelUse::Symbols; }
  void collectLabels(LabelCollector& labels) const override {
    keepSmallClear(labels, toPolygon(context_.view, corners()).boundingRect());
  }

 private:
  /// In the world; none while the robot's pose is not known.
  std::vector<Eigen::Vector2d> corners() const {
    const auto& model = context_.live->model;
    std::vector<Eigen::Vector2d> world_m;
    const auto pose = context_.robotPose();
    if (!pose) return world_m;
    for (const Eigen::Vector2d& corner : expanded_ ? model.expanded_footprint : model.footprint)
      world_m.push_back(pose->apply(corner));
    return world_m;
  }
};

/// A mark of constant size with the robot's heading.
class RobotLayer : public AtRobot {
 public:
  using AtRobot::AtRobot;
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

void seeRobot(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  const auto pose = context.robotPose();
  if (!pose) return;
  // It is hit by its mark; its footprint is as much of it.
  seePoint(see, 0, {pose->x_m, pose->y_m});
}

MapObject describeRobot(const LayerContext& context, FeaturesOf, std::size_t) {
  const map::LiveState& live = *context.live;
  MapObject object;
  object.kind = ObjectText::tr("Robot");
  object.topic = map::topicIndex<map::TrackedPose>();
  const auto pose = context.robotPose().value_or(geometry::Pose2());
  object.yaw_rad = pose.yaw_rad;
  Properties known;
  known.add(ObjectText::tr("Localization"), live.slam.state)
      .add(ObjectText::tr("Reliable"), live.slam.reliable);
  if (live.battery && live.battery->level)
    known.add(ObjectText::tr("Battery"), QStringLiteral("%1 %").arg(std::lround(*live.battery->level * 100)));
  if (live.planning) known.add(ObjectText::tr("Movement"), live.planning->move_state);
  if (live.model.width_m > 0) known.add(ObjectText::tr("Width"), metres(live.model.width_m));
  object.properties = known;
  return object;
}

void seeTrail(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  map::Polyline line;
  line.reserve(context.live->trail.size());
  for (const map::TrailPoint& point : context.live->trail) line.push_back(point.position_m);
  seeLine(line, see);
}

MapObject describeTrail(const LayerContext& context, FeaturesOf, std::size_t) {
  return oneLine(ObjectText::tr("Trail"), context.live->trail.size(), map::topicIndex<map::TrackedPose>());
}

constexpr LayerObjects kRobot{seeRobot, describeRobot};
constexpr LayerObjects kTrail{seeTrail, describeTrail};

void sampleTrail(LegendSample& sample, ObjectForm, std::int64_t) {
  const double reach = sample.reachPx();
  for (double x = -reach; x <= reach; x += 2) sample.live.trail.push_back({LegendSample::at(x, 0), x});
}

void addFootprint(Legend& legend, const QString& text) {
  legend.addSample(text, [](LegendSample& sample) {
    sample.live.robot_pose = geometry::Pose2{};
    sample.live.model.footprint = sample.live.model.expanded_footprint = LegendSample::box(16, 7);
  });
}

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
          .sets = LayerSet::Navigation | LayerSet::Mapping | LayerSet::Report | LayerSet::Snapshot,
          .always_on = {map::Stream::Pose},
          .lively = true,
          .traits = thinLines,
          .items = oneItem<TrailLayer>,
          .objects = &kTrail,
          .sample = sampleTrail,
          .legend = [](Legend& legend) {
            legend.addThing(LegendText::tr("Where the robot was"), ObjectForm::Line);
          }};
}

template <>
LayerSpec layerSpec<Layer::ExpandedFootprint>() {
  return {.name = "expanded-footprint",
          .title = QT_TRANSLATE_NOOP("scene", "Wide footprint"),
          .group = LayerGroup::Robot,
          .shown = false,
          .sets = LayerSet::Navigation,
          .always_on = {map::Stream::Pose, map::Stream::Model},
          .lively = true,
          .traits = thinLines,
          .items = oneItem<FootprintLayer<true>>,
          .legend = [](Legend& legend) {
            addFootprint(legend, LegendText::tr("The outline with its safety margin"));
          }};
}

template <>
LayerSpec layerSpec<Layer::Footprint>() {
  return {.name = "footprint",
          .title = QT_TRANSLATE_NOOP("scene", "Footprint"),
          .group = LayerGroup::Robot,
          .sets = LayerSet::Navigation | LayerSet::Mapping | LayerSet::Report | LayerSet::Snapshot,
          .always_on = {map::Stream::Pose, map::Stream::Model},
          .lively = true,
          .traits = thinLines,
          .items = oneItem<FootprintLayer<false>>,
          .legend = [](Legend& legend) { addFootprint(legend, LegendText::tr("Outline of the robot")); }};
}

template <>
LayerSpec layerSpec<Layer::Robot>() {
  return {.name = "robot",
          .title = QT_TRANSLATE_NOOP("scene", "Robot"),
          .group = LayerGroup::Robot,
          .sets = LayerSet::Navigation | LayerSet::Mapping | LayerSet::Report | LayerSet::Snapshot,
          .always_on = {map::Stream::Pose},
          .lively = true,
          .items = oneItem<RobotLayer>,
          .objects = &kRobot,
          .sample = [](LegendSample& sample, ObjectForm,
                       std::int64_t) { sample.live.robot_pose = geometry::Pose2{}; },
          .legend =
              [](Legend& legend) {
                legend.addThing(LegendText::tr("Robot; the tip is its front"), ObjectForm::Point);
              }};
}

}  // namespace mapwright::ui::scene
