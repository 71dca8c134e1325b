// The map of a robot without a map topic, requested from a service of type nav_msgs/GetMap. Lives on the
// link's thread. Source: nav_msgs/GetMap; map_server ("static_map"), nav2_map_server ("map"), gmapping
// ("dynamic_map").
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QTimer>

#include "fault/fault.h"
#include "net/rosbridge/client.h"

namespace mapwright::robot::ros {

class AskedMap : public QObject {
  Q_OBJECT
 public:
  struct Patience {
    std::chrono::milliseconds silence{3'000};  // of the topics, before a service is called
    std::chrono::milliseconds answer{30'000};
    std::chrono::milliseconds again{10'000};  // after all of them have failed
  };
  AskedMap(net::rosbridge::Client& client, Patience patience);

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
  void begin();
  void ask();
  void take(const std::string& service, const net::rosbridge::CallAnswer& answer);
  void stop();

  net::rosbridge::Client& client_;
  Patience patience_;
  QTimer timer_;
  Services services_;
  bool wanted_ = false, by_topic_ = false, had_ = false;
  std::optional<quint64> call_;
  std::size_t next_ = 0;                                    // of the services
  std::optional<std::pair<std::string, Fault>> first_why_;  // of this round
};

}  // namespace mapwright::robot::ros
