// What a rosbridge server sends, for whoever records it. Lives on the link's thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "net/rosbridge/client.h"
#include "robot/ros/ros_api.h"
#include "robot/ros/ros_topics.h"
#include "robot/wire/robot_link.h"

namespace mapwright::robot::ros {

/// Puts messages, and what their types are made of, where whoever records them sits.
class RosDeliveries {
 public:
  /// All of them outlive this. `found` and `sources` are kept up to date by the link. `wall_s`: the time of
  /// day, in seconds since the epoch.
  RosDeliveries(wire::DeliveryTapSlot& tap, RosApi& api, const RosGraph& found,
                const std::vector<Source>& sources, std::function<double()> wall_s)
      : tap_(tap), api_(api), graph_(found), sources_(sources), wall_s_(std::move(wall_s)) {}

  void beginAnew();  // another connection
  void pause();      // there is none: nobody can be asked
  void onMessage(const net::rosbridge::TopicMessage& message);
  /// The map that a service gave.
  void onMap(const std::string& service, const net::rosbridge::CallAnswer& answer);
  /// Whoever sits there now gets the definitions of all types that were delivered: they are asked for one
  /// after the other.
  void define();

 private:
  void deliver(const std::string& name, std::string type, std::string slot,
               const std::shared_ptr<const net::rosbridge::Frame>& frame, const char* member,
               std::optional<double> said_s, double received_s);
  void deliverDefinition(const std::string& type, const std::optional<RosDefinition>& definition);

  wire::DeliveryTapSlot& tap_;
  RosApi& api_;
  const RosGraph& graph_;
  const std::vector<Source>& sources_;
  std::function<double()> wall_s_;
  int round_ = 0;  // of connections
  bool connected_ = false, defining_ = false;
  std::set<std::string> types_, defined_;  // that were delivered on this connection, and asked for
};

}  // namespace mapwright::robot::ros
