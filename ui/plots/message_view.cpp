#include "ui/plots/message_view.h"

#include <utility>

#include <QApplication>
#include <QContextMenuEvent>
#include <QDrag>
#include <QMenu>
#include <QMouseEvent>

#include "ui/plots/field_drag.h"

namespace mapwright::window {

MessageView::MessageView(QWidget* parent) : QPlainTextEdit(parent) { viewport()->setMouseTracking(true); }

std::optional<FieldAt> MessageView::fieldBelow(const QPoint& at) const {
  if (topic_.isEmpty()) return std::nullopt;
  const QTextCursor cursor = cursorForPosition(at);
  // Beyond the end of a line, cursorForPosition() returns the nearest place.
  const QRect place = cursorRect(cursor);
  if (std::abs(place.center().x() - at.x()) > 2 * fontMetrics().maxWidth() || at.y() < place.top() ||
      at.y() > place.bottom())
    return std::nullopt;
  const QString text = toPlainText();
  if (auto field = fieldAt(text, cursor.position(), topic_)) return field;
  return cursor.position() > 0 ? fieldAt(text, cursor.position() - 1, topic_) : std::nullopt;
}

void MessageView::mousePressEvent(QMouseEvent* event) {
  // With Shift text is selected as usual, even from a number on.
  const bool plain = event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier;
  pressed_ = plain ? fieldBelow(event->pos()) : std::nullopt;
  pressed_at_ = event->pos();
  if (!pressed_) QPlainTextEdit::mousePressEvent(event);
}

void MessageView::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton)
    viewport()->setCursor(fieldBelow(event->pos()) ? Qt::OpenHandCursor : Qt::IBeamCursor);
  if (!pressed_) return QPlainTextEdit::mouseMoveEvent(event);
  if ((event->pos() - pressed_at_).manhattanLength() < QApplication::startDragDistance()) return;
  const FieldAt field = *std::exchange(pressed_, std::nullopt);
  auto mime = mimeOf(field.path);
  if (carry) return carry(std::move(mime));
  auto* const drag = new QDrag(this);
  drag->setMimeData(mime.release());
  drag->exec(Qt::CopyAction);
}

void MessageView::mouseReleaseEvent(QMouseEvent* event) {
  if (!std::exchange(pressed_, std::nullopt)) return QPlainTextEdit::mouseReleaseEvent(event);
  setTextCursor(cursorForPosition(event->pos()));
}

void MessageView::contextMenuEvent(QContextMenuEvent* event) {
  const std::unique_ptr<QMenu> menu(createStandardContextMenu());
  if (const auto field = fieldBelow(event->pos())) {
    QString name = plotName(field->path).left(80);
    name.replace(QLatin1Char('&'), QLatin1String("&&"));
    auto* const plot = new QAction(tr("Plot %1").arg(name), menu.get());
    connect(plot, &QAction::triggered, this, [this, path = field->path] { Q_EMIT plotWanted(path); });
    menu->insertAction(menu->actions().value(0), plot);
    menu->insertSeparator(menu->actions().value(1));
  }
  menu->exec(event->globalPos());
}

}  // namespace mapwright::window

#include "moc_message_view.cpp"
