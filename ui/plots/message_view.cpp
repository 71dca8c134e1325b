#include "ui/plots/message_view.h"

#include <utility>
#include <vector>

#include <QApplication>
#include <QContextMenuEvent>
#include <QDrag>
#include <QJsonArray>
#include <QJsonDocument>
#include <QMenu>
#include <QMouseEvent>

#include "ui/kit/status_text.h"

namespace mapwright::ui {

namespace {

/// Past the closing quote.
qsizetype endOfString(const QString& text, qsizetype at) {
  for (qsizetype i = at + 1; i < text.size(); ++i) {
    if (text[i] == QLatin1Char('\\')) {
      ++i;
    } else if (text[i] == QLatin1Char('"')) {
      return i + 1;
    }
  }
  return text.size();
}

std::string unescaped(const QString& quoted) {
  const QByteArray json = '[' + quoted.toUtf8() + ']';
  return QJsonDocument::fromJson(json).array().at(0).toString().toStdString();
}

bool isPlottable(const QString& value) {
  if (value == QLatin1String("true") || value == QLatin1String("false") || value == QLatin1String("null"))
    return true;
  bool number = false;
  (void)value.toDouble(&number);
  return number;
}

struct Level {
  bool array = false;
  std::size_t index = 0;
  std::string key = {};
  bool has_key = false;  // and its value comes next
  qsizetype key_from = 0, key_until = 0;
};

series::FieldPath pathOf(const std::vector<Level>& levels, const QString& topic) {
  series::FieldPath path{topic.toStdString(), {}};
  for (const Level& level : levels) {
    if (level.array) {
      path.steps.emplace_back(level.index);
    } else {
      path.steps.emplace_back(level.key);
    }
  }
  return path;
}

}  // namespace

std::optional<FieldAt> fieldAt(const QString& text, qsizetype offset, const QString& topic) {
  std::vector<Level> levels;
  for (qsizetype i = 0; i < text.size();) {
    const QChar c = text[i];
    const bool names = !levels.empty() && !levels.back().array && !levels.back().has_key;
    if (c == QLatin1Char('{') || c == QLatin1Char('[')) {
      if (levels.size() >= series::FieldPath::kMostSteps) return std::nullopt;
      levels.push_back({.array = c == QLatin1Char('[')});
      ++i;
    } else if (c == QLatin1Char('}') || c == QLatin1Char(']')) {
      if (levels.empty()) return std::nullopt;
      levels.pop_back();
      ++i;
    } else if (c == QLatin1Char(',')) {
      if (!levels.empty()) {
        ++levels.back().index;
        levels.back().has_key = false;
      }
      ++i;
    } else if (c == QLatin1Char('"') && names) {
      const qsizetype end = endOfString(text, i);
      levels.back().key = unescaped(text.mid(i, end - i));
      levels.back().has_key = true;
      levels.back().key_from = i;
      levels.back().key_until = end;
      i = end;
    } else if (c.isSpace() || c == QLatin1Char(':')) {
      ++i;
    } else {
      // A value; a truncated string is followed by a note.
      qsizetype end = c == QLatin1Char('"') ? endOfString(text, i) : i;
      while (end < text.size() && !QStringView(u",]}\n").contains(text[end])) ++end;
      const bool here = offset >= i && offset < end;
      const bool on_key = !levels.empty() && !levels.back().array && offset >= levels.back().key_from &&
                          offset < levels.back().key_until;
      if (here || on_key) {
        QString value = text.mid(i, end - i).trimmed();
        if (value.startsWith(QLatin1Char('"')) && value.endsWith(QLatin1Char('"')) && value.size() > 2)
          value = value.mid(1, value.size() - 2);
        if (levels.empty() || !isPlottable(value)) return std::nullopt;
        return FieldAt{pathOf(levels, topic), i, end};
      }
      i = std::max(end, i + 1);
    }
    if (i > offset + 100'000) break;
  }
  return std::nullopt;
}

MessageView::MessageView(QWidget* parent) : QPlainTextEdit(parent) { viewport()->setMouseTracking(true); }

std::optional<FieldAt> MessageView::fieldBelow(const QPoint& at) const {
  if (topic_.isEmpty()) return std::nullopt;
  const QTextCursor cursor = cursorForPosition(at);
  // Beyond the end of a line, cursorForPosition() returns the nearest position.
  const QRect cursor_rect = cursorRect(cursor);
  if (std::abs(cursor_rect.center().x() - at.x()) > 2 * fontMetrics().maxWidth() ||
      at.y() < cursor_rect.top() || at.y() > cursor_rect.bottom())
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
    QString name = plainWords(plotName(field->path), 80);
    name.replace(QLatin1Char('&'), QLatin1String("&&"));
    auto* const plot = new QAction(tr("Plot %1").arg(name), menu.get());
    connect(plot, &QAction::triggered, this, [this, path = field->path] { Q_EMIT plotWanted(path); });
    menu->insertAction(menu->actions().value(0), plot);
    menu->insertSeparator(menu->actions().value(1));
  }
  menu->exec(event->globalPos());
}

}  // namespace mapwright::ui

#include "moc_message_view.cpp"
