// Placing waypoints with the map in mind: other ways of creating them than a click, what they snap to,
// warnings about them, and what these have to know of the map and the robot. GUI thread.
#pragma once

#include <QDialog>
#include <QObject>
#include <QPointer>

#include "map/waypoint.h"
#include "placing/arrange.h"
#include "ui/shell/window_context.h"
#include "ui/waypoints/waypoint_editing.h"
#include "ui/waypoints/waypoint_snapping.h"
#include "ui/waypoints/waypoint_warnings.h"

class QDoubleSpinBox;
class QLineEdit;

namespace mapwright::ui {

class LineBar;
class LineTool;
class WaypointArranging;

class NewWaypointDialog : public QDialog {
  Q_OBJECT
 public:
  /// `present`: the initial values.
  explicit NewWaypointDialog(const map::Waypoint& present, QWidget* parent = nullptr);
  /// As typed, without an id.
  map::Waypoint waypoint() const;
  QLineEdit* nameEdit() const { return name_; }
  QDoubleSpinBox* x() const { return x_; }
  QDoubleSpinBox* y() const { return y_; }
  QDoubleSpinBox* heading() const { return heading_; }

 private:
  QLineEdit* name_;
  QDoubleSpinBox *x_, *y_, *heading_;
};

/// The numbers for snapping and warnings.
struct PlacingNumbers {
  double grid_m = 0.5, wall_m = 0.5, radius_m = 0.3;
};

class PlacingDialog : public QDialog {
  Q_OBJECT
 public:
  /// `reported_radius_m`: from the robot's footprint, 0 = unknown; then the typed one is hidden.
  PlacingDialog(const PlacingNumbers& present, double reported_radius_m, QWidget* parent = nullptr);
  PlacingNumbers numbers() const;
  QDoubleSpinBox* grid() const { return grid_; }
  QDoubleSpinBox* wall() const { return wall_; }
  QDoubleSpinBox* radius() const { return radius_; }

 private:
  PlacingNumbers present_;
  QDoubleSpinBox *grid_, *wall_, *radius_;
};

class PlacingActions : public QObject {
  Q_OBJECT
 public:
  /// All must outlive this.
  PlacingActions(WindowContext& context, WaypointEditing* editing, WaypointSnapping* snapping,
                 QObject* parent = nullptr);

  LineTool* lineTool() const { return line_; }
  LineBar* lineBar() const { return bar_; }
  NewWaypointDialog* dialog() const { return dialog_; }  // null: none is open
  /// What can be done now.
  void refresh();
  /// Only what depends on the robot's pose, which changes many times a second.
  void refreshRobot();

 Q_SIGNALS:
  /// They were created by number or name: show them.
  void made();

 private:
  void addCreating();
  void addSelecting();
  QAction* entry(const char* id, const QString& text, const char* icon, const char* key, Reach reach,
                 const QString& tip);
  void createAtRobot();
  void askForNumbers();
  void createAlongLine();
  void duplicate();
  /// The robot's pose on the map on screen; nullopt, with the reason in `unavailable_reason`: unknown.
  std::optional<geometry::Pose2> robotPose(QString* unavailable_reason) const;

  WindowContext& context_;
  WaypointEditing* editing_;
  WaypointSnapping* snapping_;
  LineTool* line_;
  LineBar* bar_;
  bool robot_known_ = false;
  QAction *at_robot_, *at_numbers_, *along_line_, *duplicate_, *all_, *invert_;
  QMenu* creating_menu_;
  QPointer<NewWaypointDialog> dialog_;
};

class WaypointPlacing : public QObject {
  Q_OBJECT
 public:
  /// Of a robot that does not report its footprint, until the user sets another.
  static constexpr double kRadiusM = placing::kUsualRadiusM;

  /// Both must outlive this.
  WaypointPlacing(WindowContext& context, WaypointEditing* editing, QObject* parent = nullptr);

  void setSession(session::Session* session);
  void recall(const QSettings& settings);
  void remember(QSettings& settings) const;

  WaypointSnapping* snapping() const { return snapping_; }
  WaypointWarnings* warnings() const { return warnings_; }
  PlacingActions* actions() const { return actions_; }
  WaypointArranging* arranging() const { return arranging_; }
  PlacingDialog* dialog() const { return dialog_; }  // null: none is open
  /// Selects the next waypoint with a warning, and shows it.
  void showNextWarning();

 Q_SIGNALS:
  void made();  // some have been created

 private:
  void addSnapping();
  void refresh();
  void syncGround();
  void syncRadius();
  void askDistances();
  /// Without a picture nothing else tells where to look.
  void lookAtBareOnes();

  WindowContext& context_;
  WaypointEditing* editing_;
  WaypointSnapping* snapping_;
  WaypointWarnings* warnings_;
  PlacingActions* actions_;
  WaypointArranging* arranging_;
  QPointer<session::Session> session_;
  double radius_m_ = kRadiusM;    // if the robot does not report one
  double reported_radius_m_ = 0;  // 0 = unknown
  QMenu* snap_menu_;
  QAction *snap_ = nullptr, *next_ = nullptr;
  std::vector<std::pair<QAction*, bool placing::SnapRules::*>> rules_;
  QPointer<PlacingDialog> dialog_;
};

}  // namespace mapwright::ui
