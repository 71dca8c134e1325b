// The messages of KABAM's MapManagerV2, read and written. Pure. Source: docs/protocols/kabam-map-manager.md,
// "Topics", "Services".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QByteArray>

#include "map/catalogue.h"
#include "map/waypoint.h"
#include "net/rosbridge/field.h"
#include "robot/waypoint_store.h"

namespace mapwright::robot::ros {

using net::rosbridge::Field;

/// A row of MapList, or MapInfo. Untrusted texts; the id is never empty.
struct KabamMap {
  std::string id, name, label;
  bool archived = false;
  bool operator==(const KabamMap&) const = default;
};
struct KabamCurrent {
  KabamMap map;       // its id may be empty: there is none
  std::string state;  // IDLE, MAPPING, ACTIVE, or whatever it says
  std::optional<double> created_s, updated_s;
  bool operator==(const KabamCurrent&) const = default;
};

/// What people call it: its label, else its name.
const std::string& calledOf(const KabamMap& map);

/// nullopt: it is no MapList. Rows without an id are left out.
std::optional<std::vector<KabamMap>> readMapList(const Field& msg, bool archived);
std::optional<KabamCurrent> readMapInfo(const Field& msg);

/// MapWaypointList as waypoints of the map `map_id`, in the frame `fixed_frame`; nullopt: it is none. Left
/// out, with a note: those without id or place, the second of an id, those in another frame. Those of another
/// map are left out silently.
std::optional<StoredWaypoints> readWaypoints(const Field& msg, const std::string& map_id,
                                             const std::string& fixed_frame);
/// What tells one list from another.
std::string revisionOf(const std::vector<map::Waypoint>& points);

/// A whole MapWaypoint: what is not changed goes back as it came, a zero orientation that nobody has turned
/// as well. `id` empty = it is to be created.
QByteArray waypointJson(const map::Waypoint& point, const std::string& id, const std::string& map_id,
                        const std::string& fixed_frame);
/// The arguments of ManageWaypoint, GetWaypoint, LoadMap and UpdateMap, whole.
QByteArray manageWaypointArgs(const QByteArray& waypoint, bool delete_waypoint);
/// `waypoint_id`: one of them; empty = all.
QByteArray getWaypointArgs(const std::string& map_id, const std::string& waypoint_id = {});
QByteArray loadMapArgs(const std::string& map_id, const std::string& waypoint_name);
/// `label`: what it is called from now on; empty = nothing is said of that.
QByteArray updateMapArgs(const KabamMap& map, const std::string& label, bool archived, bool delete_map);
/// The same with a picture of mono8, up to where its base64 begins; `"}}` ends it.
QByteArray updateImageHead(const KabamMap& map, int width, int height);
QByteArray saveMapArgs(const std::string& name);

/// Whether both are the same place with the same name, as far as that can be told of numbers that have
/// travelled.
bool sameBesidesTags(const map::Waypoint& a, const map::Waypoint& b);

}  // namespace mapwright::robot::ros
