// What the simulated Autoxing robot answers over HTTP (docs/protocols/autoxing.md, "Requests"): pure of
// sockets.
#pragma once

#include <string>
#include <string_view>

#include "simulator/bag_routes.h"
#include "simulator/chassis_routes.h"
#include "simulator/device_routes.h"
#include "simulator/fault_plan.h"
#include "simulator/http_answer.h"
#include "simulator/map_routes.h"
#include "simulator/mapping_routes.h"
#include "simulator/robot_state.h"
#include "simulator/simulator.h"

namespace mapwright::simulator {

bool isSubmapPath(std::string_view path);

/// Safe from any thread.
class HttpRoutes : public Answerer {
 public:
  HttpRoutes(RobotState& state, MapLibrary& library, MappingBook& mappings, FaultPlan& faults,
             const Options& options);

  HttpAnswer answer(const HttpQuestion& question) override;
  bool isSlow(std::string_view path) const override;
  bool opensTopics(std::string_view secret) const override { return allows(secret); }

 private:
  bool allows(std::string_view secret) const { return secret_.empty() || secret == secret_; }
  HttpAnswer write(const HttpQuestion& question);
  HttpAnswer routed(const HttpQuestion& question);
  HttpAnswer submap(const HttpQuestion& question);
  HttpAnswer image(const HttpQuestion& question);

  const RobotState& state_;
  MapLibrary& library_;
  FaultPlan& faults_;
  const std::string secret_;
  BodyCache bodies_;
  DeviceRoutes device_;
  MapRoutes maps_;
  MappingRoutes mappings_;
  ChassisRoutes chassis_;
  BagRoutes bags_;
};

}  // namespace mapwright::simulator
