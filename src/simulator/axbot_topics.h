// The topics of the Autoxing robot (docs/protocols/autoxing.md, "Topics that the map shows"): when which is
// sent, and the messages about itself and its surroundings.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "map/submap.h"
#include "simulator/maps.h"
#include "simulator/robot_state.h"
#include "simulator/value.h"

namespace mapwright::simulator {

constexpr std::string_view kSubmapListTopic = "/submap_list";

// Periods that are no number of seconds.
constexpr double kAsScans = 0, kAsPoses = -1, kWhenItChanges = -2;

struct AxbotTopic {
  std::string_view name;
  double period_s;
  bool latched = false;  // its last message is sent at once to whoever enables it
};

std::span<const AxbotTopic> axbotTopics();
/// Null for a topic that this robot does not have.
const AxbotTopic* axbotTopic(std::string_view name);
/// Topics that take milliseconds to make: pictures and scans.
bool isSlow(std::string_view topic);
/// Topics to send when the robot works with another map or picture; /map/info is not among them.
const std::vector<std::string_view>& mapTopics();
/// Those of them that come again and again while the robot maps.
bool growsWhileMapping(std::string_view topic);
/// The names of all, sorted.
std::vector<std::string_view> publishedTopics();

/// {"topic":"...",...}
std::string messageJson(std::string_view topic, Value::Object members);
/// As these robots write it.
std::string_view nameOf(map::SlamState state);
/// A pure function of the robot's present state; nullopt for topics of pictures, points and submaps, and for
/// those that need a map if there is none. `map` is the current one.
std::optional<std::string> liveMessage(std::string_view topic, const RobotState& state,
                                       const std::optional<StoredMap>& map);

}  // namespace mapwright::simulator
