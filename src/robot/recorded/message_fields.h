// Reads ROS messages in recordings like those of a rosbridge server: JSON and CBOR directly, ROS 1 and CDR by
// their definition. And what people and programs read of them. One thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>

#include <tl/expected.hpp>

#include "fault/fault.h"
#include "net/rosbridge/frame.h"
#include "recording/message.h"
#include "recording/ros_schema.h"
#include "robot/recorded/protobuf_schema.h"
#include "robot/wire/read_json.h"

namespace mapwright::robot::recorded {

using FramePtr = std::shared_ptr<const net::rosbridge::Frame>;

/// Whether messages of this channel are values of a ROS type ("package/Type"), or an equivalent Foxglove
/// type. `untyped`: includes those of unknown type.
bool isRos(const recording::Channel& channel, bool untyped);

/// Whether the type of its messages is unknown.
bool isUntyped(const recording::Channel& channel);

/// The ROS type that they are read as; unless it is Foxglove, the channel's own.
std::string rosTypeOf(const recording::Channel& channel);

class MessageFields {
 public:
  /// Its root is the message. The definition of each channel is parsed once.
  tl::expected<FramePtr, Fault> read(const recording::Message& message);
  /// The same, but Foxglove messages are not converted.
  tl::expected<FramePtr, Fault> readAsItIs(const recording::Message& message);
  /// Those that no layer uses. The error says that the encoding is not known, or why the message is not one.
  tl::expected<FramePtr, Fault> readOther(const recording::Message& message);
  /// Bytes that the message read last has beyond what its definition describes, without padding.
  std::size_t beyond() const { return beyond_; }

 private:
  /// What was made of the definition of a channel; a channel of the same id may be another one later.
  template <typename Schema>
  struct Known {
    recording::ChannelPtr channel;
    tl::expected<Schema, Fault> schema;
  };
  template <typename Schema>
  using KnownSchemas = std::unordered_map<std::uint32_t, Known<Schema>>;  // by channel id
  KnownSchemas<recording::RosSchema> ros_schemas_;
  KnownSchemas<ProtobufSchema> protobuf_schemas_;
  std::size_t beyond_ = 0;
};

/// A text as JSON.
std::string jsonText(std::string_view text);

/// A message of a recording as one JSON object: for people (the inspector) or for programs (frames, export).
/// Source: docs/json.md, "Messages".
/// All of them contain "topic" and "__stamp", those of the channel and of the log. Messages that are not JSON
/// objects, or that have other members of these names, are put into {"topic", "__stamp", "type", "msg"}.
class MessageText {
 public:
  /// People see the beginnings of long lists and texts (net::rosbridge::Field::toJson); for programs nothing
  /// is truncated, and unreadable data is included as bytes.
  enum class For { People, Programs };
  /// The message outlives it.
  MessageText(const recording::Message& message, For whom)
      : message_(message), programs_(whom == For::Programs) {}

  std::string_view bytes() const;
  /// `frame` is the result of MessageFields::read().
  std::string ofRos(const tl::expected<FramePtr, Fault>& frame, MessageFields& fields) const;
  /// A JSON object as recorded, with missing members appended; if its own say otherwise, put into another.
  std::string ofFrame(const wire::Json& root) const;
  /// A non-text frame of Autoxing.
  std::string ofBinaryFrame() const;
  /// For an encoding that no layer uses. `frame` is the result of MessageFields::readOther().
  std::string ofOther(const tl::expected<FramePtr, Fault>& frame) const;
  /// {"bytes": how many}; for programs also "base64".
  std::string ofBytes() const;

 private:
  std::string wrapped(std::string_view member, std::string_view json) const;
  std::string whole(const FramePtr& frame) const;

  const recording::Message& message_;
  bool programs_;
};

}  // namespace mapwright::robot::recorded
