// Frames of rosbridge (text, binary, pictures, fragments), their values, and the messages that they are read
// as. Bit 0 of the first byte: binary.
#include "net/rosbridge/cbor_item.h"
#include "net/rosbridge/fragment_joiner.h"
#include "net/rosbridge/frame.h"
#include "ros_values.h"
#include "target.h"

namespace mapwright::fuzz::rosbridge {
namespace {

using namespace net::rosbridge;

void join(const Field& root) {
  using std::chrono::milliseconds;
  FragmentJoiner joiner({1 << 16, 4, 64, milliseconds(10)});
  for (int now = 0; now < 3; ++now) {
    const auto joined = joiner.add(root, milliseconds(now));
    MUST(joiner.heldMessages() <= 4);
    if (joined && *joined) use(Frame::read(**joined, Frame::Wire::Text, 1 << 16));
  }
  joiner.expire(milliseconds(100));
  MUST(joiner.heldMessages() == 0 && joiner.heldBytes() == 0);
}

/// A member as it was received says the same as the one that was read.
void compareMember(const Frame& frame, std::string_view name) {
  const auto raw = frame.rawMember(name);
  const Field member = frame.root()[name];
  if (!raw || frame.wire() == Frame::Wire::Binary) return;
  const auto again = Frame::read(QByteArray(raw->data(), qsizetype(raw->size())), Frame::Wire::Text, 1 << 20);
  if (again->fault() == Frame::Fault::None && again->root().isObject())
    MUST(again->root().toWholeJson() == member.toWholeJson());
}

void read(Input input) {
  Choices from(input);
  const bool binary = (from.byte() & 1) != 0;
  const auto held = exactly(from.rest());
  if (binary && !held.empty() && lookThrough(held.data(), held.data() + held.size()) == CborFault::None)
    MUST(pastItem(held.data(), held.data() + held.size()) == held.data() + held.size());
  const QByteArray bytes(reinterpret_cast<const char*>(held.data()), qsizetype(held.size()));
  const auto frame = Frame::read(bytes, binary ? Frame::Wire::Binary : Frame::Wire::Text, 1 << 20);
  MUST(frame);
  use(textOfPng(viewOf(held), 1 << 16));
  if (frame->fault() != Frame::Fault::None) {
    MUST(frame->root().isNull());
    return;
  }
  const Field root = frame->root();
  readValues(root);
  use(root.toJson(200));
  for (const char* const name : {"op", "msg", "values"}) compareMember(*frame, name);
  readMessages(root);
  readMessages(root["msg"]);
  if (root["op"].text() == "fragment") join(root);
}

}  // namespace
}  // namespace mapwright::fuzz::rosbridge

MAPWRIGHT_FUZZ_TARGET(rosbridge)
