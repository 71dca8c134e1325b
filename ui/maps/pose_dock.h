// Where the robot believes to be, and where it is told to be.
#pragma once

#include <optional>

#include <QDockWidget>

#include "geometry/pose.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace mapwright::ui {

class PlainLabel;

class PoseDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit PoseDock(QWidget* parent = nullptr);

  /// Where the robot says it is. Until a pose is given the fields follow it.
  void setPresent(const std::optional<geometry::Pose2>& pose);
  /// What is to be set, without telling; nullopt: nothing yet.
  void setPose(const std::optional<geometry::Pose2>& pose);
  /// Why nothing can be set at present; empty if it can.
  void setObstacle(const QString& why);
  void setPlacing(bool on);
  /// A request is in progress: `said` tells of it.
  void setWaiting(bool waiting, const QString& said = {});
  enum class Outcome { Well, Odd, Bad };
  /// What came of it. `confirmable`: the robot asks whether it is so.
  void setOutcome(const QString& said, Outcome outcome, bool confirmable = false);
  void forgetOutcome();

  bool adjusts() const;
  QString outcomeShown() const;
  QString warningShown() const;
  QString presentShown() const;
  QDoubleSpinBox* xBox() const { return x_; }
  QDoubleSpinBox* yBox() const { return y_; }
  QDoubleSpinBox* yawBox() const { return yaw_; }
  QCheckBox* adjustBox() const { return adjust_; }
  QPushButton* placeButton() const { return place_; }
  QPushButton* setButton() const { return set_; }
  QPushButton* findButton() const { return find_; }
  QPushButton* confirmButton() const { return confirm_; }
  QPushButton* rejectButton() const { return reject_; }
  QPushButton* cancelButton() const { return cancel_; }

 Q_SIGNALS:
  void placeWanted(bool on);
  void typed(const mapwright::geometry::Pose2& pose);
  void setWanted();
  void findWanted();
  void confirmWanted();
  void cancelWanted();

 private:
  void applyTyped();
  void show(const geometry::Pose2& pose);
  void allowAll();

  QLabel *warning_, *outcome_;
  PlainLabel* present_;
  QDoubleSpinBox *x_, *y_, *yaw_;
  QCheckBox* adjust_;
  QPushButton *place_, *set_, *find_, *confirm_, *reject_, *cancel_;
  QString obstacle_;
  geometry::Pose2 present_pose_;
  bool setting_ = false, has_pose_ = false, waiting_ = false, confirmable_ = false;
};

}  // namespace mapwright::ui
