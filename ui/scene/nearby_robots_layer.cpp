#include <QHashFunctions>

#include "map/live_topics.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
namespace {

/// Other robots, with their footprints and where they are headed.
class NearbyRobotsLayer : public SmallLayer {
 public:
  using SmallLayer::SmallLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    markPainted();
    const QColor color = colorOr(context_.theme.other_robot);
    painter->setRenderHint(QPainter::Antialiasing);
    for (const map::NearbyRobot& other : context_.live->nearby_robots) {
      painter->setBrush(Qt::NoBrush);
      painter->setPen(QPen(translucent(color, 150), 2, Qt::DotLine));
      for (const QPolygonF& line : visibleLines(context_.view, other.trend, 4)) painter->drawPolyline(line);
      const auto outline = context_.live->nearby_footprints.find(other.footprint_digest);
      if (outline != context_.live->nearby_footprints.end() && outline->second.size() >= 3) {
        QPolygonF polygon;
        for (const Eigen::Vector2d& corner : outline->second) {
          polygon << toPoint(context_.view.pixelFromWorld(other.pose.apply(corner)));
        }
        painter->setBrush(translucent(color, 70));
        painter->setPen(QPen(color, 1.5));
        painter->drawPolygon(polygon);
      }
      drawPlace(*painter, context_, {other.pose.x_m, other.pose.y_m}, other.pose.yaw_rad, color);
    }
  }
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    for (const map::NearbyRobot& other : context_.live->nearby_robots)
      extendBy(bounds, {other.pose.x_m, other.pose.y_m});
    return bounds;
  }
  LabelUse labelUse() const override { return LabelUse::Names; }
  void collectLabels(LabelCollector& labels) const override {
    for (const map::NearbyRobot& other : context_.live->nearby_robots) {
      labelPlace(labels, context_, {other.pose.x_m, other.pose.y_m}, other.pose.yaw_rad, LabelRank::Robot,
                 qHash(QByteArrayView(other.uid)), shortName(other.uid));
    }
  }

 protected:
  QRectF reach() const override {
    std::vector<Eigen::Vector2d> points;
    for (const map::NearbyRobot& other : context_.live->nearby_robots) {
      points.insert(points.end(), other.trend.begin(), other.trend.end());
      points.emplace_back(other.pose.x_m, other.pose.y_m);
      const auto outline = context_.live->nearby_footprints.find(other.footprint_digest);
      if (outline == context_.live->nearby_footprints.end()) continue;
      for (const Eigen::Vector2d& corner : outline->second) points.push_back(other.pose.apply(corner));
    }
    return reachOf(points, 20);
  }
};

void seeNearby(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  const auto& robots = context.live->nearby_robots;
  for (std::size_t i = 0; i < robots.size(); ++i) seePoint(see, i, {robots[i].pose.x_m, robots[i].pose.y_m});
}

std::string keyOfNearby(const LayerContext& context, FeaturesOf, std::size_t number) {
  return context.live->nearby_robots[number].uid;
}

MapObject describeNearby(const LayerContext& context, FeaturesOf, std::size_t number) {
  const map::NearbyRobot& robot = context.live->nearby_robots[number];
  MapObject object;
  object.kind = ObjectText::tr("Nearby robot");
  object.name = shortName(robot.uid);
  object.yaw_rad = robot.pose.yaw_rad;
  object.topic = map::topicIndex<map::NearbyRobotsMessage>();
  return object;
}

constexpr LayerObjects kNearbyRobots{seeNearby, describeNearby, keyOfNearby};

void sampleNearby(LegendSample& sample, ObjectForm, std::int64_t) {
  const double half_px = sample.reachPx() / 2;
  map::NearbyRobot other;
  const Eigen::Vector2d at = LegendSample::at(-half_px, 0);
  other.pose = {at.x(), at.y(), 0};
  other.footprint_digest = "f";
  other.trend = {at, LegendSample::at(sample.reachPx(), 0)};
  sample.live.nearby_footprints["f"] = LegendSample::box(half_px, 7);
  sample.live.nearby_robots = {other};
}

}  // namespace

template <>
LayerSpec layerSpec<Layer::NearbyRobots>() {
  return {.name = "robots",
          .title = QT_TRANSLATE_NOOP("scene", "Nearby robots"),
          .group = LayerGroup::Environment,
          .sets = LayerSet::Navigation | LayerSet::Report,
          .streams = {map::Stream::NearbyRobots, map::Stream::NearbyFootprints},
          .topics = {map::topicIndex<map::NearbyRobotsMessage>(),
                     map::topicIndex<map::NearbyFootprintsMessage>()},
          .lively = true,
          .traits = [] { return LayerTraits{.color = true}; },
          .items = oneItem<NearbyRobotsLayer>,
          .objects = &kNearbyRobots,
          .sample = sampleNearby,
          .legend =
              [](Legend& legend) {
                legend.addThing(LegendText::tr("Other robot; dotted: where it is going"), ObjectForm::Point);
              }};
}

}  // namespace mapwright::ui::scene
