#include "ui/kit/actions.h"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QStringList>
#include <QToolBar>
#include <QWidget>

#include "robot/has_capability.h"
#include "sentences/absence_sentence.h"
#include "sentences/language.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "words/listed.h"

namespace mapwright::ui {

namespace {

/// Items without a position come last.
template <class Group>
bool standsBefore(const GroupPosition<Group>& one, const GroupPosition<Group>& other) {
  return std::tuple(one.rank == 0, one.group, one.rank) <
         std::tuple(other.rank == 0, other.group, other.rank);
}

template <class Group, class What>
void insert(std::vector<Actions::Positioned<Group, What>>& row, const GroupPosition<Group>& position,
            What what) {
  const auto at = std::upper_bound(
      row.begin(), row.end(), position,
      [](const auto& wanted, const auto& other) { return standsBefore(wanted, other.position); });
  row.insert(at, {position, std::move(what)});
}

/// "&Robot" is Robot, "R&&D" is R&D. In Chinese the key stands behind the word: "机器人(&R)" is 机器人.
QString withoutMnemonic(QString text) {
  static const QRegularExpression kBehind(QStringLiteral("\\(&[^&\\s]\\)"));
  text.remove(kBehind);
  QString plain;
  for (qsizetype i = 0; i < text.size(); ++i) {
    if (text[i] == QLatin1Char('&') && ++i == text.size()) break;
    plain += text[i];
  }
  return plain;
}

void makeToggle(QAction& action) {
  action.setCheckable(true);
  action.setIconVisibleInMenu(false);  // a check mark is clearer there than a tinted icon
}

}  // namespace

void Actions::enter(Entry entry) {
  const auto at = std::upper_bound(
      entries_.begin(), entries_.end(), entry,
      [](const Entry& wanted, const Entry& other) { return standsBefore(wanted.position, other.position); });
  entries_.insert(at, std::move(entry));
}

QAction* Actions::add(const ActionSpec& spec) {
  QList<QKeySequence> keys;
  for (const char* key : spec.keys) keys << QKeySequence(QLatin1String(key));
  QAction* const action =
      make(QLatin1String(spec.id), spec.text, QLatin1String(spec.icon), keys, spec.reach, spec.tip);
  if (spec.toggle) makeToggle(*action);
  if (spec.needs_session) need_session_.push_back(action);
  if (spec.needs_of_robot) need_of_robot_.emplace_back(action, *spec.needs_of_robot);
  const bool in_menu = spec.menu.rank != 0;
  enter({in_menu ? menuName(menuOf(spec.menu.group)) : QString(), action, spec.reach, spec.menu, spec.name});
  if (in_menu) addToMenu(spec.menu, action);
  if (spec.bar.rank != 0) insert(on_bar_, spec.bar, BarItem{action, {}});
  if (spec.map_menu.rank != 0) {
    addToMapMenu(spec.map_menu, [action](QMenu& menu, const Eigen::Vector2d&) { menu.addAction(action); });
  }
  return action;
}

void Actions::list(const MenuPosition& where, QAction* action) {
  enter({menuName(menuOf(where.group)), action, Reach::Everywhere, where});
  addToMenu(where, action);
}

void Actions::addToMenu(const MenuPosition& where, QAction* action) { insert(in_menus_, where, action); }

void Actions::addToBar(const BarPosition& where, WidgetMaker make) {
  insert(on_bar_, where, BarItem{nullptr, std::move(make)});
}

void Actions::addToMapMenu(const MapMenuPosition& where, MapMenuFiller fill) {
  insert(on_map_menu_, where, std::move(fill));
}

QAction* Actions::make(const QString& id, const QString& text, const QString& icon_name,
                       const QList<QKeySequence>& shortcuts, Reach reach, const QString& tip) {
  auto* const action = new QAction(text, this);
  action->setIconText(withoutMnemonic(text).remove(QChar(0x2026)));  // on the tool bar
  action->setObjectName(id);
  if (!icon_name.isEmpty()) action->setIcon(themedIcon(icon_name));
  action->setShortcuts(shortcuts);
  // Text fields claim the keys that they can type before any shortcut gets them (QEvent::ShortcutOverride).
  action->setShortcutContext(reach == Reach::Map ? Qt::WidgetWithChildrenShortcut : Qt::WindowShortcut);
  const QString keys = shortcutsText(*action);
  action->setToolTip(plainToolTip(keys.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, keys)));
  action->setStatusTip(QString());
  return action;
}

QAction* Actions::add(const QString& menu, const QString& id, const QString& text, const QString& icon_name,
                      const QList<QKeySequence>& shortcuts, Reach reach, const QString& tip) {
  QAction* const action = make(id, text, icon_name, shortcuts, reach, tip);
  enter({menu, action, reach});
  return action;
}

QAction* Actions::addToggle(const QString& menu, const QString& id, const QString& text,
                            const QString& icon_name, const QList<QKeySequence>& shortcuts, Reach reach,
                            const QString& tip) {
  QAction* const action = add(menu, id, text, icon_name, shortcuts, reach, tip);
  makeToggle(*action);
  return action;
}

void Actions::remove(QAction* action) {
  std::erase_if(entries_, [action](const Entry& entry) { return entry.action == action; });
  delete action;
}

QAction* Actions::find(const QString& id) const {
  for (const Entry& entry : entries_) {
    if (entry.action->objectName() == id) return entry.action;
  }
  return nullptr;
}

void Actions::setSession(robot::Robot* robot) {
  for (QAction* action : need_session_) action->setEnabled(robot != nullptr);
  updateCapabilities(robot);
}

void Actions::updateCapabilities(robot::Robot* robot) {
  for (const auto& [action, capability] : need_of_robot_) {
    // Robots tell what they can do once they are connected.
    const bool told =
        robot && (robot->isLocal() || robot->connection().phase == robot::ConnectionPhase::Online);
    const bool lacks = told && !robot::has(*robot, capability);
    allow(action, robot && !lacks,
          lacks ? sentences::absenceReason(capability, robot->unavailableReason(capability)) : QString());
  }
}

void Actions::attach(QWidget* window, QWidget* map) {
  for (const Entry& entry : entries_) (entry.reach == Reach::Map ? map : window)->addAction(entry.action);
}

Menu menuOf(MenuGroup group) {
  if (group < MenuGroup::Robots) return Menu::File;
  if (group < MenuGroup::Undo) return Menu::Robot;
  if (group < MenuGroup::Zoom) return Menu::Edit;
  if (group < MenuGroup::Maps) return Menu::Map;
  return group < MenuGroup::Finding ? Menu::View : Menu::Help;
}

QString menuTitle(Menu menu) {
  switch (menu) {
    case Menu::File:
      return QCoreApplication::translate("window", "&File");
    case Menu::Robot:
      return QCoreApplication::translate("window", "&Robot");
    case Menu::Edit:
      return QCoreApplication::translate("window", "&Edit");
    case Menu::Map:
      return QCoreApplication::translate("window", "&Map");
    case Menu::View:
      return QCoreApplication::translate("window", "&View");
    case Menu::Help:
      break;
  }
  return QCoreApplication::translate("window", "&Help");
}

QString menuName(Menu menu) { return withoutMnemonic(menuTitle(menu)); }

QString submenuTitle(MenuGroup group) {
  switch (group) {
    case MenuGroup::Turn:
      return QCoreApplication::translate("window", "Turn");
    case MenuGroup::Regions:
      return QCoreApplication::translate("window", "Regions");
    case MenuGroup::Colors:
      return QCoreApplication::translate("window", "Colours of submaps");
    case MenuGroup::Theme:
      return QCoreApplication::translate("window", "Theme");
    case MenuGroup::Languages:
      return QCoreApplication::translate("window", "Language");
    case MenuGroup::Layouts:
      return QCoreApplication::translate("window", "Layout");
    case MenuGroup::Panels:
      return QCoreApplication::translate("window", "Panels");
    default:
      return {};
  }
}

constexpr Menu kMenus[] = {Menu::Robot, Menu::Edit, Menu::Map, Menu::View, Menu::Help};

namespace {

/// `text` is that of its action, without mnemonic.
QString nameAmong(const Actions::Entry& entry, const QString& text) {
  if (entry.position.group == MenuGroup::Panels)
    return QCoreApplication::translate("window", "Panel: %1").arg(text);
  const bool called_by_menu =
      entry.position.group == MenuGroup::Layouts || entry.position.group == MenuGroup::Languages;
  return called_by_menu ? words::about(submenuTitle(entry.position.group), text) : text;
}

}  // namespace

QString nameAlone(const Actions::Entry& entry) {
  if (!entry.name.isEmpty()) return entry.name;
  const QString text = plainActionText(*entry.action);
  if (entry.position.rank != 0) return nameAmong(entry, text);
  // In a menu of its own, inside one of the bar's.
  const bool of_bar = std::any_of(std::begin(kMenus), std::end(kMenus),
                                  [&](Menu menu) { return entry.menu == menuName(menu); });
  return of_bar || entry.menu.isEmpty() ? text : words::about(entry.menu, text);
}

QStringList englishNames(const Actions::Entry& entry) {
  const bool named = !entry.name.isEmpty();
  // As it was before keepKeysApart().
  const QString spoken = entry.action->property("spoken").toString();
  const QString text = spoken.isEmpty() ? entry.action->text() : spoken;
  QStringList sources = sentences::sourcesOf(named ? entry.name : text);
  // It may have no other name, and the words before it are translated all the same.
  if (!named && sources.isEmpty()) sources << text;
  const sentences::InEnglish english;
  QStringList names;
  for (const QString& source : sources) {
    const QString plain = withoutMnemonic(source);
    names << (named || entry.position.rank == 0 ? plain : nameAmong(entry, plain));
  }
  return names;
}

QString plainActionText(const QAction& action) { return withoutMnemonic(action.text()); }

QString shortcutsText(const QAction& action) {
  QStringList keys;
  for (const QKeySequence& shortcut : action.shortcuts()) keys << shortcut.toString(QKeySequence::NativeText);
  return keys.join(QCoreApplication::translate("window", " or "));
}

namespace {

/// The first entry with a key keeps it: pressed for two, it only walks from one to the other.
void keepKeysApart(const QMenu& menu) {
  QStringList taken;
  for (QAction* const action : menu.actions()) {
    if (action->menu()) keepKeysApart(*action->menu());
    const QString key = QKeySequence::mnemonic(action->text()).toString();
    if (key.isEmpty()) continue;
    if (taken.contains(key)) {
      action->setProperty("spoken", action->text());
      action->setText(withoutMnemonic(action->text()).replace(QLatin1String("&"), QLatin1String("&&")));
    } else {
      taken << key;
    }
  }
}

}  // namespace

void fillMenuBar(QMenuBar& bar, const Actions& actions) {
  std::map<Menu, QMenu*> menus;
  std::map<MenuGroup, QMenu*> submenus;
  std::map<Menu, MenuGroup> last;
  for (const auto& [position, action] : actions.inMenus()) {
    const Menu which = menuOf(position.group);
    QMenu*& menu = menus[which];
    if (!menu) {
      menu = bar.addMenu(menuTitle(which));
      menu->setToolTipsVisible(true);
    } else if (last[which] != position.group &&
               (submenuTitle(position.group).isEmpty() || submenuTitle(last[which]).isEmpty())) {
      menu->addSeparator();  // adjacent submenus need none
    }
    last[which] = position.group;
    const QString title = submenuTitle(position.group);
    if (title.isEmpty()) {
      menu->addAction(action);
      continue;
    }
    QMenu*& submenu = submenus[position.group];
    if (!submenu) {
      submenu = menu->addMenu(title);
      submenu->setToolTipsVisible(true);
    }
    submenu->addAction(action);
  }
  for (const auto& [which, menu] : menus) keepKeysApart(*menu);
}

void fillToolBar(QToolBar& bar, const Actions& actions) {
  std::optional<BarGroup> last;
  for (const auto& [position, item] : actions.onBar()) {
    if (last && *last < BarGroup::Layouts && position.group >= BarGroup::Layouts) {
      auto* gap = new QWidget(&bar);
      gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
      bar.addWidget(gap);
    } else if (last && last != position.group) {
      bar.addSeparator();
    }
    last = position.group;
    item.make ? (void)bar.addWidget(item.make(&bar)) : bar.addAction(item.action);
  }
}

void fillMapMenu(QMenu& menu, const Actions& actions, const Eigen::Vector2d& world_m) {
  std::optional<MapMenuGroup> last;
  for (const auto& [position, fill] : actions.onMapMenu()) {
    QAction* const line = last && last != position.group ? menu.addSeparator() : nullptr;
    const qsizetype before = menu.actions().size();
    fill(menu, world_m);
    if (menu.actions().size() > before) {
      last = position.group;
    } else {
      delete line;
    }
  }
}

}  // namespace mapwright::ui

#include "moc_actions.cpp"
