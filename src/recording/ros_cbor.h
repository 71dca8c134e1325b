// ROS messages in the form of rosbridge's binary frames, so that the code for frames also reads recordings
// without knowing ROS 1 or CDR. Sources: rosbridge v2, "cbor"; RFC 8949; RFC 8746 (arrays of numbers).
#pragma once

#include <cstddef>
#include <span>

#include <QByteArray>
#include <tl/expected.hpp>

#include "recording/ros_decode.h"

namespace mapwright::recording {

/// The message as one CBOR map, with members in the order of the schema. Arrays of numbers are byte strings
/// tagged with type and byte order (uint8[] and bool[] without), copied unchanged; times are {secs, nsecs} in
/// ROS 1 and {sec, nanosec} in ROS 2. Single numbers are integers or 64-bit floats (including NaN). Memory:
/// the message plus the names of all its members; over 512 MiB is TooMany. Pure; any thread.
tl::expected<QByteArray, RosDecodeFault> rosToCbor(const RosSchema& schema, RosWire wire,
                                                   std::span<const std::uint8_t> bytes);

}  // namespace mapwright::recording
