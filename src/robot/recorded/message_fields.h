// Messages of ROS in recordings, read as those of a rosbridge server: JSON and CBOR as they are, those
// serialised as by ROS 1 or as CDR through their definition. One thread.
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

/// Whether messages of this channel are values of a ROS type ("package/Type"), or say the same by a schema of
/// Foxglove. `untyped`: those are, too, whose type nobody said.
bool isRos(const recording::Channel& channel, bool untyped);

/// Whether nobody said of which type its messages are.
bool isUntyped(const recording::Channel& channel);

/// The type of ROS as which they are read; of others than Foxglove's the one that the channel tells.
std::string rosTypeOf(const recording::Channel& channel);

class MessageFields {
 public:
  /// Its root is the message. The definition of each channel is read once.
  tl::expected<FramePtr, Fault> read(const recording::Message& message);
  /// The same, but what says it by a schema of Foxglove is no message of ROS yet.
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
