// The lidar's topics in all three forms sent by robots: JSON points, packed fields, binary clouds
// (docs/protocols/autoxing.md, "Live topics").
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

#include "simulator/frame.h"
#include "simulator/robot_state.h"

namespace mapwright::simulator {

struct Options;

/// One scan of /scan_matched_points2 as JSON, at the present pose.
std::string scanMessage(const RobotState& state, int points, std::uint32_t seed);

/// Safe from any thread. Each scan is made once for all listeners. Above 5,000 points eight scans around the
/// first position are prepared and sent in turn, so that the reader is measured and not the simulator.
class PointTopics {
 public:
  PointTopics(const RobotState& state, const Options& options) : state_(state), options_(options) {}

  /// nullopt for other topics.
  std::optional<Frame> messageOf(std::string_view topic, bool binary);

 private:
  using Key = std::tuple<std::string, bool, std::int64_t>;  // topic, binary, number of the scan

  const RobotState& state_;
  const Options& options_;
  std::mutex mutex_;
  std::map<Key, Frame> made_;
};

}  // namespace mapwright::simulator
