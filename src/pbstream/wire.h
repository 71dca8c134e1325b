// Reads protobuf messages field by field from a stream, so that large ones need no memory of their own. What
// is known must have the wire type that it ought to have: forks change messages without a new version.
// Unknown fields are skipped.
#pragma once

#include <cstdint>
#include <utility>

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/message.h>

#include "fault/fault.h"

namespace mapwright::pbstream {

class Wire {
 public:
  static constexpr int kMostElementBytes = 1 << 20;  // of a message that is read at once

  /// `stream` outlives this.
  explicit Wire(google::protobuf::io::ZeroCopyInputStream* stream);

  /// The fields of the present message, one after the other: `on(number)` reads the value and returns true,
  /// or returns false for it to be skipped.
  template <typename On>
  void fields(On on) {
    while (const int number = next()) {
      if (!on(number)) skip();
    }
  }
  /// The present field is a message: its fields.
  template <typename On>
  void message(On on) {
    const int before = enter();
    if (before < 0) return;
    fields(std::move(on));
    leave(before);
  }
  /// The present field is a small message, with the wire types that it declares.
  void read(google::protobuf::Message& into);
  std::uint64_t varint();
  double fixed64();
  float fixed32();
  /// Numbers of a repeated field, packed or one alone. `take` returns false if it takes no more.
  template <typename Take>
  void varints(Take take) {
    if (type() == 0) {
      const std::uint64_t value = varint();
      if (good() && !take(value)) refuse();
      return;
    }
    const int before = enter();
    if (before < 0) return;
    std::uint64_t value = 0;
    while (good() && in_.BytesUntilLimit() > 0) {
      if (!in_.ReadVarint64(&value)) return breakOff();
      if (!take(value)) return refuse();
    }
    leave(before);
  }

  /// Nothing has failed, and nobody has stopped it.
  bool good() const { return !stopped_; }
  /// The present field is a message, or fault() says that it is not.
  void mustBeMessage() { (void)is(2); }
  /// Enough was read.
  void stop() { stopped_ = true; }
  /// What it says is wrong for another reason.
  void fail(Fault why);
  /// None: nothing is wrong so far.
  const Fault& fault() const { return fault_; }

 private:
  std::uint32_t type() const { return tag_ & 7; }
  /// 0: there is no further one.
  int next();
  void skip();
  /// Negative: it is no message.
  int enter();
  void leave(int before);
  bool is(std::uint32_t type);
  void breakOff();
  void refuse();  // too many

  google::protobuf::io::CodedInputStream in_;
  std::uint32_t tag_ = 0;
  bool stopped_ = false;
  Fault fault_;
};

/// Why the wire types of a message, or of one within it, are not as declared; none: they are.
Fault wrongTypeIn(const google::protobuf::Message& message);

}  // namespace mapwright::pbstream
