// All actions of the window in one list: menus, tool bar, context menu, command palette and shortcut sheet
// are built from it. Whoever registers an action says where it goes.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QString>

#include "robot/robot.h"

class QMenu;
class QWidget;
class QMenuBar;
class QToolBar;

namespace mapwright::ui {

/// Where a shortcut works.
enum class Reach {
  Everywhere,   // in the whole window (has Ctrl, Alt or is a function key)
  OutsideText,  // everywhere except while typing: a single key, which text fields use themselves
  Map,          // while the map has the focus: a key with other meanings elsewhere
};

/// The menus of the menu bar, from left to right.
enum class Menu { File, Robot, Edit, Map, View, Help };

/// The groups of all menus, from top to bottom, separated by lines.
enum class MenuGroup {
  // File
  Files,
  Exports,
  Quit,
  // Robot
  Robots,
  Link,
  Mapping,
  // Edit
  Undo,
  Save,
  Waypoints,
  // Map
  Zoom,
  Look,
  Turn,
  Tools,
  WholeMap,
  Regions,
  Copies,
  // View
  Maps,
  Drawn,
  Colors,
  Theme,
  Languages,
  Layouts,
  Panels,
  Window,
  // Help
  Finding,
  About,
};

/// The groups of the tool bar, from left to right; the last two are at the far end.
enum class BarGroup { Robot, Maps, Tools, Edit, Look, Drawn, Places, Layouts, FarEnd };

/// The groups of the map's context menu.
enum class MapMenuGroup { Edit, Point, Submap, Copies, Look };

/// A position within groups. Ranks increase within the group, with gaps (10, 20 …); equal ranks are in order
/// of registration.
template <class Group>
struct GroupPosition {
  Group group = {};
  int rank = 0;  // 0 = nowhere
};
using MenuPosition = GroupPosition<MenuGroup>;
using BarPosition = GroupPosition<BarGroup>;
using MapMenuPosition = GroupPosition<MapMenuGroup>;

/// The properties of an action; omitted ones do not apply.
struct ActionSpec {
  const char* id = "";  // its object name
  QString text = {};    // with a mnemonic
  QString name = {};    // where it stands alone, without its menu around it; empty = the text says enough
  const char* icon = "";
  std::vector<const char*> keys = {};  // "Ctrl+O"
  Reach reach = Reach::Everywhere;
  QString tip = {};            // the keys are appended
  bool toggle = false;         // on or off
  bool needs_session = false;  // disabled while no robot or file is open
  /// The same, and while files are open that lack this, with the reason.
  std::optional<robot::Capability> needs_of_robot = {};
  MenuPosition menu = {};
  BarPosition bar = {};
  MapMenuPosition map_menu = {};
};

class Actions : public QObject {
  Q_OBJECT
 public:
  struct Entry {
    QString menu;  // "View": its menu, and its heading in the shortcut sheet
    QAction* action;
    Reach reach;
    MenuPosition position = {};
    QString name = {};  // see ActionSpec
  };
  /// Adds entries to the map's context menu at a point, world metres, if there are any.
  using MapMenuFiller = std::function<void(QMenu& menu, const Eigen::Vector2d& world_m)>;
  using WidgetMaker = std::function<QWidget*(QWidget* parent)>;
  template <class Group, class What>
  struct Positioned {
    GroupPosition<Group> position;
    What what;
  };
  /// One or the other.
  struct BarItem {
    QAction* action = nullptr;
    WidgetMaker make = {};
  };

  explicit Actions(QObject* parent = nullptr) : QObject(parent) {}

  QAction* add(const ActionSpec& spec);
  /// `what` is called when it is triggered, as long as `receiver` exists.
  template <class Receiver, class What>
  QAction* add(const ActionSpec& spec, Receiver* receiver, What&& what) {
    QAction* const action = add(spec);
    connect(action, &QAction::triggered, receiver, std::forward<What>(what));
    return action;
  }
  /// For actions outside of menus. `id` is the object name. The shortcut is appended to the tooltip.
  QAction* add(const QString& menu, const QString& id, const QString& text, const QString& icon_name,
               const QList<QKeySequence>& shortcuts, Reach reach, const QString& tip);
  QAction* addToggle(const QString& menu, const QString& id, const QString& text, const QString& icon_name,
                     const QList<QKeySequence>& shortcuts, Reach reach, const QString& tip);
  /// Deletes an action outside of menus.
  void remove(QAction* action);
  /// An action owned by someone else, without shortcuts: added to its menu and to the lists.
  void list(const MenuPosition& position, QAction* action);
  /// The same, but only in its menu, for example a submenu.
  void addToMenu(const MenuPosition& position, QAction* action);
  /// A widget on the tool bar, made together with the bar.
  void addToBar(const BarPosition& position, WidgetMaker make);
  void addToMapMenu(const MapMenuPosition& position, MapMenuFiller fill);

  /// In the order of the menus.
  const std::vector<Entry>& entries() const { return entries_; }
  QAction* find(const QString& id) const;  // null = none
  const std::vector<Positioned<MenuGroup, QAction*>>& inMenus() const { return in_menus_; }
  const std::vector<Positioned<BarGroup, BarItem>>& onBar() const { return on_bar_; }
  const std::vector<Positioned<MapMenuGroup, MapMenuFiller>>& onMapMenu() const { return on_map_menu_; }

  /// Disables actions that need a session while there is none. Null: nothing is open.
  void setSession(robot::Robot* robot);
  /// It may have gained or lost a capability.
  void updateCapabilities(robot::Robot* robot);

  /// Activates the shortcuts: those of Reach::Map on `map`, the others on `window`.
  void attach(QWidget* window, QWidget* map);

 private:
  QAction* make(const QString& id, const QString& text, const QString& icon_name,
                const QList<QKeySequence>& shortcuts, Reach reach, const QString& tip);
  void enter(Entry entry);

  std::vector<Entry> entries_;
  std::vector<QAction*> need_session_;
  std::vector<std::pair<QAction*, robot::Capability>> need_of_robot_;
  // Each in the order of its positions.
  std::vector<Positioned<MenuGroup, QAction*>> in_menus_;
  std::vector<Positioned<BarGroup, BarItem>> on_bar_;
  std::vector<Positioned<MapMenuGroup, MapMenuFiller>> on_map_menu_;
};

Menu menuOf(MenuGroup group);
/// "&Robot".
QString menuTitle(Menu menu);
/// "Robot".
QString menuName(Menu menu);
/// For a group that forms a submenu; empty = it does not.
QString submenuTitle(MenuGroup group);

/// "Panel: Maps", "Fit the map": says what the action does without its menu around it.
QString nameAlone(const Actions::Entry& entry);
/// The same in English, as far as it is known: one for each text that it may stand for. Empty while English
/// is spoken.
QStringList englishNames(const Actions::Entry& entry);
/// "Fit (F)": an action's text without mnemonics, dots and the like.
QString plainActionText(const QAction& action);
/// "F", "Ctrl+K", "+ or =".
QString shortcutsText(const QAction& action);

class Actions;

void fillMenuBar(QMenuBar& bar, const Actions& actions);
void fillToolBar(QToolBar& bar, const Actions& actions);
/// The context menu of the map at a point, world metres.
void fillMapMenu(QMenu& menu, const Actions& actions, const Eigen::Vector2d& world_m);

}  // namespace mapwright::ui
