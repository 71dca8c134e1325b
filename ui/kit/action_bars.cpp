#include "ui/kit/action_bars.h"

#include <map>
#include <optional>

#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

#include "ui/kit/actions.h"

namespace mapwright::window {

void fillMenuBar(QMenuBar& bar, const Actions& actions) {
  std::map<Menu, QMenu*> menus;
  std::map<MenuGroup, QMenu*> submenus;
  std::map<Menu, MenuGroup> last;
  for (const auto& [place, action] : actions.inMenus()) {
    const Menu which = menuOf(place.group);
    QMenu*& menu = menus[which];
    if (!menu) {
      menu = bar.addMenu(menuTitle(which));
      menu->setToolTipsVisible(true);
    } else if (last[which] != place.group &&
               (submenuTitle(place.group).isEmpty() || submenuTitle(last[which]).isEmpty())) {
      menu->addSeparator();  // adjacent submenus need none
    }
    last[which] = place.group;
    const QString title = submenuTitle(place.group);
    if (title.isEmpty()) {
      menu->addAction(action);
      continue;
    }
    QMenu*& submenu = submenus[place.group];
    if (!submenu) {
      submenu = menu->addMenu(title);
      submenu->setToolTipsVisible(true);
    }
    submenu->addAction(action);
  }
}

void fillToolBar(QToolBar& bar, const Actions& actions) {
  std::optional<BarGroup> last;
  for (const auto& [place, item] : actions.onBar()) {
    if (last && last != place.group && place.group == BarGroup::FarEnd) {
      auto* gap = new QWidget(&bar);
      gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
      bar.addWidget(gap);
    } else if (last && last != place.group) {
      bar.addSeparator();
    }
    last = place.group;
    item.make ? (void)bar.addWidget(item.make(&bar)) : bar.addAction(item.action);
  }
}

void fillMapMenu(QMenu& menu, const Actions& actions, const Eigen::Vector2d& world_m) {
  std::optional<MapMenuGroup> last;
  for (const auto& [place, fill] : actions.onMapMenu()) {
    QAction* const line = last && last != place.group ? menu.addSeparator() : nullptr;
    const qsizetype before = menu.actions().size();
    fill(menu, world_m);
    if (menu.actions().size() > before) {
      last = place.group;
    } else {
      delete line;
    }
  }
}

}  // namespace mapwright::window
