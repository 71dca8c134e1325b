// Requests for what an Autoxing robot sees around it and has collected. Lives on the link's thread. Source:
// docs/protocols/autoxing.md, "Where the robot sees things".
#pragma once

#include <string_view>
#include <vector>

#include <QStringList>
#include <tl/expected.hpp>

#include "robot/axbot/robot_urls.h"
#include "robot/sighting_source.h"
#include "robot/wire/task.h"

namespace mapwright::robot::axbot {

/// {"pose": {"pos": [x, y], "ori": rad}, "ref"}. Without a pose: it sees none.
tl::expected<Sighting, Fault> parseSighting(std::string_view body, Sight what);
/// The names of a list of files, oldest first.
struct CollectedNames {
  std::vector<std::string> newest;  // the oldest of them first
  std::size_t older = 0;            // that are left out
};
tl::expected<CollectedNames, Fault> parseCollectedNames(std::string_view body);

QStringList sightingTopics();

class SightingRequests {
 public:
  using Task = wire::TaskPtr;
  explicit SightingRequests(RobotServer server) : server_(std::move(server)) {}

  void look(const Task& task, Sight what, SightEdge edge, OutcomeTo<Sighting> reply);
  void collectedLandmarks(const Task& task, OutcomeTo<CollectedLandmarks> reply);

 private:
  struct Collecting;
  void nextFile(const std::shared_ptr<Collecting>& collecting);

  const RobotServer server_;
};

}  // namespace mapwright::robot::axbot
