// What the simulated robot answers over HTTP (axbot.md, "Requests"): pure of sockets.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulator/fault_plan.h"
#include "simulator/robot_state.h"
#include "simulator/simulator.h"

namespace mapwright::simulator {

struct HttpQuestion {
  std::string_view method;
  std::string_view target;  // path and query, as sent
  std::string_view secret;
  std::string_view if_none_match;
};

struct HttpAnswer {
  int status = 200;
  std::string content_type = "application/json";
  std::vector<std::pair<std::string, std::string>> headers;
  std::shared_ptr<const std::string> body;
  int delay_ms = 0;
  bool drop = false;      // close without an answer
  bool truncate = false;  // half the body, then close
};

/// The path of a target, without its query.
std::string_view pathOf(std::string_view target);
/// The value of `key` in the target's query; empty when absent.
std::string_view queryValue(std::string_view target, std::string_view key);
bool isSubmapPath(std::string_view path);

/// Safe from any thread.
class HttpRoutes {
 public:
  HttpRoutes(const RobotState& state, FaultPlan& faults, const Options& options);

  HttpAnswer answer(const HttpQuestion& question);
  bool allows(std::string_view secret) const { return secret_.empty() || secret == secret_; }

 private:
  HttpAnswer submap(const HttpQuestion& question);
  HttpAnswer deviceInfo() const;

  const RobotState& state_;
  FaultPlan& faults_;
  const std::string secret_;
  const bool enable_topic_list_;
  const std::uint32_t seed_;
  BodyCache bodies_;
};

HttpAnswer jsonAnswer(int status, std::string body);

}  // namespace mapwright::simulator
