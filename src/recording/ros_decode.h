// Messages of ROS as they lie in recordings: serialised as by ROS 1 ("ros1"), or as CDR by ROS 2 ("cdr").
// Sources: ROS wiki, "roscpp: Overview: Messages" (serialisation: little-endian, packed, arrays and texts
// behind a uint32); OMG DDS-XTypes 1.3, 7.4 (encapsulation, plain CDR with alignment; of XCDR2, alignment to
// 4 at most); rosidl (a message without members is one byte).
//
// Pure; any thread. Bytes are untrusted: no count is believed that the bytes left could not hold, nothing is
// copied.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "recording/ros_schema.h"

namespace mapwright::recording {

/// Numbers side by side, as they lie in the message: not aligned in memory.
struct RosNumbers {
  RosKind kind = RosKind::Uint8;  // one of a fixed size
  bool big_endian = false;
  std::span<const std::uint8_t> bytes;
  std::size_t count() const { return bytes.size() / sizeOf(kind); }
};

/// Takes a message member by member. Views are into the message. Texts are as they came, maybe no UTF-8.
class RosVisitor {
 public:
  virtual ~RosVisitor() = default;
  virtual void beginObject(const RosType& type) = 0;  // then member() and a value, for each of its fields
  virtual void endObject() = 0;
  virtual void member(std::string_view name) = 0;
  virtual void beginList(std::size_t count) = 0;  // of objects, texts or times
  virtual void endList() = 0;
  virtual void flag(bool value) = 0;
  virtual void whole(std::int64_t value) = 0;
  virtual void natural(std::uint64_t value) = 0;
  virtual void real(double value) = 0;
  virtual void text(std::string_view value) = 0;
  virtual void time(std::int64_t seconds, std::int64_t nanoseconds) = 0;  // of ROS 1, durations too
  /// Asked before every value; false: enough, the message is too large for whoever takes it.
  virtual bool takesMore() const { return true; }
  virtual void numbers(const RosNumbers& numbers) = 0;  // an array of numbers or flags
};

struct RosDecodeFault {
  enum class Code : std::uint8_t {
    NotThisEncoding,  // neither "ros1" nor "cdr", or an encapsulation that is not plain CDR
    CutOff,           // the bytes end within `field`
    TooMany,          // more members than any message has, or than the visitor takes
    NotSupported,     // a wide text
  };
  Code code = Code::CutOff;
  std::string field;  // its name
};

enum class RosWire : std::uint8_t { Ros1, Cdr };
/// Of a channel's message encoding; nullopt: another one.
std::optional<RosWire> rosWire(std::string_view message_encoding);

/// nullopt: all of it was visited. Else it was visited up to there; lists and objects may be left open. Bytes
/// behind the message are passed over. `schema` is one that parseRosSchema() made.
std::optional<RosDecodeFault> decodeRos(const RosSchema& schema, RosWire wire,
                                        std::span<const std::uint8_t> bytes, RosVisitor& visitor);

}  // namespace mapwright::recording
