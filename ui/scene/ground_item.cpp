#include "ui/scene/ground_item.h"

#include <algorithm>
#include <cmath>

#include <QPainter>
#include <QStyleOptionGraphicsItem>

#include "ui/scene/layer_item.h"

namespace mapwright::ui::scene {

GroundItem::GroundItem(const LayerContext& context) : context_(context) {
  setFlag(ItemUsesExtendedStyleOption);
  setAcceptedMouseButtons(Qt::NoButton);
}

QRectF GroundItem::boundingRect() const {
  return {0, 0, qreal(context_.view.width_px), qreal(context_.view.height_px)};
}

bool GroundItem::holds(const LayerItem* layer) const {
  return std::find(layers_.begin(), layers_.end(), layer) != layers_.end();
}

void GroundItem::setLayers(std::vector<LayerItem*> layers) {
  if (layers == layers_) return;
  for (LayerItem* layer : layers_) layer->setFlag(ItemHasNoContents, false);
  layers_ = std::move(layers);
  for (LayerItem* layer : layers_) layer->setFlag(ItemHasNoContents, true);
  changed(boundingRect());
}

void GroundItem::changed(const QRectF& rect) {
  if (outdated_) *outdated_ += rect.toAlignedRect().adjusted(-1, -1, 1, 1);
  update(rect);
}

void GroundItem::paintLayers(QPainter& painter, const QRectF& exposed, QWidget* widget) const {
  painter.fillRect(exposed, QColor(context_.theme.map.unknown));
  QStyleOptionGraphicsItem option;
  option.exposedRect = exposed;
  for (LayerItem* layer : layers_) {
    if (!layer->isVisible()) continue;
    painter.save();
    painter.setOpacity(painter.opacity() * layer->opacity());
    if (layer->part()) painter.setClipRect(*layer->part(), Qt::IntersectClip);
    layer->paint(&painter, &option, widget);
    painter.restore();
  }
}

void GroundItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) {
  const QRectF exposed = option->exposedRect & boundingRect();
  // While the camera moves, a picture would be used only once.
  if (!widget || painted_view_ != context_.view) {
    if (widget) {
      painted_view_ = context_.view;
      outdated_.reset();
    }
    return paintLayers(*painter, exposed, widget);
  }
  const qreal ratio = painter->device()->devicePixelRatioF();
  const QSize size(int(std::ceil(context_.view.width_px * ratio)),
                   int(std::ceil(context_.view.height_px * ratio)));
  if (picture_.size() != size || picture_.devicePixelRatio() != ratio) {
    picture_ = QImage(size, QImage::Format_RGB32);
    if (picture_.isNull()) return paintLayers(*painter, exposed, widget);  // no memory
    picture_.setDevicePixelRatio(ratio);
    outdated_.reset();
  }
  if (!outdated_) outdated_ = QRegion(boundingRect().toAlignedRect());
  const QRegion needed = *outdated_ & exposed.toAlignedRect();
  if (!needed.isEmpty()) {
    QPainter on_picture(&picture_);
    on_picture.setClipRegion(needed);
    paintLayers(on_picture, QRectF(needed.boundingRect()), widget);
    *outdated_ -= needed;
  }
  painter->save();
  painter->scale(1 / ratio, 1 / ratio);
  picture_.setDevicePixelRatio(1);
  painter->drawImage(QPointF(0, 0), picture_);
  picture_.setDevicePixelRatio(ratio);
  painter->restore();
}

}  // namespace mapwright::ui::scene
