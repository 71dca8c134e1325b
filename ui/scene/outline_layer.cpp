// Where the submaps lie: their outlines, their ids, the highlighted ones.
#include <set>
#include <utility>

#include <QFontMetricsF>

#include "scene/layer_bounds.h"
#include "scene/layer_item.h"
#include "scene/legend.h"

namespace mapwright::scene {
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
      if (!outline.visible) continue;
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
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    painter->setRenderHint(QPainter::Antialiasing);
    const QFontMetricsF metrics(context_.theme.label_font);
    const double cell_w = metrics.horizontalAdvance(QStringLiteral("000-0000")) + 4,
                 cell_h = metrics.height() + 2;
    std::set<std::pair<int, int>> taken;
    // Newest first: if labels collide, the older one is dropped.
    for (auto it = context_.outlines.rbegin(); it != context_.outlines.rend(); ++it) {
      const QPointF center = toPoint(context_.view.pixelFromWorld(it->second.center));
      if (center.x() < -50 || center.y() < -20 || center.x() > context_.view.width_px + 50 ||
          center.y() > context_.view.height_px + 20) {
        continue;
      }
      const int column = int(center.x() / cell_w + 1000), row = int(center.y() / cell_h + 1000);
      bool free = true;
      for (int dx = -1; dx <= 1; ++dx) {
        for (int dy = -1; dy <= 1; ++dy) free &= !taken.contains({column + dx, row + dy});
      }
      if (!free) continue;
      taken.insert({column, row});
      const QString text = QString::fromStdString(map::toText(it->first));
      QColor color = context_.theme.text;
      if (!it->second.visible) color.setAlpha(170);
      drawLabel(*painter,
                {center.x() - metrics.horizontalAdvance(text) / 2, center.y() + metrics.ascent() / 2}, text,
                context_.theme, color, !it->second.visible);
    }
  }
  geometry::WorldRect contentBounds() const override { return boundsOf(context_.outlines); }
};

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
  constexpr std::size_t kMostLabels = 20;  // more would only overlap
  const geometry::WorldRect visible = context_.view.visibleWorld();
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
    painter->setBrush(translucent(context_.theme.accent, 28));
    painter->setPen(QPen(context_.theme.text_halo, 4));
    painter->drawPolygon(polygon);
    painter->setPen(QPen(context_.theme.accent, 2));
    painter->drawPolygon(polygon);
    if (context_.highlighted.size() > kMostLabels) continue;
    drawLabel(*painter, polygon.boundingRect().center(), QString::fromStdString(map::toText(id)),
              context_.theme, context_.theme.accent);
  }
}

template <>
LayerSpec layerSpec<Layer::Outlines>() {
  return {.name = "outlines",
          .title = QT_TRANSLATE_NOOP("scene", "Outlines"),
          .shown = false,
          .why_empty = whyNoSubmaps,
          .items = oneItem<OutlinesLayer>,
          .legend = outlinesLegend};
}

template <>
LayerSpec layerSpec<Layer::Ids>() {
  return {.name = "ids",
          .title = QT_TRANSLATE_NOOP("scene", "Submap ids"),
          .shown = false,
          .why_empty = whyNoSubmaps,
          .items = oneItem<IdsLayer>,
          .legend = idsLegend};
}

}  // namespace mapwright::scene
