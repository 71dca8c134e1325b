// Everything that is read of a message of ROS, in whichever form it came.
#pragma once

#include "net/rosbridge/cbor_item.h"
#include "robot/ros/dispatch_messages.h"
#include "robot/ros/kabam_messages.h"
#include "robot/ros/read_messages.h"
#include "target.h"

namespace mapwright::fuzz {

inline void readValues(const net::rosbridge::Field& field, int depth = 0) {
  using net::rosbridge::Field;
  constexpr std::size_t kMost = 1 << 16;
  use(field.number());
  use(field.real());
  use(field.integer());
  use(field.natural());
  use(field.flag());
  use(field.time());
  use(field.text());
  use(field.bytes(kMost));
  use(field.int8s(kMost));
  use(field.numbers(kMost));
  use(field.typedArray());
  if (depth > 6) return;
  if (field.isObject()) {
    field.members([&](std::string_view name, const Field& value) {
      use(field[name]);
      readValues(value, depth + 1);
    });
  }
  int left = 64;
  if (field.isList()) {
    field.each([&](const Field& value) {
      if (left-- > 0) readValues(value, depth + 1);
    });
  }
}

inline void readMessages(const net::rosbridge::Field& message) {
  using namespace robot::ros;
  if (auto grid = readGrid(message)) {
    if (const auto patch = readGridPatch(message["patch"])) use(applyPatch(*grid, *patch));
  }
  use(readGridPatch(message));
  use(readPath(message));
  use(readPolygon(message));
  use(readPoseStamped(message));
  use(readPoseWithCovariance(message));
  use(readOdometry(message));
  use(readPoseArray(message));
  use(readLaserScan(message));
  use(readPointCloud2(message));
  use(readMarkers(message));
  use(readTf(message));
  use(readMapList(message, false));
  use(readMapInfo(message));
  use(readWaypoints(message, "m", "map"));
  use(readGridPart(message));
  use(readMapExtent(message));
  use(readSpatialCloud(message));
  use(readProjectedPart(message, 0));
  use(readProjections(message));
}

/// CBOR that our own code has made.
inline void mustBeSound(const QByteArray& cbor) {
  const auto* const at = reinterpret_cast<const std::uint8_t*>(cbor.constData());
  const auto fault = net::rosbridge::lookThrough(at, at + cbor.size());
  MUST(fault == net::rosbridge::CborFault::None || fault == net::rosbridge::CborFault::TooDeep);
}

}  // namespace mapwright::fuzz
