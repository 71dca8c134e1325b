// The live map of a ROS robot, by its topic or by a service. Lives on the link's thread.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QPointer>
#include <QTimer>

#include "fault/fault.h"
#include "map/live_topics.h"
#include "net/rosbridge/client.h"
#include "robot/call.h"
#include "robot/wire/task.h"

namespace mapwright::robot::ros {

/// The last map that came, for requests for the whole map.
class LiveMap : public QObject {
  Q_OBJECT
 public:
  explicit LiveMap(std::chrono::milliseconds timeout) : timeout_(timeout) {}

  void onGrid(const map::GridMessage& grid);
  /// The received map is no longer the robot's current one.
  void forget() { last_.reset(); }
  const std::optional<map::GridMessage>& last() const { return last_; }
  /// The last map received, or the next one, under that key and name. `longer`: waits longer than usual, for
  /// a large one.
  void fetch(const wire::TaskPtr& task, const map::MapKey& key, const std::string& name,
             OutcomeTo<map::WholeMap> reply, std::chrono::milliseconds longer = {});
  /// Somebody waits for it, or wants to hear of each.
  bool wanted() const { return !waits_.empty() || !listeners_.expired(); }
  /// As long as it is held, the map is asked for; came() tells of each. Let go of it on the link's thread,
  /// while this lives or after.
  std::shared_ptr<void> listen();
  /// The connection broke off.
  void lose() { waits_.drop(); }

 Q_SIGNALS:
  void wantedChanged();
  void came();

 private:
  std::chrono::milliseconds timeout_;
  std::optional<map::GridMessage> last_;
  wire::WaitList waits_;
  std::weak_ptr<void> listeners_;
};

/// The map of a robot without a map topic, requested from a service. Source: nav_msgs/GetMap; map_server
/// ("static_map"), nav2_map_server ("map"), gmapping ("dynamic_map").
class MapFromService : public QObject {
  Q_OBJECT
 public:
  struct Timeouts {
    std::chrono::milliseconds silence{3'000};  // of the topics, before a service is called
    std::chrono::milliseconds answer{30'000};
    std::chrono::milliseconds again{10'000};  // after all of them have failed
  };
  MapFromService(net::rosbridge::Client& client, Timeouts timeouts);

  /// The services that provide it, better ones first.
  struct Services {
    std::vector<std::string> names;
    bool known = false;  // the robot lists them; otherwise they are tried without reporting failures
    bool operator==(const Services&) const = default;
  };
  /// `by_topic`: it may arrive on a topic, which is waited for first.
  void want(bool wanted, bool by_topic, Services services);
  /// A topic has brought it.
  void heard();
  /// A new connection, or none: starts over.
  void beginAnew();

 Q_SIGNALS:
  /// `answer` keeps the map alive: its values' member `map` is a nav_msgs/OccupancyGrid.
  void came(const std::string& service, const mapwright::net::rosbridge::CallAnswer& answer);
  void failed(const std::string& service, const mapwright::Fault& why);

 private:
  void ask();
  void onAnswer(const std::string& service, const net::rosbridge::CallAnswer& answer);
  void stop();

  net::rosbridge::Client& client_;
  Timeouts timeouts_;
  QTimer timer_;
  Services services_;
  bool wanted_ = false, by_topic_ = false, had_ = false;
  std::optional<quint64> call_;
  std::size_t next_ = 0;                                    // of the services
  std::optional<std::pair<std::string, Fault>> first_why_;  // of this round
};

}  // namespace mapwright::robot::ros
