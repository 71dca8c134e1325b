// Serialises ROS messages from a rosbridge server as ROS itself does: the reverse of recording/ros_cbor.h.
// Pure; any thread. Sources: as there.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "net/rosbridge/field.h"
#include "recording/ros_cbor.h"
#include "recording/ros_schema.h"

namespace mapwright::recorder {

/// `message` as bytes: packed ("ros1"), or plain CDR, little-endian, with its encapsulation header ("cdr").
/// Writes all or nothing: if a member is missing, not in the schema, or of the wrong type, the error is its
/// name. Floats that JSON cannot represent (null) become NaN.
tl::expected<std::string, std::string> encodeRos(const recording::RosSchema& schema, recording::RosWire wire,
                                                 const net::rosbridge::Field& message);

}  // namespace mapwright::recorder
