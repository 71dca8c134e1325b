#include "ui/waypoints/waypoint_carrying.h"

#include <memory>
#include <set>
#include <utility>

#include "sentences/failure_sentence.h"
#include "ui/scene/map_scene.h"
#include "ui/waypoints/waypoint_text.h"
#include "ui/waypoints/waypoint_transfer.h"
#include "ui/waypoints/waypoint_warnings.h"

namespace mapwright::ui {

WaypointCarrying::WaypointCarrying(WindowContext& context, WaypointEditing* editing,
                                   WaypointTransfer* transfer, const WaypointWarnings* warnings,
                                   QObject* parent)
    : Carrying(context,
               {.title = tr("Carry over waypoints"),
                .one = tr("Waypoint"),
                .named = tr("What becomes of the waypoints"),
                .carried = tr("It is a waypoint of the map on screen now."),
                .there = tr("The map on screen has a waypoint of this name. It stays as it is there."),
                .looking = tr("Looking at the walls around each waypoint…"),
                .hint = tr("Lay the old map under this one as a reference map, and align it. Then press "
                           "Carry over waypoints… there.")},
               QStringLiteral("carryOver"), 37, parent),
      editing_(editing),
      transfer_(transfer),
      warnings_(warnings) {}

QString WaypointCarrying::whyNotBetween(robot::Robot& reader) const {
  if (!reader.waypointStore() && !reader.waypointSource()) return tr("The reference map has no waypoints.");
  if (editable()) return {};
  return editing_->unavailableReason().isEmpty() ? tr("The waypoints of the map on screen cannot be edited.")
                                                 : editing_->unavailableReason();
}

bool WaypointCarrying::editable() const { return editing_->editable(); }

void WaypointCarrying::read(robot::Robot& reader, const map::MapKey& key) {
  const int asked = turn();
  if (robot::WaypointStore* const store = reader.waypointStore()) {
    store->read(key, [this, asked](robot::Outcome<robot::StoredWaypoints> answer) {
      if (asked == turn())
        onPoints(std::move(answer).map([](auto&& stored) { return std::move(stored.points); }));
    });
  } else {
    reader.waypointSource()->waypoints(key, [this, asked](robot::Outcome<map::WaypointList> answer) {
      if (asked == turn())
        onPoints(std::move(answer).map([](auto&& told) { return std::move(told.points); }));
    });
  }
}

void WaypointCarrying::onPoints(robot::Outcome<std::vector<map::Waypoint>> points) {
  if (!points) {
    return giveUp(tr("The waypoints of the reference map cannot be read. %1")
                      .arg(QString::fromStdString(sentences::sentenceOf(points.error()))));
  }
  if (points->empty()) return giveUp(tr("The reference map has no waypoints."));
  points_ = std::move(*points);
  std::vector<carry::Spot> spots;
  for (const map::Waypoint& point : points_) spots.push_back({point.position_m, point.yaw_rad});
  const carry::CarryOptions options{.radius_m = warnings_->radius(), .adjust = adjusts()};
  start([this, spots = std::move(spots), options](const carry::Site& site) -> BackgroundRun::Then {
    return [this, carried = site.carried(spots, options)] {
      std::vector<CarryRow> rows;
      for (std::size_t i = 0; i < carried.size(); ++i)
        rows.push_back({shortWaypointName(points_[i]), carried[i], points_[i].id});
      setRows(std::move(rows));
    };
  });
}

const map::Waypoint* WaypointCarrying::placed(int row) const {
  const auto became = became_.find(rows()[std::size_t(row)].id);
  return became == became_.end() ? nullptr : editing_->find(became->second);
}

std::vector<CarryRow::State> WaypointCarrying::statesNow() const {
  std::set<std::string> names;
  if (editing_->document()) {
    for (const auto& [key, point] : editing_->document()->items()) names.insert(point.name);
  }
  std::vector<CarryRow::State> states;
  for (std::size_t i = 0; i < rows().size(); ++i) {
    const std::string& name = points_[i].name;
    states.push_back(placed(int(i))                          ? CarryRow::State::Carried
                     : !name.empty() && names.contains(name) ? CarryRow::State::There
                                                             : CarryRow::State::Open);
  }
  return states;
}

geometry::WorldRect WaypointCarrying::boundsOf(int row) const {
  const map::Waypoint* const there = placed(row);
  geometry::WorldRect bounds;
  bounds.extend(there ? there->position_m : rows()[std::size_t(row)].carried.spot.position_m);
  return bounds;
}

bool WaypointCarrying::put(const std::vector<int>& going) {
  std::vector<map::Waypoint> points;
  for (const int row : going) {
    const carry::Spot& spot = rows()[std::size_t(row)].carried.spot;
    map::Waypoint point = points_[std::size_t(row)];
    point.position_m = spot.position_m;
    point.yaw_rad = spot.yaw_rad;
    points.push_back(std::move(point));
  }
  const std::vector<edit::Key> keys = transfer_->carryOver(points);
  for (std::size_t i = 0; i < keys.size(); ++i) became_[rows()[std::size_t(going[i])].id] = keys[i];
  if (!keys.empty()) context_.scene.setLayerVisible(scene::Layer::Waypoints, true);
  return !keys.empty();
}

}  // namespace mapwright::ui

#include "moc_waypoint_carrying.cpp"
