#include "ui/robot/robot_menus.h"

#include <QFileInfo>

#include "ui/kit/actions.h"
#include "ui/kit/plain_label.h"
#include "ui/robot/recent_robots.h"
#include "ui/shell/current_session.h"
#include "words/qt_plain.h"

namespace mapwright::window {

namespace {

/// Without submenus, which belong to the menu bar.
void addGroup(QMenu& menu, const Actions& actions, MenuGroup group) {
  for (const auto& [place, action] : actions.inMenus()) {
    if (place.group == group && !action->menu()) menu.addAction(action);
  }
}

}  // namespace

RobotMenus::RobotMenus(QWidget& window, Actions& actions, const RecentRobots& recents,
                       const CurrentSession& current, QObject* parent)
    : QObject(parent), actions_(actions), recents_(recents), current_(current) {
  auto* const files = new QMenu(tr("Recent &files"), &window);
  files->setToolTipsVisible(true);
  connect(files, &QMenu::aboutToShow, this, [this, files] {
    files->clear();
    addRecents(*files, true, {});
    if (files->isEmpty()) files->addAction(tr("None yet"))->setEnabled(false);
  });
  actions_.place({MenuGroup::Places, 30}, files->menuAction());
}

QMenu* RobotMenus::makeChipMenu(QWidget* owner) {
  auto* const menu = new QMenu(owner);
  menu->setToolTipsVisible(true);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillChipMenu(*menu); });
  return menu;
}

void RobotMenus::fillChipMenu(QMenu& menu) {
  menu.clear();
  addGroup(menu, actions_, MenuGroup::Places);
  addRecents(menu, false, tr("Recent robots"));
  addRecents(menu, true, tr("Recent files"));
  if (!current_.session()) return;
  menu.addSeparator();
  addGroup(menu, actions_, MenuGroup::Link);
}

void RobotMenus::addRecents(QMenu& menu, bool files, const QString& title) {
  bool first = true;
  for (const RecentRobot& robot : recents_.list()) {
    const auto parsed = recents_.addresses().parse(robot.address);
    const QString path = parsed ? parsed->path : QString();
    if (robot.address == current_.address() || path.isEmpty() == files) continue;
    if (first && !title.isEmpty()) menu.addSection(title);
    first = false;
    QString label =
        files ? QStringLiteral("%1  %2").arg(QFileInfo(path).fileName(), QFileInfo(path).absolutePath())
        : robot.name.isEmpty() ? robot.address
                               : QStringLiteral("%1  %2").arg(words::plainName(robot.name), robot.address);
    label.replace(QLatin1Char('&'), QLatin1String("&&"));  // no mnemonics from robots
    QAction* const action = menu.addAction(label.left(120));
    action->setToolTip(plainToolTip(robot.address));
    connect(action, &QAction::triggered, this,
            [this, address = robot.address] { Q_EMIT addressWanted(address); });
  }
}

}  // namespace mapwright::window

#include "moc_robot_menus.cpp"
