// Where the submaps lie: their outlines, their ids, the highlighted ones.
#include <cmath>
#include <cstdint>
#include <unordered_set>

#include <QFontMetricsF>
#include <QHashFunctions>

#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
namespace {

class OutlinesLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    painter->setRenderHint(QPainter::Antialiasing);
    constexpr double kTooSmallPx = 6;
    const geometry::WorldRect visible = context_.view.visibleWorld();
    QList<QLineF> active, frozen;
    for (const auto& [id, outline] : context_.outlines) {
      if (!outline.visible || (context_.outlined && !context_.outlined->contains(id))) continue;
      geometry::WorldRect bounds;
      for (const Eigen::Vector2d& corner : outline.corners) bounds.extend(corner);
      if (!bounds.intersects(visible)) continue;
      if (std::max(bounds.width(), bounds.height()) < kTooSmallPx * context_.view.scale_m_per_px) continue;
      for (std::size_t i = 0; i < outline.corners.size(); ++i) {
        (outline.frozen ? frozen : active) << QLineF(
            toPoint(context_.view.pixelFromWorld(outline.corners[i])),
            toPoint(context_.view.pixelFromWorld(outline.corners[(i + 1) % outline.corners.size()])));
      }
    }
    const auto lay = [&](const QList<QLineF>& lines, const QColor& color, Qt::PenStyle style) {
      if (lines.isEmpty()) return;
      sheet_.paint(*painter, boundingRect().size(), color.alphaF(), [&](QPainter& on_sheet) {
        on_sheet.setPen(QPen(translucent(color, 255), 0, style));
        on_sheet.drawLines(lines);
      });
    };
    lay(frozen, context_.theme.outline_frozen, Qt::DashLine);
    lay(active, context_.theme.outline, Qt::SolidLine);
  }
  geometry::WorldRect contentBounds() const override { return boundsOf(context_.outlines); }

 private:
  LineSheet sheet_;
};

class IdsLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter*, const QStyleOptionGraphicsItem*, QWidget*) override {}  // only labels
  LabelUse labelUse() const override { return LabelUse::Names; }
  void collectLabels(LabelCollector& labels) const override {
    // Zoomed out there are more of them than can be told apart: the newest in each square of the map.
    constexpr double kSquarePx = 24;
    std::unordered_set<std::uint64_t> squares;
    const QPointF zero = toPoint(context_.view.pixelFromWorld({0, 0}));
    for (auto it = context_.outlines.rbegin(); it != context_.outlines.rend(); ++it) {
      const auto& [id, outline] = *it;
      if (context_.highlighted.contains(id)) continue;  // labelled by its frame
      if (context_.outlined && !context_.outlined->contains(id)) continue;
      const QPointF center = toPoint(context_.view.pixelFromWorld(outline.center));
      if (!labels.area().contains(center)) continue;
      const auto square = [](double px) { return std::uint64_t(std::int64_t(std::floor(px / kSquarePx))); };
      const QPointF at = center - zero;
      if (!squares.insert(qHashMulti(0, square(at.x()), square(at.y()))).second) continue;
      labels.add(LabelWish::Position::Over, LabelRank::Id, QRectF(center - QPointF(1, 1), QSizeF(2, 2)),
                 std::hash<map::SubmapId>()(id), QString::fromStdString(map::toText(id)),
                 translucent(context_.theme.text, outline.visible ? 255 : 170), !outline.visible);
    }
  }
  geometry::WorldRect contentBounds() const override { return boundsOf(context_.outlines); }
};

void sampleOutline(LegendSample& sample, ObjectForm, std::int64_t look) {
  const auto box = sample.wideBox(7);
  Outline& outline = sample.context.outlines[{}];
  std::copy(box.begin(), box.end(), outline.corners.begin());
  outline.frozen = look != 0;
}

void outlinesLegend(Legend& legend) {
  legend.addThing(LegendText::tr("Submap"), ObjectForm::Area, 0);
  legend.addThing(LegendText::tr("Frozen submap"), ObjectForm::Area, 1);
}

void idsLegend(Legend& legend) {
  // Labels are drawn above all layers: the sample is one of them.
  const auto add = [&](const QString& text, bool visible) {
    legend.add(text, [&, visible](QPainter& painter, const QRectF& room) {
      const QString id = QString::fromStdString(map::toText(map::SubmapId{0, 12}));
      const QFontMetricsF metrics(legend.theme().label_font);
      const QPointF corner = room.center() - QPointF(metrics.horizontalAdvance(id), metrics.height()) / 2;
      drawLabel(painter, corner + QPointF(0, metrics.ascent()), id, legend.theme(),
                translucent(legend.theme().text, visible ? 255 : 170), !visible);
    });
  };
  add(LegendText::tr("Trajectory and number of a submap"), true);
  add(LegendText::tr("Submap that you have hidden"), false);
}

}  // namespace

bool Outline::contains(const Eigen::Vector2d& p) const {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d edge = corners[(i + 1) % 4] - corners[i], to = p - corners[i];
    const double side = edge.x() * to.y() - edge.y() * to.x();
    left += side >= 0;
    right += side <= 0;
  }
  return left == 4 || right == 4;
}

void HighlightItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  const geometry::WorldRect visible = context_.view.visibleWorld();
  // Several on top of each other would hide what is below.
  const QBrush fill =
      context_.highlighted.size() == 1 ? QBrush(translucent(context_.theme.accent, 28)) : QBrush(Qt::NoBrush);
  for (const map::SubmapId id : context_.highlighted) {
    const auto it = context_.outlines.find(id);
    if (it == context_.outlines.end()) continue;
    geometry::WorldRect bounds;
    QPolygonF polygon;
    for (const Eigen::Vector2d& corner : it->second.corners) {
      bounds.extend(corner);
      polygon << toPoint(context_.view.pixelFromWorld(corner));
    }
    if (!bounds.intersects(visible)) continue;
    painter->setBrush(fill);
    painter->setPen(QPen(context_.theme.text_halo, 4));
    painter->drawPolygon(polygon);
    painter->setPen(QPen(context_.theme.accent, 2));
    painter->drawPolygon(polygon);
  }
}

void HighlightItem::collectLabels(LabelCollector& labels) const {
  constexpr std::size_t kMostLabels = 100;  // with more, none is looked for
  if (context_.highlighted.size() > kMostLabels) return;
  for (const map::SubmapId id : context_.highlighted) {
    const auto it = context_.outlines.find(id);
    if (it == context_.outlines.end()) continue;
    const auto& corners = it->second.corners;
    labels.add(LabelWish::Position::Within, LabelRank::Chosen,
               toPolygon(context_.view, {corners.begin(), corners.end()}).boundingRect(),
               std::hash<map::SubmapId>()(id), QString::fromStdString(map::toText(id)),
               readable(context_.theme.accent, context_.theme));
  }
}

template <>
LayerSpec layerSpec<Layer::Outlines>() {
  return {.name = "outlines",
          .title = QT_TRANSLATE_NOOP("scene", "Outlines"),
          .shown = false,
          .sets = LayerSet::Mapping,
          .shows_submaps = true,
          .why_empty = noSubmapsReason,
          .items = oneItem<OutlinesLayer>,
          .sample = sampleOutline,
          .legend = outlinesLegend};
}

template <>
LayerSpec layerSpec<Layer::Ids>() {
  return {.name = "ids",
          .title = QT_TRANSLATE_NOOP("scene", "Submap ids"),
          .shown = false,
          .sets = LayerSet::Mapping,
          .shows_submaps = true,
          .why_empty = noSubmapsReason,
          .items = oneItem<IdsLayer>,
          .legend = idsLegend};
}

}  // namespace mapwright::ui::scene
