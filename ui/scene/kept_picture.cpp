#include "ui/scene/kept_picture.h"

#include <cmath>

#include <QPainter>

namespace mapwright::ui::scene {

void KeptPicture::paint(QPainter& painter, const QRectF& exposed, const geometry::ViewTransform& view,
                        std::uint64_t revision, const Draw& draw) {
  const bool moved = view_ != view;
  if (moved || revision_ != revision) drawn_ = false;
  view_ = view;
  revision_ = revision;
  // While the camera moves, a picture would be used only once.
  if (moved) return draw(painter, exposed);
  const qreal ratio = painter.device()->devicePixelRatioF();
  const QSize size(int(std::ceil(view.width_px * ratio)), int(std::ceil(view.height_px * ratio)));
  if (picture_.size() != size || picture_.devicePixelRatio() != ratio) {
    picture_ = QImage(size, QImage::Format_ARGB32_Premultiplied);
    picture_.setDevicePixelRatio(ratio);
    drawn_ = false;
  }
  // With less than full opacity, lines show through each other: not so in a picture.
  if (picture_.isNull() || painter.opacity() < 1) return draw(painter, exposed);
  if (!drawn_) {
    picture_.fill(Qt::transparent);
    QPainter on_picture(&picture_);
    draw(on_picture, QRectF(0, 0, view.width_px, view.height_px));
    drawn_ = true;
  }
  painter.drawImage(QPointF(0, 0), picture_);
}

}  // namespace mapwright::ui::scene
