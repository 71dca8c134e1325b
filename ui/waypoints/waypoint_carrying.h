// The waypoints of the reference map on the map on screen: what becomes of each, and those that are carried
// over become changes to its list. Why: docs/tasks/new-map.md.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>

#include "map/catalogue.h"
#include "ui/shell/laid_map.h"
#include "ui/shell/window_context.h"
#include "ui/waypoints/waypoint_editing.h"

namespace mapwright::carry {
struct Carried;
}

namespace mapwright::window {

class CarryDock;
class CarryRun;
class WaypointTransfer;
class WaypointWarnings;

class WaypointCarrying : public QObject {
  Q_OBJECT
 public:
  /// All must outlive this. `warnings` know the radius of the robot.
  WaypointCarrying(WindowContext& context, WaypointEditing* editing, WaypointTransfer* transfer,
                   const WaypointWarnings* warnings, QObject* parent);
  ~WaypointCarrying() override;

  CarryDock* dock() const { return dock_; }
  /// The reference map; nullopt = none, or it is still being read.
  void setLaid(const std::optional<LaidMap>& laid);
  /// Shows the dock, and what becomes of them.
  void open();
  /// The map on screen or its waypoints have changed.
  void refresh();

 Q_SIGNALS:
  /// Empty: waypoints can be carried over.
  void possibleChanged(const QString& why_not);
  void carried();

 private:
  /// What the verdicts are about.
  struct Subject {
    LaidMap laid;
    render::PlacedGrid map;
    map::MapKey key;
    /// It still is, although the map on screen may have changed.
    bool sameAs(const Subject& other) const { return laid == other.laid && key == other.key; }
  };

  QString whyNot() const;
  std::optional<Subject> subject() const;
  void look();
  void onPoints(robot::Outcome<std::vector<map::Waypoint>> points);
  void onCarried(const std::vector<carry::Carried>& carried);
  void forget(const QString& said);
  void show();
  void goTo(int row);
  void carryOver(const std::vector<int>& rows);

  WindowContext& context_;
  WaypointEditing* editing_;
  WaypointTransfer* transfer_;
  const WaypointWarnings* warnings_;
  CarryDock* dock_;
  std::optional<LaidMap> laid_;
  std::optional<QString> why_not_;  // as it was said last
  std::optional<Subject> looked_at_;
  std::vector<map::Waypoint> points_;        // of the reference map
  std::map<std::string, edit::Key> became_;  // by their ids: those that were carried over
  int turn_ = 0;                             // answers of earlier ones are of no use
  QString said_;                             // instead of the sum
  std::unique_ptr<CarryRun> run_;
};

}  // namespace mapwright::window
