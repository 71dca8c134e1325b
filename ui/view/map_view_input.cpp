// MapView: mouse, wheel, keys and gestures.
#include <cmath>
#include <utility>

#include <QGestureEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPinchGesture>
#include <QPointingDevice>
#include <QWheelEvent>

#include "geometry/pose.h"
#include "ui/view/map_view.h"

namespace mapwright::window {

namespace {

constexpr double kDragStartPx = 4;
constexpr double kFineZoom = 0.2;                               // part of a rung with Ctrl
constexpr double kWheelTurn = geometry::radiansFromDegrees(5);  // one notch with Shift
constexpr double kArrowPx = 64;
constexpr double kNotch = 120;  // eighths of a degree, see QWheelEvent

}  // namespace

bool MapView::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture && nativeGesture(static_cast<QNativeGestureEvent*>(event)))
    return true;
  return QGraphicsView::event(event);
}

bool MapView::viewportEvent(QEvent* event) {
  switch (event->type()) {
    case QEvent::NativeGesture:
      if (nativeGesture(static_cast<QNativeGestureEvent*>(event))) return true;
      break;
    case QEvent::Gesture:
      if (gesture(static_cast<QGestureEvent*>(event))) return true;
      break;
    case QEvent::Leave:
      cursor_px_.reset();
      tool_->left();
      Q_EMIT cursorMoved();
      break;
    default:
      break;
  }
  return QGraphicsView::viewportEvent(event);
}

void MapView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton) return;  // contextMenuEvent follows
  if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton) {
    event->ignore();
    return;
  }
  stopMoving();
  press_ = drag_last_ = event->position();
  // Middle and Space+left drag at once; a left press may still become a click.
  dragging_ = event->button() == Qt::MiddleButton || space_held_;
  cancelToolDrag();
  if (!dragging_) tool_takes_ = tool_->pressed(pointAt(event->position(), event->modifiers()));
  updateCursor();
  event->accept();
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
  cursor_px_ = event->position();
  if (press_ && (event->buttons() & (Qt::LeftButton | Qt::MiddleButton))) {
    const QPointF moved = event->position() - *press_;
    if (!dragging_ && !tool_dragging_ && std::hypot(moved.x(), moved.y()) >= kDragStartPx) {
      (tool_takes_ ? tool_dragging_ : dragging_) = true;
      updateCursor();
    }
    if (tool_dragging_) tool_->dragged(pointAt(event->position(), event->modifiers()));
    if (dragging_) {
      panBy(event->position() - drag_last_);
      drag_last_ = event->position();
    }
  } else {
    activeTool()->hovered(pointAt(event->position(), event->modifiers()));
  }
  Q_EMIT cursorMoved();
  event->accept();
}

void MapView::mouseReleaseEvent(QMouseEvent* event) {
  if (!press_ || (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton)) {
    event->ignore();
    return;
  }
  const bool click = !dragging_ && !tool_dragging_ && event->button() == Qt::LeftButton;
  const MapPoint at = pointAt(event->position(), event->modifiers());
  press_.reset();
  dragging_ = false;
  tool_takes_ = false;
  if (std::exchange(tool_dragging_, false)) tool_->released(at);
  updateCursor();
  if (click) activeTool()->clicked(at);
  event->accept();
}

void MapView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (activeTool()->takesEveryPress()) return mousePressEvent(event);
  if (event->button() != Qt::LeftButton) return;
  event->accept();
  const Eigen::Vector2d world = worldAt(event->position());
  if (activeTool()->doubleClicked(pointAt(event->position(), event->modifiers()))) return;
  geometry::ViewTransform to = destination();
  to.center_m = world;
  to.scale_m_per_px = ladderScale(to.scale_m_per_px, 3);
  takeByHand();
  moveTo(to, true);
}

void MapView::wheelEvent(QWheelEvent* event) {
  event->accept();
  const bool touchpad = event->device() && event->device()->type() == QInputDevice::DeviceType::TouchPad;
  const bool phased = event->phase() != Qt::NoScrollPhase && !event->pixelDelta().isNull();
  const Qt::KeyboardModifiers modifiers = event->modifiers();
  if ((touchpad || phased) && !(modifiers & (Qt::ControlModifier | Qt::ShiftModifier))) {
    const QPointF pixels =
        event->pixelDelta().isNull() ? QPointF(event->angleDelta()) / 2 : QPointF(event->pixelDelta());
    panBy(pixels);
    return;
  }
  // With Shift and Alt some platforms report the wheel sideways.
  const int angle = event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
  if (angle == 0) return;
  const double notches = angle / kNotch;
  if (modifiers & Qt::ShiftModifier) {
    rotateBy(notches * kWheelTurn, event->position());
  } else if (modifiers & Qt::ControlModifier) {
    zoomFactorAt(event->position(), std::pow(kLadder, notches * kFineZoom));
  } else {
    zoomSteps(notches, event->position());
  }
}

void MapView::keyPressEvent(QKeyEvent* event) {
  if (tool_->keyPressed({event->key(), event->modifiers(), event->isAutoRepeat()})) {
    // A drag that was ended by a key is ignored from then on.
    if (event->key() == Qt::Key_Escape && std::exchange(tool_dragging_, false)) press_.reset();
    updateCursor();
    event->accept();
    return;
  }
  const double step = event->modifiers() & Qt::ShiftModifier ? kArrowPx * 4 : kArrowPx;
  switch (event->key()) {
    case Qt::Key_Left:
      panBy({step, 0});
      break;
    case Qt::Key_Right:
      panBy({-step, 0});
      break;
    case Qt::Key_Up:
      panBy({0, step});
      break;
    case Qt::Key_Down:
      panBy({0, -step});
      break;
    case Qt::Key_Escape:
      stopMoving();
      setFollowing(false);
      Q_EMIT escaped();
      break;
    case Qt::Key_Space:
      if (!event->isAutoRepeat() && !tool_dragging_) {
        space_held_ = true;
        updateCursor();
      }
      break;
    default:
      event->ignore();
      return;
  }
  event->accept();
}

void MapView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
    space_held_ = false;
    updateCursor();
    event->accept();
    return;
  }
  event->ignore();
}

void MapView::focusOutEvent(QFocusEvent* event) {
  space_held_ = false;
  if (tool_dragging_) press_.reset();
  cancelToolDrag();
  updateCursor();
  QGraphicsView::focusOutEvent(event);
}

void MapView::contextMenuEvent(QContextMenuEvent* event) {
  const QPointF at =
      event->reason() == QContextMenuEvent::Keyboard ? cursor_px_.value_or(middle()) : QPointF(event->pos());
  Q_EMIT menuRequested(viewport()->mapToGlobal(at.toPoint()), at);
  event->accept();
}

bool MapView::nativeGesture(QNativeGestureEvent* event) {
  switch (event->gestureType()) {
    case Qt::ZoomNativeGesture:
      zoomFactorAt(event->position(), std::exp(event->value()));
      return true;
    case Qt::RotateNativeGesture: {
      takeByHand(true);
      stopMoving();
      const QPointF at = event->position();
      setView(scene_->view().rotatedAt({at.x(), at.y()}, -geometry::radiansFromDegrees(event->value())));
      return true;
    }
    case Qt::SmartZoomNativeGesture:
      zoomSteps(3, event->position());
      return true;
    default:
      return false;
  }
}

bool MapView::gesture(QGestureEvent* event) {
  auto* pinch = static_cast<QPinchGesture*>(event->gesture(Qt::PinchGesture));
  if (!pinch) return false;
  const QPointF at = viewport()->mapFromGlobal(pinch->centerPoint());
  if (pinch->changeFlags() & QPinchGesture::CenterPointChanged) {
    panBy(pinch->centerPoint() - pinch->lastCenterPoint());
  }
  if ((pinch->changeFlags() & QPinchGesture::ScaleFactorChanged) && pinch->scaleFactor() > 0) {
    zoomFactorAt(at, pinch->scaleFactor());
  }
  event->accept(pinch);
  return true;
}

}  // namespace mapwright::window
