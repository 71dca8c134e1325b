// All actions of the window, in one list: menus, tool bar, the menu of the map, command palette and shortcut
// sheet are made from it. Where an action stands is said by whoever registers it.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QString>

class QMenu;
class QWidget;

namespace mapwright::window {

/// Where a shortcut works.
enum class Reach {
  Everywhere,   // in the whole window (has Ctrl, Alt or is a function key)
  OutsideText,  // everywhere but where text is typed: a single key, which a text field takes for itself
  Map,          // while the map has the focus: a key that means something else in other places
};

/// The menus of the menu bar, from left to right.
enum class Menu { Robot, Edit, Map, View, Help };

/// The groups of all menus, from top to bottom, a line between each two of the same menu.
enum class MenuGroup {
  // Robot
  Places,
  Link,
  Mapping,
  Quit,
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
  Copies,
  // View
  Maps,
  Drawn,
  Colors,
  Theme,
  Panels,
  Window,
  // Help
  Finding,
  About,
};

/// The groups of the tool bar, from left to right; the last one stands at the far end.
enum class BarGroup { Robot, Maps, Tools, Edit, Look, Drawn, Places, FarEnd };

/// The groups of the menu that the map has at a point.
enum class MapMenuGroup { Edit, Point, Submap, Copies, Look };

/// A place in a row of groups. Ranks count upwards within the group and leave room (10, 20 …); those of the
/// same rank stand as they were registered.
template <class Group>
struct Place {
  Group group = {};
  int rank = 0;  // 0 = nowhere
};
using MenuPlace = Place<MenuGroup>;
using BarPlace = Place<BarGroup>;
using MapMenuPlace = Place<MapMenuGroup>;

/// What is to be known of an action; what is left out, it does not have.
struct ActionSpec {
  const char* id = "";  // its object name
  QString text = {};    // with a mnemonic
  const char* icon = "";
  std::vector<const char*> keys = {};  // "Ctrl+O"
  Reach reach = Reach::Everywhere;
  QString tip = {};            // gets the keys appended
  bool toggle = false;         // on or off
  bool needs_session = false;  // it can do nothing while no robot and no file is open
  MenuPlace menu = {};
  BarPlace bar = {};
  MapMenuPlace map_menu = {};
};

class Actions : public QObject {
  Q_OBJECT
 public:
  struct Entry {
    QString menu;  // "View": the menu it stands in, and its heading in the shortcut sheet
    QAction* action;
    Reach reach;
    MenuPlace place = {};
  };
  /// Puts entries into the map's menu at a point, world metres; none where it has nothing to say there.
  using MapMenuFiller = std::function<void(QMenu& menu, const Eigen::Vector2d& world_m)>;
  using WidgetMaker = std::function<QWidget*(QWidget* parent)>;
  template <class Group, class What>
  struct Placed {
    Place<Group> place;
    What what;
  };
  /// One or the other.
  struct BarItem {
    QAction* action = nullptr;
    WidgetMaker make = {};
  };

  explicit Actions(QObject* parent = nullptr) : QObject(parent) {}

  QAction* add(const ActionSpec& spec);
  /// `what` is called when it is triggered, as long as `receiver` lives.
  template <class Receiver, class What>
  QAction* add(const ActionSpec& spec, Receiver* receiver, What&& what) {
    QAction* const action = add(spec);
    connect(action, &QAction::triggered, receiver, std::forward<What>(what));
    return action;
  }
  /// Those that stand in no menu. `id` is the object name. The tooltip gets the shortcut appended.
  QAction* add(const QString& menu, const QString& id, const QString& text, const QString& icon_name,
               const QList<QKeySequence>& shortcuts, Reach reach, const QString& tip);
  QAction* addToggle(const QString& menu, const QString& id, const QString& text, const QString& icon_name,
                     const QList<QKeySequence>& shortcuts, Reach reach, const QString& tip);
  /// An action that something else owns and that has no shortcuts: in its menu, and in the lists.
  void list(const MenuPlace& place, QAction* action);
  /// The same in its menu only, as for a submenu.
  void place(const MenuPlace& place, QAction* action);
  /// A widget on the tool bar, made when the bar is.
  void placeOnBar(const BarPlace& place, WidgetMaker make);
  void placeOnMapMenu(const MapMenuPlace& place, MapMenuFiller fill);

  /// In the order of the menus.
  const std::vector<Entry>& entries() const { return entries_; }
  QAction* find(const QString& id) const;  // null = none
  const std::vector<Placed<MenuGroup, QAction*>>& inMenus() const { return in_menus_; }
  const std::vector<Placed<BarGroup, BarItem>>& onBar() const { return on_bar_; }
  const std::vector<Placed<MapMenuGroup, MapMenuFiller>>& onMapMenu() const { return on_map_menu_; }

  /// Those that need a session are disabled while there is none, and enabled when one begins.
  void setSessionOpen(bool open);

  /// Makes the shortcuts work: those of Reach::Map on `map`, the rest on `window`.
  void attach(QWidget* window, QWidget* map);

 private:
  QAction* make(const QString& id, const QString& text, const QString& icon_name,
                const QList<QKeySequence>& shortcuts, Reach reach, const QString& tip);
  void enter(Entry entry);

  std::vector<Entry> entries_;
  std::vector<QAction*> need_session_;
  // Each in the order of its places.
  std::vector<Placed<MenuGroup, QAction*>> in_menus_;
  std::vector<Placed<BarGroup, BarItem>> on_bar_;
  std::vector<Placed<MapMenuGroup, MapMenuFiller>> on_map_menu_;
};

Menu menuOf(MenuGroup group);
/// "&Robot".
QString menuTitle(Menu menu);
/// Of a group that stands in a menu of its own within its menu; empty = it does not.
QString submenuTitle(MenuGroup group);

/// "Fit (F)": an action's text without mnemonics, dots and the like.
QString plainActionText(const QAction& action);
/// "F", "Ctrl+K", "+ or =".
QString shortcutsText(const QAction& action);

}  // namespace mapwright::window
