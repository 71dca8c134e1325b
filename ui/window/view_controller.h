// The view of the map: its tools (pan and measure), following, going to a point, the initial view; and what
// is under the cursor.
#pragma once

#include <QTimer>

#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"
#include "ui/view/map_tool.h"

namespace mapwright::ui {

class MeasureTool;

class ViewController : public Controller {
  Q_OBJECT
 public:
  explicit ViewController(WindowContext& context, QObject* parent = nullptr);

  void setSession(session::Session* session) override;
  void recall(const QSettings& settings) override;
  void remember(QSettings& settings) override;
  void reset() override;
  /// Takes away the marker of a place that was gone to.
  bool escape() override;

 Q_SIGNALS:
  /// A click on the map with the pan tool, world metres.
  void clicked(const Eigen::Vector2d& world_m);
  /// The same, with where it was on screen and with which keys.
  void picked(const mapwright::ui::MapPoint& at);

 private:
  void addTools();
  void addRobotActions();
  void addOtherActions();
  void addToMapMenu();
  void wireCursor();
  void follow(bool on);
  void goTo();
  void showCursor();
  void fitAtFirst();
  void fitScansAtFirst();
  void refresh();
  void copyCoordinates(const Eigen::Vector2d& world_m);

  WindowContext& context_;
  MeasureTool* measure_;
  QAction* follow_ = nullptr;
  QAction* robot_turn_ = nullptr;
  QAction* furniture_ = nullptr;
  QTimer cursor_timer_;
  bool fitted_poses_ = false, fitted_scans_ = false;
};

}  // namespace mapwright::ui
