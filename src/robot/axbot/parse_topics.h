// From WebSocket frames to typed topic messages. Pure functions, any thread.
// Source: docs/protocols/autoxing.md, "Live topics", "Binary frames".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QStringList>
#include <tl/expected.hpp>

#include "map/live_topics.h"
#include "robot/wire/read_json.h"

namespace mapwright::robot::axbot {

/// A picture topic whose picture has to be fetched yet.
struct GridToFetch {
  map::GridMessage grid;  // without png and fingerprint
  std::string data_url;   // as the robot wrote it
};

/// Where a message that cannot be read at all is filed.
inline constexpr const char* kUnknownTopic = "(unknown)";

/// What a text frame was.
struct TextFrame {
  std::string topic;                               // empty for answers
  std::optional<map::TopicMessage> message;        // a topic that mapwright knows, or UnreadableMessage
  std::optional<map::UnreadableMessage> left_out;  // what of `message` could not be read
  std::optional<GridToFetch> grid_to_fetch;
  std::optional<std::vector<std::string>> enabled_topics;  // the answer to enable_topic
  std::string error;                                       // the robot's own error text
  std::optional<double> stamp_s;                           // the robot's own, seconds since the epoch
};

/// Reads text frames one after the other, keeping the parser's memory. Literal NaN and Infinity (not JSON,
/// but sent by robots) and numbers beyond any type count as null.
class TopicReader {
 public:
  TextFrame read(std::string_view utf8);

 private:
  wire::JsonReader json_;
};

/// The same of a text that is read already. `of_topic` is the one of a text that names none itself.
TextFrame readFrame(const wire::Json& root, const std::string& of_topic = {});

/// The same for a single frame.
TextFrame parseTextFrame(std::string_view utf8);

/// What a binary frame (?pb=1) holds: topic length, topic, gzip flag, RosMessageWrapper.
struct BinaryFrame {
  std::string topic;
  std::string body;  // unpacked; empty when it could not be read
};
/// The error is the message that says what is wrong.
tl::expected<BinaryFrame, map::UnreadableMessage> unpackBinaryFrame(std::string_view bytes);

/// Its topic alone; empty when there is none.
std::string topicOfBinaryFrame(std::string_view bytes);

/// The type of what a binary frame holds, and its definition (a FileDescriptorSet of protobuf).
inline constexpr const char* kBinaryType = "ros_messages.RosMessageWrapper";
std::string binaryTypeDefinition();

/// Reads what a binary frame holds, as parseBinaryFrame() does.
std::optional<map::TopicMessage> parseBinaryBody(const std::string& topic, std::string_view body);

/// Reads a binary frame. nullopt for topics that are not ours; UnreadableMessage when it cannot be read.
std::optional<map::TopicMessage> parseBinaryFrame(std::string_view bytes);

/// The topics that are understood, for completion and layers.
QStringList knownTopics();

}  // namespace mapwright::robot::axbot
