// Messages of ROS, as a rosbridge server sends them, serialised as ROS itself writes them: the mirror of
// recording/ros_decode.h. Pure; any thread. Sources: as there.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "net/rosbridge/field.h"
#include "recording/ros_decode.h"
#include "recording/ros_schema.h"

namespace mapwright::recorder {

/// `message` as bytes: packed ("ros1"), or plain CDR, little-endian, behind its encapsulation ("cdr"). All of
/// it is written or nothing: where a member is missing, is none of the schema, or does not fit its type, the
/// error is its name. What JSON cannot say of a float (null) is NaN.
tl::expected<std::string, std::string> encodeRos(const recording::RosSchema& schema, recording::RosWire wire,
                                                 const net::rosbridge::Field& message);

}  // namespace mapwright::recorder
