#include "ui/waypoints/waypoint_placing.h"

#include <algorithm>
#include <cmath>

#include <QMenu>

#include "scene/drawing.h"
#include "session/lacks_picture.h"
#include "ui/shell/viewpoint.h"
#include "ui/view/map_view.h"

namespace mapwright::window {
namespace {

const QString kRadiusKey = QStringLiteral("waypoints/robot_radius_m");
using placing::kMostRadiusM;
constexpr double kAroundBareM = 3;  // around waypoints without a picture

}  // namespace

WaypointPlacing::WaypointPlacing(WindowContext& context, WaypointEditing* editing, QObject* parent)
    : QObject(parent),
      context_(context),
      editing_(editing),
      snapping_(new WaypointSnapping(&context.scene, &context.hits, this)),
      warnings_(new WaypointWarnings(editing, context.workers, this)),
      actions_(new PlacingActions(context, editing, snapping_, this)),
      snap_menu_(new QMenu(tr("S&nap to"), &context.window)) {
  addSnapping();
  next_ = context_.actions.add({.id = "nextWarning",
                                .text = tr("Next &warning"),
                                .icon = "problem",
                                .keys = {"F8"},
                                .tip = tr("The next waypoint with a warning"),
                                .menu = {MenuGroup::Waypoints, 19}},
                               this, &WaypointPlacing::showNextWarning);
  connect(warnings_, &WaypointWarnings::changed, this, &WaypointPlacing::refresh);
  connect(snapping_, &WaypointSnapping::changed, this, &WaypointPlacing::refresh);
  connect(editing_, &WaypointEditing::opened, this, &WaypointPlacing::lookAtBareOnes);
  connect(actions_, &PlacingActions::made, this, [this] {
    context_.scene.setLayerVisible(scene::Layer::Waypoints, true);
    Q_EMIT made();
  });
  connect(&context_.scene, &scene::MapScene::contentChanged, this, &WaypointPlacing::syncGround);
  connect(&context_.scene, &scene::MapScene::cellsEdited, this, [this](const geometry::WorldRect& where) {
    syncGround();
    warnings_->cellsChanged(where);
  });
  syncRadius();
  refresh();
}

QAction* WaypointPlacing::addRule(const char* id, const QString& text, const QString& tip,
                                  bool placing::SnapRules::*rule) {
  QAction* const action = context_.actions.addToggle(menuTitle(Menu::Edit).remove(QLatin1Char('&')),
                                                     QLatin1String(id), text, {}, {}, Reach::Everywhere, tip);
  connect(action, &QAction::triggered, this, [this, rule](bool checked) {
    placing::SnapRules rules = snapping_->rules();
    rules.*rule = checked;
    snapping_->setRules(rules);
    // Choosing what to snap to also turns snapping on.
    if (checked) snapping_->setOn(true);
  });
  rules_.push_back({action, rule});
  return action;
}

void WaypointPlacing::addSnapping() {
  using placing::SnapRules;
  snap_ = context_.actions.add({.id = "snap",
                                .text = tr("&Snap"),
                                .keys = {"S"},
                                .reach = Reach::OutsideText,
                                .tip = tr("Placed waypoints snap to what is selected below; Alt suspends it"),
                                .toggle = true,
                                .menu = {MenuGroup::Waypoints, 13}},
                               snapping_, &WaypointSnapping::setOn);
  snap_menu_->addAction(addRule("snapWaypoints", tr("Other &waypoints"),
                                tr("The positions of other waypoints, and lines through them"),
                                &SnapRules::waypoints));
  snap_menu_->addAction(
      addRule("snapGrid", tr("A &grid"), tr("Lines at a regular distance, see Distances"), &SnapRules::grid));
  snap_menu_->addAction(addRule("snapWalls", tr("A distance to wa&lls"),
                                tr("Positions at a given distance from the nearest wall, see Distances"),
                                &SnapRules::walls));
  snap_menu_->addAction(addRule("snapHeadings", tr("&Headings of 15°"),
                                tr("Headings that are multiples of 15°"), &SnapRules::headings));
  snap_menu_->addSeparator();
  QAction* const distances =
      context_.actions.add(menuTitle(Menu::Edit).remove(QLatin1Char('&')), QStringLiteral("snapDistances"),
                           tr("&Distances…"), QStringLiteral("settings"), {}, Reach::Everywhere,
                           tr("Grid spacing, distance to walls, and robot size"));
  connect(distances, &QAction::triggered, this, &WaypointPlacing::askDistances);
  snap_menu_->addAction(distances);
  context_.actions.place({MenuGroup::Waypoints, 13}, snap_menu_->menuAction());
}

void WaypointPlacing::refresh() {
  snap_->setChecked(snapping_->on());
  for (const auto& [action, rule] : rules_) action->setChecked(snapping_->rules().*rule);
  next_->setEnabled(warnings_->count() > 0);
}

void WaypointPlacing::setSession(session::Session* session) {
  if (session_) {
    session_->disconnect(this);
    session_->wholeMap().disconnect(this);
  }
  session_ = session;
  if (session_) {
    connect(&session_->wholeMap(), &session::MapSlot::changed, this, &WaypointPlacing::syncGround);
    connect(session_, &session::Session::liveHeard, this, [this](int what) {
      if (what == map::topicIndex<map::RobotModel>()) syncRadius();
      if (what == map::topicIndex<map::TrackedPose>()) actions_->refreshRobot();
    });
    connect(session_, &session::Session::frameChanged, actions_, &PlacingActions::refresh);
  }
  syncGround();
  syncRadius();
  actions_->refresh();
}

void WaypointPlacing::syncGround() {
  placing::PlacedMap under = mapUnder(context_.scene);
  // A fetched part does not tell where the map ends.
  under.is_part = session_ && session_->wholeMap().shown().state_of;
  warnings_->setMap(under);
}

void WaypointPlacing::lookAtBareOnes() {
  if (!session_ || !session::lacksPicture(session_->wholeMap()) || !editing_->document()) return;
  geometry::WorldRect around;
  for (const auto& [key, point] : editing_->document()->items()) around.extend(point.position_m);
  if (!around.empty()) context_.viewpoint.fit(around.grown(kAroundBareM));
}

void WaypointPlacing::syncRadius() {
  told_radius_m_ = session_ ? placing::radiusOf(session_->live().model) : 0;
  warnings_->setRadius(told_radius_m_ > 0 ? told_radius_m_ : radius_m_);
}

void WaypointPlacing::recall(const QSettings& settings) {
  snapping_->recall(settings);
  const double radius = settings.value(kRadiusKey, kRadiusM).toDouble();
  radius_m_ = std::isfinite(radius) ? std::clamp(radius, 0.0, kMostRadiusM) : kRadiusM;
  syncRadius();
}

void WaypointPlacing::remember(QSettings& settings) const {
  snapping_->remember(settings);
  settings.setValue(kRadiusKey, radius_m_);
}

void WaypointPlacing::askDistances() {
  if (dialog_) return;
  dialog_ = new PlacingDialog({snapping_->rules().grid_m, snapping_->rules().wall_m, radius_m_},
                              told_radius_m_, &context_.window);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog_, &QDialog::accepted, this, [this] {
    const PlacingNumbers numbers = dialog_->numbers();
    placing::SnapRules rules = snapping_->rules();
    rules.grid_m = numbers.grid_m;
    rules.wall_m = numbers.wall_m;
    snapping_->setRules(rules);
    radius_m_ = numbers.radius_m;
    syncRadius();
  });
  dialog_->open();
}

void WaypointPlacing::showNextWarning() {
  const std::set<edit::Key>& selected = editing_->selected();
  const edit::Key key = warnings_->next(selected.empty() ? edit::Key() : *selected.begin());
  const map::Waypoint* const point = editing_->find(key);
  if (!point) return;
  context_.scene.setLayerVisible(scene::Layer::Waypoints, true);
  editing_->select({key});
  const QPointF at = scene::toPoint(context_.scene.view().pixelFromWorld(point->position_m));
  const QRectF well_inside = QRectF(context_.view.viewport()->rect()).adjusted(40, 40, -40, -40);
  if (!well_inside.contains(at)) context_.view.lookAt(point->position_m);
}

}  // namespace mapwright::window

#include "moc_waypoint_placing.cpp"
