// The ports of the Autoxing and the Agibot robot and their threads.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/axbot_routes.h"
#include "simulator/sockets.h"
#include "simulator/topic_messages.h"

namespace mapwright::simulator {

class TopicSession;

/// Serves from start() to destruction. One thread does all that has to do with sockets, and nothing on it
/// waits; two workers make what takes milliseconds.
class AxbotServer {
 public:
  AxbotServer(const Robot& robot, RequestLog& log);
  ~AxbotServer();
  AxbotServer(const AxbotServer&) = delete;
  AxbotServer& operator=(const AxbotServer&) = delete;

  /// Opens both ports of 127.0.0.1 (0 = a free one) and starts the thread. nullopt when it runs.
  std::optional<std::string> start(std::uint16_t port, std::uint16_t aimdk_port);
  std::uint16_t port() const { return port_; }
  std::uint16_t aimdkPort() const { return aimdk_port_; }
  int openWebSockets() const { return links_.open(); }

  /// From any thread: sends the list to all that have it enabled.
  void publishList();
  /// From any thread; returns when they are cut.
  void dropWebSockets();

  // For the sessions, on the server's thread.
  const Robot& robot() const { return robot_; }
  TopicMessages& messages() { return messages_; }
  Links<TopicSession>& links() { return links_; }
  Loop& loop() { return loop_; }

 private:
  std::optional<std::string> open(HttpService& service, std::uint16_t port, std::uint16_t& opened);
  void publish(std::string_view topic);
  void tick();
  void publishChanges(std::chrono::steady_clock::time_point now);
  void keepFaultSchedule(std::chrono::steady_clock::time_point now);

  const Robot robot_;
  AxbotRoutes axbot_routes_;
  AimdkRoutes aimdk_routes_;
  TopicMessages messages_;
  Links<TopicSession> links_;
  std::uint16_t port_ = 0, aimdk_port_ = 0;
  ListStamp published_;
  MapEdits published_maps_;
  bool published_mapping_ = false;
  std::chrono::steady_clock::time_point list_at_, tick_at_, dropped_at_, restarted_at_, overlays_edited_at_;
  std::vector<Periodic> periodic_;
  HttpService axbot_, aimdk_;
  Loop loop_{2};
};

}  // namespace mapwright::simulator
