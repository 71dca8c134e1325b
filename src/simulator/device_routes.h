// What the simulated robot tells about its make over HTTP (docs/protocols/autoxing.md, "Requests"): pure of
// sockets.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "simulator/http_answer.h"

namespace mapwright::simulator {

class DeviceRoutes {
 public:
  DeviceRoutes(std::uint32_t seed, bool enable_topic_list)
      : seed_(seed), enable_topic_list_(enable_topic_list) {}

  /// nullopt for paths that are not its own.
  std::optional<HttpAnswer> answer(const HttpQuestion& question) const;

 private:
  std::string device() const;
  std::string info() const;

  const std::uint32_t seed_;
  const bool enable_topic_list_;
};

}  // namespace mapwright::simulator
