#include "ui/window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>

#include "session/session.h"
#include "ui/clouds/clouds_controller.h"
#include "ui/clouds/projections_controller.h"
#include "ui/clouds/section_dock.h"
#include "ui/kit/actions.h"
#include "ui/kit/icons.h"
#include "ui/kit/panels.h"
#include "ui/layers/layers_controller.h"
#include "ui/maps/administration_controller.h"
#include "ui/maps/compare_controller.h"
#include "ui/maps/expected_controller.h"
#include "ui/maps/export_controller.h"
#include "ui/maps/files_controller.h"
#include "ui/maps/maps_controller.h"
#include "ui/maps/maps_dock.h"
#include "ui/maps/pose_controller.h"
#include "ui/maps/reference_controller.h"
#include "ui/maps/reference_dock.h"
#include "ui/maps/transfer_controller.h"
#include "ui/objects/objects_controller.h"
#include "ui/overlays/overlay_carrying.h"
#include "ui/overlays/overlays_controller.h"
#include "ui/picture/picture_controller.h"
#include "ui/plots/messages_controller.h"
#include "ui/plots/messages_dock.h"
#include "ui/plots/plots_controller.h"
#include "ui/regions/regions_controller.h"
#include "ui/replay/recording_controller.h"
#include "ui/replay/recordings_controller.h"
#include "ui/replay/recordings_dock.h"
#include "ui/replay/rehearsal_controller.h"
#include "ui/replay/replay_controller.h"
#include "ui/robot/connection_controller.h"
#include "ui/robot/problems_controller.h"
#include "ui/robot/robot_controller.h"
#include "ui/robot/status_controller.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/focus_return.h"
#include "ui/shell/notices.h"
#include "ui/shell/unsaved_changes.h"
#include "ui/shell/viewpoint.h"
#include "ui/shell/window_status_bar.h"
#include "ui/slam/closures_controller.h"
#include "ui/slam/closures_dock.h"
#include "ui/slam/disagreement_controller.h"
#include "ui/slam/inspector_controller.h"
#include "ui/slam/inspector_dock.h"
#include "ui/slam/leave_out_controller.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/tool_choice.h"
#include "ui/waypoints/edit_controller.h"
#include "ui/waypoints/waypoint_carrying.h"
#include "ui/waypoints/waypoints_controller.h"
#include "ui/window/appearance_controller.h"
#include "ui/window/help_controller.h"
#include "ui/window/language_controller.h"
#include "ui/window/layout_controller.h"
#include "ui/window/tool_bar.h"
#include "ui/window/view_controller.h"

namespace mapwright::ui {

namespace {

constexpr int kFramePx = 8, kTitleBarPx = 40;
constexpr int kNoteAfterMs = 1'000;
const QString kGeometryKey = QStringLiteral("window/geometry");

template <typename Options>
Options with(const std::shared_ptr<work::Workers>& workers, Options options) {
  options.workers = workers;
  return options;
}
template <typename Options>
Options with(const std::shared_ptr<work::Workers>& workers, const work::Budgets& budgets, Options options) {
  options.budgets = budgets;
  return with(workers, std::move(options));
}

}  // namespace

MainWindow::MainWindow(Dependencies dependencies, QWidget* parent)
    : QMainWindow(parent),
      settings_(dependencies.settings),
      workers_(work::orOwn(dependencies.workers)),
      cloud_store_(std::make_shared<clouds::CloudStore>(workers_)),
      scene_(std::make_unique<scene::MapScene>(with(workers_, dependencies.budgets, dependencies.renderer),
                                               cloud_store_)) {
  loadResources();
  setWindowTitle(QStringLiteral("mapwright"));
  setWindowIcon(QIcon(QStringLiteral(":/mapwright.svg")));
  setObjectName(QStringLiteral("mainWindow"));
  prepareChosenTheme(settings_);

  view_ = new MapView(scene_.get(), this);
  setCentralWidget(view_);
  new FocusReturn(*this, *view_, this);
  bar_ = new WindowStatusBar(this);
  setStatusBar(bar_);
  addCameraActions(actions_, *view_);
  overlay_ = new MapOverlay(view_, new MapFurniture(actions_, view_));
  current_ = new CurrentSession(*scene_, with(workers_, dependencies.budgets, dependencies.session),
                                dependencies.addresses, this);
  edit_ = with(workers_, dependencies.edit);
  context_.emplace(WindowContext{.window = *this,
                                 .view = *view_,
                                 .scene = *scene_,
                                 .actions = actions_,
                                 .findings = findings_,
                                 .tools = *new ToolChoice(view_, overlay_, this),
                                 .overlay = *overlay_,
                                 .panels = *new Panels(*this, actions_),
                                 .notices = *new Notices(overlay_->notice(), this),
                                 .viewpoint = *new Viewpoint(*view_, this),
                                 .bar = *bar_,
                                 .current = *current_,
                                 .settings = settings_,
                                 .hits = hits_,
                                 .undo = undo_,
                                 .unsaved = *new UnsavedChanges(this),
                                 .edit = edit_,
                                 .addresses = dependencies.addresses,
                                 .budgets = dependencies.budgets,
                                 .workers = workers_});
  createControllers(dependencies);
  connectControllers();
  addOwnActions();
  fillMenuBar(*menuBar(), actions_);
  createToolBar();
  actions_.attach(this, view_);
  connect(view_, &MapView::menuRequested, this, &MainWindow::showMapMenu);
  connect(view_, &MapView::escaped, this, &MainWindow::escape);

  showChosenTheme(*this, settings_, *scene_);
  restoreSettings();
  note_soon_.setSingleShot(true);
  note_soon_.setInterval(kNoteAfterMs);
  connect(&note_soon_, &QTimer::timeout, this, &MainWindow::storeSettings);
  qApp->installEventFilter(this);
  notifyControllers(nullptr);
  Q_EMIT current_->stateChanged();
  view_->setFocus();
  if (!dependencies.initial_address.isEmpty()) connection_->startWith(dependencies.initial_address);
}

MainWindow::~MainWindow() {
  // The scene and the docks refer to the session, the view to the scene: destroy from the outside in.
  leaveRobot();
  context_->tools.putAway();
  for (auto it = controllers_.rbegin(); it != controllers_.rend(); ++it) {
    context_->unsaved.forget(*it);
    delete *it;
  }
  delete view_;
  view_ = nullptr;
}

void MainWindow::createControllers(const Dependencies& dependencies) {
  WindowContext& context = *context_;
  // Their order is the tab order of the docks, and the order in which Esc is offered.
  const auto make = [&]<class What>(What*& controller, auto&&... needs) {
    controller = new What(context, std::forward<decltype(needs)>(needs)..., this);
    controllers_.push_back(controller);
  };
  const auto ids = [this](const char* id) { return actions_.find(QLatin1String(id)); };
  placing_ = new PicturePlacing(this, dependencies.yamls_naming, workers_);
  make(appearance_);
  make(view_control_);
  make(layout_);
  make(compare_, *placing_,
       [connect = dependencies.connect](const QString& address) { return connect(address, {}); });
  make(layers_);
  make(objects_);
  make(closures_);
  make(disagreement_);
  make(inspector_, ids("showIds"), ids("showOutlines"));
  controllers_.push_back(new EditController(context, this));
  make(waypoints_);
  make(picture_);
  make(overlays_, dependencies.overlays_history);
  make(recordings_);
  make(replay_, [this](const QString& address) { return connection_->another(address); });
  make(plots_, replay_->clock());
  make(regions_);
  make(clouds_, *cloud_store_);
  make(projections_);
  make(problems_);
  make(maps_);
  make(administration_);
  make(transfer_);
  make(pose_);
  make(reference_, *placing_,
       [connect = dependencies.connect](const QString& address) { return connect(address, {}); });
  auto* const rehearsal = new RehearsalController(
      context, [connect = dependencies.connect](const QString& address) { return connect(address, {}); },
      this);
  controllers_.push_back(rehearsal);
  connect(reference_, &ReferenceController::laidChanged, rehearsal, &RehearsalController::setLaid);
  connect(recordings_->dock(), &RecordingsDock::rehearseWanted, rehearsal, &RehearsalController::rehearseBag);
  connect(rehearsal, &RehearsalController::recordingsWanted, this,
          [this] { context_->panels.open(recordings_->dock()); });
  make(robot_);
  make(messages_);
  make(files_, *placing_);
  make(export_, dependencies.yamls_naming);
  auto* const leave_out = new LeaveOutController(context, this);
  controllers_.push_back(leave_out);
  connect(inspector_->dock(), &InspectorDock::menuOpening, leave_out, &LeaveOutController::addForSubmaps);
  connect(closures_->dock(), &ClosuresDock::menuOpening, leave_out, &LeaveOutController::addForClosure);
  connect(leave_out, &LeaveOutController::openWanted, files_, &FilesController::open);
  controllers_.push_back(new ExpectedController(context, this));
  make(connection_, ConnectionController::Means{dependencies.connect, dependencies.probes, dependencies.keys,
                                                dependencies.has_secret});
  make(recording_);
  controllers_.push_back(new StatusController(context, this));
  controllers_.push_back(new LanguageController(context, this));
  controllers_.push_back(new HelpController(context, this));
  for (Controller* controller : controllers_) context.unsaved.watch(controller);
  connect(current_, &CurrentSession::changed, this, &MainWindow::notifyControllers);
}

void MainWindow::connectControllers() {
  connect(view_control_, &ViewController::clicked, inspector_, &InspectorController::clickedOnMap);
  connect(inspector_, &InspectorController::located, objects_, &ObjectsController::wentTo);
  connect(objects_, &ObjectsController::chose, closures_, &ClosuresController::chosenOnMap);
  connect(closures_, &ClosuresController::submapShown, inspector_->dock(), &InspectorDock::select);
  connect(closures_->dock(), &ClosuresDock::chosen, disagreement_, &DisagreementController::leavePlace);
  connect(disagreement_, &DisagreementController::wentToPlace, this, [this] {
    closures_->escape();
    objects_->escape();
  });
  connect(view_control_, &ViewController::picked, objects_, &ObjectsController::clickedOnMap);
  connect(view_control_, &ViewController::clicked, replay_, &ReplayController::clickedOnMap);
  connect(recordings_, &RecordingsController::openWanted, replay_, &ReplayController::openBag);
  connect(replay_, &ReplayController::backWanted, connection_, &ConnectionController::goBackTo);
  connect(layout_, &LayoutController::leaving, replay_, &ReplayController::leaveLayout);
  connect(layout_, &LayoutController::shown, replay_, &ReplayController::onLayout);
  connect(current_, &CurrentSession::stateChanged, &actions_, [this] {
    if (session::Session* const session = current_->session()) actions_.updateCapabilities(&session->robot());
  });
  connect(plots_, &PlotsController::rawWanted, messages_->dock(), &MessagesDock::setWantedElsewhere);
  connect(messages_->dock(), &MessagesDock::plotWanted, plots_, &PlotsController::plot);
  connect(inspector_, &InspectorController::colorModeWanted, layers_, &LayersController::setColorMode);
  connect(layers_, &LayersController::colorModeChanged, inspector_, &InspectorController::setColorMode);
  SectionView* const section = clouds_->sectionDock()->view();
  connect(projections_, &ProjectionsController::bandsChanged, section, &SectionView::setBands);
  connect(section, &SectionView::bandMoved, projections_, &ProjectionsController::setHeights);
  connect(picture_, &PictureController::compareWanted, compare_, &CompareController::compareWithSaved);
  connect(picture_, &PictureController::written, maps_, &MapsController::expectOwnChange);
  connect(overlays_, &OverlaysController::fileWritten, maps_, &MapsController::expectOwnChange);
  picture_->setNamed([this] { return connection_->named(); });
  connect(picture_, &PictureController::fileWanted, files_, &FilesController::open);
  connect(transfer_, &TransferController::openWanted, files_, &FilesController::open);
  connect(maps_, &MapsController::compareWanted, compare_, &CompareController::compareWith);
  connect(maps_, &MapsController::alignWanted, reference_, &ReferenceController::alignWithMap);
  connect(maps_, &MapsController::exportWanted, export_, &ExportController::exportMap);
  Carrying* const waypoints = waypoints_->carrying();
  Carrying* const overlays = overlays_->carrying();
  ReferenceDock* const reference = reference_->dock();
  connect(reference_, &ReferenceController::swipeWanted, compare_, &CompareController::startWith);
  connect(reference_, &ReferenceController::laidChanged, waypoints, &Carrying::setLaid);
  connect(reference_, &ReferenceController::laidChanged, overlays, &Carrying::setLaid);
  connect(waypoints, &Carrying::possibleChanged, reference, &ReferenceDock::setWhyNotCarried);
  connect(overlays, &Carrying::possibleChanged, reference, &ReferenceDock::setWhyOverlaysNotCarried);
  connect(reference, &ReferenceDock::carryWanted, waypoints, &Carrying::open);
  connect(reference, &ReferenceDock::carryOverlaysWanted, overlays, &Carrying::open);
  connect(maps_->dock(), &MapsDock::submapsWanted, transfer_, &TransferController::openSubmaps);
  connect(maps_->dock(), &MapsDock::menuOpening, transfer_, &TransferController::fillMenu);
  connect(maps_->dock(), &MapsDock::menuOpening, administration_, &AdministrationController::fillMenu);
  connect(administration_, &AdministrationController::sessionExpected, connection_,
          &ConnectionController::expectSession);
  connect(export_, &ExportController::wholeExported, regions_, &RegionsController::onExported);
  connect(maps_, &MapsController::regionsWanted, regions_, &RegionsController::showRegions);
  connect(maps_, &MapsController::retryWanted, connection_, &ConnectionController::retry);
  connect(problems_, &ProblemsController::retryWanted, connection_, &ConnectionController::retry);
  connect(robot_, &RobotController::safetyChanged, connection_, &ConnectionController::setSafety);
  connect(recording_, &RecordingController::playWanted, files_, &FilesController::open);
  connect(connection_, &ConnectionController::fileWanted, files_, &FilesController::choose);
  connect(files_, &FilesController::addressWanted, connection_, &ConnectionController::goTo);
}

void MainWindow::addOwnActions() {
  actions_.add({.id = "quit",
                .text = tr("&Quit"),
                .name = tr("Quit mapwright"),
                .keys = {"Ctrl+Q"},
                .tip = tr("Quit mapwright"),
                .menu = {MenuGroup::Quit, 10}},
               this, &MainWindow::close);
  actions_.add({.id = "resetLayout",
                .text = tr("&Reset layout"),
                .icon = "reset",
                .tip = tr("Restore the original docks, layers and colours"),
                .menu = {MenuGroup::Window, 40}},
               this, &MainWindow::resetLayout);
}

void MainWindow::createToolBar() {
  auto* const tools = new ToolBar(actions_, this);
  addToolBar(Qt::TopToolBarArea, tools);
  connect(layout_, &LayoutController::shown, tools, &ToolBar::showRole);
}

void MainWindow::notifyControllers(session::Session* session) {
  actions_.setSession(session ? &session->robot() : nullptr);
  for (Controller* controller : controllers_) controller->setSession(session);
}

void MainWindow::restoreSettings() {
  if (!restoreGeometry(settings_.value(kGeometryKey).toByteArray())) {
    const QRect room = QGuiApplication::primaryScreen()->availableGeometry();
    // Room for the window manager's frame.
    resize(qMin(1600, room.width() - kFramePx), qMin(1000, room.height() - kTitleBarPx));
  }
  for (Controller* controller : controllers_) controller->recall(settings_);
}

void MainWindow::saveSettings() {
  settings_.setValue(kGeometryKey, saveGeometry());
  for (Controller* controller : controllers_) controller->remember(settings_);
}

void MainWindow::storeSettings() {
  settings_.setValue(kGeometryKey, saveGeometry());
  for (Controller* controller : controllers_) {
    if (controller == layout_) {
      layout_->save(settings_);
    } else if (controller == layers_) {
      layers_->save(settings_);
    } else {
      controller->remember(settings_);
    }
  }
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  const bool by_user = type == QEvent::MouseButtonRelease || type == QEvent::KeyRelease ||
                       type == QEvent::Wheel ||
                       (watched == this && (type == QEvent::Resize || type == QEvent::Move));
  if (by_user && !note_soon_.isActive() && isVisible()) note_soon_.start();
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::resetLayout() {
  for (Controller* controller : controllers_) controller->reset();
}

void MainWindow::escape() {
  if (disagreement_->endSteps()) return;  // what blinks ends first, whatever else is marked
  for (Controller* controller : controllers_) {
    if (controller->escape()) return;
  }
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  // Not handled by any widget: Esc means the same wherever the focus is.
  if (event->key() != Qt::Key_Escape) return QMainWindow::keyPressEvent(event);
  auto* search = qobject_cast<QLineEdit*>(focusWidget());
  if (search && search->isClearButtonEnabled() && !search->text().isEmpty()) {
    search->clear();
  } else {
    view_->setFollowing(false);
    escape();
  }
  event->accept();
}

void MainWindow::showMapMenu(const QPoint& global_pos, const QPointF& viewport_px) {
  if (!session()) return;  // there is no map
  QMenu menu(this);
  fillMapMenu(menu, actions_, view_->worldAt(viewport_px));
  menu.exec(global_pos);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_close_ && (context_->unsaved.any() || context_->unsaved.losesFetched())) {
    event->ignore();
    context_->unsaved.whenMayLeaveRobot([this] {
      may_close_ = true;
      close();
    });
    return;
  }
  note_soon_.stop();
  saveSettings();
  QMainWindow::closeEvent(event);
}

QMenu* MainWindow::createPopupMenu() {
  // The default menu lists tool bars by internal names.
  auto* menu = new QMenu(this);
  for (QDockWidget* dock : context_->panels.docks()) menu->addAction(dock->toggleViewAction());
  return menu;
}

std::optional<QString> MainWindow::connectTo(const QString& address, const QByteArray& secret) {
  return connection_->connectTo(address, secret);
}

void MainWindow::leaveRobot() { current_->leave(); }
session::Session* MainWindow::session() const { return current_->session(); }

}  // namespace mapwright::ui

#include "moc_main_window.cpp"
