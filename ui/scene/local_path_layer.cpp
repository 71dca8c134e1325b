// The next part of the path.
#include <algorithm>

#include "map/live_topics.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
namespace {

/// The local path as a band of the robot's width.
class LocalPathLayer : public SmallLayer {
 public:
  using SmallLayer::SmallLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override {
    markPainted();
    const map::LocalPathMessage& path = context_.live->local_path;
    if (path.points.size() < 2) return;
    QColor color = translucent(colorOr(context_.theme.path), 90);
    if (path.rgba && !style().color.isValid()) {
      color = QColor(int(*path.rgba >> 24 & 255), int(*path.rgba >> 16 & 255), int(*path.rgba >> 8 & 255),
                     std::max(60, int(*path.rgba & 255)));
    }
    const double width = widthPx();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter->drawPath(pathOf(visibleLines(context_.view, path.points, width, option->exposedRect)));
  }

 protected:
  QRectF reach() const override { return reachOf(context_.live->local_path.points, widthPx()); }

 private:
  double widthPx() const {
    return std::clamp(context_.live->local_path.width_m / context_.view.scale_m_per_px, 3.0, 4000.0);
  }
  geometry::WorldRect contentBounds() const override { return boundsOf(context_.live->local_path.points); }
};

void seeLocalPath(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  seeLine(context.live->local_path.points, see);
}

MapObject describeLocalPath(const LayerContext& context, FeaturesOf, std::size_t) {
  const map::LocalPathMessage& path = context.live->local_path;
  MapObject object =
      oneLine(ObjectText::tr("Local path"), path.points.size(), map::topicIndex<map::LocalPathMessage>());
  if (path.width_m > 0) object.properties.push_back({ObjectText::tr("Width"), metres(path.width_m)});
  return object;
}

constexpr LayerObjects kLocalPath{seeLocalPath, describeLocalPath};

void sampleLocalPath(LegendSample& sample, ObjectForm, std::int64_t) {
  sample.live.local_path.points = sample.line();
  sample.live.local_path.width_m = 12 * LegendSample::kMPerPx;
}

}  // namespace

template <>
LayerSpec layerSpec<Layer::LocalPath>() {
  return {.name = "local-path",
          .title = QT_TRANSLATE_NOOP("scene", "Local path"),
          .group = LayerGroup::Robot,
          .sets = LayerSet::Navigation | LayerSet::Report,
          .streams = {map::Stream::LocalPath},
          .always_on = {map::Stream::Pose},
          .topics = {map::topicIndex<map::LocalPathMessage>()},
          .topic_chosen = true,
          .lively = true,
          .traits = [] { return LayerTraits{.color = true}; },
          .items = oneItem<LocalPathLayer>,
          .objects = &kLocalPath,
          .sample = sampleLocalPath,
          .legend =
              [](Legend& legend) {
                legend.addThing(LegendText::tr("Next part of the path, as wide as the robot"),
                                ObjectForm::Line);
              }};
}

}  // namespace mapwright::ui::scene
