// The actions of a replay: a submenu of the Robot menu.
#pragma once

#include <vector>

#include <QObject>

#include "ui/shell/window_context.h"

class QAction;
class QMenu;

namespace mapwright::window {

class ReplayClock;
class TimelineDock;

class ReplayActions : public QObject {
  Q_OBJECT
 public:
  /// All must outlive it.
  ReplayActions(WindowContext& context, ReplayClock& clock, TimelineDock& dock, QObject* parent = nullptr);

  /// Bags are read to their end automatically.
  bool readsAll() const;
  void setReadsAll(bool all);
  /// There is a replay, opened or not; `back`: where "back" leads.
  void setReplay(bool is_replay, const QString& back);

 Q_SIGNALS:
  void backWanted();
  void readsAllChanged(bool all);
  void exportWanted();

 private:
  template <typename What>
  QAction* entry(const char* id, const QString& text, const char* icon, const char* key, const QString& tip,
                 What&& what);
  void refresh();

  WindowContext& context_;
  ReplayClock& clock_;
  TimelineDock& dock_;
  QMenu* menu_;
  std::vector<QAction*> of_open_bag_;
  QAction *read_all_ = nullptr, *end_loop_ = nullptr, *back_ = nullptr;
};

}  // namespace mapwright::window
