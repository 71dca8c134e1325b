// Landmarks seen by the robot, or those of an opened map.
#include <QHashFunctions>

#include "map/live_topics.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
namespace {

const std::vector<map::Landmark>& landmarksOf(const LayerContext& context, FeaturesOf of) {
  return of == FeaturesOf::Robot ? context.live->landmarks : context.of(of).landmarks;
}

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
    for (const map::Landmark& landmark : landmarks()) extendBy(bounds, landmark.position_m);
    return bounds;
  }
  LabelUse labelUse() const override { return LabelUse::Names; }
  void collectLabels(LabelCollector& labels) const override {
    for (const map::Landmark& landmark : landmarks()) {
      const QRectF mark = diamondOf(landmark).boundingRect();
      labels.symbol(mark);
      if (!labels.named(mark)) continue;
      labels.add(LabelWish::Position::Beside, LabelRank::Landmark, mark, qHash(QByteArrayView(landmark.id)),
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
  const std::vector<map::Landmark>& landmarks() const { return landmarksOf(context_, *of()); }
  QPolygonF diamondOf(const map::Landmark& landmark) const {
    const QPointF at = toPoint(context_.view.pixelFromWorld(landmark.position_m));
    return {at + QPointF(0, -7), at + QPointF(7, 0), at + QPointF(0, 7), at + QPointF(-7, 0)};
  }
};

void seeLandmarks(const LayerContext& context, FeaturesOf of, const SeeObject& see) {
  seePoints(landmarksOf(context, of), see);
}

std::string keyOfLandmark(const LayerContext& context, FeaturesOf of, std::size_t number) {
  return landmarksOf(context, of)[number].id;
}

MapObject describeLandmark(const LayerContext& context, FeaturesOf of, std::size_t number) {
  const map::Landmark& landmark = landmarksOf(context, of)[number];
  MapObject object;
  object.kind = ObjectText::tr("Landmark");
  object.name = shortName(landmark.id);
  object.look = landmark.in_use.value_or(true) ? 1 : 0;
  if (of == FeaturesOf::Robot) object.topic = map::topicIndex<map::LandmarksMessage>();
  object.properties = Properties().add(ObjectText::tr("In use"), landmark.in_use);
  return object;
}

constexpr LayerObjects kLandmarks{seeLandmarks, describeLandmark, keyOfLandmark};

}  // namespace

template <>
LayerSpec layerSpec<Layer::Landmarks>() {
  return {.name = "landmarks",
          .title = QT_TRANSLATE_NOOP("scene", "Landmarks"),
          .group = LayerGroup::Environment,
          .sets = LayerSet::Navigation | LayerSet::Mapping | LayerSet::Report,
          .streams = {map::Stream::Landmarks},
          .topics = {map::topicIndex<map::LandmarksMessage>()},
          .traits = [] { return LayerTraits{.color = true}; },
          .why_empty = noMapFeaturesReason,
          .items = itemForEachMap<LandmarksLayer>,
          .objects = &kLandmarks,
          .sample =
              [](LegendSample& sample, ObjectForm, std::int64_t look) {
                sample.live.landmarks = {{{}, {0, 0}, look != 0}};
              },
          .legend =
              [](Legend& legend) {
                legend.addThing(LegendText::tr("Landmark"), ObjectForm::Point, 1);
                legend.addThing(LegendText::tr("Landmark that is not in use"), ObjectForm::Point, 0);
              }};
}

}  // namespace mapwright::ui::scene
