// Converts WebSocket frames to typed topic messages. Pure functions, any thread. Source:
// docs/protocols/autoxing.md, "Live topics", "Binary frames".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QStringList>
#include <tl/expected.hpp>

#include "map/live_topics.h"
#include "map/stream.h"
#include "robot/robot.h"
#include "robot/wire/read_json.h"

namespace mapwright::robot::axbot {

/// A picture topic whose picture still has to be fetched.
struct GridToFetch {
  map::GridMessage grid;  // without png and fingerprint
  std::string data_url;   // as the robot wrote it
};

/// The topic for completely unreadable messages.
inline constexpr const char* kUnknownTopic = "(unknown)";

/// A parsed text frame.
struct TextFrame {
  std::string topic;                               // empty for answers
  std::optional<map::TopicMessage> message;        // a known topic, or UnreadableMessage
  std::optional<map::UnreadableMessage> left_out;  // the unreadable part of `message`
  std::optional<GridToFetch> grid_to_fetch;
  std::optional<std::vector<std::string>> enabled_topics;  // the answer to enable_topic
  std::string error;                                       // the robot's own error text
  std::optional<double> stamp_s;                           // the robot's own, seconds since the epoch
};

/// Reads text frames one after the other, reusing the parser's memory. Literal NaN and Infinity (not JSON,
/// but sent by robots) and numbers out of range count as null.
class TopicReader {
 public:
  TextFrame read(std::string_view utf8);

 private:
  wire::JsonReader json_;
};

/// The same for parsed JSON.
TextFrame readFrame(const wire::Json& root);
/// The same of a message that came on this topic, whatever it says itself.
TextFrame readFrameOn(const std::string& topic, const wire::Json& root);

/// The same for a single frame.
TextFrame parseTextFrame(std::string_view utf8);

/// The content of a binary frame (?pb=1): topic length, topic, gzip flag, RosMessageWrapper.
struct BinaryFrame {
  std::string topic;
  std::string body;  // unpacked; empty if it could not be read
};
/// The error is the message that says what is wrong.
tl::expected<BinaryFrame, map::UnreadableMessage> unpackBinaryFrame(std::string_view bytes);

/// Only its topic; empty if there is none.
std::string topicOfBinaryFrame(std::string_view bytes);

/// The type of the content of binary frames, and its definition (a FileDescriptorSet of protobuf).
inline constexpr const char* kBinaryType = "ros_messages.RosMessageWrapper";
std::string binaryTypeDefinition();

/// The content of a binary frame as one JSON text; nullopt: it is not known here.
std::optional<std::string> jsonOfBinaryBody(std::string_view body);

/// Reads the content of a binary frame, as parseBinaryFrame() does.
std::optional<map::TopicMessage> parseBinaryBody(const std::string& topic, std::string_view body);

/// Reads a binary frame. nullopt for unknown topics; UnreadableMessage if it cannot be read.
std::optional<map::TopicMessage> parseBinaryFrame(std::string_view bytes);

/// For the raw-message inspector: a text frame as received, truncated at kMaxRawText.
RawMessage rawText(const std::string& topic, std::string_view utf8);
/// A binary frame as readable JSON if its message is known and not too long, otherwise as a hex dump.
RawMessage rawBinary(std::string_view bytes);

/// The supported topics, for completion and layers.
QStringList knownTopics();

/// Which topics carry a kind of data.
struct StreamTopics {
  QStringList usual;  // requested together
  /// The name in older firmware, which sends it unreduced: subscribed if the usual ones stay silent.
  QStringList older;
};
StreamTopics topicsOf(map::Stream stream);

}  // namespace mapwright::robot::axbot
