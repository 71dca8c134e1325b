#include "ui/waypoints/placing_actions.h"

#include <QMenu>

#include "placing/names.h"
#include "scene/drawing.h"
#include "ui/kit/plain_label.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_view.h"
#include "ui/view/tool_choice.h"
#include "ui/waypoints/line_bar.h"
#include "ui/waypoints/line_tool.h"
#include "ui/waypoints/waypoint_snapping.h"
#include "ui/waypoints/waypoint_text.h"

namespace mapwright::window {
namespace {
constexpr double kDuplicatePx = 24;  // minimum distance from the originals, so that both are visible
}

PlacingActions::PlacingActions(WindowContext& context, WaypointEditing* editing, WaypointSnapping* snapping,
                               QObject* parent)
    : QObject(parent),
      context_(context),
      editing_(editing),
      snapping_(snapping),
      line_(new LineTool(&context.scene, snapping, this)),
      bar_(new LineBar(line_, &context.view)),
      creating_menu_(new QMenu(tr("&New waypoint"), &context.window)),
      arranging_menu_(new QMenu(tr("&Arrange waypoints"), &context.window)) {
  addCreating();
  addSelecting();
  addArranging();
  for (QMenu* menu : {creating_menu_, arranging_menu_}) menu->setToolTipsVisible(true);
  context_.actions.place({MenuGroup::Waypoints, 12}, creating_menu_->menuAction());
  context_.actions.place({MenuGroup::Waypoints, 14}, arranging_menu_->menuAction());
  connect(creating_menu_, &QMenu::aboutToShow, this, &PlacingActions::refresh);
  connect(editing_, &WaypointEditing::opened, this, &PlacingActions::refresh);
  connect(editing_, &WaypointEditing::selectionChanged, this, &PlacingActions::refresh);
  connect(&context_.scene, &scene::MapScene::robotPlaceChanged, this, &PlacingActions::refresh);
  connect(line_, &LineTool::madeWanted, this, &PlacingActions::createAlongLine);
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
  return context_.actions.add(menuTitle(Menu::Edit).remove(QLatin1Char('&')), QLatin1String(id), text,
                              QLatin1String(icon), keys, reach, tip);
}

void PlacingActions::addCreating() {
  at_robot_ = entry("waypointAtRobot", tr("At the &robot"), "robot", "Ctrl+Shift+R", Reach::Everywhere,
                    tr("A waypoint at the robot's position and heading"));
  connect(at_robot_, &QAction::triggered, this, &PlacingActions::createAtRobot);
  at_numbers_ = entry("waypointAtNumbers", tr("At &coordinates…"), "goto", "Ctrl+Shift+N", Reach::Everywhere,
                      tr("A waypoint with a given name, position and heading"));
  connect(at_numbers_, &QAction::triggered, this, &PlacingActions::askForNumbers);
  along_line_ = context_.actions.addToggle(
      menuTitle(Menu::Edit).remove(QLatin1Char('&')), QStringLiteral("waypointLine"), tr("Along a &line"),
      QStringLiteral("line"), {QKeySequence(QStringLiteral("L"))}, Reach::OutsideText,
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

void PlacingActions::addArranging() {
  using placing::Axis;
  const auto add = [this](const char* id, const QString& text, const QString& tip, Arranging how, Axis axis,
                          const QString& what) {
    QAction* const action = entry(id, text, "", "", Reach::Everywhere, tip);
    connect(action, &QAction::triggered, this, [this, how, axis, what] { arrange(how, axis, what); });
    arranging_menu_->addAction(action);
    arranging_.push_back(action);
  };
  add("alignWaypointsX", tr("Align on one &x"), tr("Move all selected waypoints to their mean x"),
      &placing::aligned, Axis::X, tr("align %1"));
  add("alignWaypointsY", tr("Align on one &y"), tr("Move all selected waypoints to their mean y"),
      &placing::aligned, Axis::Y, tr("align %1"));
  add("distributeWaypointsX", tr("&Distribute along x"),
      tr("Space the selected waypoints evenly between the outermost two"), &placing::distributed, Axis::X,
      tr("distribute %1"));
  add("distributeWaypointsY", tr("Dis&tribute along y"),
      tr("Space the selected waypoints evenly between the outermost two"), &placing::distributed, Axis::Y,
      tr("distribute %1"));
}

std::optional<geometry::Pose2> PlacingActions::robotPose(QString* why_not) const {
  const session::Session* const session = context_.current.session();
  const auto& pose = session ? session->live().robot_pose : std::nullopt;
  if (!pose) {
    *why_not = tr("The position of the robot is unknown.");
    return std::nullopt;
  }
  if (context_.scene.robotPlace().where == map::Whereabouts::Elsewhere) {
    *why_not = tr("The robot is not in the map on screen.");
    return std::nullopt;
  }
  return pose;
}

void PlacingActions::refresh() {
  const bool editable = editing_->editable();
  const QString why = editing_->document() ? editing_->whyNot() : tr("Open a map to place waypoints in it.");
  const auto allow = [](QAction* action, bool allowed, const QString& why_not) {
    action->setEnabled(allowed);
    // The first words of it are what it does.
    if (!action->property("tip").isValid()) action->setProperty("tip", action->toolTip());
    const QString tip = action->property("tip").toString();
    action->setToolTip(allowed || why_not.isEmpty() ? tip : plainToolTip(why_not));
  };
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
  for (std::size_t i = 0; i < arranging_.size(); ++i) {
    const bool distributes = i >= 2;
    allow(arranging_[i], editable && selected >= (distributes ? 3U : 2U),
          !editable     ? why
          : distributes ? tr("Select at least three waypoints.")
                        : tr("Select at least two waypoints."));
  }
}

void PlacingActions::refreshRobot() {
  QString why_not;
  if (robotPose(&why_not).has_value() != robot_known_) refresh();
}

void PlacingActions::createAtRobot() {
  QString why_not;
  const auto pose = robotPose(&why_not);
  if (!pose) return refresh();
  map::Waypoint point;
  point.position_m = {pose->x_m, pose->y_m};
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
  if (!line_->ready() || !editing_->editable()) return;
  std::vector<map::Waypoint> points;
  for (const placing::Spot& spot : line_->spots()) {
    map::Waypoint point;
    point.position_m = spot.position_m;
    point.yaw_rad = spot.yaw_rad;
    points.push_back(std::move(point));
  }
  if (points.empty()) return;
  editing_->addAll(std::move(points), tr("add %1"));
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
    map::Waypoint copy;
    copy.name = of.name.empty() ? std::string() : placing::nextName(of.name, taken);
    copy.type = of.type;
    copy.tags = of.tags;
    copy.yaw_rad = of.yaw_rad;
    copy.position_m = of.position_m + Eigen::Vector2d(away, -away);
    copies.push_back(std::move(copy));
  }
  editing_->addAll(std::move(copies), tr("duplicate %1"));
  Q_EMIT made();
}

void PlacingActions::arrange(Arranging how, placing::Axis axis, const QString& what) {
  std::vector<placing::Spot> spots;
  for (const edit::Key& key : editing_->selected()) {
    const map::Waypoint& point = *editing_->find(key);
    spots.push_back({point.position_m, point.yaw_rad});
  }
  spots = how(std::move(spots), axis);
  WaypointPreview to;
  std::size_t i = 0;
  for (const edit::Key& key : editing_->selected()) to.emplace_hint(to.end(), key, spots[i++]);
  editing_->apply(to, what.arg(waypointsText(qsizetype(to.size()))));
}

}  // namespace mapwright::window

#include "moc_placing_actions.cpp"
