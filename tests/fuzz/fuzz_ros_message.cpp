// A definition of a ROS message (msg of ROS 1 and ROS 2, IDL), and bytes that are read by it: a byte that
// chooses, the length of the definition, the definition, the bytes.
#include "net/rosbridge/frame.h"
#include "recording/ros_cbor.h"
#include "recording/ros_schema.h"
#include "ros_values.h"
#include "target.h"

namespace mapwright::fuzz::ros_message {
namespace {

using namespace recording;

void read(Input input) {
  Choices from(input);
  const unsigned how = from.byte();
  const std::string definition = textOf(from.bytes(from.twoBytes()));
  const auto dialect = (how & 1) != 0 ? RosDialect::Ros2 : RosDialect::Ros1;
  const auto schema = parseRosSchema((how & 2) != 0 ? "a/msg/B" : "a/B", definition, dialect);
  if (!schema) return;
  MUST(!schema->types.empty());
  for (const RosType& type : schema->types) {
    for (const RosField& field : type.fields) MUST(field.type < schema->types.size());
  }
  const auto bytes = exactly(from.rest());
  std::size_t left = 0;
  const auto cbor = rosToCbor(*schema, (how & 4) != 0 ? RosWire::Cdr : RosWire::Ros1, bytes, &left);
  if (!cbor || cbor->size() > 1 << 20) return;
  MUST(left <= bytes.size());
  mustBeSound(*cbor);
  const auto frame = net::rosbridge::Frame::read(*cbor, net::rosbridge::Frame::Wire::Binary);
  use(frame->root().toJson(500));
  use(frame->root().toWholeJson());
  readMessages(frame->root());
}

}  // namespace
}  // namespace mapwright::fuzz::ros_message

MAPWRIGHT_FUZZ_TARGET(ros_message)
