// Reads ROS messages in recordings like those of a rosbridge server: JSON and CBOR directly, ROS 1 and CDR by
// their definition. One thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

#include <tl/expected.hpp>

#include "fault/fault.h"
#include "net/rosbridge/frame.h"
#include "recording/message.h"
#include "recording/ros_schema.h"
#include "robot/recorded/protobuf_schema.h"

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

 private:
  using Schema = tl::expected<recording::RosSchema, Fault>;
  const Schema& schemaOf(const recording::ChannelPtr& channel);
  using Protobuf = tl::expected<ProtobufSchema, Fault>;
  const Protobuf& protobufOf(const recording::ChannelPtr& channel);
  struct Known {
    recording::ChannelPtr channel;
    Schema schema;
  };
  std::unordered_map<std::uint32_t, Known> schemas_;  // by channel id
  struct KnownProtobuf {
    recording::ChannelPtr channel;
    Protobuf schema;
  };
  std::unordered_map<std::uint32_t, KnownProtobuf> protobufs_;
};

}  // namespace mapwright::robot::recorded
