// The waypoints of the reference map on the map on screen. Why: docs/tasks/new-map.md.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ui/carry/carrying.h"
#include "ui/waypoints/waypoint_editing.h"

namespace mapwright::ui {

class WaypointTransfer;
class WaypointWarnings;

class WaypointCarrying : public Carrying {
  Q_OBJECT
 public:
  /// All must outlive this. `warnings` know the radius of the robot.
  WaypointCarrying(WindowContext& context, WaypointEditing* editing, WaypointTransfer* transfer,
                   const WaypointWarnings* warnings, QObject* parent);

 private:
  QString whyNotBetween(robot::Robot& reader) const override;
  bool editable() const override;
  void read(robot::Robot& reader, const map::MapKey& key) override;
  void forgetCarried() override { became_.clear(); }
  std::vector<CarryRow::State> statesNow() const override;
  geometry::WorldRect boundsOf(int row) const override;
  bool put(const std::vector<int>& rows) override;

  void onPoints(robot::Outcome<std::vector<map::Waypoint>> points);
  /// What a row became; null: it was not carried over.
  const map::Waypoint* placed(int row) const;

  WaypointEditing* editing_;
  WaypointTransfer* transfer_;
  const WaypointWarnings* warnings_;
  std::vector<map::Waypoint> points_;        // of the reference map
  std::map<std::string, edit::Key> became_;  // by the ids of rows
};

}  // namespace mapwright::ui
