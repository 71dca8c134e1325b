// Loop closures of the pose graph: where each one has the robot, and where the finished map has it.
#include <array>

#include "map/closures.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
namespace {

/// How much a closure contradicts the map. Of real maps nearly none lie between 0.2 and 2 m.
enum ClosureLook { Fits, Strained, Contradicts };
constexpr double kStrainedM = 0.1, kContradictsM = 0.5;
constexpr double kPlaceDotPx = 3, kPlaceRingPx = 7;  // edges
constexpr double kPlaceRingFromPx = 6;               // shorter lines have no ring at their end

ClosureLook lookOf(const map::Closure& closure) {
  return closure.residual_m > kContradictsM ? Contradicts : closure.residual_m > kStrainedM ? Strained : Fits;
}

/// Those within one submap only say that scan matching worked: they are drawn where a list asks for them.
bool isDrawn(const LayerContext& context, const map::Closure& closure) {
  return context.closures_chosen || closure.kind == map::ConstraintKind::Inter;
}

class ClosuresLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    if (!context_.closures) return;
    const QSizeF viewport(context_.view.width_px, context_.view.height_px);
    const QRectF seen(QPointF(0, 0), viewport);
    std::array<QList<QLineF>, 3> lines;
    std::array<QList<QRectF>, 3> dots, rings;
    for (const map::Closure& closure : context_.closures->ranked) {
      if (!isDrawn(context_, closure)) continue;
      const QLineF line(toPoint(context_.view.pixelFromWorld(closure.at)),
                        toPoint(context_.view.pixelFromWorld(closure.expected)));
      if (!QRectF(line.p1(), line.p2()).normalized().adjusted(-9, -9, 9, 9).intersects(seen)) continue;
      const ClosureLook look = lookOf(closure);
      lines[look] << line;
      dots[look] << squareAround(line.p1(), kPlaceDotPx / 2);
      if (line.length() > kPlaceRingFromPx) rings[look] << squareAround(line.p2(), kPlaceRingPx / 2);
    }
    const std::array colors{context_.theme.good, context_.theme.warn, context_.theme.bad};
    // The worst ones on top.
    for (const ClosureLook look : {Fits, Strained, Contradicts}) {
      if (lines[look].isEmpty()) continue;
      sheet_.paint(*painter, viewport, 1, [&](QPainter& on_sheet) {
        on_sheet.setPen(QPen(colors[look], look == Contradicts ? 2 : 0));
        on_sheet.drawLines(lines[look]);
        on_sheet.setBrush(Qt::NoBrush);
        on_sheet.setPen(QPen(colors[look], 0));
        on_sheet.drawRects(rings[look]);
        for (const QRectF& dot : dots[look]) on_sheet.fillRect(dot, colors[look]);
      });
    }
  }
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    if (!context_.closures) return bounds;
    for (const map::Closure& closure : context_.closures->ranked) {
      if (!isDrawn(context_, closure)) continue;
      extendBy(bounds, closure.at);
      extendBy(bounds, closure.expected);
    }
    return bounds;
  }

 private:
  LineSheet sheet_;
};

void seeClosures(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  if (!context.closures) return;
  std::size_t number = 0;
  for (const map::Closure& closure : context.closures->ranked) {
    const std::array line{closure.at, closure.expected};
    if (isDrawn(context, closure)) seePart(see, number, ObjectForm::Line, line);
    ++number;
  }
}

MapObject describeClosure(const LayerContext& context, FeaturesOf, std::size_t number) {
  MapObject object;
  object.kind = ObjectText::tr("Loop closure");
  if (!context.closures || number >= context.closures->ranked.size()) return object;
  const map::Closure& closure = context.closures->ranked[number];
  object.look = lookOf(closure);
  const QString submap = QString::fromStdString(map::toText(closure.submap));
  const QString node = QString::fromStdString(map::toText(closure.node));
  object.name = QStringLiteral("%1 : %2").arg(submap, node);
  object.properties =
      Properties()
          .add(ObjectText::tr("Contradicts the map by"), metres(closure.residual_m))
          .add(ObjectText::tr("Turned by"),
               QStringLiteral("%1°").arg(geometry::degreesFromRadians(closure.residual_rad), 0, 'f', 2))
          .add(ObjectText::tr("Submap"), submap)
          .add(ObjectText::tr("Node"), node);
  return object;
}

std::string keyOfClosure(const LayerContext& context, FeaturesOf, std::size_t number) {
  if (!context.closures || number >= context.closures->ranked.size()) return {};
  const map::Closure& closure = context.closures->ranked[number];
  return map::toText(closure.submap) + ":" + map::toText(closure.node);
}

constexpr LayerObjects kClosures{seeClosures, describeClosure, keyOfClosure, false};

void sampleClosure(LegendSample& sample, ObjectForm, std::int64_t look) {
  map::Closure closure;
  closure.kind = map::ConstraintKind::Inter;
  closure.residual_m = look == Fits ? 0 : look == Strained ? 2 * kStrainedM : 2 * kContradictsM;
  const double reach = sample.reachPx() - 3;
  closure.at = LegendSample::at(look == Fits ? 0 : -reach, 0);
  closure.expected = LegendSample::at(look == Fits ? 0 : reach, 0);
  auto closures = std::make_shared<map::Closures>();
  closures->ranked = {closure};
  sample.context.closures = std::move(closures);
}

}  // namespace

template <>
LayerSpec layerSpec<Layer::Closures>() {
  return {.name = "closures",
          .title = QT_TRANSLATE_NOOP("scene", "Loop closures"),
          .shown = false,
          .follows_robot = false,
          .why_empty = noPoseGraphReason,
          .items = oneItem<ClosuresLayer>,
          .objects = &kClosures,
          .sample = sampleClosure,
          .legend = [](Legend& legend) {
            legend.addThing(LegendText::tr("Loop closure that fits the map"), ObjectForm::Line, Fits);
            legend.addThing(LegendText::tr("Off by more than 0.1 m"), ObjectForm::Line, Strained);
            legend.addThing(LegendText::tr("Contradicts the map by more than 0.5 m"), ObjectForm::Line,
                            Contradicts);
          }};
}

}  // namespace mapwright::ui::scene
