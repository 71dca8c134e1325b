// Several waypoints as a form: common values, differences, and changes to all. GUI thread.
#pragma once

#include <QWidget>

#include "ui/waypoints/waypoint_editing.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace mapwright::window {

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

class GroupForm : public QWidget {
  Q_OBJECT
 public:
  explicit GroupForm(WaypointEditing* editing, QWidget* parent = nullptr);

  QLabel* placeLabel() const { return place_; }
  QDoubleSpinBox* shiftX() const { return dx_; }
  QDoubleSpinBox* shiftY() const { return dy_; }
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
  QPushButton *shift_, *turn_;
  QLineEdit *add_tags_, *remove_tags_, *type_;
  QLabel* type_label_;
};

}  // namespace mapwright::window
