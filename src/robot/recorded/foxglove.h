// Messages by the schemas of Foxglove, as messages of ROS that say the same: what places and reads those
// reads these, too. Pure. Source: the documentation of Foxglove's schemas (Grid, LaserScan, PointCloud,
// PoseInFrame, PosesInFrame, FrameTransform, FrameTransforms; PackedElementField, NumericType).
#pragma once

#include <optional>
#include <string>

#include <QByteArray>
#include <tl/expected.hpp>

#include "fault/fault.h"
#include "net/rosbridge/field.h"
#include "recording/message.h"

namespace mapwright::robot::recorded {

/// Those that say something that a layer shows.
enum class FoxgloveKind {
  Grid,
  LaserScan,
  PointCloud,
  PoseInFrame,
  PosesInFrame,
  FrameTransform,
  FrameTransforms
};

/// By the name of the schema, in whichever encoding: "foxglove.Grid" (JSON, protobuf), "foxglove_msgs/Grid"
/// and "foxglove_msgs/msg/Grid" (ROS). nullopt: another one.
std::optional<FoxgloveKind> foxgloveKind(const recording::Channel& channel);

/// As which type of ROS its messages are read: a scan becomes points, because it has a place of its own.
const char* rosTypeOf(FoxgloveKind kind);

/// The message as CBOR. Lists of numbers are typed arrays (RFC 8746). The reason: a member that is needed is
/// not there, or lies.
tl::expected<QByteArray, Fault> foxgloveToRos(FoxgloveKind kind, const net::rosbridge::Field& message);

}  // namespace mapwright::robot::recorded
