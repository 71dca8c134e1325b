// A map too large to be moved whole: fetched by the regions in view, as a whole, or as a rectangle.
#pragma once

#include <memory>

#include <QPointer>
#include <QTimer>

#include "regions/region_map.h"
#include "window/controller.h"
#include "window/window_context.h"

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
  /// The whole map on screen has been written into a file.
  void noteExported();

  /// Null while no robot gives its map by regions.
  regions::RegionMap* map() const { return map_.get(); }
  QMessageBox* question() const;  // null = none is asked
  /// The map by regions instead of any other.
  void showRegions();
  /// One line; empty while there is no map by regions.
  QString statusShown() const;
  RectangleTool* tool() const { return tool_; }

  /// Fetches the whole map or a rectangle of it, once.
  MapErrand& errand() const { return *errand_; }
  /// Seconds; 0 = never by itself.
  void setRefreshEvery(int seconds);
  int refreshEvery() const { return refresh_every_s_; }

 private:
  void addActions();
  void follow();  // the dispatcher has come or gone
  void look();    // at what is in view now
  void tell();
  bool online() const;
  void drawRectangle();
  QString reasonAt(const Eigen::Vector2d& world_m) const;
  /// The first view is where the robot is: there is map.
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
  // The last: they go first, and what they tell is taken by what stands above.
  std::unique_ptr<MapErrand> errand_;
  std::unique_ptr<MapSaving> saving_;
};

}  // namespace mapwright::window
