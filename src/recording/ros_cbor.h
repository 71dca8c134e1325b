// Messages of ROS as rosbridge would send them in a binary frame: then whoever reads frames reads recordings,
// and needs to know of neither ROS 1 nor CDR. Sources: rosbridge v2, "cbor"; RFC 8949; RFC 8746 (arrays of
// numbers).
#pragma once

#include <cstddef>
#include <span>

#include <QByteArray>
#include <tl/expected.hpp>

#include "recording/ros_decode.h"

namespace mapwright::recording {

/// The message as one CBOR map, its members in the order of the schema. Arrays of numbers are byte strings
/// with the tag of their type and byte order (uint8[] and flags without), copied as they lie; times of ROS 1
/// are {secs, nsecs}, those of ROS 2 {sec, nanosec}. Lone numbers are whole, or floats of 64 bits (NaN too).
/// Memory: as much as the message and the names of its members, each time that they occur; over 512 MiB is
/// TooMany. Pure; any thread.
tl::expected<QByteArray, RosDecodeFault> rosToCbor(const RosSchema& schema, RosWire wire,
                                                   std::span<const std::uint8_t> bytes);

}  // namespace mapwright::recording
