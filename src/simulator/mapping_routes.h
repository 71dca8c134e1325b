// Mapping tasks over HTTP (docs/protocols/autoxing.md, "Requests"): pure of sockets.
#pragma once

#include <optional>
#include <string_view>

#include "simulator/fault_plan.h"
#include "simulator/http_answer.h"
#include "simulator/map_library.h"
#include "simulator/mapping_book.h"

namespace mapwright::simulator {

/// Safe from any thread.
class MappingRoutes {
 public:
  MappingRoutes(const RobotState& state, MappingBook& mappings, MapLibrary& library, const FaultPlan& faults)
      : state_(state), mappings_(mappings), library_(library), faults_(faults) {}

  /// nullopt for paths that are not its own.
  std::optional<HttpAnswer> answer(const HttpQuestion& question);

 private:
  HttpAnswer collection(const HttpQuestion& question);
  HttpAnswer start(const HttpQuestion& question);
  HttpAnswer current(const HttpQuestion& question);
  HttpAnswer task(std::string_view rest, const HttpQuestion& question);
  HttpAnswer shown(int status, const MappingTask& task);
  void append(std::string& out, const MappingTask& task);

  const RobotState& state_;
  MappingBook& mappings_;
  MapLibrary& library_;
  const FaultPlan& faults_;
};

}  // namespace mapwright::simulator
