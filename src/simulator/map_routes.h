// Maps, mapping tasks and static files over HTTP (axbot.md, "Requests"): pure of sockets.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "simulator/fault_plan.h"
#include "simulator/http_answer.h"
#include "simulator/map_library.h"

namespace mapwright::simulator {

/// Safe from any thread.
class MapRoutes {
 public:
  MapRoutes(MapLibrary& library, const FaultPlan& faults) : library_(library), faults_(faults) {}

  /// The answer to a GET; nullopt for paths that are not its own.
  std::optional<HttpAnswer> answer(const HttpQuestion& question);

 private:
  HttpAnswer list() const;
  HttpAnswer map(std::string_view rest, const HttpQuestion& question);
  HttpAnswer current() const;
  HttpAnswer mappings() const;
  HttpAnswer mapping(std::string_view rest, const HttpQuestion& question);
  HttpAnswer image(const HttpQuestion& question);
  HttpAnswer picture(const MapPicturePtr& picture, const HttpQuestion& question, bool for_ever);

  MapLibrary& library_;
  const FaultPlan& faults_;
};

/// A map's PNG as the faults leave it.
std::string faultyPng(const std::string& png, const Faults& faults);

}  // namespace mapwright::simulator
