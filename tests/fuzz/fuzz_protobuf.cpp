// A message of protobuf by the definition in its recording: the length of the FileDescriptorSet, it, the
// message.
#include "recording/message.h"
#include "robot/recorded/protobuf_schema.h"
#include "ros_values.h"
#include "target.h"

namespace mapwright::fuzz::protobuf {
namespace {

void read(Input input) {
  Choices from(input);
  recording::Channel channel;
  channel.schema_encoding = channel.message_encoding = "protobuf";
  channel.schema_name = "a.B";
  channel.schema_data = textOf(from.bytes(from.twoBytes()));
  const auto schema = robot::recorded::ProtobufSchema::of(channel);
  if (!schema) return;
  const auto cbor = schema->toCbor(exactly(from.rest()));
  if (cbor) mustBeSound(*cbor);
}

}  // namespace
}  // namespace mapwright::fuzz::protobuf

MAPWRIGHT_FUZZ_TARGET(protobuf)
