// Other ways of creating waypoints than a click, and arranging the selected ones: actions, dialogs, the tool
// for lines. GUI thread.
#pragma once

#include <QObject>
#include <QPointer>

#include "placing/arrange.h"
#include "ui/shell/window_context.h"
#include "ui/waypoints/placing_dialogs.h"
#include "ui/waypoints/waypoint_editing.h"

namespace mapwright::window {

class LineBar;
class LineTool;
class WaypointSnapping;

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
  void addArranging();
  QAction* entry(const char* id, const QString& text, const char* icon, const char* key, Reach reach,
                 const QString& tip);
  void createAtRobot();
  void askForNumbers();
  void createAlongLine();
  void duplicate();
  using Arranging = std::vector<placing::Spot> (*)(std::vector<placing::Spot>, placing::Axis);
  void arrange(Arranging how, placing::Axis axis, const QString& what);
  /// The robot's pose on the map on screen; nullopt, with the reason in `why_not`: unknown.
  std::optional<geometry::Pose2> robotPose(QString* why_not) const;

  WindowContext& context_;
  WaypointEditing* editing_;
  WaypointSnapping* snapping_;
  LineTool* line_;
  LineBar* bar_;
  bool robot_known_ = false;
  QAction *at_robot_, *at_numbers_, *along_line_, *duplicate_, *all_, *invert_;
  std::vector<QAction*> arranging_;
  QMenu *creating_menu_, *arranging_menu_;
  QPointer<NewWaypointDialog> dialog_;
};

}  // namespace mapwright::window
