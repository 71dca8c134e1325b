// Forms for the selected waypoints: one with its name, place, heading and tags, or several with what they
// have in common. GUI thread.
#pragma once

#include <QWidget>

#include "ui/waypoints/waypoint_editing.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace mapwright::ui {

class WaypointWarnings;

/// One of its fields has the focus: somebody may be typing.
bool hasFocusInside(const QWidget& form);

/// One waypoint: name, place, heading, tags.
class WaypointForm : public QWidget {
  Q_OBJECT
 public:
  explicit WaypointForm(WaypointEditing* editing, QWidget* parent = nullptr);
  QLineEdit* nameEdit() const { return name_; }
  QLineEdit* tagsEdit() const { return tags_; }
  QDoubleSpinBox* yawBox() const { return yaw_; }
  /// Must outlive this.
  void setWarnings(const WaypointWarnings* warnings);
  QString warningsShown() const;  // empty = none
  /// The selection has changed, or the focus has left.
  void refresh();

 private:
  void showWarnings();
  void applyName(const QString& text);
  void applyTags();
  /// Continuous changes of one field are one command.
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

/// What several waypoints have in common. Pure.
struct GroupSummary {
  std::size_t count = 0;
  Eigen::AlignedBox2d place;
  bool same_yaw = false;
  std::optional<double> yaw_rad;            // of all, where same_yaw
  std::map<std::string, std::size_t> tags;  // how many have each
  bool same_type = false;
  std::string type;  // of all, where same_type
};
GroupSummary summaryOf(const edit::WaypointDocument& document, const std::set<edit::Key>& keys);

/// Several: common values, differences, and changes to all.
class GroupForm : public QWidget {
  Q_OBJECT
 public:
  explicit GroupForm(WaypointEditing* editing, QWidget* parent = nullptr);

  QLabel* placeLabel() const { return place_; }
  QDoubleSpinBox* shiftX() const { return dx_; }
  QPushButton* renameButton() const { return rename_; }
  QPushButton* shiftButton() const { return shift_; }
  QComboBox* turnChoice() const { return turn_how_; }
  QDoubleSpinBox* turnBox() const { return yaw_; }
  QPushButton* turnButton() const { return turn_; }
  QLineEdit* addTagsEdit() const { return add_tags_; }
  QLineEdit* removeTagsEdit() const { return remove_tags_; }
  QLineEdit* typeEdit() const { return type_; }

 private:
  void refresh();
  void shift();
  void turn();
  void tag(QLineEdit* edit, bool add);

  WaypointEditing* editing_;
  QLabel *place_, *tags_;
  QDoubleSpinBox *dx_, *dy_, *yaw_;
  QComboBox* turn_how_;
  QPushButton *rename_, *shift_, *turn_;
  QLineEdit *add_tags_, *remove_tags_, *type_;
  QLabel* type_label_;
};

}  // namespace mapwright::ui
