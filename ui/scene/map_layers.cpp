#include "scene/map_layers.h"

#include <algorithm>
#include <cmath>

#include <QPainter>
#include <QStyleOptionGraphicsItem>

namespace mapwright::scene {
namespace {

constexpr int kMapTileEdge = 256;  // of the renderer's tiles

}  // namespace

TileLayer::TileLayer(const LayerContext& context, render::TileRenderer& renderer)
    : DeviceLayer(context), renderer_(renderer) {}

void TileLayer::paintPixels(QPainter& painter, const QRectF& exposed) {
  const std::vector<render::DrawnTile> tiles = renderer_.drawnTiles();
  const auto first =
      std::find_if(tiles.begin(), tiles.end(), [](const auto& tile) { return !tile.stand_in; });
  const std::span stand_ins(tiles.begin(), first), finished(first, tiles.end());
  if (!stand_ins.empty() && renderer_.colors().clear_unknown) {
    // A transparent part of a finished tile shows the layer below, not the stand-in.
    QRegion open(exposed.toAlignedRect());
    for (const render::DrawnTile& tile : finished) {
      open -= QRect(int(tile.to_viewport.dx()), int(tile.to_viewport.dy()), kMapTileEdge, kMapTileEdge);
    }
    painter.save();
    painter.setClipRegion(open, Qt::IntersectClip);
    drawTiles(painter, exposed, stand_ins);
    painter.restore();
  } else {
    drawTiles(painter, exposed, stand_ins);
  }
  drawTiles(painter, exposed, finished);
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
