#include "ui/scene/label_ink.h"

#include <cmath>

#include <QFontMetricsF>

#include "ui/scene/drawing.h"

namespace mapwright::ui::scene {
namespace {

constexpr int kMostSizes = 20'000;
constexpr double kHaloPx = 2;  // half of its line, and what antialiasing adds

}  // namespace

QSizeF LabelInk::sizeOf(const QString& text, const MapTheme& theme) {
  if (sizes_of_px_ != theme.label_font.pixelSize() || sizes_.size() > kMostSizes) sizes_.clear();
  sizes_of_px_ = theme.label_font.pixelSize();
  QSizeF& size = sizes_[text];
  if (!size.isValid()) {
    const QFontMetricsF metrics(theme.label_font);
    size = QSizeF(metrics.horizontalAdvance(text), metrics.height());
  }
  return size;
}

void LabelInk::draw(QPainter& painter, const QPointF& top_left, const QString& text, const MapTheme& theme,
                    const QColor& color, bool struck_through) {
  const qreal ratio = painter.device()->devicePixelRatioF();
  const Key key{text,           color.rgba(), theme.text_halo.rgba(), theme.label_font.pixelSize(),
                struck_through, ratio};
  const QImage* image = images_.object(key);
  if (!image) {
    const QSizeF size = sizeOf(text, theme) + QSizeF(2 * kHaloPx, 2 * kHaloPx);
    QImage drawn((size * ratio).toSize() + QSize(1, 1), QImage::Format_ARGB32_Premultiplied);
    if (drawn.isNull()) return;
    drawn.setDevicePixelRatio(ratio);
    drawn.fill(Qt::transparent);
    QPainter on_image(&drawn);
    drawLabel(on_image, {kHaloPx, kHaloPx + QFontMetricsF(theme.label_font).ascent()}, text, theme, color,
              struck_through);
    on_image.end();
    // One that is larger than the whole cache would be gone at once.
    if (drawn.sizeInBytes() > images_.maxCost()) {
      painter.drawImage(top_left - QPointF(kHaloPx, kHaloPx), drawn);
      return;
    }
    // A picture that was painted on holds what Qt painted it with, outlines and all: many times its pixels. A
    // copy does not.
    auto* const made = new QImage(drawn.copy());
    images_.insert(key, made, made->sizeInBytes());
    image = made;
  }
  const QPointF at = (top_left - QPointF(kHaloPx, kHaloPx)) * ratio;
  painter.drawImage(QPointF(std::round(at.x()), std::round(at.y())) / ratio, *image);
}

}  // namespace mapwright::ui::scene
