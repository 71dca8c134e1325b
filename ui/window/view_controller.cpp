#include "ui/window/view_controller.h"

#include <QMenu>

#include "map/live_state.h"
#include "render/tile_renderer.h"
#include "robot/slam_file.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/viewpoint.h"
#include "ui/shell/window_status_bar.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/measure_tool.h"
#include "ui/view/on_screen.h"
#include "ui/view/toast_stack.h"
#include "ui/view/tool_choice.h"
#include "ui/window/go_to_dialog.h"
#include "ui/window/panes.h"

namespace mapwright::ui {

namespace {

constexpr int kCursorMs = 40;  // the map under a resting cursor changes: updated this often
constexpr double kRoomAroundPosesM = 8;
constexpr double kRoomAroundScansM = 2;
const QString kToolKey = QStringLiteral("view/tool");

}  // namespace

ViewController::ViewController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context), measure_(new MeasureTool(&context.scene, this)) {
  addRobotActions();
  addOtherActions();
  addToMapMenu();
  wireCursor();
  connect(&context_.current, &CurrentSession::stateChanged, this, &ViewController::refresh);
  connect(&context_.view, &MapView::followingChanged, follow_, &QAction::setChecked);
  addTools();
}

void ViewController::addTools() {
  auto* const pan = static_cast<PanTool*>(context_.view.tool());  // with which a view begins
  context_.tools.add(pan, context_.actions.add({.id = "pan",
                                                .text = tr("&Pan"),
                                                .name = tr("Tool: Pan"),
                                                .icon = "pan",
                                                .keys = {"P"},
                                                .reach = Reach::OutsideText,
                                                .tip = tr("Drag the map"),
                                                .toggle = true,
                                                .menu = {MenuGroup::Tools, 10},
                                                .bar = {BarGroup::Tools, 10}}));
  context_.tools.add(measure_, context_.actions.add({.id = "measure",
                                                     .text = tr("&Measure"),
                                                     .name = tr("Tool: Measure"),
                                                     .icon = "measure",
                                                     .keys = {"M"},
                                                     .reach = Reach::OutsideText,
                                                     .tip = tr("Measure distances between clicked points"),
                                                     .toggle = true,
                                                     .needs_session = true,
                                                     .menu = {MenuGroup::Tools, 20},
                                                     .bar = {BarGroup::Tools, 20}}));
  context_.actions.addToMapMenu({MapMenuGroup::Point, 20}, [this](QMenu& menu, const Eigen::Vector2d& world) {
    menu.addAction(themedIcon(QStringLiteral("measure")), tr("Measure from here"), this, [this, world] {
      context_.tools.choose(measure_);
      measure_->clicked({world, {}, {}});
    });
  });
  connect(pan, &PanTool::clickedAt, this, [this](const MapPoint& at) {
    Q_EMIT clicked(at.world_m);
    Q_EMIT picked(at);
  });
}

void ViewController::addRobotActions() {
  follow_ = context_.actions.add({.id = "follow",
                                  .text = tr("Follow the &robot"),
                                  .icon = "follow",
                                  .keys = {"R"},
                                  .reach = Reach::OutsideText,
                                  .tip = tr("Keep the robot in the centre; panning stops it"),
                                  .toggle = true,
                                  .needs_of_robot = robot::Capability::Live,
                                  .menu = {MenuGroup::Look, 10},
                                  .bar = {BarGroup::Look, 30}},
                                 this, &ViewController::follow);
  context_.actions.add({.id = "goTo",
                        .text = tr("&Go to coordinates…"),
                        .icon = "goto",
                        .keys = {"Ctrl+G"},
                        .tip = tr("Centre the map on given coordinates"),
                        .needs_session = true,
                        .menu = {MenuGroup::Look, 20},
                        .bar = {BarGroup::Places, 10}},
                       this, &ViewController::goTo);
  robot_turn_ = context_.actions.add(
      {.id = "robotTurn",
       .text = tr("Rotate as on the robot's d&isplay"),
       .icon = "north",
       .reach = Reach::OutsideText,
       .tip = tr("Rotate the view as on the robot's own display"),
       .menu = {MenuGroup::Turn, 20}},
      this, [this] {
        const session::Session* const session = context_.current.session();
        if (const auto rad = session ? session->wholeMap().shown().display_rotation_rad : std::nullopt)
          context_.view.setRotation(*rad);
      });
}

void ViewController::addOtherActions() {
  context_.actions.add(
      {.id = "copyCoordinates",
       .text = tr("Copy &coordinates"),
       .icon = "copy",
       .keys = {"C"},
       .reach = Reach::OutsideText,
       .tip = tr("Copy the world coordinates under the cursor"),
       .needs_session = true,
       .menu = {MenuGroup::Copies, 10}},
      this,
      [this] { copyCoordinates(context_.view.cursorWorld().value_or(context_.scene.view().center_m)); });
  furniture_ = context_.actions.add({.id = "furniture",
                                     .text = tr("&Buttons on the map"),
                                     .name = tr("Show the buttons on the map"),
                                     .icon = "furniture",
                                     .keys = {"H"},
                                     .reach = Reach::OutsideText,
                                     .tip = tr("Show the buttons on top of the map"),
                                     .toggle = true,
                                     .menu = {MenuGroup::Drawn, 40}});
  furniture_->setChecked(true);
  connect(furniture_, &QAction::toggled, this, [this](bool on) { context_.overlay.setFurnitureVisible(on); });
  context_.actions.add({.id = "focusMap",
                        .text = tr("Focus the &map"),
                        .keys = {"Ctrl+F6"},
                        .tip = tr("Move the keyboard focus to the map"),
                        .menu = {MenuGroup::Window, 20}},
                       this, [this] { context_.view.setFocus(Qt::ShortcutFocusReason); });
  context_.actions.add({.id = "nextPane",
                        .text = tr("Focus the ne&xt part of the window"),
                        .keys = {"F6"},
                        .tip = tr("Move the keyboard focus on: map, strips, panels, status bar, tool bar"),
                        .menu = {MenuGroup::Window, 24}},
                       this, [this] { goToPane(context_, 1); });
  context_.actions.add({.id = "previousPane",
                        .text = tr("Focus the pre&vious part of the window"),
                        .keys = {"Shift+F6"},
                        .tip = tr("Move the keyboard focus back: tool bar, status bar, panels, strips, map"),
                        .menu = {MenuGroup::Window, 26}},
                       this, [this] { goToPane(context_, -1); });
}

void ViewController::addToMapMenu() {
  context_.actions.addToMapMenu({MapMenuGroup::Point, 10}, [this](QMenu& menu, const Eigen::Vector2d& world) {
    QAction* const where = menu.addAction(coordinatesText(world, context_.scene.view().scale_m_per_px));
    where->setEnabled(false);
    menu.addAction(themedIcon(QStringLiteral("copy")), tr("Copy coordinates"), this,
                   [this, world] { copyCoordinates(world); });
    menu.addAction(themedIcon(QStringLiteral("locate")), tr("Centre here"), this,
                   [this, world] { context_.view.lookAt(world); });
  });
}

void ViewController::wireCursor() {
  cursor_timer_.setSingleShot(true);
  cursor_timer_.setInterval(kCursorMs);
  connect(&cursor_timer_, &QTimer::timeout, this, &ViewController::showCursor);
  connect(&context_.view, &MapView::cursorMoved, this, &ViewController::showCursor);
  connect(&context_.scene.renderer(), &render::TileRenderer::tilesChanged, &cursor_timer_, [this] {
    if (!cursor_timer_.isActive()) cursor_timer_.start();
  });
  const auto camera_moved = [this] {
    context_.bar.showView(context_.scene.view());
    context_.overlay.furniture()->setRotation(context_.scene.view().rotation_rad);
  };
  connect(&context_.scene, &scene::MapScene::viewChanged, this, camera_moved);
  camera_moved();
}

void ViewController::setSession(session::Session* session) {
  if (!session) return context_.view.setFollowing(false);
  context_.viewpoint.forget();
  fitted_poses_ = fitted_scans_ = false;
  connect(session, &session::Session::listChanged, this, &ViewController::fitAtFirst);
  connect(session, &session::Session::rowsChanged, this, &ViewController::fitAtFirst);
  connect(session, &session::Session::liveHeard, this, [this](int what) {
    if (what == map::topicIndex<map::PointCloudMessage>()) fitScansAtFirst();
  });
}

void ViewController::recall(const QSettings& settings) {
  furniture_->setChecked(settings.value(QStringLiteral("view/furniture"), true).toBool());
  context_.tools.choose(settings.value(kToolKey).toString());
}

void ViewController::remember(QSettings& settings) {
  settings.setValue(QStringLiteral("view/furniture"), context_.overlay.furnitureVisible());
  settings.setValue(kToolKey, context_.tools.chosen()->name());
}

void ViewController::reset() {
  furniture_->setChecked(true);
  context_.tools.putAway();
}

bool ViewController::escape() {
  if (!context_.scene.marker()) return false;
  context_.scene.setMarker(std::nullopt);
  return true;
}

void ViewController::follow(bool on) {
  session::Session* const session = context_.current.session();
  const bool nobody = on && session && !robot::slamFileOf(session->robot()).isEmpty();
  context_.view.setFollowing(on && !nobody);
  if (nobody) {
    follow_->setChecked(false);
    context_.overlay.toasts()->add(Mark::Neutral, tr("This is a file: there is no robot to follow."));
  } else if (on && context_.scene.robotPlace().drawn == scene::ScreenPart::None) {
    context_.overlay.toasts()->add(
        Mark::Warning, tr("The robot is not in this map. The view will follow it again in its own map."));
  } else if (on && session && !session->live().robot_pose) {
    context_.overlay.toasts()->add(
        Mark::Neutral,
        tr("The robot has not reported its pose yet. The view will follow it as soon as it does."));
  }
}

void ViewController::goTo() {
  GoToDialog dialog(context_.view.destination().center_m, &context_.window);
  if (dialog.exec() != QDialog::Accepted || !dialog.point()) return;
  context_.view.lookAt(*dialog.point());
  context_.scene.setMarker(*dialog.point());
}

void ViewController::showCursor() {
  const auto world = context_.view.cursorWorld();
  if (!world) return context_.bar.showCursor({}, {});
  context_.bar.showCursor(
      coordinatesText(*world, context_.scene.view().scale_m_per_px),
      context_.current.session() ? occupancyText(context_.scene.occupancyAt(*world)) : QString());
}

void ViewController::fitAtFirst() {
  const session::Session* const session = context_.current.session();
  if (!session || context_.viewpoint.chosen() || !context_.scene.layerVisible(scene::Layer::Submaps)) return;
  const session::SubmapCounts counts = session->counts();
  const geometry::WorldRect bounds = session->contentBounds();
  if (counts.listed == 0 || bounds.empty()) return;
  if (!fitted_poses_) {
    // Only the poses are known yet: leave room around them.
    fitted_poses_ = true;
    context_.viewpoint.fit(counts.shown > 0 ? bounds : bounds.grown(kRoomAroundPosesM));
  }
  if (counts.pending == 0 && counts.shown > 0) {
    context_.viewpoint.choose();
    context_.viewpoint.fit(bounds);
  }
}

/// For a robot with only sensor data: a map that arrives later is shown as if there had been nothing.
void ViewController::fitScansAtFirst() {
  const session::Session* const session = context_.current.session();
  if (!session || fitted_scans_ || context_.viewpoint.chosen() || !scansInView(context_.scene)) return;
  const bool map = session->wholeMap().cells() || session->counts().listed > 0;
  const geometry::WorldRect bounds = map ? geometry::WorldRect() : context_.scene.contentBounds();
  if (bounds.empty()) return;
  fitted_scans_ = true;
  context_.viewpoint.fit(bounds.grown(kRoomAroundScansM));
}

void ViewController::refresh() {
  const session::Session* const session = context_.current.session();
  const bool turned = session && session->wholeMap().shown().display_rotation_rad.has_value();
  robot_turn_->setEnabled(turned);
  robot_turn_->setToolTip(plainToolTip(turned ? tr("Rotate the view as on the robot's own display")
                                              : tr("The open map has no rotation of its own.")));
}

void ViewController::copyCoordinates(const Eigen::Vector2d& world_m) {
  const QString text = coordinatesForClipboard(world_m);
  copyText(context_.overlay, text, tr("Copied %1").arg(text));
}

}  // namespace mapwright::ui

#include "moc_view_controller.cpp"
