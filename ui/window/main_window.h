// The window: the map in the middle, docks around it, one robot at a time.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QByteArray>
#include <QImage>
#include <QMainWindow>
#include <QPointer>
#include <QSet>
#include <QSettings>
#include <QString>
#include <QTimer>
#include <tl/expected.hpp>

#include "robot/robot.h"
#include "scene/map_scene.h"
#include "session/session.h"
#include "window/actions.h"
#include "window/dialogs/recent_robots.h"
#include "window/look/theme.h"
#include "window/map/view_mode.h"

class QActionGroup;
class QDockWidget;

namespace mapwright::window {

class CompareControl;
class ConnectDialog;
class ConnectionChip;
class ExportDialog;
class InspectorDock;
class LayersDock;
class MapOverlay;
class MapsDock;
class MapView;
class MeasureTool;
class MessagesDock;
class PictureDialog;
class ProblemsDock;
class RobotDock;
class WindowStatusBar;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// What the window needs from the composition root.
  struct Dependencies {
    /// Makes a robot, not yet connected, from an address (also "demo:"). The error is a sentence.
    std::function<tl::expected<std::unique_ptr<robot::Robot>, QString>(const QString& address,
                                                                       const QByteArray& secret)>
        connect;
    QSettings& settings;           // must outlive the window
    QString initial_address = {};  // connected to at once; empty = none
    session::Session::Options session = {};
    render::TileRenderer::Options renderer = {};
    /// The map.yaml files beside a picture that name it as theirs. Looks at the disk; called on any thread.
    /// Null: pictures are always asked for their place.
    std::function<QStringList(const QString& picture)> yamls_naming = {};
  };

  explicit MainWindow(Dependencies dependencies, QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Leaves the present robot and goes to another; the error is a sentence, then everything stays as it was.
  std::optional<QString> connectTo(const QString& address, const QByteArray& secret = {});
  void leaveRobot();
  /// A map.yaml, a picture (asks how it lies) or a folder. What cannot be opened becomes a toast.
  void openPath(const QString& path);
  /// Shows a map of the catalogue without loading it on the robot.
  void openMap(const map::MapKey& key);

  session::Session* session() const { return session_.get(); }
  scene::MapScene* mapScene() const { return scene_.get(); }
  MapView* view() const { return view_; }
  const Actions& actionList() const { return actions_; }
  InspectorDock* inspector() const { return inspector_; }
  LayersDock* layers() const { return layers_; }
  MapsDock* maps() const { return maps_; }
  RobotDock* robotPanel() const { return robot_panel_; }
  MessagesDock* messages() const { return messages_; }
  CompareControl* comparison() const { return comparison_; }
  PictureDialog* pictureDialog() const;  // null: not open
  ExportDialog* exportDialog() const;    // null: not open
  ConnectDialog* secretDialog() const;   // null: not open
  ProblemsDock* problems() const { return problems_; }
  WindowStatusBar* bar() const { return bar_; }
  MapOverlay* overlay() const { return overlay_; }
  ConnectionChip* chip() const { return chip_; }
  MeasureTool* measureTool() const { return measure_; }

  ThemeChoice theme() const { return theme_; }
  void setTheme(ThemeChoice choice);
  void setColorMode(render::ColorMode mode);
  void setMapMode(ViewMode mode);

  /// The map as on screen, without buttons and notices.
  QImage mapPicture() const;
  /// The error is a sentence.
  std::optional<QString> saveMapPicture(const QString& path);
  void resetLayout();

  QMenu* createPopupMenu() override;

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  // main_window_actions.cpp
  void createActions();
  void createRobotActions();
  void createMapActions();
  void createViewActions();
  void createHelpActions();
  void createMenus();
  void createToolBar();
  void fillRobotMenu(QMenu* menu);
  void addRecents(QMenu* menu, bool files, const QString& title);
  std::vector<QDockWidget*> docks() const;
  // main_window_layout.cpp
  void createDocks();
  void arrangeDocks();
  void placeDocks();
  void restoreSettings();
  void saveSettings();
  void noteSettings();
  void syncLayerActions();
  // main_window_map.cpp
  void wireMap();
  void showMapMenu(const QPoint& global_pos, const QPointF& viewport_px);
  void goTo();
  void fit();
  void locate(map::SubmapId id);
  void setMeasuring(bool on);
  void copyText(const QString& text, const QString& what);
  void copyCoordinates(const Eigen::Vector2d& world_m);
  void askAndSavePicture();
  void escape();
  void showCursor();
  void fitAtFirst();
  // main_window_maps.cpp
  void createModeActions();
  void createCompareActions();
  void wireMapsOf(session::Session* session);
  void syncModeActions();
  void beginMapMode();
  void endMapMode();
  void fitNewMap();
  void noteMapChange();
  void refreshMapActions();
  void compareFile(const QString& path);
  void compareWithAddress(const QString& address);
  // main_window_files.cpp
  void createFileActions();
  void chooseFile();
  QString lastMapFolder() const;
  /// Finds out where a picture lies, from the map.yaml beside it or by asking, and goes on with its address.
  void placePicture(const QString& path, const QString& accept_text,
                    const std::function<void(const QString& address)>& then);
  void askPlacement(const QString& path, const QStringList& named_by, const QString& accept_text,
                    const std::function<void(const QString& address)>& then);
  void goToAddress(const QString& address);
  void exportMap();
  // main_window_safety.cpp
  void wireSafety();
  void refreshSafety();
  void refreshPlace();
  void changeRobotPlace();
  QString submapsOf() const;
  QString titleOf(const QString& robot) const;
  /// The local files that the map on screen was read from.
  std::vector<std::string> sourceFiles() const;
  // main_window.cpp
  void retry();
  void dismissNotice();
  void wireSession();
  void openConnectDialog();
  void enterSecret();
  void openCertificate();
  void refreshState();
  void refreshChip();
  void refreshNotice();
  void noteRestart();
  void noteProblems();

  Dependencies dependencies_;
  RecentRobots recents_;
  Actions actions_;
  std::unique_ptr<scene::MapScene> scene_;
  std::unique_ptr<session::Session> session_;
  QString address_;

  MapView* view_ = nullptr;
  MeasureTool* measure_ = nullptr;
  class MapTool* pan_ = nullptr;
  MapOverlay* overlay_ = nullptr;
  WindowStatusBar* bar_ = nullptr;
  ConnectionChip* chip_ = nullptr;
  InspectorDock* inspector_ = nullptr;
  LayersDock* layers_ = nullptr;
  ProblemsDock* problems_ = nullptr;
  MapsDock* maps_ = nullptr;
  RobotDock* robot_panel_ = nullptr;
  MessagesDock* messages_ = nullptr;
  CompareControl* comparison_ = nullptr;
  QPointer<PictureDialog> picture_dialog_;
  quint64 pictures_asked_ = 0;  // only the last one that was wanted is gone on with
  QPointer<ExportDialog> export_dialog_;
  QActionGroup* theme_actions_ = nullptr;
  QActionGroup* mode_actions_ = nullptr;
  QActionGroup* color_actions_ = nullptr;

  ThemeChoice theme_ = ThemeChoice::System;
  QTimer cursor_timer_;
  QString last_uuid_;
  /// The problems have opened by themselves, once for good: whether they are open is the user's from then on.
  bool problems_shown_once_ = false;
  /// Which tabs are in front was restored: nothing raises others by itself.
  bool front_tabs_chosen_ = false;
  bool settings_told_ = false;  // that they cannot be kept
  /// The camera is still ours: the first pictures may be fitted.
  bool may_fit_ = true;
  bool fitted_poses_ = false;
  /// The next whole map is one that the user asked for: look at it.
  bool fit_next_map_ = false;
  std::optional<map::MapKey> fitted_map_;
  /// What was on screen before a robot without submaps left no choice.
  std::optional<ViewMode> mode_before_;
  std::optional<map::MapKey> export_when_read_;
  std::unique_ptr<robot::Robot> compare_source_;  // reads a file for a comparison
  QSet<QString> dismissed_;                       // notices that were closed
};

}  // namespace mapwright::window
