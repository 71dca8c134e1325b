#include "window/actions.h"

#include <QStringList>
#include <QWidget>

#include "window/look/icons.h"
#include "window/look/plain_label.h"

namespace mapwright::window {

QAction* Actions::add(const QString& menu, const QString& id, const QString& text, const QString& icon_name,
                      const QList<QKeySequence>& shortcuts, Reach reach, const QString& tip) {
  auto* action = new QAction(text, this);
  action->setObjectName(id);
  if (!icon_name.isEmpty()) action->setIcon(themedIcon(icon_name));
  action->setShortcuts(shortcuts);
  // Text fields claim the keys that they can type before any shortcut gets them (QEvent::ShortcutOverride).
  action->setShortcutContext(reach == Reach::Map ? Qt::WidgetWithChildrenShortcut : Qt::WindowShortcut);
  const QString keys = shortcutsText(*action);
  action->setToolTip(plainToolTip(keys.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, keys)));
  action->setStatusTip(QString());
  entries_.push_back({menu, action, reach});
  return action;
}

QAction* Actions::addToggle(const QString& menu, const QString& id, const QString& text,
                            const QString& icon_name, const QList<QKeySequence>& shortcuts, Reach reach,
                            const QString& tip) {
  QAction* action = add(menu, id, text, icon_name, shortcuts, reach, tip);
  action->setCheckable(true);
  action->setIconVisibleInMenu(false);  // a check mark says more there than a tinted picture
  return action;
}

QAction* Actions::find(const QString& id) const {
  for (const Entry& entry : entries_) {
    if (entry.action->objectName() == id) return entry.action;
  }
  return nullptr;
}

void Actions::attach(QWidget* window, QWidget* map) {
  for (const Entry& entry : entries_) (entry.reach == Reach::Map ? map : window)->addAction(entry.action);
}

QString plainActionText(const QAction& action) {
  QString text = action.text();
  text.remove(QLatin1Char('&'));
  return text;
}

QString shortcutsText(const QAction& action) {
  QStringList keys;
  for (const QKeySequence& shortcut : action.shortcuts()) keys << shortcut.toString(QKeySequence::NativeText);
  return keys.join(QStringLiteral(" or "));
}

}  // namespace mapwright::window
