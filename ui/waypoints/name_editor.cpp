#include "ui/waypoints/name_editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>

#include "ui/kit/forms.h"
#include "ui/view/map_tool.h"

namespace mapwright::ui {
namespace {

constexpr int kNameWidthPx = 180, kAsidePx = 12, kLongestTyped = 500;
constexpr auto kHandIsDone = QEvent::User;

bool isPress(const QEvent& event) {
  return event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonDblClick;
}

}  // namespace

NameEditor::NameEditor(QWidget* map) : QLineEdit(map) {
  setLongest(*this, kLongestTyped);
  setAccessibleName(tr("Name of the waypoint"));
  hide();
  connect(this, &QLineEdit::textEdited, this, [this](const QString& text) {
    if (then_) then_(text.trimmed().isEmpty() ? offered_ : text);
  });
}

void NameEditor::ask(const QPointF& at, const QString& name, std::function<void(const QString&)> then) {
  finish();
  follow(at);
  showWhole(*this, name);
  offered_ = name;
  selectAll();
  then_ = std::move(then);
  by_hand_ = pressed_away_ = back_after_it_ = false;
  show();
  raise();
  setFocus();
  qApp->installEventFilter(this);
}

void NameEditor::follow(const QPointF& at) {
  object_px_ = at;
  const int height = sizeHint().height();
  const QRect room = parentWidget()->rect().adjusted(4, 4, -4, -4);
  const int x =
      std::clamp(int(at.x()) + kAsidePx, room.left(), std::max(room.left(), room.right() - kNameWidthPx));
  const int y =
      std::clamp(int(at.y()) - height / 2, room.top(), std::max(room.top(), room.bottom() - height));
  setGeometry(x, y, kNameWidthPx, height);
}

void NameEditor::finish() { close(true); }

void NameEditor::loseObject() {
  if (then_) then_ = [](const QString&) {};
}

void NameEditor::close(bool keep) {
  if (!then_) return;
  qApp->removeEventFilter(this);
  const auto then = std::exchange(then_, nullptr);
  hide();
  if (isModified()) then(keep && !text().trimmed().isEmpty() ? text() : offered_);
}

void NameEditor::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      close(true);
      break;
    case Qt::Key_Escape:
      close(false);
      break;
    default:
      QLineEdit::keyPressEvent(event);
      event->accept();  // the map below would move the waypoint with Up and Down
      return;
  }
  event->accept();
  Q_EMIT closed();
}

bool NameEditor::isOnObject(const QPointF& viewport_px) const {
  const QPointF away = viewport_px - object_px_;
  return std::hypot(away.x(), away.y()) <= MapTool::kReachPx;
}

/// Until what the user just did has been handled, wherever that leads.
void NameEditor::rememberFocus() {
  if (!std::exchange(by_hand_, true))
    QCoreApplication::postEvent(this, new QEvent(kHandIsDone), Qt::HighEventPriority);
}

void NameEditor::customEvent(QEvent*) {
  by_hand_ = false;
  if (std::exchange(pressed_away_, false)) close(true);
}

bool NameEditor::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::KeyPress:
    case QEvent::ShortcutOverride:
      rememberFocus();
      break;
    case QEvent::MouseButtonRelease:  // of a menu or a button: what it does may take the focus
      rememberFocus();
      if (watched == parentWidget() && std::exchange(back_after_it_, false))
        QMetaObject::invokeMethod(this, &NameEditor::focusAgain, Qt::QueuedConnection);
      break;
    default:
      break;
  }
  if (pressed_away_ && isPress(*event) && watched->isWidgetType()) {
    pressed_away_ = false;
    const auto* press = static_cast<QMouseEvent*>(event);
    const bool on_object = watched == parentWidget() && press->button() == Qt::LeftButton &&
                           press->modifiers() == Qt::NoModifier && isOnObject(press->position());
    // A second click on the waypoint, or a drag of it, goes on with its name.
    on_object ? void(back_after_it_ = true) : close(true);
  }
  return QLineEdit::eventFilter(watched, event);
}

void NameEditor::focusAgain() {
  if (!then_ || !isVisible()) return;
  raise();
  setFocus();
  if (marked_.from >= 0) {
    setSelection(marked_.from, marked_.count);
  } else {
    setCursorPosition(marked_.cursor);
  }
}

void NameEditor::focusOutEvent(QFocusEvent* event) {
  marked_ = {selectionStart(), selectionLength(), cursorPosition()};
  QLineEdit::focusOutEvent(event);
  if (!then_) return;
  switch (event->reason()) {
    case Qt::PopupFocusReason:         // its own menu, or another one
    case Qt::ActiveWindowFocusReason:  // it has the focus again when this window is active again
      return;
    case Qt::MouseFocusReason:
      pressed_away_ = true;
      return rememberFocus();
    case Qt::TabFocusReason:
    case Qt::BacktabFocusReason:
    case Qt::ShortcutFocusReason:
      return close(true);
    default:
      // Not the user: a panel, a strip, an answer of the robot.
      by_hand_ ? close(true) : focusAgain();
  }
}

}  // namespace mapwright::ui

#include "moc_name_editor.cpp"
