// Completes the last one of several comma-separated tags.
#pragma once

#include <QCompleter>
#include <QLineEdit>

#include "ui/waypoints/waypoint_editing.h"

class QStringListModel;

namespace mapwright::window {

class TagCompleter : public QCompleter {
  Q_OBJECT
 public:
  /// Of what is typed into `edit`, which becomes its parent; `editing` must outlive it. The tags are looked
  /// up whenever somebody begins to type there, those that most waypoints have first.
  TagCompleter(WaypointEditing* editing, QLineEdit* edit);

  QString pathFromIndex(const QModelIndex& index) const override;
  QStringList splitPath(const QString& path) const override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void lookUp();

  WaypointEditing* editing_;
  QLineEdit* edit_;
  QStringListModel* tags_;
};

}  // namespace mapwright::window
