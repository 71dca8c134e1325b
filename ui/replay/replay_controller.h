// A bag on screen instead of the live robot: its time, its panel, and the way back.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <QPointer>
#include <tl/expected.hpp>

#include "robot/bag_library.h"
#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"
#include "ui/view/on_screen.h"

class QAction;
class QKeyEvent;
class QMenu;

namespace mapwright::ui::reporting {
class ReportJob;
}

namespace mapwright::ui {

class EventsDock;
class RangeExportDialog;
class ReplayClock;
class TimelineDock;

class ReplayController : public Controller {
  Q_OBJECT
 public:
  /// Makes a robot with this address, not yet connected, like the present one. The error is a sentence.
  using MakeRobot =
      std::function<tl::expected<std::unique_ptr<robot::Robot>, QString>(const QString& address)>;

  ReplayController(WindowContext& context, MakeRobot make_robot, QObject* parent = nullptr);
  ~ReplayController() override;

  ReplayClock& clock() const { return *clock_; }
  TimelineDock* dock() const { return dock_; }
  EventsDock* eventsDock() const { return events_; }

  /// A bag of the present robot, or of the one whose bag is shown. Errors are shown as a toast.
  void openBag(const robot::BagKey& key);
  /// A bag of `origin`, which is not connected; replaces what is on screen after unsaved changes are saved or
  /// discarded.
  void open(std::unique_ptr<robot::Robot> origin, const robot::BagKey& key);
  /// The bag of this name, or else the recording.
  void open(std::unique_ptr<robot::Robot> origin, const std::string& name);
  /// Ends the replay; goes back to the robot or map that was open before, if there was one.
  void back();
  /// Asks which part of the open bag to export.
  void exportRange();
  RangeExportDialog* rangeDialog() const;  // null: not open
  /// Writes the report of the present moment to a file that is asked for.
  void reportMoment();
  /// The same to this file; a toast says what came of it.
  void reportMoment(const QString& path);
  /// A click on the robot's path goes to the time when it was there.
  void clickedOnMap(const Eigen::Vector2d& world_m);

  /// The window's layout is about to change: a timeline that came with the bag is no part of it.
  void leaveLayout();
  void onLayout();

  void setSession(session::Session* session) override;
  void recall(const QSettings& settings) override;
  void remember(QSettings& settings) override;

 Q_SIGNALS:
  /// The replay ends: to what was open before it.
  void backWanted(const QString& address);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// Space plays wherever it has no other use.
  bool onSpaceKey(QObject& at, QKeyEvent& key);
  /// The submenu of the Robot menu.
  void addActions();
  template <typename What>
  QAction* entry(const char* id, const QString& text, const char* icon, const char* key, const QString& tip,
                 What&& what);
  void refreshActions();
  void show(std::unique_ptr<robot::Robot> replay);
  void onConnection();
  void onOpened();
  void showPose();
  /// Whether the robot was connected at this time of its recording.
  void onLink();
  /// Once the state at the first time is known.
  void chooseMaps();
  void chooseMode();
  void fitAtFirst();
  /// A bag is seen with the whole path of its robot, until the user moves the map or the time.
  void fitTrack(geometry::WorldRect track);
  void connectEvents();
  void saveEvents();
  void refresh();
  QString backWords() const;

  WindowContext& context_;
  MakeRobot make_robot_;
  ReplayClock* clock_;
  TimelineDock* dock_;
  EventsDock* events_;
  QPointer<RangeExportDialog> range_dialog_;
  std::unique_ptr<reporting::ReportJob> report_;  // being written
  QMenu* menu_ = nullptr;
  std::vector<QAction*> of_open_bag_;
  QAction *read_all_ = nullptr, *end_loop_ = nullptr, *back_ = nullptr;
  bool space_pressed_ = false;  // on the map, without other input since
  bool dock_was_open_ = true;   // the timeline, before there was a bag
  bool shown_before_ = false;   // in the layout that was left
  bool maps_chosen_ = false;
  bool fits_track_ = false;            // neither the map nor the time has been moved since the bag was opened
  std::optional<double> opened_at_s_;  // the time shown first
  bool away_ = false;                  // disconnected at this time of the recording
  std::optional<ViewMode> mode_before_;  // a bag without submaps
};

}  // namespace mapwright::ui
