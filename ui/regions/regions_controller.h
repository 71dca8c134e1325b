// A map too large to be sent whole: fetched by the visible regions, as a whole, or as a rectangle; saved on
// the robot.
#pragma once

#include <functional>
#include <memory>

#include <QDialog>
#include <QPointer>
#include <QTimer>

#include "regions/region_map.h"
#include "robot/map_dispatch.h"
#include "ui/kit/controller.h"
#include "ui/kit/status_text.h"
#include "ui/shell/window_context.h"

class QAction;
class QActionGroup;
class QLabel;
class QLineEdit;
class QMessageBox;
class QPushButton;

namespace mapwright::ui {

/// Asks for the name of the file that the robot writes its map to on its own disk. Stays open until the robot
/// has answered, and shows the answer next to the input.
class SaveMapDialog : public QDialog {
  Q_OBJECT
 public:
  /// `toast` shows the result.
  SaveMapDialog(robot::MapDispatch* dispatch, std::function<void(Mark, const QString&)> toast,
                QWidget* parent = nullptr);

 protected:
  void done(int result) override;

 private:
  QString filename() const;
  void look();
  void ask();
  void wait();
  /// It was not saved.
  void refuse(const QString& why);

  QPointer<robot::MapDispatch> dispatch_;
  std::function<void(Mark, const QString&)> toast_;
  robot::Call saving_;

  QLineEdit* name_;
  QLabel* state_;
  QPushButton* save_;
  bool waits_ = false;
};

class MapFetch;
class PlainLabel;
class RectangleTool;

class RegionsController : public Controller {
  Q_OBJECT
 public:
  explicit RegionsController(WindowContext& context, QObject* parent = nullptr);
  ~RegionsController() override;

  void setSession(session::Session* session) override;
  void recall(const QSettings& settings) override;
  void remember(QSettings& settings) override;
  std::vector<Fetched> fetched() override;
  /// The whole map on screen was written to a file.
  void onExported();

  /// Null while no robot sends its map by region.
  regions::RegionMap* map() const { return map_.get(); }
  QMessageBox* question() const;  // null = none is open
  /// Shows the map by regions instead of any other.
  void showRegions();
  /// One line; empty without a map by regions.
  QString statusShown() const;
  RectangleTool* tool() const { return tool_; }

  /// Fetches the whole map or a rectangle of it, once.
  MapFetch& fetch() const { return *map_fetch_; }
  /// Seconds; 0 = never automatically.
  void setRefreshEvery(int seconds);
  int refreshEvery() const { return refresh_every_s_; }

 private:
  void addActions();
  void follow();  // the dispatcher has appeared or disappeared
  void look();    // updates the visible area
  void updateState();
  bool online() const;
  void drawRectangle();
  void saveOnRobot();
  QString reasonAt(const Eigen::Vector2d& world_m) const;
  /// The first view is around the robot, where there is map.
  void lookAtRobot();

  WindowContext& context_;
  QPointer<robot::MapDispatch> dispatch_;
  std::unique_ptr<regions::RegionMap> map_;
  RectangleTool* tool_;
  QAction *refresh_ = nullptr, *fetch_whole_ = nullptr, *fetch_region_ = nullptr, *save_map_ = nullptr;
  QActionGroup* every_;
  QPointer<PlainLabel> status_;  // goes with the status bar
  QTimer look_soon_, refresh_timer_;
  int refresh_every_s_ = 0;
  bool looked_at_robot_ = false, was_online_ = false;
  QPointer<SaveMapDialog> save_dialog_;
  // Last member: destroyed first, as its signals are handled by the members above.
  std::unique_ptr<MapFetch> map_fetch_;
};

}  // namespace mapwright::ui
