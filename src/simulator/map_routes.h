// Stored maps and static files over HTTP (docs/protocols/autoxing.md, "Requests"): pure of sockets.
#pragma once

#include <optional>
#include <string_view>

#include "simulator/fault_plan.h"
#include "simulator/http_answer.h"
#include "simulator/map_library.h"
#include "simulator/mapping_book.h"

namespace mapwright::simulator {

/// Safe from any thread.
class MapRoutes {
 public:
  MapRoutes(MapLibrary& library, const MappingBook& mappings, const FaultPlan& faults)
      : library_(library), mappings_(mappings), faults_(faults) {}

  /// nullopt for paths that are not its own.
  std::optional<HttpAnswer> answer(const HttpQuestion& question);

 private:
  HttpAnswer collection(const HttpQuestion& question);
  HttpAnswer create(const HttpQuestion& question);
  HttpAnswer map(std::string_view rest, const HttpQuestion& question);
  HttpAnswer detail(const StoredMap& map);
  HttpAnswer change(const StoredMap& map, const HttpQuestion& question);
  HttpAnswer download(const StoredMap& map);

  MapLibrary& library_;
  const MappingBook& mappings_;
  const FaultPlan& faults_;
};

}  // namespace mapwright::simulator
