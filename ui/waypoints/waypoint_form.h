// One waypoint as a form: name, place, heading, tags.
#pragma once

#include <QWidget>

#include "ui/waypoints/waypoint_editing.h"

class QDoubleSpinBox;
class QLabel;
class QLineEdit;

namespace mapwright::window {

class WaypointWarnings;

class WaypointForm : public QWidget {
  Q_OBJECT
 public:
  explicit WaypointForm(WaypointEditing* editing, QWidget* parent = nullptr);
  QLineEdit* nameEdit() const { return name_; }
  QLineEdit* tagsEdit() const { return tags_; }
  QDoubleSpinBox* yawBox() const { return yaw_; }
  /// What is doubtful about them; must outlive this.
  void setWarnings(const WaypointWarnings* warnings);
  QString warningsShown() const;  // empty = none

 private:
  void refresh();
  void showWarnings();
  void takeName(const QString& text);
  /// What the hand does to one field without a break is one command.
  void apply(const QString& what, edit::FieldMask field, const std::function<void(map::Waypoint&)>& change);

  WaypointEditing* editing_;
  QLineEdit *name_, *tags_;
  QDoubleSpinBox *x_, *y_, *yaw_;
  QLabel* doubtful_;
  const WaypointWarnings* warnings_ = nullptr;
  edit::Key shown_;
  edit::FieldMask last_field_ = 0;
  edit::Gesture gesture_ = 0;
  QString name_before_;  // what is typed now
  bool refreshing_ = false, typing_ = false;
};

}  // namespace mapwright::window
