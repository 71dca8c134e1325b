#include <cmath>

#include "map/live_topics.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
namespace {

/// The robot's goal.
class TargetLayer : public SmallLayer {
 public:
  using SmallLayer::SmallLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    markPainted();
    const auto& planning = context_.live->planning;
    if (!planning) return;
    const QColor color = colorOr(context_.theme.target);
    const QRectF near_view(-kReachPx, -kReachPx, context_.view.width_px + 2 * kReachPx,
                           context_.view.height_px + 2 * kReachPx);
    for (const geometry::Pose2& target : planning->targets) {
      const QPointF at = toPoint(context_.view.pixelFromWorld({target.x_m, target.y_m}));
      if (!near_view.contains(at)) continue;
      const double heading = target.yaw_rad + context_.view.rotation_rad;
      if (planning->targets.size() > kFew) {  // a cloud of them
        painter->setPen(QPen(color, 1.5));
        painter->drawLine(at, at + QPointF(std::cos(heading), -std::sin(heading)) * 7);
        continue;
      }
      painter->setRenderHint(QPainter::Antialiasing);
      painter->setBrush(Qt::NoBrush);
      for (const auto& [pen_color, width] :
           {std::pair{context_.theme.text_halo, 5.0}, std::pair{color, 2.0}}) {
        painter->setPen(QPen(pen_color, width, Qt::SolidLine, Qt::RoundCap));
        painter->drawEllipse(at, 9, 9);
        painter->drawLine(at, at + QPointF(std::cos(heading), -std::sin(heading)) * 16);
      }
      painter->setBrush(color);
      painter->drawEllipse(at, 2, 2);
    }
  }
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    if (!context_.live->planning) return bounds;
    for (const geometry::Pose2& target : context_.live->planning->targets)
      extendBy(bounds, {target.x_m, target.y_m});
    return bounds;
  }
  LabelUse labelUse() const override { return LabelUse::Symbols; }
  void collectLabels(LabelCollector& labels) const override {
    const auto& planning = context_.live->planning;
    if (!planning || planning->targets.size() > kFew) return;
    for (const geometry::Pose2& target : planning->targets) {
      const QPointF at = toPoint(context_.view.pixelFromWorld({target.x_m, target.y_m}));
      keepClear(labels, context_, QRectF(at - QPointF(11, 11), QSizeF(22, 22)), target.yaw_rad);
    }
  }

 protected:
  QRectF reach() const override {
    std::vector<Eigen::Vector2d> points;
    if (const auto& planning = context_.live->planning) {
      for (const geometry::Pose2& target : planning->targets) points.emplace_back(target.x_m, target.y_m);
    }
    return reachOf(points, kReachPx);
  }

 private:
  static constexpr std::size_t kFew = 50;
  static constexpr double kReachPx = 20;
};

void seeTargets(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  if (!context.live->planning) return;
  const auto& targets = context.live->planning->targets;
  for (std::size_t i = 0; i < targets.size(); ++i) seePoint(see, i, {targets[i].x_m, targets[i].y_m});
}

MapObject describeTarget(const LayerContext& context, FeaturesOf, std::size_t number) {
  const map::PlanningState& planning = *context.live->planning;
  MapObject object;
  object.kind = ObjectText::tr("Target");
  object.yaw_rad = planning.targets[number].yaw_rad;
  object.topic = map::topicIndex<map::PlanningState>();
  Properties known;
  known.add(ObjectText::tr("Movement"), planning.move_state)
      .add(ObjectText::tr("Action"), planning.action_type);
  if (planning.remaining_distance_m)
    known.add(ObjectText::tr("Distance left"), metres(*planning.remaining_distance_m));
  known.add(ObjectText::tr("Why it failed"), planning.fail_reason);
  object.properties = known;
  return object;
}

constexpr LayerObjects kTargets{seeTargets, describeTarget};

void sampleTarget(LegendSample& sample, ObjectForm, std::int64_t) {
  const Eigen::Vector2d place = LegendSample::at(-3, 0);
  sample.live.planning.emplace().targets = {{place.x(), place.y(), 0}};
}

}  // namespace

template <>
LayerSpec layerSpec<Layer::Target>() {
  return {.name = "target",
          .title = QT_TRANSLATE_NOOP("scene", "Target"),
          .group = LayerGroup::Robot,
          .sets = LayerSet::Navigation | LayerSet::Report,
          .streams = {map::Stream::Planning},
          .topics = {map::topicIndex<map::PlanningState>()},
          .topic_chosen = true,
          .traits = [] { return LayerTraits{.color = true}; },
          .items = oneItem<TargetLayer>,
          .objects = &kTargets,
          .sample = sampleTarget,
          .legend =
              [](Legend& legend) {
                legend.addThing(LegendText::tr("Target, with its heading"), ObjectForm::Point);
              }};
}

}  // namespace mapwright::ui::scene
