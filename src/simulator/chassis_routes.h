// The current map, the pose, the live overlays and what the wheels are told, over HTTP
// (docs/protocols/autoxing.md, "Requests"): pure of sockets.
#pragma once

#include <optional>

#include "simulator/fault_plan.h"
#include "simulator/http_answer.h"
#include "simulator/map_library.h"
#include "simulator/robot_state.h"

namespace mapwright::simulator {

/// Safe from any thread.
class ChassisRoutes {
 public:
  ChassisRoutes(RobotState& state, MapLibrary& library, const FaultPlan& faults)
      : state_(state), library_(library), faults_(faults) {}

  /// nullopt for paths that are not its own.
  std::optional<HttpAnswer> answer(const HttpQuestion& question);

 private:
  HttpAnswer currentMap(const HttpQuestion& question);
  HttpAnswer setCurrentMap(const HttpQuestion& question);
  HttpAnswer pose(const HttpQuestion& question);
  HttpAnswer overlays(const HttpQuestion& question);
  HttpAnswer controlMode(const HttpQuestion& question);
  HttpAnswer emergencyStop(const HttpQuestion& question);
  HttpAnswer relocate(const HttpQuestion& question);

  RobotState& state_;
  MapLibrary& library_;
  const FaultPlan& faults_;
};

}  // namespace mapwright::simulator
