// Bags, recordings and the bag player over HTTP (docs/protocols/autoxing.md, "Requests"): pure of sockets.
#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

#include "simulator/bag_store.h"
#include "simulator/http_answer.h"
#include "simulator/map_library.h"
#include "simulator/simulator.h"

namespace mapwright::simulator {

/// Safe from any thread.
class BagRoutes {
 public:
  BagRoutes(const RobotState& state, const MapLibrary& library, std::uint32_t seed, BagOptions options)
      : state_(state), library_(library), seed_(seed), options_(options), store_(state, options.odd) {}

  /// nullopt for paths that are not its own.
  std::optional<HttpAnswer> answer(const HttpQuestion& question);

 private:
  HttpAnswer collection(BagFolder folder, const HttpQuestion& question);
  HttpAnswer record(const HttpQuestion& question);
  HttpAnswer download(std::string bytes, std::string_view range) const;
  HttpAnswer file(BagFolder folder, std::string_view rest, const HttpQuestion& question);
  HttpAnswer player(const std::optional<Bag>& bag, const HttpQuestion& question);
  std::shared_ptr<const BagRecording> recordingOf(const Bag& bag);

  const RobotState& state_;
  const MapLibrary& library_;
  const std::uint32_t seed_;
  const BagOptions options_;
  BagStore store_;
  std::mutex mutex_;
  std::list<std::pair<BagSpan, std::shared_ptr<const BagRecording>>>
      recordings_;  // the last few, newest first
};

}  // namespace mapwright::simulator
