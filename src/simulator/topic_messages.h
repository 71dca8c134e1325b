// The messages of /ws/v2/topics (docs/protocols/autoxing.md, "Live topics"), as the bytes of one frame each.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/frame.h"
#include "simulator/map_topics.h"
#include "simulator/point_topics.h"
#include "simulator/robot_state.h"

namespace mapwright::simulator {

/// {"topic":"/submap_list",...}; key `submap`, slam_state as text. Numbers that JSON lacks are null.
std::string submapListJson(const map::SubmapList& list);
/// Topic length, topic, gzip flag, RosMessageWrapper (gzipped when large).
std::string submapListBinary(const map::SubmapList& list);
/// Rows as a robot with a broken SLAM sends them: NaN, zero quaternions, duplicates, a version going back.
void addBadEntries(map::SubmapList& list);

/// Makes the messages of the topics that this robot publishes; the list is made once per change. Safe from
/// any thread.
class TopicMessages {
 public:
  TopicMessages(const RobotState& state, MapLibrary& library, const FaultPlan& faults, const Options& options)
      : state_(state), library_(library), maps_(state, library, faults, options), points_(state, options) {}

  /// The current message; nullopt for topics that are never published.
  std::optional<Frame> messageOf(std::string_view topic, bool binary, bool bad_entries);

 private:
  Frame listMessage(bool binary, bool bad_entries);

  const RobotState& state_;
  const MapLibrary& library_;
  MapTopics maps_;
  PointTopics points_;
  std::mutex mutex_;
  ListStamp stamp_;
  bool bad_entries_ = false;
  std::optional<std::string> uuid_;
  Frame json_, binary_;
};

constexpr std::string_view kSubmapListTopic = "/submap_list";

}  // namespace mapwright::simulator
