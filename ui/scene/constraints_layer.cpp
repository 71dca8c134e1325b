// What a mapping robot ties its submaps together with.
#include <array>

#include "map/live_topics.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
namespace {

/// Many short, thin segments.
class ConstraintsLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    const auto& sets = context_.live->constraints.by_name;
    const QSizeF viewport(context_.view.width_px, context_.view.height_px);
    const QRectF seen(QPointF(0, 0), viewport);
    for (const auto& [name, segments] : sets) {
      QList<QLineF> lines;
      for (const auto& [from, to] : segments) {
        const QLineF line(toPoint(context_.view.pixelFromWorld(from)),
                          toPoint(context_.view.pixelFromWorld(to)));
        if (QRectF(line.p1(), line.p2()).normalized().adjusted(-1, -1, 1, 1).intersects(seen)) lines << line;
      }
      if (lines.isEmpty()) continue;
      // Residuals are remaining errors; other constraints are only there.
      const bool residual = name.find("esidual") != std::string::npos;
      const QColor color = colorOr(residual ? context_.theme.bad : context_.theme.constraint);
      sheet_.paint(*painter, viewport, 0.8, [&](QPainter& on_sheet) {
        on_sheet.setPen(QPen(color, 0));
        on_sheet.drawLines(lines);
      });
    }
  }
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    for (const auto& [name, segments] : context_.live->constraints.by_name) {
      for (const auto& [from, to] : segments) {
        extendBy(bounds, from);
        extendBy(bounds, to);
      }
    }
    return bounds;
  }

 private:
  LineSheet sheet_;
};

void seeConstraints(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  std::size_t number = 0;
  for (const auto& [name, segments] : context.live->constraints.by_name) {
    for (const auto& [from, to] : segments) {
      const std::array line{from, to};
      seePart(see, number++, ObjectForm::Line, line);
    }
  }
}

MapObject describeConstraint(const LayerContext& context, FeaturesOf, std::size_t number) {
  MapObject object;
  object.kind = ObjectText::tr("Constraint");
  object.topic = map::topicIndex<map::ConstraintsMessage>();
  for (const auto& [name, segments] : context.live->constraints.by_name) {
    if (number < segments.size()) {
      object.name = shortName(name);
      object.look = name.find("esidual") != std::string::npos ? 1 : 0;
      break;
    }
    number -= segments.size();
  }
  return object;
}

constexpr LayerObjects kConstraints{seeConstraints, describeConstraint, noKey, false};

void sampleConstraints(LegendSample& sample, ObjectForm, std::int64_t look) {
  const double reach = sample.reachPx();
  const auto at = &LegendSample::at;
  sample.live.constraints.by_name[look == 0 ? "constraints" : "residuals"] = {{at(-reach, 3), at(0, -5)},
                                                                              {at(0, -5), at(reach, 5)}};
}

}  // namespace

template <>
LayerSpec layerSpec<Layer::Constraints>() {
  return {.name = "constraints",
          .title = QT_TRANSLATE_NOOP("scene", "Constraints"),
          .shown = false,
          .sets = LayerSet::Mapping,
          .streams = {map::Stream::Constraints},
          .topics = {map::topicIndex<map::ConstraintsMessage>()},
          .traits = [] { return lineTraits(1); },
          .items = oneItem<ConstraintsLayer>,
          .objects = &kConstraints,
          .sample = sampleConstraints,
          .legend =
              [](Legend& legend) {
                legend.addThing(LegendText::tr("Constraint"), ObjectForm::Line, 0);
                legend.addThing(LegendText::tr("Residual: the error that remains"), ObjectForm::Line, 1);
              }};
}

}  // namespace mapwright::ui::scene
