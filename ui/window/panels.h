// The docks of the window: where they stand at first, which are open, which of those behind each other is in
// front.
#pragma once

#include <vector>

#include <QByteArray>
#include <QObject>

class QDockWidget;
class QMainWindow;

namespace mapwright::window {

class Actions;

/// Where a dock stands at first. Those of one side stand behind each other, as tabs.
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
  /// False: that was no state of these docks; nothing has changed.
  bool restore(const QByteArray& state);
  /// The layout is as the user left it: nothing comes to the front by itself.
  bool restored() const { return restored_; }

  /// Shows a dock that somebody asked for.
  void open(QDockWidget* dock);
  /// Brings a dock to the front, unless the user has chosen what is there.
  void suggest(QDockWidget* dock);

 Q_SIGNALS:
  /// All are as at first, and laid out: who has more to the point than the last tab suggests it now.
  void arranged();

 private:
  struct Panel {
    QDockWidget* dock;
    PanelPlace place;
  };
  std::vector<Panel> onSide(PanelPlace::Side side) const;  // by tab
  void place();
  /// Another one for other docks, so that an old state is not forced upon a new layout.
  int version() const;

  QMainWindow& window_;
  Actions& actions_;
  std::vector<Panel> panels_;
  bool restored_ = false;
};

}  // namespace mapwright::window
