// The lidar's topics in the three shapes that robots send: JSON points, packed fields, binary clouds
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

/// One scan of /scan_matched_points2 as JSON, as the robot sees it now.
std::string scanMessage(const RobotState& state, int points, std::uint32_t seed);

/// Safe from any thread. Each scan is made once, however many listen. Above 5,000 points eight scans around
/// the place of the first are prepared and sent in turn, so that a reader is measured and not the writer.
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
