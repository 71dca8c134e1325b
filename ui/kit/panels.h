// The docks of the window: their original places, which are open, and which tab is in front.
#pragma once

#include <vector>

#include <QByteArray>
#include <QObject>
#include <QWidget>

class QDockWidget;
class QMainWindow;

namespace mapwright::window {

class Actions;

/// The original place of a dock. Those on one side are tabs.
struct PanelPlace {
  enum class Side { Left, Right, Bottom };
  Side side = Side::Left;
  int tab = 0;        // its rank among the tabs of its side
  int menu_rank = 0;  // in the View menu
  bool open = true;
};

class Panels : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive this.
  Panels(QMainWindow& window, Actions& actions);

  /// Not owned. Gives the dock its title bar and lists it in the View menu.
  void add(QDockWidget* dock, const PanelPlace& place);
  /// In the order of the View menu.
  std::vector<QDockWidget*> docks() const;

  bool eventFilter(QObject* watched, QEvent* event) override;
  /// All as at first.
  void arrange();
  QByteArray state() const;
  /// False: invalid state for these docks; nothing has changed.
  bool restore(const QByteArray& state);
  /// The layout was restored: nothing comes to the front automatically.
  bool restored() const { return restored_; }

  /// Shows a dock on request.
  void open(QDockWidget* dock);
  /// Brings a dock to the front, unless the user has chosen the one that is there.
  void suggest(QDockWidget* dock);

 Q_SIGNALS:
  /// All docks are in their original places: suggest a more useful one than the last tab now.
  void arranged();

 private:
  struct Panel {
    QDockWidget* dock;
    PanelPlace place;
  };
  std::vector<Panel> onSide(PanelPlace::Side side) const;  // by tab
  void place();
  /// Changes with the set of docks, so that an old state is not applied to a new layout.
  int version() const;

  QMainWindow& window_;
  Actions& actions_;
  std::vector<Panel> panels_;
  bool restored_ = false;
};

/// Replaces the title bar of `dock`. Dragging and double-clicking still work.
void giveTitle(QDockWidget* dock);

}  // namespace mapwright::window
