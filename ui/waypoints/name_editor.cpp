#include "ui/waypoints/name_editor.h"

#include <algorithm>
#include <utility>

#include <QKeyEvent>

namespace mapwright::window {

namespace {

constexpr int kNameWidthPx = 180, kAsidePx = 12, kLongestTyped = 500;

}  // namespace

NameEditor::NameEditor(QWidget* map) : QLineEdit(map) {
  setMaxLength(kLongestTyped);
  setAccessibleName(tr("Name of the waypoint"));
  hide();
  connect(this, &QLineEdit::textEdited, this, [this](const QString& text) {
    if (then_) then_(text.trimmed().isEmpty() ? offered_ : text);
  });
}

void NameEditor::ask(const QPointF& at, const QString& name, std::function<void(const QString&)> then) {
  finish();
  follow(at);
  setText(name);
  offered_ = name;
  selectAll();
  then_ = std::move(then);
  show();
  raise();
  setFocus();
}

void NameEditor::follow(const QPointF& at) {
  const int height = sizeHint().height();
  const QRect room = parentWidget()->rect().adjusted(4, 4, -4, -4);
  const int x =
      std::clamp(int(at.x()) + kAsidePx, room.left(), std::max(room.left(), room.right() - kNameWidthPx));
  const int y =
      std::clamp(int(at.y()) - height / 2, room.top(), std::max(room.top(), room.bottom() - height));
  setGeometry(x, y, kNameWidthPx, height);
}

void NameEditor::finish() { close(true); }

void NameEditor::close(bool take) {
  if (!then_) return;
  const auto then = std::exchange(then_, nullptr);
  hide();
  if (isModified()) then(take && !text().trimmed().isEmpty() ? text() : offered_);
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
      return QLineEdit::keyPressEvent(event);
  }
  event->accept();
  Q_EMIT closed();
}

void NameEditor::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  // Its own context menu does not end it, and neither does switching windows.
  const Qt::FocusReason why = event->reason();
  if (why != Qt::PopupFocusReason && why != Qt::ActiveWindowFocusReason) close(true);
}

}  // namespace mapwright::window

#include "moc_name_editor.cpp"
