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
#include "robot/ros/kabam_book.h"
#include "robot/ros/kabam_plan.h"
#include "robot/ros/ros_calls.h"
#include "robot/waypoint_store.h"
#include "robot/wire/task.h"

namespace mapwright::robot::ros {

struct KabamPatience {
  std::chrono::milliseconds call{10'000};    // for an answer
  std::chrono::milliseconds read{60'000};    // for all waypoints of a map: there may be very many
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
  KabamRequests(net::rosbridge::Client& client, KabamPatience patience, WhenKnown when_known,
                std::function<std::string()> fixed_frame);

  KabamBook& book() { return book_; }
  /// Where the manager is ("/map_manager"); nullopt: there is none. True when it has come or gone.
  bool setPlace(const std::optional<std::string>& place);
  bool there() const { return there_; }
  /// A message of one of its topics, or of another: then it says so.
  KabamBook::Taken take(const net::rosbridge::TopicMessage& message) {
    return book_.take(message.topic, message.frame, message.msg);
  }
  /// Tells what was taken; what waits for it is looked at.
  void tell(const KabamBook::Taken& taken);

  void list(const wire::TaskPtr& task, OutcomeTo<std::vector<map::CatalogueEntry>> reply);
  void describe(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
  void waypoints(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<StoredWaypoints> reply);
  void perform(const wire::TaskPtr& task, const map::MapKey& key, const WaypointRequest& request,
               OutcomeTo<WaypointReceipt> reply);
  void carryOut(const wire::TaskPtr& task, const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply);

 Q_SIGNALS:
  void stands(const QString& state);  // what it does now; comes before mapsChanged()
  void mapsChanged();
  void waypointsChanged();

 private:
  /// How far a change is visible in a list.
  enum class Shown { NotYet, OtherTags, Done };
  using Awaited = wire::WaitList::End;
  struct Change {
    map::MapKey key;
    WaypointChange what;
    std::string id;  // for a created one, as given by the robot; empty = compare the name
    OutcomeTo<WaypointReceipt> reply;
    std::chrono::steady_clock::time_point until;
    std::chrono::milliseconds pause{0};  // before they are asked for
  };
  using ChangePtr = std::shared_ptr<Change>;

  /// `then` once the lists have come, or with a failure about `subject`.
  void whenListed(const wire::TaskPtr& task, const map::Subject& subject,
                  std::function<void(std::optional<map::Failure>)> then);
  net::rosbridge::CallRequest request(const char* service, QByteArray args) const;
  void lookFirst(const wire::TaskPtr& task, const map::MapKey& key, const WaypointRequest& asked,
                 OutcomeTo<WaypointReceipt> reply);
  void send(const wire::TaskPtr& task, const map::MapKey& key, const WaypointRequest& request,
            OutcomeTo<WaypointReceipt> reply);
  void confirm(const wire::TaskPtr& task, const ChangePtr& change, std::optional<map::Failure> doubt);
  void askWhetherShown(const wire::TaskPtr& task, const ChangePtr& change, std::optional<map::Failure> doubt);
  static Shown shownIn(const StoredWaypoints& stored, Change& change);
  void endChange(const ChangePtr& change, Shown shown, std::optional<map::Failure> doubt) const;
  struct Ordered;
  void sendOrder(const wire::TaskPtr& task, const std::shared_ptr<Ordered>& ordered);
  void confirmOrder(const wire::TaskPtr& task, const std::shared_ptr<Ordered>& ordered,
                    std::optional<map::Failure> doubt);

  net::rosbridge::Client& client_;
  KabamPatience patience_;
  WhenKnown when_known_;
  std::function<std::string()> fixed_frame_;
  KabamBook book_;
  bool there_ = false;
  wire::WaitList waits_;
};

}  // namespace mapwright::robot::ros
