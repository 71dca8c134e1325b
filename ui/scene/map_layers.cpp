#include "scene/map_layers.h"

#include <cmath>

#include <QPainter>
#include <QPainterPath>
#include <QStyleOptionGraphicsItem>

namespace mapwright::scene {

QPointF toPoint(const Eigen::Vector2d& v) { return {v.x(), v.y()}; }

void drawLabel(QPainter& painter, const QPointF& baseline_left, const QString& text, const MapTheme& theme,
               const QColor& color, bool struck_through) {
  QFont font = theme.label_font;
  font.setStrikeOut(struck_through);
  QPainterPath path;
  path.addText(baseline_left, font, text);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.text_halo, 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
  painter.fillPath(path, color);
}

LayerItem::LayerItem(const LayerContext& context) : context_(context) {
  setFlag(ItemUsesExtendedStyleOption);
  setAcceptedMouseButtons(Qt::NoButton);
}

QRectF LayerItem::boundingRect() const {
  return {0, 0, qreal(context_.view.width_px), qreal(context_.view.height_px)};
}

TileLayer::TileLayer(const LayerContext& context, render::TileRenderer& renderer)
    : LayerItem(context), renderer_(renderer) {}

void TileLayer::sendView() {
  geometry::ViewTransform view = context_.view;
  view.scale_m_per_px /= pixel_ratio_;
  view.width_px = int(std::ceil(view.width_px * pixel_ratio_));
  view.height_px = int(std::ceil(view.height_px * pixel_ratio_));
  renderer_.setView(view);
}

void TileLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  if (const qreal ratio = painter->device()->devicePixelRatioF(); ratio != pixel_ratio_) {
    pixel_ratio_ = ratio;
    sendView();
  }
  const QRectF exposed(option->exposedRect.topLeft() * pixel_ratio_,
                       option->exposedRect.size() * pixel_ratio_);
  painter->save();
  painter->scale(1 / pixel_ratio_, 1 / pixel_ratio_);
  painter->setRenderHint(QPainter::SmoothPixmapTransform, false);
  const QTransform base = painter->transform();
  for (const render::DrawnTile& tile : renderer_.drawnTiles()) {
    if (!tile.to_viewport.mapRect(QRectF(tile.image.rect())).intersects(exposed)) continue;
    if (tile.to_viewport.type() <= QTransform::TxTranslate) {
      painter->setTransform(base);
      painter->drawImage(QPointF(tile.to_viewport.dx(), tile.to_viewport.dy()), tile.image);
    } else {
      painter->setTransform(tile.to_viewport * base);
      painter->drawImage(QPointF(0, 0), tile.image);
    }
  }
  painter->restore();
}

void StaleLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  painter->fillRect(option->exposedRect, context_.theme.stale_veil);
}

MeasureLayer::MeasureLayer(const LayerContext& context, const std::vector<Eigen::Vector2d>& points)
    : LayerItem(context), points_(points) {}

void MeasureLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (points_.empty()) return;
  painter->setRenderHint(QPainter::Antialiasing);
  QPolygonF line;
  for (const Eigen::Vector2d& point : points_) line << toPoint(context_.view.pixelFromWorld(point));
  painter->setPen(QPen(context_.theme.text_halo, 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter->drawPolyline(line);
  painter->setPen(QPen(context_.theme.measure, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter->drawPolyline(line);
  painter->setBrush(context_.theme.measure);
  for (const QPointF& point : line) painter->drawEllipse(point, 3.5, 3.5);
  double total = 0;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const double leg = (points_[i] - points_[i - 1]).norm();
    total += leg;
    const QPointF middle = (line[qsizetype(i)] + line[qsizetype(i) - 1]) / 2;
    if (points_.size() > 2) {
      drawLabel(*painter, middle + QPointF(6, -6), lengthText(leg), context_.theme, context_.theme.text);
    }
  }
  if (points_.size() > 1) {
    drawLabel(*painter, line.last() + QPointF(10, 4), lengthText(total), context_.theme,
              context_.theme.measure);
  }
}

}  // namespace mapwright::scene
