// Reads and writes the messages of KABAM's MapManagerV2. Pure. Source: docs/protocols/kabam-map-manager.md,
// "Topics", "Services".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QByteArray>

#include "map/catalogue.h"
#include "map/failure.h"
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
  KabamMap map;       // its id may be empty: no map
  std::string state;  // IDLE, MAPPING, ACTIVE, or any other value
  std::optional<double> created_s, updated_s;
  bool operator==(const KabamCurrent&) const = default;
};

/// The displayed name: its label, otherwise its name.
const std::string& calledOf(const KabamMap& map);

/// nullopt: not a MapList. Rows without an id are skipped.
std::optional<std::vector<KabamMap>> readMapList(const Field& msg, bool archived);
std::optional<KabamCurrent> readMapInfo(const Field& msg);

/// MapWaypointList as waypoints of the map `map_id`, in the frame `fixed_frame`; nullopt: not a list. Skipped
/// with a note: those without id or position, duplicates of an id, those in another frame. Those of another
/// map are skipped silently.
std::optional<StoredWaypoints> readWaypoints(const Field& msg, const std::string& map_id,
                                             const std::string& fixed_frame);
/// Identifies the version of a list.
std::string revisionOf(const std::vector<map::Waypoint>& points);

/// A complete MapWaypoint: unchanged fields are sent back as received, including a zero orientation that was
/// not edited. `id` empty = create it.
QByteArray waypointJson(const map::Waypoint& point, const std::string& id, const std::string& map_id,
                        const std::string& fixed_frame);
/// The complete arguments of ManageWaypoint, GetWaypoint, LoadMap and UpdateMap.
QByteArray manageWaypointArgs(const QByteArray& waypoint, bool delete_waypoint);
/// `waypoint_id`: one of them; empty = all.
QByteArray getWaypointArgs(const std::string& map_id, const std::string& waypoint_id = {});
QByteArray loadMapArgs(const std::string& map_id, const std::string& waypoint_name);
/// `label`: the new name; empty = unchanged.
QByteArray updateMapArgs(const KabamMap& map, const std::string& label, bool archived, bool delete_map);
/// The same with a mono8 picture, up to the start of its base64; `"}}` ends it.
QByteArray updateImageHead(const KabamMap& map, int width, int height);
QByteArray saveMapArgs(const std::string& name);

/// Whether both have the same position and name, within the precision of transmitted numbers.
bool sameBesidesTags(const map::Waypoint& a, const map::Waypoint& b);

/// nullopt: success. Otherwise the failure about `subject`; unknown codes are shown as numbers. `service`:
/// "load_map". `name`: the requested name of the waypoint or map.
std::optional<map::Failure> resultOf(std::string_view service, const Field& values, map::Subject subject,
                                     const std::string& name = {});

/// The code of LoadMap if the map is already loaded.
inline constexpr const char* kAlreadyLoaded = "2";

}  // namespace mapwright::robot::ros
