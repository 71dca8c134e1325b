// Overlays from the robot: where it stands, where it sees a charger or a rack, and the landmarks and barcodes
// that it has collected. GUI thread.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include <QObject>
#include <QPointer>

#include "geometry/pose.h"
#include "overlays/overlay_marks.h"
#include "robot/sighting_source.h"
#include "session/session.h"
#include "ui/overlays/overlay_tool.h"
#include "ui/shell/window_context.h"

class QMenu;

namespace mapwright::ui {

class OverlayMarksDialog;

class OverlayTeaching : public QObject {
  Q_OBJECT
 public:
  /// All must outlive this.
  OverlayTeaching(WindowContext& context, edit::OverlayEditing* editing, OverlayTool* tool,
                  QObject* parent = nullptr);

  void setSession(session::Session* session);
  /// The robot is in the map whose overlays are edited.
  void setThere(bool there);
  QMenu* menu() const { return menu_; }
  OverlayMarksDialog* dialog() const;  // null: none is open
  /// It was asked for something, and has not answered yet.
  bool asking() const { return !call_.over(); }

 private:
  struct Thing {
    robot::Sight what;
    robot::SightEdge edge;
    int type;  // of the point that it becomes
    QAction* action;
    QString called;  // "charger"
  };
  void addThing(const char* id, const QString& text, const QString& called, robot::Sight what,
                robot::SightEdge edge, int type);
  void refresh();
  robot::SightingSource* source() const;
  std::optional<geometry::Pose2> robotPose() const;
  QString noRobotReason() const;
  void addRobotsPlace();
  void look(const Thing& thing);
  void onSighting(const Thing& thing, const robot::Sighting& sighting);
  void collect();
  void offer(const std::vector<map::Landmark>& collected, const QString& note);
  void addMarks(const std::vector<overlays::MarkOffer>& chosen);
  void show(const Eigen::Vector2d& at_m);

  WindowContext& context_;
  edit::OverlayEditing* editing_;
  OverlayTool* tool_;
  QMenu* menu_;
  QAction *place_, *marks_;
  std::vector<Thing> things_;
  QPointer<session::Session> session_;
  bool there_ = false, robot_known_ = false;
  robot::Call call_;
  std::map<std::string, geometry::Pose2> barcodes_;  // that came in this session
  QPointer<OverlayMarksDialog> dialog_;
};

}  // namespace mapwright::ui
