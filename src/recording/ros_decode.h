// Deserialises ROS messages in recordings: ROS 1 format ("ros1"), or CDR of ROS 2 ("cdr"). Sources: ROS wiki,
// "roscpp: Overview: Messages" (serialisation: little-endian, packed, arrays and texts after a uint32); OMG
// DDS-XTypes 1.3, 7.4 (encapsulation, plain CDR with alignment; for XCDR2, alignment to at most 4); rosidl (a
// message without members is one byte).
// Pure; any thread. Bytes are untrusted: counts that exceed the remaining bytes are rejected, and nothing is
// copied.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "recording/ros_schema.h"

namespace mapwright::recording {

/// Consecutive numbers, as stored in the message: unaligned.
struct RosNumbers {
  RosKind kind = RosKind::Uint8;  // one of a fixed size
  bool big_endian = false;
  std::span<const std::uint8_t> bytes;
  std::size_t count() const { return bytes.size() / sizeOf(kind); }
};

/// Receives a message member by member, as views into it. Texts are as received, maybe invalid UTF-8.
class RosVisitor {
 public:
  virtual ~RosVisitor() = default;
  virtual void beginObject(
      const RosType& type) = 0;  // followed by member() and a value, for each of its fields
  virtual void endObject() = 0;
  virtual void member(std::string_view name) = 0;
  virtual void beginList(std::size_t count) = 0;  // of objects, texts or times
  virtual void endList() = 0;
  virtual void flag(bool value) = 0;
  virtual void whole(std::int64_t value) = 0;
  virtual void natural(std::uint64_t value) = 0;
  virtual void real(double value) = 0;
  virtual void text(std::string_view value) = 0;
  virtual void time(std::int64_t seconds, std::int64_t nanoseconds) = 0;  // of ROS 1, including durations
  /// Called before every value; false: stop, the message is too large for the receiver.
  virtual bool takesMore() const { return true; }
  virtual void numbers(const RosNumbers& numbers) = 0;  // an array of numbers or bools
};

struct RosDecodeFault {
  enum class Code : std::uint8_t {
    NotThisEncoding,  // neither "ros1" nor "cdr", or an encapsulation other than plain CDR
    CutOff,           // the bytes end within `field`
    TooMany,          // more members than any real message, or than the visitor accepts
    NotSupported,     // a wide text
  };
  Code code = Code::CutOff;
  std::string field;  // its name
};

enum class RosWire : std::uint8_t { Ros1, Cdr };
/// From a channel's message encoding; nullopt: another one.
std::optional<RosWire> rosWire(std::string_view message_encoding);

/// nullopt: all of it was visited. Otherwise the part before the fault was; lists and objects may be left
/// open. Bytes after the message are ignored. `schema` comes from parseRosSchema().
std::optional<RosDecodeFault> decodeRos(const RosSchema& schema, RosWire wire,
                                        std::span<const std::uint8_t> bytes, RosVisitor& visitor);

}  // namespace mapwright::recording
