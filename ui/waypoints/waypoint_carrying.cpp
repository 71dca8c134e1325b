#include "ui/waypoints/waypoint_carrying.h"

#include <utility>

#include <QCheckBox>

#include "scene/map_scene.h"
#include "sentences/failure_sentence.h"
#include "session/session.h"
#include "ui/kit/panels.h"
#include "ui/shell/current_session.h"
#include "ui/shell/viewpoint.h"
#include "ui/waypoints/carry_dock.h"
#include "ui/waypoints/carry_run.h"
#include "ui/waypoints/waypoint_transfer.h"
#include "ui/waypoints/waypoint_warnings.h"

namespace mapwright::window {
namespace {

constexpr double kAroundM = 3;  // of a place that is looked at: as far as walls count for it

}  // namespace

WaypointCarrying::WaypointCarrying(WindowContext& context, WaypointEditing* editing,
                                   WaypointTransfer* transfer, const WaypointWarnings* warnings,
                                   QObject* parent)
    : QObject(parent),
      context_(context),
      editing_(editing),
      transfer_(transfer),
      warnings_(warnings),
      dock_(new CarryDock(&context.window)),
      run_(std::make_unique<CarryRun>(context.workers)) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Right, .tab = 71, .menu_rank = 37, .open = false});
  connect(dock_, &CarryDock::lookWanted, this, &WaypointCarrying::look);
  connect(dock_, &CarryDock::placeWanted, this, &WaypointCarrying::goTo);
  connect(dock_, &CarryDock::soundWanted, this, [this] {
    std::vector<int> rows;
    for (std::size_t i = 0; i < dock_->model()->rows().size(); ++i) {
      if (dock_->model()->rows()[i].sound()) rows.push_back(int(i));
    }
    carryOver(rows);
  });
  connect(dock_, &CarryDock::selectedWanted, this, [this] { carryOver(dock_->selected()); });
  connect(run_.get(), &CarryRun::finished, this, &WaypointCarrying::onCarried);
}

WaypointCarrying::~WaypointCarrying() { delete dock_; }

void WaypointCarrying::setLaid(const std::optional<LaidMap>& laid) {
  if (!laid || !laid_ || laid->reader != laid_->reader || laid->key != laid_->key) became_.clear();
  laid_ = laid;
  refresh();
}

QString WaypointCarrying::whyNot() const {
  const session::Session* const session = context_.current.session();
  if (!laid_ || !laid_->reader) return tr("There is no reference map.");
  if (!laid_->reader->waypointStore() && !laid_->reader->waypointSource())
    return tr("The reference map has no waypoints.");
  if (!session || !session->wholeMap().cells()) return tr("There is no whole map on screen.");
  if (!session->wholeMap().settled()) return tr("The map on screen is still being read.");
  if (!editing_->editable()) {
    return editing_->unavailableReason().isEmpty()
               ? tr("The waypoints of the map on screen cannot be edited.")
               : editing_->unavailableReason();
  }
  return {};
}

std::optional<WaypointCarrying::Subject> WaypointCarrying::subject() const {
  const session::Session* const session = context_.current.session();
  if (!laid_ || !session || !session->wholeMap().cells()) return std::nullopt;
  const session::MapSlot& whole = session->wholeMap();
  return Subject{*laid_, {whole.cells(), whole.reference()}, whole.shown().key};
}

void WaypointCarrying::open() {
  context_.panels.open(dock_);
  look();
}

void WaypointCarrying::look() {
  const QString why = whyNot();
  forget(why);
  if (!why.isEmpty()) return show();
  looked_at_ = subject();
  robot::Robot& reader = *looked_at_->laid.reader;
  const map::MapKey& key = looked_at_->laid.key;
  const int turn = turn_;
  if (robot::WaypointStore* const store = reader.waypointStore()) {
    store->read(key, [this, turn](robot::Outcome<robot::StoredWaypoints> answer) {
      if (turn == turn_)
        onPoints(std::move(answer).map([](auto&& stored) { return std::move(stored.points); }));
    });
  } else {
    reader.waypointSource()->waypoints(key, [this, turn](robot::Outcome<map::WaypointList> answer) {
      if (turn == turn_) onPoints(std::move(answer).map([](auto&& told) { return std::move(told.points); }));
    });
  }
  show();
}

void WaypointCarrying::onPoints(robot::Outcome<std::vector<map::Waypoint>> points) {
  if (!points) {
    forget(tr("The waypoints of the reference map cannot be read. %1")
               .arg(QString::fromStdString(sentences::sentenceOf(points.error()))));
  } else if (points->empty()) {
    forget(tr("The reference map has no waypoints."));
  } else {
    points_ = std::move(*points);
    std::vector<carry::Spot> spots;
    for (const map::Waypoint& point : points_) spots.push_back({point.position_m, point.yaw_rad});
    run_->start(looked_at_->laid.map, looked_at_->map, looked_at_->laid.pose, std::move(spots),
                {.radius_m = warnings_->radius(), .adjust = dock_->adjustBox()->isChecked()});
  }
  show();
}

void WaypointCarrying::onCarried(const std::vector<carry::Carried>& carried) {
  std::vector<CarryRow> rows;
  for (std::size_t i = 0; i < carried.size(); ++i) {
    const auto became = became_.find(points_[i].id);
    rows.push_back({points_[i], carried[i], became == became_.end() ? edit::Key() : became->second});
  }
  dock_->model()->setRows(std::move(rows));
  refresh();
}

void WaypointCarrying::forget(const QString& said) {
  run_->cancel();
  ++turn_;
  looked_at_.reset();
  points_.clear();
  dock_->model()->setRows({});
  said_ = said;
}

void WaypointCarrying::refresh() {
  const QString why = whyNot();
  if (std::exchange(why_not_, why) != why) Q_EMIT possibleChanged(why);
  const auto now = subject();
  if (looked_at_ && !(now && now->sameAs(*looked_at_)))
    forget(tr("The reference map was moved, or one of the maps is another one now. Check again."));
  if (looked_at_ && editing_->document()) dock_->model()->setThere(editing_->document()->items());
  show();
}

void WaypointCarrying::show() {
  const auto now = subject();
  const std::vector<CarryRow>& rows = dock_->model()->rows();
  const bool changed = looked_at_ && now && !(now->map == looked_at_->map);
  CarryShown shown{.said = said_, .editable = editing_->editable()};
  if (looked_at_ && rows.empty()) shown.said = tr("Looking at the walls around each waypoint…");
  if (!rows.empty()) shown.said = carrySumText(rows);
  if (!rows.empty() && changed)
    shown.said = tr("The map on screen has changed since then. As it was: %1").arg(shown.said);
  if (shown.said.isEmpty())
    shown.said =
        tr("Lay the old map under this one as a reference map, and align it. Then press Carry over "
           "waypoints… there.");
  shown.again = whyNot().isEmpty() && ((!looked_at_ && !said_.isEmpty()) || (!rows.empty() && changed));
  dock_->setState(shown);
}

void WaypointCarrying::goTo(int row) {
  if (row < 0 || std::size_t(row) >= dock_->model()->rows().size()) return;
  const CarryRow& one = dock_->model()->rows()[std::size_t(row)];
  const map::Waypoint* const placed = one.key.empty() ? nullptr : editing_->find(one.key);
  const Eigen::Vector2d at = placed ? placed->position_m : one.carried.spot.position_m;
  context_.scene.setMarker(at);
  context_.viewpoint.lookAt({at.x() - kAroundM, at.y() - kAroundM, at.x() + kAroundM, at.y() + kAroundM});
}

void WaypointCarrying::carryOver(const std::vector<int>& rows) {
  std::vector<map::Waypoint> points;
  std::vector<int> going;
  for (const int row : rows) {
    const CarryRow& one = dock_->model()->rows()[std::size_t(row)];
    if (one.state != CarryRow::State::Open) continue;
    map::Waypoint point = one.point;
    point.position_m = one.carried.spot.position_m;
    point.yaw_rad = one.carried.spot.yaw_rad;
    points.push_back(std::move(point));
    going.push_back(row);
  }
  const std::vector<edit::Key> keys = transfer_->carryOver(points);
  if (keys.empty()) return;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    dock_->model()->setKey(going[i], keys[i]);
    const std::string& id = dock_->model()->rows()[std::size_t(going[i])].point.id;
    if (!id.empty()) became_[id] = keys[i];
  }
  context_.scene.setLayerVisible(scene::Layer::Waypoints, true);
  Q_EMIT carried();
  refresh();
}

}  // namespace mapwright::window

#include "moc_waypoint_carrying.cpp"
