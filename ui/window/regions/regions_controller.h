// A map too large to be moved whole: fetched by the regions in view, as a whole, or as a rectangle.
#pragma once

#include <functional>
#include <memory>

#include <QMessageBox>
#include <QPointer>
#include <QTimer>

#include "regions/region_fetch.h"
#include "window/controller.h"
#include "window/status/status_text.h"
#include "window/window_context.h"

class QActionGroup;

namespace mapwright::window {

class ExportJob;
class PlainLabel;
class RectangleTool;
class SaveMapDialog;

class RegionsController : public Controller {
  Q_OBJECT
 public:
  explicit RegionsController(WindowContext& context, QObject* parent = nullptr);
  ~RegionsController() override;

  void setSession(session::Session* session) override;
  void recall(const QSettings& settings) override;
  void remember(QSettings& settings) override;

  /// Null while no robot gives its map by regions.
  regions::RegionMap* map() const { return map_.get(); }
  QMessageBox* question() const { return question_; }  // null = none is asked
  /// The map by regions instead of any other.
  void showRegions();
  /// One line; empty while there is no map by regions.
  QString statusShown() const;
  RectangleTool* tool() const { return tool_; }

  /// Asks first, with the size that is known.
  void fetchWhole();
  /// Asks what is to become of it.
  void takeRectangle(const geometry::WorldRect& rect);
  /// Fetches the rectangle and writes `path`.pgm and .yaml, or shows it as a map.
  void saveRectangle(const geometry::WorldRect& rect, const QString& path);
  void keepRectangle(const geometry::WorldRect& rect);
  /// Seconds; 0 = never by itself.
  void setRefreshEvery(int seconds);
  int refreshEvery() const { return refresh_every_s_; }

 private:
  enum class Then { Show, Save };
  void addActions();
  void follow();  // the dispatcher has come or gone
  void look();    // at what is in view now
  void tell();
  bool online() const;
  void startWhole();
  void startRectangle(const geometry::WorldRect& rect, Then then, const QString& path);
  void endRectangle();
  void show(std::function<std::string()> picture, const map::GridReference& grid, const QString& name);
  void save(const regions::FetchedGrid& fetched);
  void saveOnRobot();
  void stopJob();
  /// The first view is where the robot is: there is map.
  void lookAtRobot();
  void toast(Mark mark, const QString& text);

  WindowContext& context_;
  QPointer<robot::MapDispatch> dispatch_;
  std::unique_ptr<regions::RegionMap> map_;
  RectangleTool* tool_;
  QAction *refresh_ = nullptr, *fetch_whole_ = nullptr, *fetch_region_ = nullptr, *save_map_ = nullptr;
  QActionGroup* every_;
  QPointer<PlainLabel> status_;  // goes with the status bar
  QPointer<QMessageBox> question_;
  QPointer<SaveMapDialog> save_dialog_;
  robot::Call saving_;
  QTimer look_soon_, refresh_timer_;
  int refresh_every_s_ = 0;
  // One at a time.
  std::unique_ptr<regions::RegionFetch> fetch_;
  Then then_ = Then::Show;
  QString path_;
  robot::Call whole_;
  bool whole_under_way_ = false, looked_at_robot_ = false;
  std::uint64_t job_ = 0;  // what still comes of an older one is not taken
  std::unique_ptr<ExportJob> export_;
  work::Share share_;  // the last: it waits for what runs
};

}  // namespace mapwright::window
