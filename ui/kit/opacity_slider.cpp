#include "ui/kit/opacity_slider.h"

#include <QMouseEvent>
#include <QPainter>

#include "ui/kit/ui_colors.h"

namespace mapwright::window {

OpacitySlider::OpacitySlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setRange(0, 100);
  setPageStep(10);
  setFixedSize(46, 18);
  setFocusPolicy(Qt::TabFocus);
  setToolTip(tr("Opacity"));
}

void OpacitySlider::paintEvent(QPaintEvent*) {
  const UiColors colors = appColors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(hasFocus() ? colors.focus : colors.border);
  painter.setBrush(isEnabled() ? colors.base : colors.window);
  painter.drawRoundedRect(box, 3, 3);
  if (value() > 0 && isEnabled()) {
    QColor fill = colors.accent;
    fill.setAlpha(colors.dark ? 110 : 60);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawRoundedRect(
        QRectF(box.left() + 1, box.top() + 1, (box.width() - 2) * value() / 100.0, box.height() - 2), 2, 2);
  }
  painter.setPen(isEnabled() ? colors.text : palette().color(QPalette::Disabled, QPalette::WindowText));
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.88);
  painter.setFont(small);
  painter.drawText(rect(), Qt::AlignCenter, QStringLiteral("%1 %").arg(value()));
}

void OpacitySlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) follow(event->position());
}

void OpacitySlider::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) follow(event->position());
}

// The list scrolls; the wheel must not change the slider under the cursor.
void OpacitySlider::wheelEvent(QWheelEvent* event) { event->ignore(); }

void OpacitySlider::follow(const QPointF& at) {
  setValue(qRound(100.0 * (at.x() - 1.5) / qMax(1, width() - 3)));
}

}  // namespace mapwright::window

#include "moc_opacity_slider.cpp"
