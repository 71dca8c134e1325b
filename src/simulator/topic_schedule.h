// When which topic is sent.
#pragma once

#include <chrono>
#include <string_view>
#include <vector>

namespace mapwright::simulator {

struct Options;

/// A topic that comes again and again.
struct PeriodicTopic {
  std::string_view topic;
  std::chrono::steady_clock::duration period;
  std::chrono::steady_clock::time_point due;
};

std::vector<PeriodicTopic> periodicTopics(const Options& options, std::chrono::steady_clock::time_point now);

/// Topics whose last message is sent at once to whoever enables them.
bool isLatched(std::string_view topic);
/// Topics that come often enough to be left out when a reader is slow.
bool mayBeLeftOut(std::string_view topic);
/// Topics that take milliseconds to make: pictures and scans.
bool isSlow(std::string_view topic);
/// Topics to send when the robot works with another map or picture; /map/info is not among them.
const std::vector<std::string_view>& mapTopics();
/// Those of them that come again and again while the robot maps.
bool growsWhileMapping(std::string_view topic);
/// All that this robot has.
std::vector<std::string_view> publishedTopics();

}  // namespace mapwright::simulator
