// The topics of an Autoxing robot: how each is read, and which kind of data it carries. Source:
// docs/protocols/autoxing.md, "Topics that the map shows".
#pragma once

#include <optional>
#include <string_view>

#include "map/live_topics.h"
#include "map/stream.h"
#include "robot/axbot/parse_topics.h"
#include "robot/wire/read_json.h"

namespace mapwright::robot::axbot {

struct Topic {
  std::string_view name;
  /// Returns an UnreadableMessage if the message is invalid. Null for pictures and for clouds of points
  /// (isCloudTopic).
  map::TopicMessage (*read)(const wire::Json& message) = nullptr;
  std::optional<map::GridKind> picture = {};  // of picture topics: their layer
  std::optional<map::Stream> stream = {};
  bool older = false;   // a name in older firmware (StreamTopics::older)
  bool offered = true;  // for completion
};
/// Null: it is unknown here.
const Topic* findTopic(std::string_view name);

}  // namespace mapwright::robot::axbot
