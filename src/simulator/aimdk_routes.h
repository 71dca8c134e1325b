// What the simulated Agibot robot answers (docs/protocols/agibot-aimdk.md): JSON by POST to
// /rpc/<service>/<method>. Pure of sockets. Its building is the Autoxing robot's.
#pragma once

#include <string>
#include <string_view>

#include "simulator/fault_plan.h"
#include "simulator/http_answer.h"
#include "simulator/map_library.h"

namespace mapwright::simulator {

/// Safe from any thread.
class AimdkRoutes : public Answerer {
 public:
  AimdkRoutes(MapLibrary& library, const FaultPlan& faults) : library_(library), faults_(faults) {}

  HttpAnswer answer(const HttpQuestion& question) override;
  bool isSlow(std::string_view) const override { return true; }
  bool opensTopics(std::string_view) const override { return false; }

 private:
  std::string storedMapNames() const;
  std::string currentMap() const;
  std::string wholeMap(std::string_view body);
  std::string topoMessages(std::string_view body);

  MapLibrary& library_;
  const FaultPlan& faults_;
};

}  // namespace mapwright::simulator
