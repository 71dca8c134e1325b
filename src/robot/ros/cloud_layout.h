// The layout of points in the bytes of a sensor_msgs/PointCloud2. Private to the readers. Source:
// sensor_msgs/PointCloud2, PointField.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/ros/read_messages.h"
#include "robot/wire/packed_number.h"

namespace mapwright::robot::ros {

using wire::NumberPlace;

struct CloudLayout {
  std::optional<NumberPlace> x, y, z, intensity;
  std::optional<NumberPlace> color;  // "rgb" or "rgba": four bytes, 0xAARRGGBB
  std::vector<std::string> outside;  // required fields that extend beyond the record
  std::size_t width = 0, height = 0, point_step = 0, row_step = 0;
  bool big_endian = false;
};

/// The product of any two of its numbers does not overflow: none exceeds `most_bytes`, which is below 2^31.
/// If there are no points, nothing else is read.
Read<CloudLayout> readCloudLayout(const Field& msg, std::size_t most_bytes);

/// There are fewer bytes than the layout needs.
Fault cloudCutShort(const CloudLayout& layout, std::size_t bytes);

}  // namespace mapwright::robot::ros
