// The docks of the window: their original positions, which are open, and which tab is in front.
#pragma once

#include <functional>
#include <vector>

#include <QByteArray>
#include <QObject>
#include <QStringList>
#include <QWidget>

class QDockWidget;
class QMainWindow;

namespace mapwright::ui {

class Actions;

/// The position of a dock where no layout names it: a tab at the end of its side.
struct PanelPosition {
  enum class Side { Left, Right, Bottom };
  Side side = Side::Left;
  int tab = 0;        // its rank among those tabs
  int menu_rank = 0;  // in the View menu
  bool open = false;
  std::function<bool()> idle = {};  // it has nothing to do with what is open now
};

/// An arrangement of the docks for one kind of work: which are open at first, and where.
struct Layout {
  /// Tabs in one area.
  struct Stack {
    PanelPosition::Side side = PanelPosition::Side::Left;
    QStringList docks;         // by object name; the first one is in front
    int share = 1;             // of the length of its side
    bool keeps_front = false;  // whatever is suggested
  };
  /// Those of one side are below one another, those at the bottom side by side.
  std::vector<Stack> stacks;
  int left_px = 220, right_px = 322, bottom_px = 168;
  /// The bottom reaches below the docks at the right.
  bool wide_bottom = false;
};

class Panels : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive this.
  Panels(QMainWindow& window, Actions& actions);

  /// Not owned. Gives the dock, which is complete, its title bar and lists it in the View menu.
  void add(QDockWidget* dock, const PanelPosition& position);
  /// In the order of the View menu.
  std::vector<QDockWidget*> docks() const;

  bool eventFilter(QObject* watched, QEvent* event) override;
  /// All as at first in this layout.
  void arrange(const Layout& layout = {});
  QByteArray state() const;
  /// A state() of `layout`. False: invalid state for these docks; nothing has changed.
  bool restore(const QByteArray& state, const Layout& layout = {});
  /// The layout was restored: nothing comes to the front automatically.
  bool restored() const { return restored_; }

  /// Shows a dock on request.
  void open(QDockWidget* dock);
  /// Brings a dock to the front, unless the user or the layout has chosen the one that is there.
  void suggest(QDockWidget* dock);
  /// Something else was opened: docks that have nothing to do with it leave the front to another tab.
  void standBack();

 Q_SIGNALS:
  /// All docks are in their original positions: suggest a more useful one than the last tab now.
  void arranged();

 private:
  struct Panel {
    QDockWidget* dock;
    PanelPosition position;
  };
  /// The stacks of a side, docks that the layout does not name at the end of the last one.
  std::vector<std::vector<Panel>> stacksOn(PanelPosition::Side side) const;
  const Layout::Stack* stackOf(const QDockWidget* dock) const;  // null: the layout does not name it
  bool opensAtFirst(const Panel& panel) const;
  void layOut();
  void share();
  void raiseFirst();
  /// Changes with the set of docks, so that an old state is not applied to a new layout.
  int version() const;

  QMainWindow& window_;
  Actions& actions_;
  std::vector<Panel> panels_;
  Layout layout_;
  const QDockWidget* behind_ = nullptr;  // the one that is being closed, which nobody sees
  bool restored_ = false;
};

/// Replaces the title bar of `dock`. Dragging and double-clicking still work.
void giveTitle(QDockWidget* dock);

}  // namespace mapwright::ui
