// ROS messages of recordings in the form of rosbridge's binary frames, so that the code for frames also reads
// recordings without knowing ROS 1 ("ros1") or CDR of ROS 2 ("cdr"). Sources: ROS wiki, "roscpp: Overview:
// Messages" (serialisation: little-endian, packed, arrays and texts after a uint32); OMG DDS-XTypes 1.3, 7.4
// (encapsulation, plain CDR with alignment; for XCDR2, alignment to at most 4); rosidl (a message without
// members is one byte); rosbridge v2, "cbor"; RFC 8949; RFC 8746 (arrays of numbers).
// Pure; any thread. Bytes are untrusted: counts that exceed the remaining bytes are rejected.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include <QByteArray>
#include <tl/expected.hpp>

#include "recording/ros_schema.h"

namespace mapwright::recording {

struct RosDecodeFault {
  enum class Code : std::uint8_t {
    NotThisEncoding,  // neither "ros1" nor "cdr", or an encapsulation other than plain CDR
    CutOff,           // the bytes end within `field`
    TooMany,          // more members than any real message, or over 512 MiB of CBOR
    NotSupported,     // a wide text
  };
  Code code = Code::CutOff;
  std::string field;  // its name
};

enum class RosWire : std::uint8_t { Ros1, Cdr };
/// From a channel's message encoding; nullopt: another one.
std::optional<RosWire> rosWire(std::string_view message_encoding);

/// The message as one CBOR map, with members in the order of the schema. Arrays of numbers are byte strings
/// tagged with type and byte order (uint8[] without), copied unchanged; times are {secs, nsecs} in ROS 1 and
/// {sec, nanosec} in ROS 2. Single numbers are integers or 64-bit floats (including NaN). Texts are as
/// received, maybe invalid UTF-8; bytes after the message are ignored. Memory: the message plus the names of
/// all its members. `schema` comes from parseRosSchema().
/// `left`: the number of bytes after it.
tl::expected<QByteArray, RosDecodeFault> rosToCbor(const RosSchema& schema, RosWire wire,
                                                   std::span<const std::uint8_t> bytes,
                                                   std::size_t* left = nullptr);

/// The tag of a byte string that holds numbers of this type. Source: RFC 8746, section 2.1 (0b010fsell).
template <typename Number>
constexpr std::uint64_t cborTagOf(bool big_endian = false) {
  constexpr bool real = std::is_floating_point_v<Number>;
  constexpr int kind = real ? 16 : std::is_signed_v<Number> ? 8 : 0;
  constexpr int width = std::countr_zero(sizeof(Number)) - (real ? 1 : 0);
  return std::uint64_t(64 + kind + (sizeof(Number) > 1 && !big_endian ? 4 : 0) + width);
}

}  // namespace mapwright::recording
