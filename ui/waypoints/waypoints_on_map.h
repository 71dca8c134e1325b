// The waypoints of the open list as the map shows them and as clicks find them: follows document, selection
// and drags, waypoint by waypoint. GUI thread.
#pragma once

#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

#include <QObject>

#include "ui/scene/map_scene.h"
#include "ui/view/hit_list.h"
#include "ui/waypoints/waypoint_editing.h"

namespace mapwright::ui {

class WaypointWarnings;

class WaypointsOnMap : public QObject {
  Q_OBJECT
 public:
  /// All must outlive this.
  WaypointsOnMap(WaypointEditing* editing, scene::MapScene* scene, HitList* hits, QObject* parent = nullptr);
  /// The map that they belong to; nullopt = nothing is drawn.
  void setMap(const std::optional<map::MapKey>& map);
  /// Must outlive this.
  void setWarnings(const WaypointWarnings* warnings);

 private:
  void begin();
  void onChanged(const edit::DocumentChange& change);
  void onSelection();
  void onPreview();
  /// nullopt = it is not drawn.
  std::optional<scene::DrawnWaypoint> drawnOf(const edit::Key& key) const;
  void place(const edit::Key& key);  // in the index
  void placeAll();                   // anew
  void put(const edit::Key& key);    // among what is drawn
  void draw();

  WaypointEditing* editing_;
  const WaypointWarnings* warnings_ = nullptr;
  scene::MapScene* scene_;
  PointIndex places_;
  std::optional<map::MapKey> map_;
  std::vector<scene::DrawnWaypoint> points_;
  std::vector<edit::Key> keys_;  // of points_
  std::unordered_map<edit::Key, std::size_t> at_;
  std::set<edit::Key> selected_;      // as drawn
  std::vector<edit::Key> previewed_;  // as drawn
};

}  // namespace mapwright::ui
