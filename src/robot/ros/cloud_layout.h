// How the points of a sensor_msgs/PointCloud2 lie in its bytes. Private to the readers.
// Source: sensor_msgs/PointCloud2, PointField.
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
  std::vector<std::string> outside;  // fields of these that do not lie in a record
  std::size_t width = 0, height = 0, point_step = 0, row_step = 0;
  bool big_endian = false;
};

/// Products of two of its numbers are numbers still: none is above `most_bytes`, which is below 2^31. Of no
/// points nothing else is read.
Read<CloudLayout> readCloudLayout(const Field& msg, std::size_t most_bytes);

/// There are fewer bytes than the layout says.
Fault cloudCutShort(const CloudLayout& layout, std::size_t bytes);

}  // namespace mapwright::robot::ros
