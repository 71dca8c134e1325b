// The messages of /ws/v2/topics (docs/protocols/autoxing.md, "Live topics"), as the bytes of one frame each.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

#include "simulator/axbot_topics.h"
#include "simulator/fault_plan.h"
#include "simulator/sockets.h"

namespace mapwright::simulator {

/// {"topic":"/submap_list",...}; key `submap`, slam_state as text. Numbers that JSON lacks are null.
std::string submapListJson(const map::SubmapList& list);
/// One scan of /scan_matched_points2 as JSON, at the present pose.
std::string scanMessage(const RobotState& state, int points, std::uint32_t seed);

/// Makes the messages of the topics that this robot publishes. The list is made once per change, each scan
/// once for all listeners: above 5,000 points eight scans around the first position are prepared and sent in
/// turn, so that the reader is measured and not the simulator. Safe from any thread.
class TopicMessages {
 public:
  TopicMessages(const RobotState& state, MapLibrary& library, const FaultPlan& faults, const Options& options)
      : state_(state), library_(library), faults_(faults), options_(options) {}

  /// The current message; nullopt for topics that are never published, and if the robot has no such picture.
  std::optional<Frame> messageOf(std::string_view topic, bool binary, bool bad_entries);

 private:
  using ListKey = std::tuple<ListStamp, std::string, bool, bool>;  // stamp, uuid, binary, bad entries
  using ScanKey = std::tuple<std::string, bool, std::int64_t>;     // topic, binary, number of the scan

  Frame listMessage(bool binary, bool bad_entries);
  Frame pointsMessage(std::string_view topic, bool binary);
  std::optional<Frame> pictureMessage(std::string_view topic);
  MapPicturePtr pictureOf(std::string_view topic);
  MapPicturePtr costsAroundRobot(double resolution_m, int cells);
  MapPicturePtr costsOfWholeMap();
  MapPicturePtr incremental();
  MapPicturePtr environment(bool symmetry);

  const RobotState& state_;
  MapLibrary& library_;
  const FaultPlan& faults_;
  const Options& options_;
  std::mutex list_mutex_, scan_mutex_;
  Cache<ListKey, Frame> lists_{2};
  Cache<ScanKey, Frame> scans_{64};
  Cache<std::string, MapPicturePtr> made_{8};  // pictures by what they were made from
};

}  // namespace mapwright::simulator
