// One waypoint as a form: name, place, heading, tags.
#pragma once

#include <QWidget>

#include "window/waypoints/waypoint_editing.h"

class QDoubleSpinBox;
class QLineEdit;

namespace mapwright::window {

class WaypointForm : public QWidget {
  Q_OBJECT
 public:
  explicit WaypointForm(WaypointEditing* editing, QWidget* parent = nullptr);
  QLineEdit* nameEdit() const { return name_; }

 private:
  void refresh();
  void takeName(const QString& text);
  /// What the hand does to one field without a break is one command.
  void apply(const QString& what, edit::FieldMask field, const std::function<void(map::Waypoint&)>& change);

  WaypointEditing* editing_;
  QLineEdit *name_, *tags_;
  QDoubleSpinBox *x_, *y_, *yaw_;
  edit::Key shown_;
  edit::FieldMask last_field_ = 0;
  edit::Gesture gesture_ = 0;
  QString name_before_;  // what is typed now
  bool refreshing_ = false, typing_ = false;
};

}  // namespace mapwright::window
