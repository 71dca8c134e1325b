// The port and the threads of the simulated ROS robot.
#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/request_log.h"
#include "simulator/ros/ros_robot.h"
#include "simulator/ros/ros_session.h"

namespace mapwright::simulator::ros {

/// Runs from start() to destruction. One thread handles all sockets; a worker does slow tasks. Encoding
/// blocks everyone, as on real servers.
class RosServer {
 public:
  RosServer(const Options& options, const RobotState& robot, FaultPlan& faults, RequestLog& log,
            KabamStore& kabam, MapPictures& pictures);
  ~RosServer();
  RosServer(const RosServer&) = delete;
  RosServer& operator=(const RosServer&) = delete;

  /// Opens the port of 127.0.0.1 (0 = a free one) and starts the thread. nullopt on success.
  std::optional<std::string> start(std::uint16_t port);
  std::uint16_t port() const { return port_; }
  int openLinks() const { return links_.open(); }

  // From any thread; return when done.
  void dropLinks();
  /// While it is on nothing is read, written or accepted; other requests to this server are done afterwards,
  /// without waiting.
  void stall(bool on);
  void refresh();  // every topic sends its present state
  void otherOperator();
  void otherPainter();

  // For the sessions, on the server's thread.
  const Options& options() const { return options_; }
  RosFaults faults() const { return plan_.faults().ros; }
  FaultPlan& plan() { return plan_; }
  RosRobot& robot() { return robot_; }
  Links<RosSession>& links() { return links_; }
  Loop& loop() { return loop_; }
  void logRequest(std::string_view method, std::string_view target, int status);
  /// Publishes the changes of a call.
  void publishChanges();
  /// Whether a subscription will ever get a message.
  bool mayDeliver(std::string_view topic, std::string_view type) const;
  void deliverLatched(const std::shared_ptr<RosSession>& session, const std::string& topic);
  void advertise(const std::string& topic, const std::string& type);
  /// Forwards a client's message to all subscribers. Returns a sentence if it is refused.
  std::string publishFrom(const std::string& topic, const Value& msg);

 private:
  void tick();
  void publishLate(std::chrono::steady_clock::time_point now);
  void keepFaultSchedule(std::chrono::steady_clock::time_point now);
  void publish(std::string_view topic);
  void publishWaypoints();
  void make(const std::string& topic, std::weak_ptr<RosSession> only_for, bool for_all);
  void deliverAll(const PublicationPtr& message);
  PublicationPtr publicationOf(const std::string& topic);
  void runAndWait(const std::function<void()>& action);

  const Options& options_;
  FaultPlan& plan_;
  RequestLog& log_;
  KabamStore& kabam_;
  RosRobot robot_;
  std::uint16_t port_ = 0;
  std::vector<Periodic> periodic_;
  std::map<std::string, std::string, std::less<>> advertised_;
  Links<RosSession> links_;
  std::map<std::string, PublicationPtr, std::less<>> last_;                            // of latched topics
  std::deque<std::pair<std::chrono::steady_clock::time_point, PublicationPtr>> late_;  // of waypoints
  std::map<std::string, bool> making_;  // true: once more afterwards
  KabamEdits published_;
  Dispatcher::Edits dispatched_;
  std::chrono::steady_clock::time_point tick_at_, restarted_at_, edited_at_, painted_at_, garbage_at_;
  std::size_t garbage_ = 0;
  std::atomic<bool> stalled_ = false;
  Loop loop_{1};
};

}  // namespace mapwright::simulator::ros
