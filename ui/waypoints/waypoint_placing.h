// Placing waypoints with the map in mind: what they are caught by, what is doubtful about them, and what
// these two have to know of the map and the robot. GUI thread.
#pragma once

#include <QObject>
#include <QPointer>

#include "ui/shell/window_context.h"
#include "ui/waypoints/placing_actions.h"
#include "ui/waypoints/waypoint_snapping.h"
#include "ui/waypoints/waypoint_warnings.h"

namespace mapwright::window {

class WaypointPlacing : public QObject {
  Q_OBJECT
 public:
  /// What a robot is taken to be that does not tell its shape, until somebody says otherwise.
  static constexpr double kRadiusM = placing::kUsualRadiusM;

  /// Both must outlive this.
  WaypointPlacing(WindowContext& context, WaypointEditing* editing, QObject* parent = nullptr);

  void setSession(session::Session* session);
  void recall(const QSettings& settings);
  void remember(QSettings& settings) const;

  WaypointSnapping* snapping() const { return snapping_; }
  WaypointWarnings* warnings() const { return warnings_; }
  PlacingActions* actions() const { return actions_; }
  PlacingDialog* dialog() const { return dialog_; }  // null: none is open
  /// Selects the next one that is warned of, and looks at it.
  void showNextWarning();

 Q_SIGNALS:
  void made();  // some have been created

 private:
  void addSnapping();
  QAction* addRule(const char* id, const QString& text, const QString& tip, bool placing::SnapRules::*rule);
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
  QPointer<session::Session> session_;
  double radius_m_ = kRadiusM;  // where the robot does not tell
  double told_radius_m_ = 0;    // 0 = it does not
  QMenu* snap_menu_;
  QAction *snap_ = nullptr, *next_ = nullptr;
  std::vector<std::pair<QAction*, bool placing::SnapRules::*>> rules_;
  QPointer<PlacingDialog> dialog_;
};

}  // namespace mapwright::window
