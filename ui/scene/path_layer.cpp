// The planned path to the target.
#include "map/live_topics.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
namespace {

constexpr double kPathPx = 3;

class PathLayer : public SmallLayer {
 public:
  using SmallLayer::SmallLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override {
    markPainted();
    drawHaloedLine(*painter, context_, colorOr(context_.theme.path), sizeOr(kPathPx), context_.live->path,
                   option->exposedRect);
  }
  geometry::WorldRect contentBounds() const override { return boundsOf(context_.live->path); }

 protected:
  QRectF reach() const override { return reachOf(context_.live->path, sizeOr(kPathPx) + 2); }
};

void seePath(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  seeLine(context.live->path, see);
}

MapObject describePath(const LayerContext& context, FeaturesOf, std::size_t) {
  return oneLine(ObjectText::tr("Path"), context.live->path.size(), map::topicIndex<map::PathMessage>());
}

constexpr LayerObjects kPath{seePath, describePath};

}  // namespace

template <>
LayerSpec layerSpec<Layer::Path>() {
  return {.name = "path",
          .title = QT_TRANSLATE_NOOP("scene", "Path"),
          .group = LayerGroup::Robot,
          .sets = LayerSet::Navigation | LayerSet::Report,
          .streams = {map::Stream::Path},
          .topics = {map::topicIndex<map::PathMessage>()},
          .topic_chosen = true,
          .traits = [] { return lineTraits(kPathPx); },
          .items = oneItem<PathLayer>,
          .objects = &kPath,
          .sample = [](LegendSample& sample, ObjectForm, std::int64_t) { sample.live.path = sample.line(); },
          .legend =
              [](Legend& legend) {
                legend.addThing(LegendText::tr("Planned path to the target"), ObjectForm::Line);
              }};
}

}  // namespace mapwright::ui::scene
