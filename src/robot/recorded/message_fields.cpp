#include "robot/recorded/message_fields.h"

#include <utility>

#include "recording/ros_cbor.h"
#include "robot/axbot/faults.h"
#include "robot/recorded/faults.h"
#include "robot/recorded/foxglove.h"
#include "robot/recorded/recording_reasons.h"
#include "robot/ros/faults.h"

namespace mapwright::robot::recorded {

using net::rosbridge::Frame;

namespace {

constexpr const char* kPlainJson = "mapwright.Message";  // recorder/layout.h

tl::expected<FramePtr, Fault> frameOf(const QByteArray& bytes, Frame::Wire wire) {
  FramePtr frame = Frame::read(bytes, wire);
  switch (frame->fault()) {
    case Frame::Fault::None:
      return frame;
    case Frame::Fault::NotJson:
      return tl::unexpected(Fault(robot::axbot::fault::MessageNotJson, {std::int64_t(bytes.size())}));
    default:
      return tl::unexpected(Fault(robot::ros::fault::MessageNotUnderstood));
  }
}

Fault missing(const recording::Channel& channel) { return {fault::RosSchemaMissing, {channel.schema_name}}; }

/// The maximum size of a message without members: CDR has a header, a byte for the members, and padding.
std::size_t bytesOfNothing(recording::RosWire wire) { return wire == recording::RosWire::Cdr ? 8 : 0; }

}  // namespace

bool isRos(const recording::Channel& channel, bool untyped) {
  const std::string& encoding = channel.message_encoding;
  if (encoding == "protobuf" || encoding == "json") {
    if (foxgloveKind(channel)) return true;
  }
  if (recording::rosWire(encoding) || encoding == "cbor") return true;
  if (encoding != "json") return false;
  return isUntyped(channel) ? untyped : channel.schema_name.find('/') != std::string::npos;
}

bool isUntyped(const recording::Channel& channel) {
  return channel.schema_name.empty() || channel.schema_name == kPlainJson;
}

const MessageFields::Schema& MessageFields::schemaOf(const recording::ChannelPtr& channel) {
  const auto known = schemas_.find(channel->id);
  if (known != schemas_.end() && known->second.channel == channel) return known->second.schema;
  const auto read = [&]() -> Schema {
    const auto dialect = recording::rosDialect(channel->schema_encoding);
    if (channel->schema_data.empty() && !dialect) return tl::unexpected(missing(*channel));
    if (!dialect) {
      return tl::unexpected(
          Fault(fault::RosEncodingUnknown, {channel->message_encoding, channel->schema_encoding}));
    }
    return recording::parseRosSchema(channel->schema_name, channel->schema_data, *dialect)
        .map_error(
            [&](const recording::RosSchemaFault& fault) { return reasonOf(fault, channel->schema_name); });
  };
  return schemas_.insert_or_assign(channel->id, Known{channel, read()}).first->second.schema;
}

std::string rosTypeOf(const recording::Channel& channel) {
  const auto kind = foxgloveKind(channel);
  if (kind) return rosTypeOf(*kind);
  return isUntyped(channel) ? std::string() : channel.schema_name;
}

const MessageFields::Protobuf& MessageFields::protobufOf(const recording::ChannelPtr& channel) {
  const auto known = protobufs_.find(channel->id);
  if (known != protobufs_.end() && known->second.channel == channel) return known->second.schema;
  return protobufs_.insert_or_assign(channel->id, KnownProtobuf{channel, ProtobufSchema::of(*channel)})
      .first->second.schema;
}

tl::expected<FramePtr, Fault> MessageFields::read(const recording::Message& message) {
  auto frame = readAsItIs(message);
  const auto kind = frame ? foxgloveKind(*message.channel) : std::nullopt;
  if (!kind) return frame;
  const auto cbor = foxgloveToRos(*kind, (*frame)->root());
  if (!cbor) return tl::unexpected(cbor.error());
  return frameOf(*cbor, Frame::Wire::Binary);
}

tl::expected<FramePtr, Fault> MessageFields::readAsItIs(const recording::Message& message) {
  if (message.channel->message_encoding == "protobuf") {
    const Protobuf& schema = protobufOf(message.channel);
    if (!schema) return tl::unexpected(schema.error());
    const auto cbor = schema->toCbor(message.bytes);
    if (!cbor) return tl::unexpected(cbor.error());
    return frameOf(*cbor, Frame::Wire::Binary);
  }
  const std::string& encoding = message.channel->message_encoding;
  const auto wire = recording::rosWire(encoding);
  if (!wire) {
    // A CBOR frame shares its bytes, so they must be owned.
    const QByteArray bytes(reinterpret_cast<const char*>(message.bytes.data()),
                           qsizetype(message.bytes.size()));
    return frameOf(bytes, encoding == "cbor" ? Frame::Wire::Binary : Frame::Wire::Text);
  }
  const Schema& schema = schemaOf(message.channel);
  if (!schema) return tl::unexpected(schema.error());
  // An empty definition means a type without members (std_msgs/Empty), if the message agrees.
  if (message.channel->schema_data.empty() && message.bytes.size() > bytesOfNothing(*wire))
    return tl::unexpected(missing(*message.channel));
  const auto cbor = recording::rosToCbor(*schema, *wire, message.bytes);
  if (!cbor) return tl::unexpected(reasonOf(cbor.error(), encoding));
  return frameOf(*cbor, Frame::Wire::Binary);
}

}  // namespace mapwright::robot::recorded
