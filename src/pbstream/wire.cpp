#include "pbstream/wire.h"

#include <bit>
#include <limits>
#include <vector>

#include <google/protobuf/descriptor.h>
#include <google/protobuf/unknown_field_set.h>
#include <google/protobuf/wire_format_lite.h>

#include "pbstream/faults.h"

namespace mapwright::pbstream {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::internal::WireFormatLite;

}  // namespace

Wire::Wire(google::protobuf::io::ZeroCopyInputStream* stream) : in_(stream) {
  in_.SetTotalBytesLimit(std::numeric_limits<int>::max());
}

void Wire::fail(Fault why) {
  if (!fault_.any()) fault_ = std::move(why);
  stopped_ = true;
}

void Wire::breakOff() { fail(fault::NotReadable); }
void Wire::refuse() { fail(faultText("pbstream", "it has more values than it may have")); }

int Wire::next() {
  if (stopped_) return 0;
  tag_ = in_.ReadTag();
  if (tag_ == 0) {
    if (!in_.ConsumedEntireMessage()) breakOff();
    return 0;
  }
  const int number = int(tag_ >> 3);
  if (number == 0) breakOff();
  return number;
}

void Wire::skip() {
  if (!WireFormatLite::SkipField(&in_, tag_)) breakOff();
}

bool Wire::is(std::uint32_t type) {
  if (type == this->type()) return true;
  fail({fault::WrongType, {std::int64_t(tag_ >> 3)}});
  return false;
}

int Wire::enter() {
  std::uint32_t length = 0;
  if (!is(WireFormatLite::WIRETYPE_LENGTH_DELIMITED)) return -1;
  const int left = in_.BytesUntilLimit();
  if (!in_.ReadVarint32(&length) || length > std::uint32_t(std::numeric_limits<int>::max()) ||
      (left >= 0 && length > std::uint32_t(left))) {
    breakOff();
    return -1;
  }
  return in_.PushLimit(int(length));
}

void Wire::leave(int before) {
  if (!stopped_ && in_.BytesUntilLimit() > 0) breakOff();
  in_.PopLimit(before);
}

void Wire::read(Message& into) {
  const int before = enter();
  if (before < 0) return;
  if (in_.BytesUntilLimit() > kMostElementBytes)
    return fail(faultText("pbstream", "one of its parts is too large"));
  into.Clear();
  if (!into.MergePartialFromCodedStream(&in_)) return breakOff();
  leave(before);
  if (Fault wrong = wrongTypeIn(into); wrong.any()) fail(std::move(wrong));
}

std::uint64_t Wire::varint() {
  std::uint64_t value = 0;
  if (is(WireFormatLite::WIRETYPE_VARINT) && !in_.ReadVarint64(&value)) breakOff();
  return value;
}

double Wire::fixed64() {
  std::uint64_t value = 0;
  if (is(WireFormatLite::WIRETYPE_FIXED64) && !in_.ReadLittleEndian64(&value)) breakOff();
  return std::bit_cast<double>(value);
}

float Wire::fixed32() {
  std::uint32_t value = 0;
  if (is(WireFormatLite::WIRETYPE_FIXED32) && !in_.ReadLittleEndian32(&value)) breakOff();
  return std::bit_cast<float>(value);
}

Fault wrongTypeIn(const Message& message) {
  const auto* const reflection = message.GetReflection();
  const auto& unknown = reflection->GetUnknownFields(message);
  for (int i = 0; i < unknown.field_count(); ++i) {
    const int number = unknown.field(i).number();
    if (message.GetDescriptor()->FindFieldByNumber(number)) return {fault::WrongType, {std::int64_t(number)}};
  }
  std::vector<const FieldDescriptor*> fields;
  reflection->ListFields(message, &fields);
  for (const FieldDescriptor* const field : fields) {
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) continue;
    const int count = field->is_repeated() ? reflection->FieldSize(message, field) : 1;
    for (int i = 0; i < count; ++i) {
      Fault wrong = wrongTypeIn(field->is_repeated() ? reflection->GetRepeatedMessage(message, field, i)
                                                     : reflection->GetMessage(message, field));
      if (wrong.any()) return wrong;
    }
  }
  return {};
}

}  // namespace mapwright::pbstream
