// Requests to a KABAM map manager, on the link's thread. Its topics are authoritative: after a change it
// waits for them. Source: docs/protocols/kabam-map-manager.md.
#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include <QObject>
#include <QString>

#include "net/rosbridge/client.h"
#include "robot/map_administration.h"
#include "robot/robot.h"
#include "robot/ros/kabam_plan.h"
#include "robot/ros/kabam_state.h"
#include "robot/ros/ros_calls.h"
#include "robot/waypoint_store.h"
#include "robot/wire/task.h"

namespace mapwright::robot::ros {

struct KabamTimeouts {
  std::chrono::milliseconds call{10'000};  // for an answer
  /// For all waypoints of a map: there may be very many. If its topic has sent a list already: `call`.
  std::chrono::milliseconds read{60'000};
  std::chrono::milliseconds lists{5'000};    // for the first messages of the topics
  std::chrono::milliseconds confirm{5'000};  // for the topics to show a change
  std::chrono::milliseconds topic{
      2'000};  // for the waypoint topic to do so, before the waypoints are requested
  std::chrono::milliseconds look_again{500};  // interval between requests for waypoints
};

class KabamRequests : public QObject {
  Q_OBJECT
 public:
  /// `client` and what the functions look at outlive this. `fixed_frame`: that of the map, which waypoints
  /// lie in; empty = not known.
  KabamRequests(net::rosbridge::Client& client, KabamTimeouts timeouts, WhenKnown when_known,
                std::function<std::string()> fixed_frame);

  KabamState& state() { return state_; }
  /// Where the manager is ("/map_manager"); nullopt: there is none. True when it has come or gone.
  bool setNamespace(const std::optional<std::string>& ns);
  bool there() const { return there_; }
  /// Tells what has changed in the state; what waits for it is looked at.
  void emitChanges(const KabamState::Update& update);

  void list(const wire::TaskPtr& task, OutcomeTo<std::vector<map::CatalogueEntry>> reply);
  void describe(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply,
                map::AskedFor asked_for = map::AskedFor::All);
  void waypoints(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<StoredWaypoints> reply);
  void perform(const wire::TaskPtr& task, const map::MapKey& key, const WaypointRequest& request,
               OutcomeTo<WaypointReceipt> reply);
  void carryOut(const wire::TaskPtr& task, const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply);

 Q_SIGNALS:
  void stands(const QString& state);  // what it does now; comes before mapsChanged()
  void mapsChanged();
  void waypointsChanged();
  /// The manager gave a waypoint that it was asked to create as `ours` the id `theirs`; comes before the
  /// result of the request.
  void named(const QString& ours, const QString& theirs);

 private:
  /// How far a change is visible in a list.
  enum class Shown { NotYet, OtherTags, Done };
  using End = wire::WaitList::End;
  struct Change {
    wire::TaskPtr task;
    map::MapKey key;
    WaypointChange what;
    OutcomeTo<WaypointReceipt> reply;
    std::string id = {};  // for a created one, as given by the robot; empty = compare the name
    std::chrono::steady_clock::time_point until = {};
    std::chrono::milliseconds pause{0};      // before they are asked for
    std::optional<map::Failure> doubt = {};  // the failure, unless the change shows
    map::Subject subject() const { return map::placesOf(key); }
  };
  using ChangePtr = std::shared_ptr<Change>;
  struct Order;
  using OrderPtr = std::shared_ptr<Order>;

  /// `then` once the lists have come, or with a failure about `subject`.
  void whenListed(const wire::TaskPtr& task, const map::Subject& subject, map::AskedFor asked_for,
                  Checked then);
  void ask(const wire::TaskPtr& task, const char* service, QByteArray args, net::rosbridge::Reply reply,
           std::optional<std::chrono::milliseconds> timeout = {});
  /// The waypoints of an answer of get_waypoint; nullopt: there are none in it.
  std::optional<StoredWaypoints> storedIn(const net::rosbridge::CallAnswer& answer,
                                          const map::MapKey& key) const;
  /// What the topic said last, which may be out of date; nullopt: nothing about this map, or it is known to
  /// lag.
  std::optional<StoredWaypoints> toldByTopic(const map::MapKey& key) const;
  void lookFirst(const ChangePtr& change);
  void send(const ChangePtr& change);
  void confirm(const ChangePtr& change);
  void askWhetherShown(const ChangePtr& change);
  static Shown shownIn(const StoredWaypoints& stored, Change& change);
  void end(const ChangePtr& change, Shown shown) const;
  void send(const OrderPtr& order);
  void confirm(const OrderPtr& order, std::optional<map::Failure> doubt);

  net::rosbridge::Client& client_;
  KabamTimeouts timeouts_;
  WhenKnown when_known_;
  std::function<std::string()> fixed_frame_;
  KabamState state_;
  bool there_ = false;
  wire::WaitList waits_;
};

}  // namespace mapwright::robot::ros
