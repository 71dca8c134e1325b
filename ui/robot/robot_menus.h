// Menus of places to go: that of the connection chip, and the recent files.
#pragma once

#include <QMenu>
#include <QObject>

namespace mapwright::window {

class Actions;
class CurrentSession;
class RecentRobots;

class RobotMenus : public QObject {
  Q_OBJECT
 public:
  /// All must outlive this. Adds itself to the Robot menu.
  RobotMenus(QWidget& window, Actions& actions, const RecentRobots& recents, const CurrentSession& current,
             QObject* parent = nullptr);
  /// Owned by `owner`.
  QMenu* makeChipMenu(QWidget* owner);

 Q_SIGNALS:
  void addressWanted(const QString& address);

 private:
  void fillChipMenu(QMenu& menu);
  void addRecents(QMenu& menu, bool files, const QString& title);

  Actions& actions_;
  const RecentRobots& recents_;
  const CurrentSession& current_;
};

}  // namespace mapwright::window
