// The port: editable waypoints. Source: docs/protocols/kabam-map-manager.md, "Services".
// Supports robots with a service for each change (create, rename, move, delete) as well as lists that are
// written as a whole: plan() returns the requests for a set of changes.
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

/// The stored waypoints of one map.
struct StoredWaypoints {
  std::vector<map::Waypoint> points;  // with unique ids that are not empty
  std::string revision;               // changes with the list; opaque
  std::vector<Fault> notes;           // what is odd about them
  bool there = true;                  // false: there is no list, not even an empty one
  /// Ids of those stored with a zero quaternion, which is no heading: their yaw is 0 here.
  std::set<std::string> zero_turns = {};
};

/// What a store can keep of a waypoint; the rest is lost or refused.
struct KeptFields {
  bool type = true;
  bool tags = true;
  bool no_heading = true;       // false: a missing heading would come back as 0
  bool name_twice = true;       // false: duplicate names are refused
  bool removal = true;          // false: what is stored cannot be deleted
  std::string usual_type = {};  // of what has none
  /// Positions come back on the nearest pixel of this size; 0 = as they were sent. Of the list that was read
  /// last.
  double pixel_m = 0;
};

/// A waypoint before and after a change; nullopt = it does not exist.
struct WaypointChange {
  std::string id;
  std::optional<map::Waypoint> before = {}, after = {};
};

/// One request: the changes that it makes, to the list of that revision.
struct WaypointRequest {
  std::vector<WaypointChange> changes;
  std::string revision;
};

/// A request as shown to the user before it is sent: the robot's name of the service, and a JSON object.
struct WaypointCall {
  std::string service, arguments;  // empty: no call, the list is written
};

/// The result of a successful request.
struct WaypointReceipt {
  /// The ids of created waypoints, if they differ from the requested ones: theirs by ours.
  std::map<std::string, std::string> ids;
};

/// Capability: the waypoints of a map, readable and editable. Call it on the thread that made the robot;
/// results arrive there, too. See robot/call.h for how a request ends.
class WaypointStore : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  /// The same for all of its lists.
  virtual KeptFields keeps() const { return {}; }
  /// A map without a list has an empty one.
  virtual Call read(const map::MapKey& map, OutcomeTo<StoredWaypoints> reply) = 0;
  /// The requests that make `changes` to the list `now`, in order. Sends nothing.
  virtual std::vector<WaypointRequest> plan(const StoredWaypoints& now,
                                            const std::vector<WaypointChange>& changes) const = 0;
  /// The call that performing it would make. Sends nothing.
  virtual WaypointCall callOf(const map::MapKey& /*map*/, const WaypointRequest& /*request*/) const {
    return {};
  }
  /// Performs one. FailureKind::Conflict: someone else has changed its target, and nothing is applied.
  virtual Call perform(const map::MapKey& map, const WaypointRequest& request,
                       OutcomeTo<WaypointReceipt> reply) = 0;

 Q_SIGNALS:
  void changed();  // some list may have changed: read it again
  /// The robot gave a waypoint that it was asked to create as `ours` the id `theirs`. Comes before the result
  /// of the request, and whether it is there yet or not.
  void named(const QString& ours, const QString& theirs);
};

}  // namespace mapwright::robot
