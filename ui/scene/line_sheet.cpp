#include "scene/line_sheet.h"

#include <QPaintDevice>

namespace mapwright::scene {

void LineSheet::paint(QPainter& painter, const QSizeF& viewport, double opacity,
                      const std::function<void(QPainter&)>& draw) {
  const qreal ratio = painter.device()->devicePixelRatioF();
  const QSize size = (viewport * ratio).toSize();
  if (sheet_.size() != size) sheet_ = QImage(size, QImage::Format_ARGB32_Premultiplied);
  if (sheet_.isNull()) return;
  sheet_.setDevicePixelRatio(ratio);
  sheet_.fill(Qt::transparent);
  QPainter on_sheet(&sheet_);
  draw(on_sheet);
  on_sheet.end();
  const qreal before = painter.opacity();
  painter.setOpacity(before * opacity);
  painter.drawImage(QPointF(0, 0), sheet_);
  painter.setOpacity(before);
}

}  // namespace mapwright::scene
