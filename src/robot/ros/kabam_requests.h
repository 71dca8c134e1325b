// Requests to a KABAM map manager, on the link's thread. Its topics are authoritative: after a change it
// waits for them. Source: docs/protocols/kabam-map-manager.md.
#pragma once

#include <chrono>
#include <functional>
#include <list>
#include <memory>

#include <QObject>
#include <QTimer>

#include "net/rosbridge/client.h"
#include "robot/map_administration.h"
#include "robot/robot.h"
#include "robot/ros/kabam_book.h"
#include "robot/ros/kabam_plan.h"
#include "robot/waypoint_store.h"
#include "robot/wire/errand.h"

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
  /// `client` and everything used by `fixed_frame` outlive this. `fixed_frame`: the frame of the map and its
  /// waypoints; empty = unknown.
  KabamRequests(net::rosbridge::Client& client, KabamPatience patience,
                std::function<std::string()> fixed_frame, QObject* parent = nullptr);

  KabamBook& book() { return book_; }
  /// New data has arrived on the topics: checks the waiting requests.
  void look();

  void list(const wire::ErrandPtr& errand, OutcomeTo<std::vector<map::CatalogueEntry>> reply);
  void describe(const wire::ErrandPtr& errand, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
  void waypoints(const wire::ErrandPtr& errand, const map::MapKey& key, OutcomeTo<StoredWaypoints> reply);
  void perform(const wire::ErrandPtr& errand, const map::MapKey& key, const WaypointRequest& request,
               OutcomeTo<WaypointReceipt> reply);
  void carryOut(const wire::ErrandPtr& errand, const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply);

 private:
  /// How far a change is visible in a list.
  enum class Shown { NotYet, OtherTags, Done };
  enum class Awaited { Held, TooLate, Cancelled };
  using Then = std::function<void(Awaited)>;
  struct Change {
    map::MapKey key;
    WaypointChange what;
    std::string id;  // for a created one, as given by the robot; empty = compare the name
    OutcomeTo<WaypointReceipt> reply;
    std::chrono::steady_clock::time_point until;
    std::chrono::milliseconds pause{0};  // before they are asked for
  };
  using ChangePtr = std::shared_ptr<Change>;

  /// Calls `then` once the lists have arrived, or fails about `subject`.
  void whenListed(const wire::ErrandPtr& errand, const map::Subject& subject,
                  std::function<void(std::optional<map::Failure>)> then);
  /// Calls `then` as soon as `holds` is true, or when the time is over.
  void await(const wire::ErrandPtr& errand, std::chrono::milliseconds within, std::function<bool()> holds,
             Then then);
  net::rosbridge::CallRequest request(const char* service, QByteArray args) const;
  void lookFirst(const wire::ErrandPtr& errand, const map::MapKey& key, const WaypointRequest& asked,
                 OutcomeTo<WaypointReceipt> reply);
  void send(const wire::ErrandPtr& errand, const map::MapKey& key, const WaypointRequest& request,
            OutcomeTo<WaypointReceipt> reply);
  void confirm(const wire::ErrandPtr& errand, const ChangePtr& change, std::optional<map::Failure> doubt);
  void askWhetherShown(const wire::ErrandPtr& errand, const ChangePtr& change,
                       std::optional<map::Failure> doubt);
  static Shown shownIn(const StoredWaypoints& stored, Change& change);
  void endChange(const ChangePtr& change, Shown shown, std::optional<map::Failure> doubt) const;
  struct Ordered;
  void sendOrder(const wire::ErrandPtr& errand, const std::shared_ptr<Ordered>& ordered);
  void confirmOrder(const wire::ErrandPtr& errand, const std::shared_ptr<Ordered>& ordered,
                    std::optional<map::Failure> doubt);

  net::rosbridge::Client& client_;
  KabamPatience patience_;
  std::function<std::string()> fixed_frame_;
  KabamBook book_;
  struct Waiting {
    std::function<bool()> holds;
    Then then;
    std::unique_ptr<QTimer> patience;
    wire::ErrandPtr errand;
    int number = 0;  // of the errand
  };
  using Entry = std::shared_ptr<Waiting>;
  void end(const Entry& entry, Awaited how);
  std::list<Entry> waiting_;
};

}  // namespace mapwright::robot::ros
