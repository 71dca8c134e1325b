#include <set>
#include <utility>

#include <QFontMetricsF>
#include <QPainter>

#include "scene/map_layers.h"

namespace mapwright::scene {

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

OutlineLayer::OutlineLayer(const LayerContext& context, const Outlines& outlines,
                           const std::set<map::SubmapId>& highlighted, What what)
    : LayerItem(context), outlines_(outlines), highlighted_(highlighted), what_(what) {}

void OutlineLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  switch (what_) {
    case What::Outlines:
      paintOutlines(*painter);
      break;
    case What::Ids:
      paintIds(*painter);
      break;
    case What::Highlight:
      paintHighlight(*painter);
      break;
  }
}

void OutlineLayer::paintOutlines(QPainter& painter) {
  constexpr double kTooSmallPx = 6;
  const geometry::WorldRect visible = context_.view.visibleWorld();
  QList<QLineF> active, frozen;
  for (const auto& [id, outline] : outlines_) {
    if (!outline.visible) continue;
    geometry::WorldRect bounds;
    for (const Eigen::Vector2d& corner : outline.corners) bounds.extend(corner);
    if (!bounds.intersects(visible)) continue;
    if (std::max(bounds.width(), bounds.height()) < kTooSmallPx * context_.view.scale_m_per_px) continue;
    for (std::size_t i = 0; i < outline.corners.size(); ++i) {
      (outline.frozen ? frozen : active)
          << QLineF(toPoint(context_.view.pixelFromWorld(outline.corners[i])),
                    toPoint(context_.view.pixelFromWorld(outline.corners[(i + 1) % outline.corners.size()])));
    }
  }
  const auto lay = [&](const QList<QLineF>& lines, const QColor& color, Qt::PenStyle style) {
    if (lines.isEmpty()) return;
    QColor opaque = color;
    opaque.setAlpha(255);
    sheet_.paint(painter, boundingRect().size(), color.alphaF(), [&](QPainter& on_sheet) {
      on_sheet.setPen(QPen(opaque, 0, style));
      on_sheet.drawLines(lines);
    });
  };
  lay(frozen, context_.theme.outline_frozen, Qt::DashLine);
  lay(active, context_.theme.outline, Qt::SolidLine);
}

void OutlineLayer::paintIds(QPainter& painter) const {
  const QFontMetricsF metrics(context_.theme.label_font);
  const double cell_w = metrics.horizontalAdvance(QStringLiteral("000-0000")) + 4,
               cell_h = metrics.height() + 2;
  std::set<std::pair<int, int>> taken;
  // Newest first: if labels collide, the older one is dropped.
  for (auto it = outlines_.rbegin(); it != outlines_.rend(); ++it) {
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
    drawLabel(painter, {center.x() - metrics.horizontalAdvance(text) / 2, center.y() + metrics.ascent() / 2},
              text, context_.theme, color, !it->second.visible);
  }
}

void OutlineLayer::paintHighlight(QPainter& painter) const {
  constexpr std::size_t kMostLabels = 20;  // more would only overlap
  const geometry::WorldRect visible = context_.view.visibleWorld();
  QColor fill = context_.theme.accent;
  fill.setAlpha(28);
  for (const map::SubmapId id : highlighted_) {
    const auto it = outlines_.find(id);
    if (it == outlines_.end()) continue;
    geometry::WorldRect bounds;
    QPolygonF polygon;
    for (const Eigen::Vector2d& corner : it->second.corners) {
      bounds.extend(corner);
      polygon << toPoint(context_.view.pixelFromWorld(corner));
    }
    if (!bounds.intersects(visible)) continue;
    painter.setBrush(fill);
    painter.setPen(QPen(context_.theme.text_halo, 4));
    painter.drawPolygon(polygon);
    painter.setPen(QPen(context_.theme.accent, 2));
    painter.drawPolygon(polygon);
    if (highlighted_.size() > kMostLabels) continue;
    drawLabel(painter, polygon.boundingRect().center(), QString::fromStdString(map::toText(id)),
              context_.theme, context_.theme.accent);
  }
}

}  // namespace mapwright::scene
