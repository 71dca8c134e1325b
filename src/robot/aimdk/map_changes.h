// Changes of the maps of an Agibot robot with newer firmware. Lives on the link's thread. Source:
// docs/protocols/agibot-aimdk.md, "Newer services".
#pragma once

#include <chrono>
#include <memory>

#include "robot/map_administration.h"
#include "robot/wire/task.h"

namespace mapwright::robot::aimdk {

class AimdkLink;

struct ChangeTimes {
  std::chrono::milliseconds confirm{5'000};   // for the robot to show a change
  std::chrono::milliseconds look_again{500};  // interval between looks
};

class MapChanges {
 public:
  /// `link` outlives this.
  MapChanges(AimdkLink& link, const ChangeTimes& times) : link_(link), times_(times) {}

  /// Sent once; then the robot is asked how it is now, also if the answer is lost.
  void carryOut(const wire::TaskPtr& task, const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply);

 private:
  struct Change;
  using ChangePtr = std::shared_ptr<Change>;

  void send(const ChangePtr& change);
  void look(const ChangePtr& change);
  /// How it is now; `holds`: it is as it was wanted.
  void endOrRetry(const ChangePtr& change, Outcome<map::CatalogueEntry> now, bool holds);

  AimdkLink& link_;
  const ChangeTimes times_;
  wire::WaitList waits_;
};

}  // namespace mapwright::robot::aimdk
