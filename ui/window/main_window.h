// The window: the map in the middle, docks around it, one robot at a time. It arranges; the controllers
// contain the features.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QByteArray>
#include <QMainWindow>
#include <QSettings>
#include <QString>
#include <QTimer>
#include <QUndoGroup>
#include <tl/expected.hpp>

#include "clouds/cloud_store.h"
#include "edit/open_waypoints.h"
#include "render/tile_renderer.h"
#include "robot/probe.h"
#include "robot/robot.h"
#include "session/session_options.h"
#include "ui/kit/actions.h"
#include "ui/kit/findings.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/window_context.h"
#include "ui/view/hit_list.h"
#include "work/workers.h"

namespace mapwright::keyring {
class KeyRing;
}

namespace mapwright::ui {

class AdministrationController;
class AppearanceController;
class CloudsController;
class ClosuresController;
class CompareController;
class ConnectionController;
class Controller;
class DisagreementController;
class ExportController;
class FilesController;
class InspectorController;
class LayersController;
class LayoutController;
class MapOverlay;
class MapsController;
class MapView;
class MessagesController;
class ObjectsController;
class OverlaysController;
class PictureController;
class PicturePlacing;
class PlotsController;
class PoseController;
class ProblemsController;
class ProjectionsController;
class RecordingsController;
class ReferenceController;
class RegionsController;
class ReplayController;
class RecordingController;
class RobotController;
class TransferController;
class ViewController;
class WaypointsController;
class WindowStatusBar;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// What the composition root provides.
  struct Dependencies {
    /// Makes a robot, not yet connected, from an address (also "demo:"). The error is a sentence.
    std::function<tl::expected<std::unique_ptr<robot::Robot>, QString>(const QString& address,
                                                                       const QByteArray& secret)>
        connect;
    QSettings& settings;           // must outlive the window
    QString initial_address = {};  // connected to at once; empty = none
    session::Session::Options session = {};
    render::TileRenderer::Options renderer = {};
    /// Returns the map.yaml files that name a picture as their image. Accesses the disk; called on any
    /// thread. Null: always ask for a picture's position.
    std::function<QStringList(const QString& picture)> yamls_naming = {};
    edit::EditOptions edit = {};      // where to keep drafts
    robot::Addresses addresses = {};  // the supported kinds
    /// Shared background threads; null = a thread pool of its own.
    std::shared_ptr<work::Workers> workers = {};
    /// The questions that tell which robots answer at a host; null: nobody is looked for.
    std::function<std::vector<robot::Probe>(const robot::Host& host)> probes = {};
    keyring::KeyRing* keys = nullptr;  // null: secrets are not kept
    /// Whether the program was started with a secret for this address.
    std::function<bool(const QString& address)> has_secret = {};
    /// The file that keeps the versions of overlays; empty: none are kept.
    std::string overlays_history = {};
    work::Budgets budgets = work::budgetsFrom();  // of all caches
  };

  explicit MainWindow(Dependencies dependencies, QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Switches to another robot after unsaved changes are saved or discarded; the error is a sentence, and
  /// then nothing has changed.
  std::optional<QString> connectTo(const QString& address, const QByteArray& secret = {});
  void leaveRobot();

  session::Session* session() const;
  scene::MapScene* mapScene() const { return scene_.get(); }
  MapView* view() const { return view_; }
  const Actions& actionList() const { return actions_; }
  void resetLayout();

  QMenu* createPopupMenu() override;

 protected:
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void createControllers(const Dependencies& dependencies);
  /// Connects signals from one controller to another.
  void connectControllers();
  void addOwnActions();
  void createToolBar();
  void notifyControllers(session::Session* session);
  void restoreSettings();
  void saveSettings();
  /// Some time after the user has done something, so that little is lost with the program.
  void storeSettings();
  void escape();
  void showMapMenu(const QPoint& global_pos, const QPointF& viewport_px);

  QSettings& settings_;
  std::shared_ptr<work::Workers> workers_;
  Actions actions_;
  Findings findings_;
  std::shared_ptr<clouds::CloudStore> cloud_store_;
  std::unique_ptr<scene::MapScene> scene_;
  HitList hits_{*scene_};
  QUndoGroup undo_;
  MapView* view_;
  WindowStatusBar* bar_;
  MapOverlay* overlay_;
  CurrentSession* current_;
  edit::EditOptions edit_;
  std::optional<WindowContext> context_;

  AppearanceController* appearance_ = nullptr;
  CloudsController* clouds_ = nullptr;
  ProjectionsController* projections_ = nullptr;
  CompareController* compare_ = nullptr;
  ConnectionController* connection_ = nullptr;
  ExportController* export_ = nullptr;
  FilesController* files_ = nullptr;
  ClosuresController* closures_ = nullptr;
  DisagreementController* disagreement_ = nullptr;
  InspectorController* inspector_ = nullptr;
  LayersController* layers_ = nullptr;
  LayoutController* layout_ = nullptr;
  MapsController* maps_ = nullptr;
  AdministrationController* administration_ = nullptr;
  MessagesController* messages_ = nullptr;
  ObjectsController* objects_ = nullptr;
  OverlaysController* overlays_ = nullptr;
  PictureController* picture_ = nullptr;
  PicturePlacing* placing_ = nullptr;
  PlotsController* plots_ = nullptr;
  PoseController* pose_ = nullptr;
  ProblemsController* problems_ = nullptr;
  RecordingsController* recordings_ = nullptr;
  ReplayController* replay_ = nullptr;
  RecordingController* recording_ = nullptr;
  ReferenceController* reference_ = nullptr;
  RegionsController* regions_ = nullptr;
  RobotController* robot_ = nullptr;
  TransferController* transfer_ = nullptr;
  ViewController* view_control_ = nullptr;
  WaypointsController* waypoints_ = nullptr;
  QTimer note_soon_;
  std::vector<Controller*> controllers_;  // in order of creation
  bool may_close_ = false;                // unsaved changes have been dealt with
};

}  // namespace mapwright::ui
