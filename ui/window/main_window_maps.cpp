// MainWindow: whole maps, the catalogue, comparing.
#include <QActionGroup>

#include "window/dialogs/export_dialog.h"
#include "window/docks/maps_dock.h"
#include "window/files/map_files.h"
#include "window/look/plain_label.h"
#include "window/main_window.h"
#include "window/map/compare_control.h"
#include "window/map/map_overlay.h"
#include "window/map/map_view.h"
#include "window/map/toast_stack.h"

namespace mapwright::window {

namespace {

QKeySequence key(const char* text) { return QKeySequence(QLatin1String(text)); }

}  // namespace

void MainWindow::createModeActions() {
  mode_actions_ = new QActionGroup(this);
  // Neither is possible too: both layers can be hidden in the list.
  mode_actions_->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  const auto mode = [this](const char* id, const char* text, const char* icon_name, const char* keys,
                           ViewMode which, const char* tip) {
    QAction* action =
        actions_.addToggle(QStringLiteral("View"), QLatin1String(id), QLatin1String(text),
                           QLatin1String(icon_name), {key(keys)}, Reach::OutsideText, QLatin1String(tip));
    action->setData(int(which));
    action->setProperty("tip", action->toolTip());
    mode_actions_->addAction(action);
    connect(action, &QAction::triggered, this, [this, which] { setMapMode(which); });
  };
  mode("modeSubmaps", "&Submaps", "submaps", "1", ViewMode::Submaps, "Show the submaps");
  mode("modeWhole", "&Whole map", "map", "2", ViewMode::Whole, "Show the whole map");
  mode("modeBoth", "&Both", "layers", "3", ViewMode::Both, "Show the whole map below the submaps");
}

void MainWindow::createCompareActions() {
  QAction* compare = actions_.add(QStringLiteral("Map"), QStringLiteral("compare"),
                                  QStringLiteral("Com&pare…"), QStringLiteral("compare"), {key("Ctrl+D")},
                                  Reach::Everywhere, QStringLiteral("Set the open map against another one"));
  connect(compare, &QAction::triggered, this, [this] { comparison_->start(); });
}

void MainWindow::setMapMode(ViewMode mode) {
  setViewMode(*scene_, mode);
  syncModeActions();
}

void MainWindow::syncModeActions() {
  const auto mode = viewMode(*scene_);
  const bool only_whole = session_ && !session_->robot().submapSource();
  for (QAction* action : mode_actions_->actions()) {
    const auto which = ViewMode(action->data().toInt());
    action->setChecked(mode == which);
    const bool possible = !only_whole || which == ViewMode::Whole;
    action->setEnabled(possible);
    action->setToolTip(possible
                           ? action->property("tip").toString()
                           : plainToolTip(QStringLiteral("There are no submaps here, only whole maps.")));
  }
}

void MainWindow::beginMapMode() {
  if (!session_->robot().submapSource()) {
    if (!mode_before_) mode_before_ = viewMode(*scene_).value_or(ViewMode::Submaps);
    setMapMode(ViewMode::Whole);
    if (session_->catalogue().offered() && !front_tabs_chosen_) maps_->raise();
  } else {
    endMapMode();
  }
  syncModeActions();
}

void MainWindow::endMapMode() {
  if (!mode_before_) return;
  const ViewMode before = *mode_before_;
  mode_before_.reset();
  setMapMode(before);
}

void MainWindow::wireMapsOf(session::Session* session) {
  connect(&session->wholeMap(), &session::MapSlot::changed, this, &MainWindow::noteMapChange);
  connect(&session->comparedMap(), &session::MapSlot::changed, this, &MainWindow::refreshState);
  connect(&session->catalogue(), &session::Catalogue::changed, this, &MainWindow::refreshState);
  connect(&session->robot(), &robot::Robot::mapsChanged, this, [this] {
    const session::MapSlot& slot = session_->wholeMap();
    const QString path = pathOfAddress(address_);
    if (path.isEmpty() || slot.phase() == session::MapSlot::Phase::Empty) return;
    overlay_->toasts()->add(
        Mark::Good,
        QStringLiteral("%1 changed on disk and is read again.").arg(mapCalled(slot.name(), slot.key())));
  });
}

void MainWindow::openMap(const map::MapKey& key) {
  if (!session_) return;
  fit_next_map_ = true;
  fitted_map_.reset();
  if (viewMode(*scene_) == ViewMode::Submaps || !viewMode(*scene_)) setMapMode(ViewMode::Whole);
  session_->openMap(key);
  refreshState();
}

void MainWindow::fitNewMap() {
  if (!session_ || !session_->wholeMap().cells()) return;
  const map::MapKey& shown = session_->wholeMap().shown().key;
  if (fitted_map_ == shown || !scene_->layerVisible(scene::Layer::WholeMap)) return;
  if (!fit_next_map_ && (!may_fit_ || scene_->layerVisible(scene::Layer::Submaps))) return;
  if (fit_next_map_ && shown != session_->wholeMap().key()) return;  // still the one of before
  fitted_map_ = shown;
  fit_next_map_ = false;
  view_->fit(scene_->contentBounds(), false, 0.01);
}

void MainWindow::noteMapChange() {
  refreshState();
  const session::MapSlot& slot = session_->wholeMap();
  if (!export_when_read_ || !slot.settled()) return;
  const bool wanted = slot.key() == *export_when_read_ && slot.phase() == session::MapSlot::Phase::Ready;
  export_when_read_.reset();
  if (wanted) exportMap();
}

void MainWindow::refreshMapActions() {
  const bool connected = session_ != nullptr;
  actions_.find(QStringLiteral("compare"))->setEnabled(connected);
  actions_.find(QStringLiteral("export"))->setEnabled(connected);
  const bool turned = connected && session_->wholeMap().shown().display_rotation_rad.has_value();
  QAction* turn = actions_.find(QStringLiteral("robotTurn"));
  turn->setEnabled(turned);
  turn->setToolTip(plainToolTip(turned
                                    ? QStringLiteral("Turn the view as this map's robot shows it to people")
                                    : QStringLiteral("The open map comes without a turn of its own.")));
}

void MainWindow::compareFile(const QString& path) {
  if (isBarePicture(path)) {
    placePicture(path, tr("Compare"), [this](const QString& address) { compareWithAddress(address); });
  } else {
    compareWithAddress(fileAddress(path));
  }
}

void MainWindow::compareWithAddress(const QString& address) {
  if (!session_) return;
  auto reader = dependencies_.connect(address, {});
  robot::WholeMapSource* source = reader && *reader ? (*reader)->wholeMapSource() : nullptr;
  if (!source) {
    overlay_->toasts()->add(Mark::Bad, reader ? QStringLiteral("This is no map file.") : reader.error());
    return;
  }
  compare_source_ = std::move(*reader);
  compare_source_->connectToRobot();
  source->fetch({map::MapKind::File, {}}, [this](robot::Answer<map::WholeMap> answer) {
    if (answer) {
      comparison_->startWith(std::move(*answer));
    } else {
      overlay_->toasts()->add(Mark::Bad, QString::fromStdString(answer.error().sentence));
    }
  });
}

}  // namespace mapwright::window
