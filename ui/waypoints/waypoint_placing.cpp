#include "ui/waypoints/waypoint_placing.h"

#include <algorithm>
#include <cmath>

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>

#include "geometry/pose.h"
#include "map/live_state.h"
#include "session/lacks_picture.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/ui_colors.h"
#include "ui/scene/drawing.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/viewpoint.h"
#include "ui/view/map_view.h"
#include "ui/view/tool_choice.h"
#include "ui/waypoints/decimal_place.h"
#include "ui/waypoints/line_bar.h"
#include "ui/waypoints/line_tool.h"
#include "ui/waypoints/waypoint_arranging.h"
#include "ui/waypoints/waypoint_text.h"

namespace mapwright::ui {
namespace {

constexpr double kFarthestPlaceM = 1e7;
constexpr double kNoPlaceHeading = -181;  // the minimum of its field means none
constexpr int kLongestPlaceName = 500;

QDoubleSpinBox* metres(double least, double most, double value, QWidget* parent) {
  auto* const box = numberField(parent, {.least = least, .most = most, .width_px = 130});
  box->setValue(value);
  return box;
}

QHBoxLayout* buttonsOf(QDialog* dialog, const QString& done) {
  auto* const ok = new QPushButton(done, dialog);
  auto* const cancel = new QPushButton(QDialog::tr("Cancel"), dialog);
  giveRoles(*ok, {cancel});
  QObject::connect(ok, &QPushButton::clicked, dialog, &QDialog::accept);
  QObject::connect(cancel, &QPushButton::clicked, dialog, &QDialog::reject);
  return rowOf({LayoutItem::rest(), cancel, ok}, 8);
}

QFormLayout* dialogForm(QVBoxLayout* column) {
  auto* const form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(8);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addLayout(form);
  return form;
}

constexpr double kDuplicatePx = 24;  // minimum distance from the originals, so that both are visible

const QString kRadiusKey = QStringLiteral("waypoints/robot_radius_m");
using placing::kMostRadiusM;
constexpr double kAroundBareM = 3;  // around waypoints without a picture

}  // namespace

NewWaypointDialog::NewWaypointDialog(const map::Waypoint& present, QWidget* parent)
    : QDialog(parent),
      name_(new QLineEdit(this)),
      x_(metres(-kFarthestPlaceM, kFarthestPlaceM, present.position_m.x(), this)),
      y_(metres(-kFarthestPlaceM, kFarthestPlaceM, present.position_m.y(), this)),
      heading_(numberField(this, {kNoPlaceHeading, 180, 1, 15, QString(QChar(0xb0)), {}, 130})) {
  setWindowTitle(tr("New waypoint"));
  setMinimumWidth(340);
  setLongest(*name_, kLongestPlaceName);
  showWhole(*name_, QString::fromStdString(present.name));
  name_->selectAll();
  heading_->setSpecialValueText(tr("none"));
  heading_->setValue(present.yaw_rad
                         ? geometry::degreesFromRadians(geometry::normalizeAngle(*present.yaw_rad))
                         : kNoPlaceHeading);
  heading_->setToolTip(tr("Counter-clockwise from the x axis of the map"));
  auto* const column = new QVBoxLayout(this);
  QFormLayout* const form = dialogForm(column);
  form->addRow(tr("&Name"), name_);
  form->addRow(tr("&x"), x_);
  form->addRow(tr("&y"), y_);
  form->addRow(tr("&Heading"), heading_);
  column->addLayout(buttonsOf(this, tr("Create")));
}

map::Waypoint NewWaypointDialog::waypoint() const {
  map::Waypoint point;
  point.name = name_->text().trimmed().toStdString();
  point.position_m = {x_->value(), y_->value()};
  if (heading_->value() > kNoPlaceHeading) point.yaw_rad = geometry::radiansFromDegrees(heading_->value());
  return point;
}

PlacingDialog::PlacingDialog(const PlacingNumbers& present, double reported_radius_m, QWidget* parent)
    : QDialog(parent),
      present_(present),
      grid_(metres(0.01, 100, present.grid_m, this)),
      wall_(metres(0.01, 100, present.wall_m, this)),
      radius_(metres(0, 10, reported_radius_m > 0 ? reported_radius_m : present.radius_m, this)) {
  setWindowTitle(tr("Distances"));
  setMinimumWidth(380);
  auto* const column = new QVBoxLayout(this);
  QFormLayout* const form = dialogForm(column);
  form->addRow(tr("&Grid to snap to"), grid_);
  form->addRow(tr("Distance to &walls"), wall_);
  form->addRow(tr("&Radius of the robot"), radius_);
  radius_->setSpecialValueText(tr("not checked"));
  radius_->setEnabled(reported_radius_m <= 0);
  auto* const about = wrappedLabel(
      reported_radius_m > 0 ? tr("The robot reports its own footprint, which is used instead.")
                            : tr("Waypoints closer to a wall than this get a warning. This robot does not "
                                 "report its footprint."),
      this);
  setTextColor(*about, appColors().secondary_text);
  column->addWidget(about);
  column->addLayout(buttonsOf(this, tr("OK")));
}

PlacingNumbers PlacingDialog::numbers() const {
  return {grid_->value(), wall_->value(), radius_->isEnabled() ? radius_->value() : present_.radius_m};
}

PlacingActions::PlacingActions(WindowContext& context, WaypointEditing* editing, WaypointSnapping* snapping,
                               QObject* parent)
    : QObject(parent),
      context_(context),
      editing_(editing),
      snapping_(snapping),
      line_(new LineTool(&context.scene, snapping, this)),
      bar_(new LineBar(line_, editing, &context.view)),
      creating_menu_(new QMenu(tr("&New waypoint"), &context.window)) {
  addCreating();
  addSelecting();
  creating_menu_->setToolTipsVisible(true);
  context_.actions.addToMenu({MenuGroup::Waypoints, 12}, creating_menu_->menuAction());
  connect(creating_menu_, &QMenu::aboutToShow, this, &PlacingActions::refresh);
  connect(editing_, &WaypointEditing::opened, this, &PlacingActions::refresh);
  connect(editing_, &WaypointEditing::selectionChanged, this, &PlacingActions::refresh);
  connect(&context_.scene, &scene::MapScene::robotPlaceChanged, this, &PlacingActions::refresh);
  connect(line_, &LineTool::madeWanted, this, &PlacingActions::createAlongLine);
  connect(line_, &LineTool::activated, this, [this](bool active) {
    if (active) context_.view.setFocus();
  });
  connect(bar_, &LineBar::createWanted, this, &PlacingActions::createAlongLine);
  connect(bar_, &LineBar::closed, this, [this] {
    context_.tools.putAway();
    context_.view.setFocus();
  });
  refresh();
}

QAction* PlacingActions::entry(const char* id, const QString& text, const char* icon, const char* key,
                               Reach reach, const QString& tip) {
  QList<QKeySequence> keys;
  if (*key) keys << QKeySequence(QLatin1String(key));
  return context_.actions.add(menuName(Menu::Edit), QLatin1String(id), text, QLatin1String(icon), keys, reach,
                              tip);
}

void PlacingActions::addCreating() {
  at_robot_ = entry("waypointAtRobot", tr("At the &robot"), "robot", "Ctrl+Shift+R", Reach::Everywhere,
                    tr("A waypoint at the robot's position and heading"));
  connect(at_robot_, &QAction::triggered, this, &PlacingActions::createAtRobot);
  at_numbers_ = entry("waypointAtNumbers", tr("At &coordinates…"), "goto", "Ctrl+Shift+N", Reach::Everywhere,
                      tr("A waypoint with a given name, position and heading"));
  connect(at_numbers_, &QAction::triggered, this, &PlacingActions::askForNumbers);
  along_line_ = context_.actions.addToggle(menuName(Menu::Edit), QStringLiteral("waypointLine"),
                                           tr("Along a &line"), QStringLiteral("line"),
                                           {QKeySequence(QStringLiteral("L"))}, Reach::OutsideText,
                                           tr("Evenly spaced waypoints along a line, heading along it"));
  context_.tools.add(line_, along_line_);
  for (QAction* action : {at_robot_, at_numbers_, along_line_}) creating_menu_->addAction(action);
}

void PlacingActions::addSelecting() {
  duplicate_ = context_.actions.add({.id = "duplicateWaypoints",
                                     .text = tr("D&uplicate waypoints"),
                                     .icon = "copy",
                                     .keys = {"Ctrl+D"},
                                     .tip = tr("Copy the selected waypoints, next to the originals"),
                                     .menu = {MenuGroup::Waypoints, 16}},
                                    this, &PlacingActions::duplicate);
  all_ = context_.actions.add({.id = "selectAllWaypoints",
                               .text = tr("Select all &waypoints"),
                               .keys = {"Ctrl+A"},
                               .reach = Reach::Map,
                               .tip = tr("All waypoints of the map"),
                               .menu = {MenuGroup::Waypoints, 17}},
                              editing_, &WaypointEditing::selectAll);
  invert_ =
      context_.actions.add({.id = "invertWaypoints",
                            .text = tr("&Invert the selection"),
                            .keys = {"Ctrl+Shift+A"},
                            .reach = Reach::Map,
                            .tip = tr("Select the waypoints that are not selected, and deselect the others"),
                            .menu = {MenuGroup::Waypoints, 18}},
                           editing_, &WaypointEditing::invertSelection);
}

std::optional<geometry::Pose2> PlacingActions::robotPose(QString* unavailable_reason) const {
  const session::Session* const session = context_.current.session();
  const auto& pose = session ? session->live().robot_pose : std::nullopt;
  if (!pose) {
    *unavailable_reason = tr("The position of the robot is unknown.");
    return std::nullopt;
  }
  if (context_.scene.robotPlace().where == map::Whereabouts::Elsewhere) {
    *unavailable_reason = tr("The robot is not in the map on screen.");
    return std::nullopt;
  }
  return pose;
}

void PlacingActions::refresh() {
  const bool editable = editing_->editable();
  const QString why =
      editing_->document() ? editing_->unavailableReason() : tr("Open a map to place waypoints in it.");
  QString no_robot;
  robot_known_ = robotPose(&no_robot).has_value();
  allow(at_robot_, editable && robot_known_, editable ? no_robot : why);
  allow(at_numbers_, editable, why);
  allow(along_line_, editable, why);
  if (!editable && context_.tools.chosen() == line_) context_.tools.putAway();
  const auto selected = editing_->selected().size();
  allow(duplicate_, editable && selected > 0, editable ? tr("Nothing is selected.") : why);
  allow(all_, editing_->document() != nullptr, why);
  allow(invert_, editing_->document() != nullptr, why);
}

void PlacingActions::refreshRobot() {
  QString unavailable_reason;
  if (robotPose(&unavailable_reason).has_value() != robot_known_) refresh();
}

void PlacingActions::createAtRobot() {
  QString unavailable_reason;
  const auto pose = robotPose(&unavailable_reason);
  if (!pose) return refresh();
  map::Waypoint point;
  point.position_m = decimalPlace({pose->x_m, pose->y_m});
  point.yaw_rad = pose->yaw_rad;
  const edit::Gesture gesture = editing_->newGesture();
  const auto keys = editing_->addAll({point}, tr("add %1"), gesture);
  if (keys.empty()) return;
  Q_EMIT made();
  Q_EMIT editing_->renameWanted(*keys.begin(), gesture);
}

void PlacingActions::askForNumbers() {
  if (dialog_ || !editing_->editable()) return;
  map::Waypoint present;
  present.position_m = context_.view.cursorWorld().value_or(context_.scene.view().center_m);
  dialog_ = new NewWaypointDialog(present, &context_.window);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog_, &QDialog::accepted, this, [this] {
    const map::Waypoint point = dialog_->waypoint();
    if (editing_->addAll({point}, tr("add %1")).empty()) return;
    Q_EMIT made();
    const QPointF at = scene::toPoint(context_.scene.view().pixelFromWorld(point.position_m));
    if (!QRectF(context_.view.viewport()->rect()).contains(at)) context_.view.lookAt(point.position_m);
  });
  dialog_->open();
}

void PlacingActions::createAlongLine() {
  if (!line_->ready() || !editing_->editable() || !bar_->notFromReason().isEmpty()) return;
  std::vector<map::Waypoint> points;
  const QStringList names = bar_->names();
  for (const placing::Spot& spot : line_->spots()) {
    map::Waypoint point;
    if (const auto i = qsizetype(points.size()); i < names.size()) point.name = names[i].toStdString();
    point.position_m = decimalPlace(spot.position_m);
    point.yaw_rad = spot.yaw_rad;
    points.push_back(std::move(point));
  }
  if (points.empty()) return;
  editing_->addAll(std::move(points), tr("add %1"));
  bar_->onCreated();
  line_->forget();
  Q_EMIT made();
  context_.view.setFocus();
}

void PlacingActions::duplicate() {
  if (!editing_->editable() || editing_->selected().empty()) return;
  const double away =
      std::max(snapping_->rules().grid_m, kDuplicatePx * context_.scene.view().scale_m_per_px);
  std::set<std::string> taken = editing_->names();
  std::vector<map::Waypoint> copies;
  for (const edit::Key& key : editing_->selected()) {
    const map::Waypoint& of = *editing_->find(key);
    map::Waypoint copy = of;
    copy.source.clear();
    if (!of.name.empty()) copy.name = placing::nextName(of.name, taken);
    copy.position_m = decimalPlace(of.position_m + Eigen::Vector2d(away, -away));
    copies.push_back(std::move(copy));
  }
  editing_->addAll(std::move(copies), tr("duplicate %1"));
  Q_EMIT made();
}

WaypointPlacing::WaypointPlacing(WindowContext& context, WaypointEditing* editing, QObject* parent)
    : QObject(parent),
      context_(context),
      editing_(editing),
      snapping_(new WaypointSnapping(&context.scene, &context.hits, this)),
      warnings_(new WaypointWarnings(editing, context.workers, this)),
      actions_(new PlacingActions(context, editing, snapping_, this)),
      arranging_(new WaypointArranging(context, editing, snapping_, this)),
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

void WaypointPlacing::addSnapping() {
  using placing::SnapRules;
  snap_ = context_.actions.add({.id = "snap",
                                .text = tr("&Snap"),
                                .name = tr("Snap waypoints"),
                                .keys = {"S"},
                                .reach = Reach::OutsideText,
                                .tip = tr("Placed waypoints snap to what is selected below; Alt suspends it"),
                                .toggle = true,
                                .menu = {MenuGroup::Waypoints, 13}},
                               snapping_, &WaypointSnapping::setOn);
  struct Rule {
    const char* id;
    QString text, tip;
    bool SnapRules::*rule;
  };
  const QString menu = menuName(Menu::Edit);
  for (const auto& [id, text, tip, rule] :
       {Rule{"snapWaypoints", tr("Other &waypoints"),
             tr("The positions of other waypoints, and lines through them"), &SnapRules::waypoints},
        Rule{"snapGrid", tr("A &grid"), tr("Lines at a regular distance, see Distances"), &SnapRules::grid},
        Rule{"snapWalls", tr("A distance to wa&lls"),
             tr("Positions at a given distance from the nearest wall, see Distances"), &SnapRules::walls},
        Rule{"snapHeadings", tr("&Headings of 15°"), tr("Headings that are multiples of 15°"),
             &SnapRules::headings}}) {
    QAction* const action =
        context_.actions.addToggle(menu, QLatin1String(id), text, {}, {}, Reach::Everywhere, tip);
    connect(action, &QAction::triggered, this, [this, rule = rule](bool checked) {
      SnapRules rules = snapping_->rules();
      rules.*rule = checked;
      snapping_->setRules(rules);
      // Choosing what to snap to also turns snapping on.
      if (checked) snapping_->setOn(true);
    });
    rules_.push_back({action, rule});
    snap_menu_->addAction(action);
  }
  snap_menu_->addSeparator();
  QAction* const distances = context_.actions.add(menu, QStringLiteral("snapDistances"), tr("&Distances…"),
                                                  QStringLiteral("settings"), {}, Reach::Everywhere,
                                                  tr("Grid spacing, distance to walls, and robot size"));
  connect(distances, &QAction::triggered, this, &WaypointPlacing::askDistances);
  snap_menu_->addAction(distances);
  context_.actions.addToMenu({MenuGroup::Waypoints, 13}, snap_menu_->menuAction());
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
  placing::PlacedMap under;
  if (session_ && session_->wholeMap().isWhole()) under = mapUnder(context_.scene);
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
  reported_radius_m_ = session_ ? placing::radiusOf(session_->live().model) : 0;
  warnings_->setRadius(reported_radius_m_ > 0 ? reported_radius_m_ : radius_m_);
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
                              reported_radius_m_, &context_.window);
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

}  // namespace mapwright::ui

#include "moc_waypoint_placing.cpp"
