#include "map/live_topics.h"
#include "sentences/state_words.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"
#include "words/listed.h"

namespace mapwright::ui::scene {
namespace {

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
      const QString state = shortName(sentences::doorWord(door.state).toStdString());
      labels.add(LabelWish::Position::Beside, LabelRank::Door, mark, i,
                 door.name.empty() ? state : words::about(shortName(door.name), state), context_.theme.text);
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

// MapObject::look.
constexpr std::int64_t kOpenDoor = 0, kClosedDoor = 1, kOtherDoor = 2;

void seeDoors(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  const auto& doors = context.live->doors;
  for (std::size_t i = 0; i < doors.size(); ++i) {
    if (doors[i].polygon.size() >= 3) seePart(see, i, ObjectForm::Area, doors[i].polygon);
  }
}

std::string keyOfDoor(const LayerContext& context, FeaturesOf, std::size_t number) {
  const map::AutoDoor& door = context.live->doors[number];
  return door.mac.empty() ? door.name : door.mac;
}

MapObject describeDoor(const LayerContext& context, FeaturesOf, std::size_t number) {
  const map::AutoDoor& door = context.live->doors[number];
  MapObject object;
  object.kind = ObjectText::tr("Automatic door");
  object.name = shortName(door.name);
  object.look = door.state == "open" ? kOpenDoor : door.state == "closed" ? kClosedDoor : kOtherDoor;
  object.topic = map::topicIndex<map::AutoDoorsMessage>();
  object.properties =
      Properties()
          .add(ObjectText::tr("State"), door.state.empty() ? QString() : sentences::doorWord(door.state))
          .add(ObjectText::tr("MAC address"), door.mac);
  return object;
}

constexpr LayerObjects kDoors{seeDoors, describeDoor, keyOfDoor};

void sampleDoor(LegendSample& sample, ObjectForm, std::int64_t look) {
  const char* const state = look == kOpenDoor ? "open" : look == kClosedDoor ? "closed" : "";
  sample.live.doors = {{{}, {}, state, sample.wideBox(5)}};
}

}  // namespace

template <>
LayerSpec layerSpec<Layer::Doors>() {
  return {.name = "doors",
          .title = QT_TRANSLATE_NOOP("scene", "Auto doors"),
          .group = LayerGroup::Environment,
          .sets = LayerSet::Navigation | LayerSet::Report,
          .streams = {map::Stream::Doors},
          .topics = {map::topicIndex<map::AutoDoorsMessage>()},
          .items = oneItem<DoorsLayer>,
          .objects = &kDoors,
          .sample = sampleDoor,
          .legend = [](Legend& legend) {
            legend.addThing(LegendText::tr("Open"), ObjectForm::Area, kOpenDoor);
            legend.addThing(LegendText::tr("Closed"), ObjectForm::Area, kClosedDoor);
            legend.addThing(LegendText::tr("Moving, or state unknown"), ObjectForm::Area, kOtherDoor);
          }};
}

}  // namespace mapwright::ui::scene
