#include "window/main_window.h"

#include <algorithm>

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QFileDialog>
#include <QToolButton>
#include <QTreeView>

#include "window/dialogs/certificate_dialog.h"
#include "window/dialogs/connect_dialog.h"
#include "window/dialogs/trusted_certificates.h"
#include "window/docks/inspector_dock.h"
#include "window/docks/layers_dock.h"
#include "window/docks/maps_dock.h"
#include "window/docks/messages_dock.h"
#include "window/docks/problems_dock.h"
#include "window/docks/robot_dock.h"
#include "window/files/map_files.h"
#include "window/look/icons.h"
#include "window/map/compare_control.h"
#include "window/map/empty_state.h"
#include "window/map/map_furniture.h"
#include "window/map/map_overlay.h"
#include "window/map/map_view.h"
#include "window/map/measure_tool.h"
#include "window/map/notice_bar.h"
#include "window/map/toast_stack.h"
#include "window/status/connection_chip.h"
#include "window/status/window_status_bar.h"
#include "words/qt_plain.h"

namespace mapwright::window {

using robot::ConnectionPhase;

MainWindow::MainWindow(Dependencies dependencies, QWidget* parent)
    : QMainWindow(parent),
      dependencies_(std::move(dependencies)),
      recents_(dependencies_.settings),
      scene_(std::make_unique<scene::MapScene>(dependencies_.renderer)) {
  loadResources();
  setWindowTitle(QStringLiteral("mapwright"));
  setWindowIcon(QIcon(QStringLiteral(":/mapwright.svg")));
  setObjectName(QStringLiteral("mainWindow"));
  // The theme goes first: what is made after it takes its sizes from its style.
  theme_ = themeFromName(dependencies_.settings.value(QStringLiteral("view/theme")).toString());
  const bool dark = applyTheme(*qApp, theme_);
  scene_->setTheme(dark ? scene::darkMapTheme() : scene::lightMapTheme());

  view_ = new MapView(scene_.get(), this);
  pan_ = view_->tool();
  measure_ = new MeasureTool(scene_.get(), this);
  setCentralWidget(view_);
  // What is dropped on the map is dropped on the window.
  setAcceptDrops(true);
  view_->setAcceptDrops(false);
  view_->viewport()->setAcceptDrops(false);
  bar_ = new WindowStatusBar(this);
  setStatusBar(bar_);
  createActions();
  overlay_ = new MapOverlay(
      view_, new MapFurniture(actions_.find(QStringLiteral("zoomIn")),
                              actions_.find(QStringLiteral("zoomOut")), actions_.find(QStringLiteral("fit")),
                              actions_.find(QStringLiteral("northUp")), view_));
  comparison_ = new CompareControl(scene_.get(), view_, overlay_->compareBar(), this);
  connect(comparison_, &CompareControl::fileWanted, this, [this] {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Compare with a map file"), lastMapFolder(), mapFileFilter());
    if (!path.isEmpty()) compareFile(path);
  });
  createDocks();
  createMenus();
  createToolBar();
  actions_.attach(this, view_);
  wireMap();
  connect(bar_, &WindowStatusBar::problemsWanted, this, [this] {
    problems_->show();
    problems_->raise();
  });
  connect(overlay_->card(), &EmptyStateCard::connectWanted, this, &MainWindow::openConnectDialog);
  connect(overlay_->card(), &EmptyStateCard::secretWanted, this, &MainWindow::enterSecret);
  connect(overlay_->card(), &EmptyStateCard::demoWanted, actions_.find(QStringLiteral("demo")),
          &QAction::trigger);
  connect(overlay_->card(), &EmptyStateCard::retryWanted, actions_.find(QStringLiteral("retry")),
          &QAction::trigger);
  connect(overlay_->card(), &EmptyStateCard::certificateWanted, this, &MainWindow::openCertificate);
  connect(overlay_->card(), &EmptyStateCard::cancelWanted, this, &MainWindow::leaveRobot);
  connect(overlay_->card(), &EmptyStateCard::fileWanted, actions_.find(QStringLiteral("openFile")),
          &QAction::trigger);
  connect(overlay_->notice(), &NoticeBar::offerTaken, this, [this] {
    if (session_ && wantsSecret(session_->connection())) return enterSecret();
    if (session_ && session_->connection().certificate) {
      openCertificate();
    } else if (session_) {
      retry();
    } else {
      openConnectDialog();
    }
  });
  connect(overlay_->notice(), &NoticeBar::closed, this, &MainWindow::dismissNotice);
  wireSafety();

  restoreSettings();
  refreshState();
  view_->setFocus();
  if (!dependencies_.initial_address.isEmpty()) {
    if (const auto error = connectTo(dependencies_.initial_address)) {
      overlay_->notice()->setNotice(Mark::Bad,
                                    QStringLiteral("%1: %2").arg(dependencies_.initial_address, *error),
                                    QStringLiteral("Connect…"));
    }
  }
}

MainWindow::~MainWindow() {
  // The scene and the docks hold on to the session, the view to the scene: take apart from the outside in.
  leaveRobot();
  delete view_;
  view_ = nullptr;
}

std::optional<QString> MainWindow::connectTo(const QString& address, const QByteArray& secret) {
  auto robot = dependencies_.connect(address, secret);
  if (!robot) return robot.error();
  if (!*robot) return QStringLiteral("This address gives no robot.");
  leaveRobot();
  session::Session::Options options = dependencies_.session;
  options.log_safety = true;
  session_ = std::make_unique<session::Session>(std::move(*robot), options);
  address_ = session_->robot().address();
  may_fit_ = true;
  fitted_poses_ = false;
  fit_next_map_ = false;
  fitted_map_.reset();
  recents_.add(address, QDateTime::currentDateTime());
  noteSettings();
  wireSession();
  session_->open();
  refreshState();
  view_->setFocus();
  return std::nullopt;
}

void MainWindow::leaveRobot() {
  if (!session_) return;
  view_->setFollowing(false);
  compare_source_.reset();
  export_when_read_.reset();
  session_->disconnect(this);
  comparison_->setSession(nullptr);
  layers_->setSession(nullptr);
  maps_->setSession(nullptr);
  robot_panel_->setSession(nullptr);
  messages_->setSession(nullptr);
  scene_->setStale(false);
  inspector_->setSession(nullptr);
  problems_->setSession(nullptr);
  bar_->setSession(nullptr);
  scene_->setSession(nullptr);
  session_->close();
  session_.reset();
  address_.clear();
  last_uuid_.clear();
  endMapMode();
  syncModeActions();
  refreshState();
}

void MainWindow::wireSession() {
  session::Session* session = session_.get();
  connect(session, &session::Session::connectionChanged, this, &MainWindow::refreshState);
  connect(session, &session::Session::identityChanged, this, [this] {
    refreshChip();
    const robot::RobotIdentity identity = session_->robot().identity();
    const QString name = identity.name.isEmpty() ? identity.serial : identity.name;
    if (!name.isEmpty()) recents_.setName(session_->robot().address(), name);
  });
  connect(session, &session::Session::listChanged, this, [this] {
    refreshState();
    fitAtFirst();
  });
  connect(session, &session::Session::rowsChanged, this, [this] {
    refreshState();
    fitAtFirst();
  });
  connect(session, &session::Session::sessionRestarted, this, &MainWindow::noteRestart);
  connect(session, &session::Session::problemsChanged, this, &MainWindow::noteProblems);
  connect(session, &session::Session::liveChanged, this, [this](int what) {
    if (what == map::topicIndex<map::MapInfo>()) refreshState();
  });
  connect(&session->safety(), &session::SafetyWatch::changed, this, &MainWindow::refreshSafety);
  wireMapsOf(session);
  scene_->setSession(session);
  inspector_->setSession(session);
  problems_->setSession(session);
  bar_->setSession(session);
  layers_->setSession(session);
  maps_->setSession(session);
  robot_panel_->setSession(session);
  messages_->setSession(session);
  comparison_->setSession(session);
  beginMapMode();
}

void MainWindow::retry() {
  if (!session_) return;
  const session::MapSlot& slot = session_->wholeMap();
  const bool map_failed = slot.phase() == session::MapSlot::Phase::Failed || slot.broken();
  session_->retryNow();
  if (map_failed) session_->openMap(slot.key());
}

void MainWindow::openConnectDialog() {
  ConnectDialog dialog(
      recents_,
      [this](const QString& address, const QByteArray& secret) { return connectTo(address, secret); }, this);
  if (!address_.isEmpty() && !address_.startsWith(QLatin1String("demo"))) dialog.setAddress(address_);
  dialog.exec();
}

void MainWindow::enterSecret() {
  if (!session_ || secretDialog()) return;
  auto* dialog = new ConnectDialog(
      recents_,
      [this](const QString& address, const QByteArray& secret) { return connectTo(address, secret); }, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
  dialog->askForSecret(address_, session_->connection().reason);  // once it is shown, so that the focus stays
}

ConnectDialog* MainWindow::secretDialog() const { return findChild<ConnectDialog*>(); }

void MainWindow::openCertificate() {
  const auto certificate = session_ ? session_->connection().certificate : std::nullopt;
  if (!certificate || findChild<CertificateDialog*>()) return;
  auto* dialog = new CertificateDialog(*certificate, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, decided = *certificate] {
    // The robot may have been left meanwhile, or shows yet another one.
    if (!session_ || session_->connection().certificate != decided) return;
    TrustedCertificates(dependencies_.settings).trust(decided.host, decided.sha256);
    session_->robot().trustCertificate(decided.sha256);
  });
  dialog->open();
}

void MainWindow::refreshState() {
  const bool connected = session_ != nullptr;
  for (const char* id : {"retry", "disconnect", "follow"}) {
    actions_.find(QLatin1String(id))->setEnabled(connected);
  }
  refreshMapActions();
  MapsInView in_view{scene_->layerVisible(scene::Layer::Submaps),
                     scene_->layerVisible(scene::Layer::WholeMap)};
  if (comparison_->active()) in_view.whole = true;
  overlay_->card()->setState(emptyState(session_.get(), in_view));
  const bool submaps_left_out = scene_->robotPlace().drawn == scene::ScreenPart::None;
  bar_->setInView(in_view.submaps && !submaps_left_out, in_view.whole, submapsOf());
  scene_->setStale(session_ && session_->staleSince().has_value());
  refreshChip();
  refreshSafety();
  refreshPlace();
  refreshNotice();
}

void MainWindow::refreshChip() {
  if (!session_) {
    chip_->setRobot(QStringLiteral("No robot"), Mark::Neutral, {}, QStringLiteral("Connect to a robot"));
    setWindowTitle(QStringLiteral("mapwright"));
    return;
  }
  const robot::RobotIdentity identity = session_->robot().identity();
  const robot::ConnectionState connection = session_->connection();
  const QString address = session_->robot().address();
  QString name = identity.name.isEmpty() ? identity.serial : identity.name;
  if (name.trimmed().isEmpty()) name = address;
  name = words::plainName(name);
  QStringList detail{address};
  if (!identity.model.isEmpty()) detail << QStringLiteral("Model %1").arg(identity.model);
  if (!identity.serial.isEmpty()) detail << QStringLiteral("Serial number %1").arg(identity.serial);
  if (!identity.version.isEmpty()) detail << QStringLiteral("Version %1").arg(identity.version);
  const StateText state = connectionText(connection);
  detail << state.text;
  chip_->setRobot(name, state.mark, connectionWord(connection.phase), detail.join(QLatin1Char('\n')));
  setWindowTitle(titleOf(name));
}

void MainWindow::refreshNotice() {
  NoticeBar* const notice = overlay_->notice();
  const auto quiet = [&] { notice->setNotice(Mark::None, {}, {}); };
  if (!session_) return quiet();
  const session::MapSlot& slot = session_->wholeMap();
  const auto since = session_->staleSince();
  if (since && (session_->counts().shown > 0 || slot.cells())) {
    const bool refused = session_->connection().phase == ConnectionPhase::Refused;
    QString sentence = lostConnectionSentence(*since, QDateTime::currentDateTime());
    if (refused && !session_->connection().reason.isEmpty())
      sentence += QLatin1Char(' ') + session_->connection().reason;
    notice->setNotice(refused ? Mark::Bad : Mark::Warning, sentence,
                      wantsSecret(session_->connection())  ? tr("Enter secret…")
                      : session_->connection().certificate ? tr("Certificate…")
                                                           : tr("Retry now"));
    return;
  }
  const bool whole_wanted = scene_->layerVisible(scene::Layer::WholeMap) || comparison_->active();
  const QString name = mapCalled(slot.name(), slot.key());
  if (whole_wanted && slot.phase() == session::MapSlot::Phase::Failed && overlay_->card()->isHidden()) {
    notice->setNotice(Mark::Bad, QStringLiteral("%1: %2").arg(name, slot.remark()), QStringLiteral("Retry"));
    return;
  }
  const QString remark = QStringLiteral("%1: %2").arg(name, slot.remark());
  if (whole_wanted && slot.phase() == session::MapSlot::Phase::Ready && !slot.remark().isEmpty() &&
      !dismissed_.contains(remark)) {
    notice->setNotice(Mark::Warning, remark, slot.broken() ? QStringLiteral("Retry") : QString(), true);
    return;
  }
  const QString limits = session_->robot().limits();
  if (!limits.isEmpty() && !dismissed_.contains(limits)) {
    notice->setNotice(Mark::Neutral, limits, {}, true);
    return;
  }
  quiet();
}

void MainWindow::dismissNotice() {
  dismissed_.insert(overlay_->notice()->sentence());
  refreshNotice();
}

void MainWindow::noteRestart() {
  const QString uuid = QString::fromStdString(session_->book().uuid());
  if (uuid == last_uuid_) return;
  if (!last_uuid_.isEmpty() && !uuid.isEmpty()) {
    overlay_->toasts()->add(
        Mark::Warning, QStringLiteral("The robot started a new SLAM session. The map of before is gone."));
  }
  last_uuid_ = uuid;
}

void MainWindow::noteProblems() {
  // Once, so that nobody overlooks the first error; after that the count in the status bar is enough.
  if (problems_shown_once_) return;
  // What is wrong with the robot itself has its notice.
  const auto ofRobot = [&](const session::LoggedProblem& row) {
    const auto& safety = session_->safety().conditions();
    return std::any_of(safety.begin(), safety.end(), [&](const map::SafetyCondition& condition) {
      return map::problemOf(condition).subject == row.problem.subject;
    });
  };
  const auto& rows = session_->problems().rows();
  if (std::none_of(rows.begin(), rows.end(), [&](const session::LoggedProblem& row) {
        return !row.resolved && row.problem.severity == map::Severity::Error && !ofRobot(row);
      })) {
    return;
  }
  problems_shown_once_ = true;
  problems_->show();
  problems_->raise();
}

void MainWindow::setTheme(ThemeChoice choice) {
  theme_ = choice;
  const bool dark = applyTheme(*qApp, choice);
  scene_->setTheme(dark ? scene::darkMapTheme() : scene::lightMapTheme());
  for (QAction* action : theme_actions_->actions()) {
    if (action->data().toInt() == int(choice)) action->setChecked(true);
  }
  dependencies_.settings.setValue(QStringLiteral("view/theme"), themeName(choice));
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  // The desktop may take it in and out of the full screen too.
  if (event->type() != QEvent::WindowStateChange) return;
  if (QAction* action = actions_.find(QStringLiteral("fullScreen"))) action->setChecked(isFullScreen());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  saveSettings();
  QMainWindow::closeEvent(event);
}

}  // namespace mapwright::window
