// Converts Foxglove messages to equivalent ROS messages, so that the code for ROS messages handles both.
// Pure. Source: the documentation of Foxglove's schemas (Grid, LaserScan, PointCloud, PoseInFrame,
// PosesInFrame, FrameTransform, FrameTransforms; PackedElementField, NumericType).
#pragma once

#include <optional>
#include <string>

#include <QByteArray>
#include <tl/expected.hpp>

#include "fault/fault.h"
#include "net/rosbridge/field.h"
#include "recording/message.h"

namespace mapwright::robot::recorded {

/// The types shown by a layer.
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

/// The ROS type that its messages are read as: a scan becomes points, because it has a pose of its own.
const char* rosTypeOf(FoxgloveKind kind);

/// The message as CBOR. Lists of numbers are typed arrays (RFC 8746). The error: a required member is missing
/// or invalid.
tl::expected<QByteArray, Fault> foxgloveToRos(FoxgloveKind kind, const net::rosbridge::Field& message);

}  // namespace mapwright::robot::recorded
