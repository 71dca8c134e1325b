#include "ui/view/swipe_handle.h"

#include <algorithm>

#include <QCoreApplication>
#include <QGraphicsView>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "ui/kit/ui_colors.h"

namespace mapwright::ui {

SwipeHandle::SwipeHandle(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("swipe"));
  setCursor(Qt::SplitHCursor);
  setFocusPolicy(Qt::StrongFocus);
  setToolTip(tr("Drag it, or press Left and Right, to reveal one map or the other"));
  setAccessibleName(tr("Divider between the compared maps"));
  hide();
}

void SwipeHandle::setAt(double fraction) {
  at_ = std::clamp(fraction, 0.0, 1.0);
  if (!parentWidget()) return;
  const int x = int(at_ * parentWidget()->width());
  setGeometry(x - kWidthPx / 2, 0, kWidthPx, parentWidget()->height());
}

void SwipeHandle::moveTo(double fraction) {
  setAt(fraction);
  Q_EMIT moved(at_);
}

void SwipeHandle::paintEvent(QPaintEvent*) {
  const UiColors colors = appColors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF middle(width() / 2.0, height() / 2.0);
  painter.setPen(QPen(hasFocus() ? colors.text : colors.accent, hasFocus() ? 2 : 1.5));
  painter.setBrush(colors.window);
  painter.drawRoundedRect(QRectF(middle.x() - 10, middle.y() - 18, 20, 36), 8, 8);
  painter.setPen(QPen(colors.text, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  for (const double side : {-1.0, 1.0}) {
    const QPointF tip(middle.x() + side * 6.5, middle.y());
    painter.drawPolyline(QPolygonF{tip + QPointF(-side * 3.5, -4), tip, tip + QPointF(-side * 3.5, 4)});
  }
}

void SwipeHandle::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) grab_px_ = event->position().x() - width() / 2.0;
}

void SwipeHandle::mouseMoveEvent(QMouseEvent* event) {
  if (!grab_px_ || !(event->buttons() & Qt::LeftButton)) return;
  const double x = mapToParent(event->position().toPoint()).x() - *grab_px_;
  moveTo(x / std::max(1, parentWidget()->width()));
}

void SwipeHandle::mouseReleaseEvent(QMouseEvent*) { grab_px_.reset(); }

void SwipeHandle::wheelEvent(QWheelEvent* event) {
  // The map below can still be zoomed.
  auto* view = qobject_cast<QGraphicsView*>(parentWidget());
  if (!view) return;
  const QPointF at = mapToParent(event->position().toPoint());
  QWheelEvent passed(at, event->globalPosition(), event->pixelDelta(), event->angleDelta(), event->buttons(),
                     event->modifiers(), event->phase(), event->inverted(), event->source());
  QCoreApplication::sendEvent(view->viewport(), &passed);
  event->accept();
}

void SwipeHandle::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers() & Qt::ShiftModifier ? 0.1 : 0.01;
  switch (event->key()) {
    case Qt::Key_Left:
      moveTo(at_ - step);
      break;
    case Qt::Key_Right:
      moveTo(at_ + step);
      break;
    case Qt::Key_Home:
      moveTo(0);
      break;
    case Qt::Key_End:
      moveTo(1);
      break;
    case Qt::Key_Escape:
      Q_EMIT escaped();
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace mapwright::ui

#include "moc_swipe_handle.cpp"
