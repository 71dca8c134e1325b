#include "ui/waypoints/tag_completer.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <QEvent>
#include <QStringListModel>

namespace mapwright::window {

TagCompleter::TagCompleter(WaypointEditing* editing, QLineEdit* edit)
    : QCompleter(edit), editing_(editing), edit_(edit), tags_(new QStringListModel(this)) {
  setModel(tags_);
  setCaseSensitivity(Qt::CaseInsensitive);
  setCompletionMode(QCompleter::PopupCompletion);
  edit_->setCompleter(this);
  edit_->installEventFilter(this);
  // Setting the text does not count as typing; this one was chosen.
  connect(
      this, qOverload<const QString&>(&QCompleter::activated), edit_, [this] { edit_->setModified(true); },
      Qt::QueuedConnection);
}

void TagCompleter::lookUp() {
  std::map<std::string, int> counts;
  if (editing_->document()) {
    for (const auto& [key, point] : editing_->document()->items()) {
      for (const std::string& tag : point.tags) ++counts[tag];
    }
  }
  std::vector<std::pair<int, std::string>> order;
  for (const auto& [tag, count] : counts) order.emplace_back(-count, tag);
  std::sort(order.begin(), order.end());
  QStringList tags;
  for (const auto& [count, tag] : order) {
    const QString text = QString::fromStdString(tag);
    if (!text.contains(QLatin1Char(','))) tags << text;  // that one cannot be typed
  }
  tags_->setStringList(tags);
}

QString TagCompleter::pathFromIndex(const QModelIndex& index) const {
  const QString typed = edit_->text();
  const qsizetype comma = typed.lastIndexOf(QLatin1Char(','));
  const QString before = comma < 0 ? QString() : typed.left(comma + 1) + QLatin1Char(' ');
  return before + QCompleter::pathFromIndex(index);
}

QStringList TagCompleter::splitPath(const QString& path) const {
  return {path.mid(path.lastIndexOf(QLatin1Char(',')) + 1).trimmed()};
}

bool TagCompleter::eventFilter(QObject* watched, QEvent* event) {
  if (watched == edit_ && event->type() == QEvent::FocusIn) lookUp();
  return QCompleter::eventFilter(watched, event);
}

}  // namespace mapwright::window

#include "moc_tag_completer.cpp"
