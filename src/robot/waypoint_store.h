// The port: waypoints that can be changed. Source: docs/protocols/kabam-map-manager.md, "Services".
//
// Made for robots with a service for every single change (create, rename, move, delete) as well as for lists
// that are written as a whole: plan() says how many requests a set of changes takes.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QObject>

#include "map/catalogue.h"
#include "map/waypoint.h"
#include "robot/call.h"

namespace mapwright::robot {

/// The waypoints of one map as they are kept now.
struct StoredWaypoints {
  std::vector<map::Waypoint> points;  // their ids are not empty and all different
  std::string revision;               // another one whenever the list is; opaque
  std::vector<Fault> notes;           // what is odd about them
  bool there = true;                  // false: there is no list, not even an empty one
  /// Ids of those that are kept with a quaternion of zero, which is no heading: their yaw is 0 here.
  std::set<std::string> zero_turns = {};
};

/// What of a waypoint is kept; the rest is lost there, or refused.
struct KeptFields {
  bool type = true;
  bool no_heading = true;  // false: one without a heading would come back with a heading of 0
  bool name_twice = true;  // false: a name that another one has is refused
};

/// One waypoint as it was and as it is to be; nullopt = it is not there.
struct WaypointChange {
  std::string id;
  std::optional<map::Waypoint> before = {}, after = {};
};

/// One request: what it changes, in one go, of the list of that revision.
struct WaypointRequest {
  std::vector<WaypointChange> changes;
  std::string revision;
};

/// A request as people read it before it is sent: the robot's name of the service, and a JSON object.
struct WaypointCall {
  std::string service, arguments;  // empty: nothing is called, the list is written
};

/// What a request that was carried out tells.
struct WaypointReceipt {
  /// The ids of created ones, where they are not those that were asked for: theirs by ours.
  std::map<std::string, std::string> ids;
};

/// Capability: the waypoints of a map, to be read and changed. Called on the thread that made the robot; what
/// it hands out comes there, too. See robot/call.h for how a request ends.
class WaypointStore : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  /// The same of all of its lists.
  virtual KeptFields keeps() const { return {}; }
  /// A map without a list has an empty one.
  virtual Call read(const map::MapKey& map, OutcomeTo<StoredWaypoints> reply) = 0;
  /// The requests that make `changes` of the list as it is `now`, in the order that they are to be sent in.
  /// Asks nobody.
  virtual std::vector<WaypointRequest> plan(const StoredWaypoints& now,
                                            const std::vector<WaypointChange>& changes) const = 0;
  /// What performing it would ask of the robot. Asks nobody.
  virtual WaypointCall callOf(const map::MapKey& /*map*/, const WaypointRequest& /*request*/) const {
    return {};
  }
  /// Carries one out. FailureKind::Conflict: what it is to change has been changed by somebody else; then
  /// nothing is applied.
  virtual Call perform(const map::MapKey& map, const WaypointRequest& request,
                       OutcomeTo<WaypointReceipt> reply) = 0;

 Q_SIGNALS:
  void changed();  // some list may be another one now: read again
};

}  // namespace mapwright::robot
