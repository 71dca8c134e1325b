// From WebSocket frames to typed topic messages. Pure functions, any thread.
// Source: axbot.md, "WebSocket"; seed 000 (/submap_list).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "map/live_topics.h"

namespace mapwright::robot::axbot {

/// What a text frame was.
struct TextFrame {
  std::string topic;                         // empty for answers
  std::optional<map::TopicMessage> message;  // a topic that mapwright knows, or UnreadableMessage
  std::optional<std::vector<std::string>> enabled_topics;  // the answer to enable_topic
  std::string error;                                       // the robot's own error text
};

/// Reads a text frame. Literal NaN and Infinity (not JSON, but sent by robots) and numbers beyond any type
/// count as null.
TextFrame parseTextFrame(std::string_view utf8);

/// Reads a binary frame (?pb=1): topic length, topic, gzip flag, RosMessageWrapper. nullopt for topics that
/// are not ours; UnreadableMessage when it cannot be read.
std::optional<map::TopicMessage> parseBinaryFrame(std::string_view bytes);

}  // namespace mapwright::robot::axbot
