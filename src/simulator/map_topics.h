// The picture topics (docs/protocols/autoxing.md, "Topics that the map shows").
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "simulator/fault_plan.h"
#include "simulator/frame.h"
#include "simulator/map_library.h"
#include "simulator/robot_state.h"

namespace mapwright::simulator {

/// Safe from any thread.
class MapTopics {
 public:
  MapTopics(const RobotState& state, MapLibrary& library, const FaultPlan& faults, const Options& options)
      : state_(state), library_(library), faults_(faults), options_(options) {}

  /// The current message; nullopt for other topics, and if the robot has no such picture.
  std::optional<Frame> messageOf(std::string_view topic);

 private:
  MapPicturePtr pictureOf(std::string_view topic);
  MapPicturePtr costsAroundRobot(double resolution_m, int cells);
  MapPicturePtr costsOfWholeMap();
  MapPicturePtr incremental();
  MapPicturePtr environment(bool symmetry);

  const RobotState& state_;
  MapLibrary& library_;
  const FaultPlan& faults_;
  const Options& options_;
  std::mutex mutex_;
  struct Made {
    std::string of;  // what it was made from
    MapPicturePtr picture;
  };
  std::map<std::string, Made, std::less<>> made_;  // by topic: unchanged ones are reused
};

}  // namespace mapwright::simulator
