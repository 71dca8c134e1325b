// The simulated robot's port and its thread.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <thread>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>

#include "simulator/services.h"

namespace mapwright::simulator {

/// Serves from start() to destruction. One thread does all the work; nothing on it waits.
class Server {
 public:
  Server(const Options& options, RobotState& state, FaultPlan& faults, RequestLog& log);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Opens 127.0.0.1:port and starts the thread. nullopt when it runs.
  std::optional<std::string> start(std::uint16_t port);
  std::uint16_t port() const { return port_; }
  int openWebSockets() const { return hub_.open(); }

  /// From any thread: sends the list to all that have it enabled.
  void publishList();
  /// From any thread; returns when they are cut.
  void dropWebSockets();

 private:
  void accept();
  void tick();
  void publishChanges(std::chrono::steady_clock::time_point now);
  void keepFaultSchedule(std::chrono::steady_clock::time_point now);

  const Options& options_;
  RobotState& state_;
  FaultPlan& faults_;
  RequestLog& log_;
  HttpRoutes routes_;
  TopicMessages messages_;
  WebSocketHub hub_;
  boost::asio::io_context io_{1};
  boost::asio::ip::tcp::acceptor acceptor_{io_};
  boost::asio::steady_timer timer_{io_};
  std::uint16_t port_ = 0;
  ListStamp published_;
  std::chrono::steady_clock::time_point list_at_, state_at_, dropped_at_, restarted_at_;
  std::thread thread_;
};

}  // namespace mapwright::simulator
