// The topics of the Autoxing robot (docs/protocols/autoxing.md, "Topics that the map shows"): when which is
// sent, and the messages about itself and its surroundings.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "map/submap.h"
#include "simulator/maps.h"
#include "simulator/robot_state.h"
#include "simulator/value.h"

namespace mapwright::simulator {

constexpr std::string_view kSubmapListTopic = "/submap_list";

// Periods that are no number of seconds.
constexpr double kAsScans = 0, kAsPoses = -1, kWhenItChanges = -2;

/// What is so about a topic.
enum TopicTraits : unsigned {
  kLatched = 1,     // its last message is sent at once to whoever enables it
  kSlow = 2,        // it takes milliseconds to make: pictures and scans
  kOfMap = 4,       // sent when the robot works with another map or picture
  kGrows = 8,       // comes again and again only while the robot maps
  kNeedsMap = 16,   // there is none without a current map,
  kNeedsRound = 32  // or without the way that the robot goes round
};

struct Live;

struct AxbotTopic {
  std::string_view name;
  double period_s;
  unsigned traits = 0;
  Value::Object (*make)(const Live& live) = nullptr;  // null for pictures, points and submaps

  bool is(TopicTraits trait) const { return (traits & trait) != 0; }
};

std::span<const AxbotTopic> axbotTopics();
/// Null for a topic that this robot does not have.
const AxbotTopic* axbotTopic(std::string_view name);

/// {"topic":"...",...}
std::string messageJson(std::string_view topic, Value::Object members);
/// As these robots write it.
std::string_view nameOf(map::SlamState state);
/// A pure function of the robot's present state; nullopt for topics of pictures, points and submaps, and for
/// those that need a map if there is none. `map` is the current one.
std::optional<std::string> liveMessage(std::string_view topic, const RobotState& state,
                                       const std::optional<StoredMap>& map);

}  // namespace mapwright::simulator
