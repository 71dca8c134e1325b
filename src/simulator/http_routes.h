// What the simulated Autoxing robot answers over HTTP (axbot.md, "Requests"): pure of sockets.
#pragma once

#include <string>
#include <string_view>

#include "simulator/fault_plan.h"
#include "simulator/http_answer.h"
#include "simulator/map_routes.h"
#include "simulator/robot_state.h"
#include "simulator/simulator.h"

namespace mapwright::simulator {

bool isSubmapPath(std::string_view path);

/// Safe from any thread.
class HttpRoutes : public Answerer {
 public:
  HttpRoutes(const RobotState& state, MapLibrary& library, FaultPlan& faults, const Options& options);

  HttpAnswer answer(const HttpQuestion& question) override;
  bool isSlow(std::string_view path) const override;
  bool opensTopics(std::string_view secret) const override { return allows(secret); }

 private:
  bool allows(std::string_view secret) const { return secret_.empty() || secret == secret_; }
  HttpAnswer submap(const HttpQuestion& question);
  HttpAnswer deviceInfo() const;

  const RobotState& state_;
  FaultPlan& faults_;
  const std::string secret_;
  const bool enable_topic_list_;
  const std::uint32_t seed_;
  BodyCache bodies_;
  MapRoutes maps_;
};

}  // namespace mapwright::simulator
