#include "ui/window/tool_bar.h"

#include <utility>

#include <QActionEvent>
#include <QKeyEvent>
#include <QLayout>
#include <QToolButton>

#include "ui/kit/actions.h"
#include "ui/kit/icons.h"

namespace mapwright::ui {

ToolBar::ToolBar(const Actions& actions, QWidget* parent) : QToolBar(tr("Tools"), parent) {
  setObjectName(QStringLiteral("tools"));
  setMovable(false);
  setFloatable(false);
  setIconSize({20, 20});
  toggleViewAction()->setVisible(false);
  fillToolBar(*this, actions);
  all_ = this->actions();
  if (auto* const more = findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"))) {
    more->setAccessibleName(tr("More tools"));
    more->setToolTip(tr("More tools"));
    more->setIcon(themedIcon(QStringLiteral("chevron-right")));
  }
}

void ToolBar::showRole(Role role) {
  for (QAction* action : all_) removeAction(action);
  QAction* line = nullptr;
  bool first = true;
  for (QAction* action : std::as_const(all_)) {
    if (action->isSeparator()) {
      line = first ? nullptr : action;
    } else if (isOnBar(role, action->objectName())) {
      if (QAction* const between = std::exchange(line, nullptr)) addAction(between);
      addAction(action);
      first = false;
    }
  }
  with_text_ = withTextOnBar(role);
  giveTexts();
}

void ToolBar::giveTexts() {
  std::vector<QToolButton*> buttons;
  for (const QString& id : std::as_const(with_text_)) {
    for (QAction* action : actions()) {
      auto* const button = qobject_cast<QToolButton*>(widgetForAction(action));
      if (action->objectName() == id && button) buttons.push_back(button);
    }
  }
  for (QAction* action : actions()) {
    if (auto* const button = qobject_cast<QToolButton*>(widgetForAction(action));
        button && !action->icon().isNull())
      button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  }
  int room = width() - layout()->sizeHint().width();
  for (QToolButton* const button : buttons) {
    const int without = button->sizeHint().width();
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    const int more = button->sizeHint().width() - without;
    if (more > room) {
      button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    } else {
      room -= more;
    }
  }
}

bool ToolBar::event(QEvent* event) {
  const bool done = QToolBar::event(event);
  if (event->type() == QEvent::ActionAdded) {
    // One stop of Tab for the whole bar; arrow keys go along it.
    if (QWidget* const widget = widgetForAction(static_cast<QActionEvent*>(event)->action()))
      widget->installEventFilter(this);
  }
  if (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange) giveTexts();
  return done;
}

bool ToolBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QToolBar::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key != Qt::Key_Left && key != Qt::Key_Right) return QToolBar::eventFilter(watched, event);
  QList<QWidget*> stops;
  for (QAction* action : actions()) {
    auto* const button = qobject_cast<QToolButton*>(widgetForAction(action));
    if (button && button->isVisible() && button->isEnabled()) stops << button;
  }
  const qsizetype at = stops.indexOf(static_cast<QWidget*>(watched));
  if (at < 0) return false;
  const qsizetype step = (key == Qt::Key_Right) == (layoutDirection() == Qt::LeftToRight) ? 1 : -1;
  stops[(at + step + stops.size()) % stops.size()]->setFocus(Qt::TabFocusReason);
  return true;
}

void ToolBar::resizeEvent(QResizeEvent* event) {
  QToolBar::resizeEvent(event);
  if (event->size().width() != event->oldSize().width()) giveTexts();
}

}  // namespace mapwright::ui

#include "moc_tool_bar.cpp"
