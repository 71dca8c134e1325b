// The simulated robots' ports and their threads.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "simulator/loop.h"
#include "simulator/routes.h"
#include "simulator/services.h"
#include "simulator/topic_schedule.h"

namespace mapwright::simulator {

/// Serves from start() to destruction. One thread does all that has to do with sockets, and nothing on it
/// waits; two workers make what takes milliseconds.
class Server {
 public:
  Server(const Robot& robot, RequestLog& log);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Opens both ports of 127.0.0.1 (0 = a free one) and starts the thread. nullopt when it runs.
  std::optional<std::string> start(std::uint16_t port, std::uint16_t aimdk_port);
  std::uint16_t port() const { return axbot_.port; }
  std::uint16_t aimdkPort() const { return aimdk_.port; }
  int openWebSockets() const { return links_.open(); }

  /// From any thread: sends the list to all that have it enabled.
  void publishList();
  /// From any thread; returns when they are cut.
  void dropWebSockets();

 private:
  /// One robot's door.
  struct Door {
    Answerer& routes;
    std::uint16_t port = 0;
  };

  std::optional<std::string> open(Door& door, std::uint16_t port);
  void publish(std::string_view topic);
  void tick();
  void publishChanges(std::chrono::steady_clock::time_point now);
  void keepFaultSchedule(std::chrono::steady_clock::time_point now);

  const Robot robot_;
  RequestLog& log_;
  HttpRoutes routes_;
  AimdkRoutes aimdk_routes_;
  TopicMessages messages_;
  Links<WebSocketSession> links_;
  Door axbot_{routes_};
  Door aimdk_{aimdk_routes_};
  ListStamp published_;
  MapEdits published_maps_;
  bool published_mapping_ = false;
  std::chrono::steady_clock::time_point list_at_, tick_at_, dropped_at_, restarted_at_;
  std::vector<PeriodicTopic> periodic_;
  Loop loop_{2};
};

}  // namespace mapwright::simulator
