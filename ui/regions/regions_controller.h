// A map too large to be sent whole: fetched by the visible regions, as a whole, or as a rectangle.
#pragma once

#include <memory>

#include <QPointer>
#include <QTimer>

#include "regions/region_map.h"
#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

class QAction;
class QActionGroup;
class QMessageBox;

namespace mapwright::window {

class MapErrand;
class MapSaving;
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
  void noteExported();

  /// Null while no robot sends its map by region.
  regions::RegionMap* map() const { return map_.get(); }
  QMessageBox* question() const;  // null = none is open
  /// Shows the map by regions instead of any other.
  void showRegions();
  /// One line; empty without a map by regions.
  QString statusShown() const;
  RectangleTool* tool() const { return tool_; }

  /// Fetches the whole map or a rectangle of it, once.
  MapErrand& errand() const { return *errand_; }
  /// Seconds; 0 = never automatically.
  void setRefreshEvery(int seconds);
  int refreshEvery() const { return refresh_every_s_; }

 private:
  void addActions();
  void follow();  // the dispatcher has appeared or disappeared
  void look();    // updates the visible area
  void tell();
  bool online() const;
  void drawRectangle();
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
  // Last members: destroyed first, as their signals are handled by the members above.
  std::unique_ptr<MapErrand> errand_;
  std::unique_ptr<MapSaving> saving_;
};

}  // namespace mapwright::window
