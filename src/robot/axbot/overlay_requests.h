// Requests for the overlays of an Autoxing robot's maps. Lives on the link's thread. Source:
// docs/protocols/autoxing.md, "Requests", "Overlays".
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "robot/axbot/robot_urls.h"
#include "robot/overlay_store.h"
#include "robot/wire/task.h"

namespace mapwright::robot::axbot {

/// From a map (`GET /maps/{id}`), whose overlays are a text, or else an object.
tl::expected<OverlayText, Fault> parseOverlayText(std::string_view map);

class OverlayRequests {
 public:
  using Task = wire::TaskPtr;
  explicit OverlayRequests(RobotServer server) : server_(std::move(server)) {}

  void read(const Task& task, const map::MapKey& key, OutcomeTo<OverlayText> reply);
  void write(const Task& task, const map::MapKey& key, const std::string& text,
             OutcomeTo<std::monostate> reply);

 private:
  void readStored(const Task& task, const map::MapKey& key, OutcomeTo<OverlayText> reply);
  void readLive(const Task& task, OutcomeTo<OverlayText> reply);

  const RobotServer server_;
};

}  // namespace mapwright::robot::axbot
